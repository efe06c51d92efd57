// Branches of periodic orbits by pseudo-arclength continuation (Keller 1977; Allgower, Georg 1990).
#include "whirl/engine/branch.h"
#include "branch_points.h"
#include "curve.h"
#include "follower.h"
#include "halved.h"
#include "mirrored.h"
#include "special_points.h"
#include "whirl/engine/orbit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

whirl_branch_options whirl_branch_default(double from, double to) {
    return (whirl_branch_options){.orbit = whirl_orbit_default(),
                                  .from = from,
                                  .to = to,
                                  .step = 0.01,
                                  .least_step = 1e-10,
                                  .most_step = 0.05,
                                  .most_points = 1000,
                                  .special = true};
}

// ---------------------------------------------------------------- steps

static void branch_exchange(waypoint *a, waypoint *b) {
    const waypoint kept = *a;
    *a = *b;
    *b = kept;
}

/// State of the continuation: its last, present, next and first waypoints.
typedef struct walk {
    waypoint before, now, next, first;
    double *trial, *across; ///< [unknowns]
    double step;
    bool within; ///< the parameter is within its bounds
} walk;

static whirl_status add_waypoint(follower *f, const waypoint *p) {
    whirl_branch_point point = {
        .value = follower_value(f, p->u), .second = NAN, .criticality = NAN, .orbit = whirl_orbit_copy(p->orbit)};
    if (!point.orbit) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point of a branch");
    const whirl_status status = branch_add(f->branch, f->options, &point);
    if (status.code != WHIRL_OK) whirl_orbit_free(point.orbit);
    return status;
}

/// Returns true if the parameter turns round twice between two points although it changes in the same direction at
/// both. This is judged by the cubic along the branch through both points with their tangents.
static bool hides_folds(const follower *f, const waypoint *a, const waypoint *b, double *work) {
    const size_t n = f->curve.count;
    const double first = a->tangent[n], last = b->tangent[n], least = 0.1 * fmin(fabs(first), fabs(last));
    for (size_t i = 0; i <= n; i++) work[i] = b->u[i] - a->u[i];
    const double mean = work[n] / sqrt(curve_dot(&f->curve, work, work));
    const double by_x = 2.0 * (3.0 * mean - 2.0 * first - last), by_square = 3.0 * (first + last - 2.0 * mean);
    const double x = -0.5 * by_x / by_square, extreme = first + 0.5 * by_x * x;
    return first * last > 0.0 && x > 0.0 && x < 1.0 && copysign(1.0, first) * extreme < least;
}

/// Tries a step. *good becomes true if the step found a point that continues the branch.
static whirl_status branch_try_step(follower *f, walk *w, bool *good) {
    const waypoint *now = &w->now, *next = &w->next;
    follower_predict(f, &w->before, now, now, w->step, w->trial);
    const double *across = follower_across(f, &w->before, now, now, w->across);
    const whirl_status status = follower_find(f, w->trial, across, now->tangent, &w->next);
    *good = false;
    if (status.code != WHIRL_OK || !next->orbit) return status;
    const size_t before = w->now.orbit->unstable, after = next->orbit->unstable;
    const bool turned = curve_dot(&f->curve, w->now.tangent, next->tangent) < 0.9;
    const bool leapt = (before > after ? before - after : after - before) > 2;
    for (size_t i = 0; i <= f->curve.count; i++) w->trial[i] -= next->u[i];
    const bool far = sqrt(curve_dot(&f->curve, w->trial, w->trial)) > 0.25 * w->step;
    const bool hides = f->options->special && hides_folds(f, now, next, w->across);
    *good = !(turned || leapt || far || hides) || w->step <= 8.0 * f->options->least_step;
    return status;
}

