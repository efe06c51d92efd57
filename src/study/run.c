// Running a study: points in chains, chains on threads.
//
// A chain is a sequence of points that start from one another's ends; points that do not carry are chains of one. A
// chain is a pure function of the study and writes to its own slots, so threads cannot change a result.
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "tracker.h"
#include "whirl/study.h"

/// Points of one batch that are computed one after the other, in slots of the batch's table.
typedef struct chain {
    size_t batch, first_slot, length;
    bool reverse; ///< from the last slot to the first
} chain;

typedef struct run {
    const whirl_study *study;
    whirl_result *result;
    size_t chain_count;
    chain *chains;
    tracker tracker;
} run;

/// The state that is handed from point to point of a chain.
typedef struct carried_state {
    bool wanted, valid;
    double *x;
} carried_state;

/// A point's revolutions reach the tracker in packets, so that threads seldom meet.
typedef struct point_monitor {
    tracker *tracker;
    double pending, reported, last;
} point_monitor;

static bool revolution_done(void *context) {
    point_monitor *monitor = context;
    monitor->pending += 1.0;
    const double seconds = clock_seconds();
    if (seconds - monitor->last < 0.1) return true;
    const double packet = monitor->pending;
    monitor->last = seconds;
    monitor->reported += packet;
    monitor->pending = 0.0;
    return tracker_advance(monitor->tracker, packet, 0);
}

static size_t copies(const whirl_batch *batch) {
    return batch->carry == WHIRL_CARRY_BOTH ? 2 : 1;
}

static double point_revolutions(const whirl_batch *batch) {
    return batch->record.transient + batch->record.record;
}

