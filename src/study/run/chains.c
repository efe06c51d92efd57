// Carries the points of chains through a recorder; they end as blocks of numbers in their slots.
#include "chains.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "memory.h"
#include "whirl/engine/ensemble.h"

// ---------------------------------------------------------------- making

/// Analyses of a pass whose verdicts are compared with those of the points: the regime and, at the second tolerance,
/// the requested exponents.
static whirl_analysis_set chains_compared(const pass *p, const whirl_batch *batch) {
    static const char *const names[] = {"regime", "lyapunov", "exponents"};
    const size_t count = p->confirming ? sizeof names / sizeof *names : 1;
    whirl_analysis_set set = 0;
    for (size_t i = 0; i < count; i++) whirl_analysis_add(&set, names[i]);
    return set & batch->analyses;
}

/// Makes the layout of these analyses.
static whirl_status make_other_layout(chains *c) {
    whirl_batch first = *c->batch;
    whirl_machine machine;
    first.outline = true;
    whirl_status status = whirl_study_machine(c->run->study, &first, 0, &machine);
    if (status.code != WHIRL_OK) return status;
    status = whirl_layout_new(machine.system, &c->pass->integrate, &c->pass->record, chains_compared(c->pass, c->batch),
                              &c->other);
    if (machine.release) machine.release(machine.owner);
    return status;
}

/// Takes the next dealt chain, from malloc; NULL if there is none, or if *no_memory. There are as many at a time as
/// threads have points under way.
static chain *begin_chain(chains *c, bool *no_memory) {
    const pass *p = c->pass;
    size_t index;
    if (!deal_take(&c->deal, &index)) return NULL;
    const size_t length = pass_chain_length(p, c->batch), first = p->slots ? p->slots[index] : index * length;
    chain *link = malloc(sizeof *link);
    if (link)
        *link = (chain){.first_slot = first, .length = length, .reverse = length > 1 && c->table->branch[first] < 0};
    *no_memory = !link;
    return link;
}

whirl_status chains_new(chains *c, study_run *run, const pass *p) {
    const whirl_batch *batch = &run->study->batches[p->batch];
    const size_t length = pass_chain_length(p, batch), count = p->count / length;
    *c = (chains){.run = run,
                  .pass = p,
                  .batch = batch,
                  .table = &run->result->tables[p->batch],
                  .ends = run->ends[p->batch],
                  .weight = pass_weight(run, p),
                  .revolutions = pass_revolutions(run, p),
                  .deal = deal_begin(run, p, count)};
    // Chains of one point never wait.
    const size_t waiting = length > 1 ? count : 1;
    c->ready = calloc(waiting, sizeof(chain *));
    if (!c->ready) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", p->count);
    return pass_is_beside(p) ? make_other_layout(c) : whirl_ok();
}

void chains_free(chains *c) {
    for (size_t i = 0; i < c->ready_count; i++) free(c->ready[i]);
    free(c->ready);
}

// ---------------------------------------------------------------- a thread's work

/// A thread that works at a pass.
typedef struct worker {
    chains *chains;
    whirl_machine first;  ///< its structure is that of all machines in the recorder
    chain *unlike;        ///< a chain whose machine has another structure, waiting for a recorder of its own; or NULL
    size_t under_way;     ///< points
    double *end;          ///< [dimension] end of a point's motion
    double *other;        ///< [other.size] a verdict at the second tolerance
    double *block;        ///< [layout.size] block of a point whose block stays in the journal
    whirl_status status;  ///< first error of `next`
    double pending, last; ///< revolutions not yet reported to the tracker, and the time of the last report
    size_t number;        ///< number of the thread
    double save_at;       ///< time at which motions under way are saved next
    size_t finished;      ///< points
} worker;

/// Seconds after which a motion is saved, and saved again.
static const double save_interval = 5.0;

/// Takes the next chain, unless this thread already has its share of the remaining points: otherwise some threads would
/// end with full lanes while others are idle.
static chain *take_ready(worker *w) {
    chains *c = w->chains;
    const size_t threads = (size_t)c->deal.threads;
    chain *taken = NULL;
    bool no_memory = false;
#pragma omp critical(whirl_chains)
    {
        const size_t left = c->ready_count + deal_left(&c->deal);
        if (left > 0 && w->under_way < (left + c->under_way + threads - 1) / threads) {
            taken = c->ready_count > 0 ? c->ready[--c->ready_count] : begin_chain(c, &no_memory);
            c->under_way += taken != NULL;
        }
    }
    if (no_memory) w->status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a point");
    return taken;
}

