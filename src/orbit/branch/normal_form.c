// Cubic coefficients of normal forms, by differences of the map over the orbit, or of the forces of an equilibrium.
//
// B(u, v) and C(u, v, w) are the second and third derivatives of the map F. F is differenced along single directions;
// mixed derivatives follow by polarisation. q and p are the right and left eigenvectors with <q, q> = 1, <p, q> = 1 (p
// conjugated).
#include "normal_form.h"
#include "equations.h"
#include "rest_equations.h"
#include "shooting.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

typedef double complex number;

/// reach: length of the first differences, over the largest coordinate. Their error is of second order and
/// extrapolated. The length is halved until two coefficients agree, since an orbit may be strongly bent, or a contact
/// near.
static const double reach = 0x1p-7, agreement = 0.01, noise = 1e-3;
enum { MAX_HALVINGS = 5 };

typedef struct forms {
    shooting *s;
    const whirl_orbit *orbit;
    size_t n;
    double step;
    double *matrix;         ///< [n][n] derivative of the map
    double *images, *image; ///< [MAX_ABREAST][dimension] workspace; [n]
    double *centre;         ///< [n] the image of the orbit itself
    double *sums[2];        ///< [n] at two lengths of step
    number *q, *p;          ///< [n]
    bool failed;
} forms;

// ---------------------------------------------------------------- the map and its derivatives

/// Start points of motions that run side by side.
typedef struct looks {
    size_t count;
    double h[MAX_ABREAST], weight[MAX_ABREAST];
    size_t sum[MAX_ABREAST]; ///< index of the sum that each one adds to
} looks;

/// Maps start points over the orbit's time, images [count][dimension]: F(x + h u). For an equilibrium, computes its
/// accelerations.
static void normal_form_map(forms *f, const looks *of, const double *u) {
    shooting *s = f->s;
    const size_t d = s->dimension;
    for (size_t k = 0; k < of->count; k++) {
        double *x = f->images + k * d;
        memcpy(x, f->orbit->nodes, d * sizeof *x);
        for (size_t i = 0; i < f->n; i++) x[s->kept[i]] += of->h[k] * u[i];
        if (!shooting_rests(s)) continue;
        f->failed = !rest_slope(s, x, f->image, false) || f->failed;
        for (size_t i = 0; i < f->n; i++) x[s->kept[i]] = f->image[i];
    }
    if (!shooting_rests(s)) f->failed = !shooting_map(s, of->count, f->images, f->orbit->period) || f->failed;
}

static void normal_form_look_at(looks *of, size_t sum, double h, double weight) {
    of->h[of->count] = h;
    of->weight[of->count] = weight;
    of->sum[of->count++] = sum;
}

/// Computes out = B(u, u) or C(u, u, u) from two lengths of step.
static void normal_form_derivative(forms *f, int order, const double *u, double *out) {
    static const double places[4] = {2.0, 1.0, -1.0, -2.0}, weights[4] = {0.5, -1.0, 1.0, -0.5};
    looks of = {.count = 0};
    double size = 0.0;
    for (size_t i = 0; i < f->n; i++) size = fmax(size, fabs(u[i]));
    for (size_t k = 0; k < 2; k++) {
        const double h = ldexp(f->step / (size > 0.0 ? size : 1.0), -(int)k);
        for (size_t i = 0; i < f->n; i++) f->sums[k][i] = order == 2 ? -2.0 / (h * h) * f->centre[i] : 0.0;
        for (int sign = 1; order == 2 && sign >= -1; sign -= 2) normal_form_look_at(&of, k, sign * h, 1.0 / (h * h));
        for (int j = 0; order == 3 && j < 4; j++) normal_form_look_at(&of, k, places[j] * h, weights[j] / (h * h * h));
    }
    normal_form_map(f, &of, u);
    for (size_t k = 0; k < of.count; k++)
        for (size_t i = 0; i < f->n; i++)
            f->sums[of.sum[k]][i] += of.weight[k] * f->images[k * f->s->dimension + f->s->kept[i]];
    for (size_t i = 0; i < f->n; i++) out[i] = (4.0 * f->sums[1][i] - f->sums[0][i]) / 3.0;
}

/// Computes out = B(u, v) = (B(u + v, u + v) - B(u - v, u - v))/4; work [3][n].
static void normal_form_bilinear(forms *f, const double *u, const double *v, double *work, double *out) {
    const size_t n = f->n;
    for (int sign = 1; sign >= -1; sign -= 2) {
        for (size_t i = 0; i < n; i++) work[i] = u[i] + sign * v[i];
        normal_form_derivative(f, 2, work, sign > 0 ? out : work + n);
    }
    for (size_t i = 0; i < n; i++) out[i] = 0.25 * (out[i] - work[n + i]);
}

