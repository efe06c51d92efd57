// Derivatives of the numbers of points by parameters: against closed forms, and against differences of studies at
// neighbouring parameters, which use no derivatives.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine.h"

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 4096 };

/// A disc on a spring: w = sqrt(k/m - (c/2m)^2), ratio c/(2 sqrt(k m)), amplitude e m s^2/|k - m s^2 + i c s|.
static const char disc[] = "whirl: 1\n"
                           "parameters: {k: 4 MN/m, c: 2 kN s/m, m: 10 kg, s: 500 rad/s, e: 10 um}\n"
                           "rotor:\n"
                           "  speed: = s\n"
                           "  length_scale: %s\n"
                           "  rotation: %s\n"
                           "  stations:\n"
                           "    disc: {mass: = m, eccentricity: = e}\n"
                           "  elements:\n"
                           "    - spring: {between: [disc, ground], along: xy, stiffness: = k, damping: = c}\n"
                           "study:\n"
                           "  modes: {parameter: s, values: [500 rad/s, 700 rad/s]}\n"
                           "  unbalance: {parameter: s, values: [500 rad/s, 700 rad/s]}\n"
                           "  sensitivity: {parameters: [k, c, m, s, e]}\n";

/// Largest difference of the present test.
static double worst;

static void assert_close(double obtained, double expected, double within) {
    worst = fmax(worst, fabs(obtained - expected));
    if (!(fabs(obtained - expected) <= within)) fail_msg("%.15g, expected %.15g +- %g", obtained, expected, within);
}

/// Returns the derivative of number `number` by parameter `parameter` at a point, and checks its error.
static double slope_of(const whirl_table *table, size_t point, size_t number, size_t parameter, double within) {
    const size_t parameters = whirl_layout_field(&table->layout, WHIRL_FIELD_SENSITIVITY_PARAMETERS)->rows;
    const double *row = whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_SLOPES, 0);
    const double *numbers = whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_NUMBERS, 0);
    const double *values = whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_PARAMETERS, 0);
    row += 2 * (number * parameters + parameter);
    // Errors are compared as changes of the number by a change of the whole parameter.
    assert_true(row[1] * fabs(values[parameter] / numbers[number]) <= within);
    return row[0];
}

static double number_of(const whirl_table *table, size_t point, size_t number) {
    return whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_NUMBERS, 0)[number];
}

/// Returns the change of a number over the number, by that of a parameter over the parameter.
static double change_of(const whirl_table *table, size_t point, size_t number, size_t parameter, double within) {
    const double *values = whirl_table_field(table, point, WHIRL_FIELD_SENSITIVITY_PARAMETERS, 0);
    return slope_of(table, point, number, parameter, within) * values[parameter] / number_of(table, point, number);
}

/// Returns the index of a number in the list of a table.
static size_t place_of(const whirl_result *result, const whirl_table *table, const char *field) {
    whirl_spread_of of;
    for (size_t i = 0; whirl_table_derived(result, table, i, &of); i++)
        if (strcmp(of.field, field) == 0) return i;
    fail_msg("%s is not derived", field);
    return 0;
}

