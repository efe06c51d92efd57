// Integrators against closed forms, and their messages about bad options and motions without bounds.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/integrate.h"

static const double pi = 3.14159265358979323846;

/// x'' + 2 zeta x' + x = cos(2t), zeta = 0.1; from (0, 0).
static void oscillator(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t;
    dxdt[0] = x[1];
    dxdt[1] = forcing[0] - 0.2 * x[1] - x[0];
}
static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    forcing[0] = cos(2 * t);
}
static double oscillator_solution(double t) {
    // Steady part a cos 2t + b sin 2t with (-3 + 0.4 i) response; free part from the start at rest.
    const double d = 9 + 0.16, a = -3 / d, b = 0.4 / d, wd = sqrt(0.99);
    const double c1 = -a, c2 = (-2 * b + 0.1 * c1) / wd;
    return a * cos(2 * t) + b * sin(2 * t) + exp(-0.1 * t) * (c1 * cos(wd * t) + c2 * sin(wd * t));
}
static const whirl_system forced = {
    .dimension = 2, .period = 3.14159265358979323846, .forcing_count = 1, .forcing = cosine, .rhs = oscillator};

static double error_after(const char *method, int steps, double rtol, int revolutions) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    double x[2] = {0, 0};
    strcpy(options.method, method);
    options.steps_per_revolution = steps;
    options.rtol = rtol;
    options.atol = rtol * 1e-2;
    assert_int_equal(whirl_integrator_new(&forced, &options, &integrator).code, WHIRL_OK);
    for (int i = 0; i < revolutions; i++)
        assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
    whirl_integrator_free(integrator);
    return fabs(x[0] - oscillator_solution(revolutions * pi));
}

static void test_rk4_has_order_four(void **state) {
    (void)state;
    const double coarse = error_after("rk4", 32, 1, 7), fine = error_after("rk4", 64, 1, 7),
                 finest = error_after("rk4", 128, 1, 7);
    assert_true(fabs(log2(coarse / fine) - 4) < 0.15);
    assert_true(fabs(log2(fine / finest) - 4) < 0.1);
    assert_true(error_after("rk4", 2048, 1, 7) < 1e-12);
}

static void test_cvode_keeps_its_tolerance(void **state) {
    (void)state;
    assert_true(error_after("cvode-adams", 1024, 1e-11, 7) < 1e-8);
    assert_true(error_after("cvode-bdf", 1024, 1e-11, 7) < 1e-8);
}

static void test_steps_need_not_be_a_power_of_two(void **state) {
    (void)state;
    assert_true(error_after("rk4", 997, 1, 7) < 1e-10);
    assert_true(error_after("rk4", 1, 1, 0) < 1e-15);
}

/// A ball that falls on an elastic floor: z'' = -1 - k z [z < 0]; the period of a bounce from height h is
/// 2 (pi + 2 atan(1/sqrt(2 h k)))... computed below; the state returns to the top exactly.
static const double stiffness = 1e4, height = 0.5;
static void bouncing(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -1 - (x[0] < 0 ? stiffness * x[0] : 0);
}
static void floor_level(const void *model, double t, const double *x, double *values) {
    (void)model, (void)t;
    values[0] = -x[0];
}

static void test_cvode_locates_contacts(void **state) {
    // Flight up and down 2 sqrt(2h); contact: u'' + k u = 0 about the static depth 1/k, entered with speed v =
    // sqrt(2h): half period pi/w plus the two arcs from the floor to the static depth, atan(1/(w v)) each.
    const double w = sqrt(stiffness), v = sqrt(2 * height);
    const whirl_system ball = {.dimension = 2,
                               .period = 2 * v + (pi + 2 * atan(1 / (w * v))) / w,
                               .rhs = bouncing,
                               .switch_count = 1,
                               .switches = floor_level};
    whirl_integrate_options options = whirl_integrate_default();
    double errors[2];
    (void)state;
    for (int located = 0; located < 2; located++) {
        whirl_integrator *integrator;
        double x[2] = {height, 0};
        strcpy(options.method, located ? "cvode-adams" : "rk4");
        options.steps_per_revolution = 1000;
        options.rtol = 1e-12;
        options.atol = 1e-14;
        assert_int_equal(whirl_integrator_new(&ball, &options, &integrator).code, WHIRL_OK);
        for (int i = 0; i < 5; i++) whirl_integrator_revolve(integrator, x, NULL, NULL);
        whirl_integrator_free(integrator);
        errors[located] = fabs(x[0] - height) + fabs(x[1]);
    }
    assert_true(errors[1] < 1e-8);
    assert_true(errors[0] > 1e-5); // a fixed step walks over the contact
}

typedef struct seen {
    int count;
    double last, worst;
} seen;

