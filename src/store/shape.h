/// Shapes of datasets.
#ifndef STORE_SHAPE_H
#define STORE_SHAPE_H

#include <stddef.h>

enum {
    SHAPE_AXES = 3,                 ///< dimensions of points: planes, rows, columns
    SHAPE_MAX_RANK = SHAPE_AXES + 3 ///< dimensions of a dataset: those of points, then stations, rows, columns
};

/// Arrangement of values: a list, a matrix row by row, or planes of matrices.
typedef struct shape {
    int rank; ///< 1 to SHAPE_AXES
    size_t sizes[SHAPE_AXES];
} shape;

static inline shape list_of(size_t count) {
    return (shape){1, {count}};
}

static inline size_t shape_count(shape of) {
    size_t count = 1;
    for (int i = 0; i < of.rank; ++i) count *= of.sizes[i];
    return count;
}

#endif
