// Points that no recorder follows: machines at rest, and run-ups.
#include "kinds.h"
#include "pass.h"

#include <errno.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "batch_points.h"
#include "clock.h"
#include "deal.h"
#include "derived.h"
#include "record_fields.h"
#include "run_journal.h"
#include "study_run.h"
#include "tracker.h"
#include "whirl/engine/study.h"

/// Number of points that a thread, or a share, computes together: each of them uses the modes of the point before it.
enum { RESTING_PIECE = 8 };

/// Most run-ups that a thread carries together.
enum { RUNS_TOGETHER = 64 };

struct long_points;

/// A long point: a run-up, which reports its progress and is saved.
typedef struct long_point {
    study_run *run;
    struct long_points *all;
    size_t batch, slot;
    double revolutions; ///< revolutions of the study that the point counts as
    double share;       ///< share of them that was reported
    bool continued;     ///< a saved state was read, and nothing was reported since
    double reported;    ///< s, when progress was reported (clock_seconds)
    bool collected;     ///< its state for the next save was collected (long_points.collecting)
    void *bytes;        ///< [size] the latest state; NULL: none
    size_t size;
    double turns; ///< completed turns in that state
} long_point;

/// The long points that a thread computes together. The journal keeps the states of all of them at once: one state of
/// each point is collected, and all are saved when a point offers a second one.
typedef struct long_points {
    study_run *run;
    size_t thread, count;
    bool collecting;
    double begun, save_at; ///< s, when collecting began, and when it is to begin
    long_point points[RUNS_TOGETHER];
} long_points;

/// A thread that works at pieces.
typedef struct worker {
    study_run *run;
    const pass *pass;
    whirl_batch own;          ///< copy of the batch, with the machine of the sample that is being computed
    const whirl_batch *batch; ///< the copy, with the placed unbalances
    whirl_table *table;
    bool has_modes;
    resting_machine before; ///< the point before, if it is known
    known_rests rests;      ///< equilibria of this and the neighbouring points
    whirl_critical *found;  ///< [most]
    size_t most, count;
    double *block;       ///< block of the present point, if the table does not hold blocks: the journal does
    size_t thread;       ///< number of the thread
    long_points lasting; ///< the points that are being computed
} worker;

static double *resting_block_of(const worker *w, size_t slot) {
    return w->table->blocks ? w->table->blocks + slot * w->table->layout.size : w->block;
}

/// Notes that a point is finished; `share` of it was reported before.
static void resting_finish(const worker *w, size_t slot, double share, bool recalled) {
    const double revolutions = pass_revolutions(w->run, w->pass);
    w->table->done[slot] = 1;
    if (recalled)
        tracker_recall(&w->run->tracker, revolutions, 1);
    else
        tracker_advance(&w->run->tracker, (1.0 - share) * revolutions, 1);
}

// ---------------------------------------------------------------- long points

/// Reports the share of a point that is done, a few times a second.
static void long_point_passed(void *watcher, double time, double share) {
    enum { REPORTS = 10 }; // a second
    long_point *own = watcher;
    const double now = clock_seconds(), more = own->revolutions * (share - own->share);
    (void)time;
    if (!own->continued && now - own->reported < 1.0 / REPORTS) return;
    if (own->continued)
        tracker_recall(&own->run->tracker, more, 0);
    else
        tracker_advance(&own->run->tracker, more, 0);
    own->continued = false;
    own->reported = now;
    own->share = share;
}

/// Saves the latest states of all long points.
static void long_points_save(long_points *all) {
    whirl_point_state states[RUNS_TOGETHER];
    size_t count = 0;
    for (size_t i = 0; i < all->count; i++) {
        const long_point *own = &all->points[i];
        if (own->bytes) states[count++] = (whirl_point_state){own->batch, own->slot, own->turns, own->bytes, own->size};
    }
    run_journal_save(all->run->journal, all->thread, states, count);
    all->save_at = save_next(all->begun, clock_seconds());
    all->collecting = false;
}

static bool long_point_is_due(void *context) {
    const long_point *own = context;
    long_points *all = own->all;
    const double now = clock_seconds();
    if (all->collecting && own->collected) long_points_save(all);
    if (!all->collecting && now >= all->save_at) {
        all->collecting = true;
        all->begun = now;
        for (size_t i = 0; i < all->count; i++) all->points[i].collected = false;
    }
    return all->collecting && !own->collected;
}

