/// The station pass: damping, unbalance and constant pull; it initializes the accelerations to which elements add.
///
/// x'' = (U cos tau - W sin tau) + pull_x - d x',    y'' = (U sin tau + W cos tau) + pull_y - d y'
#ifndef ROTOR_STATION_KERNEL_H
#define ROTOR_STATION_KERNEL_H

#include "../../element.h"
#include "vector.h"

/// Computes the accelerations by damping and pull alone.
static inline void station_balanced(size_t stride, const vec *number, const vec *v, vec *a) {
    const vec damping = number[STATION_DAMPING * stride];
    a[0] = v_fnma(damping, v[0], number[STATION_PULL_X * stride]);
    a[stride] = v_fnma(damping, v[stride], number[STATION_PULL_Y * stride]);
}

/// Computes the accelerations; c and s: cos tau, sin tau.
static inline void station_kernel(vec c, vec s, size_t stride, const vec *number, const vec *v, vec *a) {
    const vec in_phase = number[STATION_UNBALANCE_COS * stride], ahead = number[STATION_UNBALANCE_SIN * stride];
    const vec damping = number[STATION_DAMPING * stride];
    const vec ax = v_fnma(damping, v[0], number[STATION_PULL_X * stride]);
    const vec ay = v_fnma(damping, v[stride], number[STATION_PULL_Y * stride]);
    a[0] = v_fma(in_phase, c, v_fnma(ahead, s, ax));
    a[stride] = v_fma(in_phase, s, v_fma(ahead, c, ay));
}

/// Computes the accelerations of a perturbation, on which only damping acts.
static inline void station_tangent(size_t stride, const vec *number, const vec *v, vec *a) {
    const vec damping = v_sub(v_set(0.0), number[STATION_DAMPING * stride]);
    a[0] = v_mul(damping, v[0]);
    a[stride] = v_mul(damping, v[stride]);
}

#endif
