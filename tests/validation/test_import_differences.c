// Results that ROSS computes otherwise from the same numbers, and by how much, as the notes of an import say.
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
#include "support_import.h"

// ROSS's frequencies are those of its own element (ross/shaft_element.py of version 2.3.0, commit 631a249), run by
// itself, its matrices put together and their eigenvalues taken by LAPACK.

/// Between springs at its ends, of pieces that each are one element, or `steps` of them: cones, or cylinders as wide as
/// these are in the middle.
typedef struct machine {
    double length, spring; ///< m, of a piece; N/m
    size_t pieces;         ///< at most 10
    double diameter[11];   ///< m, where pieces begin and end
    size_t steps;
    bool cylinders;
    const char *options; ///< lines of every element
} machine;

static void put_element(char **at, const machine *of, size_t number, double length, const double diameter[2]) {
    *at += sprintf(*at,
                   "[ShaftElement_%zu]\nn = %zu\nL = %.17g\nidl = 0\nidr = 0\nodl = %.17g\nodr = %.17g\n%smaterial = "
                   "{name = \"steel\", rho = 7810.0, E = 211e9, G_s = 81.2e9}\n",
                   number, number, length, diameter[0], diameter[1], of->options);
}

/// Returns a file as ROSS saves it; freed by the caller.
static char *file_of(const machine *of) {
    const size_t count = of->pieces * of->steps;
    char *const text = calloc(count + 2, 400), *at = text;
    for (size_t i = 0; i < count; i++) {
        const double *const ends = &of->diameter[i / of->steps], taper = (ends[1] - ends[0]) / (double)of->steps;
        const double from = ends[0] + taper * (double)(i % of->steps), middle = from + 0.5 * taper;
        const double cone[] = {from, from + taper}, step[] = {middle, middle};
        put_element(&at, of, i, of->length / (double)of->steps, of->cylinders ? step : cone);
    }
    for (size_t end = 0; end < 2; end++)
        at += sprintf(at, "[BearingElement_%zu]\nn = %zu\nkxx = %.17g\n", end, end * count, of->spring);
    return text;
}

/// Computes the frequencies in rad/s of the first two modes.
static void frequencies(const machine *of, double speed, double found[2]) {
    whirl_imported imported;
    double clock;
    char *const file = file_of(of);
    require_ok(whirl_import_parse(file, strlen(file), "rotor.toml", &imported));
    char *const text = whole_case(&imported);
    whirl_case *const object = parse_case(text);
    whirl_modes *const modes = modes_at(object, speed, &clock);
    for (size_t i = 0; i < 2; i++) found[i] = clock * modes->modes[i].imaginary;
    whirl_modes_free(modes);
    whirl_case_free(object);
    free(text);
    free(file);
}

/// Shafts that are wider in the middle, by half and twice as wide: cones in single elements against steps of cylinders.
static void test_cones(void **state) {
    static const struct {
        double ratio, ross, higher; ///< rad/s, of one element a cone; and by how much
    } of[] = {{1.5, 432.359353, 0.006}, {2.0, 419.6485141, 0.021}};
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        double fine[2], one[2];
        const double thin = 0.05, wide = of[i].ratio * thin;
        machine shaft = {.length = 0.25,
                         .spring = 1e7,
                         .pieces = 5,
                         .diameter = {thin, thin, wide, wide, thin, thin},
                         .steps = 12,
                         .cylinders = true,
                         .options = ""};
        frequencies(&shaft, 1e-3, fine);
        shaft.steps = 1;
        shaft.cylinders = false;
        frequencies(&shaft, 1e-3, one);
        check_within("Import", words("cones %.1f times as wide: mode 1 over that of steps of cylinders", of[i].ratio),
                     1.0, one[0] / fine[0], 1e-3);
        check_within("Import", words("cones %.1f times as wide: mode 1 by ROSS's element over that", of[i].ratio),
                     1.0 + of[i].higher, of[i].ross / fine[0], 1e-3);
    }
}

/// Makes a shaft of ten elements, ten times as long as thick.
static machine round_shaft(const char *options) {
    machine shaft = {.length = 0.1, .spring = 1e9, .pieces = 10, .steps = 1, .options = options};
    for (size_t i = 0; i <= shaft.pieces; i++) shaft.diameter[i] = 0.1;
    return shaft;
}

static void test_hutchinson(void **state) {
    const machine shaft = round_shaft("shear_method_calc = \"hutchinson\"\n");
    double found[2];
    (void)state;
    frequencies(&shaft, 1e-3, found);
    check_within("Import", "hutchinson: mode 1 by ROSS's element over whirl's", 1.0 - 0.0024, 1240.194774 / found[0],
                 1e-4);
}

/// ROSS keeps gyroscopic moments; where the file asks for none both have the same.
static void test_rotary_inertia(void **state) {
    static const struct {
        double speed;
        const char *name;
        double ross[2]; ///< rad/s, backward and forward
        double apart;   ///< by which each is off
    } of[] = {{314.1592653589793, "3000 rpm", {1244.420478, 1247.873809}, 0.0014},
              {1047.1975511965977, "10000 rpm", {1240.401098, 1251.912154}, 0.0046}};
    const machine shaft = round_shaft("rotary_inertia = false\n");
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        double found[2];
        frequencies(&shaft, of[i].speed, found);
        for (size_t m = 0; m < 2; m++)
            check_within("Import",
                         words("no rotary inertia, %s: %s mode 1 by ROSS's element over whirl's", of[i].name,
                               m ? "forward" : "backward"),
                         1.0 + (m ? of[i].apart : -of[i].apart), of[i].ross[m] / found[m], 1e-4);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cones), cmocka_unit_test(test_hutchinson),
                                       cmocka_unit_test(test_rotary_inertia)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
