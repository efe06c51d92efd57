/// What the kernels of a call work on: vectors of one instruction set.
///
/// Rotors side by side, each lane at its own time and on its own sides of the switches, with perturbations.
#ifndef ROTOR_BLOCK_H
#define ROTOR_BLOCK_H

#include "coupling.h"
#include "element.h"
#include "vector.h"

typedef struct block {
    size_t stride, vectors;
    size_t perturbations;
    size_t next, next_v;   ///< vectors from the positions of one state or perturbation to the next, and of the rest
    size_t forcing_stride; ///< vectors from one value of time to the next
    const vec *forcing, *q, *v;
    const vec *turned;    ///< derivatives of the values of time by the shaft's phase, where that is a state; else NULL
    size_t phase;         ///< that state's row among the rates
    vec *a, *divergence;  ///< divergence: NULL where it is not wanted
    const vec *numbers;   ///< of the machine
    const size_t *places; ///< of those of its parts; NULL: each has its own
    const vec *sides;     ///< of its switches; NULL: the state decides
    const coupling *coupled; ///< by masses; NULL where none are
} block;

/// Those of an element, of the first vector.
static inline const vec *numbers_of(const block *b, const element *own) {
    return b->numbers + (b->places ? b->places[own->part] : own->first_number) * b->stride;
}
static inline const vec *sides_of(const block *b, const element *own) {
    return b->sides ? b->sides + own->first_switch * b->stride : NULL;
}

/// A block of one vector, as large machines have it, where compilers see that it is one: no loop is left, and no
/// distance to compute.
static inline block single(const block *b) {
    block one = *b;
    one.stride = one.vectors = 1;
    return one;
}

/// What perturbation n is to the shaft's phase, of vector k.
static inline vec phase_of(const block *b, size_t n, size_t k) {
    return b->turned ? b->v[n * b->next_v + b->phase * b->stride + k] : v_set(0.0);
}

static inline int wants_tangent(const block *b) {
    return b->perturbations > 0 || b->divergence;
}

/// What a derivative, of the acceleration that forces give the coordinate `row` alone by the velocity of `by`, is of
/// the trace.
static inline vec of_trace(const block *b, size_t row, size_t by, vec derivative) {
    if (b->coupled) return v_mul(v_set(coupling_share(b->coupled, by, row)), derivative);
    return row == by ? derivative : v_set(0.0);
}

#endif
