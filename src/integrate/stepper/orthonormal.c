// Gram and Schmidt's orthogonalisation, modified and done twice, so that the result is orthogonal to the last bits
// however close the vectors were (Giraud, Langou, Rozloznik 2005).
#include "orthonormal.h"

#include <float.h>
#include <math.h>
#include <string.h>

static double orthonormal_dot(size_t n, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

/// Subtracts from u its parts along the first `before` vectors. Returns the remaining length.
static double take_off(size_t n, const double *vectors, size_t before, double *u) {
    for (int turn = 0; turn < 2; turn++)
        for (size_t j = 0; j < before; j++) {
            const double *v = vectors + j * n;
            const double along = orthonormal_dot(n, u, v);
            for (size_t i = 0; i < n; i++) u[i] -= along * v[i];
        }
    return sqrt(orthonormal_dot(n, u, u));
}

/// Writes a unit vector orthogonal to the first `before` vectors. Tries the unit vectors along the axes in turn, and
/// takes the first of which enough remains: a squared length of at least half the mean over all axes, which at least
/// one has.
static void replace(size_t n, const double *vectors, size_t before, double *u) {
    for (size_t axis = 0; axis < n; axis++) {
        memset(u, 0, n * sizeof *u);
        u[axis] = 1.0;
        const double length = take_off(n, vectors, before, u);
        if (length * length * (double)n < 0.5 * (double)(n - before)) continue;
        for (size_t i = 0; i < n; i++) u[i] /= length;
        return;
    }
}

void make_orthonormal(size_t dimension, size_t count, double *vectors, double *growth) {
    for (size_t k = 0; k < count; k++) {
        double *u = vectors + k * dimension;
        const double length = take_off(dimension, vectors, k, u);
        growth[k] += log(fmax(length, DBL_MIN));
        if (length >= DBL_MIN)
            for (size_t i = 0; i < dimension; i++) u[i] /= length;
        else
            replace(dimension, vectors, k, u);
    }
}
