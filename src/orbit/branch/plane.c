// Curves of special points over two parameters, by the equations of the orbit and the function that vanishes there.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "branch_points.h"
#include "curve.h"
#include "equations.h"
#include "normal_form.h"
#include "orbit_describe.h"
#include "vanishing.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

/// State of a curve. The unknowns are those of the orbit, which include the first parameter, then the second parameter.
typedef struct walk {
    const whirl_plane *plane;
    const whirl_branch_options *options;
    double low, high; ///< bounds of the second parameter
    whirl_special kind;
    size_t touch;
    double second; ///< second parameter of the family's machines
    whirl_family family;
    orbit_equations equations;
    curve curve;
    whirl_branch *branch;
    double step;
    double *u, *tangent, *trial; ///< [unknowns] present point
    double *before;              ///< [2][unknowns] the point before, and scratch for a direction
    double *aside;               ///< [unknowns] scratch of derivatives, like the next ones
    double *above, *below;       ///< [equations]
    double *orbit_derivative;    ///< [orbit's equations][orbit's unknowns]
    whirl_orbit *orbit;          ///< orbit at the point found last
} walk;

static whirl_status make_machine(const void *context, double value, whirl_machine *machine) {
    const walk *w = context;
    return w->plane->machine(w->plane->context, value, w->second, machine);
}

/// Sets the second parameter, which changes the machine at every value of the first.
static void set_second(walk *w, double second) {
    if (second != w->second) w->equations.value = NAN;
    w->second = second;
}

// ---------------------------------------------------------------- equations

/// Evaluates the orbit's equations and the test function at u.
static bool values_at(walk *w, const double *u, double *value, double *derivative, whirl_orbit **orbit) {
    orbit_equations *e = &w->equations;
    const size_t n = equations_count(e);
    whirl_orbit *own = NULL;
    set_second(w, u[n + 1]);
    if (!equations_evaluate(e, u, value, derivative ? derivative : w->orbit_derivative)) return false;
    if (orbit_describe(e->s, e->nodes, equations_period(e, u), 0.0, &own).code != WHIRL_OK) return false;
    value[n] = vanishing_value(w->kind, w->touch, own);
    if (orbit)
        *orbit = own;
    else
        whirl_orbit_free(own);
    return isfinite(value[n]);
}

/// Computes the last row of the derivative, that of the test function, and the last column, that of the second
/// parameter, by central differences.
static bool plane_differences(walk *w, const double *u, double *derivative) {
    const size_t n = equations_count(&w->equations), all = n + 2;
    for (size_t k = 0; k < all; k++) {
        const double apart = 0x1p-14 * w->curve.scale[k];
        memcpy(w->aside, u, all * sizeof *u);
        w->aside[k] = u[k] + apart;
        if (!values_at(w, w->aside, w->above, NULL, NULL)) return false;
        w->aside[k] = u[k] - apart;
        if (!values_at(w, w->aside, w->below, NULL, NULL)) return false;
        derivative[n * all + k] = (w->above[n] - w->below[n]) / (2.0 * apart);
        for (size_t i = 0; k == n + 1 && i < n; i++)
            derivative[i * all + k] = (w->above[i] - w->below[i]) / (2.0 * apart);
    }
    return true;
}

static bool plane_evaluate(void *context, const double *u, double *value, double *derivative) {
    walk *w = context;
    const size_t n = equations_count(&w->equations), all = n + 2;
    whirl_orbit_free(w->orbit);
    w->orbit = NULL;
    if (!derivative) return values_at(w, u, value, NULL, NULL);
    if (!values_at(w, u, value, w->orbit_derivative, &w->orbit)) return false;
    for (size_t i = 0; i < n; i++)
        memcpy(derivative + i * all, w->orbit_derivative + i * (n + 1), (n + 1) * sizeof *derivative);
    if (!plane_differences(w, u, derivative)) return false;
    set_second(w, u[n + 1]);
    equations_put(&w->equations, u);
    return true;
}

/// Returns the size of the residual. The orbit must close to its tolerance. The test function must vanish to 1e-10,
/// since its derivatives are differences.
static double plane_size_of(void *context, const double *u, const double *value) {
    walk *w = context;
    const double orbit = equations_size(&w->equations, u, value);
    return fmax(orbit, 1e10 * w->options->orbit.tolerance * fabs(value[equations_count(&w->equations)]));
}

// ---------------------------------------------------------------- the walk

/// Returns the criticality of a Hopf point, NaN of other points: for orbits it would cost as much again as the curve.
/// The derivative must be that of the last point.
static double plane_criticality(walk *w, double angle) {
    const size_t n = equations_count(&w->equations);
    if (w->kind != WHIRL_HOPF) return NAN;
    set_second(w, w->u[n + 1]);
    if (!equations_evaluate(&w->equations, w->u, w->above, w->orbit_derivative)) return NAN;
    return normal_form(w->equations.s, w->orbit, w->kind, angle);
}

