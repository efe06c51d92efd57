/// State of a run of a study, which all its passes share.
#ifndef STUDY_STUDY_RUN_H
#define STUDY_STUDY_RUN_H

#include <stdbool.h>
#include <stddef.h>

#include "tracker.h"
#include "whirl/engine/study.h"

/// State of a refined map (refined_map.h).
typedef struct refined_map refined_map;

/// Data that all passes share.
typedef struct study_run {
    const whirl_study *study;
    whirl_result *result;
    const whirl_point_store *journal; ///< or NULL
    int threads;
    size_t dimension;
    whirl_mapped *mapped;            ///< memory of large arrays below
    double *ends[WHIRL_MAX_BATCHES]; ///< [count][dimension] end of every point, NaN if it diverged; for batches that
                                     ///< are carried or may be followed, else NULL
    refined_map *refined[WHIRL_MAX_BATCHES]; ///< refined maps of batches that have one, else NULL
    /// [slots] for batches with starts from neighbours: 1 + the slot whose end a motion begins at, 0 for others; or
    /// NULL.
    size_t *origins[WHIRL_MAX_BATCHES];
    whirl_share share;          ///< points that are computed and confirmed; all zero: all of them
    const whirl_dealer *dealer; ///< NULL: points are not dealt out
    bool gathering;             ///< points that are not in the journal are left out
    bool traced;                ///< branches and tori are as complete as this run makes them
    double deadline;            ///< time at which points under way are abandoned (clock_seconds); 0: none
    tracker tracker;
} study_run;

#endif
