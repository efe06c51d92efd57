/// The derivative of one station's acceleration by its own displacement and velocity.
#ifndef ROTOR_TANGENT_H
#define ROTOR_TANGENT_H

#include "block.h"

/// Derivatives of x'' and of y'' by x, y, x', y'.
typedef struct tangent_block {
    vec x[4], y[4];
} tangent_block;

/// Applies the derivatives in vector k, for the first two ports of the element, to all perturbations.
static inline void tangent_apply(const tangent_block *tangent, const element *own, const block *b, size_t k) {
    const size_t x = own->port[0] * b->stride + k, y = own->port[1] * b->stride + k;
    for (size_t n = 1; n <= b->perturbations; n++) {
        const vec *q = b->q + n * b->next, *v = b->v + n * b->next_v, perturbation[4] = {q[x], q[y], v[x], v[y]};
        vec *a = b->a + n * b->next_v;
        for (int i = 0; i < 4; i++) {
            a[x] = v_fma(tangent->x[i], perturbation[i], a[x]);
            a[y] = v_fma(tangent->y[i], perturbation[i], a[y]);
        }
    }
    if (!b->divergence) return;
    vec trace = v_add(of_trace(b, own->port[0], own->port[0], tangent->x[2]),
                      of_trace(b, own->port[1], own->port[1], tangent->y[3]));
    if (b->coupled)
        trace = v_add(trace, v_add(of_trace(b, own->port[0], own->port[1], tangent->x[3]),
                                   of_trace(b, own->port[1], own->port[0], tangent->y[2])));
    b->divergence[k] = v_add(b->divergence[k], trace);
}

#endif