/// Keeps a chain's state; after a divergence the chain starts afresh.
static whirl_status carry(carried_state *carried, const whirl_record *record) {
    carried->valid = record->motion == WHIRL_BOUNDED;
    if (!carried->wanted || !carried->valid) return whirl_ok();
    if (!carried->x) carried->x = malloc(record->dimension * sizeof *carried->x);
    if (!carried->x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    memcpy(carried->x, record->end, record->dimension * sizeof *carried->x);
    return whirl_ok();
}

static whirl_status compute_point(run *r, const whirl_batch *batch, double value, carried_state *carried,
                                  const whirl_layout *layout, double *block) {
    whirl_machine machine;
    whirl_status status = r->study->machine(r->study->family, batch, value, &machine);
    if (status.code != WHIRL_OK) return status;
    point_monitor progress = {.tracker = &r->tracker, .last = clock_seconds()};
    const whirl_monitor monitor = {revolution_done, &progress};
    const double *start = carried->wanted && carried->valid ? carried->x : machine.start;
    whirl_record *record = NULL;
    status = whirl_record_motion(machine.system, &batch->integrate, &batch->record, start, &monitor, &record);
    if (status.code == WHIRL_OK) status = whirl_analyze(record, &batch->record, batch->analyses, layout, block);
    if (status.code == WHIRL_OK) status = carry(carried, record);
    whirl_record_free(record);
    if (machine.release) machine.release(machine.owner);
    tracker_advance(&r->tracker, point_revolutions(batch) - progress.reported, 1);
    return status;
}

static void run_chain(run *r, const chain *link) {
    const whirl_batch *batch = &r->study->batches[link->batch];
    whirl_table *table = &r->result->tables[link->batch];
    carried_state carried = {.wanted = batch->carry != WHIRL_CARRY_NONE};
    for (size_t i = 0; i < link->length && !atomic_load(&r->tracker.halt); i++) {
        const size_t slot = link->first_slot + (link->reverse ? link->length - 1 - i : i);
        const whirl_status status = compute_point(r, batch, table->values[slot], &carried, &table->layout,
                                                  table->blocks + slot * table->layout.size);
        if (status.code != WHIRL_OK) tracker_fail(&r->tracker, &status);
    }
    free(carried.x);
}

/// Long points first, so that no thread is left with one at the end.
static int by_work(const void *left, const void *right) {
    const chain *a = left, *b = right;
    if (a->batch != b->batch) return a->batch > b->batch ? -1 : 1; // details come after the sweep and are longer
    return a->first_slot < b->first_slot ? -1 : a->first_slot > b->first_slot;
}

static whirl_status make_chains(run *r) {
    size_t most = 0;
    for (size_t i = 0; i < r->study->batch_count; i++)
        most += r->study->batches[i].count * copies(&r->study->batches[i]);
    r->chains = calloc(most ? most : 1, sizeof *r->chains);
    if (!r->chains) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", most);
    for (size_t i = 0; i < r->study->batch_count; i++) {
        const whirl_batch *batch = &r->study->batches[i];
        if (batch->carry == WHIRL_CARRY_NONE) {
            for (size_t k = 0; k < batch->count; k++) r->chains[r->chain_count++] = (chain){i, k, 1, false};
            continue;
        }
        if (batch->carry != WHIRL_CARRY_REVERSE) r->chains[r->chain_count++] = (chain){i, 0, batch->count, false};
        if (batch->carry != WHIRL_CARRY_FORWARD)
            r->chains[r->chain_count++] = (chain){i, (copies(batch) - 1) * batch->count, batch->count, true};
    }
    qsort(r->chains, r->chain_count, sizeof *r->chains, by_work);
    return whirl_ok();
}

// ---------------------------------------------------------------- tables

static void fill_values(whirl_table *table, const whirl_batch *batch) {
    for (size_t copy = 0; copy < copies(batch); copy++)
        for (size_t k = 0; k < batch->count; k++) {
            const size_t slot = copy * batch->count + k;
            table->values[slot] = batch->values ? batch->values[k] : NAN;
            if (batch->carry != WHIRL_CARRY_NONE)
                table->branch[slot] = copy == 1 || batch->carry == WHIRL_CARRY_REVERSE ? -1 : 1;
        }
}

/// An empty table whose layout follows from the first machine of the batch.
static whirl_status make_table(const whirl_study *study, const whirl_batch *batch, whirl_table *table) {
    whirl_machine machine;
    whirl_status status = study->machine(study->family, batch, batch->values ? batch->values[0] : NAN, &machine);
    if (status.code != WHIRL_OK) return status;
    status = whirl_layout_new(machine.system, &batch->integrate, &batch->record, batch->analyses, &table->layout);
    if (machine.release) machine.release(machine.owner);
    if (status.code != WHIRL_OK) return status;
    memcpy(table->name, batch->name, sizeof table->name);
    memcpy(table->parameter, batch->parameter, sizeof table->parameter);
    table->count = copies(batch) * batch->count;
    table->analyses = batch->analyses;
    table->integrate = batch->integrate;
    table->record = batch->record;
    table->values = calloc(table->count, sizeof *table->values);
    table->branch = calloc(table->count, sizeof *table->branch);
    table->blocks = calloc(table->count * table->layout.size + 1, sizeof *table->blocks);
    if (!table->values || !table->branch || !table->blocks)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the results of %zu points", table->count);
    fill_values(table, batch);
    return whirl_ok();
}

static whirl_status make_result(run *r) {
    r->result = calloc(1, sizeof *r->result);
    if (r->result) {
        r->result->case_text = calloc(1, 1);
        r->result->tables = calloc(r->study->batch_count, sizeof *r->result->tables);
    }
    if (!r->result || !r->result->tables || !r->result->case_text)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a result");
    r->result->table_count = r->study->batch_count;
    for (size_t i = 0; i < r->study->batch_count; i++) {
        const whirl_status status = make_table(r->study, &r->study->batches[i], &r->result->tables[i]);
        if (status.code != WHIRL_OK) return status;
    }
    return whirl_ok();
}

static whirl_status check(const whirl_study *study, const whirl_run_options *options) {
    if (study->batch_count == 0 || study->batch_count > WHIRL_MAX_BATCHES || !study->machine)
        return whirl_fail(WHIRL_BAD_INPUT, "the study has %zu batches, expected 1 to %d and a machine",
                          study->batch_count, WHIRL_MAX_BATCHES);
    for (size_t i = 0; i < study->batch_count; i++)
        if (study->batches[i].count == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "batch '%s' has no points, expected at least one",
                              study->batches[i].name);
    if (options->threads < 0) return whirl_fail(WHIRL_BAD_INPUT, "threads is %d, expected 0 or more", options->threads);
    return whirl_ok();
}

static void begin(run *r, const whirl_run_options *options) {
    size_t points = 0;
    double revolutions = 0.0;
    for (size_t i = 0; i < r->study->batch_count; i++) {
        const whirl_batch *batch = &r->study->batches[i];
        const size_t count = batch->count * copies(batch);
        points += count;
        revolutions += (double)count * point_revolutions(batch);
    }
    tracker_begin(&r->tracker, options, points, revolutions);
}

whirl_status whirl_study_run(const whirl_study *study, const whirl_run_options *options, whirl_result **out) {
    *out = NULL;
    run r = {.study = study};
    whirl_status status = check(study, options);
    if (status.code == WHIRL_OK) status = make_result(&r);
    if (status.code == WHIRL_OK) status = make_chains(&r);
    if (status.code == WHIRL_OK) {
        begin(&r, options);
        const int threads = options->threads > 0 ? options->threads : omp_get_num_procs();
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
        for (size_t i = 0; i < r.chain_count; i++) run_chain(&r, &r.chains[i]);
        status = r.tracker.status;
        if (status.code == WHIRL_OK && atomic_load(&r.tracker.halt))
            status = whirl_fail(WHIRL_STOPPED, "stopped after %zu of %zu points", r.tracker.progress.points_done,
                                r.tracker.progress.points_total);
        if (status.code == WHIRL_OK) tracker_end(&r.tracker);
    }
    free(r.chains);
    if (status.code == WHIRL_OK)
        *out = r.result;
    else
        whirl_result_free(r.result);
    return status;
}
