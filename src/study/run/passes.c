#include "passes.h"

#include <errno.h>
#include <omp.h>
#include <stdlib.h>

#include "chains.h"
#include "kinds.h"

/// Sorts passes with long points first, so that no thread ends with one alone.
static void sort_long_first(chains *all, size_t count) {
    for (size_t i = 1; i < count; i++) {
        const chains moved = all[i];
        size_t at = i;
        for (; at > 0 && all[at - 1].revolutions < moved.revolutions; at--) all[at] = all[at - 1];
        all[at] = moved;
    }
}

static void passes_work_chains(study_run *run, chains *all, size_t count) {
    tracker *progress = &run->tracker;
#pragma omp parallel num_threads(run->threads)
    {
        errno = 0;
        for (size_t i = 0; i < count; i++) {
            const whirl_status status =
                atomic_load(&progress->halt) ? whirl_ok() : chains_work(&all[i], (size_t)omp_get_thread_num());
            if (status.code != WHIRL_OK && status.code != WHIRL_STOPPED) tracker_fail(progress, &status);
        }
    }
}

/// Makes the passes without chains, in their order: machines at rest, and branches, whose curves and tori depend on
/// what was found. *count is how many passes are left, in front.
static whirl_status work_without_chains(study_run *run, const pass *passes, size_t *count, const pass **left) {
    whirl_status status = whirl_ok();
    size_t others = 0;
    for (size_t i = 0; i < *count && status.code == WHIRL_OK; i++) {
        const study_kind *kind = study_kind_of(&run->study->batches[passes[i].batch]);
        if (kind->work)
            status = kind->work(run, &passes[i]);
        else
            left[others++] = &passes[i];
    }
    *count = others;
    return status;
}

whirl_status passes_work(study_run *run, const pass *passes, size_t count) {
    chains *all = calloc(count + 1, sizeof *all);
    const pass **left = calloc(count + 1, sizeof(const pass *));
    whirl_status status = all && left ? work_without_chains(run, passes, &count, left)
                                      : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu passes", count);
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) status = chains_new(&all[i], run, left[i]);
    if (status.code == WHIRL_OK) {
        sort_long_first(all, count);
        passes_work_chains(run, all, count);
    }
    for (size_t i = 0; all && i < count; i++) chains_free(&all[i]);
    free(all);
    free(left);
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
