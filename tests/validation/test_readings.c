// The paper's ten points in all three readings of its equations: the verdict with what it rests on, by RK4 confirmed
// with twice the steps, and by dop853 with located contacts confirmed at a tighter tolerance. Nothing of the derived
// and the literal reading is known from elsewhere; what can be asked of them is that two methods never contradict each
// other where both are sure. WHIRL_SOAK: longer records.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"

enum { POINTS = 5, DISC = 0, JOURNAL = 1 };

/// The ten ratios by turns: every test has regular and chaotic motions.
static const double ratios[2][POINTS] = {{1.0, 0.48, 0.45, 0.4, 0.25}, {0.6, 0.46, 0.44, 0.35, 0.15}};

/// Makes the sweep long enough for its verdicts.
static void lengthen(whirl_batch *batch, const void *method) {
    assert_string_equal("r_k", batch->parameter);
    const bool is_long = getenv("WHIRL_SOAK") != NULL;
    batch->record.transient = is_long ? 3000 : 400;
    batch->record.record = is_long ? 2000 : 400;
    snprintf(batch->integrate.method, sizeof batch->integrate.method, "%s", (const char *)method);
}

static void put_verdict(const char *who, const whirl_verdict *verdict) {
    char name[64];
    whirl_verdict_name(verdict, name, sizeof name);
    printf("readings | %s | - | %s, %s | - | -\n", who, name, whirl_confidence_name(verdict->confidence));
}

static void put_numbers(const char *who, const whirl_table *table, size_t i, const whirl_verdict *verdict) {
    printf("readings | %s, by RK4: exponent per revolution | - | %.4f +- %.4f | - | -\n", who,
           table_number(table, i, "lyapunov/largest", 0), table_number(table, i, "lyapunov/error", 0));
    printf("readings | %s, by RK4: max r1, max e, share of rub | - | %.4f, %.4f, %.3f | - | -\n", who,
           table_number(table, i, "orbit/max_radius", DISC), table_number(table, i, "orbit/eccentricity", JOURNAL),
           table_number(table, i, "rub/share", 0));
    printf("readings | %s, by RK4: distance of returns, digits of averages | - | %.2g, %.3g | - | -\n", who,
           verdict->recurrence, verdict->regularity);
    if (!isnan(verdict->chaos))
        printf("readings | %s, by RK4: K of the 0-1 test | - | %.3f | - | -\n", who, verdict->chaos);
}

static bool is_sure(const whirl_verdict *verdict) {
    return verdict->confidence >= WHIRL_FAIR && verdict->regime != WHIRL_UNDETERMINED;
}

static void compare(const char *reading, const char *file, int turn) {
    whirl_result *fixed = run_case_at(file, 2, ratios[turn], POINTS, lengthen, "rk4");
    whirl_result *adaptive = run_case_at(file, 2, ratios[turn], POINTS, lengthen, "dop853");
    int sure = 0;
    for (size_t i = 0; i < POINTS; i++) {
        const whirl_verdict one = whirl_table_verdict(&fixed->tables[0], i);
        const whirl_verdict other = whirl_table_verdict(&adaptive->tables[0], i);
        const char *who = words("%s, r_k = %.2f", reading, ratios[turn][i]);
        put_verdict(words("%s, by RK4", who), &one);
        put_verdict(words("%s, by dop853", who), &other);
        if (one.regime != WHIRL_DIVERGING) put_numbers(who, &fixed->tables[0], i, &one);
        if (!is_sure(&one) || !is_sure(&other)) continue;
        sure++;
        check_holds("readings", words("%s: both methods find the same", who),
                    one.regime == other.regime && one.period == other.period);
    }
    assert_true(sure > POINTS / 2);
    whirl_result_free(fixed);
    whirl_result_free(adaptive);
}

static void calibrated_1(void **state) {
    (void)state;
    compare("calibrated", "paper", 0);
}
static void calibrated_2(void **state) {
    (void)state;
    compare("calibrated", "paper", 1);
}
static void derived_1(void **state) {
    (void)state;
    compare("derived", "paper-derived", 0);
}
static void derived_2(void **state) {
    (void)state;
    compare("derived", "paper-derived", 1);
}
static void literal_1(void **state) {
    (void)state;
    compare("literal", "paper-literal", 0);
}
static void literal_2(void **state) {
    (void)state;
    compare("literal", "paper-literal", 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(calibrated_1), cmocka_unit_test(calibrated_2),
                                       cmocka_unit_test(derived_1),    cmocka_unit_test(derived_2),
                                       cmocka_unit_test(literal_1),    cmocka_unit_test(literal_2)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