static void long_point_collect(void *context, double turns, const void *bytes, size_t size) {
    long_point *own = context;
    void *copy = realloc(own->bytes, size);
    own->collected = true;
    if (!copy) return; // the state before stays
    memcpy(copy, bytes, size);
    own->bytes = copy;
    own->size = size;
    own->turns = turns;
    // A single point need not wait for others.
    if (own->all->count == 1) long_points_save(own->all);
}

/// Begins to compute long points.
static void long_points_begin(worker *w) {
    w->lasting.run = w->run;
    w->lasting.thread = w->thread;
    w->lasting.count = 0;
    w->lasting.collecting = false;
    w->lasting.save_at = clock_seconds() + save_interval;
}

static void long_points_end(long_points *all) {
    for (size_t i = 0; i < all->count; i++) free(all->points[i].bytes);
    all->count = 0;
}

/// Adds a point that may be long. If a state of it was saved, the point owns a copy of that state and continues from
/// it.
static whirl_saving long_point_begin(worker *w, size_t slot) {
    long_point *own = &w->lasting.points[w->lasting.count++];
    *own = (long_point){.run = w->run,
                        .all = &w->lasting,
                        .batch = pass_number(w->run, w->pass),
                        .slot = slot,
                        .revolutions = pass_revolutions(w->run, w->pass),
                        .reported = clock_seconds()};
    whirl_saving made = {.context = own, .save = long_point_collect};
    if (run_journal_saves(w->run->journal)) made.due = long_point_is_due;
    own->bytes = run_journal_state(w->run->journal, own->batch, slot, &own->turns, &own->size);
    own->continued = own->bytes != NULL;
    made.saved = own->bytes;
    made.saved_size = own->size;
    return made;
}

// ---------------------------------------------------------------- points

static journal_entry resting_entry(const worker *w, size_t slot, double *block) {
    return (journal_entry){.batch = w->pass->batch, .slot = slot, .block = block, .size = w->table->layout.size};
}

static whirl_status resting_keep(const worker *w, size_t slot, double *block) {
    const journal_entry entry = resting_entry(w, slot, block);
    const whirl_status status = run_journal_write(w->run->journal, &entry);
    return status.code == WHIRL_OK ? run_journal_sync(w->run->journal) : status;
}

/// Returns true for a point that has no point before it: the first one, and the first one of every machine of samples.
static bool resting_is_first(const worker *w, size_t slot) {
    return w->batch->tolerances.samples > 0 && w->batch->row > 0 ? slot % w->batch->row == 0 : slot == 0;
}

/// Locates critical speeds between the point before (w->before) and this one. Does nothing if the equilibrium is lost
/// in between.
static whirl_status resting_locate(worker *w, size_t slot, resting_machine *own) {
    whirl_status status = whirl_ok();
    w->count = 0;
    if (resting_is_first(w, slot)) return status;
    if (!w->before.modes) status = resting_new(w->run->study, w->batch, w->table->values[slot - 1], &w->before);
    if (status.code == WHIRL_OK) status = resting_follow(&w->before, own);
    if (status.code == WHIRL_OK)
        status = critical_locate(w->run->study, w->batch, &w->before, own, w->found, w->most, &w->count);
    if (status.code != WHIRL_NUMERICAL_FAILURE) return status;
    w->count = 0;
    return whirl_ok();
}

/// Returns true if other equilibria are looked for, from those at the values before and after: for machines that turn,
/// unless springs replace their bearings. The records of a data set have no order of values.
static bool looks_elsewhere(const worker *w, const whirl_machine *machine) {
    if (w->batch->dataset) return false;
    const size_t points = w->batch->tolerances.samples > 0 ? w->batch->row : w->table->count;
    return points > 1 && machine->speed != 0.0 && whirl_layout_field(&w->table->layout, WHIRL_FIELD_RANGES_ELSEWHERE);
}

/// Adds to a computed point what is derived from it. Returns its status, which names the place of an error.
static whirl_status resting_complete(const worker *w, const whirl_batch *batch, size_t slot, whirl_status status,
                                     const resting_machine *own, double *block) {
    if (status.code == WHIRL_OK) status = derived_at_rest(w->run->study, batch, own, &w->table->layout, block);
    sample_note(batch, slot, &w->table->layout, block);
    // A machine that could not be built has already named its place.
    if (status.code == WHIRL_BAD_INPUT && *batch->parameter && strncmp(status.message, "at ", 3) != 0)
        status = whirl_fail(status.code, "at %s = %.10g: %.300s", batch->parameter, own->value, status.message);
    return status;
}

