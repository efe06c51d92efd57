// Refined maps: computed points have the bits of the whole grid, the others the labels that they would have; and
// threads, shares, stops and stores change nothing.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define STORE_SLOTS 1024
#include "memory_store.h"
#include "sweep_study.h"

enum { COLUMNS = 37, ROWS = 25, POINTS = COLUMNS * ROWS, SQUARE = 8 };

/// x' = x^2 + p^2 + q^2 - 1/2 from 0: within the disc p^2 + q^2 < 1/2 it comes to rest, beyond it is gone in finite
/// time. In a basin x' = x - x^3 from p^2 + q^2 - 1/2: to -1 within the disc, to 1 beyond.
typedef struct model {
    bool basin;
    double a, start[1];
    whirl_system system;
} model;

static void slope(const void *pointer, double t, const double *forcing, const double *x, double *dxdt) {
    const model *m = pointer;
    (void)t, (void)forcing;
    dxdt[0] = m->basin ? x[0] - x[0] * x[0] * x[0] : x[0] * x[0] + m->a;
}

static whirl_status machine(const void *family, const whirl_batch *batch, double value, whirl_machine *out) {
    static const whirl_probe probe = {.name = "rest"};
    const bool basin = *(const bool *)family;
    const double a = value * value + batch->second_value * batch->second_value - 0.5;
    model *own = malloc(sizeof *own);
    assert_non_null(own);
    *own = (model){.basin = basin, .a = a, .start = {basin ? a : 0.0}};
    own->system =
        (whirl_system){.dimension = 1, .period = 1, .rhs = slope, .probe_count = 1, .probes = &probe, .model = own};
    *out = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

/// The plane's values, and the study over it.
typedef struct plane {
    double p[POINTS], q[POINTS];
    bool basin;
    whirl_study study;
} plane;

static void make(plane *s, const char *name, size_t refine, bool confirm) {
    static const char *const analyses[] = {"poincare", "orbit", "regime"};
    s->basin = strcmp(name, "basin") == 0;
    for (size_t i = 0; i < POINTS; i++) {
        s->p[i] = -1.0 + 2.0 * (double)(i % COLUMNS) / (COLUMNS - 1);
        s->q[i] = -0.4 + 1.6 * (double)(i / COLUMNS) / (ROWS - 1);
    }
    s->study = sweep_study("p", s->p, POINTS, 32);
    whirl_batch *batch = &s->study.batches[0];
    s->study.machine = machine;
    s->study.family = &s->basin;
    strcpy(batch->name, name);
    batch->role = s->basin ? WHIRL_ROLE_BASIN : WHIRL_ROLE_MAP;
    strcpy(batch->second, "q");
    batch->second_values = s->q;
    batch->row = COLUMNS;
    batch->refine = refine;
    batch->confirm = confirm;
    batch->record.transient = 100;
    batch->record.record = 20;
    for (size_t i = 0; i < 3; i++) assert_true(whirl_analysis_add(&batch->analyses, analyses[i]));
}

static bool same_motion(const whirl_table *a, size_t i, const whirl_table *b, size_t j) {
    const whirl_verdict one = whirl_table_verdict(a, i), other = whirl_table_verdict(b, j);
    return one.regime == other.regime && one.period == other.period;
}

/// Checks all fields of the points except the width, which the grid lacks.
static void expect_same_bits(const whirl_table *refined, size_t i, const whirl_table *grid, size_t j) {
    for (size_t f = 0; f < grid->layout.field_count; f++) {
        const whirl_field *field = &grid->layout.fields[f];
        const double *one = whirl_table_field(refined, i, field->name, 0);
        assert_memory_equal(one, whirl_table_field(grid, j, field->name, 0),
                            field->repeat * field->rows * field->columns * sizeof *one);
    }
    assert_true(refined->values[i] == grid->values[j] && whirl_table_second(refined, i) == whirl_table_second(grid, j));
}

/// The grid's own verdicts hold at all of its points, and less than half of them were computed; all along the circle.
static void a_refined_map_has_the_grids_points(void **state) {
    (void)state;
    for (int confirm = 0; confirm < 2; confirm++) {
        plane whole, part;
        make(&whole, "map", 0, confirm);
        make(&part, "map", SQUARE, confirm);
        whirl_result *all = run(&whole.study, 2), *some = run(&part.study, 2);
        const whirl_table *grid = &all->tables[0], *refined = &some->tables[0];
        size_t cover[POINTS], circle = 0;
        assert_int_equal(whirl_table_grid(refined), POINTS);
        assert_int_equal(whirl_table_rows(refined), ROWS);
        assert_true(refined->count < POINTS / 2 && whirl_table_planned(refined) == refined->count);
        whirl_table_cover(refined, cover);
        for (size_t i = 0; i < refined->count; i++) expect_same_bits(refined, i, grid, whirl_table_slot(refined, i));
        for (size_t slot = 0; slot < POINTS; slot++) {
            assert_true(same_motion(refined, cover[slot], grid, slot));
            const double away = whole.p[slot] * whole.p[slot] + whole.q[slot] * whole.q[slot] - 0.5;
            if (fabs(away) > 0.1) // where it is fast enough for a verdict
                assert_int_equal(whirl_table_verdict(grid, slot).regime, away < 0 ? WHIRL_PERIODIC : WHIRL_DIVERGING);
            const bool meet = slot % COLUMNS > 0 && !same_motion(grid, slot - 1, grid, slot);
            circle += meet;
            if (meet) assert_true(whirl_table_slot(refined, cover[slot]) == slot);
        }
        assert_true(circle > ROWS);
        whirl_result_free(all);
        whirl_result_free(some);
    }
}

/// Both motions of a basin are P-1: its squares are divided where attractors differ, and its shares are those of the
/// grid's starts.
static void a_basin_is_refined_by_attractors(void **state) {
    plane whole, part;
    whirl_attractor of_grid[4], found[4];
    size_t grid_count, count;
    (void)state;
    make(&whole, "basin", 0, false);
    make(&part, "basin", SQUARE, false);
    whirl_result *all = run(&whole.study, 2), *some = run(&part.study, 2);
    assert_true(some->tables[0].count < POINTS / 2);
    assert_int_equal(whirl_table_attractors(&all->tables[0], NULL, of_grid, 4, &grid_count).code, WHIRL_OK);
    assert_int_equal(whirl_table_attractors(&some->tables[0], NULL, found, 4, &count).code, WHIRL_OK);
    assert_int_equal(grid_count, 2);
    assert_int_equal(count, 2);
    for (size_t k = 0; k < 2; k++) {
        assert_int_equal(found[k].points, of_grid[k].points);
        assert_true(found[k].share == of_grid[k].share && found[k].error == of_grid[k].error);
    }
    whirl_result_free(all);
    whirl_result_free(some);
}

static void expect_same(const whirl_result *one, const whirl_result *other) {
    const whirl_table *a = &one->tables[0], *b = &other->tables[0];
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->slots, b->slots, a->count * sizeof *a->slots);
    for (size_t i = 0; i < a->count; i++) {
        double block[BLOCK];
        assert_true(a->layout.size <= BLOCK);
        memcpy(block, whirl_table_block(a, i), a->layout.size * sizeof *block);
        assert_memory_equal(block, whirl_table_block(b, i), a->layout.size * sizeof *block);
    }
}

