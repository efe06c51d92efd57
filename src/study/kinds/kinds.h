/// Kinds of points that studies compute (whirl_kind), and how each is computed and shared: one file of this folder and
/// one line of the registry.
#ifndef STUDY_KINDS_H
#define STUDY_KINDS_H

#include "passes.h"
#include "whirl/engine/study.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct study_kind {
    const char *name; ///< name of its whirl_kind
    size_t piece;     ///< points that are shared or dealt as one piece if they are not carried; 0: all
    /// Computes the points of a pass, on all threads. The tracker reports errors and stops. WHIRL_NO_MEMORY. NULL:
    /// chains compute the points, together with those of other passes.
    whirl_status (*work)(study_run *run, const pass *p);
} study_kind;

/// Returns the kind of a batch's points.
const study_kind *study_kind_of(const whirl_batch *batch);

extern const study_kind rest_kind, branch_kind, torus_kind;

// ---------------------------------------------------------------- critical
// Events between two neighbouring points of a study of machines at rest.

/// A machine of a batch at rest, with its modes.
typedef struct resting_machine {
    whirl_machine machine;
    whirl_modes *modes;
    size_t *before; ///< [modes->count] the mode's number (from 1) at the point before, 0: none; NULL: unknown
    double value;
} resting_machine;

/// Makes one. Errors as those of the machine and of whirl_modes_new.
whirl_status resting_new(const whirl_study *study, const whirl_batch *batch, double value, resting_machine *out);
void resting_free(resting_machine *r);

/// Matches the modes of a point with those of the point before. WHIRL_NO_MEMORY.
whirl_status resting_follow(const resting_machine *from, resting_machine *to);

/// Locates critical speeds and thresholds of stability between two points, to 1e-10 of the parameter: at most `most`
/// are written to found, *count is how many.
whirl_status critical_locate(const whirl_study *study, const whirl_batch *batch, const resting_machine *from,
                             const resting_machine *to, whirl_critical *found, size_t most, size_t *count);

// ---------------------------------------------------------------- elsewhere
// Other places of rest: where those of neighbouring points lead.

/// Equilibrium of a point's machine, as found from its start.
typedef struct known_rest {
    bool known;
    size_t slot, dimension;
    double *x; ///< [dimension]; NULL: nowhere
} known_rest;

/// Rests of three points in a row.
typedef struct known_rests {
    known_rest of[3];
} known_rests;

void known_rests_free(known_rests *rests);

/// Looks for another place of rest of a point's machine from those of the points before and after it (in its row of a
/// map). *elsewhere [dimension], to be freed, is NULL where there is none; *growth is its largest eigenvalue's real
/// part; *rest, which `rests` keeps, is where the machine rests. WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status elsewhere_find(const whirl_study *study, const whirl_batch *batch, const double *values, size_t slot,
                            const whirl_machine *machine, known_rests *rests, const double **rest, double **elsewhere,
                            double *growth);

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
