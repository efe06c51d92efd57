// Axial motion: bars against closed forms, thrust of helical gears and weight at rest, forced vibration along the
// shaft.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/result.h"

enum { SIZE = 4096 };

static const double axial_pi = 3.14159265358979323846;

/// Runs a case of modes with these parts of the rotor.
static whirl_result *axial_modes(const char *parts, const char *settings) {
    char text[SIZE];
    snprintf(
        text, sizeof text,
        "whirl: 1\nparameters: {n: 100 rad/s}\nrotor:\n  speed: = n\n  length_scale: 1 mm\n%sstudy:\n  modes: {%s}\n",
        parts, settings);
    return result_of_text(text);
}

static const double *axial_field(const whirl_result *result, const char *field, size_t station) {
    const double *found = whirl_table_field(whirl_result_table(result, "modes"), 0, field, station);
    assert_non_null(found);
    return found;
}

/// Returns the frequency of an axial mode, rad/s, counted from 0 by rising frequency.
static double axial_frequency(const whirl_result *result, size_t index) {
    const double *torsion = whirl_table_field(whirl_result_table(result, "modes"), 0, WHIRL_FIELD_MODES_TORSION, 0);
    const double *share = axial_field(result, WHIRL_FIELD_MODES_AXIAL_SHARE, 0);
    for (size_t i = 0;; i++)
        if (whirl_mode_kind_of(torsion ? torsion[i] : 0.0, share[i]) == WHIRL_AXIAL_MODE && index-- == 0)
            return axial_field(result, WHIRL_FIELD_MODES_FREQUENCY, 0)[i];
}

/// A uniform bar, free at both ends: with consistent mass and n equal elements its frequencies have a closed form, for
/// k = i pi/L; bending and twist do not know of axial motion. Reduced or not. Free in axial motion, it has one motion
/// more that nothing holds.
static void bar_free_at_both_ends(void **state) {
    static const char form[] = "  shafts: {s: {axial: yes, twist: %s, reduce: %s, mass: %s}}\n"
                               "  stations: {left: {position: 0}, right: {position: 900 mm}}\n"
                               "  elements:\n"
                               "    - segment: {length: 900 mm, outer: 60 mm, inner: 20 mm, elements: 12}\n"
                               "    - spring: {between: [left, ground], stiffness: 1e7 N/m}\n"
                               "    - spring: {between: [right, ground], stiffness: 1e7 N/m}\n";
    const double wave = sqrt(2.11e11 / 7810.0), length = 0.9, h = length / 12.0;
    char text[SIZE];
    (void)state;
    for (size_t i = 0; i < 8; i++) {
        const bool twists = i % 2, reduced = i / 2 % 2, lumped = i / 4;
        snprintf(text, sizeof text, form, twists ? "yes" : "no", reduced ? "yes" : "no",
                 lumped ? "lumped" : "consistent");
        whirl_result *result = axial_modes(text, "count: 60");
        check_within("Axial", "motions of a free bar that nothing holds", twists ? 2.0 : 1.0,
                     axial_field(result, WHIRL_FIELD_MODES_RIGID_BODY, 0)[0], 0.0);
        for (size_t n = 1; n <= 4; n++) {
            const double c = cos((double)n * axial_pi * h / length);
            const double known = wave / h * (lumped ? sqrt(2.0 * (1.0 - c)) : sqrt(6.0 * (1.0 - c) / (2.0 + c)));
            check_within("Axial",
                         words("mode %zu of a free bar, %s%s%s", n, lumped ? "lumped" : "consistent",
                               twists ? ", twisting" : "", reduced ? ", reduced" : ""),
                         known, axial_frequency(result, n - 1), 1e-10 * known);
        }
        whirl_result_free(result);
    }
}

