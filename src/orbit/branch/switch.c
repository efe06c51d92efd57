// Finds orbits on the branch that begins at a special point of another branch.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "curve.h"
#include "follower.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/orbit.h"

/// Doubles the number of revolutions of an orbit.
static whirl_orbit *go_round_twice(const whirl_orbit *orbit, double **nodes) {
    const size_t size = orbit->segment_count * orbit->dimension;
    whirl_orbit *twice = calloc(1, sizeof *twice);
    *nodes = calloc(2 * size + 1, sizeof **nodes);
    if (!twice || !*nodes) {
        free(twice);
        return NULL;
    }
    *twice = *orbit;
    twice->revolutions = 2 * orbit->revolutions;
    twice->period = 2.0 * orbit->period;
    twice->segment_count = 2 * orbit->segment_count;
    memcpy(*nodes, orbit->nodes, size * sizeof **nodes);
    memcpy(*nodes + size, orbit->nodes, size * sizeof **nodes);
    twice->nodes = *nodes;
    return twice;
}

/// Searches an orbit at a distance of `step` along `direction` from the unknowns in `trial`.
static whirl_status step_aside(follower *f, double step, waypoint *at, double *trial, const double *direction) {
    const double value = follower_value(f, trial);
    for (size_t i = 0; i <= f->curve.count; i++) trial[i] += step * direction[i];
    const whirl_status status = follower_find(f, trial, direction, direction, at);
    if (status.code != WHIRL_OK || at->orbit) return status;
    return whirl_fail(WHIRL_BAD_INPUT, "no orbit was found on the branch that begins at %.10g", value);
}

// ---------------------------------------------------------------- from orbits

/// The point of departure, in the unknowns of the other branch.
typedef struct departure_point {
    double *u, *tangent; ///< [unknowns]
} departure_point;

/// Finds the special point from `trial`, then an orbit off it. The orbit is searched orthogonal to `tangent`; if that
/// is NULL, to the tangent of the special point. `point` receives the special point and its tangent.
static whirl_status leave_across(follower *f, double step, const double *tangent, departure_point *point, waypoint *at,
                                 double *trial, double *direction) {
    const size_t size = (f->curve.count + 1) * sizeof *trial;
    curve_parameter_direction(&f->curve, direction);
    const whirl_status status = follower_find(f, trial, direction, direction, at);
    if (status.code != WHIRL_OK) return status;
    if (!tangent && at->orbit) memcpy(point->tangent, at->tangent, size);
    if (!at->orbit || !curve_other(&f->curve, tangent ? tangent : at->tangent, direction))
        return whirl_fail(WHIRL_BAD_INPUT, "the point at which a branch begins was not found again");
    memcpy(point->u, at->u, size);
    memcpy(trial, at->u, size);
    return step_aside(f, step, at, trial, direction);
}

/// Finds the branch's tangent at a thousandth of the span from the special point. At the point itself, where two
/// branches cross, errors turn the tangent towards the other branch. `other` has no orbit if none is found there.
static whirl_status find_other_tangent(follower *f, const departure_point *point, waypoint *other, double *trial,
                                       double *direction) {
    const size_t n = f->curve.count;
    const double span = f->options->to - f->options->from, high = fmax(f->options->from, f->options->to);
    const double aside = 1e-3 * fabs(span), length = point->u[n] + aside > high ? -aside : aside;
    const bool flat = fabs(follower_lean(f, point->tangent)) > 0.3;
    for (size_t i = 0; i < n; i++)
        trial[i] = point->u[i] + (flat ? length * point->tangent[i] / point->tangent[n] : 0.0);
    trial[n] = point->u[n] + length;
    curve_parameter_direction(&f->curve, direction);
    return follower_find(f, trial, direction, point->tangent, other);
}

/// Leaves the special point orthogonal to its own tangent. If errors have turned that tangent, leaves it orthogonal to
/// the tangent next to it.
static whirl_status leave_orbit(follower *f, double value, double step, waypoint *at, double *trial,
                                double *direction) {
    const size_t all = f->curve.count + 1;
    departure_point point = {.u = calloc(2 * all, sizeof(double))};
    waypoint other = {.u = NULL};
    if (!point.u) return whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    point.tangent = point.u + all;
    follower_take(f, value, trial);
    whirl_status left = leave_across(f, step, NULL, &point, at, trial, direction);
    whirl_status status = waypoint_new(f, &other);
    if (status.code == WHIRL_OK && left.code != WHIRL_NO_MEMORY)
        status = find_other_tangent(f, &point, &other, trial, direction);
    if (status.code == WHIRL_OK && other.orbit && curve_dot(&f->curve, other.tangent, point.tangent) < 0.9) {
        memcpy(trial, point.u, all * sizeof *trial);
        left = leave_across(f, step, other.tangent, &point, at, trial, direction);
    }
    waypoint_free(&other);
    free(point.u);
    return status.code == WHIRL_OK ? left : status;
}

// ---------------------------------------------------------------- from equilibria

/// Returns the mode of an equilibrium with that frequency and the least damping.
static size_t whirling_mode(const whirl_modes *modes, double frequency) {
    size_t found = 0;
    for (size_t i = 1; i < modes->count; i++)
        if (hypot(modes->modes[i].real, modes->modes[i].imaginary - frequency) <
            hypot(modes->modes[found].real, modes->modes[found].imaginary - frequency))
            found = i;
    return found;
}

/// Adds the motion of the mode, Re(v exp(i 2 pi share)), at a share (0 to 1) of its period, times a factor.
static void add_mode(const double *vector, size_t dimension, double share, double factor, double *x) {
    const double c = cos(6.283185307179586476925 * share), s = sin(6.283185307179586476925 * share);
    for (size_t i = 0; i < dimension; i++) x[i] += factor * (vector[2 * i] * c - vector[2 * i + 1] * s);
}

