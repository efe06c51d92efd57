// Custom systems, compared with closed forms: alone and in lanes, by functions for one machine and for many.
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

enum { SPEEDS = 9 };

static const double two_pi = 6.283185307179586476925;

/// x'' + 2 zeta x' + x = F cos(omega t), parameters omega and F.
static int oscillator(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = p[1] * cos(p[0] * t) - 2.0 * zeta * x[1] - x[0];
    return 0;
}

static int oscillators(size_t count, size_t row, const double *t, const double *x, const double *p, double *dxdt,
                       void *context) {
    (void)context;
    for (size_t i = 0; i < count; i++) {
        dxdt[i] = x[row + i];
        dxdt[row + i] = p[row + i] * cos(p[i] * t[i]) - 2.0 * zeta * x[row + i] - x[i];
    }
    return 0;
}

/// Makes a sweep of the speed, at tolerances so tight that closed forms agree to many digits.
static whirl_user_system *make(void) {
    whirl_user_system *system;
    double speeds[SPEEDS];
    for (int i = 0; i < SPEEDS; i++) speeds[i] = 0.4 + 0.19 * i;
    good(whirl_user_system_new("Linear oscillator", 2, &system));
    good(whirl_user_system_parameter(system, "omega", 1.3, "rad/s", "1.3 rad/s"));
    good(whirl_user_system_parameter(system, "F", 0.7, "1", "0.7"));
    good(whirl_user_system_speed(system, "omega"));
    good(whirl_user_system_start(system, 0, 0.3));
    good(whirl_user_system_vary(system, "omega", speeds, SPEEDS));
    good(whirl_user_system_rates(system, oscillator, NULL));
    good(whirl_user_system_set(system, "method", "dop853"));
    good(whirl_user_system_set(system, "rtol", "1e-11"));
    good(whirl_user_system_set(system, "atol", "1e-13"));
    good(whirl_user_system_set(system, "transient", "200"));
    good(whirl_user_system_set(system, "record", "50"));
    good(whirl_user_system_set(system, "settle", "no"));
    return system;
}

/// A perturbation turns as it decays, and its length swings: by 1 +- zeta where velocities are the user's own, by the
/// ratio of the periods, up to 4.7, where they are those by the common time. Over 100 revolutions and more that leaves
/// in an exponent at most 2 zeta/100, or ln(4.7)/100.
static const double swing = 8e-4, swing_in_lanes = 0.0155;

/// Computes the largest distance of amplitudes and of exponents from their closed forms.
static void compare(const whirl_result *result, double most_of_exponent) {
    const whirl_table *table = whirl_result_table(result, "sweep");
    assert_int_equal(SPEEDS, table->count);
    for (size_t i = 0; i < table->count; i++) {
        const double omega = table->values[i], spring = 1.0 - omega * omega, damping = 2.0 * zeta * omega;
        const double amplitude = 0.7 / hypot(spring, damping), own = two_pi / omega;
        const double high = whirl_table_field(table, i, "orbit/high", 0)[0];
        const double exponent = whirl_table_number(table, i, "lyapunov/largest", 0);
        const whirl_verdict verdict = whirl_table_verdict(table, i);
        assert_true(verdict.regime == WHIRL_PERIODIC && verdict.period == 1);
        // Bounds are looked at 1024 times per revolution: a cosine is less than its amplitude by at most 5e-6 of it.
        assert_true(fabs(high - amplitude) < 6e-6 * amplitude);
        assert_true(fabs(exponent + zeta * own) < most_of_exponent);
        // The section is where the closed form has it: x = Re(A e^{i omega t}) at t = T.
        const double x = amplitude * cos(atan2(damping, spring));
        assert_true(fabs(whirl_table_field(table, i, "poincare/section", 0)[0] - x) < 1e-8);
    }
}

