/// Where the motion of a point goes, to compare points by.
#ifndef STUDY_BOUNDS_H
#define STUDY_BOUNDS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"

enum {
    BOUNDS = 6 ///< mean, least and largest x and y of a station
};

/// Reads bounds [stations][BOUNDS]; false where the table lacks any, or one is no finite number.
bool bounds_read(const whirl_table *table, size_t point, size_t stations, double *bounds);

#endif
