// The finished points of a table, which are all that a file holds of it: a run of a million points that is stopped
// early leaves a small file.
#ifndef STORE_FINISHED_H
#define STORE_FINISHED_H

#include "whirl/result.h"

typedef struct finished {
    whirl_table table; ///< of these points alone, with their slots and without blocks
    size_t *points;    ///< [table.count] which points of the whole table they are; owns what the table points to
} finished;

whirl_status finished_points(const whirl_table *whole, finished *points);
void finished_free(finished *points);

#endif
