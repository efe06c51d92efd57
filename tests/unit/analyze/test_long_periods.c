// Long periods of motions that settle early: a circle that is locked at p/q turns per revolution, for which everything
// is known.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "whirl/engine/analyze.h"

static const double two_pi = 6.283185307179586;

/// theta' = p/q - (rate/q) sin(q theta - p t) on a circle that draws in: P-q, with the exponent -2 pi rate.
typedef struct lock {
    double p, q, rate;
} lock;

static void slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const lock *l = model;
    const double inwards = 1.0 - x[0] * x[0] - x[1] * x[1];
    const double turn = l->p / l->q - l->rate / l->q * sin(l->q * atan2(x[1], x[0]) - l->p * t);
    (void)forcing;
    dxdt[0] = inwards * x[0] - turn * x[1];
    dxdt[1] = inwards * x[1] + turn * x[0];
}

static whirl_verdict judge(const lock *l, bool settle, double *revolutions) {
    static const whirl_probe probe = {.name = "circle", .y = 1};
    const double start[] = {1.0, 0.001};
    const whirl_system system = {
        .dimension = 2, .period = two_pi, .rhs = slope, .probe_count = 1, .probes = &probe, .model = l};
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    snprintf(integrate.method, sizeof integrate.method, "rk4");
    integrate.steps_per_revolution = 64;
    options.waveform = false;
    options.settle = settle;
    assert_int_equal(whirl_record_motion(&system, &integrate, &options, start, NULL, &record).code, WHIRL_OK);
    const whirl_verdict verdict = whirl_judge(record);
    *revolutions = record->revolutions;
    whirl_record_free(record);
    return verdict;
}

/// Three periods are watched, however early the motion has settled.
static void early_ends_leave_three_periods(void **state) {
    const lock locks[] = {{2, 5, 0.05}, {9, 64, 0.05}, {9, 67, 0.08}, {12, 89, 0.013}, {17, 127, 0.05}};
    (void)state;
    for (size_t i = 0; i < sizeof locks / sizeof *locks; i++) {
        double all, some;
        const whirl_verdict whole = judge(&locks[i], false, &all), early = judge(&locks[i], true, &some);
        assert_int_equal(whole.period, (int)locks[i].q);
        assert_int_equal(early.regime, WHIRL_PERIODIC);
        assert_int_equal(early.period, (int)locks[i].q);
        assert_true(fabs(early.exponent.value + two_pi * locks[i].rate) < 0.01 * two_pi * locks[i].rate);
        assert_true(some < all);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(early_ends_leave_three_periods)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
