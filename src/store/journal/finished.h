/// The finished points of a table, which are all that a file holds of it: a run of a million points that is stopped
/// early leaves a small file.
#ifndef STORE_FINISHED_H
#define STORE_FINISHED_H

#include "whirl/engine/result.h"
#include "whirl/status.h"

#include <stddef.h>

typedef struct finished {
    whirl_table table; ///< these points, without blocks; if all are finished, with the arrays of the whole table
    size_t *points;    ///< [table.count] which points of the whole table they are; NULL: all
    whirl_mapped *mapped;
} finished;

/// The whole table must live as long.
whirl_status finished_points(const whirl_table *whole, finished *points);

/// Index in the whole table of a finished point.
static inline size_t finished_point(const finished *own, size_t at) {
    return own->points ? own->points[at] : at;
}

void finished_free(finished *points);

#endif
