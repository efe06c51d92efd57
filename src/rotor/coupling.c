// Masses that couple coordinates: the mass matrix of those that are coupled, and its inverse.
#include "coupling.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static bool is_coupled(const assembly *from, size_t coordinate) {
    for (size_t i = 0; i < from->mass_count; i++)
        if (from->masses[i].row == coordinate || from->masses[i].by == coordinate) return true;
    return false;
}

size_t coupling_count(const assembly *from) {
    size_t count = 0;
    for (size_t d = 0; d < from->degrees && from->mass_count > 0; d++) count += is_coupled(from, d);
    return count;
}

/// The mass matrix M of the coupled coordinates, over the roots of their own inertias: symmetric, 1 where nothing
/// couples.
static void add_masses(coupling *out, const assembly *from) {
    const size_t n = out->count;
    memset(out->share, 0, n * n * sizeof *out->share);
    for (size_t i = 0; i < n; i++) out->share[i * n + i] = 1.0;
    for (size_t k = 0; k < from->mass_count; k++) {
        const mass_term *term = &from->masses[k];
        const size_t i = out->place[term->row], j = out->place[term->by];
        const double mass = term->mass / sqrt(from->inertia[term->row] * from->inertia[term->by]);
        out->share[i * n + j] += mass;
        if (i != j) out->share[j * n + i] += mass;
    }
}

/// Inverts a symmetric positive definite matrix [n][n] in its place, by its pivots on the diagonal one after the other
/// (Gauss, Jordan). False where one is not positive.
static bool invert(double *m, size_t n) {
    for (size_t k = 0; k < n; k++) {
        const double pivot = m[k * n + k];
        if (!(pivot > 0.0 && isfinite(pivot))) return false;
        m[k * n + k] = 1.0;
        for (size_t j = 0; j < n; j++) m[k * n + j] /= pivot;
        for (size_t i = 0; i < n; i++) {
            const double factor = m[i * n + k];
            if (i == k) continue;
            m[i * n + k] = 0.0;
            for (size_t j = 0; j < n; j++) m[i * n + j] -= factor * m[k * n + j];
        }
    }
    return true;
}

whirl_status coupling_fill(coupling *out, const assembly *from) {
    size_t n = 0;
    if (from->mass_count == 0) return whirl_ok();
    for (size_t d = 0; d < from->degrees; d++) {
        out->place[d] = NO_COORDINATE;
        if (!is_coupled(from, d)) continue;
        out->place[d] = n;
        out->row[n++] = d;
    }
    out->count = n;
    add_masses(out, from);
    if (!invert(out->share, n))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the rotor's mass matrix is not positive definite, expected masses that are");
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            const double root = sqrt(from->inertia[out->row[j]] / from->inertia[out->row[i]]);
            out->share[i * n + j] *= root * from->unit[out->row[j]] / from->unit[out->row[i]];
        }
    return whirl_ok();
}
