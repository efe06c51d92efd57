// Jumps of a sweep between motions of one regime: where the folds of Duffing's oscillator are known,
// there are jumps, and only there; a resonance without folds has none, however steep.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "sweep_study.h"

/// x'' + 0.1 x' + x + alpha x^3 = 0.4 cos(w t), in the time tau = w t.
typedef struct oscillator {
    double w, alpha;
    double start[2];
    whirl_system system;
} oscillator;

static const whirl_probe probe = {.name = "mass", .x = 0, .y = 0, .vx = 1, .vy = 1};
static const double two_pi = 6.283185307179586476925;

static void slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const oscillator *of = model;
    (void)t;
    dxdt[0] = x[1];
    dxdt[1] = (0.4 * forcing[0] - x[0] - of->alpha * x[0] * x[0] * x[0]) / (of->w * of->w) - 0.1 / of->w * x[1];
}

static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    forcing[0] = cos(t);
}

static whirl_status machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    (void)batch;
    oscillator *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (oscillator){.w = value, .alpha = *(const double *)family};
    own->system = (whirl_system){.dimension = 2,
                                 .period = two_pi,
                                 .forcing_count = 1,
                                 .forcing = cosine,
                                 .rhs = slope,
                                 .probe_count = 1,
                                 .probes = &probe,
                                 .model = own};
    *out = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

enum { POINTS = 57 };

/// Sweeps w = 1.02 ... 1.30 both ways, each start carried from the point before.
static whirl_result *sweep(double alpha) {
    double values[POINTS];
    whirl_study study = sweep_study("w", values, POINTS, 64);
    whirl_batch *batch = &study.batches[0];
    for (int i = 0; i < POINTS; i++) values[i] = 1.02 + 0.005 * i;
    study.machine = machine;
    study.family = &alpha;
    batch->carry = WHIRL_CARRY_BOTH;
    batch->record.transient = 250;
    batch->record.record = 30;
    assert_true(whirl_analysis_add(&batch->analyses, "orbit"));
    assert_true(whirl_analysis_add(&batch->analyses, "regime"));
    return run(&study, 1);
}

/// With rising w the large motion is followed to its fold, with falling w the small one. The folds are those of the
/// response A^2 [(1 - w^2 + 3/4 alpha A^2)^2 + (0.1 w)^2] = 0.4^2 (harmonic balance), whose third harmonic, left out,
/// moves them by (3/4 alpha A^2)^2/32 < 0.006.
static void duffing_jumps_at_its_folds(void **state) {
    (void)state;
    whirl_jump jumps[8];
    size_t count;
    whirl_result *result = sweep(0.05);
    const whirl_table *table = &result->tables[0];
    assert_int_equal(whirl_table_jumps(table, jumps, 8, &count).code, WHIRL_OK);
    assert_int_equal(count, 2);
    static const double folds[2] = {1.19016, 1.14531};
    for (int i = 0; i < 2; i++) {
        const double from = table->values[jumps[i].from], to = table->values[jumps[i].to];
        assert_int_equal(jumps[i].to, jumps[i].from + 1);
        assert_int_equal(table->branch[jumps[i].from], i == 0 ? 1 : -1);
        assert_true(fmin(from, to) - 0.006 < folds[i] && folds[i] < fmax(from, to) + 0.006);
        assert_true(jumps[i].change >
                    (i == 0 ? 0.3 : 0.15)); // amplitudes 3.4 to 1.1, and 1.8 to 2.8, of twice 3.4 and 2.8
    }
    whirl_result_free(result);
}

static void a_resonance_has_none(void **state) {
    (void)state;
    whirl_jump jumps[8];
    size_t count;
    whirl_result *result = sweep(0.0);
    assert_int_equal(whirl_table_jumps(&result->tables[0], jumps, 8, &count).code, WHIRL_OK);
    assert_int_equal(count, 0);
    whirl_result_free(result);
}

/// The count includes jumps beyond the room of the list; tables without orbits, or of one point, have none.
static void odd_tables(void **state) {
    (void)state;
    size_t count;
    whirl_result *result = sweep(0.05);
    whirl_table *table = &result->tables[0];
    assert_int_equal(whirl_table_jumps(table, NULL, 0, &count).code, WHIRL_OK);
    assert_int_equal(count, 2);
    const size_t all = table->count;
    table->count = 1;
    assert_int_equal(whirl_table_jumps(table, NULL, 0, &count).code, WHIRL_OK);
    assert_int_equal(count, 0);
    table->count = all;
    table->layout.field_count = 0;
    assert_int_equal(whirl_table_jumps(table, NULL, 0, &count).code, WHIRL_OK);
    assert_int_equal(count, 0);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(duffing_jumps_at_its_folds),
                                       cmocka_unit_test(a_resonance_has_none), cmocka_unit_test(odd_tables)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