/// A bar on thrust bearings of stiffness k at its end, with a mass M at the other: w^2 by tan(q L) of the continuous
/// bar, which the mesh approaches with the fourth power of 1/n in Richardson's sequence.
static void bar_with_a_mass(void **state) {
    static const char form[] = "  shafts: {s: {axial: yes, reduce: no}}\n"
                               "  stations: {left: {position: 0}, right: {position: 1 m, mass: 5 kg}}\n"
                               "  elements:\n"
                               "    - segment: {length: 1 m, outer: 50 mm, elements: %d}\n"
                               "    - spring: {between: [left, ground], stiffness: 1e8 N/m}\n"
                               "    - spring: {between: [right, ground], stiffness: 1e8 N/m}\n"
                               "    - spring: {between: [left, ground], along: axial, stiffness: 2e8 N/m}\n";
    const double area = axial_pi / 4.0 * 0.05 * 0.05, modulus = 2.11e11, density = 7810.0;
    double low = 1.0, high = 6000.0, found[2];
    char text[SIZE];
    (void)state;
    // With q = w/c the bar holds u = cos q z + (k/(E A q)) sin q z; at its end E A u' = M w^2 u.
    for (int i = 0; i < 200; i++) {
        const double w = 0.5 * (low + high), q = w * sqrt(density / modulus), s = 2e8 / (modulus * area * q);
        const double u = cos(q) + s * sin(q), slope = q * (s * cos(q) - sin(q));
        *(modulus * area * slope - 5.0 * w * w * u > 0.0 ? &low : &high) = w;
    }
    for (size_t i = 0; i < 2; i++) {
        snprintf(text, sizeof text, form, i == 0 ? 16 : 32);
        whirl_result *result = axial_modes(text, "count: 40");
        found[i] = axial_frequency(result, 0);
        whirl_result_free(result);
    }
    check_within("Axial", "bar with a mass on a thrust bearing, extrapolated", low, (4.0 * found[1] - found[0]) / 3.0,
                 3e-7 * low);
    check_holds("Axial", "the mesh alone is further from it", fabs(found[1] - low) > 3e-7 * low);
}

/// Returns the axial displacement of a station at rest, m.
static double axial_rest(const whirl_result *result, size_t station) {
    return axial_field(result, WHIRL_FIELD_MODES_AXIAL_REST, station)[0];
}

/// A cone under a steady axial force: it stretches by F L/(E pi r1 r2) with any mesh, and its thrust bearing gives way
/// by F/k. Of two forces the displacements add up.
static void cone_stretches(void **state) {
    static const char form[] = "  shafts: {s: {axial: yes}}\n"
                               "  stations: {left: {position: 0}, right: {position: 600 mm}}\n"
                               "  elements:\n"
                               "    - segment: {length: 600 mm, outer: 80 mm, outer_end: 30 mm, elements: %d}\n"
                               "    - spring: {between: [left, ground], stiffness: 1e8 N/m}\n"
                               "    - spring: {between: [right, ground], stiffness: 1e8 N/m}\n"
                               "    - spring: {between: [left, ground], along: axial, stiffness: 4e8 N/m}\n"
                               "    - force: {at: right, steady_axial: 20 kN}\n"
                               "    - force: {at: left, steady_axial: -5 kN}\n";
    char text[SIZE];
    (void)state;
    for (int elements = 1; elements <= 4; elements += 3) {
        snprintf(text, sizeof text, form, elements);
        whirl_result *result = axial_modes(text, "count: 4");
        const double stretch = 20e3 * 0.6 / (2.11e11 * axial_pi * 0.04 * 0.015), left = 15e3 / 4e8;
        check_within("Axial", words("thrust bearing under 15 kN, %d elements", elements), left, axial_rest(result, 0),
                     1e-11 * left);
        check_within("Axial", words("cone under 20 kN, %d elements", elements), left + stretch, axial_rest(result, 1),
                     1e-11 * stretch);
        whirl_result_free(result);
    }
}

