/// Ratio of the force of a film of finite length to that of a short one. Both are without negative pressures (Guembel's
/// condition), and closed around the journal.
///
/// With the quantities of film_kernel.h and a journal that turns counter-clockwise the force is (R + i I) (fx + i fy),
/// where (fx, fy) is Capone's. By the symmetry of Reynolds' equation R is even and I odd in p, and
///
///     (R, I) = sum (R_mn, I_mn) p^m b^n/(1 + d_p p^2 + d_b b^2),   p = g U/(C c),   b = g 2/pi atan(P/W),
///
/// where the sums are over m/FILM_IN_P + n/FILM_IN_B <= 1, with the coefficients of film_table.h. Near the wall the
/// coefficients are not known. There g moves p and b back towards the middle: g = 1 - (1 - FILM_BACK) z^2 with
/// z = max(0, 1 - q/(c^2 FILM_FOLD)), q = c^2 - x^2 - y^2. g is 1 up to the eccentricity ratio .95, FILM_BACK at the
/// wall, and continuous with its slope.
#ifndef ROTOR_FILM_RATIO_H
#define ROTOR_FILM_RATIO_H

#include "film_kernel.h"
#include "film_table.h"

#define FILM_FOLD 0.0975 ///< 1 - .95^2
#define FILM_BACK 0.8

/// Numbers of a film in a moving housing, or of finite length, after the numbers of every film. First, the factors
/// along x and y that convert its force on the journal to the force on the housing, 0 for the ground. Then, for finite
/// length: L/D; 1/c; 1/(c^2 FILM_FOLD); 2/pi, negative if journal and housing turn clockwise (then P, the angle and I
/// have the opposite sign); the coefficients of the numerator, and those of the denominator.
enum {
    FILM_REACTION_X = FILM_NUMBERS,
    FILM_REACTION_Y,
    FILM_LENGTH,
    FILM_OVER_CLEARANCE,
    FILM_OVER_FOLD,
    FILM_TURNS,
    FILM_COEFFICIENT,
    FILM_ALL_NUMBERS = FILM_COEFFICIENT + FILM_COEFFICIENTS + FILM_DENOMINATOR
};

/// The law of an element with these numbers.
enum { FILM_OF_FINITE_LENGTH = 1 };

/// film_finite_type: the variant of film.c for films that its own kernel does not cover. film_coefficients: writes the
/// coefficients for a ratio L/D.
extern const element_type film_finite_type;
void film_coefficients(double length, double *number);
static inline void film_drag(const element *own, const drag_view *in, double torque[2]) {
    drag_of_film(own, in, own->number[FILM_CLEARANCE] * in->length, torque);
}

/// Source of coefficients: those of the lanes, `stride` apart; or one set `all` if all lanes have the same, which is
/// faster.
typedef struct film_series {
    const vec *lanes;
    size_t stride;
    const double *all;
} film_series;

VECTOR_INLINE vec film_coefficient(const film_series *of, size_t n) {
    return of->all ? v_set(of->all[n]) : of->lanes[n * of->stride];
}

/// Rows of powers of b, one for each power m of p; the length of row m; and the index of its first coefficient.
enum { FILM_ROWS = FILM_IN_P + 1 };
#define FILM_POWERS(m) (FILM_IN_B * (FILM_IN_P - (m)) / FILM_IN_P + 1)

VECTOR_INLINE size_t film_row(int m) {
    size_t first = 0;
    VECTOR_WHOLE for (int i = 0; i < FILM_ROWS; i++) if (i % 2 < m % 2 || (i % 2 == m % 2 && i < m)) first +=
        FILM_POWERS(i);
    return first;
}

/// R and I, and their derivatives by p and b if requested.
typedef struct film_ratio {
    vec real, imaginary, real_p, imaginary_p, real_b, imaginary_b;
} film_ratio;

/// Returns the polynomial in u of every other row from `first` on. *slope becomes its derivative, unless `slope` is
/// NULL.
VECTOR_INLINE vec film_sum(const vec row[FILM_ROWS], int first, vec u, vec *slope) {
    vec s = v_set(0.0), by_u = s;
    VECTOR_WHOLE for (int m = FILM_ROWS - 1; m >= 0; m--) {
        if (m % 2 != first) continue;
        by_u = v_fma(by_u, u, s);
        s = v_fma(s, u, row[m]);
    }
    if (slope) *slope = by_u;
    return s;
}

/// Computes R and I. Evaluates all rows side by side, so that no multiply-add waits for the previous one.
VECTOR_INLINE film_ratio film_ratio_at(const film_series *of, vec p, vec b, bool slopes) {
    vec row[FILM_ROWS], by_b[FILM_ROWS];
    VECTOR_WHOLE for (int m = 0; m < FILM_ROWS; m++) row[m] = by_b[m] = v_set(0.0);
    // Use Horner's scheme in b for all rows and their derivatives.
    VECTOR_WHOLE for (int j = FILM_IN_B; j >= 0; j--) {
        VECTOR_WHOLE for (int m = 0; m < FILM_ROWS; m++) {
            if (j >= FILM_POWERS(m)) continue;
            const vec c = film_coefficient(of, film_row(m) + (size_t)j);
            if (slopes) by_b[m] = v_fma(by_b[m], b, row[m]);
            row[m] = j == FILM_POWERS(m) - 1 ? c : v_fma(row[m], b, c);
        }
    }
    // Even rows give R, odd rows I; both are divided by the denominator.
    const vec u = v_mul(p, p), d_p = film_coefficient(of, FILM_COEFFICIENTS),
              d_b = film_coefficient(of, FILM_COEFFICIENTS + 1);
    const vec over = v_div(v_set(1.0), v_fma(d_p, u, v_fma(v_mul(d_b, b), b, v_set(1.0))));
    film_ratio r;
    r.real_p = r.imaginary_p = r.real_b = r.imaginary_b = v_set(0.0);
    vec by_u, odd_u;
    const vec odd = v_mul(over, film_sum(row, 1, u, slopes ? &odd_u : NULL));
    r.real = v_mul(over, film_sum(row, 0, u, slopes ? &by_u : NULL));
    r.imaginary = v_mul(p, odd);
    if (!slopes) return r;
    // Compute the derivatives of the quotients by p and b.
    const vec twice_p = v_add(p, p), under_p = v_mul(v_mul(d_p, twice_p), over),
              under_b = v_mul(v_mul(d_b, v_add(b, b)), over);
    const vec even_b = v_mul(over, film_sum(by_b, 0, u, NULL)), odd_b = v_mul(over, film_sum(by_b, 1, u, NULL));
    r.real_p = v_fnma(r.real, under_p, v_mul(twice_p, v_mul(over, by_u)));
    r.imaginary_p = v_fnma(r.imaginary, under_p, v_fma(v_mul(twice_p, p), v_mul(over, odd_u), odd));
    r.real_b = v_fnma(r.real, under_b, even_b);
    r.imaginary_b = v_fnma(r.imaginary, under_b, v_mul(p, odd_b));
    return r;
}

/// p, b before it is limited, g and its derivative by q, and 1/C.
typedef struct film_direction {
    vec p, b, g, g_q, over_C;
} film_direction;

VECTOR_INLINE film_direction film_direction_of(const film_state *f, size_t stride, const vec *number) {
    const vec CC = v_fma(f->A, f->A, v_fma(f->B, f->B, v_set(0x1p-600))), over_C = v_div(v_set(1.0), v_sqrt(CC));
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
