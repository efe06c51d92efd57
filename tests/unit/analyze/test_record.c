// Records of motions that are known in closed form.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/analyze.h"

static const double pi = 3.14159265358979323846;

/// An oscillator in the plane. From (1, 0, 0, d/2) with d = 1 or -1 it follows x = cos t, y = d/2 sin t. Its contact
/// (wall) has the force x - 0.6 where x > 0.6.
static void harmonic(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[2];
    dxdt[1] = x[3];
    dxdt[2] = -x[0];
    dxdt[3] = -x[1];
}
static void wall(const void *model, const double *x, double *force) {
    (void)model;
    force[0] = x[0] > 0.6 ? x[0] - 0.6 : 0.0;
}
static const whirl_probe probe = {.name = "disc", .x = 0, .y = 1, .vx = 2, .vy = 3};
static const whirl_system ellipse = {.dimension = 4,
                                     .period = 6.28318530717958647692,
                                     .rhs = harmonic,
                                     .contact_count = 1,
                                     .contacts = wall,
                                     .probe_count = 1,
                                     .probes = &probe};

static whirl_record *record(const whirl_system *system, const whirl_record_options *options, const double *start,
                            int steps) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record *made;
    integrate.steps_per_revolution = steps;
    const whirl_status status = whirl_record_motion(system, &integrate, options, start, NULL, &made);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    return made;
}

static void test_ellipse(void **state) {
    (void)state;
    for (int direction = -1; direction <= 1; direction += 2) {
        whirl_record_options options = whirl_record_default();
        options.transient = 4;
        options.record = 3;
        const double start[4] = {1, 0, 0, 0.5 * direction};
        whirl_record *r = record(&ellipse, &options, start, 1024);
        assert_int_equal(r->motion, WHIRL_BOUNDED);
        assert_int_equal(r->section_count, 5); // the record and half the transient
        assert_int_equal(r->record_count, 3);
        assert_int_equal(r->samples_per_revolution, 64);
        assert_int_equal(r->sample_count, 3 * 64);
        assert_true(fabs(r->max_radius[0] - 1) < 1e-9 && fabs(r->min_radius[0] - 0.5) < 1e-9);
        assert_true(fabs(r->mean[0]) < 1e-9 && fabs(r->mean[1]) < 1e-9);
        assert_true(r->backward[0] == (direction < 0 ? 1.0 : 0.0));
        assert_true(fabs(r->low[1] + 0.5) < 1e-9 && fabs(r->high[3] - 0.5) < 1e-9);
        // In contact while |t| < acos 0.6: a share of acos(0.6)/pi, to two instants of 1024; it closes three times.
        assert_true(fabs(r->contact_share[0] - acos(0.6) / pi) < 2.0 / 1024);
        assert_true(r->contact_number[0] == 3.0);
        assert_true(fabs(r->contact_force[0] - 0.4) < 1e-9);
        for (size_t i = 0; i < r->sample_count; i++) {
            const double t = 2 * pi * (double)(i + 1) / 64;
            assert_true(fabs(r->waveform[i] - cos(t)) < 1e-8);
            assert_true(fabs(r->waveform[r->sample_count + i] - 0.5 * direction * sin(t)) < 1e-8);
        }
        for (size_t i = 0; i < r->section_count; i++) assert_true(fabs(r->section[4 * i] - 1) < 1e-8);
        // A centre neither attracts nor repels.
        for (size_t i = 0; i < r->growth_count; i++) assert_true(fabs(r->growth[i]) < 1e-6);
        assert_true(fabs(r->end[0] - 1) < 1e-8);
        whirl_record_free(r);
    }
}

/// A node at (1, 2) with the rates 1/4 and 2: once a perturbation is aligned with x, it shrinks by exp(-1/4) in a
/// revolution.
static void node(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = -0.25 * (x[0] - 1);
    dxdt[1] = -2.0 * (x[1] - 2);
}

