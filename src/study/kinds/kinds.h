/// The kinds of points that studies compute (whirl_kind), each with how it is computed and shared: one file of this
/// folder and one line of the registry.
#ifndef STUDY_KINDS_H
#define STUDY_KINDS_H

#include "passes.h"
#include "whirl/engine/study.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct study_kind {
    const char *name; ///< of its whirl_kind
    size_t piece;     ///< points that stay together where they are shared or dealt out and are not carried; 0: all
    /// Computes the points of a pass, on all threads; errors and stops are the tracker's; WHIRL_NO_MEMORY. NULL: they
    /// are drawn from chains, side by side with those of other passes.
    whirl_status (*work)(study_run *run, const pass *p);
} study_kind;

/// Of the points of a batch.
const study_kind *study_kind_of(const whirl_batch *batch);

extern const study_kind rest_kind, branch_kind, torus_kind;

// ---------------------------------------------------------------- critical
// What lies between two neighbouring points of a study of machines at rest.

/// A machine of a batch at rest, with its modes.
typedef struct resting_machine {
    whirl_machine machine;
    whirl_modes *modes;
    size_t *before; ///< [modes->count] which mode of the point before each was, from 1, 0: none; NULL: unknown
    double value;
} resting_machine;

/// Makes one. Errors as those of the machine, and of whirl_modes_new.
whirl_status resting_new(const whirl_study *study, const whirl_batch *batch, double value, resting_machine *out);
void resting_free(resting_machine *r);

/// Finds out which modes of the point before those of a point were. WHIRL_NO_MEMORY.
whirl_status resting_follow(const resting_machine *from, resting_machine *to);

/// Locates critical speeds and thresholds of stability between two points, to 1e-10 of the parameter: at most `most`
/// are written to found, *count is how many.
whirl_status critical_locate(const whirl_study *study, const whirl_batch *batch, const resting_machine *from,
                             const resting_machine *to, whirl_critical *found, size_t most, size_t *count);

// ---------------------------------------------------------------- refined_map
// Maps that are refined: points are computed where verdicts differ, round after round (kinds.h).

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

// ---------------------------------------------------------------- squares
// Squares over a plane of points, divided where their points differ: which points of a refined map are computed.
//
// The plane is cut into first squares whose corners are points of it; those of the last column and row may be smaller.
// A square is halved along both axes where a point on its edges is known to differ from its first corner, down to
// squares of neighbouring points. What one first square learns of an edge the other one beside it learns, too, so that
// a boundary is followed from square to square. The more is known the more is divided, and never less: what is asked
// for in the end does not depend on the order in which points become known, nor on who asks first. Alone, a first
// square looks at the points that it asked for itself: what it asks for then is part of that, and depends on no other.

typedef struct squares {
    size_t columns, rows;       ///< points of the plane; a point is row * columns + column
    size_t width;               ///< of the first squares, in points, a power of two
    const unsigned char *known; ///< [rows][columns] 1 for points that can be compared
    bool alone;                 ///< first squares are
    bool (*differ)(const void *context, size_t a, size_t b);
    const void *context;
} squares;

/// First squares, which are counted row after row.
size_t squares_count(const squares *s);

/// Whether a point is of a first square, its edges included.
bool squares_has(const squares *s, size_t square, size_t point);

/// Whether it is a corner of one.
bool squares_is_corner(const squares *s, size_t point);

/// Sets in asked [rows][columns] all points that a first square needs as far as known points tell: its corners, and
/// those of all squares into which it is divided. False without memory.
bool squares_ask(const squares *s, size_t square, unsigned char *asked);

/// Sets in widths [rows][columns], at their first corners, the widths of the squares that were left as they are and
/// whose corners are known. False without memory.
bool squares_widths(const squares *s, size_t square, double *widths);

#endif
