// Angles that the state drives: a pendulum that rotates without end, compared with its closed form,
//
//     theta'' = -b sin t - 2 c (theta' - 1/2 - b cos t) - (k/2) sin(2 theta - t - 2 b sin t),
//
// of which theta = t/2 + b sin t is a motion, and with it its copy half a turn on: period 2. What is near it follows
// u'' + 2 c u' + k u = 0.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "near.h"
#include "whirl/engine.h"

static const double two_pi = 6.283185307179586476925, pi = 3.14159265358979323846, b = 0.4, c = 0.1;

/// A pendulum; its parameter is k.
static int pendulum(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = -b * sin(t) - 2.0 * c * (x[1] - 0.5 - b * cos(t)) - 0.5 * p[0] * sin(2.0 * x[0] - t - 2.0 * b * sin(t));
    return 0;
}

static whirl_user_system *make(bool lanes, bool angle, const char *method) {
    whirl_user_system *system;
    good(whirl_user_system_new("Pendulum", 2, &system));
    good(whirl_user_system_parameter(system, "k", 0.3, "1", "0.3"));
    good(whirl_user_system_rates(system, pendulum, NULL));
    good(whirl_user_system_oscillates(system, lanes));
    if (angle) good(whirl_user_system_angle(system, 0, two_pi));
    good(whirl_user_system_start(system, 0, 0.2));
    good(whirl_user_system_start(system, 1, 0.6));
    good(whirl_user_system_set(system, "method", method));
    good(whirl_user_system_set(system, "rtol", "1e-9"));
    return system;
}

static void rotation_is_periodic(void **state) {
    static const char *const methods[] = {"dop853", "rk4", "rodas5p", "cvode-bdf"};
    const double ks[] = {0.2, 0.45};
    (void)state;
    for (int form = 0; form < 8; form++) {
        whirl_user_system *system = make(form & 1, true, methods[form / 2]);
        good(whirl_user_system_set(system, "confirm", "yes"));
        good(whirl_user_system_vary(system, "k", ks, 2));
        good(whirl_user_system_analyze(system, "poincare"));
        good(whirl_user_system_analyze(system, "regime"));
        good(whirl_user_system_analyze(system, "lyapunov"));
        whirl_result *result = run(system, 2);
        const whirl_table *table = whirl_result_table(result, "sweep");
        for (size_t i = 0; i < table->count; i++) {
            const whirl_verdict verdict = whirl_table_verdict(table, i);
            const double *section = whirl_table_field(table, i, "poincare/section", 0);
            assert_int_equal(verdict.regime, WHIRL_PERIODIC);
            assert_int_equal(verdict.period, 2);
            assert_int_equal(verdict.confidence, WHIRL_HIGH);
            near(verdict.exponent.value, -c * two_pi, 2e-4);
            near(whirl_table_number(table, i, "lyapunov/largest", 0), -c * two_pi, 2e-2);
            for (size_t n = 0; n < 8; n++) {
                near(remainder(section[4 * n], pi), 0.0, 1e-6);
                near(fabs(section[4 * n] - section[4 * n + 4]), pi, 1e-6);
            }
        }
        whirl_result_free(result);
        whirl_user_system_free(system);
    }
}

/// Without a declared angle the same motion never returns.
static void without_angles_it_is_not_known(void **state) {
    (void)state;
    whirl_user_system *system = make(false, false, "dop853");
    whirl_result *result = run(system, 2);
    assert_int_equal(whirl_table_verdict(&result->tables[0], 0).regime, WHIRL_UNDETERMINED);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

static void branches_of_rotations_have_their_multipliers(void **state) {
    (void)state;
    for (int lanes = 0; lanes < 2; lanes++) {
        whirl_user_system *system = make(lanes, true, "dop853");
        good(whirl_user_system_branch(system, "k", 0.2, 0.6, NULL, 0));
        whirl_result *result = run(system, 2);
        const whirl_table *table = whirl_result_table(result, "branch");
        assert_true(table->count > 3);
        for (size_t i = 0; i < table->count; i++) {
            const double *nodes = whirl_table_field(table, i, "trace/nodes", 0);
            near(remainder(nodes[0], pi), 0.0, 1e-8);
            near(nodes[1], 0.5 + b, 1e-8);
            near(whirl_table_number(table, i, "trace/largest", 0), exp(-2.0 * c * two_pi), 1e-6);
        }
        whirl_result_free(result);
        whirl_user_system_free(system);
    }
}

static void wrong_arguments_are_refused(void **state) {
    (void)state;
    whirl_user_system *system = make(false, false, "dop853");
    refused(whirl_user_system_angle(system, 2, two_pi), "there is no coordinate 2, expected 0 to 1");
    refused(whirl_user_system_angle(system, 0, 0.0), "a turn of coordinate 0 is 0, expected a number above 0");
    refused(whirl_user_system_angle(system, 0, NAN), "expected a number above 0");
    whirl_user_system_free(system);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotation_is_periodic),
        cmocka_unit_test(without_angles_it_is_not_known),
        cmocka_unit_test(branches_of_rotations_have_their_multipliers),
        cmocka_unit_test(wrong_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
