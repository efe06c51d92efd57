/// Steps of a run (run.c): the passes over the points of a study, and what follows when these are known.
#ifndef STUDY_RUN_H
#define STUDY_RUN_H

#include "kinds.h"
#include "pass.h"

// ---------------------------------------------------------------- prepare.c

/// Adds the fact "film tables" (whirl_result_film_tables) to a result of the study. WHIRL_NO_MEMORY.
whirl_status study_add_film_tables(const whirl_study *study, whirl_result *result);

// ---------------------------------------------------------------- passes.c

/// Makes all passes, on all threads. The tracker reports errors and stops. WHIRL_NO_MEMORY.
whirl_status passes_work(study_run *run, const pass *passes, size_t count);

/// Outcome of a stage, after its threads have ended: WHIRL_STOPPED if a stop came before its last point.
whirl_status passes_outcome(const study_run *run);

// ---------------------------------------------------------------- share.c

/// Reduces a pass over all points of a batch to those of the run's share, or to those that may be dealt to it; its
/// slots are to be freed. WHIRL_NO_MEMORY.
whirl_status share_pass(const study_run *run, pass *p);

/// Reduces a pass that confirms carried points to the points that this run has.
void share_confirmed(const study_run *run, pass *p);

// ---------------------------------------------------------------- follow.c

/// Follows chaotic motions whose chaos may end, as far as the budget allows, and subtracts their cost from it. *done is
/// how many. The tracker reports stops.
whirl_status follow_points(study_run *run, int round, double *budget, size_t *done);

// ---------------------------------------------------------------- refine.c

/// Computes doubtful points again until the budget is spent or none is left. The tracker reports stops.
whirl_status refine_points(study_run *run);

// ---------------------------------------------------------------- neighbours
// Starts from neighbours: each place of a study is started from the ends of its neighbours' motions on attractors that
// none of its own starts reached, round after round. What a round does follows from the blocks alone, and every such
// start has its own slot: threads, journals and interruptions change no bit.

/// Runs the rounds of all batches that ask for them, after all points are computed and confirmed. The tracker reports
/// stops. WHIRL_NO_MEMORY.
whirl_status neighbours_work(study_run *run);

/// Removes from the tables the slots of starts that were never used. WHIRL_NO_MEMORY.
whirl_status neighbours_end(study_run *run);

/// Frees the origins.
void neighbours_free(study_run *run);

// ---------------------------------------------------------------- refined_map
// Refined maps: points are computed where verdicts differ, round after round.

/// Prepares the refined maps of a run and replaces earlier ones. Slots are those of the finest grid. Freed by
/// refined_maps_free, after a failure too. WHIRL_NO_MEMORY.
whirl_status refined_maps_new(study_run *run);
void refined_maps_free(study_run *run);

/// Fills a pass with the points of a refined map that the run's share has requested so far: at first the corners of its
/// first squares. Its slots are to be freed. WHIRL_NO_MEMORY.
/// In shares, first squares request points alone. The run that gathers the shares lets them request together once all
/// points are known, and computes the missing ones in the late pass, which the first pass leaves out.
whirl_status refined_pass(const study_run *run, pass *p);
whirl_status refined_late_pass(const study_run *run, pass *p);

/// Number of the points of all first squares; and true if a slot belongs to a share.
size_t refined_first_points(const whirl_batch *batch);
bool refined_share_has(const whirl_batch *batch, const whirl_share *share, size_t slot);

/// Divides squares, after the corners of the first squares are computed, until none needs dividing or the run must end.
/// The tracker reports stops.
whirl_status refined_maps_work(study_run *run);

/// Removes from the tables of refined maps the points that were not requested, and notes in "map/width" how many grid
/// points each represents. WHIRL_NO_MEMORY.
whirl_status refined_maps_end(study_run *run);

// ---------------------------------------------------------------- squares
// Squares over a plane of points, divided where their points differ: they decide which points of a refined map are
// computed.
// The plane is cut into first squares whose corners are its points; those of the last column and row may be smaller. A
// square is halved along both axes if a point on its edges is known to differ from its first corner, down to
// neighbouring points. Points on an edge count for the squares on both sides, so a boundary is followed from square to
// square. More known points never divide less, so the final request depends neither on the order in which points become
// known nor on who requests first. A square that is `alone` uses only points that it requested itself and is
// independent of all others.

typedef struct squares {
    size_t columns, rows;       ///< points of the plane; a point is row * columns + column
    size_t width;               ///< width of first squares, in points, a power of two
    const unsigned char *known; ///< [rows][columns] 1 for points that can be compared
    bool alone;                 ///< first squares use only their own points
    bool (*differ)(const void *context, size_t a, size_t b);
    const void *context;
} squares;

/// Number of first squares, counted row after row.
size_t squares_count(const squares *s);

/// Returns true if a point is in a first square, edges included.
bool squares_has(const squares *s, size_t square, size_t point);

/// Returns true if a point is a corner of a first square.
bool squares_is_corner(const squares *s, size_t point);

/// Sets in asked [rows][columns] all points that a first square needs, given the known points: its corners, and those
/// of all squares into which it is divided. False without memory.
bool squares_ask(const squares *s, size_t square, unsigned char *asked);

/// Sets in widths [rows][columns], at their first corners, the widths of the undivided squares with known corners.
/// False without memory.
bool squares_widths(const squares *s, size_t square, double *widths);

#endif
