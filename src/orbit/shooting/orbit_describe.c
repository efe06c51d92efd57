// Describes an orbit that was found.
#include "orbit_describe.h"
#include "shooting.h"
#include "touch.h"
#include "whirl/engine/orbit.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/// Returns the size in bytes of an orbit with its arrays, which follow it in one block.
static size_t describe_size_of(const whirl_orbit *orbit) {
    return sizeof *orbit + orbit->multiplier_count * sizeof *orbit->multipliers +
           orbit->touch_count * sizeof *orbit->touches + (orbit->segment_count + 2) * orbit->dimension * sizeof(double);
}

static void place_arrays(whirl_orbit *orbit) {
    orbit->multipliers = (whirl_multiplier *)(orbit + 1);
    orbit->touches = (whirl_touch *)(orbit->multipliers + orbit->multiplier_count);
    orbit->nodes = (double *)(orbit->touches + orbit->touch_count);
    orbit->low = orbit->nodes + orbit->segment_count * orbit->dimension;
    orbit->high = orbit->low + orbit->dimension;
}

whirl_orbit *whirl_orbit_new(const whirl_orbit *like) {
    whirl_orbit *orbit = calloc(1, describe_size_of(like));
    if (!orbit) return NULL;
    *orbit = (whirl_orbit){.dimension = like->dimension,
                           .revolutions = like->revolutions,
                           .period = like->period,
                           .segment_count = like->segment_count,
                           .multiplier_count = like->multiplier_count,
                           .touch_count = like->touch_count};
    place_arrays(orbit);
    return orbit;
}

whirl_orbit *whirl_orbit_copy(const whirl_orbit *orbit) {
    whirl_orbit *copy = malloc(describe_size_of(orbit));
    if (!copy) return NULL;
    memcpy(copy, orbit, describe_size_of(orbit));
    place_arrays(copy);
    return copy;
}

void whirl_orbit_free(whirl_orbit *orbit) {
    free(orbit);
}

size_t orbit_own_multiplier(const whirl_orbit *orbit) {
    size_t own = SIZE_MAX;
    double nearest = INFINITY;
    const bool has_one = orbit->revolutions == 0 && orbit->period > 0.0;
    for (size_t i = 0; has_one && i < orbit->multiplier_count; i++) {
        const double away = hypot(orbit->multipliers[i].real - 1.0, orbit->multipliers[i].imaginary);
        if (away < nearest) {
            nearest = away;
            own = i;
        }
    }
    return own;
}

double whirl_orbit_largest(const whirl_orbit *orbit) {
    const size_t own = orbit_own_multiplier(orbit);
    double largest = -INFINITY;
    for (size_t i = 0; i < orbit->multiplier_count; i++) {
        const whirl_multiplier *m = &orbit->multipliers[i];
        if (i != own) largest = fmax(largest, orbit->period > 0.0 ? hypot(m->real, m->imaginary) : m->real);
    }
    return largest;
}

/// Counts multipliers outside the unit circle, or eigenvalues with positive real part.
static size_t count_unstable(const whirl_orbit *orbit) {
    const double slight = 1e-9;
    const size_t own = orbit_own_multiplier(orbit);
    size_t count = 0;
    for (size_t i = 0; i < orbit->multiplier_count; i++) {
        const double real = orbit->multipliers[i].real, size = hypot(real, orbit->multipliers[i].imaginary);
        count += i != own && (orbit->period > 0.0 ? size > 1.0 + slight : real > slight * size);
    }
    return count;
}

static int by_real_part(const void *a, const void *b) {
    const whirl_multiplier *p = a, *q = b;
    if (p->real != q->real) return p->real > q->real ? -1 : 1;
    return p->imaginary > q->imaginary ? -1 : p->imaginary < q->imaginary;
}

whirl_status orbit_describe(shooting *s, const double *nodes, double period, double residual, whirl_orbit **out) {
    const whirl_orbit like = {.dimension = s->dimension,
                              .revolutions = s->revolutions,
                              .period = period,
                              .segment_count = s->count,
                              .multiplier_count = s->kept_count,
                              .touch_count = whirl_touch_count(s->system)};
    // Copy the orbit.
    whirl_orbit *orbit = whirl_orbit_new(&like);
    if (!orbit) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit of %zu segments", s->count);
    orbit->residual = residual;
    orbit->volume = s->volume;
    memcpy(orbit->nodes, nodes, s->count * s->dimension * sizeof *orbit->nodes);
    // Find multipliers and contacts.
    whirl_status status = whirl_ok();
    if (!whirl_product_eigenvalues(s->kept_count, s->count, s->matrices, orbit->multipliers))
        status =
            whirl_fail(WHIRL_BAD_INPUT, "the multipliers of an orbit were not found: its derivative is not finite");
    if (shooting_rests(s)) qsort(orbit->multipliers, s->kept_count, sizeof *orbit->multipliers, by_real_part);
    if (status.code == WHIRL_OK) status = touch_find(s, orbit);
    orbit->unstable = count_unstable(orbit);
    if (status.code == WHIRL_OK)
        *out = orbit;
    else
        whirl_orbit_free(orbit);
    return status;
}