/// Adds the special points between the present point and the next one, or the branch's end.
static whirl_status pass_special(follower *f, walk *w, bool *ended) {
    *ended = halved_between(&w->now, &w->next);
    if (*ended) {
        f->branch->end = WHIRL_END_HALVED;
        return halved_add(f, &w->now, &w->next);
    }
    whirl_branch_point point;
    whirl_status status = mirrored_locate(f, &w->now, &w->next, &point, ended);
    const bool pitchfork = point.orbit != NULL;
    if (pitchfork) {
        if (*ended) f->branch->end = WHIRL_END_MIRRORED;
        status = branch_add(f->branch, f->options, &point);
        if (status.code != WHIRL_OK) whirl_orbit_free(point.orbit);
    }
    if (status.code != WHIRL_OK || *ended || !f->options->special) return status;
    return special_locate(f, &w->now, &w->next, pitchfork);
}

/// Adds the last point, at the bound of the parameter.
static whirl_status end_at_bound(follower *f, walk *w) {
    const whirl_branch_options *o = f->options;
    const double value = follower_value(f, w->next.u), low = fmin(o->from, o->to), high = fmax(o->from, o->to);
    const double bound = value > high ? high : low, before = follower_value(f, w->now.u);
    const double share = (bound - before) / (value - before);
    const size_t all = f->curve.count + 1;
    double *direction = calloc(all, sizeof *direction);
    if (!direction) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point of a branch");
    for (size_t i = 0; i < all; i++) w->trial[i] = w->now.u[i] + share * (w->next.u[i] - w->now.u[i]);
    w->trial[all - 1] = bound;
    curve_parameter_direction(&f->curve, direction);
    whirl_status status = follower_find(f, w->trial, direction, w->now.tangent, &w->next);
    free(direction);
    f->branch->end = WHIRL_END_OF_RANGE;
    if (status.code != WHIRL_OK || !w->next.orbit || share <= 0.0) return status;
    bool ended;
    status = pass_special(f, w, &ended);
    return status.code == WHIRL_OK && !ended ? add_waypoint(f, &w->next) : status;
}

/// Shifts the unknowns of an orbit, or a direction, by a number of segments.
static void begin_later(const follower *f, const double *u, size_t segments, double *out) {
    const size_t count = f->equations.s->count, kept = f->equations.s->kept_count;
    memcpy(out, u, (f->curve.count + 1) * sizeof *u);
    for (size_t j = 0; j < count; j++) memcpy(out + j * kept, u + (j + segments) % count * kept, kept * sizeof *u);
}

/// Returns true if the branch has returned to its first point, or to the same orbit shifted by some revolutions.
static bool is_closed(const follower *f, const walk *w) {
    const size_t all = f->curve.count + 1, count = f->equations.s->count;
    const size_t revolutions = f->equations.s->revolutions, turns = revolutions > 0 ? revolutions : 1;
    if (f->branch->count < 8) return false;
    for (size_t turn = 0; turn < turns; turn++) {
        const size_t later = turn * (count / turns);
        begin_later(f, w->first.tangent, later, w->trial);
        if (!(curve_dot(&f->curve, w->now.tangent, w->trial) > 0.9)) continue;
        begin_later(f, w->first.u, later, w->trial);
        for (size_t i = 0; i < all; i++) w->trial[i] -= w->now.u[i];
        if (sqrt(curve_dot(&f->curve, w->trial, w->trial)) < 0.75 * w->step) return true;
    }
    return false;
}

static bool branch_is_within(const follower *f, const waypoint *p) {
    const double value = follower_value(f, p->u);
    return value >= fmin(f->options->from, f->options->to) && value <= fmax(f->options->from, f->options->to);
}

