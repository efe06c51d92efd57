// The main loop of a run: all threads compute the points of passes.
//
//     for each pass, on every thread:                    passes_work, worker_compute
//         while motions turn:                            worker_record
//             fill free lanes with motions of points     worker_next
//             carry all motions over one revolution      whirl_recorder_revolve (analyze/record/recorder.c)
//             for each finished motion:                  worker_finish
//                 run the analyses into its block
//                 write the block to the journal
//
// A point is a pure function of the study and is written to its own slot of the table, so threads change no result.
// Points that start from one another's ends (a carried sweep) are computed one after the other.
#include "passes.h"
#include "batch_points.h"
#include "deal.h"
#include "derived.h"
#include "kinds.h"
#include "pass.h"
#include "record_fields.h"
#include "refine_fields.h"
#include "run_journal.h"
#include "starts.h"
#include "study_run.h"
#include "whirl/engine/study.h"

#include <errno.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "mapped.h"
#include "whirl/engine/ensemble.h"

/// A point under way, and the number of points that follow it, each from the end of the previous one.
typedef struct point {
    size_t slot;           ///< slot of the batch's table
    bool reverse;          ///< the next point has the previous slot
    size_t left;           ///< points from this one on
    double begun;          ///< time at which it began (clock_seconds)
    whirl_machine machine; ///< machine of the point
    double *copy_start;    ///< initial state of a perturbed copy, or NULL
    const double *from;    ///< [dimension] initial state of its motion
} point;

/// A pass under way, shared by all workers.
typedef struct pass_work {
    study_run *run;
    const pass *pass;
    const whirl_batch *batch;
    whirl_table *table;
    double *ends;               ///< the batch's ends, or NULL
    double weight, revolutions; ///< cost of a revolution; revolutions of a point
    whirl_layout other;         ///< layout of a verdict that is compared with the point's
    deal deal;                  ///< points that no worker has begun
    size_t ready_count;
    point **ready;    ///< points whose predecessor is done, and that no worker has taken
    size_t under_way; ///< points that workers have taken and not finished
} pass_work;

/// A thread that works at a pass.
typedef struct worker {
    pass_work *work;
    whirl_machine first;  ///< its structure is that of all machines in the recorder
    point *unlike;        ///< a point whose machine has another structure, waiting for a recorder of its own; or NULL
    size_t under_way;     ///< points
    double *end;          ///< [dimension] end of a point's motion
    double *other;        ///< [other.size] a verdict that is compared with the point's
    double *block;        ///< [layout.size] block of a point whose block stays in the journal
    whirl_status status;  ///< first error of a point that could not begin; points under way are still finished
    double pending, last; ///< revolutions not yet reported to the tracker, and the time of the last report
    size_t number;        ///< number of the thread
    double save_at;       ///< time at which motions under way are saved next
    size_t finished;      ///< points
} worker;

// ---------------------------------------------------------------- a pass

/// Analyses of a pass whose verdicts are compared with those of the points: the regime and, at the second tolerance,
/// the requested exponents.
static whirl_analysis_set compared_analyses(const pass *p, const whirl_batch *batch) {
    static const char *const names[] = {"regime", "lyapunov", "exponents"};
    const size_t count = p->confirming ? sizeof names / sizeof *names : 1;
    whirl_analysis_set set = 0;
    for (size_t i = 0; i < count; i++) whirl_analysis_add(&set, names[i]);
    return set & batch->analyses;
}

/// Makes the layout of these analyses.
static whirl_status make_other_layout(pass_work *w) {
    whirl_batch first = *w->batch;
    whirl_machine machine;
    first.outline = true;
    whirl_status status = whirl_study_machine(w->run->study, &first, 0, &machine);
    if (status.code != WHIRL_OK) return status;
    status = whirl_layout_new(machine.system, &w->pass->integrate, &w->pass->record,
                              compared_analyses(w->pass, w->batch), &w->other);
    if (machine.release) machine.release(machine.owner);
    return status;
}

