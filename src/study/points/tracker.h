/// Progress of a run, updated by all threads.
#ifndef STUDY_TRACKER_H
#define STUDY_TRACKER_H

#include <stdatomic.h>
#include <stdbool.h>

#include "first_error.h"
#include "whirl/engine/study.h"

/// Progress, first error and end of a run.
typedef struct tracker {
    const whirl_run_options *options;
    whirl_progress progress;
    first_error error; ///< first error of any thread
    atomic_bool halt;  ///< no further work
    double started, reported;
} tracker;

/// Begins the progress of a run, whose planned work is `revolutions`, and its clock.
void tracker_begin(tracker *tracker, const whirl_run_options *options, double revolutions);

/// Begins a stage of `points` points. The stages of a study's own points share the revolutions given to tracker_begin;
/// every round of refinement, of starts from neighbours or of followed motions has its own.
void tracker_stage(tracker *tracker, whirl_stage stage, size_t points);
void tracker_round(tracker *tracker, int round, size_t points, double revolutions);

/// Begins a round of starts from neighbours.
void tracker_neighbours(tracker *tracker, int round, size_t points, double revolutions);

/// Begins to follow motions, in round 0 or in a round of refinement.
void tracker_follow(tracker *tracker, int round, size_t motions, double revolutions);

/// Adds to the progress, and reports it a few times a second. Returns false if the run must end.
bool tracker_advance(tracker *tracker, double revolutions, size_t points);

/// Adds a point that needs no computing.
void tracker_recall(tracker *tracker, double revolutions, size_t points);

/// Adds work that was not planned.
void tracker_add(tracker *tracker, double revolutions, size_t points);

/// Subtracts planned work that turned out not to exist.
void tracker_lack(tracker *tracker, double revolutions, size_t points);

/// Notes an error; the first one counts. The run ends.
void tracker_fail(tracker *tracker, const whirl_status *status);

/// Makes the last report.
void tracker_end(tracker *tracker);

#endif
