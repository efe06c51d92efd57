/// The derivative of a film's force on its journal (film_kernel.h), in closed form.
///
/// The force is f = -(1/q)(X, Y) with X = x T + B G + A S, Y = y T - A G + B S, where T = 3(2C + P G)/q, S = -E U,
/// E = 2C/D. It depends on x, y and (A, B), which is taken in polar form: the force is proportional to C = |(A, B)|,
/// and by the angle beta of (A, B) (dA = -B, dB = A) P, U and G have the derivatives U, -P and E U. At fixed A, B, with
/// D_x = -2 A U,
///
///     G_x = E B + x H,   G_y = -E A + y H,   H = (E P + G)/q,
///     S_x = -A K,   S_y = -B K,   S_beta = P K,   K = E (1 + 2 U^2/D),
///     T_x = (3(B G + P G_x) + 2 x T)/q,   T_y = (3(-A G + P G_y) + 2 y T)/q,   T_beta = 3(U G + P E U)/q.
///
/// None of the sums cancels near the wall. Then d/dx' = 2 d/dB and d/dy' = -2 d/dA.
#ifndef ROTOR_FILM_TANGENT_H
#define ROTOR_FILM_TANGENT_H

#include "elements/tangent.h"
#include "film_kernel.h"

/// The quantities of the formulas above.
typedef struct film_slopes {
    vec x, y, A, B, P, U, G, S, T, E, K, over_q;
} film_slopes;

static inline vec film_over_root(const film_state *f) {
    return v_mul(v_set(0.57735026918962576451), f->root);
}

static inline film_slopes film_slope(const film_state *f) {
    film_slopes s = {.x = f->x, .y = f->y, .A = f->A, .B = f->B, .P = f->P};
    const vec over_root = film_over_root(f), twice_root = v_add(over_root, over_root);
    const vec twice = v_mul(f->W, twice_root); // 2C
    s.over_q = v_mul(over_root, over_root);
    s.U = v_fma(s.x, s.A, v_mul(s.y, s.B));
    s.G = v_mul(f->angle, twice_root);
    s.E = v_mul(twice, f->over_D);
    s.S = v_sub(v_set(0.0), v_mul(s.E, s.U));
    s.T = v_mul(v_set(3.0), v_mul(v_fma(s.P, s.G, twice), s.over_q));
    s.K = v_mul(s.E, v_fma(v_mul(v_set(2.0), s.U), v_mul(s.U, f->over_D), v_set(1.0)));
    return s;
}

/// Computes -q times the derivatives of the force by x at fixed A and B.
static inline void film_slope_x(const film_slopes *s, vec *X, vec *Y) {
    const vec H = v_mul(v_fma(s->E, s->P, s->G), s->over_q);
    const vec G = v_fma(s->E, s->B, v_mul(s->x, H)), S = v_sub(v_set(0.0), v_mul(s->A, s->K));
    const vec sum = v_mul(v_set(3.0), v_fma(s->B, s->G, v_mul(s->P, G)));
    const vec T = v_mul(v_fma(v_add(s->x, s->x), s->T, sum), s->over_q);
    *X = v_add(s->T, v_fma(s->x, T, v_fma(s->B, G, v_mul(s->A, S))));
    *Y = v_fma(s->y, T, v_fnma(s->A, G, v_mul(s->B, S)));
}

/// Computes -q times the derivatives of the force by y at fixed A and B.
static inline void film_slope_y(const film_slopes *s, vec *X, vec *Y) {
    const vec H = v_mul(v_fma(s->E, s->P, s->G), s->over_q);
    const vec G = v_fnma(s->E, s->A, v_mul(s->y, H)), S = v_sub(v_set(0.0), v_mul(s->B, s->K));
    const vec sum = v_mul(v_set(3.0), v_fnma(s->A, s->G, v_mul(s->P, G)));
    const vec T = v_mul(v_fma(v_add(s->y, s->y), s->T, sum), s->over_q);
    *X = v_fma(s->x, T, v_fma(s->B, G, v_mul(s->A, S)));
    *Y = v_add(s->T, v_fma(s->y, T, v_fnma(s->A, G, v_mul(s->B, S))));
}

/// Computes -q times the derivatives of the force by the angle of (A, B).
static inline void film_slope_angle(const film_slopes *s, vec *X, vec *Y) {
    const vec G = v_mul(s->E, s->U), S = v_mul(s->P, s->K);
    const vec T = v_mul(v_mul(v_set(3.0), v_fma(s->U, s->G, v_mul(s->P, G))), s->over_q);
    *X = v_fma(s->x, T, v_fma(s->A, s->G, v_fma(s->B, G, v_fnma(s->B, s->S, v_mul(s->A, S)))));
    *Y = v_fma(s->y, T, v_fma(s->B, s->G, v_fnma(s->A, G, v_fma(s->A, s->S, v_mul(s->B, S)))));
}

/// Computes the derivatives of `strength`/FILM_STRENGTH_OF_1 times the force by x, y, x' and y'. At rest in the centre,
/// where the force has a corner, the derivatives by the velocities are zero.
static inline void film_tangent(const film_state *f, vec strength, vec twice, tangent_block *tangent) {
    const film_slopes s = film_slope(f);
    const vec zero = v_set(0.0), two = v_set(2.0), C = v_mul(f->W, film_over_root(f));
    const vec over_C = v_select(v_less(zero, C), v_div(v_set(1.0), v_max(C, v_set(0x1p-1022))), zero);
    const vec c = v_mul(s.A, over_C), d = v_mul(s.B, over_C); // cos beta, sin beta
    // Compute the force in the film's frame, and its derivatives by displacement and by the frame's angle.
    const vec factor = v_mul(v_set(-1.0 / FILM_STRENGTH_OF_1), v_mul(strength, s.over_q));
    const vec X = v_fma(s.x, s.T, v_fma(s.B, s.G, v_mul(s.A, s.S)));
    const vec Y = v_fma(s.y, s.T, v_fnma(s.A, s.G, v_mul(s.B, s.S)));
    vec by_x[2], by_y[2], by_angle[2];
    film_slope_x(&s, &by_x[0], &by_x[1]);
    film_slope_y(&s, &by_y[0], &by_y[1]);
    film_slope_angle(&s, &by_angle[0], &by_angle[1]);
    const vec force[2] = {X, Y}, steep_x = v_mul(v_mul(two, s.x), s.over_q), steep_y = v_mul(v_mul(two, s.y), s.over_q);
    // Turn them back to x and y, row by row.
    vec *const rows[2] = {tangent->x, tangent->y};
    for (int i = 0; i < 2; i++) {
        const vec along = v_mul(force[i], over_C), across = v_mul(by_angle[i], over_C);
        const vec by_A = v_fnma(d, across, v_mul(c, along)), by_B = v_fma(c, across, v_mul(d, along));
        rows[i][0] = v_mul(factor, v_add(by_A, v_fma(steep_x, force[i], by_x[i])));
        rows[i][1] = v_mul(factor, v_add(by_B, v_fma(steep_y, force[i], by_y[i])));
        rows[i][2] = v_mul(factor, v_mul(twice, by_B));
        rows[i][3] = v_mul(factor, v_mul(v_sub(zero, twice), by_A));
    }
}

#endif
