// Starts from neighbouring points: the attractors of a tilted double well are known in closed form. Both must be found
// at all points between its folds.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { POINTS = 41, STARTS = 2, SLOTS = POINTS * (STARTS + 16) };
#define STORE_SLOTS SLOTS

#include "memory_store.h"
#include "sweep_study.h"

/// x' = p + x - x^3 + cos(2 pi t)/2: stable oscillations around two rests for |p| < 2/(3 sqrt 3), around one for other
/// p. Their amplitude a = .08 moves the folds to |p| = 2/(3 sqrt 3) (1 - 9/4 a^2), by averaging. Values are .05 apart,
/// so that none lies between.
typedef struct well {
    double p, start[1];
    whirl_system system;
} well;

static const double fold = 0.3849;

static const whirl_probe probe = {.name = "rest"};

static void slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)forcing;
    dxdt[0] = ((const well *)model)->p + x[0] - x[0] * x[0] * x[0] + 0.5 * cos(6.283185307179586 * t);
}

/// Makes the machine of a value. Both starts lead to the upper rest if p is above about -.1, else to the lower one.
static whirl_status machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    well *own = malloc(sizeof *own);
    (void)family;
    assert_non_null(own);
    assert_true(batch->start < STARTS);
    *own = (well){.p = value, .start = {0.1 + 0.01 * (double)batch->start}};
    own->system =
        (whirl_system){.dimension = 1, .period = 1, .rhs = slope, .probe_count = 1, .probes = &probe, .model = own};
    *out = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

static whirl_study study(double values[POINTS], size_t rounds) {
    static const char *const analyses[] = {"poincare", "orbit", "regime"};
    whirl_study s = sweep_study("p", values, POINTS, 64);
    whirl_batch *batch = &s.batches[0];
    for (int i = 0; i < POINTS; i++) values[i] = -1 + 2.0 * i / (POINTS - 1);
    s.machine = machine;
    batch->starts = STARTS;
    batch->neighbours = rounds;
    batch->record.transient = 80;
    batch->record.record = 16;
    for (size_t i = 0; i < 3; i++) assert_true(whirl_analysis_add(&batch->analyses, analyses[i]));
    whirl_analysis_needs(batch->analyses, &batch->record);
    return s;
}

/// Returns the number of attractors that only a start from a neighbour found. *right: exactly the values between the
/// folds have two attractors.
static size_t count_double(const whirl_result *result, bool *right) {
    whirl_coexistence found;
    const whirl_table *table = result->tables;
    size_t count = 0;
    *right = true;
    assert_int_equal(whirl_table_coexistence(table, &found).code, WHIRL_OK);
    assert_int_equal(found.places, POINTS);
    for (size_t k = 0; k < found.count; k++) {
        const whirl_coexisting *one = &found.items[k];
        assert_true(one->of == STARTS && (one->starts == STARTS || one->starts == 0));
        assert_true(one->share == (one->starts > 0 ? 1.0 : 0.0) && one->error == 0.0);
        assert_true((one->starts == 0) == whirl_table_from_neighbour(table, one->first));
        count += one->starts == 0;
        *right = *right && (one->coexisting == 2) == (fabs(table->values[one->first]) < fold);
    }
    whirl_coexistence_free(&found);
    return count;
}

/// Both rests are found up to their folds: in every round one value further at either end.
static void both_equilibria_are_followed_to_their_folds(void **state) {
    double values[POINTS];
    bool right;
    (void)state;
    for (size_t rounds = 0; rounds <= 4; rounds++) {
        const whirl_study s = study(values, rounds);
        whirl_result *result = run(&s, 2);
        assert_int_equal(count_double(result, &right), 2 * rounds);
        assert_true(result->tables[0].count >= POINTS * STARTS + 2 * rounds);
        whirl_result_free(result);
    }
    const whirl_study s = study(values, 100);
    whirl_result *result = run(&s, 2);
    assert_int_equal(count_double(result, &right), 15);
    assert_true(right);
    whirl_result_free(result);
}