/// Adds the next point.
static whirl_status branch_advance(follower *f, walk *w, bool *ended) {
    bool good;
    whirl_status status;
    // Halve the step until a point continues the branch; at the shortest step the branch is lost.
    while (status = branch_try_step(f, w, &good), status.code == WHIRL_OK && !good) {
        *ended = w->step <= f->options->least_step;
        if (*ended) f->branch->end = WHIRL_END_LOST;
        if (*ended) return status;
        w->step = fmax(0.5 * w->step, f->options->least_step);
    }
    if (status.code != WHIRL_OK) return status;
    // Add the point, after the special points that the step passed.
    *ended = !branch_is_within(f, &w->next);
    if (*ended) return end_at_bound(f, w);
    status = pass_special(f, w, ended);
    if (status.code != WHIRL_OK || *ended) return status;
    status = add_waypoint(f, &w->next);
    if (status.code != WHIRL_OK) return status;
    // Choose the next step, and move on: the equations begin at the new point.
    w->step = fmin(fmax(w->step * w->next.pace, f->options->least_step), f->options->most_step);
    branch_exchange(&w->before, &w->next);
    branch_exchange(&w->before, &w->now);
    equations_put(&f->equations, w->now.u);
    equations_begin_at(&f->equations, f->equations.nodes);
    follower_scale(f, w->now.tangent);
    *ended = is_closed(f, w);
    if (*ended) f->branch->end = WHIRL_END_CLOSED;
    return status;
}

/// Finds the first point and its direction.
static whirl_status branch_begin(follower *f, walk *w, double value, int direction) {
    const size_t all = f->curve.count + 1;
    follower_take(f, value, w->trial);
    double *along = calloc(all, sizeof *along);
    if (!along) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch");
    curve_parameter_direction(&f->curve, along);
    whirl_status status = follower_find(f, w->trial, along, along, &w->now);
    free(along);
    if (status.code == WHIRL_OK && !w->now.orbit)
        status = whirl_fail(WHIRL_BAD_INPUT, "no periodic orbit was found near the given start of a branch");
    if (status.code != WHIRL_OK) return status;
    curve_turn(&f->curve, direction, w->now.tangent);
    memcpy(w->first.u, w->now.u, 2 * all * sizeof *w->now.u);
    return add_waypoint(f, &w->now);
}

static whirl_status branch_follow(follower *f, walk *w, double value, int direction) {
    bool ended = false;
    whirl_status status = branch_begin(f, w, value, direction);
    w->step = f->options->step;
    while (status.code == WHIRL_OK && !ended && f->branch->end != WHIRL_END_STOPPED) {
        ended = f->branch->count >= f->options->most_points;
        if (ended)
            f->branch->end = WHIRL_END_OF_POINTS;
        else
            status = branch_advance(f, w, &ended);
    }
    return branch_finish(f->branch, f->options, status);
}

whirl_status whirl_branch_follow(const whirl_family *family, const whirl_orbit *start, double value, int direction,
                                 const whirl_branch_options *options, whirl_branch **branch) {
    follower f;
    walk w = {.step = 0.0};
    *branch = NULL;
    const curve_way way = {options->from, options->to, options->least_step, options->step, options->most_step};
    whirl_status status = curve_check(&way, value);
    // Make the equations and four waypoints.
    if (status.code != WHIRL_OK) return status;
    status = follower_begin(&f, family, start, value, options);
    if (status.code == WHIRL_OK) status = waypoint_new(&f, &w.before);
    if (status.code == WHIRL_OK) status = waypoint_new(&f, &w.now);
    if (status.code == WHIRL_OK) status = waypoint_new(&f, &w.next);
    if (status.code == WHIRL_OK) status = waypoint_new(&f, &w.first);
    w.trial = status.code == WHIRL_OK ? calloc(2 * (f.curve.count + 1), sizeof *w.trial) : NULL;
    if (status.code == WHIRL_OK && !w.trial) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch");
    w.across = w.trial ? w.trial + f.curve.count + 1 : NULL;
    // Follow the branch, and hand it over.
    if (status.code == WHIRL_OK) status = branch_follow(&f, &w, value, direction);
    if (status.code == WHIRL_OK) {
        *branch = f.branch;
        f.branch = NULL;
    }
    free(w.trial);
    waypoint_free(&w.before);
    waypoint_free(&w.now);
    waypoint_free(&w.next);
    waypoint_free(&w.first);
    follower_end(&f);
    return status;
}
