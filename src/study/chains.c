// Points come from chains, go through a recorder, and end as blocks of numbers in their slots.
#include "chains.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"

// ---------------------------------------------------------------- making

whirl_status chains_new(chains *c, const whirl_study *study, size_t batch_index, whirl_table *table, tracker *progress,
                        const whirl_keeper *keeper) {
    const whirl_batch *batch = &study->batches[batch_index];
    const bool carried = batch->carry != WHIRL_CARRY_NONE;
    *c = (chains){.study = study,
                  .batch = batch,
                  .batch_index = batch_index,
                  .table = table,
                  .tracker = progress,
                  .keeper = keeper};
    c->count = carried ? batch_copies(batch) : batch->count;
    c->items = calloc(c->count, sizeof *c->items);
    c->ready = calloc(c->count, sizeof(chain *));
    if (!c->items || !c->ready) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", batch->count);
    for (size_t i = 0; i < c->count; i++) {
        const bool reverse = batch->carry == WHIRL_CARRY_REVERSE || i == 1;
        c->items[i] = carried ? (chain){.first_slot = i * batch->count, .length = batch->count, .reverse = reverse}
                              : (chain){.first_slot = i, .length = 1};
        c->ready[c->count - 1 - i] = &c->items[i];
    }
    c->ready_count = c->count;
    return whirl_ok();
}

void chains_free(chains *c) {
    for (size_t i = 0; c->items && i < c->count; i++) free(c->items[i].carried);
    free(c->items);
    free(c->ready);
}

// ---------------------------------------------------------------- a thread's work

/// A thread at a batch.
typedef struct worker {
    chains *chains;
    size_t quota, under_way;
    size_t dimension;
    double *end;          ///< [dimension] of a point that is recalled, or that went astray
    whirl_status status;  ///< the first error of `next`
    double pending, last; ///< revolutions not yet told to the tracker, and when it was last told
} worker;

static chain *take_ready(chains *c) {
    chain *taken = NULL;
#pragma omp critical(whirl_chains)
    if (c->ready_count > 0) taken = c->ready[--c->ready_count];
    return taken;
}

static void put_ready(chains *c, chain *link) {
#pragma omp critical(whirl_chains)
    c->ready[c->ready_count++] = link;
}

static size_t current_slot(const chain *link) {
    return link->first_slot + (link->reverse ? link->length - 1 - link->done : link->done);
}

static void release(chain *link) {
    if (link->machine.release) link->machine.release(link->machine.owner);
    link->machine = (whirl_machine){0};
}

/// Keeps the end of a point (NULL: it diverged) for the next one of its chain; after a divergence the chain starts afresh.
static whirl_status carry(const chains *c, chain *link, const double *end, size_t dimension) {
    if (c->batch->carry == WHIRL_CARRY_NONE) return whirl_ok();
    if (!end) {
        free(link->carried);
        link->carried = NULL;
        return whirl_ok();
    }
    if (!link->carried) link->carried = malloc(dimension * sizeof *link->carried);
    if (!link->carried) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    memcpy(link->carried, end, dimension * sizeof *link->carried);
    return whirl_ok();
}

static void finish_point(chains *c, chain *link) {
    c->table->done[current_slot(link)] = 1;
    link->done++;
}

// ---------------------------------------------------------------- points that are kept

/// Takes the next point of a chain from the keeper, where that knows it.
static bool recall(worker *w, chain *link) {
    chains *c = w->chains;
    const size_t slot = current_slot(link), size = c->table->layout.size;
    bool known = false;
#pragma omp critical(whirl_keeper)
    known = c->keeper->recall(c->keeper->context, c->batch_index, slot, c->table->blocks + slot * size, size, w->end,
                              w->dimension);
    if (!known) return false;
    w->status = carry(c, link, isnan(w->end[0]) ? NULL : w->end, w->dimension);
    if (w->status.code != WHIRL_OK) return false;
    finish_point(c, link);
    tracker_recall(c->tracker, point_revolutions(c->batch));
    return true;
}

