// Mass coupling: the mass matrix of coupled coordinates, and its inverse.
#include "coupling.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "matrix.h"

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

/// Fills in the mass matrix M of the coupled coordinates, divided by the roots of their own inertias: symmetric, and 1
/// on the diagonal where nothing couples.
static void add_masses(const coupling *out, const assembly *from, double *m) {
    const size_t n = out->count;
    for (size_t i = 0; i < n; i++) m[i * n + i] = 1.0;
    for (size_t k = 0; k < from->mass_count; k++) {
        const mass_term *term = &from->masses[k];
        const size_t i = out->place[term->row], j = out->place[term->by];
        const double mass = term->mass / sqrt(from->inertia[term->row] * from->inertia[term->by]);
        m[i * n + j] += mass;
        if (i != j) m[j * n + i] += mass;
    }
}

/// Numbers the coordinates so that those which couple with one another, directly or indirectly, are adjacent.
static size_t number_coupled(coupling *out, const assembly *from) {
    size_t *first = out->place, n = 0; // first coordinate with which each couples
    for (size_t d = 0; d < from->degrees; d++) first[d] = d;
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t k = 0; k < from->mass_count; k++) {
            const mass_term *term = &from->masses[k];
            const size_t one = first[term->row], other = first[term->by], lower = one < other ? one : other;
            changed = changed || one != other;
            first[term->row] = first[term->by] = lower;
        }
    }
    for (size_t d = 0; d < from->degrees; d++) {
        const size_t begin = n;
        for (size_t other = d; other < from->degrees && is_coupled(from, d); other++)
            if (first[other] == d) out->row[n++] = other;
        for (size_t i = begin; i < n; i++) out->end[i] = n;
    }
    for (size_t d = 0; d < from->degrees; d++) out->place[d] = NO_COORDINATE;
    for (size_t i = 0; i < n; i++) out->place[out->row[i]] = i;
    return n;
}

whirl_status coupling_fill(coupling *out, const assembly *from) {
    if (from->mass_count == 0) return whirl_ok();
    const size_t n = out->count = number_coupled(out, from);
    if (n == 0) return whirl_ok();
    double *mass = calloc(n * n, sizeof *mass);
    if (!mass) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the masses of %zu coordinates", n);
    add_masses(out, from, mass);
    for (size_t i = 0; i < n * n; i++) out->share[i] = i % (n + 1) == 0 ? 1.0 : 0.0;
    const bool definite = matrix_solve_definite(n, mass, n, out->share);
    free(mass);
    if (!definite)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the rotor's mass matrix is not positive definite, expected masses that are");
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            const double root = sqrt(from->inertia[out->row[j]] / from->inertia[out->row[i]]);
            out->share[i * n + j] *= root * from->unit[out->row[j]] / from->unit[out->row[i]];
            out->columns[j * out->apart + i] = out->share[i * n + j];
        }
    return whirl_ok();
}
