// Films of finite length, and short films in a housing that moves: the variant to which film.c changes films that its
// own fast kernel does not cover.
#include "film_flow.h"
#include "film_ratio.h"
#include "film_tangent.h"
#include "registry.h"

#include <stdio.h>

VECTOR_INLINE vec apart(const element *own, const vec *row, size_t stride, size_t i) {
    const vec here = row[own->port[i] * stride];
    return own->port[2 + i] == NO_COORDINATE ? here : v_sub(here, row[own->port[2 + i] * stride]);
}

static inline void begin(const element *own, const block *b, size_t k, film_work *work, size_t at) {
    const size_t stride = b->stride;
    const vec *number = numbers_of(b, own) + k, two = number[FILM_TWICE * stride];
    const vec x = apart(own, b->q + k, stride, 0), y = apart(own, b->q + k, stride, 1);
    film_place(work, at, number[FILM_CLEARANCE_SQUARE * stride], x, y, v_fnma(two, apart(own, b->v + k, stride, 1), x),
               v_fma(two, apart(own, b->v + k, stride, 0), y));
}

/// Adds a force as acceleration of the journal, and its reaction on the housing, to the rows `a` of vectors.
VECTOR_INLINE void push(const element *own, size_t stride, const vec *number, const vec *force, vec *a) {
    for (size_t i = 0; i < 2; i++) {
        const size_t here = own->port[i], there = own->port[2 + i];
        a[here * stride] = v_add(a[here * stride], force[i]);
        if (there != NO_COORDINATE)
            a[there * stride] = v_fnma(number[(FILM_REACTION_X + i) * stride], force[i], a[there * stride]);
    }
}

/// Returns the film's contribution to the divergence.
static vec trace_of(const element *own, const block *b, const vec *number, const tangent_block *tangent) {
    const vec *const rows[2] = {tangent->x, tangent->y};
    vec trace = v_set(0.0);
    for (size_t port = 0; port < 4; port++)
        for (size_t by = 0; by < 4; by++) {
            if (own->port[port] == NO_COORDINATE || own->port[by] == NO_COORDINATE) continue;
            const vec derivative = rows[port % 2][2 + by % 2];
            const vec scaled =
                port < 2 ? derivative : v_mul(number[(FILM_REACTION_X + port % 2) * b->stride], derivative);
            const vec part = of_trace(b, own->port[port], own->port[by], scaled);
            trace = port / 2 == by / 2 ? v_add(trace, part) : v_sub(trace, part);
        }
    return trace;
}

/// Applies the derivatives of the force to perturbations.
static void push_tangent(const element *own, const block *b, size_t k, const vec *number,
                         const tangent_block *tangent) {
    for (size_t n = 1; n <= b->perturbations; n++) {
        const vec *q = b->q + n * b->next + k, *v = b->v + n * b->next_v + k;
        vec force[2] = {v_set(0.0), v_set(0.0)};
        for (size_t i = 0; i < 4; i++) {
            const vec along = apart(own, i < 2 ? q : v, b->stride, i % 2);
            force[0] = v_fma(tangent->x[i], along, force[0]);
            force[1] = v_fma(tangent->y[i], along, force[1]);
        }
        push(own, b->stride, number, force, b->a + n * b->next_v + k);
    }
    if (b->divergence) b->divergence[k] = v_add(b->divergence[k], trace_of(own, b, number, tangent));
}

