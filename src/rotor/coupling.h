/// Mass coupling: off-diagonal numbers of the mass matrix.
///
/// Elements, stations and linear terms compute g = F/(own inertia) for every coordinate alone. With mass coupling the
/// accelerations are a = C g with C = M^-1 diag(own inertia), in the units of the assembly.
#ifndef ROTOR_COUPLING_H
#define ROTOR_COUPLING_H

#include "assembly.h"

enum { COUPLING_MARGIN = 16 }; ///< numbers behind each column, which kernels may read

typedef struct coupling {
    size_t count;    ///< number of coupled coordinates
    size_t *row;     ///< [count] their indices; those of one group are adjacent
    size_t *end;     ///< [count] end of the group of each coordinate
    size_t *place;   ///< [degrees] index among the coupled coordinates; NO_COORDINATE for others
    double *share;   ///< [count][count] C
    double *columns; ///< [count + 1][apart] C, column by column; 0 where no row is
    size_t apart;    ///< distance of columns: count + COUPLING_MARGIN
} coupling;

/// Returns a number of C: the acceleration of `row` by a force that would give `by` alone an acceleration of 1.
static inline double coupling_share(const coupling *in, size_t row, size_t by) {
    const size_t i = in->place[row], j = in->place[by];
    if (i == NO_COORDINATE || j == NO_COORDINATE) return row == by ? 1.0 : 0.0;
    return in->share[i * in->count + j];
}

/// Returns the number of coordinates that the assembly's masses couple.
size_t coupling_count(const assembly *from);

/// Fills in all arrays, which the caller allocates. WHIRL_BAD_INPUT if the mass matrix is not positive definite.
whirl_status coupling_fill(coupling *out, const assembly *from);

#endif