static void test_growth_is_the_largest_exponent(void **state) {
    const whirl_system system = {.dimension = 2, .period = 1, .rhs = node};
    whirl_record_options options = whirl_record_default();
    const double start[2] = {3, 3};
    (void)state;
    options.transient = 40;
    options.record = 40;
    options.waveform = false;
    whirl_record *r = record(&system, &options, start, 128);
    assert_int_equal(r->growth_count, 60);
    assert_int_equal(r->sample_count, 0);
    for (size_t i = 20; i < r->growth_count; i++) assert_true(fabs(r->growth[i] + 0.25) < 1e-6);
    whirl_record_free(r);
}

/// x' = x: exp(n) passes the limit in a known revolution.
static void explosion(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[0];
}

static void test_divergence_has_its_revolution(void **state) {
    const whirl_system system = {.dimension = 1, .period = 1, .rhs = explosion};
    whirl_record_options options = whirl_record_default();
    const double start[1] = {1};
    (void)state;
    whirl_record *r = record(&system, &options, start, 64);
    assert_int_equal(r->motion, WHIRL_DIVERGED);
    assert_true(r->diverged_at == 14.0); // e^13 < 1e6 < e^14
    whirl_record_free(r);
}

static void test_samples_divide_the_steps(void **state) {
    whirl_record_options options = whirl_record_default();
    (void)state;
    assert_int_equal(whirl_record_samples(&options, 1024), 64);
    assert_int_equal(whirl_record_samples(&options, 1000), 100);
    assert_int_equal(whirl_record_samples(&options, 997), 997);
    assert_int_equal(whirl_record_samples(&options, 48), 48);
    // The definition, for every number of steps: the smallest divisor from 64 on.
    for (int steps = 1; steps <= 2000; steps++) {
        int found = steps < 64 ? steps : 64;
        while (steps % found != 0) found++;
        assert_int_equal(whirl_record_samples(&options, steps), found);
    }
    assert_int_equal(whirl_record_samples(&options, 2147483647), 2147483647); // a prime; the search must be fast
}

/// x' = -x/4 + cos t: settles on its one periodic motion as exp(-2 pi/4) a revolution.
static void driven(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)forcing;
    dxdt[0] = -0.25 * x[0] + cos(t);
}

static void test_a_settled_transient_ends_early(void **state) {
    const whirl_system system = {.dimension = 1, .period = 2 * 3.14159265358979323846, .rhs = driven};
    whirl_record_options options = whirl_record_default();
    const double start[1] = {5};
    (void)state;
    options.waveform = false;
    whirl_record *whole = record(&system, &options, start, 64);
    options.settle = true;
    whirl_record *early = record(&system, &options, start, 64);
    assert_true(whole->revolutions == 1200);
    // e^(-2 pi n/4) is below 1e-11 after 17 revolutions. 35 returns prove it. Then come 64 revolutions and the record.
    assert_true(early->revolutions > 17 + 35 + 64 + 100 - 5 && early->revolutions < 17 + 35 + 64 + 100 + 10);
    assert_int_equal(early->section_count, 164);
    assert_int_equal(early->growth_count, 164);
    // The motion of period 2 pi at t = 0: x = (cos t + 4 sin t)/(4 + 1/4).
    assert_true(fabs(early->end[0] - 0.25 / (1 + 0.0625)) < 1e-6);
    assert_true(fabs(early->end[0] - whole->end[0]) < 1e-9);
    assert_true(fabs(whirl_lyapunov_largest(early).value + 2 * pi / 4) < 1e-3);
    assert_int_equal(whirl_judge(early).period, 1);
    whirl_record_free(whole);
    whirl_record_free(early);
}

static bool stop_after_three(void *context) {
    int *count = context;
    return ++*count < 3;
}

static void test_a_monitor_can_stop(void **state) {
    whirl_record_options options = whirl_record_default();
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record *r;
    int count = 0;
    const whirl_monitor monitor = {stop_after_three, &count};
    const double start[4] = {1, 0, 0, 0.5};
    (void)state;
    assert_int_equal(whirl_record_motion(&ellipse, &integrate, &options, start, &monitor, &r).code, WHIRL_STOPPED);
    assert_null(r);
    assert_int_equal(count, 3);
}

