/// Maps that are refined: points are computed where verdicts differ, round after round (squares.h).
#ifndef STUDY_REFINED_MAP_H
#define STUDY_REFINED_MAP_H

#include "passes.h"

/// What is known of the refined maps of a run, in place of what was; slots are those of the finest grid. Freed by
/// refined_maps_free, after a failure too. WHIRL_NO_MEMORY.
whirl_status refined_maps_new(study_run *run);
void refined_maps_free(study_run *run);

/// Puts into a pass over a refined map the points that the run's share has asked for so far: at first the corners of
/// its first squares. Its slots are to be freed. WHIRL_NO_MEMORY.
///
/// In shares first squares ask alone; the run that gathers these lets them ask together once all is there, and computes
/// what is missing then: the points of the late pass, which the first one leaves out.
whirl_status refined_pass(const study_run *run, pass *p);
whirl_status refined_late_pass(const study_run *run, pass *p);

/// The points of the first squares, all of them, and those of a point's share.
size_t refined_first_points(const whirl_batch *batch);
bool refined_share_has(const whirl_batch *batch, const whirl_share *share, size_t slot);

/// Once the corners of the first squares are computed: goes on until no square is to be divided any more, or the run
/// shall end. Stops are the tracker's.
whirl_status refined_maps_work(study_run *run);

/// Leaves in the tables of refined maps the points that were asked for, and notes in "map/width" for how many points of
/// the grid each stands. WHIRL_NO_MEMORY.
whirl_status refined_maps_end(study_run *run);

#endif
