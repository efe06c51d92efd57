// Locates the end of a branch whose orbits close there after half their time (halved.h). The equations are singular at
// that end, so its parameter is extrapolated from points on both sides.
#include "halved.h"
#include "branch_points.h"
#include "curve.h"
#include "follower.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

#include <math.h>
#include <stdlib.h>

/// Returns the scalar product of the half-time differences of two orbits. The half-time difference [dimension] is the
/// state half a period after the first node, minus the state at the first node.
static double halved_apart(const whirl_orbit *orbit, const whirl_orbit *other) {
    const size_t n = orbit->dimension, later = orbit->segment_count / 2 * n;
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        sum += (orbit->nodes[later + i] - orbit->nodes[i]) * (other->nodes[later + i] - other->nodes[i]);
    return sum;
}

bool halved_between(const waypoint *from, const waypoint *to) {
    const whirl_orbit *a = from->orbit, *b = to->orbit;
    if (a->revolutions == 0 || a->revolutions % 2 != 0) return false;
    return halved_apart(a, b) < -0.9 * sqrt(halved_apart(a, a) * halved_apart(b, b));
}

/// A point near the end of the branch: its place along the tangent; the half-time difference of its orbit, as a
/// multiple of that of the first point; and its parameter.
typedef struct look {
    double at, apart, value;
} look;

enum { NEAREST = 3 };

/// The points nearest to the end, the nearest first.
typedef struct looks {
    look list[NEAREST];
    int count;
} looks;

static look halved_look_at(const follower *f, const waypoint *from, const waypoint *p, double at) {
    return (look){at, halved_apart(p->orbit, from->orbit) / halved_apart(from->orbit, from->orbit),
                  follower_value(f, p->u)};
}

static void halved_note(looks *to, look one) {
    int place = to->count < NEAREST ? to->count++ : NEAREST;
    for (; place > 0 && fabs(to->list[place - 1].apart) > fabs(one.apart); place--)
        if (place < NEAREST) to->list[place] = to->list[place - 1];
    if (place < NEAREST) to->list[place] = one;
}

/// Extrapolates the parameter to the end. The parameter is an even function of the half-time difference, since the
/// orbits beyond the end are those before it, shifted by half their time. It is extrapolated by a polynomial in the
/// square of the difference (Neville).
static double value_at_end(const looks *l) {
    double value[NEAREST] = {NAN}, square[NEAREST] = {NAN};
    int count = 0;
    for (int i = 0; i < l->count; i++) {
        square[count] = l->list[i].apart * l->list[i].apart;
        value[count] = l->list[i].value;
        // Of two points with nearly equal differences only the nearer one helps: the extrapolation divides by the
        // distance of the squares.
        if (count == 0 || square[count] > 2.0 * square[count - 1]) count++;
    }
    for (int order = 1; order < count; order++)
        for (int i = 0; i + order < count; i++)
            value[i] = (square[i + order] * value[i] - square[i] * value[i + 1]) / (square[i + order] - square[i]);
    return value[0];
}

/// Returns the next place of the search: the zero of the straight line through the nearest points of both sides. After
/// failures the place is between the zero and one of these points, by turns and ever closer to them.
static double next_place(const look sides[2], int missed) {
    const double slope = (sides[1].at - sides[0].at) / (sides[1].apart - sides[0].apart);
    const double zero = sides[0].at - sides[0].apart * slope;
    const double share = missed == 0 ? 0.0 : 1.0 - ldexp(1.0, -(missed + 1) / 2);
    return zero + share * (sides[missed % 2].at - zero);
}

/// Closes in on the end from both sides. The end itself is avoided, since the equations are singular there. *p becomes
/// the nearest point that was found, if any.
static whirl_status halved_close_in(follower *f, const waypoint *from, const waypoint *to, waypoint *p, looks *found) {
    enum { MAX_LOOKS = 16 };
    // The error of the parameter is of the sixth power of `near`. Orbits with differences below `same` belong to the
    // branch with the doubling.
    const double near = 1e-2, same = 1e-6;
    const size_t all = f->curve.count + 1;
    waypoint trial = {.u = NULL};
    double *work = malloc(2 * all * sizeof *work);
    whirl_status status = work ? waypoint_new(f, &trial) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch");
    look sides[2] = {halved_look_at(f, from, from, 0.0), halved_look_at(f, from, to, NAN)};
    if (status.code == WHIRL_OK) {
        sides[1].at = follower_length(f, from, to, work);
        halved_note(found, sides[0]);
        halved_note(found, sides[1]);
    }
    for (int k = 0, missed = 0; k < MAX_LOOKS && status.code == WHIRL_OK && fabs(found->list[0].apart) > near; k++) {
        const double at = next_place(sides, missed++);
        follower_predict(f, from, to, from, at, work);
        status = follower_find(f, work, follower_across(f, from, to, from, work + all), from->tangent, &trial);
        if (status.code != WHIRL_OK || !trial.orbit) continue;
        const look one = halved_look_at(f, from, &trial, at);
        if (fabs(one.apart) < same) continue;
        missed = 0;
        sides[one.apart < 0.0] = one;
        if (fabs(one.apart) < fabs(found->list[0].apart)) {
            const waypoint kept = *p;
            *p = trial;
            trial = kept;
        }
        halved_note(found, one);
    }
    waypoint_free(&trial);
    free(work);
    return status;
}

whirl_status halved_add(follower *f, const waypoint *from, const waypoint *to) {
    waypoint p;
    looks found = {.count = 0};
    whirl_status status = waypoint_new(f, &p);
    if (status.code == WHIRL_OK) status = halved_close_in(f, from, to, &p, &found);
    if (status.code == WHIRL_OK) {
        const whirl_orbit *orbit = p.orbit ? p.orbit : to->orbit;
        whirl_branch_point point = {
            .value = value_at_end(&found), .second = NAN, .criticality = NAN, .orbit = whirl_orbit_copy(orbit)};
        status = point.orbit ? branch_add(f->branch, f->options, &point)
                             : whirl_fail(WHIRL_NO_MEMORY, "no memory for a point of a branch");
        if (status.code != WHIRL_OK) whirl_orbit_free(point.orbit);
    }
    waypoint_free(&p);
    return status;
}