static whirl_result *run_with(const plane *s, memory_store *memory, whirl_run_options options, whirl_code expected) {
    whirl_result *result;
    memory->store = (whirl_point_store){.keep = memory_write, .recall = memory_recall, .context = memory};
    options.threads = 2;
    options.store = &memory->store;
    memory->written = memory->recalled = 0;
    assert_int_equal(whirl_study_run(&s->study, &options, &result).code, expected);
    return result;
}

static void expect_two_attractors(const whirl_result *result) {
    size_t count;
    assert_int_equal(whirl_table_attractors(&result->tables[0], NULL, NULL, 0, &count).code, WHIRL_OK);
    assert_int_equal(count, 2);
}

/// Three shares are gathered, with blocks in memory and with blocks in the store. Gathering before the last share
/// reports missing points, and computes none.
static void shares_make_the_whole(void **state) {
    (void)state;
    for (int confirm = 0; confirm < 2; confirm++)
        for (size_t memory = 0; memory < 2; memory++) {
            plane s;
            make(&s, "basin", SQUARE, confirm);
            whirl_result *whole = run(&s.study, 1);
            memory_store *store = store_new(POINTS, 1);
            for (size_t number = 1; number <= 3; number++) {
                const whirl_run_options gather = {.gather = true, .memory = memory};
                const whirl_run_options share = {.share = {number, 3}, .memory = memory};
                whirl_result *early = run_with(&s, store, gather, WHIRL_STOPPED);
                assert_int_equal(store->written, 0);
                whirl_result_free(early);
                whirl_result_free(run_with(&s, store, share, WHIRL_OK));
                assert_true(store->written > 0);
            }
            whirl_result *gathered =
                run_with(&s, store, (whirl_run_options){.gather = true, .memory = memory}, WHIRL_OK);
            assert_true(store->written < (int)whole->tables[0].count / 10);
            expect_same(whole, gathered);
            expect_two_attractors(whole);
            expect_two_attractors(gathered);
            whirl_result_free(gathered);
            whirl_result_free(whole);
            free(store);
        }
}

