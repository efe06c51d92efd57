// Points of machines at rest, whose motion is not followed.
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

/// A long point: a run-up, which reports its progress and is saved.
typedef struct long_point {
    study_run *run;
    size_t batch, slot, thread;
    double revolutions;       ///< revolutions of the study that the point counts as
    double share;             ///< share of them that was reported
    bool continued;           ///< a saved state was read, and nothing was reported since
    double reported, save_at; ///< s, when progress was reported, and when the state is to be saved (clock_seconds)
} long_point;

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
    double *block;      ///< block of a point whose block stays in the journal
    size_t thread;      ///< number of the thread
    long_point lasting; ///< the point that is being computed
} worker;

static double *resting_block_of(const worker *w, size_t slot) {
    return w->table->blocks ? w->table->blocks + slot * w->table->layout.size : w->block;
}

static void resting_finish(const worker *w, size_t slot, bool recalled) {
    const double revolutions = pass_revolutions(w->run, w->pass);
    w->table->done[slot] = 1;
    if (recalled)
        tracker_recall(&w->run->tracker, revolutions, 1);
    else
        tracker_advance(&w->run->tracker, (1.0 - w->lasting.share) * revolutions, 1);
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

static bool long_point_is_due(void *context) {
    const long_point *own = context;
    return clock_seconds() >= own->save_at;
}

static void long_point_save(void *context, double turns, const void *bytes, size_t size) {
    long_point *own = context;
    const double begun = clock_seconds();
    const whirl_point_state state = {own->batch, own->slot, turns, bytes, size};
    run_journal_save(own->run->journal, own->thread, &state, 1);
    own->save_at = save_next(begun, clock_seconds());
}

/// Begins a point that may be long: from its saved state if there is one.
static whirl_saving long_point_begin(worker *w, size_t slot) {
    const double now = clock_seconds();
    double turns;
    whirl_saving made = {.context = &w->lasting, .save = long_point_save};
    w->lasting = (long_point){.run = w->run,
                              .batch = pass_number(w->run, w->pass),
                              .slot = slot,
                              .thread = w->thread,
                              .revolutions = pass_revolutions(w->run, w->pass),
                              .reported = now,
                              .save_at = now + save_interval};
    if (run_journal_saves(w->run->journal)) made.due = long_point_is_due;
    made.saved = run_journal_state(w->run->journal, w->lasting.batch, slot, &turns, &made.saved_size);
    w->lasting.continued = made.saved != NULL;
    return made;
}

// ---------------------------------------------------------------- points

static journal_entry resting_entry(const worker *w, size_t slot) {
    return (journal_entry){
        .batch = w->pass->batch, .slot = slot, .block = resting_block_of(w, slot), .size = w->table->layout.size};
}

static whirl_status resting_keep(const worker *w, size_t slot) {
    const journal_entry entry = resting_entry(w, slot);
    const whirl_status status = run_journal_write(w->run->journal, &entry);
    return status.code == WHIRL_OK ? run_journal_sync(w->run->journal) : status;
}

/// Returns true for a point without one before it: the first, and the first of every machine of samples.
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

/// Returns true if other equilibria are looked for: for turning machines with their own bearings, from one value to the
/// next. Records are no such values.
static bool looks_elsewhere(const worker *w, const whirl_machine *machine) {
    if (w->batch->dataset) return false;
    const size_t points = w->batch->tolerances.samples > 0 ? w->batch->row : w->table->count;
    return points > 1 && machine->speed != 0.0 && whirl_layout_field(&w->table->layout, WHIRL_FIELD_RANGES_ELSEWHERE);
}

static whirl_status resting_analyze(worker *w, size_t slot, const resting_machine *own) {
    const resting_place at = {w->run->study, w->batch, own->value};
    const whirl_machine *machine = &own->machine;
    whirl_resting point = resting_point_of(&at, machine);
    const whirl_saving saving = long_point_begin(w, slot);
    point.saving = &saving;
    point.passed = long_point_passed;
    point.watcher = &w->lasting;
    point.modes = own->modes;
    point.critical_count = w->count;
    point.critical = w->found;
    point.before = own->before;
    double *elsewhere = NULL;
    // The run of a record has options of its own, and a motion that sensors see.
    whirl_record_options options = w->pass->record;
    whirl_run_motion motion;
    if (machine->run) options.runup = *machine->run;
    whirl_status status = records_run_new(w->batch, machine, &motion);
    if (motion.count > 0) point.motion = &motion;
    if (status.code == WHIRL_OK && looks_elsewhere(w, machine))
        status = elsewhere_find(w->run->study, w->batch, w->table->values, slot, machine, &w->rests, &point.rest,
                                &elsewhere, &point.elsewhere_growth);
    point.elsewhere = elsewhere;
    if (status.code == WHIRL_OK)
        status =
            whirl_analyze_resting(&point, &options, w->batch->analyses, &w->table->layout, resting_block_of(w, slot));
    if (status.code == WHIRL_OK)
        status = records_note_run(w->batch, slot, machine, &motion, &w->table->layout, resting_block_of(w, slot));
    records_run_free(&motion);
    free(elsewhere);
    free(saving.saved);
    if (status.code == WHIRL_OK)
        status = derived_at_rest(w->run->study, w->batch, own, &w->table->layout, resting_block_of(w, slot));
    sample_note(w->batch, slot, &w->table->layout, resting_block_of(w, slot));
    // A machine that could not be built has already named its place.
    if (status.code == WHIRL_BAD_INPUT && *w->batch->parameter && strncmp(status.message, "at ", 3) != 0)
        status = whirl_fail(status.code, "at %s = %.10g: %.300s", w->batch->parameter, own->value, status.message);
    return status;
}

/// Fills the block of a point without an equilibrium: notes how far the equilibrium could be followed.
static whirl_status leave_unfound(worker *w, size_t slot) {
    whirl_machine machine;
    const whirl_status status =
        w->run->study->machine(w->run->study->family, w->batch, w->table->values[slot], &machine);
    if (status.code != WHIRL_OK) return status;
    whirl_unfound_at_rest(&w->table->layout, whirl_equilibrium_share(machine.system, machine.start),
                          resting_block_of(w, slot));
    sample_note(w->batch, slot, &w->table->layout, resting_block_of(w, slot));
    const whirl_run_motion none = {.count = 0};
    const whirl_status noted =
        records_note_run(w->batch, slot, &machine, &none, &w->table->layout, resting_block_of(w, slot));
    if (machine.release) machine.release(machine.owner);
    return noted;
}

static whirl_status resting_compute(worker *w, size_t slot) {
    const double value = w->table->values[slot];
    resting_machine own = {.value = value};
    w->lasting.share = 0.0;
    if (w->own.tolerances.samples > 0) w->own.sampled = 1 + (w->own.row > 0 ? slot / w->own.row : 0);
    if (w->own.dataset) w->own.sampled = 1 + slot;
    whirl_status status = w->has_modes ? resting_new(w->run->study, w->batch, value, &own)
                                       : w->run->study->machine(w->run->study->family, w->batch, value, &own.machine);
    if (status.code == WHIRL_OK && w->has_modes) status = resting_locate(w, slot, &own);
    if (status.code == WHIRL_OK) status = resting_analyze(w, slot, &own);
    if (status.code == WHIRL_NUMERICAL_FAILURE) status = leave_unfound(w, slot);
    if (!tracker_advance(&w->run->tracker, 0.0, 0)) { // a point computed after a stop is discarded
        resting_free(&own);
        return whirl_ok();
    }
    if (status.code == WHIRL_OK) status = resting_keep(w, slot);
    resting_free(&w->before);
    w->before = own;
    if (status.code == WHIRL_OK) resting_finish(w, slot, false);
    return status;
}

static whirl_status work_at(worker *w, size_t first, size_t end) {
    whirl_status status = whirl_ok();
    for (size_t i = first; i < end && status.code == WHIRL_OK && !atomic_load(&w->run->tracker.halt); i++) {
        const size_t slot = w->pass->slots ? w->pass->slots[i] : i;
        const journal_entry entry = resting_entry(w, slot);
        if (run_journal_read(w->run->journal, &entry)) {
            resting_free(&w->before);
            resting_finish(w, slot, true);
        } else if (!w->run->gathering) {
            status = resting_compute(w, slot);
        }
    }
    resting_free(&w->before);
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
        // Slots of a share, or dealt slots, come in the same pieces.
        const size_t first = piece * size, after = first + size;
        status = work_at(w, first, after < w->pass->count ? after : w->pass->count);
    }
    return status;
}

