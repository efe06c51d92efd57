// The cache of modes of shafts: a solution comes back to the bit, for the same numbers only; and its memory is bounded.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "inner_modes.h"

enum { INNER = 30, KEPT = 4, SQUARE = INNER * INNER, INNER_KEPT = INNER * KEPT };

/// A problem with room for its solution.
typedef struct problem {
    double k[SQUARE], m[SQUARE], follow[INNER_KEPT], squares[INNER], shapes[SQUARE];
} problem;

static inner_modes of(problem *p) {
    return (inner_modes){INNER, KEPT, p->k, p->m, p->follow, p->squares, p->shapes};
}

/// Fills a problem that `number` identifies, with an arbitrary solution.
static void fill(problem *p, double number, bool solved) {
    for (size_t i = 0; i < SQUARE; i++) p->k[i] = number + (double)i, p->m[i] = 1.0 / (1.0 + (double)i);
    for (size_t i = 0; i < INNER_KEPT; i++) p->follow[i] = solved ? sqrt(number + (double)i) : -(double)i;
    for (size_t i = 0; i < INNER; i++) p->squares[i] = solved ? number / (1.0 + (double)i) : NAN;
    for (size_t i = 0; i < SQUARE; i++) p->shapes[i] = solved ? number * (double)i / 3.0 : NAN;
}

static void cache(double number) {
    problem asked, solved;
    fill(&asked, number, false);
    fill(&solved, number, true);
    const inner_modes before = of(&asked), after = of(&solved);
    double *begun = inner_modes_begin(&before);
    assert_non_null(begun);
    inner_modes_keep(&after, begun);
}

static bool recall(double number, problem *out) {
    fill(out, number, false);
    const inner_modes all = of(out);
    return inner_modes_recall(&all);
}

static void solutions_come_from_the_cache(void **state) {
    problem found, right;
    (void)state;
    cache(1.0);
    cache(2.0);
    cache(2.0); // as two threads may
    for (double number = 1.0; number < 3.0; number++) {
        assert_true(recall(number, &found));
        fill(&right, number, true);
        assert_memory_equal(&found, &right, sizeof found);
    }
}

static void other_numbers_do_not(void **state) {
    problem p;
    (void)state;
    cache(1.0);
    double *const parts[] = {p.k, p.m, p.follow};
    const size_t counts[] = {SQUARE, SQUARE, INNER_KEPT};
    for (size_t part = 0; part < 3; part++)
        for (size_t i = 0; i < counts[part]; i += 7) {
            fill(&p, 1.0, false);
            parts[part][i] = nextafter(parts[part][i], 1e9);
            const inner_modes all = of(&p);
            assert_false(inner_modes_recall(&all));
            assert_true(isnan(p.squares[0]) && isnan(p.shapes[0]));
        }
    fill(&p, 1.0, false);
    const inner_modes fewer = {INNER, KEPT - 1, p.k, p.m, p.follow, p.squares, p.shapes};
    assert_false(inner_modes_recall(&fewer));
}

static void the_oldest_is_forgotten(void **state) {
    problem found;
    size_t known = 0;
    (void)state;
    for (int i = 100; i < 200; i++) cache(i);
    for (int i = 100; i < 200; i++) known += recall(i, &found);
    assert_int_equal(known, 16);
    assert_true(recall(199.0, &found));
    assert_false(recall(100.0, &found));
}

static void large_problems_are_not_cached(void **state) {
    enum { LARGE = 2000 };
    double *numbers = calloc((size_t)LARGE * LARGE, sizeof *numbers);
    (void)state;
    assert_non_null(numbers);
    const inner_modes all = {LARGE, 1, numbers, numbers, numbers, numbers, numbers};
    assert_null(inner_modes_begin(&all));
    free(numbers);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solutions_come_from_the_cache),
        cmocka_unit_test(other_numbers_do_not),
        cmocka_unit_test(the_oldest_is_forgotten),
        cmocka_unit_test(large_problems_are_not_cached),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
