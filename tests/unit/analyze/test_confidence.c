// Confidence: the effect of a second tolerance, and the effect of advice on the options of a run.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "birkhoff.h"
#include "confidence.h"
#include "evidence.h"
#include "recurrence.h"
#include "section.h"
#include "whirl/engine/analyze.h"

static whirl_verdict verdict_of(whirl_regime regime, int period, whirl_confidence agreement) {
    return (whirl_verdict){.regime = regime,
                           .period = period,
                           .agreement = agreement,
                           .confidence = agreement < WHIRL_FAIR ? agreement : WHIRL_FAIR,
                           .advice = {WHIRL_NO_REMEDY, 1.0}};
}

static whirl_verdict confirm(whirl_verdict verdict, whirl_verdict other) {
    whirl_verdict_confirm(&verdict, &other);
    assert_true(verdict.confirmed);
    assert_int_equal(verdict.other_regime, other.regime);
    assert_int_equal(verdict.other_period, other.period);
    return verdict;
}

static void two_tolerances(void **state) {
    (void)state;
    const whirl_verdict p2 = verdict_of(WHIRL_PERIODIC, 2, WHIRL_HIGH);
    assert_int_equal(confirm(p2, p2).confidence, WHIRL_HIGH);
    assert_int_equal(confirm(p2, verdict_of(WHIRL_PERIODIC, 2, WHIRL_FAIR)).confidence, WHIRL_FAIR);
    const whirl_verdict contradicted[] = {verdict_of(WHIRL_PERIODIC, 4, WHIRL_HIGH),
                                          verdict_of(WHIRL_CHAOTIC, 0, WHIRL_HIGH),
                                          verdict_of(WHIRL_DIVERGING, 0, WHIRL_HIGH)};
    for (size_t i = 0; i < 3; i++) {
        const whirl_verdict result = confirm(p2, contradicted[i]);
        assert_int_equal(result.regime, WHIRL_PERIODIC);
        assert_int_equal(result.confidence, WHIRL_LOW);
        assert_int_equal(result.advice.remedy, WHIRL_TIGHTER);
        assert_true(result.advice.factor > 1.0);
    }
    whirl_verdict open = verdict_of(WHIRL_UNDETERMINED, 0, WHIRL_LOW);
    open.advice = (whirl_advice){WHIRL_LONGER_TRANSIENT, 3.0};
    assert_int_equal(confirm(p2, open).confidence, WHIRL_LOW);
    assert_int_equal(confirm(p2, open).advice.remedy, WHIRL_LONGER_TRANSIENT);
    assert_int_equal(confirm(open, p2).regime, WHIRL_UNDETERMINED);
    assert_int_equal(confirm(open, p2).confidence, WHIRL_LOW);
    assert_int_equal(confirm(open, p2).advice.remedy, WHIRL_LONGER_TRANSIENT);
}

/// Copies of a chaotic motion: how they end decides the confidence, and the order of their ends does not.
static void followed(void **state) {
    (void)state;
    whirl_verdict chaos = verdict_of(WHIRL_CHAOTIC, 0, WHIRL_HIGH);
    chaos.confidence = WHIRL_HIGH;
    whirl_verdict later[] = {verdict_of(WHIRL_CHAOTIC, 0, WHIRL_HIGH), verdict_of(WHIRL_PERIODIC, 3, WHIRL_HIGH),
                             verdict_of(WHIRL_PERIODIC, 2, WHIRL_FAIR), verdict_of(WHIRL_UNDETERMINED, 0, WHIRL_LOW)};
    whirl_verdict one = chaos, other = chaos, resting = verdict_of(WHIRL_UNDETERMINED, 0, WHIRL_LOW);
    later[3].recurrence = NAN;
    whirl_verdict_follow(&one, &later[0], 3000.0, 1000.0);
    assert_int_equal(one.confidence, WHIRL_HIGH);
    assert_true(one.followed == 3000.0);
    whirl_verdict_follow(&one, &later[3], 1000.0, 1000.0);
    assert_int_equal(one.confidence, WHIRL_FAIR);
    for (int i = 0; i < 4; i++) {
        whirl_verdict_follow(&one, &later[i], 500.0, 1000.0);
        whirl_verdict_follow(&other, &later[3 - i], 500.0, 1000.0);
    }
    whirl_verdict_follow(&other, &later[0], 4000.0, 1000.0);
    assert_int_equal(one.confidence, WHIRL_LOW);
    assert_int_equal(one.later_regime, WHIRL_PERIODIC);
    assert_int_equal(one.later_period, 2);
    assert_memory_equal(&one.followed, &other.followed, sizeof one.followed);
    assert_int_equal(one.later_period, other.later_period);
    assert_int_equal(one.confidence, other.confidence);
    assert_true(one.advice.remedy == WHIRL_LONGER_TRANSIENT && one.advice.factor == 7.0);
    assert_true(other.advice.factor == one.advice.factor);
    resting.recurrence = 1e-9;
    resting.recurrence_period = 1;
    whirl_verdict_follow(&one, &resting, 500.0, 1000.0);
    assert_int_equal(one.later_period, 1);
    whirl_verdict periodic = verdict_of(WHIRL_PERIODIC, 2, WHIRL_HIGH);
    whirl_verdict_follow(&periodic, &later[0], 3000.0, 1000.0);
    assert_true(periodic.followed == 0.0 && periodic.confidence == WHIRL_FAIR);
}

