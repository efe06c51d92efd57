// Rotors saved by ROSS: their modes by the imported case against what ROSS computes and its tests assert.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_import.h"
#include "whirl/engine/rotor.h"

static const char rotors[] = WHIRL_CASES "/../tests/rotors/";

/// Returns the text with everything from `from` up to `to` replaced; freed by the caller.
static char *replace(char *text, const char *from, const char *to, const char *by) {
    char *const start = strstr(text, from);
    assert_non_null(start);
    const char *const end = strstr(start, to);
    assert_non_null(end);
    const size_t size = strlen(text) + strlen(by) + 1;
    char *const made = malloc(size);
    snprintf(made, size, "%.*s%s%s", (int)(start - text), text, by, end);
    free(text);
    return made;
}

/// Imports a file with the whole model, without reduction.
static char *import_full(const char *name) {
    char path[512];
    whirl_imported imported;
    snprintf(path, sizeof path, "%s%s", rotors, name);
    require_ok(whirl_import_load(path, &imported));
    return whole_case(&imported);
}

/// Two discs on anisotropic bearings (Friswell et al. 2010, example 5.9.2), by ROSS 2.3 with consistent mass.
static void test_two_discs(void **state) {
    static const struct {
        double rpm;
        const char *digits[6];
    } published[] = {
        {1e-3, {"91.7965532", "96.2889998", "274.5659451", "296.5004853", "722.8978749", "765.0004292"}},
        {4000.0, {"91.6290532", "96.4083778", "267.6424154", "303.2078393", "671.5163186", "810.5345949"}},
    };
    char *const text = import_full("two-discs.toml");
    whirl_case *const object = parse_case(text);
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        double clock;
        whirl_modes *const modes = modes_at(object, published[i].rpm * 3.14159265358979323846 / 30.0, &clock);
        for (size_t mode = 0; mode < 6; mode++)
            check_digits("Import", words("two discs at %.0f rpm: mode %zu, rad/s", published[i].rpm, mode + 1),
                         published[i].digits[mode], clock * modes->modes[mode].imaginary);
        whirl_modes_free(modes);
    }
    whirl_case_free(object);
    free(text);
}

// ---------------------------------------------------------------- magnets

/// Computes the linear coefficients of a magnet as in ROSS (Schweitzer, Maslen 2009): N/A and N/m.
static void magnet_of_ross(double gap, double bias, double area, double turns, double alpha, double *by_current,
                           double *by_place) {
    *by_current = 4.0 * bias * cos(alpha) * 4e-7 * acos(-1.0) * turns * turns * area / (4.0 * gap * gap);
    *by_place = *by_current * bias / gap;
}

/// Magnets, gains of parts and PID from the file, compared with linear magnets by hand.
static void test_magnetic(void **state) {
    char by_hand[1024];
    double by_current, by_place, clock;
    (void)state;
    magnet_of_ross(1e-3, 1.0, 1e-4, 200.0, 0.392, &by_current, &by_place);
    check_digits("Import", "static stiffness of the magnet in the documentation of ROSS, N/m", "-4640.62337718",
                 by_current - by_place);
    magnet_of_ross(1e-3, 2.0, 4e-4, 240.0, 0.39269908, &by_current, &by_place);
    snprintf(by_hand, sizeof by_hand,
             "    - magnetic: {at: magnet_0, law: linear, current_stiffness: %.17g, displacement_stiffness: %.17g,\n"
             "                 proportional: 2.0e+4, integral: 5.0e+4, derivative: 40.0, derivative_filter: 1.25e-4}\n"
             "    - magnetic: {at: magnet_6, law: linear, current_stiffness: %.17g, displacement_stiffness: %.17g,\n"
             "                 proportional: 1.5e+4, derivative: 30.0, derivative_filter: 1.0e-4}\n",
             by_current, by_place, by_current, by_place);
    char *const text = import_full("magnetic.toml");
    whirl_case *const object = parse_case(text);
    char *const other = replace(text, "    # Magnet 0", "\nstudy:", by_hand);
    whirl_case *const expected = parse_case(other);
    whirl_modes *const modes = modes_at(object, 300.0, &clock), *const same = modes_at(expected, 300.0, &clock);
    double worst = 0.0;
    assert_int_equal(modes->count, same->count);
    assert_true(modes->count >= 6);
    for (size_t i = 0; i < modes->count; i++)
        worst = fmax(worst, hypot(modes->modes[i].real - same->modes[i].real,
                                  modes->modes[i].imaginary - same->modes[i].imaginary) /
                                hypot(same->modes[i].real, same->modes[i].imaginary));
    check_within("Import", "closed loops of magnets against linear ones by hand: largest relative difference", 0.0,
                 worst, 1e-9);
    whirl_modes_free(modes);
    whirl_modes_free(same);
    whirl_case_free(object);
    whirl_case_free(expected);
    free(other);
}

// ---------------------------------------------------------------- a compressor

/// Natural frequencies in rad/s at rest and forward synchronous speeds, of bearings of 1e6 to 1e11 N/m in equal ratios:
/// ross/tests/test_rotor_assembly.py, test_ucs_rotor9.
static const double at_rest[4][5] = {
    {89.61923786, 350.42266504, 662.41928664, 694.07268245, 695.82331031},
    {124.81086083, 523.02183296, 1891.18155397, 2108.7448203, 2111.56014972},
    {976.61001489, 1046.09648924, 2047.58519431, 3043.40464892, 3113.38540495},
    {2159.64074905, 2162.07931839, 2321.68023491, 4080.81909788, 4317.88700623},
};
static const double synchronous[4][5] = {
    {89.61947056, 350.61514002, 670.08583401, 703.98416314, 705.86888929},
    {126.08902134, 528.47472934, 1971.00830161, 2249.52916259, 2251.5657217},
    {1006.73169597, 1078.17877977, 2100.24701415, 3286.9082896, 3385.80171304},
    {2282.84557629, 2284.30991972, 2383.54778909, 4234.40738673, 4549.46314886},
};

