/// The oil film of a short journal bearing, pi film (Capone 1991).
///
/// Lengths in clearances, ' = d/dtau, film thickness h = 1 - x cos phi - y sin phi. With
///
///     A = x - 2y',  B = y + 2x',  C = sqrt(A^2 + B^2),  q = 1 - x^2 - y^2
///
/// the film begins at alpha = atan2(-B, -A), so that cos alpha = -A/C and sin alpha = -B/C need no angle. Capone's
/// G, V, S and the force on the journal (fx, fy) = -(C/q)(3xV - sin a G - 2 cos a S, 3yV + cos a G - 2 sin a S)
/// become, with P = xB - yA, U = xA + yB and C^2 - U^2 = q C^2 + P^2 (which saves a cancellation near the wall),
///
///     G = (2/sqrt q)[pi/2 + atan(P/(C sqrt q))],   S = -U C/(q C^2 + P^2),   C V = (2C + P G)/q,
///     (fx, fy) = -(1/q)(3x CV + B G + 2A S, 3y CV - A G + 2B S).
///
/// The scale of the force is F0 = mu omega R L (R/c)^2 (L/2R)^2 = mu omega R L^3/(4 c^2).
#ifndef ROTOR_FILM_KERNEL_H
#define ROTOR_FILM_KERNEL_H

#include "arctan.h"
#include "element.h"
#include "vector.h"

/// Length scale over clearance; count F0/(m omega^2 length scale).
enum { FILM_TO_CLEARANCES, FILM_STRENGTH, FILM_NUMBERS };

/// Adds strength times the film's force to (fx, fy). Beyond the wall (q < 0) the root is not a number: the motion then
/// counts as diverged.
static inline void film_force(vec x, vec y, vec vx, vec vy, vec strength, vec *fx, vec *fy) {
    const vec tiny = v_set(0x1p-960); // a journal at rest in the centre (C = 0) feels no force
    const vec A = v_fnma(v_set(2.0), vy, x), B = v_fma(v_set(2.0), vx, y);
    const vec q = v_fnma(y, y, v_fnma(x, x, v_set(1.0)));
    const vec CC = v_fma(A, A, v_mul(B, B));
    const vec C = v_sqrt(CC), root = v_sqrt(q);
    const vec P = v_fms(x, B, v_mul(y, A)), U = v_fma(x, A, v_mul(y, B));
    const vec D = v_fma(q, CC, v_fma(P, P, tiny));
    // One division for 1/q and 1/D.
    const vec both = v_div(v_set(1.0), v_mul(q, D));
    const vec over_q = v_mul(D, both), over_D = v_mul(q, both);
    const vec angle = v_arctan_quotient(P, v_fma(C, root, tiny));
    const vec G = v_mul(v_fma(v_set(2.0), angle, v_set(3.14159265358979323846)), v_mul(root, over_q));
    const vec S2 = v_mul(v_mul(v_set(-2.0), U), v_mul(C, over_D));
    const vec CV3 = v_mul(v_set(3.0), v_mul(v_fma(P, G, v_add(C, C)), over_q));
    const vec scale = v_mul(strength, over_q);
    *fx = v_fnma(scale, v_fma(x, CV3, v_fma(B, G, v_mul(A, S2))), *fx);
    *fy = v_fnma(scale, v_fma(y, CV3, v_fnma(A, G, v_mul(B, S2))), *fy);
}

static inline void film_kernel(const element *film, size_t stride, const vec *number, const vec *q, const vec *v,
                               vec *a) {
    const size_t x = 2 * film->station[0] * stride, y = x + stride;
    const vec scale = number[FILM_TO_CLEARANCES * stride];
    film_force(v_mul(scale, q[x]), v_mul(scale, q[y]), v_mul(scale, v[x]), v_mul(scale, v[y]),
               number[FILM_STRENGTH * stride], &a[x], &a[y]);
}

#endif