static void one_machine_is_its_closed_form(void **state) {
    (void)state;
    whirl_user_system *system = make();
    good(whirl_user_system_station(system, "phase", 0, 1, 1, 1));
    whirl_result *result = run(system, 2);
    compare(result, swing);
    const whirl_table *table = whirl_result_table(result, "sweep");
    // Velocities of a phase plane are the user's own.
    for (size_t i = 0; i < table->count; i++) {
        const double omega = table->values[i], angle = atan2(2.0 * zeta * omega, 1.0 - omega * omega);
        const double v = 0.7 * omega / hypot(1.0 - omega * omega, 2.0 * zeta * omega) * sin(angle);
        assert_true(fabs(whirl_table_field(table, i, "poincare/section", 0)[1] - v) < 1e-8);
    }
    assert_true(fabs(whirl_result_speed(result) - 1.3) < 1e-15);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

/// Returns true if all blocks have the same bits.
static bool same(const whirl_result *one, const whirl_result *other) {
    const whirl_table *a = &one->tables[0], *b = &other->tables[0];
    return a->count == b->count && a->layout.size == b->layout.size &&
           memcmp(a->blocks, b->blocks, a->count * a->layout.size * sizeof *a->blocks) == 0;
}

static void lanes_are_their_closed_form(void **state) {
    static const char *const methods[] = {"dop853", "rk4", "rodas5p"};
    (void)state;
    for (size_t m = 0; m < 3; m++) {
        whirl_user_system *system = make();
        good(whirl_user_system_oscillates(system, 1));
        good(whirl_user_system_set(system, "method", methods[m]));
        good(whirl_user_system_set(system, "rtol", m == 2 ? "1e-9" : "1e-11"));
        whirl_result *each = run(system, 2);
        compare(each, swing_in_lanes);
        good(whirl_user_system_lanes(system, oscillators, NULL));
        whirl_result *many = run(system, 2), *alone = run(system, 1);
        assert_true(same(each, many) && same(many, alone));
        whirl_result_free(alone);
        whirl_result_free(many);
        whirl_result_free(each);
        whirl_user_system_free(system);
    }
}

/// All exponents by differences and by the derivative: each is -zeta a unit of time, and their sum is known to many
/// digits.
static void differences_are_derivatives(void **state) {
    (void)state;
    for (int lanes = 0; lanes < 2; lanes++)
        for (int given = 0; given < 2; given++) {
            whirl_user_system *system = make();
            good(whirl_user_system_oscillates(system, (size_t)lanes));
            if (given) good(whirl_user_system_tangent(system, derivative, NULL));
            good(whirl_user_system_analyze(system, "exponents"));
            if (lanes) good(whirl_user_system_set(system, "method", "rk4"));
            whirl_result *result = run(system, 2);
            const whirl_table *table = whirl_result_table(result, "sweep");
            for (size_t i = 0; i < table->count; i++) {
                const double *found = whirl_table_field(table, i, "exponents/values", 0);
                const double each = -zeta * two_pi / table->values[i];
                assert_non_null(found);
                for (int k = 0; k < 2; k++) assert_true(fabs(found[k] - each) < (lanes ? swing_in_lanes : swing));
                assert_true(fabs(found[0] + found[1] - 2.0 * each) < 1e-8);
            }
            whirl_result_free(result);
            whirl_user_system_free(system);
        }
}

/// A row of a map is the sweep.
static void maps_have_rows(void **state) {
    const double forces[] = {0.2, 0.7};
    (void)state;
    whirl_user_system *system = make();
    good(whirl_user_system_oscillates(system, 1));
    whirl_result *sweep = run(system, 2);
    good(whirl_user_system_vary(system, "F", forces, 2));
    whirl_result *map = run(system, 2);
    const whirl_table *rows = whirl_result_table(map, "map"), *row = &sweep->tables[0];
    assert_int_equal(2 * SPEEDS, rows->count);
    assert_int_equal(SPEEDS, whirl_table_row(rows));
    for (size_t i = 0; i < SPEEDS; i++) {
        assert_true(rows->values[SPEEDS + i] == row->values[i]);
        assert_true(whirl_table_second(rows, SPEEDS + i) == 0.7);
        assert_memory_equal(whirl_table_field(rows, SPEEDS + i, "poincare/section", 0),
                            whirl_table_field(row, i, "poincare/section", 0), 100 * sizeof(double));
    }
    whirl_result_free(map);
    whirl_result_free(sweep);
    whirl_user_system_free(system);
}

/// Other facts of a result, and the points of the journal that it continued.
static void results_are_described(void **state) {
    (void)state;
    whirl_user_system *system = make();
    whirl_result *result = run(system, 2), *outline;
    assert_string_equal("Linear oscillator", whirl_result_title(result));
    assert_string_equal("1.3 rad/s", whirl_result_text(result, WHIRL_LIST_PARAMETERS, 0, "text"));
    assert_string_equal("state", whirl_result_name(result, WHIRL_LIST_STATIONS, 0));
    refused(whirl_user_system_outline(system, &outline), "no identity, by which a journal would know its functions");
    refused(whirl_user_system_identity(system, ""), "the identity of a system is empty");
    good(whirl_user_system_identity(system, "oscillator 1"));
    good(whirl_user_system_outline(system, &outline));
    assert_string_equal("oscillator 1", whirl_result_fact(outline, "equations"));
    assert_string_equal("0.3, 0", whirl_result_fact(outline, "equations: start"));
    assert_true(outline->tables[0].count == SPEEDS && !outline->tables[0].blocks);
    assert_string_equal("Linear oscillator", whirl_result_title(outline));
    whirl_result_free(outline);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

// ---------------------------------------------------------------- what goes wrong

static int fails_later(double t, const double *x, const double *p, double *dxdt, void *context) {
    oscillator(t, x, p, dxdt, context);
    return p[0] > 1.0 && t > 2.0 ? 7 : 0;
}

static int explodes(double t, const double *x, const double *p, double *dxdt, void *context) {
    oscillator(t, x, p, dxdt, context);
    if (p[0] > 1.0) dxdt[1] = NAN;
    return 0;
}

static void a_function_that_fails_ends_the_run(void **state) {
    (void)state;
    for (size_t lanes = 0; lanes < 2; lanes++) {
        whirl_user_system *system = make();
        whirl_job *job;
        whirl_result *result;
        good(whirl_user_system_oscillates(system, lanes));
        good(whirl_user_system_rates(system, fails_later, NULL));
        good(whirl_job_of_user_system(system, &job));
        const whirl_status status = whirl_job_run(job, &result);
        assert_int_equal(WHIRL_NUMERICAL_FAILURE, status.code);
        assert_non_null(strstr(status.message, "a function of the system gave 7 at t = "));
        assert_null(result);
        // The same system runs once its function is another.
        good(whirl_user_system_rates(system, oscillator, NULL));
        good(whirl_job_run(job, &result));
        whirl_result_free(result);
        whirl_job_free(job);
        whirl_user_system_free(system);
    }
}

/// A mass that is stopped at x = 0 by a spring and a damper p[1].
static int stopped(double t, const double *x, const double *p, double *dxdt, void *context) {
    oscillator(t, x, p, dxdt, context);
    if (x[0] > 0.0) dxdt[1] -= 100.0 * x[0] + p[1] * x[1];
    return 0;
}

/// No derivative describes the effect of a jump on a perturbation. Jumps are refused with their place if a perturbation
/// is followed, alone and in lanes, and are allowed otherwise. Kinks without jumps are followed.
static void slopes_that_jump_are_refused_where_a_derivative_is_followed(void **state) {
    static const double dampers[] = {0.0, 20.0};
    (void)state;
    for (int form = 0; form < 12; form++) {
        const bool jumps = form & 1, kinked = form & 2, exponents = form / 4 == 1, lanes = form / 4 == 2;
        whirl_user_system *system;
        whirl_job *job;
        whirl_result *result;
        good(whirl_user_system_new("Stop", 2, &system));
        good(whirl_user_system_parameter(system, "omega", 1.3, "rad/s", "1.3 rad/s"));
        good(whirl_user_system_parameter(system, "damper", dampers[jumps], "1", "damper"));
        good(whirl_user_system_speed(system, "omega"));
        good(whirl_user_system_start(system, 1, 1.0));
        good(whirl_user_system_rates(system, stopped, NULL));
        good(whirl_user_system_oscillates(system, lanes));
        if (kinked) good(whirl_user_system_kinked(system));
        if (exponents || lanes) good(whirl_user_system_analyze(system, "exponents"));
        good(whirl_user_system_set(system, "method", "dop853"));
        good(whirl_user_system_set(system, "transient", "2"));
        good(whirl_user_system_set(system, "record", "8"));
        good(whirl_job_of_user_system(system, &job));
        const whirl_status status = whirl_job_run(job, &result);
        if (jumps && (kinked || exponents || lanes)) {
            assert_int_equal(WHIRL_NUMERICAL_FAILURE, status.code);
            if (!strstr(status.message, "slope 1 of the system jumps by")) fail_msg("%s", status.message);
            assert_null(result);
        } else {
            good(status);
        }
        whirl_result_free(result);
        whirl_job_free(job);
        whirl_user_system_free(system);
    }
}

static void slopes_that_are_no_numbers_are_divergence(void **state) {
    (void)state;
    for (size_t lanes = 0; lanes < 2; lanes++) {
        whirl_user_system *system = make();
        good(whirl_user_system_oscillates(system, lanes));
        good(whirl_user_system_rates(system, explodes, NULL));
        whirl_result *result = run(system, 2);
        const whirl_table *table = whirl_result_table(result, "sweep");
        for (size_t i = 0; i < table->count; i++)
            assert_int_equal(table->values[i] > 1.0 ? WHIRL_DIVERGING : WHIRL_PERIODIC,
                             whirl_table_verdict(table, i).regime);
        whirl_result_free(result);
        whirl_user_system_free(system);
    }
}

/// The equations with the arguments of GSL: slopes before parameters.
static int as_gsl_has_it(double t, const double *x, double *slopes, void *parameters) {
    return oscillator(t, x, parameters, slopes, NULL);
}

static int silent(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)t, (void)x, (void)p, (void)context;
    dxdt[0] = 1.0;
    return 0;
}

static int wrong_perturbation(double t, const double *x, const double *p, const double *dx, double *ddxdt,
                              void *context) {
    ((double *)(uintptr_t)dx)[1] = 2.0;
    return oscillator(t, x, p, ddxdt, context);
}

/// Functions of another form, which reach the library as addresses, are found by what they do to their arguments.
static void functions_of_another_form_are_refused(void **state) {
    whirl_job *job;
    whirl_result *result;
    (void)state;
    whirl_user_system *system = make();
    good(whirl_job_of_user_system(system, &job));
    good(whirl_user_system_rates(system, (whirl_user_rates_fn)(void (*)(void))as_gsl_has_it, NULL));
    refused(whirl_job_run(job, &result),
            "the slopes change the parameters that they are given, expected the arguments");
    good(whirl_user_system_rates(system, silent, NULL));
    refused(whirl_job_run(job, &result), "the slopes leave number 1 of 2 unwritten");
    good(whirl_user_system_rates(system, oscillator, NULL));
    good(whirl_user_system_tangent(system, wrong_perturbation, NULL));
    refused(whirl_job_run(job, &result), "the numbers of the tangent change the perturbation that they are given");
    whirl_job_free(job);
    whirl_user_system_free(system);
}

static void wrong_arguments_are_refused(void **state) {
    whirl_user_system *system;
    whirl_job *job;
    whirl_result *result;
    (void)state;
    refused(whirl_user_system_new("", 0, &system), "a system of 0 coordinates, expected 1 to 4096");
    system = make();
    refused(whirl_user_system_parameter(system, "omega", 1.0, "1", ""), "two parameters called omega");
    refused(whirl_user_system_parameter(system, "2x", 1.0, "1", ""), "'2x', expected letters, digits and _");
    refused(whirl_user_system_parameter(system, "y", NAN, "1", ""), "y is nan, expected a finite number");
    refused(whirl_user_system_parameter(system, "y", 1.0, "furlogn", ""), "unit of y is 'furlogn', expected one that");
    refused(whirl_user_system_parameter(system, "y", 1.0, "rad/", ""), "unit of y is 'rad/', expected one that");
    refused(whirl_user_system_parameter(system, "y", 1.0, "rpm", ""), "y is rpm, 1 of which is 0.1047197551 in SI");
    refused(whirl_user_system_parameter(system, "y", 1.0, "degC", ""), "y is degC, 1 of which is 274.15 in SI");
    good(whirl_user_system_parameter(system, "k", 1.0, "N s/m", ""));
    good(whirl_user_system_parameter(system, "T", 1.0, "K", ""));
    refused(whirl_user_system_speed(system, "omgea"), "no parameter omgea, did you mean omega?");
    refused(whirl_user_system_start(system, 2, 1.0), "no coordinate 2, expected 0 to 1");
    refused(whirl_user_system_station(system, "s", 0, 1, 2, 1), "no coordinate 2, expected 0 to 1");
    refused(whirl_user_system_oscillates(system, 2), "2 displacements with as many velocities, expected at most 2");
    refused(whirl_user_system_period(system, 0.0), "the period is 0, expected a number above 0");
    refused(whirl_user_system_vary(system, "omega", (const double[]){1.0}, 1), "omega varies already");
    refused(whirl_user_system_vary(system, "F", (const double[]){1.0, 3.0, 2.0}, 3), "F is 2 after 3");
    refused(whirl_user_system_vary(system, "F", NULL, 0), "F varies over no values");
    refused(whirl_user_system_analyze(system, "poincar"), "no analysis poincar, did you mean poincare?");
    refused(whirl_user_system_analyze(system, "modes"), "modes is not for custom systems");
    refused(whirl_user_system_set(system, "rtoll", "1"), "no option rtoll, did you mean rtol?");
    refused(whirl_user_system_set(system, "rtol", "fine"), "rtol is 'fine', expected a number");
    refused(whirl_user_system_set(system, "rtol", "0"), "rtol is 0, expected a number above 0");
    refused(whirl_user_system_set(system, "carry", "left"), "carry is 'left', expected one of no, up, down, both");
    good(whirl_user_system_set(system, "method", "dop85"));
    good(whirl_job_of_user_system(system, &job));
    refused(whirl_job_run(job, &result), "dop853");
    good(whirl_user_system_set(system, "method", "dop853"));
    good(whirl_user_system_oscillates(system, 1));
    good(whirl_user_system_station(system, "phase", 0, 1, 1, 1));
    refused(whirl_job_run(job, &result), "expected displacements, 0 to 0, with their velocities");
    whirl_job_free(job);
    whirl_user_system_free(system);
    good(whirl_user_system_new("empty", 1, &system));
    good(whirl_job_of_user_system(system, &job));
    refused(whirl_job_run(job, &result), "no function for its slopes");
    whirl_job_free(job);
    whirl_user_system_free(system);
    whirl_user_system_free(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_machine_is_its_closed_form),
        cmocka_unit_test(lanes_are_their_closed_form),
        cmocka_unit_test(differences_are_derivatives),
        cmocka_unit_test(maps_have_rows),
        cmocka_unit_test(results_are_described),
        cmocka_unit_test(a_function_that_fails_ends_the_run),
        cmocka_unit_test(slopes_that_jump_are_refused_where_a_derivative_is_followed),
        cmocka_unit_test(slopes_that_are_no_numbers_are_divergence),
        cmocka_unit_test(functions_of_another_form_are_refused),
        cmocka_unit_test(wrong_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
