/// A massless elastic shaft with two unequal principal stiffnesses k1, k2 that turn with it.
///
/// With kbar = (k1 + k2)/2, dk = (k1 - k2)/2 and the principal axis of k1 along x at tau = 0, the force on a station
/// that is displaced by (dx, dy) from the other is
///
///     -[ kbar + dk cos 2tau     dk sin 2tau        ] (dx)
///      [ dk sin 2tau            kbar - dk cos 2tau ] (dy)
///
/// (`signs: derived`; Friswell et al. 2010, section 7.3). The paper of 2015 prints + dk cos 2tau in both diagonal
/// numbers (`signs: paper`). No turning shaft does that: x + y and x - y become two Mathieu oscillators.
#ifndef ROTOR_SHAFT_KERNEL_H
#define ROTOR_SHAFT_KERNEL_H

#include "../../element.h"
#include "vector.h"

/// Numbers: kbar and dk divided by m omega^2, for each of the two stations.
enum { SHAFT_MEAN_A, SHAFT_HALF_A, SHAFT_MEAN_B, SHAFT_HALF_B, SHAFT_NUMBERS };
enum { SHAFT_SIGNS_DERIVED, SHAFT_SIGNS_PAPER };

/// One end: the rows of its displacements and accelerations along x; the rows along y follow a stride later.
typedef struct shaft_end {
    const vec *q;
    vec *a;
} shaft_end;

/// Adds the forces for vector k; c and s: cos 2tau, sin 2tau. The forces are linear, so that this also serves
/// perturbations. turned: c and s are their derivatives by the phase, and the mean stiffness is left out.
VECTOR_INLINE void shaft_add(int law, int grounded, int turned, vec c, vec s, size_t stride, size_t k,
                             const vec *number, const shaft_end *here, const shaft_end *there) {
    const size_t y = stride + k;
    const vec dx = grounded ? here->q[k] : v_sub(here->q[k], there->q[k]);
    const vec dy = grounded ? here->q[y] : v_sub(here->q[y], there->q[y]);
    // The force divided by its scale is -(mean (dx, dy) + half (turn_x, turn_y)).
    const vec turn_x = v_fma(c, dx, v_mul(s, dy));
    const vec across = v_mul(s, dx);
    const vec turn_y = law == SHAFT_SIGNS_PAPER ? v_fma(c, dy, across) : v_fnma(c, dy, across);
    const vec mean = turned ? v_set(0.0) : number[SHAFT_MEAN_A * stride + k], half = number[SHAFT_HALF_A * stride + k];
    here->a[k] = v_fnma(mean, dx, v_fnma(half, turn_x, here->a[k]));
    here->a[y] = v_fnma(mean, dy, v_fnma(half, turn_y, here->a[y]));
    if (grounded) return;
    const vec mean_b = turned ? v_set(0.0) : number[SHAFT_MEAN_B * stride + k];
    const vec half_b = number[SHAFT_HALF_B * stride + k];
    there->a[k] = v_fma(mean_b, dx, v_fma(half_b, turn_x, there->a[k]));
    there->a[y] = v_fma(mean_b, dy, v_fma(half_b, turn_y, there->a[y]));
}

/// Adds the forces for the first vector.
VECTOR_INLINE void shaft_kernel(const element *shaft, vec c, vec s, size_t stride, const vec *number, const vec *q,
                                vec *a) {
    const int grounded = shaft->port[2] == NO_COORDINATE;
    const size_t x = shaft->port[0] * stride, other = grounded ? x : shaft->port[2] * stride;
    shaft_add(shaft->law, grounded, false, c, s, stride, 0, number, &(shaft_end){q + x, a + x},
              &(shaft_end){q + other, a + other});
}

#endif
