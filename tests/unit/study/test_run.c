// Studies over a family of systems that a user writes: slots, carried branches, threads, errors and stops.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/study.h"

/// x' = p + x - x^3: for |p| < 2/(3 sqrt 3) two stable rests, which a carried sweep follows until they vanish.
typedef struct pitchfork {
    double p;
    double start[1];
    whirl_system system;
} pitchfork;

static const whirl_probe probe = {.name = "rest"};

static void slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)t, (void)forcing;
    dxdt[0] = ((const pitchfork *)model)->p + x[0] - x[0] * x[0] * x[0];
}

static whirl_status machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    (void)batch;
    if (family && value > *(const double *)family)
        return whirl_fail(WHIRL_BAD_INPUT, "no machine beyond %g", *(const double *)family);
    pitchfork *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (pitchfork){.p = value, .start = {0.1}};
    own->system =
        (whirl_system){.dimension = 1, .period = 1, .rhs = slope, .probe_count = 1, .probes = &probe, .model = own};
    *out = (whirl_machine){&own->system, own->start, own, free};
    return whirl_ok();
}

enum { POINTS = 41 };

static whirl_study study(double values[POINTS], whirl_carry carry) {
    whirl_study s = {.batch_count = 1, .machine = machine};
    whirl_batch *batch = &s.batches[0];
    for (int i = 0; i < POINTS; i++) values[i] = -1 + 2.0 * i / (POINTS - 1);
    *batch = (whirl_batch){.name = "sweep", .parameter = "p", .count = POINTS, .values = values, .carry = carry};
    batch->integrate = whirl_integrate_default();
    batch->integrate.steps_per_revolution = 64;
    batch->record = whirl_record_default();
    batch->record.transient = 60;
    batch->record.record = 20;
    batch->record.waveform = false;
    assert_true(whirl_analysis_add(&batch->analyses, "poincare"));
    assert_true(whirl_analysis_add(&batch->analyses, "lyapunov"));
    return s;
}

static whirl_result *run(const whirl_study *s, int threads) {
    whirl_result *result;
    const whirl_status status = whirl_study_run(s, &(whirl_run_options){.threads = threads}, &result);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    return result;
}

static double rest(const whirl_table *table, size_t point) {
    return *whirl_table_field(table, point, "poincare/section", 0);
}

static void test_points_start_alike(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_NONE);
    (void)state;
    whirl_result *result = run(&s, 2);
    const whirl_table *table = whirl_result_table(result, "sweep");
    assert_int_equal(table->count, POINTS);
    for (size_t i = 0; i < POINTS; i++) {
        const double x = rest(table, i);
        assert_true(table->values[i] == values[i] && table->branch[i] == 0);
        assert_true(fabs(values[i] + x - x * x * x) < 1e-6);
        const double exponent = *whirl_table_field(table, i, "lyapunov/largest", 0);
        assert_true(fabs(exponent - (1 - 3 * x * x)) < 1e-3);
    }
    // From 0.1 the motion climbs where p + 0.1 - 0.001 > 0.
    assert_true(rest(table, 18) < 0 && rest(table, 19) > 0);
    whirl_result_free(result);
}

static void test_carrying_shows_hysteresis(void **state) {
    const double fold = 2 / (3 * sqrt(3.0));
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_BOTH);
    (void)state;
    whirl_result *result = run(&s, 2);
    const whirl_table *table = whirl_result_table(result, "sweep");
    assert_int_equal(table->count, 2 * POINTS);
    for (size_t i = 0; i < POINTS; i++) {
        assert_int_equal(table->branch[i], 1);
        assert_int_equal(table->branch[POINTS + i], -1);
        assert_true((rest(table, i) > 0) == (values[i] > fold));
        assert_true((rest(table, POINTS + i) > 0) == (values[i] > -fold));
    }
    whirl_result_free(result);
}

static void test_threads_change_no_bit(void **state) {
    double values[POINTS];
    (void)state;
    for (int carry = WHIRL_CARRY_NONE; carry <= WHIRL_CARRY_BOTH; carry++) {
        const whirl_study s = study(values, (whirl_carry)carry);
        whirl_result *one = run(&s, 1), *seven = run(&s, 7);
        const whirl_table *a = one->tables, *b = seven->tables;
        assert_int_equal(a->layout.size, b->layout.size);
        assert_memory_equal(a->blocks, b->blocks, a->count * a->layout.size * sizeof(double));
        whirl_result_free(one);
        whirl_result_free(seven);
    }
}

static void test_an_error_of_a_point_ends_the_run(void **state) {
    double values[POINTS], last = 0.5;
    whirl_study s = study(values, WHIRL_CARRY_NONE);
    whirl_result *result;
    (void)state;
    s.family = &last;
    const whirl_status status = whirl_study_run(&s, &(whirl_run_options){0}, &result);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "no machine beyond 0.5");
    assert_null(result);
}

static void count_points(void *context, const whirl_progress *progress) {
    whirl_progress *last = context;
    assert_true(progress->points_done >= last->points_done && progress->revolutions_done >= last->revolutions_done);
    *last = *progress;
}

static void test_progress_ends_complete(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_NONE);
    whirl_progress last = {0};
    whirl_result *result;
    (void)state;
    assert_int_equal(
        whirl_study_run(&s, &(whirl_run_options){.progress = count_points, .context = &last}, &result).code, WHIRL_OK);
    assert_int_equal(last.points_done, POINTS);
    assert_int_equal(last.points_total, POINTS);
    assert_true(last.revolutions_done == last.revolutions_total && last.revolutions_total == POINTS * 80.0);
    whirl_result_free(result);
}

static void test_a_stop_leaves_no_result(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_NONE);
    const volatile bool stop = true;
    whirl_result *result;
    (void)state;
    assert_int_equal(whirl_study_run(&s, &(whirl_run_options){.stop = &stop}, &result).code, WHIRL_STOPPED);
    assert_null(result);
}

static void test_empty_studies_are_refused(void **state) {
    double values[POINTS];
    whirl_study s = study(values, WHIRL_CARRY_NONE);
    whirl_result *result;
    (void)state;
    s.batches[0].count = 0;
    assert_int_equal(whirl_study_run(&s, &(whirl_run_options){0}, &result).code, WHIRL_BAD_INPUT);
    s.batch_count = 0;
    assert_int_equal(whirl_study_run(&s, &(whirl_run_options){0}, &result).code, WHIRL_BAD_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points_start_alike),        cmocka_unit_test(test_carrying_shows_hysteresis),
        cmocka_unit_test(test_threads_change_no_bit),     cmocka_unit_test(test_an_error_of_a_point_ends_the_run),
        cmocka_unit_test(test_progress_ends_complete),    cmocka_unit_test(test_a_stop_leaves_no_result),
        cmocka_unit_test(test_empty_studies_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