/// The weight of a vertical bar: its upper end rests on a thrust bearing, the lower one sinks by m g/k + rho g L^2/(2
/// E).
static void vertical_bar_hangs(void **state) {
    static const char form[] = "  shafts: {s: {axial: yes, reduce: %s}}\n"
                               "  stations: {top: {position: %s}, low: {position: %s, mass: 3 kg}}\n"
                               "  elements:\n"
                               "    - segment: {length: 2 m, outer: 40 mm, elements: 8}\n"
                               "    - spring: {between: [top, ground], stiffness: 1e8 N/m}\n"
                               "    - spring: {between: [low, ground], stiffness: 1e8 N/m}\n"
                               "    - spring: {between: [top, ground], along: axial, stiffness: 1e8 N/m}\n"
                               "    - gravity: {axis: vertical, held_at: top, top: %s}\n";
    const double g = 9.80665, area = axial_pi / 4.0 * 0.04 * 0.04, mass = 7810.0 * area * 2.0;
    const double top = (mass + 3.0) * g / 1e8, low = top + (0.5 * mass + 3.0) * g * 2.0 / (2.11e11 * area);
    char text[SIZE];
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        const bool ends = i % 2;
        const double down = ends ? -1.0 : 1.0;
        snprintf(text, sizeof text, form, i / 2 ? "yes" : "no", ends ? "2 m" : "0", ends ? "0" : "2 m",
                 ends ? "end" : "start");
        whirl_result *result = axial_modes(text, "count: 4");
        check_within("Axial", words("thrust bearing of a vertical bar, top: %s", ends ? "end" : "start"), down * top,
                     axial_rest(result, 0), 1e-11 * top);
        check_within("Axial", "lower end of a vertical bar", down * low, axial_rest(result, 1), 1e-10 * low);
        whirl_result_free(result);
    }
}

/// Thrust of helical gears under a steady torque T: F tan(beta) with the tangential force F = T/r_p on the pitch
/// circle, and beta by tan(beta) = tan(beta_b)/cos(alpha). Opposite on both gears; of the other hand the other way.
static void helical_gears_thrust(void **state) {
    static const char form[] =
        "  stations:\n"
        "    one: {mass: 10 kg, polar: 0.05 kg.m2, moves: twist, axial: yes}\n"
        "    two: {mass: 20 kg, polar: 0.2 kg.m2, moves: twist, axial: yes}\n"
        "  elements:\n"
        "    - gear: {between: [one, two], base_radii: [100 mm, 150 mm], stiffness: 4e8 N/m, helix: %g deg, backlash: "
        "0.1 mm}\n"
        "    - spring: {between: [two, ground], along: twist, stiffness: 1e6}\n"
        "    - spring: {between: [one, ground], along: axial, stiffness: 5e7 N/m}\n"
        "    - spring: {between: [two, ground], along: axial, stiffness: 7e7 N/m}\n"
        "    - force: {at: one, steady_torque: 2 kN.m}\n";
    const double degree = axial_pi / 180.0, pressure = 20.0 * degree;
    char text[SIZE];
    (void)state;
    for (int hand = -1; hand <= 1; hand += 2) {
        snprintf(text, sizeof text, form, 18.0 * hand);
        whirl_result *result = axial_modes(text, "count: 4");
        const double along = 2e3 / (0.1 / cos(pressure)) * tan(18.0 * degree) / cos(pressure);
        check_within("Axial", "thrust of the driving gear, N", -hand * along, 5e7 * axial_rest(result, 0),
                     1e-9 * along);
        check_within("Axial", "thrust of the driven gear, N", hand * along, 7e7 * axial_rest(result, 1), 1e-9 * along);
        whirl_result_free(result);
    }
}

