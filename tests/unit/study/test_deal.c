// Studies whose points are dealt out among several runs: each point is computed once, by any of them, and the gathering
// run has the bits of one run, even if it was stopped itself.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "memory_store.h"
#include "pitchfork_study.h"

enum { RUNS = 4, LARGEST = 5 };

/// The runs, one after the other, the one that gathers last; each is dealt every so many pieces, so that all get some.
typedef struct table {
    const whirl_study *study;
    memory_store *stores[RUNS];
    bool known[2][MAX_SLOTS]; ///< before the runs begin, at the first tolerance and the second
    size_t dealt[2];          ///< pieces of both passes
    size_t run;               ///< which one is at it
    size_t left[2];           ///< pieces that it may still be dealt
    bool gathered;
} table;

static bool open_point(void *context, size_t batch, size_t slot) {
    return !((const table *)context)->known[batch][slot];
}

/// Deals pieces to a run, two or three at a time: in all a quarter of them to the first run, a third of the rest to the
/// second, and so on.
static size_t claim(void *context, size_t batch, size_t count, size_t *first) {
    table *all = context;
    assert_true(batch < 2 && all->dealt[batch] <= count);
    if (all->left[batch] == SIZE_MAX) all->left[batch] = (count - all->dealt[batch]) / (RUNS - all->run);
    const size_t wanted = 2 + all->dealt[batch] % 2;
    const size_t taken = wanted < all->left[batch] ? wanted : all->left[batch];
    *first = all->dealt[batch];
    all->dealt[batch] += taken;
    all->left[batch] -= taken;
    return taken;
}

static whirl_status gather(void *context) {
    table *all = context;
    memory_store *own = all->stores[RUNS - 1];
    for (size_t run = 0; run + 1 < RUNS; run++)
        for (size_t pass = 0; pass < 2; pass++)
            for (size_t slot = 0; slot < own->slots; slot++) {
                const memory_store *other = all->stores[run];
                if (!other->known[pass][slot]) continue;
                assert_false(own->known[pass][slot]); // no point is computed twice
                own->known[pass][slot] = true;
                memcpy(own->blocks[pass][slot], other->blocks[pass][slot], sizeof own->blocks[pass][slot]);
                memcpy(own->ends[pass][slot], other->ends[pass][slot], sizeof own->ends[pass][slot]);
            }
    all->gathered = true;
    return whirl_ok();
}

/// Runs the study as run `number` of all and returns its result; `stop` ends it.
static whirl_result *run_one(table *all, size_t number, const whirl_stop *stop, whirl_status *status) {
    const whirl_point_store store = {.keep = memory_write, .recall = memory_recall, .context = all->stores[number]};
    const bool last = number + 1 == RUNS;
    const whirl_dealer dealer = {
        .threads = 2 * RUNS, .open = open_point, .claim = claim, .gather = last ? gather : NULL, .context = all};
    const whirl_run_options options = {.threads = 2, .store = &store, .dealer = &dealer, .stop = stop};
    whirl_result *result = NULL;
    all->run = number;
    all->left[0] = all->left[1] = SIZE_MAX;
    *status = whirl_study_run(all->study, &options, &result);
    return result;
}

static size_t count_known(const memory_store *store, size_t pass) {
    size_t count = 0;
    for (size_t slot = 0; slot < store->slots; slot++) count += store->known[pass][slot];
    return count;
}

static void run_others(table *all) {
    size_t done, total;
    for (size_t number = 0; number + 1 < RUNS; number++) {
        whirl_status status;
        whirl_result *part = run_one(all, number, NULL, &status);
        assert_int_equal(status.code, WHIRL_OK);
        assert_true(whirl_result_partial(part, &done, &total));
        whirl_result_free(part);
    }
}

/// Makes the runs and their stores. If `resumed`, an earlier run left parts of the points in the store of the last run.
static void begin(table *all, const whirl_study *s, bool resumed) {
    *all = (table){.study = s};
    for (size_t i = 0; i < RUNS; i++) all->stores[i] = store_new(slots_of(s), 1);
    if (!resumed) return;
    memory_store *own = all->stores[RUNS - 1];
    whirl_result_free(run_with_store(s, own, WHIRL_OK));
    for (size_t slot = 0; slot < own->slots; slot++) {
        for (size_t pass = 0; pass < 2; pass++) {
            // A third of the points is complete, a third lacks the confirmation, a third is missing. Of a carried chain
            // its first third is there.
            const bool carried = s->batches[0].carry != WHIRL_CARRY_NONE;
            const bool keep = carried ? slot < POINTS / 3 : slot % 3 == 0 || (slot % 3 == 1 && pass == 0);
            own->known[pass][slot] = all->known[pass][slot] = own->known[pass][slot] && keep;
        }
    }
    // Every run can continue a chain that it is dealt.
    for (size_t i = 0; i + 1 < RUNS && s->batches[0].carry != WHIRL_CARRY_NONE; i++)
        memcpy(all->stores[i], own, sizeof *own);
}

