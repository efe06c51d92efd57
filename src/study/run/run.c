// Runs a study: its points, their confirmations, and refinement.
#include <math.h>
#include <omp.h>
#include <stdlib.h>

#include "attractors.h"
#include "batch_slots.h"
#include "exhausted.h"
#include "film_tables.h"
#include "fit_run.h"
#include "follow.h"
#include "kinds.h"
#include "mapped.h"
#include "neighbours.h"
#include "pass.h"
#include "passes.h"
#include "refine.h"
#include "refine_fields.h"
#include "refined_map.h"
#include "settled.h"
#include "share.h"
#include "squares.h"
#include "study_run.h"
#include "tables.h"
#include "whirl/engine/study.h"
#include "whirl/internal/study_try.h"

/// Largest number of states of a machine whose first point is tried, which then takes about half a second.
enum { MAX_STATES_TRIED = 300 };

static bool has_regime(const whirl_batch *batch) {
    whirl_analysis_set regime = 0;
    whirl_analysis_add(&regime, whirl_analysis_of_verdicts());
    return (batch->analyses & regime) != 0;
}

static whirl_status check_refined_map(const whirl_batch *batch) {
    if (batch->refine == 0) return whirl_ok();
    if (batch->refine < 2 || batch->refine > WHIRL_MAX_SQUARE || (batch->refine & (batch->refine - 1)) != 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the %s is refined from squares of %zu points, expected a power of two up to %d", batch->name,
                          batch->refine, WHIRL_MAX_SQUARE);
    if (batch->starts > 1)
        return whirl_fail(WHIRL_BAD_INPUT, "the %s is refined, but has several starts a point", batch->name);
    if (batch->row == 0 || batch->count % batch->row != 0 || batch->carry != WHIRL_CARRY_NONE)
        return whirl_fail(WHIRL_BAD_INPUT, "the %s is refined, but is no map", batch->name);
    if (batch->plane > 0) return whirl_fail(WHIRL_BAD_INPUT, "the %s is refined, but has several planes", batch->name);
    return whirl_ok();
}

static whirl_status check_study(const whirl_study *study) {
    if (study->batch_count == 0 || study->batch_count > WHIRL_MAX_BATCHES || !study->machine)
        return whirl_fail(WHIRL_BAD_INPUT, "the study has %zu batches, expected 1 to %d and a machine",
                          study->batch_count, WHIRL_MAX_BATCHES);
    // Check what each batch asks for.
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_batch *batch = &study->batches[i];
        if (batch->count == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "batch '%s' has no points, expected at least one", batch->name);
        const bool moving = whirl_analysis_kind(batch->analyses)->moves;
        if (batch->starts > 1 && (batch->carry != WHIRL_CARRY_NONE || !moving || batch->starts > WHIRL_MAX_STARTS))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "batch '%s' has %zu starts, expected up to %d, and of motions that are "
                              "not carried",
                              batch->name, batch->starts, WHIRL_MAX_STARTS);
        if (!batch_is_found(batch) && (batch->confirm || study_is_refined(study) || batch->refine > 0) &&
            !has_regime(batch))
            return whirl_fail(WHIRL_BAD_INPUT, "verdicts of the %s cannot be %s: the analysis 'regime' is not chosen",
                              batch->name, batch->confirm ? "confirmed" : "refined");
        if (batch->neighbours > 0 && (batch->starts <= 1 || batch->count <= 1))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "batch '%s' has starts from neighbours, expected several points and starts", batch->name);
        if (batch->fit && batch->fit->trouble) return whirl_fail(WHIRL_BAD_INPUT, "%s", batch->fit->trouble);
        const whirl_status runs = batch->fit ? fit_runs_check(study, batch) : whirl_ok();
        if (runs.code != WHIRL_OK) return runs;
        const whirl_status refined = check_refined_map(batch);
        if (refined.code != WHIRL_OK) return refined;
    }
    return whirl_ok();
}

whirl_status whirl_study_outline(const whirl_study *study, whirl_result **out) {
    whirl_result *outline = NULL;
    whirl_study chosen = *study;
    *out = NULL;
    whirl_status status = check_study(study);
    if (status.code == WHIRL_OK) status = whirl_study_choose_methods(&chosen);
    if (status.code == WHIRL_OK) status = tables_new(&chosen, &outline);
    if (status.code == WHIRL_OK) status = study_add_film_tables(&chosen, outline);
    if (status.code == WHIRL_OK)
        *out = outline;
    else
        whirl_result_free(outline);
    return status;
}