static void check_disc(const whirl_result *result) {
    const double k = 4e6, c = 2e3, m = 10.0, e = 1e-5;
    // Frequencies and damping ratios by k, c, m; the speed changes nothing.
    const whirl_table *modes = whirl_result_table(result, "modes"),
                      *unbalance = whirl_result_table(result, "unbalance");
    const double square = k / m - c * c / (4.0 * m * m);
    const size_t frequency = place_of(result, modes, WHIRL_FIELD_MODES_FREQUENCY);
    const size_t ratio = place_of(result, modes, WHIRL_FIELD_MODES_DAMPING_RATIO);
    assert_close(number_of(modes, 0, frequency), sqrt(square), 1e-12 * sqrt(square));
    const double by_c = -c * c / (4.0 * m * m * square), by_k = k / (2.0 * m * square);
    assert_close(change_of(modes, 0, frequency, 0, 1e-10), by_k, 1e-10);
    assert_close(change_of(modes, 0, frequency, 1, 1e-10), by_c, 1e-10);
    assert_close(change_of(modes, 0, frequency, 2, 1e-10), 0.0 - by_k - by_c, 1e-10);
    assert_close(change_of(modes, 0, frequency, 3, 1e-8), 0.0, 1e-10);
    assert_close(change_of(modes, 0, ratio, 0, 1e-10), -0.5, 1e-10);
    assert_close(change_of(modes, 0, ratio, 1, 1e-10), 1.0, 1e-10);
    assert_close(change_of(modes, 0, ratio, 2, 1e-10), -0.5, 1e-10);
    // The critical speed between both points is the frequency, which does not depend on the speed.
    const size_t critical = place_of(result, modes, WHIRL_FIELD_MODES_CRITICAL);
    assert_close(number_of(modes, 1, critical), sqrt(square), 1e-9 * sqrt(square));
    assert_close(change_of(modes, 1, critical, 0, 1e-9), by_k, 1e-9);
    assert_close(change_of(modes, 1, critical, 1, 1e-9), by_c, 1e-9);
    assert_close(change_of(modes, 1, critical, 2, 1e-9), 0.0 - by_k - by_c, 1e-9);
    // The response, with D = (k - m s^2)^2 + (c s)^2.
    for (size_t point = 0; point < 2; point++) {
        const double s = unbalance->values[point], rest = k - m * s * s, D = rest * rest + c * c * s * s;
        assert_close(number_of(unbalance, point, 0), e * m * s * s / sqrt(D), 1e-12 * e * m * s * s / sqrt(D));
        assert_close(change_of(unbalance, point, 0, 0, 1e-9), 0.0 - rest * k / D, 1e-9);
        assert_close(change_of(unbalance, point, 0, 1, 1e-9), 0.0 - c * c * s * s / D, 1e-9);
        assert_close(change_of(unbalance, point, 0, 2, 1e-9), 1.0 + rest * m * s * s / D, 1e-9);
        assert_close(change_of(unbalance, point, 0, 3, 1e-9), 2.0 - s * (rest * -2.0 * m * s + c * c * s) / D, 1e-9);
        assert_close(change_of(unbalance, point, 0, 4, 1e-9), 1.0, 1e-9);
    }
}

static void test_a_disc_on_a_spring(void **state) {
    (void)state;
    static const char *const scales[] = {"1 mm", "3.7 m"}, *const rotations[] = {"counter-clockwise", "clockwise"};
    char text[SIZE];
    for (size_t i = 0; i < 4; i++) {
        snprintf(text, sizeof text, disc, scales[i / 2], rotations[i % 2]);
        whirl_result *result = result_of_text(text);
        worst = 0.0;
        check_disc(result);
        check_within("Derived",
                     words("a disc on a spring, %s, %s: 46 numbers and changes, largest difference", scales[i / 2],
                           rotations[i % 2]),
                     0.0, worst, 1e-9);
        whirl_result_free(result);
    }
}

/// Runs a study with one parameter, "p", at a value.
static whirl_result *study_at(const char *format, double p) {
    char text[SIZE], value[40];
    snprintf(value, sizeof value, "%.17g", p);
    snprintf(text, sizeof text, format, value);
    return result_of_text(text);
}

/// Compares the derivatives of all numbers of a table by the parameter "p" with differences of the numbers of studies
/// at p +- h and p +- 2 h, whose error is of order h^4. Numbers of a point may be missing in all of them.
static size_t compare_with_studies(const char *format, double p, const char *name, double h, double within) {
    static const double at[] = {0.0, -2.0, -1.0, 1.0, 2.0};
    whirl_result *results[5];
    const whirl_table *tables[5];
    for (size_t i = 0; i < 5; i++) {
        results[i] = study_at(format, p * (1.0 + at[i] * h));
        tables[i] = whirl_result_table(results[i], name);
        assert_non_null(tables[i]);
    }
    size_t compared = 0;
    const size_t count = whirl_layout_field(&tables[0]->layout, WHIRL_FIELD_SENSITIVITY_NUMBERS)->rows;
    for (size_t point = 0; point < tables[0]->count; point++)
        for (size_t i = 0; i < count; i++) {
            const double own = number_of(tables[0], point, i);
            if (!isfinite(own)) continue;
            const double f[4] = {number_of(tables[1], point, i), number_of(tables[2], point, i),
                                 number_of(tables[3], point, i), number_of(tables[4], point, i)};
            const double expected = (f[0] - 8.0 * f[1] + 8.0 * f[2] - f[3]) / (12.0 * h * own);
            assert_close(change_of(tables[0], point, i, 0, within), expected, within * fmax(1.0, fabs(expected)));
            compared++;
        }
    for (size_t i = 0; i < 5; i++) whirl_result_free(results[i]);
    return compared;
}

