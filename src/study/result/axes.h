/// The axes along which the places of a study are neighbours.
#ifndef STUDY_AXES_H
#define STUDY_AXES_H

#include "whirl/engine/result.h"

enum { MAP_AXES = 3 }; ///< at most

typedef struct map_axis {
    size_t count; ///< of places along it
    size_t step;  ///< from one to the next
} map_axis;

/// Those of a table: one of a sweep, two of a map, three where it has planes. How many.
size_t map_axes_of(const whirl_table *table, map_axis axes[MAP_AXES]);

#endif