static whirl_status keep(const worker *w, size_t slot, const double *end) {
    const chains *c = w->chains;
    const size_t size = c->table->layout.size;
    whirl_status status;
    for (size_t i = 0; !end && i < w->dimension; i++) w->end[i] = NAN;
#pragma omp critical(whirl_keeper)
    status = c->keeper->keep(c->keeper->context, c->batch_index, slot, c->table->blocks + slot * size, size,
                             end ? end : w->end, w->dimension);
    return status;
}

static whirl_status tend(const whirl_keeper *keeper) {
    whirl_status status = whirl_ok();
    if (!keeper || !keeper->tend) return status;
#pragma omp critical(whirl_keeper)
    status = keeper->tend(keeper->context);
    return status;
}

// ---------------------------------------------------------------- points that are computed

/// A chain with a point to be computed, or NULL.
static chain *take_unknown(worker *w) {
    for (;;) {
        chain *link = take_ready(w->chains);
        if (!link || !w->chains->keeper) return link;
        while (link->done < link->length && recall(w, link)) {
        }
        if (w->status.code != WHIRL_OK) return NULL;
        if (link->done < link->length) return link;
    }
}

static bool next(void *context, whirl_task *task) {
    worker *w = context;
    const chains *c = w->chains;
    if (w->under_way >= w->quota || w->status.code != WHIRL_OK || atomic_load(&c->tracker->halt)) return false;
    chain *link = take_unknown(w);
    if (!link) return false;
    const double value = c->table->values[current_slot(link)];
    w->status = c->study->machine(c->study->family, c->batch, value, &link->machine);
    if (w->status.code != WHIRL_OK) return false;
    w->under_way++;
    *task = (whirl_task){link->machine.system, link->carried ? link->carried : link->machine.start, link};
    return true;
}

static whirl_status done(void *context, const whirl_task *task, whirl_record *record) {
    worker *w = context;
    chains *c = w->chains;
    chain *link = task->tag;
    const size_t slot = current_slot(link);
    const double *end = record->motion == WHIRL_BOUNDED ? record->end : NULL;
    whirl_status status = whirl_analyze(record, &c->batch->record, c->batch->analyses, &c->table->layout,
                                        c->table->blocks + slot * c->table->layout.size);
    if (status.code == WHIRL_OK) status = carry(c, link, end, w->dimension);
    if (status.code == WHIRL_OK && c->keeper) status = keep(w, slot, end);
    // What a motion that settled or diverged did not have to run counts as done.
    w->pending += point_revolutions(c->batch) - record->revolutions;
    whirl_record_free(record);
    release(link);
    w->under_way--;
    if (status.code != WHIRL_OK) return status;
    finish_point(c, link);
    if (link->done < link->length) put_ready(c, link);
    tracker_advance(c->tracker, 0.0, 1);
    return status;
}

static void abandon(void *context, const whirl_task *task) {
    (void)context;
    release(task->tag);
}

/// Revolutions reach the tracker in packets, so that threads seldom meet.
static bool revolution_done(void *context) {
    worker *w = context;
    w->pending += 1.0;
    const double seconds = clock_seconds();
    if (seconds - w->last < 0.1) return true;
    w->last = seconds;
    const double packet = w->pending;
    w->pending = 0.0;
    const whirl_status status = tend(w->chains->keeper);
    if (status.code != WHIRL_OK) tracker_fail(w->chains->tracker, &status);
    return tracker_advance(w->chains->tracker, packet, 0);
}

whirl_status chains_work(chains *c, size_t quota) {
    worker w = {.chains = c, .quota = quota, .last = clock_seconds()};
    const whirl_task_source source = {next, done, abandon, &w};
    const whirl_monitor monitor = {revolution_done, &w};
    whirl_machine first;
    whirl_status status = c->study->machine(c->study->family, c->batch, c->table->values[0], &first);
    if (status.code != WHIRL_OK) return status;
    w.dimension = first.system->dimension;
    w.end = malloc(w.dimension * sizeof *w.end);
    if (w.end)
        status = whirl_record_motions(first.system, &c->batch->integrate, &c->batch->record, &source, &monitor);
    else
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    free(w.end);
    if (first.release) first.release(first.owner);
    tracker_advance(c->tracker, w.pending, 0);
    return w.status.code != WHIRL_OK ? w.status : status;
}