// ---------------------------------------------------------------- stages

/// Counts the states of moving machines, which must agree in all batches, since motions begin at the ends of others.
/// Machines at rest may differ; without motions the first batch counts.
static whirl_status count_states(study_run *run) {
    const whirl_study *study = run->study;
    bool moving = false;
    // Make the outline of each batch's first machine.
    for (size_t i = 0; i < study->batch_count; i++) {
        whirl_batch first = study->batches[i];
        whirl_machine machine;
        const bool moves = whirl_analysis_kind(first.analyses)->moves || batch_is_found(&first);
        if (i > 0 && !moves) continue;
        first.outline = true;
        const whirl_status status = whirl_study_machine(study, &first, 0, &machine);
        if (status.code != WHIRL_OK) return status;
        const size_t dimension = machine.system->dimension;
        if (machine.release) machine.release(machine.owner);
        if (moving && dimension != run->dimension)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the machines of '%s' have %zu states, and earlier ones %zu, expected as many in all "
                              "motions of a study",
                              first.name, dimension, run->dimension);
        run->dimension = dimension;
        moving = moving || moves;
    }
    return whirl_ok();
}

/// Makes the array of the points' ends, for batches that start from them.
static whirl_status make_ends(study_run *run) {
    const whirl_study *study = run->study;
    const whirl_status status = count_states(run);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_batch *batch = &study->batches[i];
        if (batch_is_found(batch)) continue;
        const bool carries = batch->carry != WHIRL_CARRY_NONE || batch->neighbours > 0;
        if (!carries && !batch->confirm && !study_is_refined(study)) continue;
        run->ends[i] =
            mapped_take(&run->mapped, run->result->tables[i].count * run->dimension, sizeof *run->ends[i], MAPPED_MIN);
        if (!run->ends[i]) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the ends of carried points");
    }
    return whirl_ok();
}

/// A stage over the study's own points.
typedef struct stage {
    whirl_stage name;
    size_t pass_count, points;
    double revolutions;
    pass passes[2 * WHIRL_MAX_BATCHES];
} stage;

static void free_stage(const stage *s) {
    for (size_t i = 0; i < s->pass_count; i++) free(s->passes[i].slots);
}

static void add_pass(const study_run *run, const pass *p, stage *s) {
    s->points += p->count;
    s->revolutions += (double)p->count * pass_revolutions(run, p);
    if (p->count > 0)
        s->passes[s->pass_count++] = *p;
    else
        free(p->slots);
}

/// Plans the passes over the points, or over those that are confirmed, of the run's share. Freed by free_stage.
static whirl_status plan_stage(const study_run *run, whirl_stage name, stage *s) {
    const bool confirming = name == WHIRL_STAGE_CONFIRM;
    whirl_status status = whirl_ok();
    *s = (stage){.name = name};
    for (size_t i = 0; i < run->study->batch_count && status.code == WHIRL_OK; i++) {
        const whirl_batch *batch = &run->study->batches[i];
        if ((confirming && !batch->confirm) || (run->traced && batch_is_found(batch))) continue;
        pass own = {.batch = i, .integrate = batch->integrate, .record = batch->record, .count = batch_slots(batch)};
        if (confirming) own = pass_confirming(&own);
        pass late = own;
        status = share_pass(run, &own);
        add_pass(run, &own, s);
        if (!confirming || !run->refined[i] || status.code != WHIRL_OK) continue;
        status = refined_late_pass(run, &late);
        add_pass(run, &late, s);
    }
    return status;
}

double whirl_study_revolutions(const whirl_study *study) {
    const study_run run = {.study = study};
    stage points, again;
    (void)plan_stage(&run, WHIRL_STAGE_COMPUTE, &points); // cannot fail without shares
    (void)plan_stage(&run, WHIRL_STAGE_CONFIRM, &again);
    return points.revolutions + again.revolutions;
}

static whirl_status run_stage(study_run *run, stage *s) {
    // Refined maps deal first squares, not points.
    const bool deals = run->dealer && s->name == WHIRL_STAGE_COMPUTE;
    if (s->points == 0 && !deals) return whirl_ok();
    for (size_t i = 0; i < s->pass_count && s->name == WHIRL_STAGE_CONFIRM; i++) share_confirmed(run, &s->passes[i]);
    tracker_stage(&run->tracker, s->name, s->points);
    whirl_status status = passes_work(run, s->passes, s->pass_count);
    if (status.code == WHIRL_OK && s->name == WHIRL_STAGE_COMPUTE) status = refined_maps_work(run);
    return status.code == WHIRL_OK ? passes_outcome(run) : status;
}

