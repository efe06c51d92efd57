// Running a study: every thread works at the batches, the long ones first.
#include <omp.h>
#include <stdlib.h>

#include "chains.h"

static void begin(tracker *progress, const whirl_study *study, const whirl_run_options *options) {
    size_t points = 0;
    double revolutions = 0.0;
    for (size_t i = 0; i < study->batch_count; i++) {
        const whirl_batch *batch = &study->batches[i];
        const size_t count = batch->count * batch_copies(batch);
        points += count;
        revolutions += (double)count * point_revolutions(batch);
    }
    tracker_begin(progress, options, points, revolutions);
}

/// Order of the batches: those with long points first, so that no thread is left with one at the end.
static void order_batches(const whirl_study *study, size_t order[WHIRL_MAX_BATCHES]) {
    for (size_t i = 0; i < study->batch_count; i++) {
        size_t at = i;
        for (; at > 0 && point_revolutions(&study->batches[order[at - 1]]) < point_revolutions(&study->batches[i]);
             at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
}

static void work(const whirl_study *study, chains *batches, tracker *progress, int threads) {
    size_t order[WHIRL_MAX_BATCHES];
    order_batches(study, order);
#pragma omp parallel num_threads(threads)
    for (size_t i = 0; i < study->batch_count; i++) {
        chains *c = &batches[order[i]];
        const size_t quota = (c->count + (size_t)threads - 1) / (size_t)threads;
        const whirl_status status = atomic_load(&progress->halt) ? whirl_ok() : chains_work(c, quota);
        if (status.code != WHIRL_OK && status.code != WHIRL_STOPPED) tracker_fail(progress, &status);
    }
}

static whirl_status check_study(const whirl_study *study) {
    if (study->batch_count == 0 || study->batch_count > WHIRL_MAX_BATCHES || !study->machine)
        return whirl_fail(WHIRL_BAD_INPUT, "the study has %zu batches, expected 1 to %d and a machine",
                          study->batch_count, WHIRL_MAX_BATCHES);
    for (size_t i = 0; i < study->batch_count; i++)
        if (study->batches[i].count == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "batch '%s' has no points, expected at least one",
                              study->batches[i].name);
    return whirl_ok();
}

/// How a run ended whose threads have come to rest.
static whirl_status outcome(tracker *progress) {
    const size_t done = progress->progress.points_done, total = progress->progress.points_total;
    if (progress->status.code == WHIRL_OK && done < total)
        return whirl_fail(WHIRL_STOPPED, "stopped after %zu of %zu points", done, total);
    if (progress->status.code == WHIRL_OK) tracker_end(progress);
    return progress->status;
}

whirl_status whirl_study_outline(const whirl_study *study, whirl_result **out) {
    whirl_result *outline = NULL;
    *out = NULL;
    whirl_status status = check_study(study);
    if (status.code == WHIRL_OK) status = tables_new(study, &outline);
    if (status.code == WHIRL_OK)
        *out = outline;
    else
        whirl_result_free(outline);
    return status;
}

whirl_status whirl_study_run(const whirl_study *study, const whirl_run_options *options, whirl_result **out) {
    chains batches[WHIRL_MAX_BATCHES] = {0};
    whirl_result *result = NULL;
    tracker progress;
    *out = NULL;
    if (options->threads < 0) return whirl_fail(WHIRL_BAD_INPUT, "threads is %d, expected 0 or more", options->threads);
    whirl_status status = whirl_study_outline(study, &result);
    if (status.code == WHIRL_OK) status = tables_fill(result);
    for (size_t i = 0; i < study->batch_count && status.code == WHIRL_OK; i++)
        status = chains_new(&batches[i], study, i, &result->tables[i], &progress, options->keeper);
    if (status.code == WHIRL_OK) {
        begin(&progress, study, options);
        work(study, batches, &progress, options->threads > 0 ? options->threads : omp_get_num_procs());
        status = outcome(&progress);
    }
    for (size_t i = 0; i < WHIRL_MAX_BATCHES; i++) chains_free(&batches[i]);
    if (status.code == WHIRL_STOPPED) tables_blank(result);
    if (status.code == WHIRL_OK || status.code == WHIRL_STOPPED)
        *out = result;
    else
        whirl_result_free(result);
    return status;
}
