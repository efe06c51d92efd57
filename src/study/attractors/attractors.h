/// Telling the attractors of one machine apart.
#ifndef STUDY_ATTRACTORS_H
#define STUDY_ATTRACTORS_H

#include "passes.h"
#include "whirl/engine/result.h"

#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- motion
// What motions are known by when they are compared: sections of periodic ones, and where all of them go.

/// A copy: it lasts, whatever point of its table is asked for next.
typedef struct motion {
    whirl_regime regime;
    int period;
    size_t stations;
    size_t rows;     ///< of the section, one a revolution of the orbit; 0 where it is not periodic or has none
    bool placed;     ///< where it goes is known
    bool compared;   ///< the table has what tells where motions go
    double *section; ///< [rows][stations][2]
    double *bounds;  ///< [stations][BOUNDS]
} motion;

/// The motion of a point; NULL without memory. Freed by free.
motion *motion_read(const whirl_table *table, size_t point);

/// Whether two motions of one machine are the same attractor.
bool motion_is_same(const motion *a, const motion *b);

/// How far two motions are from each other, over the extent of the larger one: the largest distance of a point of one
/// section from the nearest one of the other where both are periodic, else the largest difference of means and bounds.
/// Infinite where they cannot be compared, and for two orbits neither of whose periods is a multiple of the other.
double motion_distance(const motion *a, const motion *b);

enum { MAX_ATTRACTORS = 64 };

/// Attractors in the order in which the points come to them, with a motion on each.
typedef struct told_apart {
    size_t done; ///< points that are done, without those from neighbours, which count nowhere here
    size_t count;
    whirl_attractor found[MAX_ATTRACTORS];
    motion *motions[MAX_ATTRACTORS];
} told_apart;

/// Tells those of `count` points (NULL: the first ones) apart. Writes the index of its attractor to of[point],
/// MAX_ATTRACTORS where it has none. WHIRL_NO_MEMORY. Freed by attractors_free, after a failure too.
whirl_status attractors_tell(const whirl_table *table, const size_t *points, size_t count, size_t *of,
                             told_apart *told);
void attractors_free(told_apart *told);

// ---------------------------------------------------------------- alike
// Whether points of a table show the same motion.

/// What is remembered of points that were looked at.
typedef struct alike alike;

/// Of a table that lives longer; NULL without memory. Freed by alike_free, which takes NULL.
alike *alike_new(const whirl_table *table);
void alike_free(alike *labels);

/// Whether two points that are done have one regime and period and, in a basin, one attractor. A verdict that is
/// undetermined or of low confidence is like no other. What stands in their blocks must not change any more.
bool alike_are(alike *labels, size_t a, size_t b);

// ---------------------------------------------------------------- neighbours
// Starts from neighbours: every place of a study goes on from where motions of its neighbours ended, on attractors
// that none of its own have come to, round after round.
//
// What a round does follows from the blocks alone, and every such start has a slot of its own: threads, journals and
// interruptions change no bit.

/// Makes the rounds of all batches that have them, once all their points are there, and confirmed where they are.
/// Stops are the tracker's. WHIRL_NO_MEMORY.
whirl_status neighbours_work(study_run *run);

/// Leaves in the tables the starts that were asked for. WHIRL_NO_MEMORY.
whirl_status neighbours_end(study_run *run);

/// Frees the origins.
void neighbours_free(study_run *run);

#endif
