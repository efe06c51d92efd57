// Running a study: its points, their confirmations, and refinement.
#include <math.h>
#include <omp.h>
#include <stdlib.h>

#include "passes.h"

static bool has_regime(const whirl_batch *batch) {
    whirl_analysis_set regime = 0;
    whirl_analysis_add(&regime, whirl_analysis_of_verdicts());
    return (batch->analyses & regime) != 0;
}

static whirl_status check_study(const whirl_study *study) {
    if (study->batch_count == 0 || study->batch_count > WHIRL_MAX_BATCHES || !study->machine)
        return whirl_fail(WHIRL_BAD_INPUT, "the study has %zu batches, expected 1 to %d and a machine",
                          study->batch_count, WHIRL_MAX_BATCHES);
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_batch *batch = &study->batches[i];
        if (batch->count == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "batch '%s' has no points, expected at least one", batch->name);
        const bool judged = !whirl_analysis_is_traced(batch->analyses);
        if (judged && (batch->confirm || study_is_refined(study)) && !has_regime(batch))
            return whirl_fail(WHIRL_BAD_INPUT, "verdicts of the %s cannot be %s: the analysis 'regime' is not chosen",
                              batch->name, batch->confirm ? "confirmed" : "refined");
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
    if (status.code == WHIRL_OK)
        *out = outline;
    else
        whirl_result_free(outline);
    return status;
}

// ---------------------------------------------------------------- stages

/// Where the points of carried batches end.
static whirl_status make_ends(study_run *run) {
    const whirl_study *study = run->study;
    whirl_machine machine;
    const whirl_batch *first = &study->batches[0];
    const whirl_status status = study->machine(study->family, first, first->values ? first->values[0] : NAN, &machine);
    if (status.code != WHIRL_OK) return status;
    run->dimension = machine.system->dimension;
    if (machine.release) machine.release(machine.owner);
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_batch *batch = &study->batches[i];
        if (whirl_analysis_is_traced(batch->analyses)) continue;
        if (batch->carry == WHIRL_CARRY_NONE && !batch->confirm && !study_is_refined(study)) continue;
        run->ends[i] = calloc(run->result->tables[i].count * run->dimension, sizeof *run->ends[i]);
        if (!run->ends[i]) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the ends of carried points");
    }
    return whirl_ok();
}

/// The passes over the study's own points, and over those that are confirmed; gives their number of points.
static size_t plan_points(const study_run *run, bool confirming, pass passes[WHIRL_MAX_BATCHES], size_t *pass_count) {
    size_t points = 0;
    *pass_count = 0;
    for (size_t i = 0; i < run->study->batch_count; i++) {
        const whirl_batch *batch = &run->study->batches[i];
        if (confirming && !batch->confirm) continue;
        const pass own = {
            .batch = i, .integrate = batch->integrate, .record = batch->record, .count = batch_slots(batch)};
        passes[(*pass_count)++] = confirming ? pass_confirming(&own) : own;
        points += own.count;
    }
    return points;
}

static double sum_revolutions(const study_run *run, const pass *passes, size_t count) {
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) sum += (double)passes[i].count * pass_revolutions(run, &passes[i]);
    return sum;
}

double whirl_study_revolutions(const whirl_study *study) {
    const study_run run = {.study = study};
    pass points[WHIRL_MAX_BATCHES], again[WHIRL_MAX_BATCHES];
    size_t point_passes, again_passes;
    plan_points(&run, false, points, &point_passes);
    plan_points(&run, true, again, &again_passes);
    return sum_revolutions(&run, points, point_passes) + sum_revolutions(&run, again, again_passes);
}

static whirl_status run_stages(study_run *run, const whirl_run_options *options) {
    pass points[WHIRL_MAX_BATCHES], again[WHIRL_MAX_BATCHES];
    size_t point_passes, again_passes;
    const size_t count = plan_points(run, false, points, &point_passes);
    const size_t again_count = plan_points(run, true, again, &again_passes);
    tracker_begin(&run->tracker, options, whirl_study_revolutions(run->study));
    tracker_stage(&run->tracker, WHIRL_STAGE_COMPUTE, count);
    whirl_status status = passes_work(run, points, point_passes);
    if (status.code == WHIRL_OK) status = passes_outcome(run);
    if (status.code == WHIRL_OK && again_count > 0) {
        tracker_stage(&run->tracker, WHIRL_STAGE_CONFIRM, again_count);
        status = passes_work(run, again, again_passes);
        if (status.code == WHIRL_OK) status = passes_outcome(run);
    }
    double unlimited = (double)INFINITY;
    size_t followed;
    if (status.code == WHIRL_OK && again_count > 0) status = follow_points(run, 0, &unlimited, &followed);
    if (status.code == WHIRL_OK && study_is_refined(run->study)) status = refine_points(run);
    if (status.code == WHIRL_OK) tracker_end(&run->tracker);
    return status;
}

whirl_status whirl_study_run(const whirl_study *study, const whirl_run_options *options, whirl_result **out) {
    whirl_study chosen = *study;
    study_run run = {.study = &chosen, .keeper = options->keeper};
    *out = NULL;
    if (options->threads < 0) return whirl_fail(WHIRL_BAD_INPUT, "threads is %d, expected 0 or more", options->threads);
    run.threads = options->threads > 0 ? options->threads : omp_get_num_procs();
    whirl_status status = check_study(study);
    if (status.code == WHIRL_OK) status = whirl_study_choose_methods(&chosen);
    if (status.code == WHIRL_OK) status = whirl_study_outline(&chosen, &run.result);
    if (status.code == WHIRL_OK) status = make_ends(&run);
    if (status.code == WHIRL_OK) status = tables_fill(&run, options->memory);
    if (status.code == WHIRL_OK) status = run_stages(&run, options);
    for (size_t i = 0; i < WHIRL_MAX_BATCHES; i++) free(run.ends[i]);
    if (status.code == WHIRL_STOPPED) {
        tables_blank(run.result);
        run.result->partial = true;
    }
    if (status.code == WHIRL_OK || status.code == WHIRL_STOPPED)
        *out = run.result;
    else
        whirl_result_free(run.result);
    return status;
}