static whirl_status add_point(walk *w) {
    const size_t n = equations_count(&w->equations);
    whirl_branch_point point = {
        .value = w->u[n], .second = w->u[n + 1], .special = w->kind, .touch = w->touch, .orbit = w->orbit};
    if (w->kind == WHIRL_NEIMARK_SACKER || w->kind == WHIRL_HOPF) vanishing_pair(w->orbit, &point.angle);
    point.criticality = plane_criticality(w, point.angle);
    const whirl_status status = branch_add(w->branch, w->options, &point);
    if (status.code == WHIRL_OK) w->orbit = NULL;
    return status;
}

static bool plane_is_within(const walk *w, const double *u) {
    const size_t n = equations_count(&w->equations);
    return u[n] >= fmin(w->options->from, w->options->to) && u[n] <= fmax(w->options->from, w->options->to) &&
           u[n + 1] >= w->low && u[n + 1] <= w->high;
}

/// Finds the point orthogonal to the tangent from the trial, and moves there.
static bool plane_step(walk *w, newton_result *result) {
    const size_t all = equations_count(&w->equations) + 2;
    double *next = w->aside;
    *result = curve_correct(&w->curve, w->tangent, w->trial);
    if (!result->found || !w->orbit || !curve_tangent(&w->curve, w->tangent, w->tangent, next)) return false;
    if (curve_dot(&w->curve, next, w->tangent) < 0.9 && w->step > 8.0 * w->options->least_step) return false;
    memcpy(w->tangent, next, all * sizeof *next);
    memcpy(w->u, w->trial, all * sizeof *next);
    return true;
}

/// Returns the share of the way from `before` to the present point at which a parameter meets its bound, 1 if it stays
/// within; and the bound.
static double share_to_bound(const walk *w, const double *before, size_t index, double low, double high,
                             double *bound) {
    const double value = w->u[index];
    *bound = value > high ? high : low;
    return value > high || value < low ? (*bound - before[index]) / (value - before[index]) : 1.0;
}

/// Adds the last point, on the bound that was passed; if both parameters left their bounds, on the one that was passed
/// first. The first part of work [2][unknowns] is the point before. If no point is found, the curve ends with the point
/// before.
static whirl_status end_at_bound(walk *w, double *work) {
    const size_t n = equations_count(&w->equations), all = n + 2;
    const double low = fmin(w->options->from, w->options->to), high = fmax(w->options->from, w->options->to);
    double bounds[2], *direction = work + all;
    const double first = share_to_bound(w, work, n, low, high, &bounds[0]);
    const double second = share_to_bound(w, work, n + 1, w->low, w->high, &bounds[1]);
    const size_t which = first < second ? 0 : 1;
    for (size_t i = 0; i < all; i++) w->trial[i] = work[i] + fmin(first, second) * (w->u[i] - work[i]);
    w->trial[n + which] = bounds[which];
    memset(direction, 0, all * sizeof *direction);
    direction[n + which] = w->curve.scale[n + which];
    w->branch->end = WHIRL_END_OF_RANGE;
    const newton_result result = curve_correct(&w->curve, direction, w->trial);
    if (!result.found || !w->orbit) return whirl_ok();
    memcpy(w->u, w->trial, all * sizeof *w->u);
    return add_point(w);
}

static whirl_status plane_advance(walk *w, bool *ended) {
    const whirl_branch_options *o = w->options;
    const size_t all = equations_count(&w->equations) + 2;
    newton_result result;
    memcpy(w->before, w->u, all * sizeof *w->u);
    for (;;) {
        for (size_t i = 0; i < all; i++) w->trial[i] = w->u[i] + w->step * w->tangent[i];
        if (plane_step(w, &result)) break;
        *ended = w->step <= o->least_step;
        if (*ended) w->branch->end = WHIRL_END_LOST;
        if (*ended) return whirl_ok();
        w->step = fmax(0.5 * w->step, o->least_step);
    }
    w->step = fmin(fmax(w->step * curve_pace(&result), o->least_step), o->most_step);
    *ended = !plane_is_within(w, w->u);
    if (*ended) return end_at_bound(w, w->before);
    equations_put(&w->equations, w->u);
    equations_begin_at(&w->equations, w->equations.nodes);
    return add_point(w);
}