/// Runs the stages that need all points and their confirmations.
static whirl_status run_stages_of_all(study_run *run, bool confirmed) {
    double unlimited = (double)INFINITY;
    size_t followed;
    whirl_status status = neighbours_work(run);
    if (status.code == WHIRL_OK && confirmed) status = follow_points(run, 0, &unlimited, &followed);
    if (status.code == WHIRL_OK && study_is_refined(run->study)) status = refine_points(run);
    return status;
}

/// Plans the confirmations again after the points are known: refined maps have more points than before.
static whirl_status plan_again(study_run *run, stage *again) {
    const double before = again->revolutions;
    free_stage(again);
    const whirl_status status = plan_stage(run, WHIRL_STAGE_CONFIRM, again);
    tracker_add(&run->tracker, again->revolutions - before, 0);
    return status;
}

/// Computes the points and their confirmations, or recalls them.
static whirl_status run_points(study_run *run, const whirl_run_options *options) {
    stage points, again;
    whirl_status status = refined_maps_new(run);
    if (status.code != WHIRL_OK) return status;
    status = plan_stage(run, WHIRL_STAGE_COMPUTE, &points);
    const whirl_status planned = plan_stage(run, WHIRL_STAGE_CONFIRM, &again);
    if (status.code == WHIRL_OK) status = planned;
    tracker_begin(&run->tracker, options, points.revolutions + again.revolutions);
    if (status.code == WHIRL_OK) status = run_stage(run, &points);
    if (status.code == WHIRL_OK) status = plan_again(run, &again);
    if (status.code == WHIRL_OK) status = run_stage(run, &again);
    free_stage(&points);
    free_stage(&again);
    return status;
}

static bool branches_are_missing(const study_run *run) {
    bool missing = false;
    for (size_t i = 0; i < run->result->table_count; i++) missing = missing || run->result->tables[i].planned > 0;
    return missing;
}

/// Gathers what other runs have computed, also if the gathering run was stopped. `own` is its outcome.
static whirl_status gather_dealt(study_run *run, const whirl_run_options *options, const whirl_status *own) {
    const whirl_dealer *dealer = options->dealer;
    const double started = run->tracker.started;
    whirl_run_options unperturbed = *options;
    if ((own->code != WHIRL_OK && own->code != WHIRL_STOPPED) || !dealer->gather) return *own;
    whirl_status status = dealer->gather(dealer->context);
    if (status.code != WHIRL_OK) return status;
    run->dealer = NULL;
    run->traced = run->gathering = true;
    unperturbed.stop = NULL;
    unperturbed.progress = NULL;
    status = run_points(run, &unperturbed);
    run->traced = run->gathering = false;
    run->tracker.options = options;
    run->tracker.started = started;
    return status.code == WHIRL_OK && branches_are_missing(run) ? *own : status;
}

static whirl_status run_stages(study_run *run, const whirl_run_options *options) {
    bool confirmed = false;
    run->gathering = options->gather;
    whirl_status status = run_points(run, options);
    run->gathering = false;
    if (options->dealer) status = gather_dealt(run, options, &status);
    for (size_t i = 0; i < run->study->batch_count; i++) confirmed = confirmed || run->study->batches[i].confirm;
    const bool whole = run->share.count == 0 && !run->dealer;
    if (status.code == WHIRL_OK && whole) status = run_stages_of_all(run, confirmed);
    if (status.code == WHIRL_OK) tracker_end(&run->tracker);
    return status;
}

/// Places unbalances by rule, once for all points; the batches borrow `placed`.
static whirl_status place_all(whirl_study *study, whirl_placed *placed[WHIRL_MAX_BATCHES]) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < study->batch_count && status.code == WHIRL_OK; i++)
        status = whirl_study_place(study, &study->batches[i], &placed[i]);
    return status;
}