static whirl_status pass_work_new(pass_work *w, study_run *run, const pass *p) {
    const whirl_batch *batch = &run->study->batches[p->batch];
    const size_t length = pass_carried(p, batch), count = p->count / length;
    *w = (pass_work){.run = run,
                     .pass = p,
                     .batch = batch,
                     .table = &run->result->tables[p->batch],
                     .ends = run->ends[p->batch],
                     .weight = pass_weight(run, p),
                     .revolutions = pass_revolutions(run, p),
                     .deal = deal_begin(run, p, count)};
    // Points without successors never wait.
    const size_t waiting = length > 1 ? count : 1;
    w->ready = calloc(waiting, sizeof(point *));
    if (!w->ready) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", p->count);
    return pass_is_comparison(p) ? make_other_layout(w) : whirl_ok();
}

static void pass_work_free(pass_work *w) {
    for (size_t i = 0; i < w->ready_count; i++) free(w->ready[i]);
    free(w->ready);
}

// ---------------------------------------------------------------- points are dealt to workers

static void point_release(point *p) {
    if (p->machine.release) p->machine.release(p->machine.owner);
    p->machine = (whirl_machine){0};
    free(p->copy_start);
    p->copy_start = NULL;
}

/// Frees a point that nobody continues.
static void point_free(point *p) {
    point_release(p);
    free(p);
}

/// Begins the next point of the deal; NULL if there is none, or without memory (*no_memory). Points are allocated one
/// by one, so that only those under way take memory.
static point *begin_point(pass_work *w, bool *no_memory) {
    const pass *own = w->pass;
    size_t index;
    if (!deal_take(&w->deal, &index)) return NULL;
    const size_t length = pass_carried(own, w->batch), first = own->slots ? own->slots[index] : index * length;
    const bool reverse = length > 1 && w->table->branch[first] < 0;
    point *p = malloc(sizeof *p);
    if (p) *p = (point){.slot = reverse ? first + length - 1 : first, .reverse = reverse, .left = length};
    *no_memory = !p;
    return p;
}

/// Takes the next point, unless this thread already has its share of the remaining ones: otherwise some threads would
/// end with full lanes while others are idle.
static point *take_ready(worker *w) {
    pass_work *work = w->work;
    const size_t threads = (size_t)work->deal.threads;
    point *taken = NULL;
    bool no_memory = false;
#pragma omp critical(whirl_points)
    {
        const size_t left = work->ready_count + deal_left(&work->deal);
        if (left > 0 && w->under_way < (left + work->under_way + threads - 1) / threads) {
            taken = work->ready_count > 0 ? work->ready[--work->ready_count] : begin_point(work, &no_memory);
            work->under_way += taken != NULL;
        }
    }
    if (no_memory) w->status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a point");
    return taken;
}

/// Releases a point that is done, or is left out: any worker may take its successor, if it has one.
static void leave_point(pass_work *w, point *p, bool left_out) {
    const bool over = left_out || p->left == 0;
#pragma omp critical(whirl_points)
    {
        w->under_way--;
        if (!over) w->ready[w->ready_count++] = p;
    }
    if (over) free(p);
}

// ---------------------------------------------------------------- points are finished

/// Returns the memory for the block of a point.
static double *block_of(const worker *w, size_t slot) {
    const whirl_table *table = w->work->table;
    return table->blocks ? table->blocks + slot * table->layout.size : w->block;
}

/// Makes the journal entry of a point: its block or its second verdict; and states if carried points need them.
static journal_entry entry_of(const worker *w, size_t slot) {
    const pass_work *work = w->work;
    const bool comparison = pass_is_comparison(work->pass);
    return (journal_entry){.batch = pass_number(work->run, work->pass),
                           .slot = slot,
                           .block = comparison ? w->other : block_of(w, slot),
                           .size = comparison ? work->other.size : work->table->layout.size,
                           .end = w->end,
                           .dimension = comparison || work->pass->round > 0 ? 0 : work->run->dimension};
}

