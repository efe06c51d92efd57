// Rotors of finite elements whose natural frequencies, damping and critical speeds are known: Friswell, Penny, Garvey,
// Lees (2010), examples 5.9.1, 5.9.3 and 5.9.5, and Nelson, McVaugh (1976). The digits are those of an independent
// program (Octave; Timoshenko after Cowper, consistent mass) at the same number of elements; a second program confirmed
// them. `as_printed` has the digits of the book.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/case.h"
#include "whirl/engine/linear.h"

enum { TEXT_SIZE = 8192 };

/// Keys of a shaft: all degrees of freedom; or, for fine meshes, enough modes that the error is below the digits.
static const char full[] = "reduce: no", reduced[] = "modes: 40";

static const double rpm = 3.14159265358979323846 / 30.0;

static whirl_case *parse(const char *text) {
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    const whirl_status status = whirl_case_parse(text, strlen(text), "fe", &problems, &object);
    for (size_t i = 0; i < problems.count; i++) {
        char line[600];
        whirl_problem_text(&problems, i, line, sizeof line);
        print_error("%s\n", line);
    }
    require_ok(status);
    whirl_problems_free(&problems);
    return object;
}

static whirl_modes *modes_at(const whirl_case *object, double speed, double *clock) {
    whirl_rotor *rotor;
    whirl_modes *modes;
    require_ok(whirl_case_rotor(object, "omega", speed, &rotor));
    const whirl_system *system = whirl_rotor_system(rotor);
    double *start = calloc(system->dimension, sizeof *start);
    require_ok(whirl_modes_new(system, start, &modes));
    *clock = whirl_rotor_clock(rotor);
    free(start);
    whirl_rotor_free(rotor);
    return modes;
}

/// Checks the lowest frequencies at a speed, each to a relative 1e-6.
static void expect_frequencies(const char *what, const whirl_case *object, double speed, const double *expected,
                               size_t count) {
    double clock;
    whirl_modes *modes = modes_at(object, speed, &clock);
    assert_true(modes->count >= count);
    for (size_t i = 0; i < count; i++)
        check_within("FE", words("%s: frequency %zu at %g rpm, rad/s", what, i + 1, speed / rpm), expected[i],
                     clock * modes->modes[i].imaginary, 1e-6 * expected[i]);
    whirl_modes_free(modes);
}

/// Checks the lowest critical speeds of one direction that a study locates, in units of `unit`.
static void expect_critical(const char *what, const whirl_case *object, double direction, double unit,
                            const double *expected, size_t count) {
    whirl_result *result;
    size_t found = 0;
    const whirl_run_options how = {.threads = 1};
    require_ok(whirl_case_run(object, &how, &result));
    const whirl_table *table = &result->tables[0];
    const whirl_field *field = whirl_layout_field(&table->layout, "modes/critical");
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, "modes/critical", 0);
        for (size_t i = 0; i < field->rows; i++, row += field->columns) {
            if (row[0] != WHIRL_CRITICAL_SPEED || row[5] * direction < 0.0 || found == count) continue;
            check_within("FE",
                         words("%s: %s critical speed %zu", what, direction > 0 ? "forward" : "backward", found + 1),
                         expected[found], row[1] / unit, 1e-6 * expected[found]);
            found++;
        }
    }
    assert_int_equal(found, count);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- Friswell et al.

/// Makes the case of two discs on a shaft of 1.5 m of `elements` elements, in two equal bearings.
static whirl_case *friswell(const char *bearing, int elements, const char *reduction) {
    char text[TEXT_SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {omega: 100 rad/s}\nrotor:\n  speed: = omega\n  length_scale: 1 mm\n"
             "  shafts: {main: {%s}}\n  stations:\n    left: {position: 0 m}\n"
             "    one: {position: 0.5 m, mass: 32.589728 kg, diametral: 0.17808928 kg m2, polar: 0.32956362 kg m2}\n"
             "    two: {position: 1 m, mass: 51.525261 kg, diametral: 0.42358058 kg m2, polar: 0.80508220 kg m2}\n"
             "    right: {position: 1.5 m}\n  elements:\n    - segment: {length: 1.5 m, outer: 50 mm, elements: %d}\n"
             "    - bearing: {at: left, %s}\n    - bearing: {at: right, %s}\n"
             "study:\n  modes: {parameter: omega, from: 10 rad/s, to: 1000 rad/s, points: 12}\n",
             reduction, elements, bearing, bearing);
    return parse(text);
}

