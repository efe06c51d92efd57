// Unbalances by rule. They are placed at the antinodes of a mode, and are proportional to the static loads of the
// nearest bearings.
#include <math.h>

#include "whirl/engine/linear.h"

static const double least = 0.1;

/// A mode shape along the shaft that moves most. Its displacements have signs: they are taken along the phase of the
/// largest displacement.
typedef struct profile {
    const whirl_system *system;
    const whirl_station_statics *statics;
    const double *shape;
    size_t shaft;
    double largest, direction[2]; ///< the largest displacement, and its phase
} profile;

static double size_of(const profile *p, size_t probe) {
    const double *at = p->shape + 2 * p->system->probes[probe].x;
    return hypot(at[0], at[1]);
}

static double displacement(const profile *p, size_t probe) {
    const double *at = p->shape + 2 * p->system->probes[probe].x;
    return at[0] * p->direction[0] + at[1] * p->direction[1];
}

static bool is_along(const profile *p, size_t probe) {
    return p->system->probes[probe].shaft == p->shaft;
}

static void find_shaft(profile *p) {
    for (size_t i = 0; i < p->system->probe_count; i++) {
        if (p->system->probes[i].shaft == 0 || !(size_of(p, i) > p->largest)) continue;
        const double *at = p->shape + 2 * p->system->probes[i].x;
        p->largest = size_of(p, i);
        p->shaft = p->system->probes[i].shaft;
        for (size_t c = 0; c < 2; c++) p->direction[c] = at[c] / p->largest;
    }
}

/// Returns the nearest bearing at a position or on one side of it (-1, 1), or the probe count if there is none.
static size_t bearing_next_to(const profile *p, double place, int side) {
    size_t found = p->system->probe_count;
    for (size_t i = 0; i < p->system->probe_count; i++) {
        const double away = side * (p->system->probes[i].position - place);
        if (!is_along(p, i) || isnan(p->statics[i].carried) || away < 0.0) continue;
        if (found == p->system->probe_count || away < side * (p->system->probes[found].position - place)) found = i;
    }
    return found;
}

/// Returns true if the shape has one sign between two positions.
static bool keeps_sign(const profile *p, double from, double to) {
    int sign = 0;
    for (size_t i = 0; i < p->system->probe_count; i++) {
        const double place = p->system->probes[i].position, own = displacement(p, i);
        if (!is_along(p, i) || place < from || place > to || fabs(own) < least * p->largest) continue;
        if (sign != 0 && (own > 0.0) != (sign > 0)) return false;
        sign = own > 0.0 ? 1 : -1;
    }
    return true;
}

/// Returns the mass, kg, to which the unbalance at a station is proportional.
static double weight_at(const profile *p, size_t probe) {
    const size_t none = p->system->probe_count;
    const double place = p->system->probes[probe].position;
    const size_t left = bearing_next_to(p, place, -1), right = bearing_next_to(p, place, 1);
    if (left == none && right == none) return 0.0;
    if (left == none) return p->statics[right].mass[0];
    if (right == none) return p->statics[left].mass[1];
    const double ends[] = {p->system->probes[left].position, p->system->probes[right].position};
    const double loads[] = {p->statics[left].carried, p->statics[right].carried};
    if (left != right && keeps_sign(p, ends[0], ends[1])) return fabs(loads[0]) + fabs(loads[1]);
    return fabs(loads[ends[1] - place < place - ends[0]]);
}

/// Returns how much an unbalance by rule at a station excites the mode.
static double excitation(const profile *p, size_t probe) {
    return weight_at(p, probe) * fabs(displacement(p, probe));
}

/// Returns true if no other station in the same stretch of one sign excites the mode more.
static bool is_antinode(const profile *p, size_t probe) {
    const double place = p->system->probes[probe].position, own = displacement(p, probe);
    const double most = excitation(p, probe);
    for (size_t i = 0; i < p->system->probe_count; i++) {
        const double other = p->system->probes[i].position;
        if (i == probe || !is_along(p, i) || (displacement(p, i) > 0.0) != (own > 0.0)) continue;
        if (!keeps_sign(p, fmin(place, other), fmax(place, other))) continue;
        const double other_one = excitation(p, i);
        if (other_one > most || (other_one == most && i < probe)) return false;
    }
    return most > 0.0 && fabs(own) >= least * p->largest;
}

size_t whirl_antinodes(const whirl_system *system, const double *shape, const whirl_station_statics *statics,
                       double factor, whirl_placed *out) {
    profile p = {.system = system, .statics = statics, .shape = shape};
    size_t count = 0;
    find_shaft(&p);
    for (size_t i = 0; i < system->probe_count && p.shaft > 0; i++) {
        if (!is_along(&p, i) || !is_antinode(&p, i)) continue;
        out[count++] = (whirl_placed){.station = i,
                                      .moment = factor * weight_at(&p, i),
                                      .angle = displacement(&p, i) > 0.0 ? 0.0 : 3.14159265358979323846};
    }
    return count;
}
