// All Lyapunov exponents of machines with uncoupled planes, or other uncoupled groups of coordinates: perturbations
// must span every direction, so that the fastest growth comes first.
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

#include "support_flow.h"
#include "whirl/engine.h"

static const double pi = 3.14159265358979323846;

static void require(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

/// Makes a rotor from the text of `rotor:`.
static whirl_rotor *rotor_from(const char *text) {
    char whole[4096];
    whirl_case *object;
    whirl_rotor *rotor;
    const int length = snprintf(whole, sizeof whole, "whirl: 1\nrotor:\n%s\nstudy: {response: {}}\n", text);
    assert_true(length > 0 && (size_t)length < sizeof whole);
    require(whirl_case_parse(whole, (size_t)length, "text", NULL, &object));
    require(whirl_case_rotor(object, NULL, 0.0, &rotor));
    whirl_case_free(object);
    return rotor;
}

static whirl_record *record_of(const whirl_system *system, const char *method, whirl_growth growth, int transient,
                               int revolutions) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    double *start = calloc(system->dimension, sizeof *start);
    strcpy(integrate.method, method);
    integrate.steps_per_revolution = 256;
    options.transient = transient;
    options.record = options.watch = revolutions;
    options.waveform = false;
    options.growth = growth;
    start[1] = 0.1;
    require(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    free(start);
    return record;
}

static int falling(const void *one, const void *other) {
    const double a = *(const double *)one, b = *(const double *)other;
    return a < b ? 1 : a > b ? -1 : 0;
}

/// Checks that the exponents of a linear rotor without forcing are 2 pi times the real parts of its eigenvalues (by
/// LAPACK).
static void check_linear(const char *text, const char *method) {
    whirl_rotor *rotor = rotor_from(text);
    const whirl_system *system = whirl_rotor_system(rotor);
    const size_t n = system->dimension;
    double matrix[MAX_DIMENSION * MAX_DIMENSION], rest[MAX_DIMENSION] = {0.0}, expected[MAX_DIMENSION];
    double complex values[MAX_DIMENSION];
    whirl_estimate exponents[MAX_DIMENSION];
    exact_jacobian(system, 0.0, rest, matrix);
    eigenvalues(n, matrix, values);
    for (size_t i = 0; i < n; i++) expected[i] = 2.0 * pi * creal(values[i]);
    qsort(expected, n, sizeof *expected, falling);
    whirl_record *record = record_of(system, method, WHIRL_GROWTH_ALL, 0, 200);
    assert_true(whirl_lyapunov_spectrum(record, exponents));
    const double largest = whirl_lyapunov_largest(record).value;
    if (!(fabs(largest - expected[0]) <= 5e-3)) fail_msg("%s: largest %g, expected %g", method, largest, expected[0]);
    for (size_t i = 0; i < n; i++)
        if (!(fabs(exponents[i].value - expected[i]) <= 5e-3))
            fail_msg("%s: exponent %zu is %g, expected %g", method, i + 1, exponents[i].value, expected[i]);
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

/// Largest exponents of planes with different dampings, the smaller one along y; of stations without joints, the last
/// with the least damping; of two equal discs next to a third, whose relative motion is damped least; and of a station
/// of one axis.
static void linear_machines(void **state) {
    static const char *const machines[] = {
        "  speed: 1\n  length_scale: 1\n  stations: {a: {mass: 1}, b: {mass: 2}}\n  elements:\n"
        "    - shaft: {between: [a, b], k1: 2}\n    - bearing: {at: a, kxx: 1, kyy: 1.3, cxx: 0.4, cyy: 0.1}\n"
        "    - bearing: {at: b, kxx: 1, kyy: 1, cxx: 0.3, cyy: 0.05}",
        "  speed: 1\n  length_scale: 1\n  stations: {a: {mass: 1, damping: 0.3}, b: {mass: 1, damping: 0.1}}\n"
        "  elements:\n    - bearing: {at: a, kxx: 1}\n    - bearing: {at: b, kxx: 2, kyy: 3}",
        "  speed: 1\n  length_scale: 1\n  stations: {a: {mass: 1, damping: 0.02}, m: {mass: 1, damping: 0.5}, b: "
        "{mass: 1, "
        "damping: 0.02}}\n  elements:\n    - shaft: {between: [a, m], k1: 1}\n    - shaft: {between: [b, m], k1: 1}\n"
        "    - bearing: {at: m, kxx: 1}",
        "  speed: 1\n  length_scale: 1\n  stations: {a: {mass: 1, damping: 0.4}, p: {mass: 1, moves: y, damping: "
        "0.05}}\n"
        "  elements:\n    - bearing: {at: a, kxx: 1}\n    - spring: {between: [p, ground], along: y, stiffness: 1}"};
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    (void)state;
    for (size_t i = 0; i < sizeof machines / sizeof *machines; i++)
        for (size_t m = 0; m < (i == 0 ? 3 : 1); m++) check_linear(machines[i], methods[m]);
}

/// The loose pedestal at 581.195 rad/s, whose planes are uncoupled, has the largest exponent .41 +- .02 (longer
/// motions, and perturbations along y alone). The perturbed copy must give the same.
static void exponents_decoupled(void **state) {
    static const char *const text =
        "  speed: 581.195 rad/s\n  length_scale: 0.2 mm\n  stations:\n"
        "    disc:     {mass: 20 kg, damping: 800 N.s/m, eccentricity: 60 um}\n"
        "    left:     {mass: 4 kg, damping: 200 N.s/m}\n    right:    {mass: 4 kg, damping: 200 N.s/m}\n"
        "    pedestal: {mass: 30 kg}\n  elements:\n"
        "    - shaft:   {between: [disc, left], k1: 6 MN/m}\n    - shaft:   {between: [disc, right], k1: 6 MN/m}\n"
        "    - bearing: {at: left, kxx: 60 MN/m, cxx: 2 kN.s/m}\n"
        "    - bearing: {at: right, from: pedestal, kxx: 60 MN/m, cxx: 2 kN.s/m}\n"
        "    - spring:  {between: [pedestal, ground], along: x, stiffness: 200 MN/m, damping: 10 kN.s/m}\n"
        "    - looseness: {between: [pedestal, ground], along: y, stiffness: 200 MN/m, damping: 10 kN.s/m,\n"
        "                  loose_stiffness: 1 MN/m, loose_damping: 300 N.s/m, gap: 0.2 mm,\n"
        "                  held_stiffness: 100 MN/m, held_damping: 5 kN.s/m}\n    - gravity: 9.80665 m/s2";
    (void)state;
    whirl_rotor *rotor = rotor_from(text);
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_estimate all[MAX_DIMENSION];
    whirl_record *record = record_of(system, "rk4", WHIRL_GROWTH_ALL, 150, 350);
    whirl_record *twin = record_of(system, "rk4", WHIRL_GROWTH_LARGEST, 150, 350);
    assert_true(whirl_lyapunov_spectrum(record, all));
    const whirl_estimate largest = whirl_lyapunov_largest(record), other = whirl_lyapunov_largest(twin);
    if (!(fabs(all[0].value - 0.41) <= hypot(0.02, 3.0 * all[0].error))) fail_msg("largest of all: %g", all[0].value);
    if (!(fabs(largest.value - other.value) <= 3.0 * hypot(largest.error, other.error)))
        fail_msg("%g +- %g, by its twin %g +- %g", largest.value, largest.error, other.value, other.error);
    for (size_t k = 1; k < system->dimension; k++) assert_true(all[k].value <= all[k - 1].value);
    assert_int_equal(whirl_judge(record).regime, WHIRL_CHAOTIC);
    assert_int_equal(whirl_judge(twin).regime, WHIRL_CHAOTIC);
    whirl_record_free(record);
    whirl_record_free(twin);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(linear_machines), cmocka_unit_test(exponents_decoupled)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