static void isotropic_bearings(void **unused) {
    static const double still[] = {86.658114,  86.658114,  274.312854,  274.312854,
                                   716.786312, 716.786312, 1066.156200, 1066.156200};
    static const double turning[] = {85.389467,  87.795864,  251.784604,  294.713331,
                                     600.179362, 827.075362, 1038.995525, 1088.192999};
    static const double fine[] = {85.389371, 87.795757, 251.780528, 294.705842, 600.081412, 826.657305};
    static const double forward[] = {86.904250, 288.616834, 925.781851};
    static const double backward[] = {86.407811, 260.517497, 563.335592};
    (void)unused;
    whirl_case *object = friswell("kxx: 1 MN/m", 6, full);
    expect_frequencies("5.9.1", object, 0.0, still, 8);
    expect_frequencies("5.9.1", object, 4000 * rpm, turning, 8);
    expect_critical("5.9.1", object, 1.0, 1.0, forward, 3);
    expect_critical("5.9.1", object, -1.0, 1.0, backward, 3);
    whirl_case_free(object);
    object = friswell("kxx: 1 MN/m", 96, reduced);
    expect_frequencies("5.9.1, 96 elements", object, 4000 * rpm, fine, 6);
    whirl_case_free(object);
}

/// The frequencies of example 5.9.1 as the book prints them, to 1e-3.
static void as_printed(void **unused) {
    static const double still[] = {86.66, 86.66, 274.31, 274.31, 716.78};
    static const double turning[] = {85.39, 87.80, 251.78, 294.71, 600.18};
    (void)unused;
    whirl_case *object = friswell("kxx: 1 MN/m", 6, full);
    for (int turns = 0; turns < 2; turns++) {
        double clock;
        whirl_modes *modes = modes_at(object, turns ? 4000 * rpm : 0.0, &clock);
        for (size_t i = 0; i < 5; i++) {
            const double expected = turns ? turning[i] : still[i];
            check_within("FE", words("5.9.1 as printed: frequency %zu at %d rpm, rad/s", i + 1, turns ? 4000 : 0),
                         expected, clock * modes->modes[i].imaginary, 1e-3 * expected);
        }
        whirl_modes_free(modes);
    }
    whirl_case_free(object);
}

static void unequal_bearings(void **unused) {
    static const double still[] = {53.70120, 86.65811, 143.89946, 274.31285, 539.33098, 716.78631};
    static const double turning[] = {53.69236, 86.52489, 140.45749, 276.86382, 494.83122, 756.37005};
    (void)unused;
    whirl_case *object = friswell("kxx: 1 MN/m, kyy: 0.2 MN/m", 6, full);
    expect_frequencies("5.9.3", object, 0.0, still, 6);
    expect_frequencies("5.9.3", object, 4000 * rpm, turning, 6);
    whirl_case_free(object);
}

/// Eigenvalues with damped bearings: real and imaginary parts.
static void damped_bearings(void **unused) {
    static const struct {
        double real, imaginary;
    } still[] = {{-4.42383, 87.25794},   {-4.42383, 87.25794},    {-78.24083, 292.42277},
                 {-78.24083, 292.42277}, {-566.54038, 648.58140}, {-566.54038, 648.58140}},
      turning[] = {{-4.08308, 85.96581},   {-4.74174, 88.41471},    {-74.10177, 263.78635},
                   {-78.81042, 318.23504}, {-402.59086, 655.01204}, {-667.23754, 663.89967}};
    (void)unused;
    whirl_case *object = friswell("kxx: 1 MN/m, cxx: 3 kN s/m", 6, full);
    for (int turns = 0; turns < 2; turns++) {
        double clock;
        whirl_modes *modes = modes_at(object, turns ? 4000 * rpm : 0.0, &clock);
        for (size_t i = 0; i < 6; i++) {
            const double real = turns ? turning[i].real : still[i].real;
            const double imaginary = turns ? turning[i].imaginary : still[i].imaginary;
            const double tolerance = fmax(1e-6 * hypot(real, imaginary), 5e-6);
            check_within("FE", words("5.9.5: decay rate %zu at %d rpm, 1/s", i + 1, turns ? 4000 : 0), real,
                         clock * modes->modes[i].real, tolerance);
            check_within("FE", words("5.9.5: frequency %zu at %d rpm, rad/s", i + 1, turns ? 4000 : 0), imaginary,
                         clock * modes->modes[i].imaginary, tolerance);
        }
        whirl_modes_free(modes);
    }
    whirl_case_free(object);
}