static void tighter(void **state) {
    (void)state;
    whirl_integrate_options options = whirl_integrate_default();
    options.steps_per_revolution = 90;
    assert_int_equal(whirl_integrate_tighter(&options, 16.0).steps_per_revolution, 180);
    assert_int_equal(whirl_integrate_tighter(&options, 81.0).steps_per_revolution, 270);
    assert_int_equal(whirl_integrate_tighter(&options, 2.0).steps_per_revolution, 108); // 90 * 2^(1/4) = 107.03
    assert_true(whirl_integrate_tighter(&options, 16.0).rtol == options.rtol);
    strcpy(options.method, "cvode-adams");
    const whirl_integrate_options adaptive = whirl_integrate_tighter(&options, 16.0);
    assert_int_equal(adaptive.steps_per_revolution, 90);
    assert_true(adaptive.rtol == options.rtol / 16.0 && adaptive.atol == options.atol / 16.0);
    assert_true(whirl_integrate_tighter(&options, 1e9).rtol == 1e-14);
    options.rtol = 1e-15; // requested, so no longer refused
    assert_true(whirl_integrate_tighter(&options, 16.0).rtol == 1e-15);
}

static void advice_is_followed(void **state) {
    (void)state;
    const whirl_integrate_options given = whirl_integrate_default();
    whirl_record_options record = whirl_record_default(); // 1100 + 100, 650 watched
    whirl_integrate_options integrate = given;
    whirl_advice_apply((whirl_advice){WHIRL_NO_REMEDY, 1.0}, &integrate, &record);
    whirl_advice_apply((whirl_advice){WHIRL_OTHER_START, 1.0}, &integrate, &record); // no option gives more revolutions
    assert_memory_equal(&integrate, &given, sizeof given);
    assert_int_equal(record.transient, 1100);
    assert_int_equal(record.watch, 0);

    whirl_advice_apply((whirl_advice){WHIRL_LONGER_TRANSIENT, 2.5}, &integrate, &record);
    assert_int_equal(record.transient, 2900);
    assert_int_equal(record.record, 100);
    assert_int_equal(whirl_record_watch(&record), 650);

    record = whirl_record_default();
    whirl_advice_apply((whirl_advice){WHIRL_LONGER_WATCH, 4.0}, &integrate, &record);
    assert_int_equal(record.watch, 2600);
    assert_int_equal(record.transient - 1100, 2600 - 650); // what went before stays
    assert_int_equal(record.record, 100);

    record = whirl_record_default();
    assert_int_equal(integrate.steps_per_revolution, 1024);
    integrate.steps_per_revolution = 99; // 198 has a divisor of 66, 99 has none between 64 and 99
    const int samples = whirl_record_samples(&record, 99);
    whirl_advice_apply((whirl_advice){WHIRL_TIGHTER, 16.0}, &integrate, &record);
    assert_int_equal(integrate.steps_per_revolution, 198);
    assert_int_equal(whirl_record_samples(&record, 198), samples);

    record.transient = 2000000000;
    for (int i = 0; i < 3; i++) whirl_advice_apply((whirl_advice){WHIRL_LONGER_WATCH, 100.0}, &integrate, &record);
    assert_true(record.transient >= 2000000000 && record.watch <= record.transient + record.record);
}

static void advice_in_words(void **state) {
    (void)state;
    char text[128];
    whirl_verdict verdict = verdict_of(WHIRL_PERIODIC, 2, WHIRL_HIGH);
    whirl_verdict_advice(&verdict, text, sizeof text);
    assert_string_equal(text, "");
    verdict.advice = (whirl_advice){WHIRL_LONGER_TRANSIENT, 3.0};
    whirl_verdict_advice(&verdict, text, sizeof text);
    assert_string_equal(text, "let it run 3 times as long");
    verdict.advice = (whirl_advice){WHIRL_LONGER_WATCH, 4.0};
    whirl_verdict_advice(&verdict, text, sizeof text);
    assert_string_equal(text, "watch 4 times as many revolutions");
    verdict.advice = (whirl_advice){WHIRL_TIGHTER, 256.0};
    whirl_verdict_advice(&verdict, text, sizeof text);
    assert_string_equal(text, "integrate with errors of a step 256 times smaller");
    assert_string_equal(whirl_confidence_name(WHIRL_LOW), "low");
    assert_string_equal(whirl_confidence_name(WHIRL_FAIR), "fair");
    assert_string_equal(whirl_confidence_name(WHIRL_HIGH), "high");
}