/// Releases a chain after a point: other threads may continue it, unless it has ended.
static void chains_leave(chains *c, chain *link, bool ended) {
    const bool over = ended || link->done == link->length;
#pragma omp critical(whirl_chains)
    {
        c->under_way--;
        if (!over) c->ready[c->ready_count++] = link;
    }
    if (over) free(link);
}

static size_t current_slot(const chain *link) {
    return link->first_slot + (link->reverse ? link->length - 1 - link->done : link->done);
}

static void chains_release(chain *link) {
    if (link->machine.release) link->machine.release(link->machine.owner);
    link->machine = (whirl_machine){0};
    free(link->start);
    link->start = NULL;
}

/// Frees a chain that nobody continues.
static void chains_drop(chain *link) {
    chains_release(link);
    free(link);
}

/// Start of a point that continues another one's motion. A carried point: the end of the point before it, NULL without
/// one or if that diverged. A start from a neighbour: the end of the motion there.
static const double *carried_start(const chains *c, size_t slot) {
    const size_t origin = pass_origin(c->run, c->pass->batch, slot);
    if (origin != slot) return c->ends + origin * c->run->dimension;
    if (c->batch->carry == WHIRL_CARRY_NONE) return NULL;
    const size_t first = slot / c->batch->count * c->batch->count;
    const bool reverse = c->table->branch[slot] < 0;
    if (slot == (reverse ? first + c->batch->count - 1 : first)) return NULL;
    const double *end = c->ends + (reverse ? slot + 1 : slot - 1) * c->run->dimension;
    return isnan(end[0]) ? NULL : end;
}

/// Memory for the block of a point.
static double *chains_block_of(const worker *w, size_t slot) {
    const whirl_table *table = w->chains->table;
    return table->blocks ? table->blocks + slot * table->layout.size : w->block;
}

/// Notes a second verdict. Two copies of a point may end at the same time.
static void set_beside(const worker *w, size_t slot) {
    const chains *c = w->chains;
    const whirl_layout *layout = &c->table->layout;
    const whirl_verdict other = whirl_block_verdict(&c->other, w->other);
    const double revolutions = w->other[whirl_layout_field(&c->other, WHIRL_FIELD_REGIME_REVOLUTIONS)->offset];
#pragma omp critical(whirl_beside)
    {
        if (c->pass->confirming) {
            whirl_block_confirm(layout, chains_block_of(w, slot), &other);
            whirl_block_compare_exponents(layout, chains_block_of(w, slot), &c->other, w->other);
        } else {
            whirl_block_follow(layout, chains_block_of(w, slot), &other, revolutions);
        }
        if (c->pass->round > 0) refine_add_spent(layout, chains_block_of(w, slot), c->weight * revolutions);
    }
}

/// Finishes a point that was computed or recalled: w->end or w->other has the pass's result.
static void finish_point(worker *w, chain *link) {
    chains *c = w->chains;
    const size_t slot = current_slot(link);
    if (pass_is_beside(c->pass)) {
        // Another run may have computed the point itself, and has its block.
        if (c->table->done[slot]) set_beside(w, slot);
    } else {
        if (c->ends && c->pass->round == 0)
            memcpy(c->ends + slot * c->run->dimension, w->end, c->run->dimension * sizeof *w->end);
        c->table->done[slot] = 1;
    }
    link->done++;
    room_pass(c->batch->room, w->finished);
    room_pass(c->table->room, w->finished);
    room_pass(c->run->room, w->finished++);
}

// ---------------------------------------------------------------- points that are kept

static size_t keeper_number(const chains *c) {
    return pass_number(c->run, c->pass);
}

/// Journal entry of a point: its block or its second verdict; and states if carried points need them.
static kept_point kept_at(const worker *w, size_t slot) {
    const chains *c = w->chains;
    const bool beside = pass_is_beside(c->pass);
    return (kept_point){.batch = keeper_number(c),
                        .slot = slot,
                        .block = beside ? w->other : chains_block_of(w, slot),
                        .size = beside ? c->other.size : c->table->layout.size,
                        .end = w->end,
                        .dimension = beside || c->pass->round > 0 ? 0 : c->run->dimension};
}

/// Recalls the next point of a chain from the journal, if it is there.
static bool chains_recall(worker *w, chain *link) {
    chains *c = w->chains;
    const kept_point point = kept_at(w, current_slot(link));
    if (!keeper_recall(c->run->keeper, &point)) return false;
    finish_point(w, link);
    tracker_recall(&c->run->tracker, c->revolutions, 1);
    return true;
}