/// Searches an orbit about the equilibrium from its mode, of the size of `step`. `direction` receives the mode.
static whirl_status leave_rest(follower *f, const whirl_branch_point *point, const double *vector, double step,
                               waypoint *at, double *trial, double *direction) {
    orbit_equations *e = &f->equations;
    const size_t all = f->curve.count + 1, d = e->s->dimension;
    double largest = 0.0;
    for (size_t i = 0; i < d; i++) largest = fmax(largest, hypot(vector[2 * i], vector[2 * i + 1]));
    for (size_t j = 0; j < e->s->count; j++) {
        double *node = e->nodes + j * d;
        memset(node, 0, d * sizeof *node);
        add_mode(vector, d, (double)j / (double)e->s->count, 1.0 / largest, node);
    }
    follower_take(f, 0.0, direction);
    direction[all - 2] = direction[all - 1] = 0.0;
    for (size_t j = 0; j < e->s->count; j++) {
        double *node = e->nodes + j * d;
        memcpy(node, point->orbit->nodes, d * sizeof *node);
        add_mode(vector, d, (double)j / (double)e->s->count, step * f->curve.scale[0] / largest, node);
    }
    equations_begin_at(e, e->nodes);
    follower_take(f, point->value, trial);
    return step_aside(f, 0.0, at, trial, direction);
}

// ---------------------------------------------------------------- either

typedef struct departure {
    follower follower;
    waypoint at;
    double *work; ///< [2][unknowns]
} departure;

static whirl_status switch_prepare(departure *d, const whirl_family *family, const whirl_orbit *start, double value,
                                   const whirl_branch_options *options) {
    whirl_status status = follower_begin(&d->follower, family, start, value, options);
    if (status.code == WHIRL_OK) status = waypoint_new(&d->follower, &d->at);
    if (status.code != WHIRL_OK) return status;
    d->work = calloc(2 * (d->follower.curve.count + 1), sizeof *d->work);
    return d->work ? status : whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
}

/// Hands the orbit over and frees the rest.
static whirl_status switch_finish(departure *d, whirl_status status, whirl_orbit **orbit, double *value) {
    if (status.code == WHIRL_OK) {
        *value = follower_value(&d->follower, d->at.u);
        *orbit = d->at.orbit;
        d->at.orbit = NULL;
    }
    free(d->work);
    waypoint_free(&d->at);
    follower_end(&d->follower);
    return status;
}

static whirl_status depart_from_rest(const whirl_family *family, const whirl_branch_point *point, double step,
                                     const whirl_branch_options *options, whirl_orbit **orbit, double *value) {
    departure d = {.work = NULL};
    whirl_machine machine;
    whirl_modes *modes = NULL;
    whirl_status status = family->machine(family->context, point->value, &machine);
    if (status.code != WHIRL_OK) return status;
    // The first guess is the equilibrium in all segments, with the period of the whirl that begins there.
    const size_t size = point->orbit->dimension, segments = (size_t)options->orbit.segments;
    double *nodes = calloc(size * segments + 1, sizeof *nodes);
    whirl_orbit start = *point->orbit;
    start.period = 6.283185307179586476925 / point->angle;
    start.segment_count = segments;
    start.nodes = nodes;
    status = nodes ? whirl_modes_new(machine.system, point->orbit->nodes, &modes)
                   : whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    for (size_t j = 0; nodes && j < segments; j++) memcpy(nodes + j * size, point->orbit->nodes, size * sizeof *nodes);
    if (status.code == WHIRL_OK && modes->count == 0)
        status = whirl_fail(WHIRL_BAD_INPUT, "the equilibrium has no mode with a frequency");
    // Leave the equilibrium along the mode that whirls.
    if (status.code == WHIRL_OK) status = switch_prepare(&d, family, &start, point->value, options);
    if (status.code == WHIRL_OK) {
        const double *vector = modes->vectors + 2 * size * whirling_mode(modes, point->angle);
        status = leave_rest(&d.follower, point, vector, step, &d.at, d.work, d.work + d.follower.curve.count + 1);
    }
    whirl_modes_free(modes);
    if (machine.release) machine.release(machine.owner);
    status = switch_finish(&d, status, orbit, value);
    free(nodes);
    return status;
}

static whirl_status depart_from_orbit(const whirl_family *family, const whirl_branch_point *point, double step,
                                      const whirl_branch_options *options, whirl_orbit **orbit, double *value) {
    const bool doubles = point->special == WHIRL_DOUBLING;
    departure d = {.work = NULL};
    double *nodes = NULL;
    whirl_orbit *start = doubles ? go_round_twice(point->orbit, &nodes) : point->orbit;
    whirl_status status = start ? switch_prepare(&d, family, start, point->value, options)
                                : whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    if (status.code == WHIRL_OK)
        status = leave_orbit(&d.follower, point->value, step, &d.at, d.work, d.work + d.follower.curve.count + 1);
    status = switch_finish(&d, status, orbit, value);
    if (doubles) free(start);
    free(nodes);
    return status;
}

whirl_status whirl_branch_switch(const whirl_family *family, const whirl_branch_point *point, double step,
                                 const whirl_branch_options *options, whirl_orbit **orbit, double *value) {
    *orbit = NULL;
    if (point->special == WHIRL_HOPF) return depart_from_rest(family, point, step, options, orbit, value);
    if (point->special != WHIRL_DOUBLING && point->special != WHIRL_BRANCHING)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "no branch begins at this point, expected a doubling, a branching or a Hopf point");
    if (point->special == WHIRL_DOUBLING && point->orbit->revolutions == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "doubled orbits of autonomous motions are not searched for");
    return depart_from_orbit(family, point, step, options, orbit, value);
}