/// Compares a second verdict with the point's. Two copies of a point may end at the same time.
static void compare_verdict(const worker *w, size_t slot) {
    const pass_work *work = w->work;
    const whirl_layout *layout = &work->table->layout;
    const whirl_verdict other = whirl_block_verdict(&work->other, w->other);
    const double revolutions = w->other[whirl_layout_field(&work->other, WHIRL_FIELD_REGIME_REVOLUTIONS)->offset];
#pragma omp critical(whirl_compare)
    {
        if (work->pass->confirming) {
            whirl_block_confirm(layout, block_of(w, slot), &other);
            whirl_block_compare_exponents(layout, block_of(w, slot), &work->other, w->other);
        } else {
            whirl_block_follow(layout, block_of(w, slot), &other, revolutions);
        }
        if (work->pass->round > 0) refine_add_spent(layout, block_of(w, slot), work->weight * revolutions);
    }
}

/// Notes a point that was computed or read from the journal, and turns to its successor: w->end or w->other has the
/// pass's result.
static void point_is_done(worker *w, point *p) {
    pass_work *work = w->work;
    const size_t slot = p->slot;
    if (pass_is_comparison(work->pass)) {
        // Another run may have computed the point itself, and has its block.
        if (work->table->done[slot]) compare_verdict(w, slot);
    } else {
        if (work->ends && work->pass->round == 0)
            memcpy(work->ends + slot * work->run->dimension, w->end, work->run->dimension * sizeof *w->end);
        work->table->done[slot] = 1;
    }
    p->left--;
    p->slot += p->reverse ? -(size_t)1 : 1;
    mapped_evict_often(work->batch->mapped, w->finished);
    mapped_evict_often(work->table->mapped, w->finished);
    mapped_evict_often(work->run->mapped, w->finished++);
}

// ---------------------------------------------------------------- points begin

/// Takes a point that must be computed, or NULL. Points that the journal has are done at once.
static point *take_unknown(worker *w) {
    pass_work *work = w->work;
    for (;;) {
        point *p = take_ready(w);
        if (!p) return NULL;
        while (p->left > 0) {
            const journal_entry entry = entry_of(w, p->slot);
            if (!run_journal_read(work->run->journal, &entry)) break;
            point_is_done(w, p);
            tracker_recall(&work->run->tracker, work->revolutions, 1);
        }
        const bool gathering = work->run->gathering && !work->pass->anew;
        if (p->left > 0 && !gathering) return p;
        leave_point(work, p, gathering);
    }
}

static whirl_status machine_at(const pass_work *w, size_t slot, whirl_machine *machine) {
    const size_t index = w->batch->starts > 1 ? slot : slot % w->batch->count;
    return whirl_study_machine(w->run->study, w->batch, index, machine);
}

/// Returns the start of a point that continues another one's motion. A carried point: the end of the point before it,
/// NULL without one or if that diverged. A start from a neighbour: the end of the motion there.
static const double *carried_start(const pass_work *w, size_t slot) {
    const size_t origin = pass_origin(w->run, w->pass->batch, slot);
    if (origin != slot) return w->ends + origin * w->run->dimension;
    if (w->batch->carry == WHIRL_CARRY_NONE) return NULL;
    const size_t first = slot / w->batch->count * w->batch->count;
    const bool reverse = w->table->branch[slot] < 0;
    if (slot == (reverse ? first + w->batch->count - 1 : first)) return NULL;
    const double *end = w->ends + (reverse ? slot + 1 : slot - 1) * w->run->dimension;
    return isnan(end[0]) ? NULL : end;
}

/// Returns the point to be recorded next, with its machine; NULL if there is none, or if an error is noted.
static point *take_machine(worker *w) {
    const pass_work *work = w->work;
    if (w->unlike) return w->unlike;
    point *p = pass_time_is_over(work->run) ? NULL : take_unknown(w);
    if (!p) return NULL;
    w->status = machine_at(work, p->slot, &p->machine);
    if (w->status.code == WHIRL_OK) w->status = whirl_ensemble_check(w->first.system, p->machine.system);
    if (w->status.code == WHIRL_OK && work->pass->copy > 0) {
        p->copy_start = pass_copy_start(work->run, work->pass, p->slot);
        if (!p->copy_start) w->status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    }
    if (w->status.code == WHIRL_OK) return p;
    point_free(p);
    return NULL;
}

