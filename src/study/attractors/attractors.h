/// Attractors of one machine: which points settled on the same motion.
#ifndef STUDY_ATTRACTORS_H
#define STUDY_ATTRACTORS_H

#include "whirl/engine/result.h"

#include <stdbool.h>
#include <stddef.h>

// ---------------------------------------------------------------- motion
// Data by which motions are compared: the section of a periodic orbit, and the bounds of every motion.

/// A copy of the table's numbers; later reads of the table do not change it.
typedef struct motion {
    whirl_regime regime;
    int period;
    size_t stations;
    size_t
        rows; ///< rows of the section, one a revolution of the orbit; 0 if the motion is not periodic or has no section
    bool placed;     ///< bounds are known
    bool compared;   ///< the table has the fields that the comparison needs
    double *section; ///< [rows][stations][2]
    double *bounds;  ///< [stations][BOUNDS]
} motion;

/// Reads the motion of a point. NULL without memory. Freed by free.
motion *motion_read(const whirl_table *table, size_t point);

/// Returns true if two motions of one machine are the same attractor.
bool motion_is_same(const motion *a, const motion *b);

/// Returns the distance of two motions over the extent of the larger one. Both periodic: the largest distance of a
/// section point from the nearest one of the other. Otherwise: the largest difference of means and bounds. Infinite if
/// they cannot be compared, or if neither orbit's period is a multiple of the other's.
double motion_distance(const motion *a, const motion *b);

enum { MAX_ATTRACTORS = 64 };

/// Attractors of a set of points, in order of first appearance, with one motion of each.
typedef struct attractor_groups {
    size_t done; ///< finished points, without starts from neighbours, which shares leave out
    size_t count;
    whirl_attractor found[MAX_ATTRACTORS];
    motion *motions[MAX_ATTRACTORS];
} attractor_groups;

/// Assigns `points` [count] (NULL: the first `count` points of the table) to attractors. Writes the index of each
/// point's attractor to `of`, MAX_ATTRACTORS if it has none. WHIRL_NO_MEMORY. Freed by attractors_free, after a failure
/// too.
whirl_status attractors_group(const whirl_table *table, const size_t *points, size_t count, size_t *of,
                              attractor_groups *groups);
void attractors_free(attractor_groups *groups);

// ---------------------------------------------------------------- alike
// Comparison of points of a table.

/// A cache of the motions that were read.
typedef struct alike alike;

/// Makes a comparison for a table, which must outlive it. NULL without memory. Freed by alike_free, which takes NULL.
alike *alike_new(const whirl_table *table);
void alike_free(alike *labels);

/// Returns true if two finished points have one regime and period and, in a basin, one attractor. A verdict that is
/// undetermined or of low confidence equals no other. The blocks of both points must be final.
bool alike_are(alike *labels, size_t a, size_t b);

#endif