/// Computes the derivatives of R + i I by x, y, x' and y', in the form of film_tangent.h.
static void ratio_tangent(const film_state *f, const film_direction *d, const film_ratio *r, size_t stride,
                          const vec *number, vec real[4], vec imaginary[4]) {
    const vec zero = v_set(0.0), over_root = film_over_root(f), over_q = v_mul(over_root, over_root);
    const vec P = v_mul(f->P, over_q), U = v_fma(f->x, f->A, v_mul(f->y, f->B));
    const vec by_p = v_mul(d->over_C, number[FILM_OVER_CLEARANCE * stride]);
    const vec by_b = v_mul(number[FILM_TURNS * stride], f->W_by_D), steep = v_mul(v_set(-2.0), d->g_q);
    // Compute the derivatives of U/C and of the angle by x, y and the direction of (A, B); and the derivative of q.
    const vec p[3] = {v_mul(by_p, f->A), v_mul(by_p, f->B), v_sub(zero, v_mul(by_p, f->P))};
    const vec b[3] = {v_mul(by_b, v_fma(P, f->x, f->B)), v_mul(by_b, v_fms(P, f->y, f->A)), v_mul(by_b, U)};
    const vec g[3] = {v_mul(steep, f->x), v_mul(steep, f->y), zero};
    const vec slopes[2][2] = {{r->real_p, r->real_b}, {r->imaginary_p, r->imaginary_b}};
    const vec two = number[FILM_TWICE * stride], cosine = v_mul(f->A, d->over_C), sine = v_mul(f->B, d->over_C);
    vec *const rows[2] = {real, imaginary};
    for (int part = 0; part < 2; part++) {
        vec by[3];
        for (int i = 0; i < 3; i++) {
            const vec p_i = v_fma(d->g, p[i], v_mul(d->p, g[i])), b_i = v_fma(d->g, b[i], v_mul(d->b, g[i]));
            by[i] = v_fma(slopes[part][0], p_i, v_mul(slopes[part][1], b_i));
        }
        const vec around = v_mul(by[2], d->over_C), by_A = v_sub(zero, v_mul(sine, around));
        const vec by_B = v_mul(cosine, around);
        rows[part][0] = v_add(by[0], by_A);
        rows[part][1] = v_add(by[1], by_B);
        rows[part][2] = v_mul(two, by_B);
        rows[part][3] = v_sub(zero, v_mul(two, by_A));
    }
}

/// Returns true if all lanes have the length, and so the coefficients, of the machine that defines the structure.
VECTOR_INLINE bool all_alike(const element *own, vec length) {
    return !v_any(v_less(v_set(0.0), v_abs(v_sub(length, v_set(own->number[FILM_LENGTH])))));
}

/// Converts the force of the short film, and its derivatives unless `tangent` is NULL, to those of a film of finite
/// length.
static void lengthen(const element *own, size_t stride, const vec *number, const film_state *f, vec force[2],
                     tangent_block *tangent) {
    // Choose the faster of two ways to the same numbers: one series for all lanes if they are alike.
    const film_series lanes = {number + FILM_COEFFICIENT * stride, stride, NULL};
    const film_series all = {NULL, 0, own->number + FILM_COEFFICIENT};
    const film_direction d = film_direction_of(f, stride, number);
    const vec p = v_mul(d.g, d.p), b = v_mul(d.g, d.b), turns = number[FILM_TURNS * stride];
    film_ratio r;
    if (tangent)
        r = film_ratio_at(&lanes, p, b, true);
    else if (all_alike(own, number[FILM_LENGTH * stride]))
        r = film_ratio_at(&all, p, b, false);
    else
        r = film_ratio_at(&lanes, p, b, false);
    // Multiply the force by the complex ratio.
    const vec R = r.real, I = v_flip(r.imaginary, turns), fx = force[0], fy = force[1];
    force[0] = v_fms(R, fx, v_mul(I, fy));
    force[1] = v_fma(R, fy, v_mul(I, fx));
    if (!tangent) return;
    // Compute the derivatives by the product rule.
    vec real[4], imaginary[4];
    ratio_tangent(f, &d, &r, stride, number, real, imaginary);
    for (int i = 0; i < 4; i++) {
        const vec x = tangent->x[i], y = tangent->y[i], turned = v_flip(imaginary[i], turns);
        tangent->x[i] = v_add(v_fms(R, x, v_mul(I, y)), v_fms(real[i], fx, v_mul(turned, fy)));
        tangent->y[i] = v_add(v_fma(R, y, v_mul(I, x)), v_fma(real[i], fy, v_mul(turned, fx)));
    }
}

