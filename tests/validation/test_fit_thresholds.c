// Fits to onsets of instability, critical speeds and modes: closed forms, and thresholds of branches.
#include <complex.h>
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
#include "whirl/engine.h"

enum { MAX_TEXT = 4096 };

/// Columns of the field fit/unknown.
enum { VALUE = 2, ERROR, HALF, KNOWN = 7, COLUMNS };

static whirl_result *run_text(const char *text) {
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    whirl_result *result = NULL;
    const whirl_status status = whirl_case_parse(text, strlen(text), "fit.yaml", &problems, &object);
    if (status.code != WHIRL_OK) print_error("%s\n", problems.count > 0 ? problems.items[0].message : status.message);
    require_ok(status);
    whirl_problems_free(&problems);
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 2}, &result));
    whirl_case_free(object);
    return result;
}

/// Runs a fit of the disc below.
static whirl_result *run_disc(const char *unknown, const char *data) {
    char text[MAX_TEXT];
    snprintf(text, sizeof text,
             "whirl: 1\n"
             "parameters: {n: 100 rad/s, load: 1, m: 3 kg, k: 30 kN/m, c: 30 N s/m, q: 20 N s/m, e: 50 um}\n"
             "rotor:\n"
             "  speed: = n\n"
             "  length_scale: 1 mm\n"
             "  stations: {disc: {mass: = m, eccentricity: = e}}\n"
             "  elements:\n"
             "    - bearing: {at: disc, kxx: = k, cxx: = c, kxy: = q*n*load, kyx: = -q*n*load}\n"
             "study:\n"
             "  fit:\n"
             "    unknown: %s\n"
             "    data: %s\n"
             "    tolerance: 1e-11\n",
             unknown, data);
    return run_text(text);
}

static const double *unknowns_of(const whirl_result *result) {
    return whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
}

// ---------------------------------------------------------------- closed forms

/// The disc's numbers that were put in.
static const double truth_k = 33e3, truth_c = 37.0, truth_q = 26.0, mass = 3.0;

/// Eigenvalue of whirl in the direction of rotation (1) or against it (-1): m l^2 + c l + k - i s q n = 0, of z = x + i
/// s y with l = a + i b, b > 0.
static double complex eigenvalue(double k, double c, double q, double n, double direction) {
    const double complex root = csqrt(c * c - 4.0 * mass * (k - I * direction * q * n));
    const double complex one = (root - c) / (2.0 * mass), other = (0.0 - root - c) / (2.0 * mass);
    return cimag(one) > 0.0 ? one : other;
}

/// The speed that equals the frequency of the forward mode, by bisection.
static double critical_speed(double k, double c, double q) {
    double low = 50.0, high = 200.0;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(cimag(eigenvalue(k, c, q, middle, 1.0)) > middle ? &low : &high) = middle;
    }
    return low;
}

/// Exact numbers give back what was put in. The onset is at c sqrt(k/m)/q.
static void disc_numbers(void **unused) {
    (void)unused;
    static const char *const names[3] = {"k", "c", "q"};
    const double truth[3] = {truth_k, truth_c, truth_q};
    const double complex at_50 = eigenvalue(truth_k, truth_c, truth_q, 50.0, -1.0);
    char data[MAX_TEXT];
    snprintf(data, sizeof data,
             "[{onset: %.17g rad/s, noise: 1 rad/s}, {critical: %.17g rad/s, whirl: forward, noise: 0.1 rad/s}, "
             "{frequency: %.17g Hz, whirl: forward, noise: 0.01 Hz}, "
             "{damping: %.17g, mode: 1, whirl: backward, noise: 0.001, at: {n: 50 rad/s}}]",
             truth_c * sqrt(truth_k / mass) / truth_q, critical_speed(truth_k, truth_c, truth_q),
             cimag(eigenvalue(truth_k, truth_c, truth_q, 100.0, 1.0)) / 6.283185307179586,
             0.0 - creal(at_50) / cabs(at_50));
    whirl_result *result = run_disc("{k: , c: , q: }", data);
    const double *unknown = unknowns_of(result);
    for (int u = 0; u < 3; u++)
        check_within("Fit to thresholds", words("onset, critical speed, frequency and damping of a disc: %s", names[u]),
                     truth[u], unknown[COLUMNS * u + VALUE], 1e-8 * truth[u]);
    whirl_result_free(result);
}