static void end(table *all) {
    for (size_t i = 0; i < RUNS; i++) free(all->stores[i]);
}

static void expect_the_whole(const whirl_study *s) {
    whirl_result *whole = run(s, 1);
    size_t done, total;
    whirl_status status;
    table all;
    begin(&all, s, false);
    run_others(&all);
    const size_t others = count_known(all.stores[0], 0);
    whirl_result *gathered = run_one(&all, RUNS - 1, NULL, &status);
    assert_int_equal(status.code, WHIRL_OK);
    assert_true(all.gathered && !whirl_result_partial(gathered, &done, &total));
    if (s->batches[0].carry == WHIRL_CARRY_NONE) assert_int_equal(others, POINTS / RUNS);
    expect_same_blocks(whole, gathered);
    whirl_result_free(gathered);
    whirl_result_free(whole);
    end(&all);
}

static void test_all_together_make_the_whole(void **state) {
    double values[POINTS];
    (void)state;
    for (int carry = WHIRL_CARRY_NONE; carry <= WHIRL_CARRY_BOTH; carry++)
        for (int confirm = 0; confirm < 2; confirm++) {
            const whirl_study s = study(values, (whirl_carry)carry, confirm);
            expect_the_whole(&s);
        }
}

/// Known points are not dealt out. An incomplete chain is dealt to a run that has the rest of it.
static void test_known_points_are_not_dealt(void **state) {
    double values[POINTS];
    (void)state;
    const whirl_study s = study(values, WHIRL_CARRY_NONE, true);
    whirl_result *whole = run(&s, 1);
    whirl_status status;
    table all;
    begin(&all, &s, true);
    run_others(&all);
    whirl_result *gathered = run_one(&all, RUNS - 1, NULL, &status);
    assert_int_equal(status.code, WHIRL_OK);
    assert_int_equal(all.dealt[0], POINTS / 3);                // slots 2, 5, ...
    assert_int_equal(all.dealt[1], POINTS - (POINTS + 2) / 3); // and 1, 4, ...
    expect_same_blocks(whole, gathered);
    whirl_result_free(gathered);
    whirl_result_free(whole);
    end(&all);
}

/// The run that gathers may be stopped before its confirmations, or even before its points; its result still has the
/// points of the others.
static void test_a_stop_of_the_one_that_gathers(void **state) {
    const whirl_stop stop = true;
    double values[POINTS];
    size_t done = 0, total = 0;
    (void)state;
    const whirl_study s = study(values, WHIRL_CARRY_NONE, true);
    whirl_result *whole = run(&s, 1);
    const whirl_table *one = whole->tables;
    const size_t size = one->layout.size;
    whirl_status status;
    table all;
    begin(&all, &s, false);
    run_others(&all);
    whirl_result *gathered = run_one(&all, RUNS - 1, &stop, &status);
    const memory_store *store = all.stores[RUNS - 1];
    assert_int_equal(status.code, WHIRL_STOPPED);
    assert_non_null(strstr(status.message, "stopped after"));
    assert_true(all.gathered && whirl_result_partial(gathered, &done, &total));
    assert_int_equal(done, count_known(store, 0));
    assert_true(count_known(store, 1) >= 30 && count_known(store, 1) < POINTS);
    // Confirmations are compared when all points are there.
    for (size_t slot = 0; slot < POINTS; slot++) {
        const double *expected =
            done == POINTS && store->known[1][slot] ? one->blocks + slot * size : store->blocks[0][slot];
        if (store->known[0][slot])
            assert_memory_equal(expected, gathered->tables[0].blocks + slot * size, size * sizeof(double));
    }
    whirl_result_free(gathered);
    whirl_result_free(whole);
    end(&all);
}

static whirl_status refuse(void *context) {
    (void)context;
    return whirl_fail(WHIRL_IO_ERROR, "another run has failed");
}

static void test_an_error_of_gathering_ends_the_run(void **state) {
    double values[POINTS];
    (void)state;
    const whirl_study s = study(values, WHIRL_CARRY_NONE, false);
    whirl_result *result;
    table all;
    begin(&all, &s, false);
    all.run = RUNS - 1;
    all.left[0] = SIZE_MAX;
    const whirl_dealer dealer = {.threads = 1, .open = open_point, .claim = claim, .gather = refuse, .context = &all};
    const whirl_status status = whirl_study_run(&s, &(whirl_run_options){.threads = 1, .dealer = &dealer}, &result);
    assert_int_equal(status.code, WHIRL_IO_ERROR);
    assert_string_equal(status.message, "another run has failed");
    assert_null(result);
    end(&all);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_together_make_the_whole),
        cmocka_unit_test(test_known_points_are_not_dealt),
        cmocka_unit_test(test_a_stop_of_the_one_that_gathers),
        cmocka_unit_test(test_an_error_of_gathering_ends_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
