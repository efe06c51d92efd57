/// What the force of a film of finite length has over that of a short one: both without negative pressures (Guembel's
/// condition), closed around the journal.
///
/// With the quantities of film_kernel.h and a journal that turns counter-clockwise the force is (R + i I) (fx + i fy),
/// (fx, fy) Capone's. By the symmetry of Reynolds' equation R is even and I odd in p, and
///
///     R = sum R_mn p^m b^n,   I = sum I_mn p^m b^n,   p = g U/(C c),   b = g 2/pi atan(P/W),
///
/// sums over m/FILM_IN_P + n/FILM_IN_B <= 1, of which film_table.h has the coefficients. Near the wall, where they are
/// not known, g takes p and b back towards the middle: g = 1 - (1 - FILM_BACK) z^2, z = max(0, 1 - q/(c^2 FILM_FOLD)),
/// q = c^2 - x^2 - y^2: 1 up to the eccentricity ratio .95, FILM_BACK at the wall, and continuous with its slope.
#ifndef ROTOR_FILM_RATIO_H
#define ROTOR_FILM_RATIO_H

#include "film_kernel.h"
#include "film_table.h"

#define FILM_FOLD 0.0975 ///< 1 - .95^2
#define FILM_BACK 0.8

/// The numbers of a film in a housing that moves, or of finite length, behind those of every film: by which its force
/// on the journal becomes that on the housing, along x and y, 0 where that is the ground; then of one of finite length
/// L/D, 1/c, 1/(c^2 FILM_FOLD) and 2/pi, below 0 where journal and housing turn clockwise, when P, the angle
/// and I have the other sign; and the coefficients.
enum {
    FILM_REACTION_X = FILM_NUMBERS,
    FILM_REACTION_Y,
    FILM_LENGTH,
    FILM_OVER_CLEARANCE,
    FILM_OVER_FOLD,
    FILM_TURNS,
    FILM_COEFFICIENT,
    FILM_ALL_NUMBERS = FILM_COEFFICIENT + FILM_COEFFICIENTS
};

/// The law of an element with these numbers.
enum { FILM_OF_FINITE_LENGTH = 1 };

/// What film.c makes of films that its own kernel is not for; and the coefficients for a ratio L/D.
extern const element_type film_finite_type;
void film_coefficients(double length, double *number);

/// The coefficients: of the lanes, `stride` apart; or, where all lanes have the same, those, which is faster.
typedef struct film_series {
    const vec *lanes;
    size_t stride;
    const double *all;
} film_series;

VECTOR_INLINE vec film_coefficient(const film_series *of, size_t n) {
    return of->all ? v_set(of->all[n]) : of->lanes[n * of->stride];
}

/// Powers of b at p^m.
#define FILM_POWERS(m) (FILM_IN_B * (FILM_IN_P - (m)) / FILM_IN_P + 1)

/// R and I, and where `slopes` says so their derivatives by p and b.
typedef struct film_ratio {
    vec real, imaginary, real_p, imaginary_p, real_b, imaginary_b;
} film_ratio;

/// One of both as a polynomial in u = p^2: sum, derivatives by u and b.
VECTOR_INLINE void film_part(const film_series *of, size_t first, int odd, vec u, vec b, bool slopes, vec *sum,
                             vec *by_u, vec *by_b) {
    vec s = v_set(0.0), s_u = s, s_b = s;
    size_t end = first;
    for (int m = odd; m <= FILM_IN_P; m += 2) end += FILM_POWERS(m);
    for (int m = FILM_IN_P - (FILM_IN_P + odd) % 2; m >= 0; m -= 2) {
        const int count = FILM_POWERS(m);
        const size_t row = end - (size_t)count;
        vec c = film_coefficient(of, end - 1), slope = v_set(0.0);
        for (size_t n = end - 1; n-- > row;) {
            if (slopes) slope = v_fma(slope, b, c);
            c = v_fma(c, b, film_coefficient(of, n));
        }
        if (slopes) {
            s_u = v_fma(s_u, u, s);
            s_b = v_fma(s_b, u, slope);
        }
        s = v_fma(s, u, c);
        end = row;
    }
    *sum = s, *by_u = s_u, *by_b = s_b;
}

VECTOR_INLINE film_ratio film_ratio_at(const film_series *of, vec p, vec b, bool slopes) {
    size_t even = 0;
    for (int m = 0; m <= FILM_IN_P; m += 2) even += FILM_POWERS(m);
    const vec u = v_mul(p, p);
    film_ratio r;
    vec by_u, odd, odd_u, odd_b;
    film_part(of, 0, 0, u, b, slopes, &r.real, &by_u, &r.real_b);
    film_part(of, even, 1, u, b, slopes, &odd, &odd_u, &odd_b);
    r.imaginary = v_mul(p, odd);
    if (!slopes) return r;
    const vec twice = v_add(p, p);
    r.real_p = v_mul(twice, by_u);
    r.imaginary_p = v_fma(v_mul(twice, p), odd_u, odd);
    r.imaginary_b = v_mul(p, odd_b);
    return r;
}

/// p, b before they are taken back, g and its derivative by q.
typedef struct film_direction {
    vec p, b, g, g_q, over_C;
} film_direction;

VECTOR_INLINE film_direction film_direction_of(const film_state *f, size_t stride, const vec *number) {
    const vec CC = v_fma(f->A, f->A, v_fma(f->B, f->B, v_set(0x1p-600))),
              over_C = v_mul(v_set(0.57735026918962576451), v_root_of_3_over(CC));
    const vec U = v_fma(f->x, f->A, v_mul(f->y, f->B));
    const vec q = v_fnma(f->y, f->y, v_fnma(f->x, f->x, number[FILM_CLEARANCE_SQUARE * stride]));
    const vec over = number[FILM_OVER_FOLD * stride], one = v_set(1.0), most = v_set(1.0 - FILM_BACK);
    const vec z = v_max(v_set(0.0), v_fnma(q, over, one)), part = v_mul(most, z);
    film_direction d;
    d.over_C = over_C;
    d.p = v_mul(v_mul(U, over_C), number[FILM_OVER_CLEARANCE * stride]);
    d.b = v_fms(f->angle, number[FILM_TURNS * stride], one);
    d.g = v_fnma(part, z, one);
    d.g_q = v_mul(v_add(part, part), over);
    return d;
}

#endif
