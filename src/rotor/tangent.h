/// The derivative of one station's acceleration by its own place and velocity.
#ifndef ROTOR_TANGENT_H
#define ROTOR_TANGENT_H

#include "vector.h"

/// Derivatives of x'' and of y'' by x, y, x', y'.
typedef struct tangent_block {
    vec x[4], y[4];
} tangent_block;

/// Adds what the disturbance (q, v) of the station adds to its acceleration a; all point to the x of the station.
static inline void tangent_apply(const tangent_block *block, size_t stride, const vec *q, const vec *v, vec *a) {
    const vec disturbance[4] = {q[0], q[stride], v[0], v[stride]};
    for (int i = 0; i < 4; i++) {
        a[0] = v_fma(block->x[i], disturbance[i], a[0]);
        a[stride] = v_fma(block->y[i], disturbance[i], a[stride]);
    }
}

#endif
