// Scales of coordinates: results about a motion do not depend on the units of its equations.
//
// A Duffing oscillator x'' + x'/4 - x + x^3 = 0.2 cos t with the unit U, and a temperature that rests at T. Its P-1
// has the divergence -1/4, so that the largest exponent, of a pair, is -pi/4 per revolution. A driven van der Pol
// oscillator u'' = 0.05 (1 - u^2) u' - u + 0.3 cos t is locked on P-1 in any unit.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "near.h"
#include "whirl/engine.h"

static const double pi = 3.14159265358979323846;

/// A Duffing oscillator whose displacement has the unit U = p[0], and a coordinate that approaches T = p[1].
static int duffing(double t, const double *x, const double *p, double *dxdt, void *context) {
    const double u = x[0] / p[0], v = x[1] / p[0];
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = p[0] * (0.2 * cos(t) - 0.25 * v + u - u * u * u);
    dxdt[2] = 0.3 * (p[1] - x[2]);
    return 0;
}

static int van_der_pol(double t, const double *x, const double *p, double *dxdt, void *context) {
    const double u = x[0] / p[0], v = x[1] / p[0];
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = p[0] * (0.05 * (1.0 - u * u) * v - u + 0.3 * cos(t));
    return 0;
}

/// u' = u/2 diverges, in every unit.
static int lost(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context, (void)t, (void)p;
    dxdt[0] = 0.5 * x[0];
    return 0;
}

/// u'' - 0.05 u' + u = 0.1 cos t from rest: its amplitude is 2 (exp(t/40) - 1), in whatever unit.
static int growing(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = 0.1 * p[0] * cos(t) + 0.05 * x[1] - x[0];
    return 0;
}

static whirl_user_system *make(size_t dimension, whirl_user_rates_fn rates, double unit, double level) {
    whirl_user_system *system;
    good(whirl_user_system_new("units", dimension, &system));
    good(whirl_user_system_parameter(system, "U", unit, "1", ""));
    good(whirl_user_system_parameter(system, "T", level, "1", ""));
    good(whirl_user_system_rates(system, rates, NULL));
    good(whirl_user_system_set(system, "transient", "200"));
    good(whirl_user_system_set(system, "confirm", "yes"));
    good(whirl_user_system_analyze(system, "poincare"));
    good(whirl_user_system_analyze(system, "regime"));
    good(whirl_user_system_analyze(system, "orbit"));
    return system;
}

static void exponents_in_any_unit(void **state) {
    static const double units[][2] = {{1.0, 1.0}, {1e-6, 300.0}, {1e-9, 1e5}, {1e7, 1e-4}};
    static const char *const methods[] = {"dop853", "rodas5p"};
    double largest[2][2] = {{0}};
    (void)state;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        for (size_t m = 0; m < 2; m++) {
            whirl_user_system *system = make(3, duffing, units[i][0], units[i][1]);
            good(whirl_user_system_start(system, 1, units[i][0]));
            good(whirl_user_system_start(system, 2, units[i][1]));
            good(whirl_user_system_set(system, "method", methods[m]));
            if (i == 2) good(whirl_user_system_oscillates(system, 1));
            whirl_result *result = run(system, 1);
            const whirl_table *table = whirl_result_table(result, "response");
            const whirl_verdict v = whirl_table_verdict(table, 0);
            assert_int_equal(v.regime, WHIRL_PERIODIC);
            assert_int_equal(v.period, 1);
            assert_int_equal(v.confidence, WHIRL_HIGH);
            near(v.exponent.value, -0.25 * pi, 2e-4);
            // Numbers stay in the user's units.
            const double radius = whirl_table_number(table, 0, WHIRL_FIELD_ORBIT_MAX_RADIUS, 0) / units[i][0];
            const double section = whirl_table_field(table, 0, WHIRL_FIELD_POINCARE_SECTION, 0)[0] / units[i][0];
            if (i == 0) largest[m][0] = radius, largest[m][1] = section;
            near(radius, largest[m][0], 1e-3); // instants of adaptive steps are others
            near(section, largest[m][1], 1e-6);
            const bool far_apart = i > 0;
            assert_int_equal(*whirl_result_warning(result, 0) != '\0', far_apart);
            whirl_result_free(result);
            whirl_user_system_free(system);
        }
}