// ---------------------------------------------------------------- points that are computed

/// Takes a chain with a point that must be computed, or NULL.
static chain *take_unknown(worker *w) {
    for (;;) {
        chain *link = take_ready(w);
        if (!link) return link;
        while (link->done < link->length && chains_recall(w, link)) {
        }
        const bool gathering = w->chains->run->gathering && !w->chains->pass->anew;
        if (link->done < link->length && !gathering) return link;
        chains_leave(w->chains, link, gathering);
    }
}

// ---------------------------------------------------------------- motions under way

static bool save_is_wanted(void *context) {
    const worker *w = context;
    return clock_seconds() >= w->save_at;
}

/// Saves motions that have run for some time; shorter ones are cheaper to repeat.
static void save_states(void *context, const whirl_motion_state *states, size_t count) {
    worker *w = context;
    const chains *c = w->chains;
    const double begun = clock_seconds();
    whirl_kept_state *kept = calloc(count, sizeof *kept);
    size_t long_ones = 0;
    for (size_t i = 0; kept && i < count; i++) {
        const chain *link = states[i].task->tag;
        if (begun - link->begun < save_interval) continue;
        kept[long_ones++] = (whirl_kept_state){keeper_number(c), current_slot(link), states[i].revolutions,
                                               states[i].bytes, states[i].size};
    }
    keeper_save(c->run->keeper, w->number, kept, long_ones);
    free(kept);
    // Large states on a slow disk are saved less often, so that saving takes at most a twentieth of the time.
    const double now = clock_seconds();
    w->save_at = now + fmax(save_interval, 20.0 * (now - begun));
}

static void *saved_state(void *context, const whirl_task *task, size_t *size) {
    const worker *w = context;
    const chains *c = w->chains;
    double revolutions = 0.0;
    void *bytes = keeper_saved(c->run->keeper, keeper_number(c), current_slot(task->tag), &revolutions, size);
    if (bytes) tracker_recall(&c->run->tracker, c->weight * revolutions, 0);
    return bytes;
}

// ---------------------------------------------------------------- the source of a recorder

static whirl_status machine_at(const chains *c, size_t slot, whirl_machine *machine) {
    const size_t point = c->batch->starts > 1 ? slot : slot % c->batch->count;
    return whirl_study_machine(c->run->study, c->batch, point, machine);
}

/// Returns the chain to be recorded next, with its machine and start; NULL if there is none, or if an error is noted.
static chain *take_machine(worker *w) {
    const chains *c = w->chains;
    if (w->unlike) return w->unlike;
    chain *link = pass_time_is_over(c->run) ? NULL : take_unknown(w);
    if (!link) return NULL;
    const size_t slot = current_slot(link);
    w->status = machine_at(c, slot, &link->machine);
    if (w->status.code == WHIRL_OK) w->status = whirl_ensemble_check(w->first.system, link->machine.system);
    if (w->status.code == WHIRL_OK && c->pass->copy > 0) {
        link->start = pass_copy_start(c->run, c->pass, slot);
        if (!link->start) w->status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    }
    if (w->status.code == WHIRL_OK) return link;
    chains_drop(link);
    return NULL;
}

static bool chains_next(void *context, whirl_task *task) {
    worker *w = context;
    const chains *c = w->chains;
    if (w->status.code != WHIRL_OK || atomic_load(&c->run->tracker.halt)) return false;
    chain *link = take_machine(w);
    // A machine of another structure waits until those under way are done: a recorder takes machines of one structure.
    w->unlike = link && !whirl_ensemble_alike(w->first.system, link->machine.system) ? link : NULL;
    if (!link || w->unlike) return false;
    const double *carried = link->start ? link->start : carried_start(c, current_slot(link));
    w->under_way++;
    link->begun = clock_seconds();
    link->from = carried ? carried : link->machine.start;
    *task = (whirl_task){link->machine.system, link->from, link};
    return true;
}