whirl_status whirl_study_run(const whirl_study *study, const whirl_run_options *options, whirl_result **out) {
    whirl_study chosen = *study;
    whirl_placed *placed[WHIRL_MAX_BATCHES] = {NULL};
    study_run run = {.study = &chosen, .journal = options->store, .share = options->share, .dealer = options->dealer};
    *out = NULL;
    // Check the options.
    if (options->threads < 0) return whirl_fail(WHIRL_BAD_INPUT, "threads is %d, expected 0 or more", options->threads);
    if (run.share.count > 0 && (run.share.number < 1 || run.share.number > run.share.count))
        return whirl_fail(WHIRL_BAD_INPUT, "the share is %zu of %zu, expected 1 to %zu", run.share.number,
                          run.share.count, run.share.count);
    run.threads = options->threads > 0 ? options->threads : omp_get_num_procs();
    const int before = exhausted_watch();
    for (size_t i = 0; i < chosen.batch_count && i < WHIRL_MAX_BATCHES; i++) chosen.batches[i].stop = options->stop;
    // Prepare: tables of films, unbalances by rule, methods, an empty result and its memory.
    whirl_status status = check_study(study);
    if (status.code == WHIRL_OK) status = whirl_study_prepare(&chosen, options);
    if (status.code == WHIRL_OK) status = place_all(&chosen, placed);
    if (status.code == WHIRL_OK) status = whirl_study_choose_methods(&chosen);
    if (status.code == WHIRL_OK) status = whirl_study_outline(&chosen, &run.result);
    if (status.code == WHIRL_OK) status = make_ends(&run);
    if (status.code == WHIRL_OK) status = tables_fill(&run, options->memory);
    // Compute all stages; what was computed before a stop is kept.
    const bool begun = status.code == WHIRL_OK;
    if (begun) status = run_stages(&run, options);
    if (begun && (status.code == WHIRL_OK || status.code == WHIRL_STOPPED)) {
        whirl_status ended = refined_maps_end(&run);
        if (ended.code == WHIRL_OK) ended = neighbours_end(&run);
        if (ended.code != WHIRL_OK) status = ended;
    }
    // Free the workspace, and hand over the result.
    refined_maps_free(&run);
    neighbours_free(&run);
    for (size_t i = 0; i < WHIRL_MAX_BATCHES; i++) mapped_drop(&run.mapped, run.ends[i]), free(placed[i]);
    if (exhausted(before) && status.code != WHIRL_NO_MEMORY)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a study");
    const bool given = begun && (status.code == WHIRL_OK || status.code == WHIRL_STOPPED);
    if (given && (status.code == WHIRL_STOPPED || run.share.count > 0 || run.dealer)) {
        tables_blank(run.result);
        run.result->partial = true;
    }
    if (given)
        *out = run.result;
    else
        whirl_result_free(run.result);
    return status;
}

// ---------------------------------------------------------------- trial

/// Computes the first point of a batch at rest, to find the errors that a run would report.
static whirl_status try_point(const whirl_study *study, const whirl_batch *batch, const whirl_stop *stop) {
    whirl_study one = {.machine = study->machine, .family = study->family, .batch_count = 1};
    whirl_machine machine;
    whirl_result *result = NULL;
    one.batches[0] = *batch;
    one.batches[0].count = 1;
    one.batches[0].row = one.batches[0].plane = 0;
    one.batches[0].outline = true;
    whirl_status status = whirl_study_machine(&one, &one.batches[0], 0, &machine);
    if (status.code != WHIRL_OK) return status;
    const size_t states = machine.system->dimension;
    if (machine.release) machine.release(machine.owner);
    if (states > MAX_STATES_TRIED) return status;
    one.batches[0].outline = false;
    status = whirl_study_run(&one, &(whirl_run_options){.threads = 1, .stop = stop}, &result);
    whirl_result_free(result);
    return status;
}

/// Begins the branches of a batch, without following them.
static whirl_status try_branches(const whirl_study *study, const whirl_batch *batch, const whirl_stop *stop) {
    whirl_batch own = *batch;
    whirl_status status = whirl_ok();
    own.stop = stop;
    for (size_t i = 0; i < batch->count && status.code == WHIRL_OK && !*stop; i++) {
        whirl_orbit *orbit;
        status = settled_orbit(study, &own, batch->values[i], &orbit);
        whirl_orbit_free(orbit);
    }
    return *stop ? whirl_ok() : status;
}

whirl_status whirl_study_try(const whirl_study *study, const whirl_stop *stop) {
    study_run run = {.study = study};
    whirl_status status = whirl_study_outline(study, &run.result);
    whirl_result_free(run.result);
    if (status.code == WHIRL_OK) status = count_states(&run);
    for (size_t i = 0; i < study->batch_count && status.code == WHIRL_OK; i++) {
        const whirl_batch *batch = &study->batches[i];
        if (whirl_analysis_kind(batch->analyses)->place) status = try_point(study, batch, stop);
        if (study_kind_of(batch) == &branch_kind && !batch->second[0]) status = try_branches(study, batch, stop);
    }
    return status.code == WHIRL_BAD_INPUT || status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}