static void test_contradicting_options_are_refused(void **state) {
    whirl_integrate_options integrate = whirl_integrate_default();
    const double start[4] = {1, 0, 0, 0.5};
    whirl_record_options bad[5];
    whirl_record *r;
    (void)state;
    for (int i = 0; i < 5; i++) bad[i] = whirl_record_default();
    bad[0].record = 0;
    bad[1].transient = -1;
    bad[2].watch = 50;
    bad[3].waveform_revolutions = 101;
    bad[4].samples_per_revolution = 0;
    for (int i = 0; i < 5; i++) {
        const whirl_status status = whirl_record_motion(&ellipse, &integrate, &bad[i], start, NULL, &r);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        assert_true(strlen(status.message) > 20);
        assert_null(r);
    }
}

enum { MAX_STATES = 4 };

/// x_i' = A_i cos(t + phase) - s (x_i - c), A_i = scale/10^i: every perturbation falls by exp(-2 pi s) in a revolution.
typedef struct forced {
    double s, phase, scale, constant;
    size_t states;
} forced;
static void forced_slopes(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const forced *of = model;
    double size = of->scale;
    (void)forcing;
    for (size_t i = 0; i < of->states; i++, size *= 0.1)
        dxdt[i] = size * cos(t + of->phase) - of->s * (x[i] - of->constant);
}

/// The exponent is that of the motion at every phase of the section, also if the state is near zero there.
static void test_growth_with_a_state_near_zero(void **state) {
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    static const double phases[] = {0.0, 0.3, 1.5707963267948966, 3.141592653589793}, scales[] = {1e-3, 1.0, 1e3},
                        constants[] = {0.0, 1.0};
    enum { CASES = 3 * 4 * 3 * 2 * 2 * 2 };
    (void)state;
    for (size_t k = 0; k < CASES; k += 7) { // all values of each, and many of their combinations
        const char *method = methods[k % 3];
        const double constant = constants[k / 36 % 2] * scales[k / 12 % 3];
        const forced of = {k / 72 % 2 ? 1e-2 : 1e-3, phases[k / 3 % 4], scales[k / 12 % 3], constant,
                           k / 144 % 2 ? MAX_STATES : 1};
        const whirl_system system = {.dimension = of.states, .period = 2.0 * pi, .model = &of, .rhs = forced_slopes};
        const double start[MAX_STATES] = {constant, constant, constant, constant};
        whirl_integrate_options integrate = whirl_integrate_default();
        whirl_record_options options = whirl_record_default();
        whirl_record *made;
        snprintf(integrate.method, sizeof integrate.method, "%s", method);
        integrate.atol *= of.scale;
        options.transient = 0;
        options.record = 100;
        options.waveform = false;
        const whirl_status status = whirl_record_motion(&system, &integrate, &options, start, NULL, &made);
        if (status.code != WHIRL_OK) fail_msg("%s", status.message);
        const double exponent = whirl_lyapunov_largest(made).value, right = -2.0 * pi * of.s;
        if (!(fabs(exponent - right) < 1e-3))
            fail_msg("%s, %zu states, s %g, phase %g, scale %g, constant %g: exponent %g for %g", method, of.states,
                     of.s, of.phase, of.scale, constant, exponent, right);
        if (whirl_judge(made).regime == WHIRL_CHAOTIC) fail_msg("%s, phase %g: chaotic", method, of.phase);
        whirl_record_free(made);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ellipse),
        cmocka_unit_test(test_growth_is_the_largest_exponent),
        cmocka_unit_test(test_growth_with_a_state_near_zero),
        cmocka_unit_test(test_divergence_has_its_revolution),
        cmocka_unit_test(test_samples_divide_the_steps),
        cmocka_unit_test(test_a_settled_transient_ends_early),
        cmocka_unit_test(test_a_monitor_can_stop),
        cmocka_unit_test(test_contradicting_options_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