static whirl_status resting_analyze(worker *w, size_t slot, const resting_machine *own) {
    const resting_place at = {w->run->study, w->batch, own->value};
    const whirl_machine *machine = &own->machine;
    whirl_resting point = resting_point_of(&at, machine);
    point.modes = own->modes;
    point.critical_count = w->count;
    point.critical = w->found;
    point.before = own->before;
    double *elsewhere = NULL;
    whirl_status status = whirl_ok();
    if (looks_elsewhere(w, machine))
        status = elsewhere_find(w->run->study, w->batch, w->table->values, slot, machine, &w->rests, &point.rest,
                                &elsewhere, &point.elsewhere_growth);
    point.elsewhere = elsewhere;
    if (status.code == WHIRL_OK)
        status = whirl_analyze_resting(&point, &w->pass->record, w->batch->analyses, &w->table->layout,
                                       resting_block_of(w, slot));
    free(elsewhere);
    return resting_complete(w, w->batch, slot, status, own, resting_block_of(w, slot));
}

/// Fills the block of a point without an equilibrium: notes how far the equilibrium could be followed.
static whirl_status leave_unfound(const worker *w, const whirl_batch *batch, size_t slot, double *block) {
    whirl_machine machine;
    const whirl_status status = w->run->study->machine(w->run->study->family, batch, w->table->values[slot], &machine);
    if (status.code != WHIRL_OK) return status;
    whirl_unfound_at_rest(&w->table->layout, whirl_equilibrium_share(machine.system, machine.start), block);
    sample_note(batch, slot, &w->table->layout, block);
    const whirl_run_motion none = {.count = 0};
    const whirl_status noted = records_note_run(batch, slot, &machine, &none, &w->table->layout, block);
    if (machine.release) machine.release(machine.owner);
    return noted;
}

static whirl_status resting_compute(worker *w, size_t slot) {
    const double value = w->table->values[slot];
    resting_machine own = {.value = value};
    batch_choose(&w->own, slot);
    whirl_status status = w->has_modes ? resting_new(w->run->study, w->batch, value, &own)
                                       : w->run->study->machine(w->run->study->family, w->batch, value, &own.machine);
    if (status.code == WHIRL_OK && w->has_modes) status = resting_locate(w, slot, &own);
    if (status.code == WHIRL_OK) status = resting_analyze(w, slot, &own);
    if (status.code == WHIRL_NUMERICAL_FAILURE) status = leave_unfound(w, w->batch, slot, resting_block_of(w, slot));
    if (!tracker_advance(&w->run->tracker, 0.0, 0)) { // a point computed after a stop is discarded
        resting_free(&own);
        return whirl_ok();
    }
    if (status.code == WHIRL_OK) status = resting_keep(w, slot, resting_block_of(w, slot));
    resting_free(&w->before);
    w->before = own;
    if (status.code == WHIRL_OK) resting_finish(w, slot, 0.0, false);
    return status;
}

static whirl_status work_at(worker *w, size_t first, size_t end) {
    whirl_status status = whirl_ok();
    for (size_t i = first; i < end && status.code == WHIRL_OK && !atomic_load(&w->run->tracker.halt); i++) {
        const size_t slot = w->pass->slots ? w->pass->slots[i] : i;
        const journal_entry entry = resting_entry(w, slot, resting_block_of(w, slot));
        if (run_journal_read(w->run->journal, &entry)) {
            resting_free(&w->before);
            resting_finish(w, slot, 0.0, true);
        } else if (!w->run->gathering) {
            status = resting_compute(w, slot);
        }
    }
    resting_free(&w->before);
    return status;
}

// ---------------------------------------------------------------- run-ups

/// A run-up among others.
typedef struct run_point {
    size_t slot;
    resting_machine own;
    whirl_batch batch; ///< the batch, with the sample of the point
    resting_place at;
    whirl_saving saving;
    double *block;            ///< its block, if the table does not hold blocks: the journal does; else NULL
    double *rest, *elsewhere; ///< as in whirl_resting
    whirl_run_motion motion;  ///< motion of a record's run, for its sensors
} run_point;

/// Run-ups that are computed together, with the input of their analyses.
typedef struct run_points {
    size_t count;
    run_point points[RUNS_TOGETHER];
    whirl_resting resting[RUNS_TOGETHER]; ///< the points as analyses take them
    double *blocks[RUNS_TOGETHER];
    whirl_status statuses[RUNS_TOGETHER];
} run_points;

