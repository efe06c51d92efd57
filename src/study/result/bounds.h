/// Bounds of a point's motion, by which points are compared.
#ifndef STUDY_BOUNDS_H
#define STUDY_BOUNDS_H

#include "whirl/engine/result.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    BOUNDS = 6 ///< mean, least and largest x and y of a station
};

/// Reads bounds [stations][BOUNDS]; false if the table lacks any, or one is not finite.
bool bounds_read(const whirl_table *table, size_t point, size_t stations, double *bounds);

// ---------------------------------------------------------------- axes
// The axes along which the places of a study are neighbours.

enum { MAP_AXES = 3 }; ///< at most

typedef struct map_axis {
    size_t count; ///< number of places along the axis
    size_t step;  ///< difference between the indices of neighbours along it
} map_axis;

/// Lists the axes of a table: one of a sweep, two of a map, three with planes. Returns how many.
size_t map_axes_of(const whirl_table *table, map_axis axes[MAP_AXES]);

#endif
