// Shapes of datasets.
#ifndef STORE_SHAPE_H
#define STORE_SHAPE_H

#include <stddef.h>

enum { SHAPE_MAX_RANK = 5 }; ///< of a dataset: rows and columns of points, stations, rows, columns

/// How values lie: in a list, or in rows and columns, one row after the other.
typedef struct shape {
    int rank; ///< 1 or 2
    size_t sizes[2];
} shape;

static inline shape list_of(size_t count) {
    return (shape){1, {count, 1}};
}

static inline size_t shape_count(shape of) {
    return of.sizes[0] * of.sizes[1];
}

#endif