/// First squares that are dealt out among two runs, the second of which gathers.
typedef struct dealt {
    memory_store *stores[2];
    size_t squares, most; ///< dealt so far; that may be dealt to this run
} dealt;

static bool is_open(void *context, size_t batch, size_t slot) {
    (void)context, (void)batch, (void)slot;
    return true;
}

static size_t claim(void *context, size_t batch, size_t count, size_t *first) {
    dealt *d = context;
    if (batch > 0) return 0; // the confirmation of a point goes with it
    const size_t most = d->most < count ? d->most : count, left = most - d->squares, taken = left < 3 ? left : 3;
    *first = d->squares;
    d->squares += taken;
    return taken;
}

/// Points on edges between two first squares are computed by both runs, with the same bits.
static whirl_status gather(void *context) {
    const dealt *d = context;
    const memory_store *one = d->stores[0];
    memory_store *own = d->stores[1];
    size_t both = 0;
    for (size_t pass = 0; pass < 2; pass++)
        for (size_t slot = 0; slot < POINTS; slot++) {
            if (!one->known[pass][slot]) continue;
            if (own->known[pass][slot])
                assert_memory_equal(own->blocks[pass][slot], one->blocks[pass][slot], sizeof own->blocks[pass][slot]);
            both += own->known[pass][slot];
            own->known[pass][slot] = true;
            memcpy(own->blocks[pass][slot], one->blocks[pass][slot], sizeof own->blocks[pass][slot]);
            memcpy(own->ends[pass][slot], one->ends[pass][slot], sizeof own->ends[pass][slot]);
        }
    assert_true(both > 0);
    return whirl_ok();
}

static void squares_may_be_dealt_out(void **state) {
    (void)state;
    for (int confirm = 0; confirm < 2; confirm++) {
        plane s;
        make(&s, "map", SQUARE, confirm);
        whirl_result *whole = run(&s.study, 1);
        dealt d = {.stores = {store_new(POINTS, 1), store_new(POINTS, 1)}, .most = 8};
        whirl_dealer dealer = {.threads = 4, .open = is_open, .claim = claim, .context = &d};
        whirl_result_free(run_with(&s, d.stores[0], (whirl_run_options){.dealer = &dealer}, WHIRL_OK));
        assert_int_equal(d.squares, 8);
        d.most = POINTS;
        dealer.gather = gather;
        whirl_result *gathered = run_with(&s, d.stores[1], (whirl_run_options){.dealer = &dealer}, WHIRL_OK);
        expect_same(whole, gathered);
        whirl_result_free(gathered);
        whirl_result_free(whole);
        for (size_t i = 0; i < 2; i++) free(d.stores[i]);
    }
}