// ---------------------------------------------------------------- run-ups

/// A disc on a spring whose speed grows at a constant rate through resonance, w = 10 rad/s.
static const char passage[] = "whirl: 1\n"
                              "parameters: {k: 100 N/m, c: 0.4, m: 1 kg, e: 1 mm, rate: 1 rad/s2}\n"
                              "rotor:\n"
                              "  speed: 5 rad/s\n"
                              "  length_scale: %s\n"
                              "  rotation: %s\n"
                              "  stations:\n"
                              "    disc: {mass: = m, eccentricity: = e}\n"
                              "  elements:\n"
                              "    - spring: {between: [disc, ground], along: xy, stiffness: = k, damping: = c}\n"
                              "study:\n"
                              "  runup: {speed_from: 5 rad/s, speed_to: 17 rad/s, rate: = rate, rtol: 1e-12}\n"
                              "  sensitivity:\n"
                              "    parameters: [k, c, m, e, rate]\n"
                              "    of:\n"
                              "      - {field: runup/peak, at: disc}\n"
                              "      - {field: runup/peak_speed, at: disc}\n";

enum { PASSED = 5 }; ///< parameters of the passage

/// z, z' and their derivatives by k, c, m, e and the rate.
typedef struct passed {
    double complex z[1 + PASSED], v[1 + PASSED];
} passed;

/// Computes the slopes of z'' = e (w^2 - i w') exp(i theta) - (c z' + k z)/m with w = 5 + rate t, and of the
/// derivatives of z, in terms of the equation's derivatives by each parameter.
static passed passage_slopes(double t, const passed *at) {
    const double k = 100.0, c = 0.4, m = 1.0, e = 1e-3, rate = 1.0, w = 5.0 + rate * t;
    const double complex turned = cexp(I * (5.0 * t + 0.5 * rate * t * t)), pulled = w * w - I * rate;
    const double complex z = at->z[0], v = at->v[0];
    const double complex by[1 + PASSED] = {
        e * pulled * turned,       0.0 - z / m,     0.0 - v / m,
        (c * v + k * z) / (m * m), pulled * turned, e * turned * (2.0 * w * t - I + 0.5 * I * t * t * pulled)};
    passed slope;
    for (size_t i = 0; i <= PASSED; i++) {
        slope.z[i] = at->v[i];
        slope.v[i] = by[i] - (c * at->v[i] + k * at->z[i]) / m;
    }
    return slope;
}

