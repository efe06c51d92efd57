// The 2015 paper's diagram with orbits by Newton's method: transients end as soon as the motion cannot but come to rest
// on a stable orbit, and every verdict is that of the whole run.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/case.h"

static const char *const id = "early";

/// The paper's case, its details left out.
typedef struct diagram {
    whirl_case *object;
    whirl_study study;
} diagram;

static void open_diagram(diagram *d) {
    require_ok(whirl_case_load(words("%s/paper.yaml", WHIRL_CASES), NULL, &d->object));
    require_ok(whirl_case_study(d->object, &d->study));
    d->study.batch_count = 1;
    d->study.batches[0].confirm = false;
}

static whirl_result *run(diagram *d, bool early, int threads) {
    whirl_batch *batch = &d->study.batches[0];
    whirl_result *result;
    whirl_analysis_set floquet = 0;
    const whirl_run_options options = {.threads = threads};
    const whirl_batch before = *batch;
    assert_true(whirl_analysis_add(&floquet, "floquet"));
    if (early) batch->analyses |= floquet;
    whirl_analysis_needs(batch->analyses, &batch->record);
    batch->record.settle = early;
    require_ok(whirl_study_run(&d->study, &options, &result));
    *batch = before;
    return result;
}

static bool differs(const whirl_verdict *a, const whirl_verdict *b) {
    return a->regime != b->regime || a->period != b->period || a->curves != b->curves;
}

/// Cost of the periodic points, revolutions of Newton's method included.
typedef struct cost {
    size_t periodic, ended, differing, other_orbit, less_trusted;
    double motion, newton;
} cost;

static cost compare(const whirl_table *whole, const whirl_table *early) {
    cost sum = {0};
    for (size_t i = 0; i < whole->count; i++) {
        const whirl_verdict expected = whirl_table_verdict(whole, i), verdict = whirl_table_verdict(early, i);
        sum.differing += differs(&expected, &verdict);
        sum.other_orbit +=
            differs(&expected, &verdict) && (expected.regime == WHIRL_PERIODIC || verdict.regime == WHIRL_PERIODIC);
        sum.less_trusted += verdict.confidence < expected.confidence;
        if (expected.regime != WHIRL_PERIODIC) continue;
        sum.periodic++;
        sum.ended += table_number(early, i, "floquet/set_at", 0) > 0.0;
        sum.motion += table_number(early, i, "regime/revolutions", 0);
        sum.newton += table_number(early, i, "floquet/revolutions", 0);
    }
    return sum;
}

static bool same_bits(const whirl_table *a, const whirl_table *b) {
    return a->layout.size == b->layout.size && a->count == b->count &&
           memcmp(a->blocks, b->blocks, a->count * a->layout.size * sizeof *a->blocks) == 0;
}

static void the_papers_diagram(void **state) {
    enum { POINTS = 512 };
    const size_t every = getenv("WHIRL_SOAK") ? 1 : 2; // of the diagram's points
    diagram d;
    double values[POINTS];
    (void)state;
    open_diagram(&d);
    whirl_batch *batch = &d.study.batches[0];
    assert_int_equal(batch->count, POINTS);
    batch->count /= every;
    for (size_t i = 0; i < batch->count; i++) values[i] = batch->values[i * every];
    batch->values = values;
    whirl_result *whole = run(&d, false, 2), *early = run(&d, true, 2), *again = run(&d, true, 1);
    const cost sum = compare(&whole->tables[0], &early->tables[0]);
    const double share = (sum.motion + sum.newton) / (1200.0 * (double)sum.periodic);
    check_within(id, "points", (double)batch->count, (double)whole->tables[0].count, 0);
    check_within(id, "points whose verdict is not that of all 1200 revolutions", 0, (double)sum.differing, 0);
    check_within(id, "points whose verdict is less trusted", 0, (double)sum.less_trusted, 0);
    check_holds(id,
                words("of %zu periodic points %zu end early; they take %.1f revolutions, and %.1f by Newton's method",
                      sum.periodic, sum.ended, sum.motion / (double)sum.periodic, sum.newton / (double)sum.periodic),
                share <= 0.1);
    check_within(id, "their revolutions over 1200", 0.05, share, 0.05);
    check_holds(id, "no bit depends on the number of threads", same_bits(&early->tables[0], &again->tables[0]));
    whirl_result_free(whole);
    whirl_result_free(early);
    whirl_result_free(again);
    whirl_case_free(d.object);
}

/// A carried sweep whose periodic motions end early leaves an attractor at the same values as the whole run.
/// (Aperiodic points that follow a chaotic one start from other points of it, by rounding: those in doubt may differ.)
static void carried_both_ways(void **state) {
    enum { POINTS = 24 };
    diagram d;
    double values[POINTS];
    (void)state;
    open_diagram(&d);
    for (size_t i = 0; i < POINTS; i++) values[i] = 0.62 - 0.014 * (double)i;
    whirl_batch *batch = &d.study.batches[0];
    batch->values = values;
    batch->count = POINTS;
    batch->carry = WHIRL_CARRY_BOTH;
    whirl_result *whole = run(&d, false, 2), *early = run(&d, true, 2);
    const cost sum = compare(&whole->tables[0], &early->tables[0]);
    check_within(id, "points followed both ways", 2 * POINTS, (double)whole->tables[0].count, 0);
    check_within(id, "points that are periodic in one of both and not the same in the other", 0,
                 (double)sum.other_orbit, 0);
    check_holds(id,
                words("of %zu periodic points %zu end early; they take %.1f revolutions, and %.1f by Newton's method",
                      sum.periodic, sum.ended, sum.motion / (double)sum.periodic, sum.newton / (double)sum.periodic),
                sum.ended > sum.periodic / 2);
    whirl_result_free(whole);
    whirl_result_free(early);
    whirl_case_free(d.object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_papers_diagram),
        cmocka_unit_test(carried_both_ways),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