/// Gives the next point to the recorder, from its state in the journal if that has one; false if there is none now.
static bool worker_next(worker *w, whirl_recorder *recorder, whirl_status *status) {
    const pass_work *work = w->work;
    study_run *run = work->run;
    if (w->status.code != WHIRL_OK || atomic_load(&run->tracker.halt)) return false;
    point *p = take_machine(w);
    // A machine of another structure waits until those under way are done: a recorder takes machines of one structure.
    w->unlike = p && !whirl_ensemble_alike(w->first.system, p->machine.system) ? p : NULL;
    if (!p || w->unlike) return false;
    const double *carried = p->copy_start ? p->copy_start : carried_start(work, p->slot);
    w->under_way++;
    p->begun = clock_seconds();
    p->from = carried ? carried : p->machine.start;
    double revolutions = 0.0;
    size_t size = 0;
    void *bytes = run_journal_state(run->journal, pass_number(run, work->pass), p->slot, &revolutions, &size);
    if (bytes) tracker_recall(&run->tracker, work->weight * revolutions, 0);
    *status = whirl_recorder_add(recorder, &(whirl_task){p->machine.system, p->from, p}, bytes, size);
    if (status->code != WHIRL_OK) point_free(p);
    return status->code == WHIRL_OK;
}

// ---------------------------------------------------------------- motions end

/// Computes the block of a point, or the verdict that is compared with the point's own.
static whirl_status worker_analyze(const worker *w, const point *p, const whirl_record *record) {
    const pass_work *work = w->work;
    const pass *own = work->pass;
    // A confirmation or a copy has only a verdict; confirmed chaos is also searched for coexisting attractors and its
    // end.
    if (pass_is_comparison(own)) {
        const whirl_system *system = p->machine.system;
        whirl_status status =
            whirl_analyze(record, &own->record, compared_analyses(own, work->batch), &work->other, w->other);
        if (status.code == WHIRL_OK && own->confirming)
            status = whirl_block_seek_coexisting(&work->other, w->other, system, &own->integrate, record);
        if (status.code == WHIRL_OK && own->confirming)
            status = whirl_block_survive(&work->other, w->other, system, &own->integrate, record);
        return status;
    }
    // A point has all analyses and notes.
    const beginning start = {p->slot, pass_origin(work->run, own->batch, p->slot), p->from};
    const whirl_layout *layout = &work->table->layout;
    double *block = block_of(w, p->slot);
    const double spent = own->round > 0 ? refine_spent(layout, block) + work->weight * record->revolutions : 0.0;
    whirl_status status = whirl_analyze(record, &own->record, work->batch->analyses, layout, block);
    map_note(work->batch, p->slot % work->batch->count, layout, block);
    sample_note(work->batch, p->slot % work->batch->count, layout, block);
    if (status.code == WHIRL_OK)
        status = records_note(work->batch, p->slot % work->batch->count, &p->machine, record, layout, block);
    if (status.code == WHIRL_OK && work->batch->derivatives) {
        whirl_batch chosen = *work->batch;
        batch_choose(&chosen, p->slot % work->batch->count);
        status = derived_of_motion(work->run->study, &chosen, work->table->values[p->slot], &p->machine, record->end,
                                   layout, block);
    }
    starts_note(work->batch, &start, p->machine.system, layout, block);
    refine_note(layout, block, own, spent);
    return status;
}

/// Analyzes the record of a point, which it frees, and writes the result to the table and the journal.
static whirl_status worker_finish(worker *w, point *p, whirl_record *record) {
    pass_work *work = w->work;
    const bool bounded = record->motion == WHIRL_BOUNDED;
    for (size_t i = 0; i < work->run->dimension; i++) w->end[i] = bounded ? record->end[i] : (double)NAN;
    whirl_status status = worker_analyze(w, p, record);
    const journal_entry entry = entry_of(w, p->slot);
    if (status.code == WHIRL_OK) status = run_journal_write(work->run->journal, &entry);
    // Revolutions that a motion saved by settling or diverging count as done.
    w->pending += work->revolutions - work->weight * record->revolutions;
    whirl_record_free(record);
    w->under_way--;
    point_release(p);
    if (status.code != WHIRL_OK) {
        free(p);
        return status;
    }
    point_is_done(w, p);
    leave_point(work, p, false);
    tracker_advance(&work->run->tracker, 0.0, 1);
    return status;
}