/// Returns true if run-ups may be carried in vector lanes: by dop853, without torques over time.
static bool runs_go_together(const worker *w) {
    return strcmp(w->pass->record.runup.method, "dop853") == 0 &&
           !whirl_layout_field(&w->table->layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
}

/// Fills in the input of the analyses of a run-up, with another equilibrium if one is looked for and found.
static whirl_status run_point_describe(worker *w, run_point *p, whirl_resting *point) {
    const whirl_machine *machine = &p->own.machine;
    const size_t bytes = machine->system->dimension * sizeof *p->rest;
    *point = resting_point_of(&p->at, machine);
    whirl_status status = records_run_new(&p->batch, machine, &p->motion);
    if (p->motion.count > 0) point->motion = &p->motion;
    if (status.code != WHIRL_OK || !looks_elsewhere(w, machine)) return status;
    status = elsewhere_find(w->run->study, &p->batch, w->table->values, p->slot, machine, &w->rests, &point->rest,
                            &p->elsewhere, &point->elsewhere_growth);
    if (status.code != WHIRL_OK || !point->rest) return status;
    // Copy the equilibrium: the next point replaces the known ones.
    p->rest = malloc(bytes);
    if (!p->rest) return whirl_fail(WHIRL_NO_MEMORY, "no memory for points at rest");
    memcpy(p->rest, point->rest, bytes);
    point->rest = p->rest;
    point->elsewhere = p->elsewhere;
    return status;
}

/// Makes the machine of a run-up. An error of the machine becomes the status of the run-up.
static whirl_status run_point_begin(worker *w, run_points *all, size_t slot) {
    const size_t i = all->count++;
    run_point *p = &all->points[i];
    *p = (run_point){.slot = slot, .own = {.value = w->table->values[slot]}, .batch = w->own};
    batch_choose(&p->batch, slot);
    p->at = (resting_place){w->run->study, &p->batch, p->own.value};
    p->saving = long_point_begin(w, slot);
    if (!w->table->blocks) p->block = calloc(w->table->layout.size + 1, sizeof *p->block);
    if (!w->table->blocks && !p->block) return whirl_fail(WHIRL_NO_MEMORY, "no memory for points at rest");
    all->blocks[i] = p->block ? p->block : resting_block_of(w, slot);
    all->statuses[i] = w->run->study->machine(w->run->study->family, &p->batch, p->own.value, &p->own.machine);
    if (all->statuses[i].code == WHIRL_OK) all->statuses[i] = run_point_describe(w, p, &all->resting[i]);
    all->resting[i].saving = &p->saving;
    all->resting[i].passed = long_point_passed;
    all->resting[i].watcher = &w->lasting.points[i];
    return whirl_ok();
}

/// Keeps a run-up that was computed.
static whirl_status run_point_end(const worker *w, run_points *all, size_t i) {
    run_point *p = &all->points[i];
    whirl_status status = all->statuses[i];
    if (status.code == WHIRL_OK)
        status = records_note_run(&p->batch, p->slot, &p->own.machine, &p->motion, &w->table->layout, all->blocks[i]);
    status = resting_complete(w, &p->batch, p->slot, status, &p->own, all->blocks[i]);
    if (status.code == WHIRL_NUMERICAL_FAILURE) status = leave_unfound(w, &p->batch, p->slot, all->blocks[i]);
    if (!tracker_advance(&w->run->tracker, 0.0, 0)) return whirl_ok(); // points computed after a stop are discarded
    if (status.code == WHIRL_OK) status = resting_keep(w, p->slot, all->blocks[i]);
    if (status.code == WHIRL_OK) resting_finish(w, p->slot, w->lasting.points[i].share, false);
    return status;
}

/// Computes the run-ups of slots [count].
static whirl_status runs_compute(worker *w, const size_t *slots, size_t count) {
    run_points *all = calloc(1, sizeof *all);
    if (!all) return whirl_fail(WHIRL_NO_MEMORY, "no memory for points at rest");
    whirl_status status = whirl_ok();
    long_points_begin(w);
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) status = run_point_begin(w, all, slots[i]);
    if (status.code == WHIRL_OK)
        status = whirl_analyze_resting_together(all->count, all->resting, &w->pass->record, w->batch->analyses,
                                                &w->table->layout, all->blocks, all->statuses);
    // The first error counts, whatever the others are.
    for (size_t i = 0; i < all->count && status.code == WHIRL_OK; i++) status = run_point_end(w, all, i);
    for (size_t i = 0; i < all->count; i++) {
        resting_free(&all->points[i].own);
        records_run_free(&all->points[i].motion);
        free(all->points[i].block);
        free(all->points[i].rest);
        free(all->points[i].elsewhere);
    }
    long_points_end(&w->lasting);
    free(all);
    return tracker_advance(&w->run->tracker, 0.0, 0) ? status : whirl_ok(); // a stop is no error
}

