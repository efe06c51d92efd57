/// Where the motion of a point goes, to compare points by.
#ifndef STUDY_BOUNDS_H
#define STUDY_BOUNDS_H

#include "whirl/engine/result.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    BOUNDS = 6 ///< mean, least and largest x and y of a station
};

/// Reads bounds [stations][BOUNDS]; false where the table lacks any, or one is no finite number.
bool bounds_read(const whirl_table *table, size_t point, size_t stations, double *bounds);

// ---------------------------------------------------------------- axes
// The axes along which the places of a study are neighbours.

enum { MAP_AXES = 3 }; ///< at most

typedef struct map_axis {
    size_t count; ///< of places along it
    size_t step;  ///< from one to the next
} map_axis;

/// Those of a table: one of a sweep, two of a map, three where it has planes. How many.
size_t map_axes_of(const whirl_table *table, map_axis axes[MAP_AXES]);

#endif
