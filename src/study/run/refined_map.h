/// Refined maps: points are computed where verdicts differ, round after round.
#ifndef STUDY_REFINED_MAP_H
#define STUDY_REFINED_MAP_H

#include <stdbool.h>
#include <stddef.h>

#include "pass.h"
#include "study_run.h"
#include "whirl/engine/study.h"

/// Prepares the refined maps of a run and replaces earlier ones. Slots are those of the finest grid. Freed by
/// refined_maps_free, after a failure too. WHIRL_NO_MEMORY.
whirl_status refined_maps_new(study_run *run);
void refined_maps_free(study_run *run);

/// Fills a pass with the points of a refined map that the run's share has requested so far: at first the corners of its
/// first squares. Its slots are to be freed. WHIRL_NO_MEMORY. In a share, each first square requests points by its own
/// points alone. The run that gathers the shares lets all squares request together once all points are known. It
/// computes the points that are then missing in the late pass (refined_late_pass).
whirl_status refined_pass(const study_run *run, pass *p);
whirl_status refined_late_pass(const study_run *run, pass *p);

/// refined_first_points returns the number of points of all first squares; refined_share_has returns true if a slot
/// belongs to a share.
size_t refined_first_points(const whirl_batch *batch);
bool refined_share_has(const whirl_batch *batch, const whirl_share *share, size_t slot);

/// Divides squares, after the corners of the first squares are computed, until none needs dividing or the run must end.
/// The tracker reports stops.
whirl_status refined_maps_work(study_run *run);

/// Removes from the tables of refined maps the points that were not requested, and notes in "map/width" how many grid
/// points each represents. WHIRL_NO_MEMORY.
whirl_status refined_maps_end(study_run *run);

#endif
