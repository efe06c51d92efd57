// Shares of a study: each point is computed in one of them, and together they give the result of one run.
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

static whirl_result *run_share(const whirl_study *s, memory_store *memory, whirl_share share, bool gather,
                               whirl_status *status) {
    const whirl_point_store store = {.keep = memory_write, .recall = memory_recall, .context = memory};
    const whirl_run_options options = {.threads = 1, .store = &store, .share = share, .gather = gather};
    whirl_result *result;
    memory->written = memory->recalled = 0;
    *status = whirl_study_run(s, &options, &result);
    return result;
}

static bool is_partial(const whirl_result *result) {
    size_t done, total;
    return whirl_result_partial(result, &done, &total);
}

/// Returns the number of points that a store knows, at the first tolerance.
static size_t known_points(const memory_store *memory) {
    size_t known = 0;
    for (size_t i = 0; i < memory->slots; i++) known += memory->known[0][i];
    return known;
}

static size_t points_of(const whirl_study *s, whirl_share share) {
    size_t count = 0;
    for (size_t slot = 0; slot < slots_of(s); slot++) count += whirl_share_has(s, &share, 0, slot);
    return count;
}

/// Checks that shares make the whole. The store refuses a point that it has, so that none is computed twice.
static void expect_shares_make_the_whole(const whirl_study *s, size_t count) {
    whirl_result *whole = run(s, 1);
    memory_store *memory = store_new(slots_of(s), 1);
    const size_t passes = s->batches[0].confirm ? 2 : 1;
    whirl_status status;
    for (size_t number = count; number > 0; number--) {
        const whirl_share share = {number, count};
        const size_t own = points_of(s, share);
        // Before the last share the others' points are not all there.
        whirl_result *gathered = run_share(s, memory, (whirl_share){0}, true, &status);
        if (points_of(s, (whirl_share){number, count}) > 0) {
            assert_int_equal(status.code, WHIRL_STOPPED);
            assert_true(is_partial(gathered) && memory->written == 0);
            assert_int_equal(memory->recalled, known_points(memory));
        }
        whirl_result_free(gathered);
        whirl_result *result = run_share(s, memory, share, false, &status);
        assert_int_equal(status.code, WHIRL_OK);
        assert_int_equal(memory->written, own * passes);
        assert_true(is_partial(result));
        whirl_result_free(result);
    }
    whirl_result *gathered = run_share(s, memory, (whirl_share){0}, true, &status);
    assert_int_equal(status.code, WHIRL_OK);
    assert_false(is_partial(gathered));
    assert_int_equal(memory->recalled, slots_of(s) * passes);
    expect_same_blocks(whole, gathered);
    whirl_result_free(gathered);
    whirl_result_free(whole);
    free(memory);
}

static void test_shares_make_the_whole(void **state) {
    static const size_t counts[] = {1, 3, 7, POINTS + 2}; // the last with shares that have no point
    double values[POINTS];
    (void)state;
    for (int carry = WHIRL_CARRY_NONE; carry <= WHIRL_CARRY_BOTH; carry++)
        for (int confirm = 0; confirm < 2; confirm++)
            for (size_t i = 0; i < (confirm ? 3 : sizeof counts / sizeof *counts); i++) {
                const whirl_study s = study(values, (whirl_carry)carry, confirm);
                expect_shares_make_the_whole(&s, counts[i]);
            }
}

/// Shares of 41 points differ by one at most; a chain of carried points is all in one.
static void test_shares_are_even(void **state) {
    double values[POINTS];
    const whirl_study alone = study(values, WHIRL_CARRY_NONE, false), both = study(values, WHIRL_CARRY_BOTH, true);
    (void)state;
    for (size_t number = 1; number <= 7; number++) {
        assert_int_equal(points_of(&alone, (whirl_share){number, 7}), number <= 6 ? 6 : 5);
        assert_int_equal(points_of(&both, (whirl_share){number, 7}), number <= 2 ? POINTS : 0);
        // At the second tolerance, where batches have numbers of their own, too.
        assert_int_equal(whirl_share_has(&both, &(whirl_share){number, 7}, 1, 3), number == 1);
    }
    assert_true(whirl_share_has(&alone, &(whirl_share){0}, 0, 3));
}

static void test_shares_that_are_none_are_refused(void **state) {
    double values[POINTS];
    const whirl_study s = study(values, WHIRL_CARRY_NONE, false);
    memory_store *memory = store_new(POINTS, 1);
    whirl_status status;
    (void)state;
    assert_null(run_share(&s, memory, (whirl_share){0, 3}, false, &status));
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_null(run_share(&s, memory, (whirl_share){4, 3}, false, &status));
    assert_string_equal(status.message, "the share is 4 of 3, expected 1 to 3");
    free(memory);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shares_make_the_whole),
        cmocka_unit_test(test_shares_are_even),
        cmocka_unit_test(test_shares_that_are_none_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