/// Computes the block of a point, or its verdict at the second tolerance.
static whirl_status chains_analyze(const worker *w, const chain *link, const whirl_record *record) {
    const chains *c = w->chains;
    const pass *p = c->pass;
    const size_t slot = current_slot(link);
    const beginning start = {slot, pass_origin(c->run, p->batch, slot), link->from};
    double *block = chains_block_of(w, slot);
    if (pass_is_beside(p)) {
        const whirl_status beside =
            whirl_analyze(record, &p->record, chains_compared(p, c->batch), &c->other, w->other);
        if (beside.code != WHIRL_OK || !p->confirming) return beside;
        const whirl_system *system = link->machine.system;
        const whirl_status sought = whirl_block_seek_refuge(&c->other, w->other, system, &p->integrate, record);
        if (sought.code != WHIRL_OK) return sought;
        return whirl_block_survive(&c->other, w->other, system, &p->integrate, record);
    }
    const double spent = p->round > 0 ? refine_spent(&c->table->layout, block) + c->weight * record->revolutions : 0.0;
    const whirl_status status = whirl_analyze(record, &p->record, c->batch->analyses, &c->table->layout, block);
    map_note(c->batch, slot % c->batch->count, &c->table->layout, block);
    starts_note(c->batch, &start, link->machine.system, &c->table->layout, block);
    refine_note(&c->table->layout, block, p, spent);
    return status;
}

static whirl_status chains_done(void *context, const whirl_task *task, whirl_record *record) {
    worker *w = context;
    chains *c = w->chains;
    chain *link = task->tag;
    const size_t slot = current_slot(link);
    const bool bounded = record->motion == WHIRL_BOUNDED;
    for (size_t i = 0; i < c->run->dimension; i++) w->end[i] = bounded ? record->end[i] : (double)NAN;
    whirl_status status = chains_analyze(w, link, record);
    const kept_point point = kept_at(w, slot);
    if (status.code == WHIRL_OK) status = keeper_keep(c->run->keeper, &point);
    // Revolutions that a motion saved by settling or diverging count as done.
    w->pending += c->revolutions - c->weight * record->revolutions;
    whirl_record_free(record);
    w->under_way--;
    if (status.code != WHIRL_OK) {
        chains_drop(link);
        return status;
    }
    chains_release(link);
    finish_point(w, link);
    chains_leave(c, link, false);
    tracker_advance(&c->run->tracker, 0.0, 1);
    return status;
}

static void chains_abandon(void *context, const whirl_task *task) {
    (void)context;
    chains_drop(task->tag);
}

/// Revolutions reach the tracker in packets, so that threads seldom meet.
static bool revolution_done(void *context) {
    worker *w = context;
    study_run *run = w->chains->run;
    w->pending += w->chains->weight;
    const double seconds = clock_seconds();
    if (pass_time_is_over(run)) return false;
    if (seconds - w->last < 0.1) return true;
    w->last = seconds;
    const double packet = w->pending;
    w->pending = 0.0;
    const whirl_status status = keeper_tend(run->keeper);
    if (status.code != WHIRL_OK) tracker_fail(&run->tracker, &status);
    return tracker_advance(&run->tracker, packet, 0);
}

/// Switches to machines with the structure of a slot's machine.
static whirl_status turn_to_structure(worker *w, size_t slot) {
    if (w->first.release) w->first.release(w->first.owner);
    w->first = (whirl_machine){0};
    return machine_at(w->chains, slot, &w->first);
}

/// Records one structure's machines after the other, until none is left for this thread.
static whirl_status record_structures(worker *w) {
    const chains *c = w->chains;
    const whirl_motion_saver saver = {save_is_wanted, save_states, saved_state};
    const whirl_keeper *keeper = c->run->keeper;
    const whirl_task_source source = {chains_next, chains_done, chains_abandon, w,
                                      keeper && keeper->save ? &saver : NULL};
    const whirl_monitor monitor = {revolution_done, w};
    whirl_status status = whirl_ok();
    do {
        if (w->unlike) status = turn_to_structure(w, current_slot(w->unlike));
        if (status.code == WHIRL_OK)
            status = whirl_record_motions(w->first.system, &c->pass->integrate, &c->pass->record, &source, &monitor);
        if (status.code == WHIRL_OK) status = w->status;
    } while (status.code == WHIRL_OK && w->unlike && !atomic_load(&c->run->tracker.halt));
    return status;
}

whirl_status chains_work(chains *c, size_t number) {
    const double now = clock_seconds();
    worker w = {.chains = c, .last = now, .number = number, .save_at = now + save_interval};
    whirl_status status = turn_to_structure(&w, 0);
    if (status.code != WHIRL_OK) return status;
    w.end = calloc(c->run->dimension + c->other.size + c->table->layout.size, sizeof *w.end);
    if (w.end) {
        w.other = w.end + c->run->dimension;
        w.block = w.other + c->other.size;
        status = record_structures(&w);
    } else {
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    }
    if (w.unlike) chains_drop(w.unlike);
    free(w.end);
    if (w.first.release) w.first.release(w.first.owner);
    tracker_advance(&c->run->tracker, w.pending, 0);
    return w.status.code != WHIRL_OK ? w.status : status;
}
