// The finished points of a table, which are all that a file holds of it: a run of a million points that is stopped
// early leaves a small file.
#ifndef STORE_FINISHED_H
#define STORE_FINISHED_H

#include "whirl/engine/result.h"

typedef struct finished {
    whirl_table
        table;      ///< of these points alone, without blocks; where all are finished, with the arrays of the whole one
    size_t *points; ///< [table.count] which points of the whole table they are; NULL: all
    whirl_room *room;
} finished;

/// The whole table must live as long.
whirl_status finished_points(const whirl_table *whole, finished *points);

/// Which point of the whole table one is.
static inline size_t finished_point(const finished *own, size_t at) {
    return own->points ? own->points[at] : at;
}

void finished_free(finished *points);

#endif
