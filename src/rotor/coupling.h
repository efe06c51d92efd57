/// Masses that couple coordinates: the entries of a mass matrix beside each coordinate's own inertia.
///
/// Elements, stations and linear terms give g = F / (own inertia), coordinate by coordinate; where masses couple, the
/// accelerations are a = C g with C = M^-1 diag(own inertia), scaled as the assembly scales.
#ifndef ROTOR_COUPLING_H
#define ROTOR_COUPLING_H

#include "assembly.h"

typedef struct coupling {
    size_t count;  ///< coordinates that are coupled
    size_t *row;   ///< [count] which these are, those that couple with one another side by side
    size_t *end;   ///< [count] before which these end
    size_t *place; ///< [degrees] where they are among them; NO_COORDINATE of the others
    double *share; ///< [count][count] C
} coupling;

/// C: the acceleration of `row` for the acceleration that a force on `by` would give it alone.
static inline double coupling_share(const coupling *in, size_t row, size_t by) {
    const size_t i = in->place[row], j = in->place[by];
    if (i == NO_COORDINATE || j == NO_COORDINATE) return row == by ? 1.0 : 0.0;
    return in->share[i * in->count + j];
}

/// How many coordinates the assembly's masses couple.
size_t coupling_count(const assembly *from);

/// Fills in all, for which there is room. WHIRL_BAD_INPUT where the mass matrix is not positive definite.
whirl_status coupling_fill(coupling *out, const assembly *from);

#endif
