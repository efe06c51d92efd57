// Derivatives of chaotic motions by differences of records, against a scaling law.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine.h"

#include <math.h>
#include <stdio.h>

/// A rotor all of whose lengths are proportional to p: its motions are, too, also chaotic ones. Lengths of motions grow
/// by 1 % with 1 % more p, and the share of contact stays. The length scale does not follow p, so that the rounding of
/// neighbouring motions differs, and chaos makes them different motions of one attractor.
static const char scaled[] = "whirl: 1\n"
                             "parameters: {p: %s}\n"
                             "rotor:\n"
                             "  speed: 3.3 rad/s\n"
                             "  length_scale: 1 m\n"
                             "  stations:\n"
                             "    disc: {mass: 1 kg, damping: 0.2, eccentricity: = 0.9*p}\n"
                             "  elements:\n"
                             "    - shaft: {between: [disc, ground], k1: 1 N/m, k2: 1 N/m}\n"
                             "    - rub: {at: disc, gap: = p, stiffness: 10, friction: 0.05, law: paper}\n"
                             "    - gravity: = 0.5*p\n"
                             "study:\n"
                             "  response: {}\n"
                             "  initial: {disc: {x: 0.1, y: -0.2}}\n"
                             "  integrate: {method: dop853, transient: 200, record: 2000}\n"
                             "  analyze: [regime, spectrum, orbit, rub]\n"
                             "  sensitivity:\n"
                             "    parameters: [p]\n"
                             "    difference: 5 %%\n"
                             "    of:\n"
                             "      - {field: orbit/max_radius}\n"
                             "      - {field: orbit/mean, column: y}\n"
                             "      - {field: spectrum/synchronous, column: x}\n"
                             "      - {field: rub/share}\n"
                             "      - {field: spectrum/synchronous_lag, column: x}\n";

/// Runs the rotor at a value of p.
static whirl_result *result_at(double p) {
    char text[4096], value[40];
    snprintf(value, sizeof value, "%.17g", p);
    snprintf(text, sizeof text, scaled, value);
    return result_of_text(text);
}

/// Derivatives of chaotic motions are differences of records, and nearly all 95 % intervals contain the true value.
static void test_chaos_has_differences(void **state) {
    (void)state;
    enum { MOTIONS = 8, NUMBERS = 4 };
    static const char *const names[NUMBERS] = {"largest radius", "mean of y", "amplitude at the speed",
                                               "share of contact"};
    static const double expected[NUMBERS] = {1.0, 1.0, 1.0, 0.0}, tolerances[NUMBERS] = {0.25, 0.05, 0.1, 0.1};
    double sum[NUMBERS] = {0.0}, widest[NUMBERS] = {0.0};
    size_t within = 0, all = 0, chaotic = 0;
    for (size_t m = 0; m < MOTIONS; m++) {
        whirl_result *result = result_at(1.0 + 0.1 * (double)m);
        const whirl_table *table = whirl_result_table(result, "response");
        const double *numbers = whirl_table_field(table, 0, WHIRL_FIELD_SENSITIVITY_NUMBERS, 0);
        const double *slopes = whirl_table_field(table, 0, WHIRL_FIELD_SENSITIVITY_SLOPES, 0);
        const double p = whirl_table_field(table, 0, WHIRL_FIELD_SENSITIVITY_PARAMETERS, 0)[0];
        chaotic += whirl_table_verdict(table, 0).regime == WHIRL_CHAOTIC;
        for (size_t i = 0; i < NUMBERS; i++, all++) {
            const double unit = p / numbers[i], change = slopes[2 * i] * unit;
            const double error = fabs(slopes[2 * i + 1] * unit);
            within += fabs(change - expected[i]) <= error;
            sum[i] += change / MOTIONS;
            widest[i] = fmax(widest[i], error);
        }
        assert_true(isnan(slopes[(size_t)2 * NUMBERS])); // an angle has no such derivative
        whirl_result_free(result);
    }
    assert_int_equal(chaotic, MOTIONS);
    for (size_t i = 0; i < NUMBERS; i++) {
        check_within("Derived", words("eight chaotic motions: mean change of the %s", names[i]), expected[i], sum[i],
                     tolerances[i]);
        assert_true(widest[i] > 0.0 && widest[i] < 1.5);
    }
    check_within("Derived", words("%zu changes of chaotic motions: 95 %% intervals with the true value, %%", all), 95.0,
                 100.0 * (double)within / (double)all, 6.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_chaos_has_differences)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
