/// Mass coupling: off-diagonal entries of the mass matrix.
///
/// Elements, stations and linear terms give g = F / (own inertia), coordinate by coordinate; with mass coupling the
/// accelerations are a = C g with C = M^-1 diag(own inertia), scaled as the assembly scales.
#ifndef ROTOR_COUPLING_H
#define ROTOR_COUPLING_H

#include "assembly.h"

typedef struct coupling {
    size_t count;  ///< number of coupled coordinates
    size_t *row;   ///< [count] their indices; those of one group are adjacent
    size_t *end;   ///< [count] end of the group of each coordinate
    size_t *place; ///< [degrees] index among the coupled ones; NO_COORDINATE for others
    double *share; ///< [count][count] C
} coupling;

/// Entry of C: the acceleration of `row` per acceleration that a force on `by` would give that alone.
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