// ---------------------------------------------------------------- every condition of HIGH, one at a time

static whirl_confidence weighed(whirl_verdict v, const evidence *e) {
    const whirl_record record = {.revolutions = 1000.0};
    v.round = 1.0;
    weigh_verdict(&v, e, &record);
    return v.agreement;
}

/// A motion on a stable orbit is P-k with high confidence, unless the orbit hardly attracts or its returns are hardly
/// apart.
static void on_an_orbit(void **state) {
    (void)state;
    const whirl_verdict sure = {.regime = WHIRL_PERIODIC,
                                .period = 1,
                                .orbit = WHIRL_ORBIT_STABLE,
                                .orbit_period = 1,
                                .recurrence = 1e-8,
                                .recurrence_period = 1,
                                .orbit_distance = 1e-8,
                                .orbit_modulus = 0.5};
    evidence e = {.size = 1.0, .rounding = 1e-14, .returns.separation = 1.0};
    whirl_verdict v = sure;
    assert_int_equal(weighed(v, &e), WHIRL_HIGH);
    v.orbit_modulus = 1.0 - 1e-7;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
    v = sure;
    v.orbit_distance = 1e-4;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
    e.returns.separation = 1e-7;
    assert_int_equal(weighed(sure, &e), WHIRL_FAIR);
}

/// Without an orbit, returns and exponent must be clear, and returns after other periods far.
static void by_returns(void **state) {
    (void)state;
    const whirl_verdict v = {.regime = WHIRL_PERIODIC,
                             .period = 1,
                             .recurrence = 1e-8,
                             .recurrence_period = 1,
                             .exponent = {.value = -0.1, .error = 1e-4}};
    evidence e = {.size = 1.0, .rounding = 1e-14, .returns.separation = 1.0};
    assert_int_equal(weighed(v, &e), WHIRL_HIGH);
    e.returns.separation = 1e-6;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
    // Returns that shrink by 0.99 a revolution, where the exponent says 0.905.
    double shrinking[40];
    e.returns.separation = 1.0;
    for (int n = 0; n < 40; n++) shrinking[n] = 1e-3 * pow(0.99, n);
    e.points = (struct section){40, 1, shrinking};
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
}

/// Chaos has high confidence if it is strong, steady, irregular and watched for long.
static void in_chaos(void **state) {
    (void)state;
    enum { COUNT = 1000 };
    double growth[COUNT];
    const whirl_verdict sure = {
        .regime = WHIRL_CHAOTIC, .chaos = 0.95, .regularity = 1.0, .exponent = {.value = 0.1, .error = 1e-3}};
    for (int i = 0; i < COUNT; i++) growth[i] = 0.1 + (i % 2 ? 0.1 : -0.1);
    evidence e = {.size = 1.0, .growth = growth, .growth_count = COUNT, .points.count = 600};
    whirl_verdict v = sure;
    assert_int_equal(weighed(v, &e), WHIRL_HIGH);
    v.regularity = 3.5;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
    v = sure;
    v.chaos = 0.7;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
    v = sure;
    v.exponent.value = 0.009;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
    e.points.count = 499;
    assert_int_equal(weighed(sure, &e), WHIRL_FAIR);
    e.points.count = 600;
    for (int i = COUNT / 2; i < COUNT; i++) growth[i] += 0.2;
    assert_int_equal(weighed(sure, &e), WHIRL_FAIR);
}

/// An equilibrium has high confidence if it attracts motions as near as this one, and perturbations are seen to decay.
static void at_rest(void **state) {
    (void)state;
    double growth[1000];
    whirl_verdict v = {
        .regime = WHIRL_PERIODIC, .period = 1, .rests = true, .rest_distance = 1e-6, .exponent = {.value = -0.05}};
    for (int i = 0; i < 1000; i++) growth[i] = -0.05 + (i % 2 ? 1e-4 : -1e-4);
    evidence e = {.size = 1.0, .growth = growth, .growth_count = 1000, .points.count = 600};
    assert_int_equal(weighed(v, &e), WHIRL_HIGH);
    v.rest_distance = 1e-3;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
    v.rest_distance = 1e-6;
    e.growth_count = 0;
    assert_int_equal(weighed(v, &e), WHIRL_FAIR);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_tolerances),     cmocka_unit_test(followed),        cmocka_unit_test(tighter),
        cmocka_unit_test(advice_is_followed), cmocka_unit_test(advice_in_words), cmocka_unit_test(on_an_orbit),
        cmocka_unit_test(by_returns),         cmocka_unit_test(in_chaos),        cmocka_unit_test(at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
