#include "section_distance.h"
#include "whirl/engine/orbit.h"

#include <math.h>

#include "turns.h"

double states_distance(const whirl_system *system, const double *a, const double *b) {
    double away = 0.0, size = 0.0;
    for (size_t i = 0; i < system->dimension; i++) {
        if (turns_on(system->turns, i)) continue;
        away = fmax(away, fabs(short_way(system->angles, i, a[i] - b[i])));
        size = fmax(size, fabs(a[i]));
    }
    return size > 0.0 ? away / size : away;
}

size_t orbit_stride(const whirl_orbit *orbit) {
    const size_t sections = orbit->revolutions > 0 ? orbit->revolutions : 1;
    return orbit->segment_count / sections * orbit->dimension;
}

double whirl_orbit_distance(const whirl_system *system, const whirl_orbit *orbit, const double *state) {
    const size_t stride = orbit_stride(orbit);
    double least = INFINITY;
    for (size_t at = 0; at < orbit->segment_count * orbit->dimension; at += stride)
        least = fmin(least, states_distance(system, orbit->nodes + at, state));
    return least;
}