/// A full store stops the run at any place; the points that it has then change no bit of the next run.
static void stops_change_nothing(void **state) {
    static const int limits[] = {1, 20, 24, 60, 200, 300};
    plane s;
    (void)state;
    make(&s, "map", SQUARE, true);
    whirl_result *whole = run(&s.study, 1);
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        memory_store *store = store_new(POINTS, 1);
        store->limit = limits[i];
        assert_null(run_with(&s, store, (whirl_run_options){0}, WHIRL_IO_ERROR));
        store->limit = -1;
        whirl_result *again = run_with(&s, store, (whirl_run_options){0}, WHIRL_OK);
        assert_true(store->recalled > 0);
        expect_same(whole, again);
        whirl_result_free(again);
        free(store);
    }
    whirl_result_free(whole);
}

/// Stops at once: the corners of the first squares are asked for, and none is done.
static void a_stopped_map_is_partial(void **state) {
    const whirl_stop stop = true;
    plane s;
    size_t done, total;
    whirl_result *result;
    (void)state;
    make(&s, "map", SQUARE, false);
    assert_int_equal(whirl_study_run(&s.study, &(whirl_run_options){.threads = 2, .stop = &stop}, &result).code,
                     WHIRL_STOPPED);
    assert_true(whirl_result_partial(result, &done, &total));
    assert_true(done < total && total >= 6 * 4 && total < POINTS);
    assert_int_equal(whirl_table_grid(&result->tables[0]), POINTS);
    whirl_result_free(result);
}

/// Points in doubt are done again in a refined map, too; nothing else changes.
static void a_budget_goes_to_points_in_doubt(void **state) {
    plane s;
    (void)state;
    make(&s, "map", SQUARE, false);
    s.study.batches[0].record.transient = 10;
    whirl_result *plain = run(&s.study, 2);
    s.study.refine.revolutions = 1e5;
    whirl_result *refined = run(&s.study, 2);
    const whirl_table *a = &plain->tables[0], *b = &refined->tables[0];
    size_t again = 0;
    assert_int_equal(a->count, b->count);
    for (size_t i = 0; i < a->count; i++) {
        const bool done_again = whirl_table_number(b, i, "refine/rounds", 0) > 0;
        again += done_again;
        assert_true(whirl_table_slot(a, i) == whirl_table_slot(b, i));
        assert_true(whirl_table_number(a, i, "map/width", 0) == whirl_table_number(b, i, "map/width", 0));
        if (done_again) assert_int_equal(whirl_table_verdict(a, i).confidence, WHIRL_LOW);
    }
    assert_true(again > 0);
    whirl_result_free(plain);
    whirl_result_free(refined);
}

static void impossible_refinements_are_refused(void **state) {
    plane s;
    whirl_result *result;
    (void)state;
    make(&s, "map", 12, false);
    whirl_status status = whirl_study_run(&s.study, &(whirl_run_options){0}, &result);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_non_null(strstr(status.message, "squares of 12 points, expected a power of two"));
    make(&s, "map", SQUARE, false);
    s.study.batches[0].row = 0;
    assert_int_equal(whirl_study_run(&s.study, &(whirl_run_options){0}, &result).code, WHIRL_BAD_INPUT);
    make(&s, "map", SQUARE, false);
    s.study.batches[0].analyses = 0;
    assert_true(whirl_analysis_add(&s.study.batches[0].analyses, "orbit"));
    assert_int_equal(whirl_study_run(&s.study, &(whirl_run_options){0}, &result).code, WHIRL_BAD_INPUT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_refined_map_has_the_grids_points),
        cmocka_unit_test(a_basin_is_refined_by_attractors),
        cmocka_unit_test(shares_make_the_whole),
        cmocka_unit_test(squares_may_be_dealt_out),
        cmocka_unit_test(stops_change_nothing),
        cmocka_unit_test(a_stopped_map_is_partial),
        cmocka_unit_test(a_budget_goes_to_points_in_doubt),
        cmocka_unit_test(impossible_refinements_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