/// Takes a step by the method of Runge and Kutta.
static void passage_step(double t, double h, passed *at) {
    static const double share[] = {0.5, 0.5, 1.0}, weight[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    passed end = *at, slope = passage_slopes(t, at);
    for (int stage = 0; stage < 4; stage++) {
        passed next = *at;
        for (size_t i = 0; i <= PASSED; i++) {
            end.z[i] += h * weight[stage] * slope.z[i];
            end.v[i] += h * weight[stage] * slope.v[i];
            if (stage == 3) continue;
            next.z[i] += h * share[stage] * slope.z[i];
            next.v[i] += h * share[stage] * slope.v[i];
        }
        if (stage < 3) slope = passage_slopes(t + h * share[stage], &next);
    }
    *at = end;
}

/// Returns half the slope of |z|^2.
static double passage_growth(const passed *at) {
    return creal(conj(at->z[0]) * at->v[0]);
}

/// Computes the largest radius of the passage and the speed there, with their derivatives: radius and speed
/// [1 + PASSED].
static void passage_peak(double *radius, double *speed) {
    const double h = 1e-4;
    passed at = {{0.0}, {0.0}}, peak = at;
    double most = 0.0, when = 0.0;
    for (size_t i = 0; i < 120000; i++) {
        const double t = (double)i * h;
        passed next = at;
        passage_step(t, h, &next);
        if (passage_growth(&at) > 0.0 && passage_growth(&next) <= 0.0 && cabs(at.z[0]) > most) {
            // Find the peak within the step by Newton's method.
            double part = 0.0;
            for (int round = 0; round < 8; round++) {
                peak = at;
                passage_step(t, part, &peak);
                const passed slope = passage_slopes(t + part, &peak);
                const double bend = creal(conj(slope.z[0]) * peak.v[0] + conj(peak.z[0]) * slope.v[0]);
                part -= passage_growth(&peak) / bend;
            }
            peak = at;
            passage_step(t, part, &peak);
            most = cabs(peak.z[0]);
            when = t + part;
        }
        at = next;
    }
    // Derive the largest value, and its time from the derivatives of the slope, which is 0 there.
    const passed slope = passage_slopes(when, &peak);
    const double bend = creal(conj(slope.z[0]) * peak.v[0] + conj(peak.z[0]) * slope.v[0]);
    radius[0] = most;
    speed[0] = 5.0 + when;
    for (size_t p = 1; p <= PASSED; p++) {
        radius[p] = creal(conj(peak.z[0]) * peak.z[p]) / most;
        const double later = 0.0 - creal(conj(peak.z[p]) * peak.v[0] + conj(peak.z[0]) * peak.v[p]) / bend;
        speed[p] = later + (p == PASSED ? when : 0.0);
    }
}

static void test_a_passage_of_resonance(void **state) {
    (void)state;
    static const char *const scales[] = {"1 mm", "3.7 m"}, *const rotations[] = {"counter-clockwise", "clockwise"};
    double radius[1 + PASSED], speed[1 + PASSED];
    char text[SIZE];
    passage_peak(radius, speed);
    for (size_t i = 0; i < 4; i++) {
        snprintf(text, sizeof text, passage, scales[i / 2], rotations[i % 2]);
        whirl_result *result = result_of_text(text);
        const whirl_table *table = whirl_result_table(result, "runup");
        const double *values = whirl_table_field(table, 0, WHIRL_FIELD_SENSITIVITY_PARAMETERS, 0);
        worst = 0.0;
        assert_close(number_of(table, 0, 0) / radius[0], 1.0, 1e-9);
        assert_close(number_of(table, 0, 1) / speed[0], 1.0, 1e-9);
        for (size_t p = 0; p < PASSED; p++) {
            assert_close(change_of(table, 0, 0, p, 1e-6), radius[1 + p] * values[p] / radius[0], 1e-6);
            assert_close(change_of(table, 0, 1, p, 1e-6), speed[1 + p] * values[p] / speed[0], 1e-6);
        }
        check_within("Derived",
                     words("peak of a run-up through resonance and its speed, %s, %s: 12 numbers and changes, largest "
                           "difference",
                           scales[i / 2], rotations[i % 2]),
                     0.0, worst, 1e-6);
        whirl_result_free(result);
    }
}

/// A rigid rotor in a film, which becomes unstable as it turns faster: the threshold by the clearance.
static const char threshold[] = "whirl: 1\n"
                                "parameters: {p: %s m, s: 100 rad/s}\n"
                                "rotor:\n"
                                "  speed: = s\n"
                                "  length_scale: 0.1 mm\n"
                                "  stations:\n"
                                "    journal: {mass: 30 kg}\n"
                                "  elements:\n"
                                "    - gravity: {}\n"
                                "    - film: {at: journal, clearance: = p, viscosity: 20 mPa.s, radius: 25 mm, "
                                "length: 20 mm}\n"
                                "study:\n"
                                "  modes: {parameter: s, from: 100 rad/s, to: 900 rad/s, points: 9}\n"
                                "  sensitivity: {parameters: [p]}\n";

static void test_a_threshold(void **state) {
    (void)state;
    whirl_result *result = study_at(threshold, 1e-4);
    const whirl_table *modes = whirl_result_table(result, "modes");
    const size_t critical = place_of(result, modes, WHIRL_FIELD_MODES_CRITICAL);
    size_t located = 0;
    for (size_t i = 0; i < modes->count; i++) located += isfinite(number_of(modes, i, critical));
    assert_true(located > 0);
    whirl_result_free(result);
    worst = 0.0;
    const size_t compared = compare_with_studies(threshold, 1e-4, "modes", 2.5e-4, 2e-8);
    assert_true(compared >= 10);
    check_within("Derived",
                 words("modes and %zu thresholds of a film by its clearance: %zu changes, largest difference", located,
                       compared),
                 0.0, worst, 2e-8);
}

/// A finite-element shaft on springs in place of its bearings: the springs' stiffness is the study's own parameter.
static const char springs[] = "whirl: 1\n"
                              "parameters: {p: %s m, stiffness: 100 MN/m}\n"
                              "rotor:\n"
                              "  speed: 300 rad/s\n"
                              "  length_scale: 0.1 mm\n"
                              "  stations:\n"
                              "    left:  {position: 0 m}\n"
                              "    disc:  {position: 0.4 m, mass: 40 kg, diametral: 0.5 kg m2, polar: 0.9 kg m2}\n"
                              "    right: {position: 1 m}\n"
                              "  elements:\n"
                              "    - segment: {length: 1 m, outer: = p}\n"
                              "    - bearing: {at: left, kxx: 50 MN/m, cxx: 2 kN s/m}\n"
                              "    - bearing: {at: right, kxx: 50 MN/m, cxx: 2 kN s/m}\n"
                              "study:\n"
                              "  critical_speeds: {parameter: stiffness, values: [1 MN/m, 10 GN/m], bearings: yes, "
                              "count: 4}\n"
                              "  sensitivity: {parameters: [p]}\n";

static void test_springs_in_place_of_bearings(void **state) {
    (void)state;
    worst = 0.0;
    const size_t compared = compare_with_studies(springs, 0.06, "critical_speeds", 1e-3, 2e-8);
    assert_true(compared >= 6);
    check_within("Derived",
                 words("critical speeds of a shaft by its diameter: %zu changes, largest difference", compared), 0.0,
                 worst, 2e-8);
    // On stiff springs the shaft alone decides: a slender beam's frequency grows at least as its diameter.
    whirl_result *result = study_at(springs, 0.06);
    assert_true(change_of(whirl_result_table(result, "critical_speeds"), 1, 0, 0, 1e-8) > 1.0);
    whirl_result_free(result);
}

/// The rotor of jeffcott-rub.yaml, which rubs in part of a revolution, by the gap.
static const char rub[] = "whirl: 1\n"
                          "parameters: {p: %s m, mu: 0.05}\n"
                          "rotor:\n"
                          "  speed: 1 rad/s\n"
                          "  length_scale: 1 m\n"
                          "  stations:\n"
                          "    disc: {mass: 1 kg, damping: 0.2, eccentricity: 0.9 m}\n"
                          "  elements:\n"
                          "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"
                          "    - rub: {at: disc, gap: = p, stiffness: 10, friction: = mu, law: paper}\n"
                          "    - gravity: 0.5\n"
                          "study:\n"
                          "  response: {}\n"
                          "  initial: {disc: {x: 0.1, y: -0.2}}\n"
                          "  integrate: {method: dop853, transient: 100, record: 32}\n"
                          "  analyze: [regime, spectrum, orbit, floquet]\n"
                          "  sensitivity:\n"
                          "    parameters: [p, mu]\n"
                          "    of:\n"
                          "      - {field: orbit/max_radius, at: disc}\n"
                          "      - {field: orbit/min_radius, at: disc}\n"
                          "      - {field: orbit/mean, column: x, at: disc}\n"
                          "      - {field: orbit/mean, column: y, at: disc}\n"
                          "      - {field: spectrum/synchronous, column: x, at: disc}\n"
                          "      - {field: spectrum/synchronous, column: y, at: disc}\n"
                          "      - {field: spectrum/synchronous, column: forward, at: disc}\n"
                          "      - {field: spectrum/synchronous, column: backward, at: disc}\n"
                          "      - {field: spectrum/synchronous_lag, column: x, at: disc}\n"
                          "      - {field: spectrum/synchronous_lag, column: y, at: disc}\n"
                          "      - {field: spectrum/synchronous_lag, column: forward, at: disc}\n"
                          "      - {field: spectrum/synchronous_lag, column: backward, at: disc}\n"
                          "      - {field: floquet/modulus}\n";

static void test_a_motion_that_rubs(void **state) {
    (void)state;
    worst = 0.0;
    assert_int_equal(compare_with_studies(rub, 1.0, "response", 1e-3, 2e-8), 13);
    check_within("Derived", "a motion that rubs in part of a revolution, by the gap: 13 changes, largest difference",
                 0.0, worst, 2e-7);
    // The numbers of the orbit are those of the record: the largest radius of 1024 instants is a little smaller.
    whirl_result *result = study_at(rub, 1.0);
    const whirl_table *table = whirl_result_table(result, "response");
    whirl_spread_of of;
    for (size_t i = 0; whirl_table_derived(result, table, i, &of); i++) {
        whirl_spread_at at;
        assert_true(whirl_spread_place(result, table, &of, &at));
        const double recorded = whirl_spread_number(result, table, 0, &at);
        assert_close(number_of(table, 0, i), recorded, 1e-5 * fabs(recorded));
    }
    whirl_result_free(result);
}

/// A rotor that rubs, in a map of its speed and damping and in sweeps of one of them.
static const char plane[] = "whirl: 1\n"
                            "parameters: {s: %s, c: %s, mu: 0.05}\n"
                            "rotor:\n"
                            "  speed: = s\n"
                            "  length_scale: 1 m\n"
                            "  stations:\n"
                            "    disc: {mass: 1 kg, damping: = c, eccentricity: 0.9 m}\n"
                            "  elements:\n"
                            "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"
                            "    - rub: {at: disc, gap: 1.2 m, stiffness: 10, friction: = mu, law: paper}\n"
                            "study:\n"
                            "  %s\n"
                            "  integrate: {method: dop853, transient: 100, record: 16}\n"
                            "  analyze: [regime, orbit, spectrum]\n"
                            "  sensitivity: {parameters: [s, c, mu]}\n";

static void test_a_map(void **state) {
    (void)state;
    enum { ACROSS = 3, UP = 2 };
    static const char *const speeds[] = {"0.8 rad/s", "1 rad/s", "1.2 rad/s"}, *const dampings[] = {"0.2", "0.3"};
    char text[SIZE];
    size_t compared = 0;
    snprintf(text, sizeof text, plane, speeds[0], dampings[0],
             "map: {x: {parameter: s, values: [0.8 rad/s, 1 rad/s, 1.2 rad/s]}, y: {parameter: c, values: [0.2, "
             "0.3]}}");
    whirl_result *map = result_of_text(text);
    const whirl_table *of_map = whirl_result_table(map, "map");
    worst = 0.0;
    for (size_t i = 0; i < ACROSS * UP; i++) {
        snprintf(text, sizeof text, plane, speeds[i % ACROSS], dampings[i / ACROSS], "response: {}");
        whirl_result *response = result_of_text(text);
        const whirl_table *alone = whirl_result_table(response, "response");
        const size_t numbers = whirl_layout_field(&alone->layout, WHIRL_FIELD_SENSITIVITY_NUMBERS)->rows;
        for (size_t n = 0; n < numbers; n++)
            for (size_t p = 0; p < 3; p++) {
                const double expected = change_of(alone, 0, n, p, 1e-9);
                assert_close(change_of(of_map, i, n, p, 1e-9), expected, 1e-10 * fmax(1.0, fabs(expected)));
                compared++;
            }
        whirl_result_free(response);
    }
    whirl_result_free(map);
    check_within("Derived",
                 words("a map of a rotor that rubs, and single motions: %zu changes, largest difference", compared),
                 0.0, worst, 1e-10);
}

/// A chaotic motion has no derivatives without `difference` (test_derivatives_of_chaos.c).
static void test_chaos_has_none(void **state) {
    (void)state;
    char text[SIZE];
    snprintf(text, sizeof text, rub, "1");
    char *speed = strstr(text, "speed: 1 rad/s");
    memcpy(speed, "speed: 3.3    ", 14);
    whirl_result *result = result_of_text(text);
    const whirl_table *table = whirl_result_table(result, "response");
    assert_int_not_equal(whirl_table_verdict(table, 0).regime, WHIRL_PERIODIC);
    for (size_t i = 0; i < 13; i++) assert_true(isnan(number_of(table, 0, i)));
    whirl_result_free(result);
}

// ---------------------------------------------------------------- special points of branches

/// Returns the first special point of a kind in a table of branches; fails without one.
static size_t special_row(const whirl_table *table, whirl_special kind) {
    for (size_t i = 0; i < table->count; i++)
        if ((int)table_number(table, i, WHIRL_FIELD_TRACE_SPECIAL, 0) == (int)kind) return i;
    fail_msg("there is no special point of kind %d", (int)kind);
    return 0;
}

/// Compares the derivative of a special point's value by the parameter "p" with differences of branches at p +- h and
/// p +- 2 h, where it is located to 1e-10 of the branch's span.
static void compare_special(const char *what, const char *format, double p, whirl_special kind, double h,
                            double within) {
    double change = NAN, values[5];
    for (int i = -2; i <= 2; i++) {
        whirl_result *result = study_at(format, p * (1.0 + i * h));
        const whirl_table *table = whirl_result_table(result, "branch");
        const size_t row = special_row(table, kind);
        values[2 + i] = table->values[row];
        if (i == 0) change = change_of(table, row, 0, 0, within);
        whirl_result_free(result);
    }
    const double expected = (values[0] - 8.0 * values[1] + 8.0 * values[3] - values[4]) / (12.0 * h * values[2]);
    check_within("Derived", what, expected, change, within * fmax(1.0, fabs(expected)));
}

/// A journal in the short film that begins to whirl at a speed, by its load; and the rotor of jeffcott-rub.yaml by its
/// damping, between speeds.
static const char whirling[] = "whirl: 1\nparameters: {s: 1.5, p: %s}\nrotor:\n  speed: 1 rad/s\n  length_scale: 1 m\n"
                               "  stations: {journal: {mass: 1 kg}}\n  elements:\n"
                               "    - film: {at: journal, clearance: 1 m, load: = p/s^2}\n    - gravity: = 1/s^2\n"
                               "study:\n  branch: {parameter: s, from: 1.5, to: 3, rest: yes, points: 200}\n"
                               "  initial: {journal: {x: 0.1, y: -0.1}}\n  sensitivity: {parameters: [p]}\n";
#define RUBBING(range)                                                                                                 \
    "whirl: 1\nparameters: {omega: 1.5 rad/s, p: %s}\nrotor:\n  speed: = omega\n  length_scale: 1 m\n"                 \
    "  stations: {disc: {mass: 1 kg, damping: = 2*p, eccentricity: 0.9}}\n  elements:\n"                               \
    "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"                                                   \
    "    - rub: {at: disc, gap: 1 m, stiffness: 10, friction: 0.05, law: paper}\n    - gravity: 0.5\n"                 \
    "study:\n  initial: {disc: {x: 0.1, y: -0.2}}\n  integrate: {transient: 400, record: 100}\n"                       \
    "  branch: {parameter: omega, " range ", switches: 0}\n  sensitivity: {parameters: [p]}\n"

static void test_special_points(void **state) {
    (void)state;
    compare_special("speed at which a journal begins to whirl, by its load", whirling, 1.0, WHIRL_HOPF, 1e-3, 1e-8);
    compare_special("speed of a fold of a rotor that rubs, by its damping", RUBBING("from: 3.25, to: 3.3, at: [3.26]"),
                    0.1, WHIRL_FOLD, 1e-3, 1e-8);
    compare_special("speed of a doubling of a rotor that rubs, by its damping", RUBBING("from: 1.5, to: 4, at: [1.8]"),
                    0.1, WHIRL_DOUBLING, 1e-3, 1e-8);
}

/// A rotor whose circle of radius r = e s^2/sqrt((1 - s^2)^2 + (c s)^2) about its sag w touches the stator at the speed
/// where r + w is the gap.
static const char grazing[] = "whirl: 1\n"
                              "parameters: {s: 0.5 rad/s, c: 0.4, gap: 0.8 m, w: 0.1, e: 0.3 m, kappa: 5}\n"
                              "rotor:\n"
                              "  speed: = s\n"
                              "  length_scale: %s\n"
                              "  rotation: %s\n"
                              "  stations: {disc: {mass: 1 kg, damping: = c, eccentricity: = e}}\n"
                              "  elements:\n"
                              "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"
                              "    - contact: {at: disc, gap: = gap, stiffness: = kappa, radius: 1 m, friction: 0.05}\n"
                              "    - gravity: = w\n"
                              "study:\n"
                              "  branch: {parameter: s, from: %s, to: %s, switches: 0}\n"
                              "  sensitivity: {parameters: [c, gap, w, e, kappa, s]}\n";

static void test_a_graze(void **state) {
    (void)state;
    static const char *const scales[] = {"1 m", "3.7 mm"}, *const rotations[] = {"counter-clockwise", "clockwise"};
    static const char *const ends[][2] = {{"0.5", "1"}, {"2", "1.12"}};
    const double c = 0.4, gap = 0.8, w = 0.1, e = 0.3;
    for (size_t i = 0; i < 8; i++) {
        char text[SIZE];
        snprintf(text, sizeof text, grazing, scales[i / 2 % 2], rotations[i % 2], ends[i / 4][0], ends[i / 4][1]);
        whirl_result *result = result_of_text(text);
        const whirl_table *table = whirl_result_table(result, "branch");
        const size_t row = special_row(table, WHIRL_GRAZE);
        // The radius at the graze, and its logarithmic derivatives by the speed and by c.
        const double s = table->values[row], rest = 1.0 - s * s, D = rest * rest + c * c * s * s;
        const double r = e * s * s / sqrt(D), by_s = 2.0 / s - s * (c * c - 2.0 * rest) / D, by_c = 0.0 - c * s * s / D;
        worst = 0.0;
        assert_close(r + w, gap, 1e-8);
        assert_close(change_of(table, row, 0, 0, 1e-7), 0.0 - c / s * by_c / by_s, 1e-8);
        assert_close(change_of(table, row, 0, 1, 1e-7), gap / (s * r * by_s), 1e-8);
        assert_close(change_of(table, row, 0, 2, 1e-7), 0.0 - w / (s * r * by_s), 1e-8);
        assert_close(change_of(table, row, 0, 3, 1e-7), 0.0 - 1.0 / (s * by_s), 1e-8);
        assert_close(change_of(table, row, 0, 4, 1e-7), 0.0, 1e-8);
        assert_true(isnan(whirl_table_field(table, row, WHIRL_FIELD_SENSITIVITY_SLOPES, 0)[2 * 5]));
        check_within("Derived",
                     words("speed %s which a rotor grazes its stator, %s, %s: 6 numbers, largest difference",
                           i < 4 ? "from" : "down to", scales[i / 2 % 2], rotations[i % 2]),
                     0.0, worst, 1e-8);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_disc_on_a_spring),
        cmocka_unit_test(test_a_passage_of_resonance),
        cmocka_unit_test(test_a_threshold),
        cmocka_unit_test(test_springs_in_place_of_bearings),
        cmocka_unit_test(test_a_motion_that_rubs),
        cmocka_unit_test(test_a_map),
        cmocka_unit_test(test_chaos_has_none),
        cmocka_unit_test(test_special_points),
        cmocka_unit_test(test_a_graze),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