/// A start from a neighbour is the last state of that neighbour's motion, and the table has the neighbour's number.
static void starts_are_ends(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, 100);
    whirl_result *result = run(&s, 1);
    const whirl_table *table = result->tables;
    size_t compared = 0;
    (void)state;
    for (size_t i = 0; i < table->count; i++) {
        const size_t from = (size_t)whirl_table_number(table, i, "starts/neighbour", 0);
        assert_true((from > 0) == (i >= POINTS * STARTS));
        if (from == 0) continue;
        assert_int_equal(1, labs((long)from - 1 - (long)whirl_table_place(table, i)));
        const double start = whirl_table_number(table, i, "starts/state", 0);
        for (size_t k = 0; k < table->count; k++) {
            const whirl_field *field = whirl_layout_field(&table->layout, "poincare/section");
            const double *section = whirl_table_field(table, k, "poincare/section", 0);
            compared += whirl_table_place(table, k) == from - 1 && section[(field->rows - 1) * field->columns] == start;
        }
    }
    assert_true(compared >= table->count - POINTS * STARTS);
    whirl_result_free(result);
}

static void expect_same(const whirl_result *one, const whirl_result *other) {
    const whirl_table *a = one->tables, *b = other->tables;
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->slots, b->slots, a->count * sizeof *a->slots);
    for (size_t i = 0; i < a->count; i++) {
        double block[BLOCK];
        memcpy(block, whirl_table_block(a, i), a->layout.size * sizeof *block);
        assert_memory_equal(block, whirl_table_block(b, i), a->layout.size * sizeof *block);
    }
}

static whirl_result *run_with(const whirl_study *s, memory_store *memory, whirl_run_options options) {
    whirl_result *result;
    memory->store = (whirl_point_store){.keep = memory_write, .recall = memory_recall, .context = memory};
    options.store = &memory->store;
    memory->written = memory->recalled = 0;
    assert_int_equal(whirl_study_run(s, &options, &result).code, WHIRL_OK);
    return result;
}

/// The number of threads, shares, points recalled from a store, and the place of blocks change no bit, with and without
/// `confirm`.
static void no_bit_depends_on_how_it_is_computed(void **state) {
    double values[POINTS];
    (void)state;
    for (size_t kept = 0; kept < 2; kept++) {
        whirl_study s = study(values, 100);
        s.batches[0].confirm =
            !kept; // blocks of confirmed points stay in memory, so the second kind needs unconfirmed ones
        whirl_result *whole = run(&s, 1);
        memory_store *memory = store_new(SLOTS, 1);
        for (size_t number = 1; number <= 3; number++)
            whirl_result_free(
                run_with(&s, memory, (whirl_run_options){.threads = 2, .share = {number, 3}, .memory = kept}));
        for (int step = 1; step <= 3; step++) {
            whirl_result *gathered =
                run_with(&s, memory, (whirl_run_options){.threads = step, .gather = step == 1, .memory = kept});
            assert_true((gathered->tables[0].blocks == NULL) == (kept == 1));
            expect_same(whole, gathered);
            whirl_result_free(gathered);
            for (size_t i = 0; i < SLOTS; i++) memory->known[0][i] = memory->known[0][i] && i % (size_t)(step + 2) != 1;
        }
        free(memory);
        whirl_result_free(whole);
    }
}

static void studies_without_neighbours_are_refused(void **state) {
    double values[POINTS];
    whirl_study s = study(values, 1);
    whirl_result *result;
    (void)state;
    s.batches[0].starts = 1;
    whirl_status status = whirl_study_run(&s, &(whirl_run_options){0}, &result);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "batch 'sweep' has starts from neighbours, expected several points and starts");
    s.batches[0].starts = STARTS;
    s.batches[0].count = 1;
    status = whirl_study_run(&s, &(whirl_run_options){0}, &result);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(both_equilibria_are_followed_to_their_folds),
                                       cmocka_unit_test(starts_are_ends),
                                       cmocka_unit_test(no_bit_depends_on_how_it_is_computed),
                                       cmocka_unit_test(studies_without_neighbours_are_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