// ---------------------------------------------------------------- Nelson and McVaugh

/// Makes the rotor of Nelson and McVaugh: 18 segments of `elements` Rayleigh elements each, a disc at their station 5,
/// bearings at 11 and 15.
static whirl_case *nelson(int elements, const char *reduction) {
    static const double at[] = {0,     1.27,  5.08,  7.62,  8.89,  10.16, 10.67, 11.43, 12.70, 13.46,
                                16.51, 19.05, 22.86, 26.67, 28.70, 30.48, 31.50, 34.54, 35.81};
    static const double outer[] = {.51,  1.02, .76,  2.03, 2.03, 3.30, 3.30, 2.54, 2.54,
                                   1.27, 1.27, 1.52, 1.52, 1.27, 1.27, 3.81, 2.03, 2.03};
    static const double inner[] = {0, 0, 0, 0, 0, 0, 1.52, 1.78, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1.52};
    char text[TEXT_SIZE];
    int used =
        snprintf(text, sizeof text,
                 "whirl: 1\nparameters: {omega: 100 rad/s}\nrotor:\n  speed: = omega\n  length_scale: 1 mm\n"
                 "  materials: {metal: {modulus: 2.078e11 Pa, poisson: 0.3, density: 7806 kg/m3}}\n"
                 "  shafts: {main: {material: metal, shear: none, %s}}\n  stations:\n"
                 "    disc: {position: 8.89 cm, mass: 1.401 kg, diametral: 0.00136 kg m2, polar: 0.00203 kg m2}\n"
                 "    left: {position: 16.51 cm}\n    right: {position: 28.70 cm}\n  elements:\n"
                 "    - bearing: {at: left, kxx: 4.378e7 N/m}\n    - bearing: {at: right, kxx: 4.378e7 N/m}\n",
                 reduction);
    for (size_t i = 0; i < 18; i++) {
        used += snprintf(text + used, sizeof text - (size_t)used, "    - segment: {length: %.10g cm, outer: %.10g cm",
                         at[i + 1] - at[i], 2 * outer[i]);
        if (inner[i] > 0) used += snprintf(text + used, sizeof text - (size_t)used, ", inner: %.10g cm", 2 * inner[i]);
        used += snprintf(text + used, sizeof text - (size_t)used, ", elements: %d}\n", elements);
    }
    snprintf(text + used, sizeof text - (size_t)used,
             "study:\n  modes: {parameter: omega, from: 10000 rpm, to: 100000 rpm, points: 10}\n");
    return parse(text);
}

static void critical_speeds_of_nelson_and_mcvaugh(void **unused) {
    static const double forward[] = {17156.83, 49297.77, 95831.89}, backward[] = {15474.82, 45953.38, 64733.04};
    static const double fine_forward[] = {17156.818, 49297.58, 95819.90};
    static const double fine_backward[] = {15474.81, 45953.27, 64732.08};
    (void)unused;
    whirl_case *object = nelson(1, full);
    expect_critical("Nelson, McVaugh", object, 1.0, rpm, forward, 3);
    expect_critical("Nelson, McVaugh", object, -1.0, rpm, backward, 3);
    whirl_case_free(object);
    object = nelson(4, reduced);
    expect_critical("Nelson, McVaugh, 72 elements", object, 1.0, rpm, fine_forward, 3);
    expect_critical("Nelson, McVaugh, 72 elements", object, -1.0, rpm, fine_backward, 3);
    whirl_case_free(object);
}

static void whirl_speeds_of_nelson_and_mcvaugh(void **unused) {
    static const double still[] = {16269.38, 16269.38, 47706.40, 47706.40, 76220.85, 76220.85, 121643.18, 121643.18};
    static const double turning[] = {12828.74, 19826.69, 44914.41, 49895.85, 63975.64, 90908.26};
    double expected[8];
    (void)unused;
    whirl_case *object = nelson(1, full);
    for (size_t i = 0; i < 8; i++) expected[i] = still[i] * rpm;
    expect_frequencies("Nelson, McVaugh", object, 0.0, expected, 8);
    for (size_t i = 0; i < 6; i++) expected[i] = turning[i] * rpm;
    expect_frequencies("Nelson, McVaugh", object, 70000 * rpm, expected, 6);
    whirl_case_free(object);
}

