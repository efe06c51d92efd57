/// The oil film of a short journal bearing, pi film (Capone 1991).
///
/// ' = d/dtau, c the clearance, film thickness h = c - x cos phi - y sin phi; lengths in any unit, that of the rotor
/// here. With
///
///     A = x - 2y',  B = y + 2x',  C = sqrt(A^2 + B^2),  q = c^2 - x^2 - y^2
///
/// the film begins at alpha = atan2(-B, -A), so that cos alpha = -A/C and sin alpha = -B/C need no angle. Capone's
/// G, V, S and the force on the journal (fx, fy) = -(C/q)(3xV - sin a G - 2 cos a S, 3yV + cos a G - 2 sin a S), where
/// lengths are in clearances, become, with P = xB - yA, U = xA + yB, W = C sqrt q and W^2 + P^2 = C^2 - U^2 (which
/// saves a cancellation near the wall),
///
///     G = (2/sqrt q) angle,   angle = pi/2 + atan(P/W),   S = -U C/D,   D = W^2 + P^2,   C V = (2C + P G)/q,
///     (fx, fy) = -(2c^2/q^(3/2)) (x M + B angle - A E, y M - A angle - B E),   M = 3(W + P angle)/q,   E = U W/D.
///
/// The scale of the force is F0 = mu omega R L (R/c)^2 (L/2R)^2 = mu omega R L^3/(4 c^2).
#ifndef ROTOR_FILM_KERNEL_H
#define ROTOR_FILM_KERNEL_H

#include "../../element.h"
#include "elementary.h"
#include "vector.h"

/// 2/3^(3/2): the factor 2/q^(3/2) of the force is this number times sqrt(3/q)^3.
#define FILM_STRENGTH_OF_1 0.384900179459750509673

/// Numbers: c and c^2 in length scales; FILM_STRENGTH_OF_1 c^2 times the count times F0/(m omega^2 length scale); 2
/// divided by the shaft's speed by tau, which converts velocities by tau to velocities by the shaft's angle (2 if
/// sections are defined by the shaft's phase); pi/2, negative if the shaft turns clockwise.
///
/// For a clockwise shaft the force is the mirror image (x, -y) of that of the mirrored journal: A, U and E are the
/// same, while y, B, P and angle have the opposite sign.
enum { FILM_CLEARANCE, FILM_CLEARANCE_SQUARE, FILM_STRENGTH, FILM_TWICE, FILM_QUARTER, FILM_NUMBERS };

/// Maximum number of vectors that may be in a film at the same time.
enum { FILM_PLACES = 4 };

/// Vectors on their way through a film in three phases, place by place: film_begin, at the end of which the CPU's
/// divider computes a root; film_divide, at the end of which it computes a division; film_end. Phases of other vectors,
/// and other elements, hide its latency.
///
/// A journal at rest in the centre (A = B = 0) feels no force; the 2^-600 in C^2 keeps its quotients finite. Beyond the
/// wall (q < 0) W is not a number, and the motion counts as diverged.
typedef struct film_work {
    struct {
        vec x, y, A, B, P, W;
        vec q, D; ///< after film_divide sqrt(3/q) and 1/D
    } at[FILM_PLACES];
} film_work;

static inline void film_place(film_work *w, size_t at, vec clearance_square, vec x, vec y, vec A, vec B) {
    const vec q = v_fnma(y, y, v_fnma(x, x, clearance_square));
    const vec CC = v_fma(A, A, v_fma(B, B, v_set(0x1p-600))), WW = v_mul(q, CC);
    const vec P = v_fms(x, B, v_mul(y, A));
    w->at[at].x = x;
    w->at[at].y = y;
    w->at[at].A = A;
    w->at[at].B = B;
    w->at[at].q = q;
    w->at[at].P = P;
    w->at[at].D = v_fma(P, P, WW);
    w->at[at].W = v_sqrt(WW);
}

/// Begins the film at a place. two: the number FILM_TWICE.
static inline void film_begin(const element *film, size_t stride, const vec *number, vec two, const vec *q,
                              const vec *v, film_work *w, size_t at) {
    const size_t i = film->port[0] * stride, j = film->port[1] * stride;
    const vec x = q[i], y = q[j];
    film_place(w, at, number[FILM_CLEARANCE_SQUARE * stride], x, y, v_fnma(two, v[j], x), v_fma(two, v[i], y));
}

static inline void film_divide(film_work *w, size_t at) {
    w->at[at].D = v_div(v_set(1.0), w->at[at].D);
    w->at[at].q = v_root_of_3_over(w->at[at].q);
}

/// Quantities from which the force is computed.
typedef struct film_state {
    vec x, y, A, B, P, W, angle;
    vec root;           ///< sqrt(3/q)
    vec over_D, W_by_D; ///< 1/D, W/D
} film_state;

/// Ends the film. quarter: the number FILM_QUARTER. Computes atan(P/W) from half the cosine and half the sine of its
/// double, W^2/D - 1/2 and P W/D.
static inline film_state film_end(const film_work *w, size_t at, vec quarter) {
    const vec P = w->at[at].P, W = w->at[at].W, over_D = w->at[at].D, W_by_D = v_mul(W, over_D);
    const vec arctangent = v_half_angle(v_fms(W, W_by_D, v_set(0.5)), v_mul(P, W_by_D));
    const vec angle = v_add(quarter, arctangent);
    return (film_state){w->at[at].x, w->at[at].y, w->at[at].A, w->at[at].B, P, W, angle, w->at[at].q, over_D, W_by_D};
}

/// Adds `strength`/FILM_STRENGTH_OF_1 times the force to (fx, fy).
static inline void film_add(const film_state *f, vec strength, vec *fx, vec *fy) {
    const vec three_over_q = v_mul(f->root, f->root), scale = v_mul(v_mul(strength, three_over_q), f->root);
    const vec U = v_fma(f->x, f->A, v_mul(f->y, f->B)), E = v_mul(U, f->W_by_D);
    const vec M = v_mul(three_over_q, v_fma(f->P, f->angle, f->W));
    *fx = v_fnma(scale, v_fma(f->x, M, v_fms(f->B, f->angle, v_mul(f->A, E))), *fx);
    *fy = v_fnma(scale, v_fms(f->y, M, v_fma(f->A, f->angle, v_mul(f->B, E))), *fy);
}

#endif