/// Computes out = B(a, b) of complex vectors; work [9][n].
static void complex_bilinear(forms *f, const number *a, const number *b, double *work, number *out) {
    const size_t n = f->n;
    double *parts = work + 3 * n, *found = work + 7 * n;
    for (size_t i = 0; i < n; i++) {
        parts[i] = creal(a[i]);
        parts[n + i] = cimag(a[i]);
        parts[2 * n + i] = creal(b[i]);
        parts[3 * n + i] = cimag(b[i]);
        out[i] = 0.0;
    }
    for (size_t k = 0; k < 4; k++) {
        normal_form_bilinear(f, parts + k / 2 * n, parts + (2 + k % 2) * n, work, found);
        const number factor = (k / 2 ? I : 1.0) * (k % 2 ? I : 1.0);
        for (size_t i = 0; i < n; i++) out[i] += factor * found[i];
    }
}

/// Computes out = C(q, q, conj q) with q = a + i b: C(a, a, a) + C(a, b, b) + i (C(a, a, b) + C(b, b, b)); work [7][n].
static void normal_form_cubic(forms *f, double *work, number *out) {
    const size_t n = f->n;
    double *a = work, *b = work + n, *along = work + 2 * n, *aaa = work + 3 * n, *bbb = aaa + n, *sum = bbb + n;
    double *difference = sum + n;
    for (size_t i = 0; i < n; i++) {
        a[i] = creal(f->q[i]);
        b[i] = cimag(f->q[i]);
    }
    normal_form_derivative(f, 3, a, aaa);
    normal_form_derivative(f, 3, b, bbb);
    for (size_t i = 0; i < n; i++) along[i] = a[i] + b[i];
    normal_form_derivative(f, 3, along, sum);
    for (size_t i = 0; i < n; i++) along[i] = a[i] - b[i];
    normal_form_derivative(f, 3, along, difference);
    for (size_t i = 0; i < n; i++) {
        const double abb = (sum[i] + difference[i] - 2.0 * aaa[i]) / 6.0;
        const double aab = (sum[i] - difference[i] - 2.0 * bbb[i]) / 6.0;
        out[i] = aaa[i] + abb + I * (aab + bbb[i]);
    }
}

// ---------------------------------------------------------------- linear algebra

/// Multiplies the derivatives of the segments, whose product is that of the map. Near the unit circle the product is
/// exact enough.
static void multiply_out(forms *f, double *spare) {
    const shooting *s = f->s;
    const size_t n = f->n, size = n * n;
    memcpy(f->matrix, s->matrices, size * sizeof *f->matrix);
    for (size_t j = 1; j < s->count; j++) {
        memset(spare, 0, size * sizeof *spare);
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; k < n; k++)
                for (size_t l = 0; l < n; l++)
                    spare[i * n + l] += s->matrices[j * size + i * n + k] * f->matrix[k * n + l];
        memcpy(f->matrix, spare, size * sizeof *spare);
    }
}

/// Computes the eigenvector of the matrix, or of its transpose, with the eigenvalue nearest to `root`. Fails if none is
/// near `root`: where multipliers jump over it, as at a kink, there is no normal form.
static void normal_form_eigenvector(forms *f, bool transposed, number root, double *work, number *out) {
    const size_t n = f->n;
    static const double near = 0.01;
    double *copy = work, *real = copy + n * n, *imaginary = real + n, *vectors = imaginary + n;
    size_t nearest = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) copy[i * n + k] = f->matrix[transposed ? k * n + i : i * n + k];
    f->failed = f->failed || !matrix_eigen(n, copy, real, imaginary, vectors);
    if (f->failed) return;
    for (size_t i = 1; i < n; i++)
        if (cabs(real[i] + I * imaginary[i] - root) < cabs(real[nearest] + I * imaginary[nearest] - root)) nearest = i;
    f->failed = !(cabs(real[nearest] + I * imaginary[nearest] - root) < near * fmax(1.0, cabs(root)));
    for (size_t i = 0; i < n; i++) out[i] = vectors[2 * (nearest * n + i)] + I * vectors[2 * (nearest * n + i) + 1];
}

static number normal_form_product(size_t n, const number *p, const number *v) {
    number sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += conj(p[i]) * v[i];
    return sum;
}

/// Solves (shift - matrix) out = v, and writes out to v; work [n][n][2] and [n][2].
static void normal_form_resolve(forms *f, number shift, double *work, number *v) {
    const size_t n = f->n;
    double *right = work + 2 * n * n;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            const number entry = (i == k ? shift : 0.0) - f->matrix[i * n + k];
            work[2 * (i * n + k)] = creal(entry);
            work[2 * (i * n + k) + 1] = cimag(entry);
        }
    for (size_t i = 0; i < n; i++) {
        right[2 * i] = creal(v[i]);
        right[2 * i + 1] = cimag(v[i]);
    }
    f->failed = f->failed || !matrix_solve_complex(n, work, 1, right);
    for (size_t i = 0; i < n; i++) v[i] = right[2 * i] + I * right[2 * i + 1];
}

// ---------------------------------------------------------------- coefficients

