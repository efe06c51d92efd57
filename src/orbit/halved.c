#include "halved.h"

#include <math.h>
#include <stdlib.h>

#include "bracket.h"

/// By how much an orbit is elsewhere after half its time, in the direction in which another one is [dimension].
static double apart(const whirl_orbit *orbit, const whirl_orbit *other) {
    const size_t n = orbit->dimension, later = orbit->segment_count / 2 * n;
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        sum += (orbit->nodes[later + i] - orbit->nodes[i]) * (other->nodes[later + i] - other->nodes[i]);
    return sum;
}

bool halved_between(const waypoint *from, const waypoint *to) {
    const whirl_orbit *a = from->orbit, *b = to->orbit;
    if (a->revolutions == 0 || a->revolutions % 2 != 0) return false;
    return apart(a, b) < -0.9 * sqrt(apart(a, a) * apart(b, b));
}

/// A point near the end: by how much its orbit is elsewhere after half the time, over what it was at the first one, and
/// the parameter there.
typedef struct look {
    double apart, value;
} look;

/// The parameter at the end: it is even in how far orbits are apart, for those on the other side are the same ones.
static double value_at_end(const look *nearest, const look *other) {
    const double a = nearest->apart * nearest->apart, b = other->apart * other->apart;
    return a < 0.5 * b ? (nearest->value * b - other->value * a) / (b - a) : nearest->value;
}

static look look_at(const follower *f, const waypoint *from, const waypoint *p) {
    return (look){apart(p->orbit, from->orbit) / apart(from->orbit, from->orbit), follower_value(f, p->u)};
}

static void note(look looks[2], look one) {
    const int place = fabs(one.apart) < fabs(looks[0].apart) ? 0 : 1;
    if (place == 1 && fabs(one.apart) >= fabs(looks[1].apart)) return;
    if (place == 0) looks[1] = looks[0];
    looks[place] = one;
}

/// Closes in on the end from both sides; there the equations are singular, so that it is not met itself. p is the
/// nearest point that was found, with an orbit, and looks the two nearest.
static whirl_status close_in(follower *f, const waypoint *from, const waypoint *to, waypoint *p, look looks[2]) {
    enum { MOST_LOOKS = 24 };
    // The error of the parameter is of fourth order in this.
    const double near = 1e-4;
    const size_t all = f->curve.count + 1;
    waypoint trial;
    double *work = malloc(2 * all * sizeof *work);
    whirl_status status = work ? waypoint_new(f, &trial) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch");
    if (!work || status.code != WHIRL_OK) {
        free(work);
        return status;
    }
    bracket r = bracket_between(0.0, 1.0, follower_length(f, from, to, work), look_at(f, from, to).apart);
    for (int k = 0; k < MOST_LOOKS && fabs(looks[0].apart) > near; k++) {
        const double at = bracket_next(&r);
        follower_predict(f, from, to, from, at, work);
        status = follower_find(f, work, follower_across(f, from, to, from, work + all), from->tangent, &trial);
        if (status.code != WHIRL_OK || !trial.orbit) break;
        const look one = look_at(f, from, &trial);
        bracket_tell(&r, at, one.apart);
        if (fabs(one.apart) < fabs(looks[0].apart)) {
            const waypoint kept = *p;
            *p = trial;
            trial = kept;
        }
        note(looks, one);
    }
    waypoint_free(&trial);
    free(work);
    return status;
}

whirl_status halved_add(follower *f, const waypoint *from, const waypoint *to) {
    waypoint p;
    look looks[2] = {look_at(f, from, from), {INFINITY, NAN}};
    whirl_status status = waypoint_new(f, &p);
    note(looks, look_at(f, from, to));
    if (status.code == WHIRL_OK) status = close_in(f, from, to, &p, looks);
    if (status.code == WHIRL_OK && p.orbit) {
        whirl_branch_point point = {
            .value = value_at_end(&looks[0], &looks[1]), .second = NAN, .criticality = NAN, .orbit = p.orbit};
        p.orbit = NULL;
        status = branch_add(f->branch, f->options, &point);
        if (status.code != WHIRL_OK) whirl_orbit_free(point.orbit);
    }
    waypoint_free(&p);
    return status;
}
