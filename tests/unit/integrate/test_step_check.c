// Steps that are too long, against RK4's known region (Hairer, Wanner: Solving Ordinary Differential Equations II,
// IV.2).
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "method.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- steps

/// x'' + 2 d x' + w^2 x = cos t: lambda = -d +- sqrt(d^2 - w^2).
typedef struct spring {
    double damping, square;
} spring;

static void spring_slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const spring *own = model;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = cos(t) - 2 * own->damping * x[1] - own->square * x[0];
}

static void spring_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                           size_t count, const double *dx, double *ddxdt) {
    const spring *own = model;
    (void)t, (void)forcing, (void)x, (void)sides;
    for (size_t i = 0; i < count; i++, dx += 2, ddxdt += 2) {
        ddxdt[0] = dx[1];
        ddxdt[1] = -2 * own->damping * dx[1] - own->square * dx[0];
    }
}

static whirl_step_check check_spring(double damping, double square, int steps, bool jacobian) {
    const spring model = {damping, square};
    const whirl_system system = {.dimension = 2,
                                 .period = 2 * pi,
                                 .rhs = spring_slope,
                                 .tangent = jacobian ? spring_tangent : NULL,
                                 .model = &model};
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    whirl_step_check check;
    const double start[2] = {0.1, 0.0};
    double end[2] = {0.1, 0.0};
    strcpy(options.method, "rk4");
    options.steps_per_revolution = steps;
    assert_int_equal(whirl_integrator_new(&system, &options, &integrator).code, WHIRL_OK);
    whirl_integrator_revolve(integrator, end, NULL, NULL);
    whirl_integrator_free(integrator);
    assert_int_equal(whirl_step_check_revolution(&system, &options, start, end, 1e-10, &check).code, WHIRL_OK);
    return check;
}

/// Real eigenvalues -r, -1/r (r = 1000): stable up to h r = 2.785293563. The Jacobian by the system or by differences.
static void test_the_limit_of_decay(void **state) {
    const double r = 1000, damping = 0.5 * (r + 1 / r), least = 2 * pi * r / 2.785293563405282;
    (void)state;
    for (int jacobian = 0; jacobian < 2; jacobian++) {
        const whirl_step_check good = check_spring(damping, 1, (int)ceil(least), jacobian);
        const whirl_step_check bad = check_spring(damping, 1, (int)(0.99 * least), jacobian);
        assert_false(whirl_step_is_unstable(&good));
        assert_true(good.steps == ceil(least));
        assert_true(whirl_step_is_unstable(&bad));
        assert_true(bad.steps >= least && bad.steps <= 1.1 * least);
        assert_true(isnan(bad.error)); // for other methods the machine is not evaluated
        const double z = -2 * pi * r / (0.5 * least);
        const double growth = 1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4)));
        const whirl_step_check half = check_spring(damping, 1, (int)(0.5 * least), jacobian);
        assert_true(fabs(half.growth / growth - 1) < 1e-2);
    }
}

/// Without damping: stable up to h w = 2 sqrt 2.
static void test_the_limit_of_oscillation(void **state) {
    const double w = 200, least = 2 * pi * w / (2 * sqrt(2.0));
    (void)state;
    const whirl_step_check good = check_spring(0, w * w, (int)ceil(1.001 * least), true);
    const whirl_step_check bad = check_spring(0, w * w, (int)(0.98 * least), true);
    assert_false(whirl_step_is_unstable(&good));
    assert_true(good.error > 0.05); // stable, but wrong: the method damps an undamped mode
    assert_true(whirl_step_is_unstable(&bad));
}

/// A machine that is itself unstable is no reason to refuse the step.
static void test_unstable_machines(void **state) {
    (void)state;
    const whirl_step_check slow = check_spring(-0.1, 4, 64, true), fast = check_spring(-3, 1, 64, true);
    assert_false(whirl_step_is_unstable(&slow));
    assert_false(whirl_step_is_unstable(&fast));
}