// ---------------------------------------------------------------- between revolutions

/// Saves motions that have run for some time; shorter ones are cheaper to repeat.
static void worker_save(worker *w, whirl_recorder *recorder) {
    const pass_work *work = w->work;
    const double begun = clock_seconds();
    size_t count, long_ones = 0;
    if (begun < w->save_at || !run_journal_saves(work->run->journal)) return;
    whirl_motion_state *states = whirl_recorder_save(recorder, &count);
    if (!states) return;
    whirl_point_state *saved = calloc(count, sizeof *saved);
    for (size_t i = 0; saved && i < count; i++) {
        const point *p = states[i].task.tag;
        if (begun - p->begun < save_interval) continue;
        saved[long_ones++] = (whirl_point_state){pass_number(work->run, work->pass), p->slot, states[i].revolutions,
                                                 states[i].bytes, states[i].size};
    }
    run_journal_save(work->run->journal, w->number, saved, long_ones);
    free(saved);
    whirl_motion_states_free(states, count);
    w->save_at = save_next(begun, clock_seconds());
}

/// Reports revolutions to the tracker, in packets, so that threads seldom wait for each other. False if the run must
/// end.
static bool worker_report(worker *w, size_t turned) {
    study_run *run = w->work->run;
    const double seconds = clock_seconds();
    w->pending += w->work->weight * (double)turned;
    if (pass_time_is_over(run)) return false;
    if (seconds - w->last < 0.1) return true;
    w->last = seconds;
    const double packet = w->pending;
    w->pending = 0.0;
    const whirl_status status = run_journal_sync(run->journal);
    if (status.code != WHIRL_OK) tracker_fail(&run->tracker, &status);
    return tracker_advance(&run->tracker, packet, 0);
}

// ---------------------------------------------------------------- the main loop

/// Records machines of one structure until none is left for this thread.
static whirl_status worker_record(worker *w) {
    const pass *own = w->work->pass;
    whirl_recorder *recorder;
    whirl_task task;
    whirl_record *record;
    size_t turned = 1;
    whirl_status status = whirl_recorder_new(w->first.system, &own->integrate, &own->record, 0, &recorder);
    while (status.code == WHIRL_OK && turned > 0) {
        // Fill free lanes.
        status = whirl_recorder_begin(recorder);
        while (status.code == WHIRL_OK && whirl_recorder_has_room(recorder) && worker_next(w, recorder, &status)) {
        }
        // Carry all motions over one revolution.
        if (status.code == WHIRL_OK) status = whirl_recorder_revolve(recorder, &turned);
        // Finish the points whose motions have ended.
        while (status.code == WHIRL_OK && whirl_recorder_take(recorder, &task, &record))
            status = worker_finish(w, task.tag, record);
        // Save the other motions now and then, and look for a stop.
        if (status.code == WHIRL_OK) worker_save(w, recorder);
        if (status.code == WHIRL_OK && turned > 0 && !worker_report(w, turned))
            status = whirl_fail(WHIRL_STOPPED, "stopped");
    }
    while (recorder && whirl_recorder_drop(recorder, &task)) point_free(task.tag);
    whirl_recorder_free(recorder);
    return status.code == WHIRL_OK ? w->status : status;
}

/// Turns to machines with the structure of a slot's machine.
static whirl_status turn_to_structure(worker *w, size_t slot) {
    if (w->first.release) w->first.release(w->first.owner);
    w->first = (whirl_machine){0};
    return machine_at(w->work, slot, &w->first);
}