/// Computes <p, C(q, q, conj q)> + 2 <p, B(q, (one - A)^-1 B(q, conj q))> + <p, B(conj q, (two - A)^-1 B(q, q))>.
static number third_order(forms *f, number one, number two, double *work, number *vectors) {
    const size_t n = f->n;
    number *other = vectors, *inner = vectors + n, *outer = vectors + 2 * n;
    for (size_t i = 0; i < n; i++) other[i] = conj(f->q[i]);
    normal_form_cubic(f, work, outer);
    number sum = normal_form_product(n, f->p, outer);
    complex_bilinear(f, f->q, other, work, inner);
    normal_form_resolve(f, one, work, inner);
    complex_bilinear(f, f->q, inner, work, outer);
    sum += 2.0 * normal_form_product(n, f->p, outer);
    complex_bilinear(f, f->q, f->q, work, inner);
    normal_form_resolve(f, two, work, inner);
    complex_bilinear(f, other, inner, work, outer);
    return sum + normal_form_product(n, f->p, outer);
}

/// Computes the coefficient. A doubling has a real q: the three terms become C(q, q, q) and three times B(q, (1 - A)^-1
/// B(q, q)).
static double normal_form_coefficient(forms *f, whirl_special kind, number root, double *work, number *vectors) {
    if (kind == WHIRL_DOUBLING) return -creal(third_order(f, 1.0, 1.0, work, vectors)) / 6.0;
    if (kind == WHIRL_HOPF) return creal(third_order(f, 0.0, 2.0 * root, work, vectors)) / (2.0 * cimag(root));
    return 0.5 * creal(conj(root) * third_order(f, 1.0, root * root, work, vectors));
}

static number root_of(whirl_special kind, double angle) {
    if (kind == WHIRL_DOUBLING) return -1.0;
    return kind == WHIRL_HOPF ? I * angle : cexp(I * angle);
}

static bool normal_form_resonates(double angle) {
    const double turn = 6.283185307179586476925, slight = 1e-3;
    return fabs(angle - turn / 3.0) < slight || fabs(angle - turn / 4.0) < slight;
}

static double normal_form_compute(forms *f, whirl_special kind, number root, double *work, number *vectors) {
    const size_t n = f->n;
    multiply_out(f, work);
    normal_form_eigenvector(f, false, root, work, f->q);
    normal_form_eigenvector(f, true, conj(root), work, f->p);
    const number along = normal_form_product(n, f->p, f->q);
    for (size_t i = 0; i < n; i++) f->p[i] /= conj(along);
    for (size_t i = 0; i < n; i++) work[i] = 0.0;
    normal_form_map(f, &(looks){.count = 1}, work);
    for (size_t i = 0; i < n; i++) f->centre[i] = f->images[f->s->kept[i]];
    const double found = f->failed ? (double)NAN : normal_form_coefficient(f, kind, root, work, vectors);
    return f->failed || !isfinite(found) ? (double)NAN : found;
}

/// Compares the coefficient of the longest differences with that of half the length and, for orbits, of a quarter.
/// Coefficients of smooth maps converge, or differ by noise. At a kink they double with every halving, and there is no
/// coefficient. An equilibrium at zero has no size of its own.
static double normal_form_converge(forms *f, whirl_special kind, number root, double *work, number *vectors) {
    const double own = shooting_size(f->s, f->orbit->nodes), nothing = 1e-12;
    const bool rests = shooting_rests(f->s);
    double first = NAN, second = NAN;
    for (int k = 0; k <= MAX_HALVINGS + !rests; k++) {
        f->step = ldexp(reach, -k) * (own > nothing ? own : 1.0);
        f->failed = false;
        const double third = normal_form_compute(f, kind, root, work, vectors), apart = fabs(second - first);
        if (rests && fabs(third - second) <= agreement * fabs(third)) return second;
        if (!rests && apart <= agreement * fabs(second) && fabs(third - second) <= fmax(apart, noise * fabs(third)))
            return first;
        first = second;
        second = third;
    }
    return NAN;
}

double normal_form(shooting *s, const whirl_orbit *orbit, whirl_special kind, double angle) {
    const size_t n = s->kept_count, all = MAX_ABREAST * s->dimension;
    if (kind != WHIRL_DOUBLING && kind != WHIRL_HOPF && kind != WHIRL_NEIMARK_SACKER) return NAN;
    if (n == 0 || (kind == WHIRL_NEIMARK_SACKER && normal_form_resonates(angle))) return NAN;
    const size_t spare = 9 * n > 4 * n * n + 2 * n ? 9 * n : 4 * n * n + 2 * n;
    double *work = calloc(n * n + all + 4 * n + spare, sizeof *work);
    number *vectors = calloc(5 * n, sizeof *vectors);
    double found = NAN;
    if (work && vectors) {
        forms f = {.s = s, .orbit = orbit, .n = n, .matrix = work, .images = work + n * n};
        f.image = f.images + all;
        f.centre = f.image + n;
        f.sums[0] = f.centre + n;
        f.sums[1] = f.sums[0] + n;
        f.q = vectors;
        f.p = vectors + n;
        found = normal_form_converge(&f, kind, root_of(kind, angle), f.sums[1] + n, vectors + 2 * n);
    }
    free(work);
    free(vectors);
    return found;
}