static void see(void *observer, double t, const double *x) {
    seen *s = observer;
    s->count++;
    assert_true(t > s->last);
    s->last = t;
    const double error = fabs(x[0] - oscillator_solution(t));
    s->worst = error > s->worst ? error : s->worst;
}

static void test_observers_see_equal_parts(void **state) {
    const char *const methods[] = {"rk4", "dop853", "rodas5p", "cvode-adams", "cvode-bdf"};
    (void)state;
    for (int m = 0; m < 5; m++) {
        whirl_integrate_options options = whirl_integrate_default();
        whirl_integrator *integrator;
        seen s = {0};
        double x[2] = {0, 0};
        strcpy(options.method, methods[m]);
        options.steps_per_revolution = 250;
        options.rtol = 1e-10;
        options.atol = 1e-12;
        assert_int_equal(whirl_integrator_new(&forced, &options, &integrator).code, WHIRL_OK);
        whirl_integrator_revolve(integrator, x, see, &s);
        whirl_integrator_free(integrator);
        assert_int_equal(s.count, 250);
        assert_true(fabs(s.last - pi) < 1e-15);
        assert_true(s.worst < 1e-7);
    }
}

static void runaway(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[0] * x[0]; // infinite at t = 1/x(0)
}

static void test_divergence_is_a_result(void **state) {
    const whirl_system system = {.dimension = 1, .period = 1, .rhs = runaway};
    const char *const methods[] = {"rk4", "dop853", "rodas5p", "cvode-adams", "cvode-bdf"};
    (void)state;
    for (int m = 0; m < 5; m++) {
        whirl_integrate_options options = whirl_integrate_default();
        whirl_integrator *integrator;
        double x[1] = {0.4};
        strcpy(options.method, methods[m]);
        assert_int_equal(whirl_integrator_new(&system, &options, &integrator).code, WHIRL_OK);
        int revolution = 0;
        whirl_motion motion = WHIRL_BOUNDED;
        while (motion == WHIRL_BOUNDED && revolution < 10) {
            motion = whirl_integrator_revolve(integrator, x, NULL, NULL);
            revolution++;
        }
        whirl_integrator_free(integrator);
        assert_int_not_equal(motion, WHIRL_BOUNDED);
        assert_int_equal(revolution, 3); // 1/0.4 = 2.5
    }
}

static void test_calls_may_alternate(void **state) {
    const char *const methods[] = {"rk4", "dop853", "rodas5p", "cvode-adams"};
    (void)state;
    for (int m = 0; m < 4; m++) {
        whirl_integrate_options options = whirl_integrate_default();
        whirl_integrator *integrator;
        strcpy(options.method, methods[m]);
        assert_int_equal(whirl_integrator_new(&forced, &options, &integrator).code, WHIRL_OK);
        double alone[2] = {0.3, 0}, first[2] = {0.3, 0}, second[2] = {-1, 2};
        for (int i = 0; i < 5; i++) whirl_integrator_revolve(integrator, alone, NULL, NULL);
        for (int i = 0; i < 5; i++) {
            whirl_integrator_revolve(integrator, first, NULL, NULL);
            whirl_integrator_revolve(integrator, second, NULL, NULL);
        }
        whirl_integrator_free(integrator);
        assert_memory_equal(alone, first, sizeof alone);
    }
}

static void test_bad_options_are_refused(void **state) {
    whirl_integrator *integrator;
    whirl_integrate_options options = whirl_integrate_default();
    (void)state;
    strcpy(options.method, "rk5");
    const whirl_status unknown = whirl_integrator_new(&forced, &options, &integrator);
    assert_int_equal(unknown.code, WHIRL_BAD_INPUT);
    assert_non_null(strstr(unknown.message, "did you mean 'rk4'"));
    options = whirl_integrate_default();
    options.steps_per_revolution = 0;
    assert_int_equal(whirl_integrator_new(&forced, &options, &integrator).code, WHIRL_BAD_INPUT);
    options = whirl_integrate_default();
    options.rtol = -1;
    assert_int_equal(whirl_integrator_new(&forced, &options, &integrator).code, WHIRL_BAD_INPUT);
    options = whirl_integrate_default();
    whirl_system broken = forced;
    broken.period = NAN;
    assert_int_equal(whirl_integrator_new(&broken, &options, &integrator).code, WHIRL_BAD_INPUT);
    assert_null(integrator);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rk4_has_order_four),
        cmocka_unit_test(test_cvode_keeps_its_tolerance),
        cmocka_unit_test(test_steps_need_not_be_a_power_of_two),
        cmocka_unit_test(test_cvode_locates_contacts),
        cmocka_unit_test(test_observers_see_equal_parts),
        cmocka_unit_test(test_divergence_is_a_result),
        cmocka_unit_test(test_calls_may_alternate),
        cmocka_unit_test(test_bad_options_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