/// A run over time is a piece by itself: what its neighbours have to tell costs little beside it.
static size_t resting_piece(const whirl_batch *batch) {
    whirl_analysis_set runs = 0;
    whirl_analysis_add(&runs, "runup");
    return (batch->analyses & runs) != 0 ? 1 : RESTING_PIECE;
}

static whirl_status resting_work(study_run *run, const pass *p) {
    // All threads take pieces; neighbours stay together, since one starts from the equilibrium of the other.
    const size_t piece = resting_piece(&run->study->batches[p->batch]);
    deal pieces = deal_begin(run, p, (p->count + piece - 1) / piece);
    whirl_analysis_set modes = 0;
    whirl_analysis_add(&modes, "modes");
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
        w.has_modes = (w.batch->analyses & modes) != 0;
        w.found = calloc(w.most, sizeof *w.found);
        w.block = calloc(w.table->layout.size + 1, sizeof *w.block);
        whirl_status status =
            w.found && w.block ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for points at rest");
        if (status.code == WHIRL_OK) status = work_at_pieces(&w, &pieces, piece);
        known_rests_free(&w.rests);
        free(w.found);
        free(w.block);
        if (status.code != WHIRL_OK) tracker_fail(&run->tracker, &status);
    }
    return whirl_ok();
}

const study_kind rest_kind = {.name = "rest", .piece = RESTING_PIECE, .piece_of = resting_piece, .work = resting_work};