static void no_bound_of_pascals(void **state) {
    static const double units[] = {1.0, 3e5, 1e9, 1e-7};
    (void)state;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        for (int given = 0; given < 2; given++) {
            whirl_user_system *system = make(2, van_der_pol, units[i], 0.0);
            good(whirl_user_system_start(system, 1, 1e-3 * units[i]));
            if (given) good(whirl_user_system_scale(system, 0, units[i]));
            if (given) good(whirl_user_system_scale(system, 1, units[i]));
            whirl_result *result = run(system, 1);
            const whirl_verdict v = whirl_table_verdict(whirl_result_table(result, "response"), 0);
            assert_int_equal(v.regime, WHIRL_PERIODIC);
            assert_int_equal(v.period, 1);
            assert_int_equal(v.confidence, WHIRL_HIGH);
            near(v.exponent.value, -0.2831, 2e-4); // as in units of its own
            whirl_result_free(result);
            whirl_user_system_free(system);
        }
}

static void limit_is_named(void **state) {
    static const double units[] = {1.0, 1e5, 1e-5};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        whirl_user_system *system = make(1, lost, 1.0, 0.0);
        char reason[512];
        good(whirl_user_system_start(system, 0, units[i]));
        good(whirl_user_system_scale(system, 0, units[i]));
        whirl_result *result = run(system, 1);
        const whirl_verdict v = whirl_table_verdict(whirl_result_table(result, "response"), 0);
        assert_int_equal(v.regime, WHIRL_DIVERGING);
        near(v.diverged_at, ceil(log(1e6) / pi), 0.0); // exp(t/2) passes 1e6 scales
        near(v.limit, 1e6, 0.0);
        whirl_verdict_reason(&v, reason, sizeof reason);
        assert_non_null(strstr(reason, "coordinate 0 passed the limit of 1e+06 times its scale"));
        whirl_result_free(result);
        whirl_user_system_free(system);
    }
}

/// A motion that grows from rest has no size at its start: it is lost where its amplitude passes a million times the
/// size of its first revolutions, to a factor of ten, and not at once where that size is above a million.
static void growth_in_any_unit(void **state) {
    static const double units[] = {1.0, 1e7, 1e12};
    const double revolution = 2.0 * pi / 40.0, least = log(1e6 / 20.0) / revolution, most = log(1e7 / 2.0) / revolution;
    (void)state;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        whirl_user_system *system = make(2, growing, units[i], 0.0);
        whirl_result *result = run(system, 1);
        const whirl_verdict v = whirl_table_verdict(whirl_result_table(result, "response"), 0);
        assert_int_equal(v.regime, WHIRL_DIVERGING);
        assert_true(v.diverged_at > least && v.diverged_at < most + 1.0);
        whirl_result_free(result);
        whirl_user_system_free(system);
    }
}

static void scales_that_do_not_fit(void **state) {
    whirl_user_system *system = make(2, van_der_pol, 1.0, 0.0);
    whirl_result *result;
    (void)state;
    refused(whirl_user_system_scale(system, 2, 1.0), "there is no coordinate 2, expected 0 to 1");
    refused(whirl_user_system_scale(system, 0, 0.0), "the scale of coordinate 0 is 0, expected a number above 0");
    refused(whirl_user_system_scale(system, 0, NAN), "expected a number above 0");
    good(whirl_user_system_oscillates(system, 1));
    good(whirl_user_system_scale(system, 0, 2.0));
    good(whirl_user_system_scale(system, 1, 3.0));
    refused(attempt(system, 1, &result), "displacement 0 has a scale of 2 and its velocity one of 3");
    whirl_user_system_free(system);
    system = make(2, van_der_pol, 1.0, 0.0);
    good(whirl_user_system_angle(system, 0, 1.0));
    good(whirl_user_system_scale(system, 0, 2.0));
    refused(attempt(system, 1, &result), "coordinate 0 is an angle with a scale");
    whirl_user_system_free(system);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponents_in_any_unit),  cmocka_unit_test(no_bound_of_pascals),
        cmocka_unit_test(limit_is_named),         cmocka_unit_test(growth_in_any_unit),
        cmocka_unit_test(scales_that_do_not_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
