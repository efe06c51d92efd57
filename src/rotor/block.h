/// Arguments of kernels: vectors of one instruction set.
///
/// Each lane holds one rotor, with its own time, sides of the switches and perturbations.
#ifndef ROTOR_BLOCK_H
#define ROTOR_BLOCK_H

#include "coupling.h"
#include "element.h"
#include "vector.h"

typedef struct block {
    size_t stride, vectors;
    size_t perturbations;
    /// Number, from 0, of the perturbation that is 1 in each position, and in each velocity or state; perturbations are
    /// 0 elsewhere. NULL: they are any vectors.
    const size_t *unit_q, *unit_v;
    size_t next, next_v; ///< distances, in vectors, from the displacements of one state or perturbation to those of the
                         ///< next (in q), and likewise for the other states (in v)
    size_t forcing_stride; ///< distance in vectors between numbers of the forcing
    const vec *forcing, *q, *v;
    const vec *turned;       ///< derivatives of the forcing by the shaft's phase if that is a state; otherwise NULL
    size_t phase;            ///< row of that state among the rates
    vec *a, *divergence;     ///< divergence: NULL unless requested
    const vec *numbers;      ///< numbers of the machine
    const size_t *places;    ///< start of each part's numbers; NULL: that of an element is its first_number
    const vec *sides;        ///< sides of its switches; NULL: the state decides
    const coupling *coupled; ///< coupling of accelerations by masses, or NULL
} block;

/// Returns the numbers of an element, for the first vector.
static inline const vec *numbers_of(const block *b, const element *own) {
    return b->numbers + (b->places ? b->places[own->part] : own->first_number) * b->stride;
}
static inline const vec *sides_of(const block *b, const element *own) {
    return b->sides ? b->sides + own->first_switch * b->stride : NULL;
}

/// Returns the block with its stride and count of vectors as the constant 1, which they are for large machines.
/// Compilers then remove loops and strides.
static inline block single(const block *b) {
    block one = *b;
    one.stride = one.vectors = 1;
    return one;
}

/// Returns perturbation n of the shaft's phase, for vector k.
static inline vec phase_of(const block *b, size_t n, size_t k) {
    return b->turned ? b->v[n * b->next_v + b->phase * b->stride + k] : v_set(0.0);
}

/// Returns the accelerations of perturbation `unit`, from 0.
static inline vec *column_of(const block *b, size_t unit) {
    return b->a + (1 + unit) * b->next_v;
}

static inline int wants_tangent(const block *b) {
    return b->perturbations > 0 || b->divergence;
}

/// Returns the contribution of `derivative` to the trace of the Jacobian. `derivative`: that of the acceleration of the
/// coordinate `row`, without mass coupling, by the velocity of the coordinate `by`.
static inline vec of_trace(const block *b, size_t row, size_t by, vec derivative) {
    if (b->coupled) return v_mul(v_set(coupling_share(b->coupled, by, row)), derivative);
    return row == by ? derivative : v_set(0.0);
}

#endif