/// Two masses and two springs along the shaft, one of them a coupling: frequencies in closed form, and named axial;
/// where one meets the speed is no lateral critical speed.
static void masses_on_couplings(void **state) {
    static const char parts[] = "  stations:\n"
                                "    a: {mass: 40 kg, axial: yes}\n"
                                "    b: {mass: 60 kg, axial: yes}\n"
                                "  elements:\n"
                                "    - spring: {between: [a, ground], stiffness: 1e9 N/m}\n"
                                "    - spring: {between: [b, ground], stiffness: 1e9 N/m}\n"
                                "    - spring: {between: [a, ground], along: axial, stiffness: 3e6 N/m}\n"
                                "    - coupling: {between: [a, b], axial: 2e6 N/m}\n";
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text, "%s", parts);
    const double p = 5e6 / 40.0, q = 2e6 / 60.0, s = p + q, d = sqrt((p - q) * (p - q) + 4.0 * 2e6 * 2e6 / 2400.0);
    whirl_result *result = axial_modes(text, "parameter: n, from: 50 rad/s, to: 600 rad/s, points: 12");
    const whirl_table *table = whirl_result_table(result, "modes");
    check_within("Axial", "first mode of two masses", sqrt(0.5 * (s - d)), axial_frequency(result, 0), 1e-9);
    check_within("Axial", "second mode of two masses", sqrt(0.5 * (s + d)), axial_frequency(result, 1), 1e-9);
    const double known[] = {sqrt(0.5 * (s - d)), sqrt(0.5 * (s + d))};
    size_t met = 0;
    for (size_t point = 0; point < table->count; point++) {
        const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; i < field->rows && row[6 * i] > 0.0; i++) {
            check_within("Axial", "kind of the crossing", WHIRL_AXIAL_SPEED, row[6 * i], 0.0);
            check_within("Axial", "speed of the crossing", known[met < 2 ? met : 1], row[6 * i + 2], 1e-6);
            met++;
        }
    }
    check_within("Axial", "axial frequencies that meet the speed", 2.0, (double)met, 0.0);
    whirl_result_free(result);
}

/// Twist and axial motion that nothing couples to bending change no lateral critical speed, and add none.
static void critical_speeds_stay_lateral(void **state) {
    static const char form[] = "whirl: 1\nrotor:\n  speed: 300 rad/s\n  length_scale: 1 mm\n"
                               "  shafts: {s: {%s}}\n"
                               "  stations: {a: {position: 0}, m: {position: 0.5 m, mass: 10 kg}, b: {position: 1 m}}\n"
                               "  elements:\n"
                               "    - segment: {length: 1 m, outer: 50 mm, elements: 6}\n"
                               "    - spring: {between: [a, ground], stiffness: 1e7 N/m}\n"
                               "    - spring: {between: [b, ground], stiffness: 1e7 N/m}\n%s"
                               "study:\n  critical_speeds: {count: 6}\n";
    static const char held[] = "    - spring: {between: [a, ground], along: axial, stiffness: 1e6 N/m}\n"
                               "    - spring: {between: [a, ground], along: twist, stiffness: 1e4}\n";
    const double *speeds[2];
    whirl_result *results[2];
    char text[SIZE];
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        snprintf(text, sizeof text, form, i == 0 ? "" : "twist: yes, axial: yes", i == 0 ? "" : held);
        results[i] = result_of_text(text);
        speeds[i] = whirl_table_field(&results[i]->tables[0], 0, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
    }
    for (size_t k = 0; k < 6; k++)
        check_within("Axial", words("critical speed %zu with twist and axial motion, rad/s", k + 1), speeds[0][k],
                     speeds[1][k], 1e-9 * speeds[0][k]);
    for (size_t i = 0; i < 2; i++) whirl_result_free(results[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(bar_free_at_both_ends),
                                       cmocka_unit_test(bar_with_a_mass),
                                       cmocka_unit_test(cone_stretches),
                                       cmocka_unit_test(vertical_bar_hangs),
                                       cmocka_unit_test(helical_gears_thrust),
                                       cmocka_unit_test(masses_on_couplings),
                                       cmocka_unit_test(critical_speeds_stay_lateral)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
