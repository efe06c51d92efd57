// Motions of an oscillator under a constant load, all in closed form: rest, with the small residual motion of adaptive
// steps; motions that only look like rest; growth.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/analyze.h"

static const double two_pi = 6.283185307179586;

/// u'' + 2 damping (1 - 4 (u/cycle)^2) u' + u = force cos t, u = x - load; cycle 0: linear. With a damping below 0 and
/// little of it the motion ends on a cycle of the amplitude `cycle` (van der Pol 1926).
typedef struct oscillator {
    double damping, load, force, cycle;
} oscillator;

static double bend(const oscillator *o, double u) {
    return o->cycle > 0.0 ? 4.0 * u * u / (o->cycle * o->cycle) : 0.0;
}

static void slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const oscillator *o = model;
    const double u = x[0] - o->load;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = o->force * cos(t) - u - 2.0 * o->damping * (1.0 - bend(o, u)) * x[1];
}

static void tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                    size_t count, const double *dx, double *out) {
    const oscillator *o = model;
    const double u = x[0] - o->load, b = bend(o, u);
    (void)t, (void)forcing, (void)sides;
    for (; count > 0; count--, dx += 2, out += 2) {
        const double by_u = u != 0.0 ? 4.0 * o->damping * b / u * x[1] - 1.0 : -1.0;
        out[0] = dx[1];
        out[1] = by_u * dx[0] - 2.0 * o->damping * (1.0 - b) * dx[1];
    }
}

static whirl_verdict judge(const oscillator *o, const char *method, const double *start, int transient) {
    static const whirl_probe probe = {.name = "mass", .vx = 1, .vy = 1};
    const whirl_system system = {.dimension = 2,
                                 .period = two_pi,
                                 .rhs = slope,
                                 .tangent = tangent,
                                 .probe_count = 1,
                                 .probes = &probe,
                                 .model = o};
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    snprintf(integrate.method, sizeof integrate.method, "%s", method);
    integrate.steps_per_revolution = 128;
    options.transient = transient;
    options.waveform = false;
    assert_int_equal(whirl_record_motion(&system, &integrate, &options, start, NULL, &record).code, WHIRL_OK);
    const whirl_verdict verdict = whirl_judge(record);
    whirl_record_free(record);
    return verdict;
}

static const char *const methods[] = {"rk4", "dop853", "rodas5p", "cvode-bdf"};

/// At an equilibrium the exponent is -2 pi damping per revolution, and the order of the mode sqrt(1 - damping^2).
static void rests_by_all_methods(void **state) {
    const double dampings[] = {0.6, 0.1, 0.01}, start[] = {0.0, 0.0};
    (void)state;
    for (size_t m = 0; m < 4; m++)
        for (size_t i = 0; i < 3; i++) {
            const oscillator o = {.damping = dampings[i], .load = 0.7};
            const whirl_verdict v = judge(&o, methods[m], start, 600);
            char name[64];
            whirl_verdict_name(&v, name, sizeof name);
            assert_string_equal(name, "rests");
            assert_true(v.regime == WHIRL_PERIODIC && v.period == 1 && v.rest_distance <= 1e-5);
            assert_true(fabs(v.exponent.value + two_pi * dampings[i]) < 1e-8);
            assert_true(fabs(v.rest_order - sqrt(1.0 - dampings[i] * dampings[i])) < 1e-8);
            if (strcmp(methods[m], "cvode-bdf") != 0) assert_int_equal(v.agreement, WHIRL_HIGH);
        }
}

/// Equilibria at 0 are found, too, where a motion has no size except the errors of its steps.
static void rests_at_zero(void **state) {
    const oscillator o = {.damping = 0.1};
    const double start[] = {0.3, 0.0};
    (void)state;
    for (size_t m = 0; m < 3; m++) assert_true(judge(&o, methods[m], start, 1100).rests);
}

/// No equilibrium is reported for a vibration, however small; for a cycle about an unstable equilibrium; and for an
/// equilibrium that attracts so slowly that the motion near it may be another one.
static void motions_that_are_not_at_rest(void **state) {
    const oscillator forced = {.damping = 0.1, .load = 0.7, .force = 1e-7};
    const oscillator cycle = {.damping = -0.01, .load = 0.7, .cycle = 1e-7};
    const oscillator slow = {.damping = 1e-8, .load = 0.7};
    const double start[] = {0.7 + 5e-8, 0.0}, beside[] = {0.7 + 3e-6, 0.0};
    (void)state;
    for (size_t m = 0; m < 3; m++) {
        assert_false(judge(&forced, methods[m], start, 300).rests);
        assert_false(judge(&cycle, methods[m], start, 300).rests);
        assert_false(judge(&slow, methods[m], beside, 300).rests);
    }
    assert_int_equal(judge(&forced, "rk4", start, 300).period, 1);
}

/// A motion that is not at rest at the second tolerance is P-1 at most.
static void rest_needs_both_tolerances(void **state) {
    const oscillator o = {.damping = 0.1, .load = 0.7};
    const double start[] = {0.0, 0.0};
    (void)state;
    const whirl_verdict rests = judge(&o, "dop853", start, 300);
    whirl_verdict both = rests, one = rests, other = rests;
    other.rests = false;
    whirl_verdict_confirm(&both, &rests);
    whirl_verdict_confirm(&one, &other);
    assert_true(both.rests && both.confidence == WHIRL_HIGH);
    assert_false(one.rests);
}

/// An unstable linear machine moves away from its forced motion by e^(2 pi damping) a revolution, and the verdict
/// reports this growth.
static void unstable_machines_grow(void **state) {
    const double dampings[] = {-1e-4, -5e-4, -1e-3}, start[] = {1.0, 0.0};
    (void)state;
    for (size_t m = 0; m < 2; m++)
        for (size_t i = 0; i < 3; i++) {
            const oscillator o = {.damping = dampings[i], .load = 0.7};
            const whirl_verdict v = judge(&o, methods[m], start, 700);
            char reason[512];
            whirl_verdict_reason(&v, reason, sizeof reason);
            assert_int_equal(v.regime, WHIRL_UNDETERMINED);
            assert_non_null(strstr(reason, "grows: by "));
            assert_true(fabs(v.swelling + two_pi * dampings[i]) < 0.02 * two_pi * -dampings[i]);
            assert_int_equal(v.advice.remedy, WHIRL_LONGER_TRANSIENT);
        }
    const oscillator sound = {.damping = 1e-4, .load = 0.7};
    const whirl_verdict v = judge(&sound, "dop853", start, 700);
    char reason[512];
    whirl_verdict_reason(&v, reason, sizeof reason);
    assert_null(strstr(reason, "grows"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rests_by_all_methods),         cmocka_unit_test(rests_at_zero),
        cmocka_unit_test(motions_that_are_not_at_rest), cmocka_unit_test(rest_needs_both_tolerances),
        cmocka_unit_test(unstable_machines_grow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
