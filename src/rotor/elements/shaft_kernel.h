/// A massless elastic shaft with two unequal principal stiffnesses k1, k2 that turn with it.
///
/// With kbar = (k1 + k2)/2, dk = (k1 - k2)/2 and the principal axis of k1 along x at tau = 0, the force on a station
/// that is displaced by (dx, dy) from the other is
///
///     -[ kbar + dk cos 2tau     dk sin 2tau        ] (dx)
///      [ dk sin 2tau            kbar - dk cos 2tau ] (dy)
///
/// (`signs: derived`; Friswell et al. 2010, section 7.3). The paper of 2015 prints + dk cos 2tau in both diagonal
/// entries
/// (`signs: paper`): no turning shaft does that, x + y and x - y become two Mathieu oscillators.
#ifndef ROTOR_SHAFT_KERNEL_H
#define ROTOR_SHAFT_KERNEL_H

#include "../element.h"
#include "vector.h"

/// kbar and dk over m omega^2 at either station.
enum { SHAFT_MEAN_A, SHAFT_HALF_A, SHAFT_MEAN_B, SHAFT_HALF_B, SHAFT_NUMBERS };
enum { SHAFT_SIGNS_DERIVED, SHAFT_SIGNS_PAPER };

/// c and s: cos 2tau, sin 2tau. Linear, so that it takes disturbances too.
static inline void shaft_kernel(const element *shaft, vec c, vec s, size_t stride, const vec *number, const vec *q,
                                vec *a) {
    const size_t x = shaft->port[0] * stride, y = shaft->port[1] * stride;
    const size_t other_x = shaft->port[2] * stride, other_y = shaft->port[3] * stride;
    const int grounded = shaft->port[2] == NO_COORDINATE;
    const vec dx = grounded ? q[x] : v_sub(q[x], q[other_x]);
    const vec dy = grounded ? q[y] : v_sub(q[y], q[other_y]);
    // The force over its scale is -(mean (dx, dy) + half (turn_x, turn_y)).
    const vec turn_x = v_fma(c, dx, v_mul(s, dy));
    const vec across = v_mul(s, dx);
    const vec turn_y = shaft->law == SHAFT_SIGNS_PAPER ? v_fma(c, dy, across) : v_fnma(c, dy, across);
    const vec mean = number[SHAFT_MEAN_A * stride], half = number[SHAFT_HALF_A * stride];
    const vec ax = v_fnma(mean, dx, v_fnma(half, turn_x, a[x]));
    const vec ay = v_fnma(mean, dy, v_fnma(half, turn_y, a[y]));
    if (!grounded) {
        const vec mean_b = number[SHAFT_MEAN_B * stride], half_b = number[SHAFT_HALF_B * stride];
        const vec bx = v_fma(mean_b, dx, v_fma(half_b, turn_x, a[other_x]));
        const vec by = v_fma(mean_b, dy, v_fma(half_b, turn_y, a[other_y]));
        a[other_x] = bx;
        a[other_y] = by;
    }
    a[x] = ax;
    a[y] = ay;
}

#endif