// ---------------------------------------------------------------- oil whirl

/// A disc of 60 kg on a shaft of finite elements in two films.
static const char in_films[] =
    "whirl: 1\nparameters: {omega: 3000 rpm}\nrotor:\n  speed: = omega\n  length_scale: 0.1 mm\n"
    "  shafts: {main: {modes: 4}}\n  stations:\n    left: {position: 0 m}\n"
    "    disc: {position: 0.4 m, mass: 60 kg, diametral: 0.4 kg m2, polar: 0.7 kg m2}\n    right: {position: 1 m}\n"
    "  elements:\n    - segment: {length: 1 m, outer: 60 mm, elements: 10}\n"
    "    - film: {at: left, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 30 mm, length: 30 mm}\n"
    "    - film: {at: right, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 30 mm, length: 30 mm}\n"
    "    - gravity: 9.81 m/s2\n"
    "study:\n  modes: {parameter: omega, from: 500 rpm, to: 12000 rpm, points: 24}\n";

/// Returns the speed at which instability begins according to the study; NaN if it does not.
static double onset_of(const whirl_case *object) {
    whirl_result *result;
    double onset = NAN;
    const whirl_run_options how = {.threads = 1};
    require_ok(whirl_case_run(object, &how, &result));
    const whirl_table *table = &result->tables[0];
    const whirl_field *field = whirl_layout_field(&table->layout, "modes/critical");
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, "modes/critical", 0);
        for (size_t i = 0; i < field->rows; i++, row += field->columns)
            if (row[0] == WHIRL_ONSET && isnan(onset)) onset = row[1];
    }
    whirl_result_free(result);
    return onset;
}

/// Carries the motion over `revolutions` and returns its largest distance from the equilibrium.
static double largest_way(whirl_integrator *integrator, const double *rest, double *x, size_t degrees,
                          int revolutions) {
    double largest = 0.0;
    for (int k = 0; k < revolutions; k++) {
        assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
        for (size_t i = 0; i < degrees; i++) largest = fmax(largest, fabs(x[i] - rest[i]));
    }
    return largest;
}

/// Returns the natural logarithm of the growth of a small perturbation: its largest size in a hundred revolutions over
/// that in a hundred revolutions a thousand earlier.
static double simulated_growth(const whirl_case *object, double speed) {
    whirl_rotor *rotor;
    whirl_integrator *integrator;
    whirl_integrate_options options = whirl_integrate_default();
    require_ok(whirl_case_rotor(object, "omega", speed, &rotor));
    const whirl_system *system = whirl_rotor_system(rotor);
    double *rest = calloc(2 * system->dimension, sizeof *rest), *x = rest + system->dimension;
    require_ok(whirl_equilibrium(system, rest));
    memcpy(x, rest, system->dimension * sizeof *x);
    x[system->probes[1].x] += 1e-5;
    strcpy(options.method, "rodas5p");
    options.rtol = 1e-10;
    options.atol = 1e-13;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    const size_t degrees = system->probes[0].vx - system->probes[0].x;
    largest_way(integrator, rest, x, degrees, 200);
    const double before = largest_way(integrator, rest, x, degrees, 100);
    largest_way(integrator, rest, x, degrees, 900);
    const double after = largest_way(integrator, rest, x, degrees, 100);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
    free(rest);
    return log(after / before);
}

/// A thousandth below the threshold perturbations decay in the nonlinear equations, a thousandth above they grow.
static void oil_whirl_sets_in(void **unused) {
    (void)unused;
    whirl_case *object = parse(in_films);
    const double onset = onset_of(object);
    check_holds("FE", "a rotor in films loses its stability between 500 and 12000 rpm", isfinite(onset));
    const double below = simulated_growth(object, 0.999 * onset), above = simulated_growth(object, 1.001 * onset);
    check_holds(
        "FE", words("a thousandth below %.6g rpm a simulated perturbation dies out (growth %.3g)", onset / rpm, below),
        below < 0);
    check_holds("FE", words("a thousandth above it grows (growth %.3g)", above), above > 0);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isotropic_bearings),
        cmocka_unit_test(as_printed),
        cmocka_unit_test(unequal_bearings),
        cmocka_unit_test(damped_bearings),
        cmocka_unit_test(critical_speeds_of_nelson_and_mcvaugh),
        cmocka_unit_test(whirl_speeds_of_nelson_and_mcvaugh),
        cmocka_unit_test(oil_whirl_sets_in),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
