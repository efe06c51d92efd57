// Matching of modes between two neighbouring machines (points of a sweep).
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "whirl/engine/linear.h"

/// Returns the modal assurance criterion |a* b|^2 / (|a|^2 |b|^2): 1 for equal shapes, 0 for orthogonal ones.
static double likeness(const double *a, const double *b, size_t dimension) {
    double real = 0.0, imaginary = 0.0, of_a = 0.0, of_b = 0.0;
    for (size_t i = 0; i < 2 * dimension; i += 2) {
        real += a[i] * b[i] + a[i + 1] * b[i + 1];
        imaginary += a[i] * b[i + 1] - a[i + 1] * b[i];
        of_a += a[i] * a[i] + a[i + 1] * a[i + 1];
        of_b += b[i] * b[i] + b[i + 1] * b[i + 1];
    }
    const double both = of_a * of_b;
    return both > 0.0 ? (real * real + imaginary * imaginary) / both : 0.0;
}

/// Returns the distance of two modes in eigenvalue and shape; 0 for equal modes.
static double distance(const whirl_modes *from, size_t i, const whirl_modes *to, size_t k, double scale) {
    const whirl_mode *a = &from->modes[i], *b = &to->modes[k];
    const double sizes = scale * hypot(a->real, a->imaginary) + hypot(b->real, b->imaginary);
    const double apart = hypot(scale * a->real - b->real, scale * a->imaginary - b->imaginary);
    const double unlike =
        1.0 - likeness(from->vectors + 2 * i * from->dimension, to->vectors + 2 * k * to->dimension, from->dimension);
    return unlike + 4.0 * apart / (sizes > 0.0 ? sizes : 1.0) + 0.1 * fabs(a->direction - b->direction);
}

/// Pairs modes: of the modes without a partner, the closest pair first. apart [from->count][to->count] is overwritten.
static void pair_off(const whirl_modes *from, const whirl_modes *to, double *apart, size_t *partner, double *unlike) {
    for (size_t pairs = 0; pairs < from->count && pairs < to->count; pairs++) {
        size_t best = 0;
        for (size_t at = 1; at < from->count * to->count; at++)
            if (apart[at] < apart[best]) best = at;
        const size_t i = best / to->count, k = best % to->count;
        partner[i] = k;
        if (unlike) unlike[i] = apart[best];
        for (size_t other = 0; other < to->count; other++) apart[i * to->count + other] = (double)INFINITY;
        for (size_t other = 0; other < from->count; other++) apart[other * to->count + k] = (double)INFINITY;
    }
}

whirl_status whirl_modes_match(const whirl_modes *from, const whirl_modes *to, double scale, size_t *partner,
                               double *unlike) {
    double *apart = malloc((from->count * to->count + 1) * sizeof *apart);
    if (!apart) return whirl_fail(WHIRL_NO_MEMORY, "no memory to compare %zu modes", from->count);
    for (size_t i = 0; i < from->count; i++) {
        partner[i] = SIZE_MAX;
        if (unlike) unlike[i] = (double)INFINITY;
        for (size_t k = 0; k < to->count; k++) apart[i * to->count + k] = distance(from, i, to, k, scale);
    }
    pair_off(from, to, apart, partner, unlike);
    free(apart);
    return whirl_ok();
}
