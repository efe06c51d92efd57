/// What motions are known by when they are compared: sections of periodic ones, and where all of them go.
#ifndef STUDY_MOTION_H
#define STUDY_MOTION_H

#include "whirl/engine/result.h"

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

#endif
