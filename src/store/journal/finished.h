/// The finished points of a table. A file holds only these, so that a run of a million points that is stopped early
/// leaves a small file.
#ifndef STORE_FINISHED_H
#define STORE_FINISHED_H

#include "whirl/engine/result.h"
#include "whirl/status.h"

#include <stddef.h>

typedef struct finished {
    whirl_table table; ///< table of the finished points, without blocks; if all are finished, it borrows the arrays of
                       ///< the whole table
    size_t *points;    ///< [table.count] their indices in the whole table; NULL: all points are finished
    whirl_mapped *mapped;
} finished;

/// Finds the finished points of a table, which must live as long as they do. WHIRL_NO_MEMORY.
whirl_status finished_points(const whirl_table *whole, finished *points);

/// Returns the index of a finished point in the whole table.
static inline size_t finished_point(const finished *own, size_t at) {
    return own->points ? own->points[at] : at;
}

void finished_free(finished *points);

#endif
