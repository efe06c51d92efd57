// Torsion: trains of discs, gears with a rigid ratio, shafts of finite elements, against published and closed forms.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 4096 };

static const double two_pi = 6.283185307179586476925, pi = 3.14159265358979323846;

/// Computes the modes of a machine: `parts` is the text after its scale.
static whirl_result *torsion_modes(const char *parts, const char *study) {
    char text[SIZE];
    snprintf(text, sizeof text, "whirl: 1\nrotor:\n  speed: 3000 rpm\n  length_scale: 1 mm\n%sstudy:\n  modes: {%s}\n",
             parts, study);
    return result_of_text(text);
}

/// Returns the frequency of mode i, Hz.
static double torsion_frequency(const whirl_result *result, size_t i) {
    return whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_MODES_FREQUENCY, 0)[i] / two_pi;
}

static double torsion_number(const whirl_result *result, const char *field, size_t i) {
    return whirl_table_field(&result->tables[0], 0, field, 0)[i];
}

/// Friswell et al. 2010, example 9.7.1, and trains with gears; eigenvalue solvers and Holzer's method in 30 digits.
static void torsion_of_trains(void **state) {
    static const struct {
        const char *name, *parts, *known[5];
    } trains[] = {
        {"five discs",
         "  stations:\n"
         "    a: {polar: 3.5e-3 kg.m2, moves: twist}\n"
         "    b: {polar: 3.5e-3 kg.m2, moves: twist}\n"
         "    c: {polar: 3.5e-3 kg.m2, moves: twist}\n"
         "    d: {polar: 0.15 kg.m2, moves: twist}\n"
         "    e: {polar: 0.05 kg.m2, moves: twist}\n"
         "  elements:\n"
         "    - coupling: {between: [a, b], twist: 12e3 N.m/rad}\n"
         "    - coupling: {between: [b, c], twist: 12e3 N.m/rad}\n"
         "    - spring: {between: [c, d], along: twist, stiffness: 14e3}\n"
         "    - spring: {between: [d, e], along: twist, stiffness: 10e3}\n",
         {"81.2076290244", "141.214071392", "378.952953903", "536.363282927", NULL}},
        {"rigid gears",
         "  stations:\n"
         "    a: {polar: 211.4 kg.m2, moves: twist}\n"
         "    b: {polar: 8.3 kg.m2, moves: twist}\n"
         "    c: {polar: 0.35 kg.m2, moves: twist}\n"
         "    d: {polar: 2.6 kg.m2, moves: twist}\n"
         "  elements:\n"
         "    - coupling: {between: [a, b], twist: 9.775e6 N.m/rad}\n"
         "    - gear: {between: [b, c], base_radii: [300 mm, 100 mm]}\n"
         "    - coupling: {between: [c, d], twist: 4.1e5 N.m/rad}\n",
         {"56.2603452307", "178.293041083", NULL}},
        {"branches",
         "  stations:\n"
         "    motor: {polar: 4e-4 kg.m2, moves: twist}\n"
         "    pinion: {polar: 2.5e-5 kg.m2, moves: twist}\n"
         "    wheel: {polar: 2.5e-5 kg.m2, moves: twist}\n"
         "    one: {polar: 7e-4 kg.m2, moves: twist}\n"
         "    two: {polar: 7e-4 kg.m2, moves: twist}\n"
         "  elements:\n"
         "    - coupling: {between: [motor, pinion], twist: 1e4 N.m/rad}\n"
         "    - gear: {between: [wheel, pinion], base_radii: [30 mm, 30 mm]}\n"
         "    - coupling: {between: [pinion, one], twist: 5e3 N.m/rad}\n"
         "    - coupling: {between: [wheel, two], twist: 5e3 N.m/rad}\n",
         {"425.359477", "634.072760", "3247.19235", NULL}},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(trains); i++) {
        whirl_result *result = torsion_modes(trains[i].parts, "");
        check_within("Torsion", words("%s: motions that nothing holds", trains[i].name), 1.0,
                     torsion_number(result, WHIRL_FIELD_MODES_RIGID_BODY, 0), 0.0);
        for (size_t k = 0; trains[i].known[k]; k++) {
            check_digits("Torsion", words("%s: mode %zu, Hz", trains[i].name, k + 1), trains[i].known[k],
                         torsion_frequency(result, k));
            check_within("Torsion", words("%s: share of twists", trains[i].name), 1.0,
                         torsion_number(result, WHIRL_FIELD_MODES_TORSION, k), 0.0);
        }
        whirl_result_free(result);
    }
}