/// The error of one unknown from one number is its noise over the derivative.
static void errors_of_numbers(void **unused) {
    (void)unused;
    const double n = truth_c * sqrt(truth_k / mass) / truth_q;
    char data[MAX_TEXT];
    // The onset c sqrt(k/m)/q by q, and along a factor of the cross coupling at 100 rad/s: c sqrt(k/m)/(100 q).
    snprintf(data, sizeof data, "{onset: %.17g rad/s, noise: 2 rad/s, at: {k: 33 kN/m, c: 37 N s/m}}", n);
    whirl_result *result = run_disc("{q: }", data);
    check_within("Fit to thresholds", "onset over the speed: q", truth_q, unknowns_of(result)[VALUE], 1e-9 * truth_q);
    check_within("Fit to thresholds", "onset over the speed: standard error of q", 2.0 * truth_q / n,
                 unknowns_of(result)[ERROR], 1e-8);
    whirl_result_free(result);
    snprintf(data, sizeof data, "{onset: %.17g, along: load, noise: 0.03, at: {k: 33 kN/m, q: 26 N s/m}}", 0.01 * n);
    result = run_disc("{c: }", data);
    check_within("Fit to thresholds", "onset over a parameter: c", truth_c, unknowns_of(result)[VALUE], 1e-9 * truth_c);
    check_within("Fit to thresholds", "onset over a parameter: standard error of c", 0.03 * truth_c / (0.01 * n),
                 unknowns_of(result)[ERROR], 1e-8);
    whirl_result_free(result);
    // An onset tells nothing of the unbalance.
    snprintf(data, sizeof data,
             "[{onset: %.17g rad/s, noise: 2 rad/s, at: {k: 33 kN/m, c: 37 N s/m}}, {onset: %.17g "
             "rad/s, noise: 2 rad/s, at: {k: 33 kN/m, c: 37 N s/m}}]",
             n, n);
    result = run_disc("{q: , e: }", data);
    assert_int_equal((int)unknowns_of(result)[KNOWN], WHIRL_FIT_DETERMINED);
    assert_int_equal((int)unknowns_of(result)[COLUMNS + KNOWN], WHIRL_FIT_UNKNOWN);
    whirl_result_free(result);
}

/// The unbalance response of a linear machine loses its stability where the equilibrium does: a Neimark-Sacker point.
static void onset_of_an_orbit(void **unused) {
    (void)unused;
    const double n = truth_c * sqrt(truth_k / mass) / truth_q;
    char data[MAX_TEXT];
    snprintf(data, sizeof data, "{onset: %.17g rad/s, of: orbit, noise: 2 rad/s, at: {k: 33 kN/m, c: 37 N s/m}}", n);
    whirl_result *result = run_disc("{q: }", data);
    check_within("Fit to thresholds", "onset of an orbit, Neimark-Sacker: q", truth_q, unknowns_of(result)[VALUE],
                 1e-7 * truth_q);
    check_within("Fit to thresholds", "onset of an orbit, Neimark-Sacker: standard error of q", 2.0 * truth_q / n,
                 unknowns_of(result)[ERROR], 1e-6);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- the fold of a rotor that rubs

#define RUBBING                                                                                                        \
    "whirl: 1\nparameters: {omega: 1.5 rad/s, p: %s}\nrotor:\n  speed: = omega\n  length_scale: 1 m\n"                 \
    "  stations: {disc: {mass: 1 kg, damping: = 2*p, eccentricity: 0.9}}\n  elements:\n"                               \
    "    - shaft: {between: [disc, ground], k1: 1 N/m}\n"                                                              \
    "    - rub: {at: disc, gap: 1 m, stiffness: 10, friction: 0.05, law: paper}\n    - gravity: 0.5\n"                 \
    "study:\n  initial: {disc: {x: 0.1, y: -0.2}}\n"

/// The speed at which the branch turns back: that of a branch study, at p = 0.1.
static double fold_speed(void) {
    char text[MAX_TEXT];
    snprintf(text, sizeof text, RUBBING "  branch: {parameter: omega, from: 1.5, to: 3.3, at: [1.8], switches: 0}\n",
             "0.1");
    whirl_result *result = run_text(text);
    const whirl_table *table = &result->tables[0];
    double speed = NAN;
    for (size_t i = table->count; i-- > 0;)
        if ((int)*whirl_table_field(table, i, WHIRL_FIELD_TRACE_SPECIAL, 0) == WHIRL_FOLD &&
            !(speed > table->values[i]))
            speed = table->values[i];
    whirl_result_free(result);
    return speed;
}

static void onset_at_a_fold(void **unused) {
    (void)unused;
    // A change of the speed by 1 % for 1 % more p, tests/validation/test_derivatives.c.
    static const double change = -0.0110324171669049;
    const double speed = fold_speed();
    char text[MAX_TEXT];
    snprintf(text, sizeof text,
             RUBBING "  fit:\n    unknown: {p: }\n    transient: 400\n    tolerance: 1e-11\n"
                     "    data: {onset: %.17g rad/s, of: orbit, noise: 1e-6 rad/s, from: 1.8 rad/s, to: 4 rad/s}\n",
             "0.11", speed);
    whirl_result *result = run_text(text);
    check_within("Fit to thresholds", "onset of an orbit, fold of a rotor that rubs: its damping", 0.1,
                 unknowns_of(result)[VALUE], 1e-7);
    check_within("Fit to thresholds", "onset of an orbit, fold: standard error of the damping",
                 fabs(1e-6 * 0.1 / (speed * change)), unknowns_of(result)[ERROR], 1e-11);
    whirl_result_free(result);
}

/// A machine without the threshold is named.
static void no_onset(void **unused) {
    (void)unused;
    whirl_result *result = run_disc("{k: }", "{onset: 40 rad/s, noise: 2 rad/s, to: 60 rad/s}");
    const double *outcome = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_OUTCOME, 0);
    assert_int_equal((int)outcome[0], WHIRL_FIT_NO_MOTION);
    assert_true(isnan(unknowns_of(result)[VALUE]));
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(disc_numbers), cmocka_unit_test(errors_of_numbers),
                                       cmocka_unit_test(onset_of_an_orbit), cmocka_unit_test(onset_at_a_fold),
                                       cmocka_unit_test(no_onset)};
    return cmocka_run_group_tests_name("fit_thresholds", tests, NULL, NULL);
}
