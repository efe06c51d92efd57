// Verification on an equation that is smooth, so that RK4 shows its order, and known exactly (follower.h).
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "follower.h"
#include "whirl/internal/verify.h"

enum { SLOW, STIFF, POINTS };
static const double rates[POINTS] = {8, 100};

static whirl_study study(const char *method, int steps) {
    whirl_study s = {.batch_count = 1, .machine = make_follower};
    whirl_batch *batch = &s.batches[0];
    *batch = (whirl_batch){.name = "sweep", .parameter = "r", .count = POINTS, .values = rates};
    batch->integrate = whirl_integrate_default();
    memcpy(batch->integrate.method, method, strlen(method) + 1);
    batch->integrate.steps_per_revolution = steps;
    batch->record = whirl_record_default();
    batch->record.transient = 40;
    batch->record.record = 20;
    return s;
}

static whirl_verification *verify(const whirl_study *s, int revolutions, int threads) {
    const whirl_verify_options options = {.revolutions = revolutions};
    whirl_verification *v;
    const whirl_status status = whirl_study_verify(s, &options, &(whirl_run_options){.threads = threads}, &v);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    return v;
}

/// Returns x(1) from 0.5 by the closed form.
static double exact(double r) {
    const double w = 6.283185307179586, periodic = r * r / (r * r + w * w);
    return periodic + (0.5 - periodic) * exp(-r);
}

static void test_the_order_of_a_step(void **state) {
    const whirl_study s = study("rk4", 64);
    (void)state;
    whirl_verification *v = verify(&s, 1, 2);
    const whirl_verify_point *slow = &v->points[SLOW];
    assert_true(fabs(slow->order[0] - 4) < 0.02);
    assert_int_equal(v->integrate[0][2].steps_per_revolution, 256);
    assert_true(v->integrate[1][0].rtol == 1e-9 && fabs(v->integrate[1][2].rtol - 1e-11) < 1e-24);
    // The error is the difference from a reference with a tolerance of 1e-11.
    double x[1] = {0.5};
    whirl_machine one;
    assert_int_equal(make_follower(NULL, NULL, rates[SLOW], &one).code, WHIRL_OK);
    whirl_integrator *integrator;
    assert_int_equal(whirl_integrator_new(one.system, &v->integrate[0][0], &integrator).code, WHIRL_OK);
    whirl_integrator_revolve(integrator, x, NULL, NULL);
    assert_true(fabs(slow->runs[0][0].difference - fabs(x[0] - exact(rates[SLOW]))) < 1e-9);
    assert_true(slow->runs[0][0].difference > 1e-7);
    assert_true(slow->runs[1][2].difference == 0);
    whirl_integrator_free(integrator);
    one.release(one.owner);
    whirl_verification_free(v);
}

static void test_verdicts_that_depend_on_the_step(void **state) {
    const whirl_study s = study("rk4", 32); // r h is 3.1 with 32 steps, 1.6 with 64
    (void)state;
    whirl_verification *v = verify(&s, 20, 2);
    assert_int_equal(v->count, POINTS);
    assert_string_equal(v->parameter, "r");
    const whirl_verify_point *slow = &v->points[SLOW], *stiff = &v->points[STIFF];
    assert_true(slow->value == 8 && slow->agreed && stiff->value == 100 && !stiff->agreed);
    assert_int_equal(stiff->runs[0][0].verdict.regime, WHIRL_UNDETERMINED);
    assert_true(isnan(stiff->runs[0][0].difference) && isnan(stiff->order[0]) && isnan(stiff->exponent_spread));
    for (int m = 0; m < WHIRL_VERIFY_METHODS; m++)
        for (int level = 0; level < WHIRL_VERIFY_LEVELS; level++) {
            assert_int_equal(slow->runs[m][level].verdict.regime, WHIRL_PERIODIC);
            assert_true(slow->runs[m][level].section < 1e-3);
            // The exponent is -r.
            assert_true(fabs(slow->runs[m][level].verdict.exponent.value + 8) < 1e-2);
            if (m == 0 && level == 0) continue;
            assert_int_equal(stiff->runs[m][level].verdict.regime, WHIRL_PERIODIC);
            assert_true(stiff->runs[m][level].section < 0.05);
        }
    assert_true(slow->exponent_spread > 0 && slow->exponent_spread < 1e-2);
    whirl_verification_free(v);
}

static void test_threads_change_no_bit(void **state) {
    const whirl_study s = study("rk4", 16);
    (void)state;
    whirl_verification *one = verify(&s, 3, 1), *five = verify(&s, 3, 5);
    for (size_t i = 0; i < POINTS; i++) {
        const whirl_verify_point *a = &one->points[i], *b = &five->points[i];
        for (int m = 0; m < WHIRL_VERIFY_METHODS; m++) {
            assert_memory_equal(&a->order[m], &b->order[m], sizeof a->order[m]);
            for (int level = 0; level < WHIRL_VERIFY_LEVELS; level++)
                assert_memory_equal(&a->runs[m][level].difference, &b->runs[m][level].difference, sizeof(double));
        }
    }
    whirl_verification_free(one);
    whirl_verification_free(five);
}

static void expect_refusal(const whirl_study *s, const whirl_verify_options *options, const char *sentence) {
    whirl_verification *v;
    const whirl_status status = whirl_study_verify(s, options, &(whirl_run_options){.threads = 1}, &v);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, sentence);
    assert_null(v);
}

static void test_impossible_options_are_refused(void **state) {
    whirl_study s = study("rk4", 16);
    (void)state;
    expect_refusal(&s, &(whirl_verify_options){.revolutions = 0},
                   "states are to be compared after 0 revolutions, expected 1 or more");
    expect_refusal(&s, &(whirl_verify_options){.revolutions = 1, .method = "rk4"},
                   "rk4 can not verify rk4, expected another method with a tolerance");
    expect_refusal(&s, &(whirl_verify_options){.revolutions = 1, .method = "dop583"},
                   "no method is called 'dop583', did you mean 'dop853'?");
    s.batch_count = 2;
    expect_refusal(&s, &(whirl_verify_options){.revolutions = 1}, "the study has 2 batches, expected one with points");
}

static void test_another_method_is_found(void **state) {
    const whirl_study s = study("dop853", 16);
    (void)state;
    whirl_verification *v = verify(&s, 1, 1);
    assert_string_equal(v->integrate[0][0].method, "dop853");
    assert_string_not_equal(v->integrate[1][0].method, "dop853");
    assert_true(v->points[SLOW].agreed && v->points[STIFF].agreed);
    whirl_verification_free(v);
}

static void test_a_stop_leaves_nothing(void **state) {
    const whirl_study s = study("rk4", 16);
    const whirl_stop stop = true;
    whirl_verification *v;
    (void)state;
    const whirl_verify_options options = {.revolutions = 1};
    const whirl_run_options run = {.threads = 1, .stop = &stop};
    assert_int_equal(whirl_study_verify(&s, &options, &run, &v).code, WHIRL_STOPPED);
    assert_null(v);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_order_of_a_step),     cmocka_unit_test(test_verdicts_that_depend_on_the_step),
        cmocka_unit_test(test_threads_change_no_bit),   cmocka_unit_test(test_impossible_options_are_refused),
        cmocka_unit_test(test_another_method_is_found), cmocka_unit_test(test_a_stop_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