static inline void film_finite_finish(const element *own, const block *b, size_t k, const film_state *film) {
    const vec *number = numbers_of(b, own) + k, strength = number[FILM_STRENGTH * b->stride];
    vec force[2] = {v_set(0.0), v_set(0.0)};
    tangent_block tangent;
    const bool wanted = wants_tangent(b);
    film_add(film, strength, &force[0], &force[1]);
    if (wanted) film_tangent(film, strength, number[FILM_TWICE * b->stride], &tangent);
    if (own->law == FILM_OF_FINITE_LENGTH) lengthen(own, b->stride, number, film, force, wanted ? &tangent : NULL);
    push(own, b->stride, number, force, b->a + k);
    if (wanted) push_tangent(own, b, k, number, &tangent);
}

static void film_finite_flow(const element *first, size_t count, const block *b) {
    film_flow(first, count, b, begin, film_finite_finish);
}

const element_kernels ISA(film_finite_kernels) = {.flow = film_finite_flow};

#if VECTOR_ISA == VECTOR_SCALAR
/// Returns the Chebyshev series of n terms at x, by Clenshaw's recurrence.
static double series(const double *terms, size_t n, double x) {
    double b1 = 0.0, b2 = 0.0;
    for (size_t k = n; k-- > 1;) {
        const double b = 2.0 * x * b1 - b2 + terms[k];
        b2 = b1;
        b1 = b;
    }
    return x * b1 - b2 + terms[0];
}

/// Sums up the series. Beyond the lengths of the table they are extended: for shorter films 1 - R is proportional to
/// (L/D)^2, for longer ones R to its inverse.
void film_coefficients(double length, double *number) {
    const double r = length < FILM_SHORTEST ? FILM_SHORTEST : length > FILM_LONGEST ? FILM_LONGEST : length;
    const double s = r / (FILM_SHIFT + r), first = FILM_SHORTEST / (FILM_SHIFT + FILM_SHORTEST);
    const double last = FILM_LONGEST / (FILM_SHIFT + FILM_LONGEST), x = (2.0 * s - first - last) / (last - first);
    const double share = length / r, factor = (length < r ? share * share : 1.0 / (share * share)) / (1.0 + r * r);
    double *const under = number + FILM_COEFFICIENTS;
    for (size_t n = 0; n < FILM_COEFFICIENTS; n++) number[n] = factor * series(film_table[n], FILM_TERMS, x);
    for (size_t n = 0; n < FILM_DENOMINATOR; n++) under[n] = series(film_denominator[n], FILM_DENOMINATOR_TERMS, x);
    if (length >= r) return;
    // Add the terms 1, p^2 and b^2.
    const double rest = 1.0 - share * share;
    number[0] += rest;
    number[film_row(2)] += rest * under[0];
    number[2] += rest * under[1];
}

static double film_finite_clearance(const element *own) {
    return own->number[FILM_CLEARANCE];
}

static void film_finite_note(const element *own, double scale, double clock, char *text, size_t size) {
    (void)scale, (void)clock;
    const double length = own->number[FILM_LENGTH];
    size_t next = 0;
    if (own->law != FILM_OF_FINITE_LENGTH || length < FILM_SHORTEST || length > FILM_LONGEST) return;
    while (next + 1 < FILM_TRIED && film_errors[next][0] < length) next++;
    const double *const more = film_errors[next], *const less = film_errors[next > 0 ? next - 1 : 0];
    snprintf(text, size, "L/D %.3g: the force errs by up to %.1g of itself to an eccentricity ratio of .9, %.1g to .95",
             length, fmax(more[1], less[1]), fmax(more[2], less[2]));
}

static bool film_finite_range(const element *own, size_t index, const element_seen *seen, element_range *out) {
    const char *const limit = "to which its coefficients were found";
    *out = (element_range){"eccentricity ratio", "1", limit, sqrt(1.0 - FILM_FOLD), NAN};
    if (index > 0 || own->law != FILM_OF_FINITE_LENGTH) return false;
    out->reached = seen->radius / own->number[FILM_CLEARANCE];
    return true;
}

KERNELS_OF_EVERY_ISA(film_finite_kernels);

const element_type film_finite_type = {
    .group = {"film", "the oil film of a journal bearing of finite length, or in a housing that moves", "", NULL, 0,
              NULL, NULL},
    .number_count = FILM_ALL_NUMBERS,
    .kernels = kernels,
    .drag = film_drag,
    .bearing_clearance = film_finite_clearance,
    .range = film_finite_range,
    .note = film_finite_note,
};
#endif
