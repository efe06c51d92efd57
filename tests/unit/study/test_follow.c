// Chaotic motions that may be on their way are followed beyond their end: the Lorenz system, whose chaos ends at an
// equilibrium up to r = 24.06 and lasts beyond (Sparrow 1982).
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lorenz.h"
#include "memory_store.h"
#include "sweep_study.h"

typedef struct lorenz {
    double r, start[3];
    whirl_system system;
} lorenz;

static whirl_status make_lorenz(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    static const whirl_probe probe = {.name = "convection"};
    (void)family, (void)batch;
    lorenz *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (lorenz){.r = value, .start = {1.0, 1.0, 20.0}};
    own->system = (whirl_system){.dimension = 3,
                                 .period = 1,
                                 .rhs = lorenz_rhs,
                                 .tangent = lorenz_tangent,
                                 .probe_count = 1,
                                 .probes = &probe,
                                 .model = own};
    *out = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

static whirl_study study(const double *values, size_t count) {
    whirl_study s = sweep_study("r", values, count, 128);
    whirl_batch *batch = &s.batches[0];
    s.machine = make_lorenz;
    batch->confirm = true;
    batch->record.transient = 500;
    batch->record.watch = 580;
    assert_true(whirl_analysis_add(&batch->analyses, "regime"));
    return s;
}

/// Few points have no neighbours: every chaotic one is followed, to its end or for a while.
static void test_chaos_that_ends_is_doubted(void **state) {
    static const double values[] = {23.15, 23.36, 23.48, 28.0};
    const whirl_study s = study(values, 4);
    (void)state;
    whirl_result *result = run(&s, 2), *alone = run(&s, 1);
    int ended = 0;
    for (size_t i = 0; i < 4; i++) {
        const whirl_verdict v = whirl_table_verdict(result->tables, i);
        if (v.regime != WHIRL_CHAOTIC || v.followed == 0.0) continue;
        if (values[i] < 24.06 && v.later_regime == WHIRL_PERIODIC) {
            assert_int_equal(v.confidence, WHIRL_LOW);
            assert_int_equal(v.advice.remedy, WHIRL_LONGER_TRANSIENT);
            ended++;
        }
    }
    const whirl_verdict lasting = whirl_table_verdict(result->tables, 3);
    assert_int_equal(lasting.confidence, WHIRL_HIGH);
    assert_true(lasting.followed == 2 * 3 * 600);
    assert_int_equal(lasting.later_regime, WHIRL_CHAOTIC);
    assert_true(ended > 0);
    expect_same_blocks(result, alone);
    memory_store *memory = store_new(4, 3);
    whirl_result_free(run_with_store(&s, memory, WHIRL_OK));
    const int written = memory->written;
    whirl_result *recalled = run_with_store(&s, memory, WHIRL_OK);
    assert_int_equal(memory->recalled, written);
    expect_same_blocks(result, recalled);
    free(memory);
    whirl_result_free(recalled);
    whirl_result_free(result);
    whirl_result_free(alone);
}

/// In a sweep only those are followed that lie close to the end of chaos.
static void test_chaos_amid_chaos_is_not_followed(void **state) {
    double values[16];
    for (size_t i = 0; i < 16; i++) values[i] = 16.0 + (double)i;
    const whirl_study s = study(values, 16);
    (void)state;
    whirl_result *result = run(&s, 2);
    for (size_t i = 0; i < 16; i++) {
        const whirl_verdict v = whirl_table_verdict(result->tables, i);
        if (values[i] < 20.0) assert_true(v.regime != WHIRL_CHAOTIC);
        if (values[i] > 26.5 && values[i] < 30.0) assert_true(v.regime == WHIRL_CHAOTIC && v.followed == 0.0);
    }
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_chaos_that_ends_is_doubted),
                                       cmocka_unit_test(test_chaos_amid_chaos_is_not_followed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