/// Takes this thread's share of the points that no thread has begun, or one point if they are computed one after the
/// other. Returns the number of points.
static size_t runs_take(const worker *w, deal *pieces, size_t *slots) {
    size_t count = 0, piece;
    const size_t threads = (size_t)pieces->threads, fair = (deal_left(pieces) + threads - 1) / threads;
    const size_t limit =
        records_run_limit(w->batch, w->run->result->station_count, runs_go_together(w) ? RUNS_TOGETHER : 1);
    const size_t most = fair > limit ? limit : fair;
    while (count < most && deal_take(pieces, &piece)) slots[count++] = w->pass->slots ? w->pass->slots[piece] : piece;
    return count;
}

/// Computes run-ups until none is left.
static whirl_status work_at_runs(worker *w, deal *pieces) {
    whirl_status status = whirl_ok();
    while (status.code == WHIRL_OK && !atomic_load(&w->run->tracker.halt)) {
        size_t slots[RUNS_TOGETHER], taken, left = 0;
#pragma omp critical(whirl_resting)
        taken = runs_take(w, pieces, slots);
        if (taken == 0) break;
        // Read those that are in the journal.
        for (size_t i = 0; i < taken; i++) {
            const journal_entry entry = resting_entry(w, slots[i], resting_block_of(w, slots[i]));
            if (run_journal_read(w->run->journal, &entry))
                resting_finish(w, slots[i], 0.0, true);
            else
                slots[left++] = slots[i];
        }
        if (left > 0 && !w->run->gathering) status = runs_compute(w, slots, left);
    }
    return status;
}

/// Computes pieces of points until none is left.
static whirl_status work_at_pieces(worker *w, deal *pieces, size_t size) {
    whirl_status status = whirl_ok();
    while (status.code == WHIRL_OK && !atomic_load(&w->run->tracker.halt)) {
        size_t piece = 0;
        bool taken;
#pragma omp critical(whirl_resting)
        taken = deal_take(pieces, &piece);
        if (!taken) break;
        // If other runs compute a part of the points, w->pass->slots lists this run's: whole pieces of the same size.
        const size_t first = piece * size, after = first + size;
        status = work_at(w, first, after < w->pass->count ? after : w->pass->count);
    }
    return status;
}

/// Returns the number of points of a piece. A run-up is a piece by itself: what its neighbours could provide saves
/// little.
static size_t resting_piece(const whirl_batch *batch) {
    return whirl_analysis_has(batch->analyses, "runup") ? 1 : RESTING_PIECE;
}

static whirl_status resting_work(study_run *run, const pass *p) {
    // All threads take pieces; neighbours stay together, since one starts from the equilibrium of the other.
    const size_t piece = resting_piece(&run->study->batches[p->batch]);
    deal pieces = deal_begin(run, p, (p->count + piece - 1) / piece);
    const bool runs = whirl_analysis_has(run->study->batches[p->batch].analyses, "runup");
#pragma omp parallel num_threads(run->threads)
    {
        errno = 0;
        worker w = {.run = run,
                    .pass = p,
                    .own = run->study->batches[p->batch],
                    .table = &run->result->tables[p->batch],
                    .thread = (size_t)omp_get_thread_num(),
                    .most = (size_t)p->record.modes + 1};
        w.batch = &w.own;
        w.has_modes = whirl_analysis_has(w.batch->analyses, "modes");
        w.found = calloc(w.most, sizeof *w.found);
        w.block = calloc(w.table->layout.size + 1, sizeof *w.block);
        whirl_status status =
            w.found && w.block ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for points at rest");
        if (status.code == WHIRL_OK) status = runs ? work_at_runs(&w, &pieces) : work_at_pieces(&w, &pieces, piece);
        known_rests_free(&w.rests);
        free(w.found);
        free(w.block);
        if (status.code != WHIRL_OK) tracker_fail(&run->tracker, &status);
    }
    return whirl_ok();
}

const study_kind rest_kind = {.name = "rest", .piece = RESTING_PIECE, .piece_of = resting_piece, .work = resting_work};
