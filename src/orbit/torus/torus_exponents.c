// Normal exponents of a torus. Multiplies the map's derivative along the curve, section by section of a long walk by
// its rotation; each factor is interpolated between the nodes (Jorba 2001). The curve's direction is removed from every
// factor, and the remaining vectors are orthonormalized. On a smooth torus the logarithms of their lengths are smooth
// functions of the angle: their weighted Birkhoff averages converge faster than any power of the walk's length.
#include "harmonics.h"
#include "torus_describe.h"
#include "torus_equations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "birkhoff_weight.h"

enum { SETTLING = 256, MIN_STEPS = 512, MAX_STEPS = 8192 };

typedef struct walk {
    size_t n, count;       ///< coordinates, nodes
    double angle, at;      ///< rotation of a step; present angle
    double *curve;         ///< [count][n] series of the curve
    double *factor;        ///< [count][n][n] series of the map's derivative
    double *place, *along; ///< [n] present point, and the curve's direction there, of length 1
    double *matrix;        ///< [n][n]
    double *vectors;       ///< [n - 1][n] orthonormal, orthogonal to the curve
    double *turned;        ///< [n]
    double *growth;        ///< [MAX_STEPS][n - 1]
} walk;

static double torus_exponents_dot(size_t n, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

static void take_out(size_t n, const double *direction, double *v) {
    const double part = torus_exponents_dot(n, direction, v);
    for (size_t i = 0; i < n; i++) v[i] -= part * direction[i];
}

static bool look_along(walk *w) {
    harmonics_at(w->count, w->n, w->curve, w->at, w->place, w->along);
    const double length = sqrt(torus_exponents_dot(w->n, w->along, w->along));
    for (size_t i = 0; i < w->n; i++) w->along[i] /= length;
    return isfinite(length) && length > 0.0;
}

/// Makes vector k orthonormal to the vectors before it and to the curve. Returns its former length, 0 if nothing is
/// left.
static double torus_exponents_straighten(walk *w, size_t k) {
    double *v = w->vectors + k * w->n;
    for (int twice = 0; twice < 2; twice++) {
        take_out(w->n, w->along, v);
        for (size_t i = 0; i < k; i++) take_out(w->n, w->vectors + i * w->n, v);
    }
    const double length = sqrt(torus_exponents_dot(w->n, v, v));
    for (size_t i = 0; i < w->n && length > 0.0; i++) v[i] /= length;
    return length;
}

/// Sets the initial vectors: unit vectors without the one nearest to the curve's direction.
static bool torus_exponents_begin(walk *w) {
    size_t nearest = 0;
    if (!look_along(w)) return false;
    for (size_t i = 1; i < w->n; i++)
        if (fabs(w->along[i]) > fabs(w->along[nearest])) nearest = i;
    memset(w->vectors, 0, (w->n - 1) * w->n * sizeof *w->vectors);
    for (size_t k = 0; k + 1 < w->n; k++) {
        w->vectors[k * w->n + k + (k >= nearest)] = 1.0;
        torus_exponents_straighten(w, k);
    }
    return true;
}

/// Moves one section further. growth [n - 1] receives the logarithms of the lengths.
static bool torus_exponents_step(walk *w, double *growth) {
    const size_t n = w->n;
    harmonics_at(w->count, n * n, w->factor, w->at, w->matrix, NULL);
    w->at = remainder(w->at + w->angle, 6.283185307179586476925);
    if (!look_along(w)) return false;
    for (size_t k = 0; k + 1 < n; k++) {
        double *v = w->vectors + k * n;
        for (size_t i = 0; i < n; i++) w->turned[i] = torus_exponents_dot(n, w->matrix + i * n, v);
        memcpy(v, w->turned, n * sizeof *v);
        growth[k] = log(torus_exponents_straighten(w, k));
        if (!isfinite(growth[k])) return false;
    }
    return true;
}

static double torus_exponents_average(const walk *w, size_t which, size_t first, size_t count) {
    double sum = 0.0, weights = 0.0;
    for (size_t m = 0; m < count; m++) {
        const double weight = birkhoff_weight(m, count);
        sum += weight * w->growth[(first + m) * (w->n - 1) + which];
        weights += weight;
    }
    return sum / weights;
}

/// Writes the exponents with their errors. Returns the largest error that the length of the walk causes. Between nodes
/// the factor is wrong by `slight`; the error of an exponent is this divided by its multiplier.
static double write_averages(const walk *w, size_t count, double slight, whirl_torus *torus) {
    const double share = 1.0 / (double)torus->revolutions;
    double largest = 0.0;
    for (size_t k = 0; k < torus->exponent_count; k++) {
        const double early = torus_exponents_average(w, k, 0, count / 2),
                     late = torus_exponents_average(w, k, count / 2, count / 2);
        const double whole = torus_exponents_average(w, k, 0, count), walked = share * fabs(late - early);
        torus->exponents[k] = share * whole;
        torus->exponent_errors[k] = walked + share * slight / exp(whole);
        largest = fmax(largest, walked);
    }
    return largest;
}

/// Returns the size of the last two harmonics of the factor.
static double missing_of(const walk *w) {
    const size_t size = w->n * w->n, last = w->count / 2;
    return harmonics_size(size, w->factor, last) + harmonics_size(size, w->factor, last - 1);
}

static bool torus_exponents_move(walk *w, whirl_torus *torus) {
    size_t count = 0;
    if (!torus_exponents_begin(w)) return false;
    for (size_t m = 0; m < SETTLING; m++)
        if (!torus_exponents_step(w, w->growth)) return false;
    for (size_t most = MIN_STEPS; most <= MAX_STEPS; most *= 2) {
        for (; count < most; count++)
            if (!torus_exponents_step(w, w->growth + count * (w->n - 1))) return false;
        if (write_averages(w, count, missing_of(w), torus) < 1e-9) break;
    }
    return true;
}

/// Marks all exponents as unknown, after a walk that ended early.
static void say_nothing(whirl_torus *torus) {
    for (size_t k = 0; k < torus->exponent_count; k++) torus->exponents[k] = torus->exponent_errors[k] = NAN;
}

bool torus_find_exponents(const torus_equations *e, const double *u, whirl_torus *torus) {
    const size_t n = e->n, size = e->count * n;
    if (torus->exponent_count == 0) return true;
    double *work = calloc(size + size * n + 3 * n + 2 * n * n + (size_t)MAX_STEPS * (n - 1), sizeof *work);
    if (!work) return false;
    walk w = {.n = n, .count = e->count, .angle = u[size], .curve = work, .factor = work + size};
    w.place = w.factor + size * n;
    w.along = w.place + n;
    w.turned = w.along + n;
    w.matrix = w.turned + n;
    w.vectors = w.matrix + n * n;
    w.growth = w.vectors + n * n;
    harmonics_of(e->count, n, u, w.curve);
    harmonics_of(e->count, n * n, e->matrices, w.factor);
    if (!torus_exponents_move(&w, torus)) say_nothing(torus);
    torus->unstable = 0;
    for (size_t k = 0; k < torus->exponent_count; k++)
        torus->unstable += torus->exponents[k] > torus->exponent_errors[k] + 1e-9;
    free(work);
    return true;
}
