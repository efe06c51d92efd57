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

#include "element.h"
#include "elementary.h"
#include "vector.h"

/// Length scale over clearance; count F0/(m omega^2 length scale).
enum { FILM_TO_CLEARANCES, FILM_STRENGTH, FILM_NUMBERS };

/// Vectors that go through the film together, phase by phase: their long chains of operations hide each other's latency.
enum { FILM_GROUP = 4 };

/// One group on its way. A journal at rest in the centre (C = 0) feels no force; beyond the wall (q <= 0) nothing is a number,
/// and the motion counts as diverged.
typedef struct film_group {
    vec x[FILM_GROUP], y[FILM_GROUP], A[FILM_GROUP], B[FILM_GROUP];
    vec over_root[FILM_GROUP];                            ///< 1/sqrt q
    vec C[FILM_GROUP], P[FILM_GROUP], over_D[FILM_GROUP]; ///< D = q C^2 + P^2
    vec angle[FILM_GROUP];                                ///< atan(P/(C sqrt q))
} film_group;

/// The roots, the reciprocal and the angle. One root and one division are the machine's, the others multiply-adds, so that
/// neither its divider nor its multipliers wait for the other.
static inline void film_angles(size_t n, film_group *g) {
    const vec tiny = v_set(0x1p-960);
    vec q[FILM_GROUP], CC[FILM_GROUP], D[FILM_GROUP];
    for (size_t j = 0; j < n; j++) {
        q[j] = v_fnma(g->y[j], g->y[j], v_fnma(g->x[j], g->x[j], v_set(1.0)));
        CC[j] = v_fma(g->A[j], g->A[j], v_mul(g->B[j], g->B[j]));
        g->P[j] = v_fms(g->x[j], g->B[j], v_mul(g->y[j], g->A[j]));
        D[j] = v_fma(q[j], CC[j], v_fma(g->P[j], g->P[j], tiny));
    }
    for (size_t j = 0; j < n; j++) g->C[j] = v_sqrt(CC[j]);
    for (size_t j = 0; j < n; j++) g->over_root[j] = v_inverse_root(q[j]);
    for (size_t j = 0; j < n; j++)
        g->angle[j] = v_arctan_quotient(g->P[j], v_fma(g->C[j], v_mul(q[j], g->over_root[j]), tiny));
    for (size_t j = 0; j < n; j++) g->over_D[j] = v_reciprocal(D[j]);
}

/// Adds `strength` times the force to (fx, fy).
static inline void film_add(const film_group *g, size_t j, vec strength, vec *fx, vec *fy) {
    const vec x = g->x[j], y = g->y[j], A = g->A[j], B = g->B[j], P = g->P[j], C = g->C[j];
    const vec over_q = v_mul(g->over_root[j], g->over_root[j]);
    const vec U = v_fma(x, A, v_mul(y, B));
    const vec G = v_mul(v_fma(v_set(2.0), g->angle[j], v_set(3.14159265358979323846)), g->over_root[j]);
    const vec S2 = v_mul(v_mul(v_set(-2.0), U), v_mul(C, g->over_D[j]));
    const vec CV3 = v_mul(v_set(3.0), v_mul(v_fma(P, G, v_add(C, C)), over_q));
    const vec scale = v_mul(strength, over_q);
    *fx = v_fnma(scale, v_fma(x, CV3, v_fma(B, G, v_mul(A, S2))), *fx);
    *fy = v_fnma(scale, v_fma(y, CV3, v_fnma(A, G, v_mul(B, S2))), *fy);
}

static inline void film_place(film_group *g, size_t j, vec x, vec y, vec vx, vec vy) {
    g->x[j] = x;
    g->y[j] = y;
    g->A[j] = v_fnma(v_set(2.0), vy, x);
    g->B[j] = v_fma(v_set(2.0), vx, y);
}

/// Loads n <= FILM_GROUP vectors and finds their angles.
static inline void film_load(const element *film, size_t n, size_t stride, const vec *number, const vec *q,
                             const vec *v, film_group *g) {
    const size_t x = 2 * film->station[0] * stride, y = x + stride;
    for (size_t j = 0; j < n; j++) {
        const vec scale = number[FILM_TO_CLEARANCES * stride + j];
        film_place(g, j, v_mul(scale, q[x + j]), v_mul(scale, q[y + j]), v_mul(scale, v[x + j]),
                   v_mul(scale, v[y + j]));
    }
    film_angles(n, g);
}

/// The film of n <= FILM_GROUP vectors.
static inline void film_kernel(const element *film, size_t n, size_t stride, const vec *number, const vec *q,
                               const vec *v, vec *a) {
    const size_t x = 2 * film->station[0] * stride, y = x + stride;
    film_group g;
    film_load(film, n, stride, number, q, v, &g);
    for (size_t j = 0; j < n; j++) film_add(&g, j, number[FILM_STRENGTH * stride + j], &a[x + j], &a[y + j]);
}

#endif
