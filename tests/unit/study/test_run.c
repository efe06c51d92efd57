// Studies over a family of systems that a user writes: slots, carried branches, threads, errors and stops.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "memory_store.h"
#include "sweep_study.h"

/// x' = p + x - x^3: for |p| < 2/(3 sqrt 3) two stable equilibria, which a carried sweep follows until they vanish.
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
    *out = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

enum { POINTS = 41 };

static whirl_study study(double values[POINTS], whirl_carry carry) {
    whirl_study s = sweep_study("p", values, POINTS, 64);
    whirl_batch *batch = &s.batches[0];
    for (int i = 0; i < POINTS; i++) values[i] = -1 + 2.0 * i / (POINTS - 1);
    s.machine = machine;
    batch->carry = carry;
    batch->record.transient = 60;
    batch->record.record = 20;
    assert_true(whirl_analysis_add(&batch->analyses, "poincare"));
    assert_true(whirl_analysis_add(&batch->analyses, "lyapunov"));
    return s;
}

static double rest(const whirl_table *table, size_t point) {
    return *whirl_table_field(table, point, "poincare/section", 0);
}

static void test_points_have_the_same_start(void **state) {
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
        assert_int_equal(one->tables->layout.size, seven->tables->layout.size);
        expect_same_blocks(one, seven);
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

static whirl_stop stop;

/// Asks for a stop where the middle point begins, not where its machine is built beforehand for its tables of films.
static whirl_status stopping_machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    stop = stop || (!batch->outline && value > 0.0);
    return machine(family, batch, value, out);
}

static void test_a_stop_leaves_what_is_done(void **state) {
    double values[POINTS];
    whirl_study s = study(values, WHIRL_CARRY_NONE);
    whirl_result *result, *whole = run(&s, 1);
    size_t done, total;
    (void)state;
    s.machine = stopping_machine;
    const whirl_status status = whirl_study_run(&s, &(whirl_run_options){.threads = 1, .stop = &stop}, &result);
    assert_int_equal(status.code, WHIRL_STOPPED);
    assert_non_null(result);
    assert_true(whirl_result_partial(result, &done, &total));
    assert_true(done >= 1 && done < POINTS && total == POINTS);
    char sentence[80];
    snprintf(sentence, sizeof sentence, "stopped after %zu of %d points", done, POINTS);
    assert_string_equal(status.message, sentence);
    assert_false(whirl_result_partial(whole, &done, &total));
    const whirl_table *part = result->tables, *all = whole->tables;
    const size_t size = part->layout.size;
    for (size_t i = 0; i < POINTS; i++) {
        if (whirl_table_done(part, i))
            assert_memory_equal(part->blocks + i * size, all->blocks + i * size, size * sizeof(double));
        else
            for (size_t k = 0; k < size; k++) assert_true(isnan(part->blocks[i * size + k]));
    }
    whirl_result_free(result);
    whirl_result_free(whole);
}

// ---------------------------------------------------------------- stores

/// For any known points, with gaps in carried branches too, the result is that of a run without known points.
static void test_recalled_points_change_no_bit(void **state) {
    double values[POINTS];
    (void)state;
    for (int carry = WHIRL_CARRY_NONE; carry <= WHIRL_CARRY_BOTH; carry++) {
        const whirl_study s = study(values, (whirl_carry)carry);
        const int count = carry == WHIRL_CARRY_BOTH ? 2 * POINTS : POINTS;
        whirl_result *whole = run(&s, 1);
        memory_store *memory = store_new(POINTS * 2, 1);
        whirl_result_free(run_with_store(&s, memory, WHIRL_OK));
        assert_int_equal(memory->written, count);
        for (int step = 2; step <= 8; step *= 2) {
            for (int i = 0; i < count; i++) memory->known[0][i] = memory->known[0][i] && i % step != 1 && i != 5;
            int known = 0;
            for (int i = 0; i < count; i++) known += memory->known[0][i];
            whirl_result *resumed = run_with_store(&s, memory, WHIRL_OK);
            assert_int_equal(memory->recalled, known);
            assert_int_equal(memory->written, count - known);
            expect_same_blocks(whole, resumed);
            whirl_result_free(resumed);
        }
        whirl_result *recalled = run_with_store(&s, memory, WHIRL_OK);
        assert_true(memory->recalled == count && memory->written == 0);
        expect_same_blocks(whole, recalled);
        whirl_result_free(recalled);
        whirl_result_free(whole);
        free(memory);
    }
}

