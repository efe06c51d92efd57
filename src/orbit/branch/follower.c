// Steps shared by following a branch and locating its special points.
#include "follower.h"
#include "curve.h"
#include "orbit_describe.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------- waypoints

whirl_status waypoint_new(const follower *f, waypoint *out) {
    const size_t all = equations_unknowns(&f->equations);
    *out = (waypoint){.u = calloc(2 * all, sizeof(double))};
    if (!out->u) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch of %zu unknowns", all);
    out->tangent = out->u + all;
    return whirl_ok();
}

void waypoint_free(waypoint *p) {
    whirl_orbit_free(p->orbit);
    free(p->u);
    *p = (waypoint){.u = NULL};
}

// ---------------------------------------------------------------- the follower

void follower_scale(follower *f, double *tangent) {
    equations_scale(&f->equations, f->options->to - f->options->from, f->curve.scale);
    const double length = sqrt(curve_dot(&f->curve, tangent, tangent));
    for (size_t i = 0; i <= f->curve.count; i++) tangent[i] /= length;
}

whirl_status follower_begin(follower *f, const whirl_family *family, const whirl_orbit *start, double value,
                            const whirl_branch_options *options) {
    *f = (follower){.options = options};
    const size_t shared = start->revolutions > 0 ? start->revolutions : 1;
    whirl_status status =
        equations_make(&f->equations, NULL, family, value, &options->orbit, start->revolutions, start->period);
    if (status.code != WHIRL_OK) return status;
    // The first orbit must have the family's dimension and the options' segments.
    orbit_equations *e = &f->equations;
    if (e->s->dimension != start->dimension || e->s->count != start->segment_count)
        return whirl_fail(
            WHIRL_BAD_INPUT, "an orbit of %zu coordinates in %zu segments, expected %zu in %zu of the branch",
            start->dimension, start->segment_count, e->s->dimension, (size_t)options->orbit.segments * shared);
    // Make the curve of these equations.
    equations_reach(e, options->to - options->from);
    f->curve = (curve){.count = equations_count(e),
                       .context = e,
                       .evaluate = equations_evaluate,
                       .size = equations_size,
                       .tolerance = options->orbit.tolerance};
    f->branch = calloc(1, sizeof *f->branch);
    if (!f->branch || !curve_begin(&f->curve)) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch");
    // Begin at the first orbit.
    memcpy(e->nodes, start->nodes, e->s->count * e->s->dimension * sizeof *e->nodes);
    equations_scale(e, options->to - options->from, f->curve.scale);
    equations_begin_at(e, start->nodes);
    return status;
}

void follower_end(follower *f) {
    curve_end(&f->curve);
    equations_free(&f->equations);
    whirl_branch_free(f->branch);
    f->branch = NULL;
}

double follower_value(const follower *f, const double *u) {
    return u[f->curve.count];
}

void follower_take(const follower *f, double value, double *u) {
    const orbit_equations *e = &f->equations;
    equations_take(e, e->nodes, u);
    if (f->curve.count > e->s->count * e->s->kept_count) u[f->curve.count - 1] = e->s->period;
    u[f->curve.count] = value;
}

double follower_lean(const follower *f, const double *tangent) {
    return tangent[f->curve.count] / f->curve.scale[f->curve.count];
}

/// Share of the parameter in a tangent above which a branch counts as a function of the parameter.
static const double steep = 0.3;

/// Returns true if the branch is a function of its parameter from a to b and a little further: nowhere steep, and
/// hardly bent.
static bool is_flat(const follower *f, const waypoint *a, const waypoint *b) {
    const double bent = 0.98;
    if (!a->orbit || !b->orbit) return false;
    const double first = follower_lean(f, a->tangent), last = follower_lean(f, b->tangent);
    return first * last > 0.0 && fmin(fabs(first), fabs(last)) > steep &&
           curve_dot(&f->curve, a->tangent, b->tangent) > bent;
}

const double *follower_across(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from,
                              double *direction) {
    if (!is_flat(f, a, b)) return from->tangent;
    curve_parameter_direction(&f->curve, direction);
    return direction;
}

double follower_length(const follower *f, const waypoint *a, const waypoint *b, double *work) {
    const size_t n = f->curve.count;
    for (size_t i = 0; i <= n; i++) work[i] = b->u[i] - a->u[i];
    return is_flat(f, a, b) ? work[n] / a->tangent[n] : curve_dot(&f->curve, work, a->tangent);
}

void follower_predict(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from, double length,
                      double *u) {
    const size_t n = f->curve.count;
    for (size_t i = 0; i <= n; i++) u[i] = from->u[i] + length * from->tangent[i];
    if (!is_flat(f, a, b)) return;
    const double h = b->u[n] - a->u[n], x = (u[n] - a->u[n]) / h, y = 1.0 - x;
    if (!(h != 0.0 && fabs(x) < 4.0)) return;
    const double by_a = h * x * y * y / a->tangent[n], by_b = -h * x * x * y / b->tangent[n];
    const double share = x * x * (3.0 - 2.0 * x);
    for (size_t i = 0; i < n; i++)
        u[i] = a->u[i] + share * (b->u[i] - a->u[i]) + by_a * a->tangent[i] + by_b * b->tangent[i];
}

whirl_status follower_find(follower *f, const double *u, const double *direction, const double *along, waypoint *out) {
    orbit_equations *e = &f->equations;
    const size_t all = f->curve.count + 1;
    whirl_orbit_free(out->orbit);
    out->orbit = NULL;
    memcpy(out->u, u, all * sizeof *u);
    const newton_result result = curve_correct(&f->curve, direction, out->u);
    out->pace = curve_pace(&result);
    const double *across = fabs(follower_lean(f, along)) > steep ? direction : along;
    if (!result.found || !curve_tangent(&f->curve, across, along, out->tangent)) return whirl_ok();
    return orbit_describe(e->s, e->nodes, equations_period(e, out->u), result.size, &out->orbit);
}