/// A uniform shaft, free at both ends: with consistent mass and n equal elements cos(k h) and the frequency have a
/// closed form, and bending does not know of torsion. Reduced or not.
static void torsion_of_a_shaft(void **state) {
    static const char form[] = "  shafts: {s: {twist: %s, mesh_to: 1 Hz, reduce: %s}}\n"
                               "  stations: {left: {moves: %s}, right: {moves: %s}}\n"
                               "  elements:\n"
                               "    - segment: {from: left, to: right, length: 900 mm, outer: 60 mm, inner: 20 mm, "
                               "elements: 12}\n";
    const double wave = sqrt(8.12e10 / 7810.0), length = 0.9, h = length / 12.0;
    char text[SIZE], plain[SIZE];
    (void)state;
    for (size_t reduced = 0; reduced < 2; reduced++) {
        const char *reduce = reduced ? "yes" : "no";
        snprintf(text, sizeof text, form, "yes", reduce, "all", "all");
        snprintf(plain, sizeof plain, form, "no", reduce, "xy", "xy");
        whirl_result *result = torsion_modes(text, "count: 60"), *lateral = torsion_modes(plain, "count: 60");
        size_t torsional = 0, bent = 0;
        for (size_t i = 0; i < 12; i++) {
            const double found = torsion_frequency(result, i);
            if (torsion_number(result, WHIRL_FIELD_MODES_TORSION, i) < 0.5) {
                check_within("Torsion", words("reduced %s: bending mode %zu, Hz", reduce, bent + 1),
                             torsion_frequency(lateral, bent), found, 1e-9 * found);
                bent++;
                continue;
            }
            const double k = (double)++torsional * pi / length;
            const double known = wave / h * sqrt(6.0 * (1.0 - cos(k * h)) / (2.0 + cos(k * h))) / two_pi;
            check_within("Torsion", words("reduced %s: torsional mode %zu, Hz", reduce, torsional), known, found,
                         1e-10 * known);
        }
        check_holds("Torsion", "there are modes of both kinds", torsional > 1 && bent > 1);
        whirl_result_free(result);
        whirl_result_free(lateral);
    }
}

/// A light cone between two discs, which Saint-Venant's integral of 1/d^4 makes a spring: pieces do not matter. Its own
/// inertia is 1e-8 of the discs'.
static void torsion_of_a_cone(void **state) {
    const double a = 0.08, b = 0.04, length = 0.8, one = 0.5, other = 0.2;
    const double stiffness = 8.12e10 * pi / 32.0 * 3.0 * (a - b) / (length * (1.0 / (b * b * b) - 1.0 / (a * a * a)));
    (void)state;
    for (int elements = 1; elements < 4; elements += 2) {
        char text[SIZE];
        snprintf(
            text, sizeof text,
            "  materials: {light: {modulus: 2.11e11 Pa, shear_modulus: 8.12e10 Pa, density: 1e-3 kg/m3}}\n"
            "  shafts: {s: {twist: yes, reduce: no, material: light}}\n"
            "  stations:\n"
            "    left: {moves: all, mass: 10 kg, polar: %g kg.m2, diametral: 0.3 kg.m2}\n"
            "    right: {moves: all, mass: 10 kg, polar: %g kg.m2, diametral: 0.3 kg.m2}\n"
            "  elements:\n"
            "    - segment: {from: left, to: right, length: 800 mm, outer: 80 mm, outer_end: 40 mm, elements: %d}\n",
            one, other, elements);
        whirl_result *result = torsion_modes(text, "count: 40");
        size_t i = 0;
        while (torsion_number(result, WHIRL_FIELD_MODES_TORSION, i) < 0.5) i++;
        check_within("Torsion", words("cone of %d pieces: torsional mode, Hz", elements),
                     sqrt(stiffness * (1.0 / one + 1.0 / other)) / two_pi, torsion_frequency(result, i), 2e-6);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(torsion_of_trains), cmocka_unit_test(torsion_of_a_shaft),
                                       cmocka_unit_test(torsion_of_a_cone)};
    return cmocka_run_group_tests_name("torsion", tests, NULL, NULL);
}