/// Blocks of a large table stay with the store. Recalled one by one, they are the same to the bit.
static void test_blocks_may_stay_with_the_store(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_BOTH);
    memory_store *memory = store_new(2 * POINTS, 1);
    const whirl_point_store store = {.keep = memory_write, .recall = memory_recall, .context = memory};
    const whirl_run_options options = {.threads = 2, .store = &store, .memory = 1};
    whirl_result *whole = run(&s, 1), *stored;
    (void)state;
    assert_int_equal(whirl_study_run(&s, &options, &stored).code, WHIRL_OK);
    const whirl_table *a = whole->tables, *b = stored->tables;
    assert_true(b->blocks == NULL && memory->written == 2 * POINTS);
    for (size_t i = 0; i < a->count; i++) {
        assert_memory_equal(whirl_table_block(a, i), whirl_table_block(b, i), a->layout.size * sizeof(double));
        assert_true(*whirl_table_field(b, i, "lyapunov/largest", 0) == *whirl_table_field(a, i, "lyapunov/largest", 0));
        assert_int_equal(whirl_table_verdict(b, i).regime, whirl_table_verdict(a, i).regime);
    }
    // Requested once, though three passes check it.
    assert_int_equal(memory->recalled, 2 * POINTS);
    memory->known[0][3] = false;
    assert_null(whirl_table_block(b, 3));
    assert_null(whirl_table_field(b, 3, "lyapunov/largest", 0));
    assert_non_null(whirl_table_block(b, 4));
    b->done[5] = 0;
    assert_true(isnan(*whirl_table_field(b, 5, "lyapunov/largest", 0)));
    assert_null(whirl_table_block(b, b->count));
    whirl_result_free(stored);
    whirl_result_free(whole);
    free(memory);
}

static void test_a_carried_branch_goes_on_after_a_divergence(void **state) {
    double values[POINTS];
    whirl_study s = study(values, WHIRL_CARRY_FORWARD);
    (void)state;
    // The start, 0.1, is within the limit; the rests beyond the fold are not, so that some points diverge.
    s.batches[0].integrate.limit = 1.2;
    whirl_result *whole = run(&s, 1);
    memory_store *memory = store_new(POINTS * 2, 1);
    whirl_result_free(run_with_store(&s, memory, WHIRL_OK));
    int diverged = 0;
    for (int i = 0; i < POINTS; i++) diverged += isnan(memory->ends[0][i][0]) != 0;
    assert_true(diverged > 0 && diverged < POINTS);
    for (int i = 1; i < POINTS; i += 2) memory->known[0][i] = false;
    whirl_result *resumed = run_with_store(&s, memory, WHIRL_OK);
    expect_same_blocks(whole, resumed);
    whirl_result_free(resumed);
    whirl_result_free(whole);
    free(memory);
}

static void test_a_store_that_fails_ends_the_run(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_NONE);
    memory_store *memory = store_new(POINTS * 2, 1);
    (void)state;
    memory->limit = 7;
    assert_null(run_with_store(&s, memory, WHIRL_IO_ERROR));
    assert_int_equal(memory->written, 7);
    memory->limit = -1;
    whirl_result *whole = run(&s, 1), *resumed = run_with_store(&s, memory, WHIRL_OK);
    assert_int_equal(memory->recalled, 7);
    expect_same_blocks(whole, resumed);
    whirl_result_free(resumed);
    whirl_result_free(whole);
    free(memory);
}

static void test_an_outline_has_all_but_the_points(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_BOTH);
    whirl_result *whole = run(&s, 1), *outline;
    (void)state;
    assert_int_equal(whirl_study_outline(&s, &outline).code, WHIRL_OK);
    const whirl_table *a = whole->tables, *b = outline->tables;
    assert_true(outline->table_count == 1 && b->count == a->count && b->layout.size == a->layout.size);
    assert_memory_equal(a->values, b->values, a->count * sizeof *a->values);
    assert_memory_equal(a->branch, b->branch, a->count * sizeof *a->branch);
    assert_null(b->blocks);
    assert_null(whirl_table_field(b, 0, "poincare/section", 0));
    whirl_result_free(outline);
    whirl_result_free(whole);
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
        cmocka_unit_test(test_points_have_the_same_start),
        cmocka_unit_test(test_carrying_shows_hysteresis),
        cmocka_unit_test(test_threads_change_no_bit),
        cmocka_unit_test(test_an_error_of_a_point_ends_the_run),
        cmocka_unit_test(test_progress_ends_complete),
        cmocka_unit_test(test_a_stop_leaves_what_is_done),
        cmocka_unit_test(test_recalled_points_change_no_bit),
        cmocka_unit_test(test_blocks_may_stay_with_the_store),
        cmocka_unit_test(test_a_carried_branch_goes_on_after_a_divergence),
        cmocka_unit_test(test_a_store_that_fails_ends_the_run),
        cmocka_unit_test(test_an_outline_has_all_but_the_points),
        cmocka_unit_test(test_empty_studies_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
