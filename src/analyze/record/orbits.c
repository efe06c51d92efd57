#include "orbits.h"

#include <math.h>

#include "orbit_search.h"
#include "record_block.h"
#include "recurrence.h"

/// Additional cost of a revolution for each perturbation, in revolutions.
static const double perturbed = 0.5;

/// Newton steps of a search, and the largest share of a point's revolutions that it may cost.
static const double steps = 3.0, most_share = 0.25;

/// Largest distance from the orbit, divided by motion_size, at which a motion counts as on it.
static const double elsewhere = 1e-4;

/// Largest distance of a neutral multiplier from the unit circle.
static const double neutral = 1e-9;

bool orbits_pay(size_t dimension, const whirl_record_options *options, size_t k, double spent) {
    const double revolutions = (double)options->transient + (double)options->record;
    return (spent + steps * (double)k) * (1.0 + perturbed * (double)dimension) <= most_share * revolutions;
}

size_t orbits_settled_period(const whirl_record *record, const whirl_record_options *options) {
    const section points = record_points(record);
    const recurrence returns =
        recurrence_find(&points, record->record_count, motion_size(record), recurrence_tolerance);
    const size_t k = (size_t)returns.period, repeats = record->turns ? record->repeats : 1;
    const bool settled = returns.distance <= recurrence_tolerance && repeats > 0;
    if (!settled) return 0;
    const size_t whole = (k + repeats - 1) / repeats * repeats;
    return orbits_pay(record->dimension, options, whole, 0.0) ? whole : 0;
}

static whirl_orbit_search orbits_outcome(const whirl_record_orbit *orbit, const orbit_search *s) {
    if (!s->found) return WHIRL_ORBIT_NONE;
    if (orbit->set_at > 0.0) return WHIRL_ORBIT_STABLE;
    if (orbit->distance > elsewhere) return WHIRL_ORBIT_ELSEWHERE;
    return orbit->modulus < 1.0 - neutral ? WHIRL_ORBIT_STABLE : WHIRL_ORBIT_UNSTABLE;
}

void orbits_record(whirl_record *record, const orbit_search *s, double distance) {
    whirl_record_orbit *orbit = &record->orbit;
    orbit->period = (int)s->revolutions;
    orbit->residual = s->residual;
    orbit->volume = s->volume;
    orbit->multiplier_count = s->found ? s->kept : 0;
    orbit->distance = distance / motion_size(record);
    for (size_t i = 0; i < orbit->multiplier_count; i++) {
        orbit->multipliers[2 * i] = s->values[i].real;
        orbit->multipliers[2 * i + 1] = s->values[i].imaginary;
    }
    orbit->modulus = orbit->multiplier_count > 0 ? hypot(s->values[0].real, s->values[0].imaginary) : 0.0;
    orbit->search = orbits_outcome(orbit, s);
}