/// Computes points of a pass, one structure of machines after the other, until none is left for thread `number`.
static whirl_status worker_compute(pass_work *work, size_t number) {
    // Begin with the structure of the first point.
    study_run *run = work->run;
    const double now = clock_seconds();
    worker w = {.work = work, .last = now, .number = number, .save_at = now + save_interval};
    whirl_status status = turn_to_structure(&w, 0);
    if (status.code != WHIRL_OK) return status;
    w.end = calloc(run->dimension + work->other.size + work->table->layout.size, sizeof *w.end);
    if (!w.end) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a state");
    if (status.code == WHIRL_OK) {
        w.other = w.end + run->dimension;
        w.block = w.other + work->other.size;
        status = worker_record(&w);
    }
    // Go on with points of other structures, which wait until no point of the present one is left.
    while (status.code == WHIRL_OK && w.unlike && !atomic_load(&run->tracker.halt)) {
        status = turn_to_structure(&w, w.unlike->slot);
        if (status.code == WHIRL_OK) status = worker_record(&w);
    }
    // Give everything back, and report revolutions that were not yet reported.
    if (w.unlike) point_free(w.unlike);
    free(w.end);
    if (w.first.release) w.first.release(w.first.owner);
    tracker_advance(&run->tracker, w.pending, 0);
    return w.status.code != WHIRL_OK ? w.status : status;
}

/// Sorts passes with long points first, so that no thread ends with one long point alone.
static void sort_long_first(pass_work *all, size_t count) {
    for (size_t i = 1; i < count; i++) {
        const pass_work moved = all[i];
        size_t at = i;
        for (; at > 0 && all[at - 1].revolutions < moved.revolutions; at--) all[at] = all[at - 1];
        all[at] = moved;
    }
}

whirl_status passes_work(study_run *run, const pass *passes, size_t count) {
    tracker *progress = &run->tracker;
    pass_work *all = calloc(count + 1, sizeof *all);
    whirl_status status = all ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu passes", count);
    size_t moving = 0;
    // Work first at the passes without motions, in their order: machines at rest, and branches, whose curves and tori
    // depend on what was found.
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        const study_kind *kind = study_kind_of(&run->study->batches[passes[i].batch]);
        status = kind->work ? kind->work(run, &passes[i]) : pass_work_new(&all[moving++], run, &passes[i]);
    }
    if (status.code == WHIRL_OK) {
        sort_long_first(all, moving);
#pragma omp parallel num_threads(run->threads)
        {
            errno = 0;
            for (size_t i = 0; i < moving; i++) {
                const whirl_status own =
                    atomic_load(&progress->halt) ? whirl_ok() : worker_compute(&all[i], (size_t)omp_get_thread_num());
                if (own.code != WHIRL_OK && own.code != WHIRL_STOPPED) tracker_fail(progress, &own);
            }
        }
    }
    for (size_t i = 0; all && i < moving; i++) pass_work_free(&all[i]);
    free(all);
    return status;
}

whirl_status passes_outcome(const study_run *run) {
    static const char *const formats[] = {
        [WHIRL_STAGE_COMPUTE] = "stopped after %zu of %zu points",
        [WHIRL_STAGE_CONFIRM] = "stopped after %zu of %zu points were confirmed",
        [WHIRL_STAGE_NEIGHBOURS] = "stopped after %zu of %zu motions of a round of starts from neighbours",
        [WHIRL_STAGE_FOLLOW] = "stopped after %zu of %zu copies of chaotic motions were followed",
        [WHIRL_STAGE_TABLES] = "stopped after %zu of %zu tables of films",
        [WHIRL_STAGE_REFINE] = "stopped after %zu of %zu points of a round of refinement",
    };
    const whirl_progress *progress = &run->tracker.progress;
    if (run->tracker.error.code != WHIRL_OK) return first_error_status(&run->tracker.error);
    if (run->tracker.options->gather && progress->points_done < progress->points_total)
        return whirl_fail(WHIRL_STOPPED,
                          progress->stage == WHIRL_STAGE_CONFIRM ? "%zu of %zu points are confirmed so far"
                                                                 : "%zu of %zu points are there so far",
                          progress->points_done, progress->points_total);
    // Without a stop, points are missing only because time ran out or because other runs have them.
    const bool stopped = run->gathering || atomic_load(&run->tracker.halt);
    if (progress->points_done == progress->points_total || !stopped) return whirl_ok();
    return whirl_fail(WHIRL_STOPPED, formats[progress->stage], progress->points_done, progress->points_total);
}