/// The error of a revolution by RK4 is the known one: of order 4, to the tolerance of what it is compared with.
static void test_the_error_of_a_revolution(void **state) {
    (void)state;
    const double coarse = check_spring(0.05, 4, 32, true).error, fine = check_spring(0.05, 4, 64, true).error;
    assert_true(fabs(log2(coarse / fine) - 4) < 0.2);
    assert_true(check_spring(0.05, 4, 4096, true).error < 1e-9);
}

static void test_methods_with_a_tolerance_are_left_alone(void **state) {
    const spring model = {1e6, 1};
    const whirl_system system = {.dimension = 2, .period = 2 * pi, .rhs = spring_slope, .model = &model};
    whirl_integrate_options options = whirl_integrate_default();
    const double start[2] = {0, 0};
    whirl_step_check check;
    (void)state;
    strcpy(options.method, "dop853");
    assert_int_equal(whirl_step_check_revolution(&system, &options, start, NULL, 1e-6, &check).code, WHIRL_OK);
    assert_true(check.growth == 1 && isnan(check.error));
    strcpy(options.method, "rk5");
    assert_int_equal(whirl_step_check_revolution(&system, &options, start, NULL, 1e-6, &check).code, WHIRL_BAD_INPUT);
}

/// The steps of dop853 are in proportion to the decay rate, by its own limit on the real axis; those of rodas5p are not
/// limited.
static void test_steps_of_stiff_machines(void **state) {
    double steps[2];
    (void)state;
    for (int i = 0; i < 3; i++) {
        const double rates[] = {50, 1e4, 1e5}, r = rates[i];
        const spring model = {0.5 * (r + 1 / r), 1};
        const whirl_system system = {
            .dimension = 2, .period = 2 * pi, .rhs = spring_slope, .tangent = spring_tangent, .model = &model};
        const whirl_integrate_options options = whirl_integrate_default();
        const double from[2] = {0.1, 0.0};
        whirl_method_cost cost;
        assert_int_equal(whirl_method_probe(&system, &options, from, &cost).code, WHIRL_OK);
        if (i == 0) {
            assert_true(cost.dop853 == 0 && isnan(cost.rodas5p));
            continue;
        }
        steps[i - 1] = cost.dop853 / 12;
        // dop853 is stable on the negative axis where |R| <= 1, tried here in steps of a thousandth.
        double limit = 0;
        while (dop853_amplification(-limit - 1e-3, 0) <= 1) limit += 1e-3;
        const double least = 2 * pi * r / limit;
        assert_true(steps[i - 1] >= 0.999 * least && steps[i - 1] <= 1.06 * least);
        assert_true(cost.rodas5p > 100 && cost.rodas5p < 5e3);
    }
}

/// Stability functions are exp to the order of their method.
static void test_amplification(void **state) {
    (void)state;
    for (int i = 0; i < 8; i++) {
        const double angle = 0.25 * pi * i, z = 0.1, x = z * cos(angle), y = z * sin(angle);
        assert_true(fabs(rk4_amplification(x, y) - exp(x)) < 2 * pow(z, 5) / 120);
        assert_true(fabs(dop853_amplification(x, y) - exp(x)) < 1e-14);
        const double bx = 0.5 * cos(angle), by = 0.5 * sin(angle);
        assert_true(fabs(dop853_amplification(bx, by) - exp(bx)) < 1e-8);
    }
    assert_true(fabs(rk4_amplification(-2.785293563405282, 0) - 1) < 1e-12);
    assert_true(fabs(rk4_amplification(0, 2 * sqrt(2.0)) - 1) < 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_limit_of_decay),
        cmocka_unit_test(test_the_limit_of_oscillation),
        cmocka_unit_test(test_unstable_machines),
        cmocka_unit_test(test_the_error_of_a_revolution),
        cmocka_unit_test(test_methods_with_a_tolerance_are_left_alone),
        cmocka_unit_test(test_amplification),
        cmocka_unit_test(test_steps_of_stiff_machines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