/// Finds the first point, at the second parameter of the start.
static whirl_status plane_begin(walk *w, const whirl_branch_point *start, int direction) {
    const size_t n = equations_count(&w->equations), nodes = w->equations.s->count * w->equations.s->kept_count;
    equations_take(&w->equations, start->orbit->nodes, w->trial);
    if (n > nodes) w->trial[nodes] = start->orbit->period;
    w->trial[n] = start->value;
    w->trial[n + 1] = w->second;
    memset(w->tangent, 0, (n + 2) * sizeof *w->tangent);
    w->tangent[n + 1] = (direction < 0 ? -1.0 : 1.0) * w->curve.scale[n + 1];
    const newton_result result = curve_correct(&w->curve, w->tangent, w->trial);
    if (!result.found || !w->orbit || !curve_tangent(&w->curve, w->tangent, w->tangent, w->aside))
        return whirl_fail(WHIRL_BAD_INPUT, "the special point that a curve shall begin with was not found again");
    memcpy(w->tangent, w->aside, (n + 2) * sizeof *w->tangent);
    memcpy(w->u, w->trial, (n + 2) * sizeof *w->u);
    return add_point(w);
}

// ---------------------------------------------------------------- memory

static whirl_status plane_prepare(walk *w, const whirl_branch_point *start) {
    const whirl_orbit *orbit = start->orbit;
    // Make the equations of the orbit over the first parameter.
    w->family = (whirl_family){make_machine, w};
    whirl_status status = equations_make(&w->equations, NULL, &w->family, start->value, &w->options->orbit,
                                         orbit->revolutions, orbit->period);
    if (status.code != WHIRL_OK) return status;
    orbit_equations *e = &w->equations;
    if (e->s->dimension != orbit->dimension || e->s->count != orbit->segment_count)
        return whirl_fail(WHIRL_BAD_INPUT, "an orbit of %zu coordinates in %zu segments, expected %zu in %zu",
                          orbit->dimension, orbit->segment_count, e->s->dimension, e->s->count);
    // The curve has one equation more, that of the special point, and one unknown more, the second parameter.
    const size_t n = equations_count(e), all = n + 2;
    equations_reach(e, w->options->to - w->options->from);
    w->curve = (curve){.count = n + 1,
                       .context = w,
                       .evaluate = plane_evaluate,
                       .size = plane_size_of,
                       .tolerance = w->options->orbit.tolerance};
    w->branch = calloc(1, sizeof *w->branch);
    w->u = calloc(8 * all + n * (n + 1), sizeof *w->u);
    if (!w->branch || !w->u || !curve_begin(&w->curve)) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a curve");
    // Divide the one allocation.
    w->tangent = w->u + all;
    w->trial = w->tangent + all;
    w->aside = w->trial + all;
    w->above = w->aside + all;
    w->below = w->above + all;
    w->before = w->below + all;
    w->orbit_derivative = w->before + 2 * all;
    // Begin at the special point.
    memcpy(e->nodes, orbit->nodes, e->s->count * e->s->dimension * sizeof *e->nodes);
    equations_scale(e, w->options->to - w->options->from, w->curve.scale);
    w->curve.scale[n + 1] = w->high - w->low;
    equations_begin_at(e, orbit->nodes);
    return status;
}

static whirl_status plane_follow(walk *w, const whirl_branch_point *start, int direction) {
    bool ended = false;
    whirl_status status = plane_prepare(w, start);
    if (status.code == WHIRL_OK) status = plane_begin(w, start, direction);
    w->step = w->options->step;
    while (status.code == WHIRL_OK && !ended && w->branch->end != WHIRL_END_STOPPED) {
        ended = w->branch->count >= w->options->most_points;
        if (ended)
            w->branch->end = WHIRL_END_OF_POINTS;
        else
            status = plane_advance(w, &ended);
    }
    return w->branch ? branch_finish(w->branch, w->options, status) : status;
}

whirl_status whirl_curve_follow(const whirl_plane *plane, const whirl_branch_point *start, double second, int direction,
                                const double bounds[2], const whirl_branch_options *options, whirl_branch **out) {
    walk w = {.plane = plane,
              .options = options,
              .low = bounds[0],
              .high = bounds[1],
              .kind = start->special,
              .touch = start->touch,
              .second = second};
    *out = NULL;
    // Check the point and the bounds.
    if (start->special == WHIRL_REGULAR || start->special == WHIRL_BRANCHING)
        return whirl_fail(WHIRL_BAD_INPUT, "no curve over two parameters leads through this point, expected a fold, a "
                                           "doubling, a Neimark-Sacker, Hopf or grazing point");
    if (!(bounds[0] < bounds[1] && second >= bounds[0] && second <= bounds[1] && options->from != options->to))
        return whirl_fail(WHIRL_BAD_INPUT, "a curve begins at %g of %g to %g, expected bounds around it", second,
                          bounds[0], bounds[1]);
    // Follow the curve, and hand it over.
    whirl_status status = plane_follow(&w, start, direction);
    if (status.code == WHIRL_OK) {
        *out = w.branch;
        w.branch = NULL;
    }
    whirl_orbit_free(w.orbit);
    whirl_branch_free(w.branch);
    curve_end(&w.curve);
    equations_free(&w.equations);
    free(w.u);
    return status;
}