/// Makes the compressor of 91 elements without its seals, on bearings of one stiffness.
static whirl_case *on_springs(double stiffness) {
    char springs[256];
    snprintf(springs, sizeof springs,
             "    - bearing: {at: bearing_0, kxx: %.17g N/m}\n    - bearing: {at: bearing_1, kxx: %.17g N/m}\n",
             stiffness, stiffness);
    char *const text = replace(import_full("ross/compressor.toml"), "    - bearing:", "\nstudy:", springs);
    whirl_case *const object = parse_case(text);
    free(text);
    return object;
}

/// Returns the frequency of the forward mode nearest to the speed, over the speed.
static double nearest_forward(const whirl_modes *modes) {
    double nearest = 0.0;
    for (size_t i = 0; i < modes->count; i++)
        if (fabs(modes->modes[i].imaginary - 1.0) < fabs(nearest - 1.0) && modes->modes[i].direction > 0.0)
            nearest = modes->modes[i].imaginary;
    return nearest;
}

/// At rest every mode stands there twice, once in each plane; at a forward synchronous speed one whirls with the shaft.
static void test_critical_speed_map(void **state) {
    (void)state;
    for (int k = 0; k < 5; k++) {
        const double power = 6.0 + 1.25 * k;
        whirl_case *const object = on_springs(pow(10.0, power));
        double clock, rest = 0.0, whirl = 0.0;
        whirl_modes *modes = modes_at(object, 1e-4, &clock);
        for (size_t mode = 0; mode < 4; mode++)
            rest = fmax(rest, fabs(clock * modes->modes[2 * mode].imaginary / at_rest[mode][k] - 1.0));
        whirl_modes_free(modes);
        for (size_t mode = 0; mode < 4; mode++) {
            modes = modes_at(object, synchronous[mode][k], &clock);
            whirl = fmax(whirl, fabs(nearest_forward(modes) - 1.0));
            whirl_modes_free(modes);
        }
        check_within(
            "Import",
            words("compressor on springs of 10^%.2f N/m: four modes at rest, largest relative difference", power), 0.0,
            rest, 1e-7);
        check_within(
            "Import",
            words("compressor on springs of 10^%.2f N/m: four synchronous speeds, largest relative difference", power),
            0.0, whirl, 1e-6);
        whirl_case_free(object);
    }
}

// ---------------------------------------------------------------- options of single elements

/// Returns the Jacobian at rest, [dimension][dimension], of the two discs with `line` in place of that of its key in
/// `edits` elements, the first `from`.
static double *jacobian_with(size_t edits, const char *line, size_t from, size_t *n) {
    char path[512], *text = calloc(1, 1 << 16);
    whirl_imported imported;
    snprintf(path, sizeof path, "%s%s", rotors, "two-discs.toml");
    FILE *const file = fopen(path, "r");
    char row[256];
    const size_t key = strcspn(line, "=");
    for (size_t element = 0; fgets(row, sizeof row, file);) {
        const bool is_it = strncmp(row, line, key) == 0;
        strcat(text, is_it && element >= from && element < from + edits ? line : row);
        element += is_it;
    }
    fclose(file);
    require_ok(whirl_import_parse(text, strlen(text), "two-discs", &imported));
    whirl_case *const object = parse_case(imported.text);
    whirl_rotor *rotor;
    require_ok(whirl_case_rotor(object, "speed", 400.0, &rotor));
    const whirl_system *const system = whirl_rotor_system(rotor);
    *n = system->dimension;
    double *const rest = calloc(*n, sizeof *rest), *const unit = calloc(*n * *n, sizeof *unit);
    double *const columns = calloc(*n * *n, sizeof *columns), forcing[WHIRL_MAX_FORCING] = {0};
    for (size_t i = 0; i < *n; i++) unit[i * *n + i] = 1.0;
    system->tangent(system->model, 0.0, forcing, rest, NULL, *n, unit, columns);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
    whirl_imported_free(&imported);
    free(rest);
    free(unit);
    free(text);
    return columns;
}

/// Effects of the options of elements add up: that of the first two elements plus that of the other four is that of
/// all.
static void test_options_add_up(void **state) {
    static const char *const lines[] = {"gyroscopic = false\n", "alpha = 12.0\n", "beta = 3e-5\n"};
    (void)state;
    for (size_t k = 0; k < sizeof lines / sizeof *lines; k++) {
        size_t n;
        double *const none = jacobian_with(0, lines[k], 0, &n), *const first = jacobian_with(2, lines[k], 0, &n);
        double *const rest = jacobian_with(4, lines[k], 2, &n), *const all = jacobian_with(6, lines[k], 0, &n);
        double largest = 0.0, worst = 0.0, effect = 0.0;
        for (size_t i = 0; i < n * n; i++) {
            largest = fmax(largest, fabs(all[i]));
            effect = fmax(effect, fabs(all[i] - none[i]));
            worst = fmax(worst, fabs(first[i] + rest[i] - none[i] - all[i]));
        }
        assert_true(effect > 1e-6 * largest);
        check_within("Import",
                     words("two discs, %.*s in parts against all: largest difference of the Jacobian, relative",
                           (int)strcspn(lines[k], " "), lines[k]),
                     0.0, worst / largest, 1e-11);
        free(none);
        free(first);
        free(rest);
        free(all);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_two_discs), cmocka_unit_test(test_magnetic),
                                       cmocka_unit_test(test_critical_speed_map),
                                       cmocka_unit_test(test_options_add_up)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
