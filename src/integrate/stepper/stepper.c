// Steps of one motion: slopes, interpolant, and the point at which a step must end. Formulas, error estimates and
// lengths of steps are those of the kernels.
#include "stepper.h"
#include "bernstein.h"
#include "crossing.h"
#include "stepper_parts.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "adaptive_lanes.h"

// ---------------------------------------------------------------- the system as kernels see it

/// Computes the forcing that the kernel sees: the time t itself.
static void forcing_at(const void *model, size_t stride, size_t vectors, const void *t, void *forcing) {
    (void)model, (void)stride, (void)vectors;
    *(double *)forcing = *(const double *)t;
}

/// Applies the Jacobian to unit vectors by differences of order 2, exact to 1e-10: for systems without a Jacobian, and
/// for motions along switches.
static void difference_columns(const stepper *c, double t, const double *at, double *columns) {
    const size_t n = c->dimension;
    double *x = c->slot->end_v, *below = c->slot->end_slope; // not yet in use
    memcpy(x, at, n * sizeof *x);
    for (size_t j = 0; j < n; j++) {
        double *column = columns + j * n;
        const double apart = 0x1p-17 * (fabs(at[j]) + c->atol / c->rtol);
        x[j] = at[j] + apart;
        const double high = x[j];
        stepper_slope(c, t, x, column);
        x[j] = at[j] - apart;
        stepper_slope(c, t, x, below);
        for (size_t i = 0; i < n; i++) column[i] = (column[i] - below[i]) / (high - x[j]);
        x[j] = at[j];
    }
}

static void stepper_system_flow(const lanes_view *view) {
    const stepper *c = view->model;
    const double t = *(const double *)view->forcing, *x = view->v, *vectors = x + c->dimension;
    double *slope = view->a, *columns = slope + c->dimension;
    stepper_slope(c, t, x, slope);
    if (c->slot && view->tangents > 0 && (!c->system->tangent || c->sliding_count > 0))
        difference_columns(c, t, x, columns);
    else if (view->tangents > 0)
        stepper_apply_jacobian(c, t, x, view->tangents, vectors, columns);
    if (view->divergence) *(double *)view->divergence = stepper_divergence(c, t, x);
}

// ---------------------------------------------------------------- memory

/// Joins the groups of two coordinates, whose sizes are then measured together.
static void join(size_t *mates, size_t a, size_t b) {
    for (size_t i = mates[a]; i != a; i = mates[i])
        if (i == b) return;
    if (a == b) return;
    const size_t next = mates[a];
    mates[a] = mates[b];
    mates[b] = next;
}

/// Groups coordinates whose sizes are measured together: those of one probe, or of a group of a rotor. So a coordinate
/// that passes zero need not be more exact there.
static void find_mates(size_t *mates, const whirl_system *system) {
    const whirl_lanes *lanes = system->lanes;
    for (size_t d = 0; d < system->dimension; d++) mates[d] = d;
    for (size_t i = 0; !lanes && i < system->probe_count; i++) {
        const whirl_probe *probe = &system->probes[i];
        join(mates, probe->x, probe->y);
        join(mates, probe->x, probe->vx);
        join(mates, probe->x, probe->vy);
    }
    for (size_t g = 0; lanes && g < lanes->group_count; g++)
        for (size_t d = lanes->groups[g]; d < lanes->groups[g + 1]; d++) {
            join(mates, lanes->groups[g], d);
            join(mates, lanes->groups[g], lanes->degrees + d);
        }
}

static const size_t no_groups[] = {0};

/// Makes the kernel's slot. Returns false without memory.
static bool make_slot(stepper *c, const whirl_system *system) {
    find_mates(c->mates, system);
    adaptive_lanes *slot = adaptive_lanes_make(&(adaptive_lanes){.method = c->method,
                                                                 .model = c,
                                                                 .flow = stepper_system_flow,
                                                                 .forcing_at = forcing_at,
                                                                 .stride = 1,
                                                                 .slots = 1,
                                                                 .rates = c->dimension,
                                                                 .dimension = c->dimension,
                                                                 .forcing_count = 1,
                                                                 .modulated = true,
                                                                 .groups = no_groups,
                                                                 .mates = c->mates,
                                                                 .rtol = c->rtol,
                                                                 .atol = c->atol,
                                                                 .limit = INFINITY});
    // Use the slot's arrays as those of the step.
    c->slot = slot;
    if (!slot) return false;
    slot->running[0] = 1.0;
    c->start = slot->v;
    c->end = slot->end_v;
    c->first = slot->slope;
    c->last = slot->end_slope;
    c->stage = slot->stage_v;
    c->dense_count = c->method->dense;
    for (int i = 0; i < c->dense_count; i++) c->dense[i] = slot->dense[1 + i];
    return true;
}

stepper *stepper_new(const lanes_method *own, const whirl_system *system, const whirl_integrate_options *options) {
    const size_t n = system->dimension, switches = system->switch_count;
    const size_t numbers = (6 + CUBIC + RK4_ROWS + MAX_SLIDING + 3) * n + (1 + SWITCH_ROWS) * switches;
    stepper *c =
        calloc(1, sizeof *c + numbers * sizeof(double) + n * sizeof(size_t) + switches * (sizeof(int) + sizeof(bool)));
    if (!c) return NULL;
    *c = (stepper){.method = own,
                   .dimension = n,
                   .rtol = options->rtol,
                   .atol = options->atol,
                   .limit = options->limit,
                   .fixed = rk4_one_of(stepper_system_flow, c, n),
                   .dense_count = CUBIC};
    // Divide the one allocation.
    double *row = (double *)(c + 1);
    double **const parts[] = {&c->x,     &c->start,    &c->end,      &c->first,   &c->last,
                              &c->stage, &c->dense[0], &c->dense[1], &c->dense[2]};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++, row += n) *parts[i] = row;
    c->rows = row;
    c->work = c->rows + RK4_ROWS * n;
    c->sides = c->work + (MAX_SLIDING + 3) * n;
    c->at_switches = c->sides + switches;
    c->mates = (size_t *)(c->at_switches + SWITCH_ROWS * switches);
    c->held = (int *)(c->mates + n);
    c->sliding = (bool *)(c->held + switches);
    // With an adaptive method the arrays of the step are those of the kernel's slot.
    if (!own || make_slot(c, system)) return c;
    stepper_free(c);
    return NULL;
}

void stepper_free(stepper *c) {
    if (!c) return;
    adaptive_lanes_free(c->slot);
    free(c);
}

// ---------------------------------------------------------------- one step

/// Tries a step of length h from `start`, whose slope at the beginning is known. Computes its end and the slope there.
/// Returns the norm of its error divided by the tolerance, or NaN if the step leaves the equations' domain.
static double try_step(stepper *c, double h) {
    adaptive_lanes *slot = c->slot;
    c->length = h;
    c->tried++;
    c->interpolated = false;
    if (!slot) {
        rk4_try_step(c, h);
        for (size_t d = 0; d < c->dimension; d++)
            if (!isfinite(c->last[d])) return NAN;
        return 0.0;
    }
    *slot->length = h;
    c->method->one->try_step(slot);
    return sqrt(*slot->error);
}

static double try_varied(stepper *c) {
    if (!c->variation.set) return 0.0;
    return c->method ? c->method->try_varied(c) : rk4_try_varied(c);
}

/// Tries a step of the state and of its perturbations, so that these are as exact as the state. Returns the larger norm
/// of their errors. If the error of perturbations is NaN, the state decides.
static double try_all(stepper *c, double h) {
    const double error = try_step(c, h);
    if (!(error <= 1.0)) return error;
    const double varied = try_varied(c);
    return isfinite(varied) ? fmax(error, varied) : error;
}

void stepper_interpolate(stepper *c) {
    if (c->slot && c->interpolated) return;
    c->interpolated = true;
    if (c->slot) {
        c->method->one->take_polynomials(c->slot);
        return;
    }
    for (size_t d = 0; d < c->dimension; d++) {
        const double way = c->end[d] - c->start[d], h = c->length;
        c->dense[0][d] = way;
        c->dense[1][d] = h * c->first[d] - way;
        c->dense[2][d] = 2.0 * way - h * (c->first[d] + c->last[d]);
    }
}

void stepper_between(const stepper *c, double theta, double *x) {
    for (size_t d = 0; d < c->dimension; d++) {
        double sum = 0.0;
        for (int i = c->dense_count - 1; i >= 0; i--) sum = (sum + c->dense[i][d]) * (i % 2 == 0 ? theta : 1.0 - theta);
        x[d] = c->start[d] + sum;
    }
}

// ---------------------------------------------------------------- beginnings

static whirl_motion judge(const stepper *c) {
    for (size_t d = 0; d < c->dimension; d++)
        if (!(fabs(c->x[d]) <= c->limit)) return WHIRL_DIVERGED; // NaN too
    return WHIRL_BOUNDED;
}

void stepper_place(stepper *c, const whirl_system *system, double t) {
    c->system = system;
    c->t = t;
    c->switchings = 0;
    c->crossed = true;
    if (!c->slot) return;
    c->slot->period = system->period;
    *c->slot->before = 1.0;
    *c->slot->attempts = 0.0;
}

whirl_motion stepper_begin(stepper *c, const whirl_system *system, const double *x) {
    stepper_place(c, system, 0.0);
    memcpy(c->x, x, c->dimension * sizeof *x);
    if (judge(c) != WHIRL_BOUNDED) return WHIRL_DIVERGED;
    stepper_find_sides(c);
    if (!c->slot) return WHIRL_BOUNDED;
    memcpy(c->start, c->x, c->dimension * sizeof *x);
    stepper_slope(c, 0.0, c->x, c->first);
    *c->slot->t = 0.0;
    c->method->one->begin(c->slot);
    return WHIRL_BOUNDED;
}

// ---------------------------------------------------------------- steps that end at switches

static void observe(void *context, double theta, double *values) {
    stepper *c = context;
    stepper_between(c, theta, c->stage);
    stepper_guarded(c, c->begin + theta * c->length, c->stage, values);
}

/// Takes the step again so that it ends where function `which` is zero. Ends it first at theta of its length, by the
/// interpolant, then corrects it by the remaining value. Shares of sliding are curved, most of all near the end of a
/// contact: their slope is taken from the last two steps.
static void land(stepper *c, double theta, size_t which) {
    const int tries = c->sliding[which] ? 12 : 4;
    const double whole = c->length, nudge = 1e-4;
    double *after = stepper_row(c, ROW_TO), *before = stepper_row(c, ROW_FROM);
    observe(c, theta + nudge, after);
    observe(c, theta - nudge, before);
    double rate = (after[which] - before[which]) / (2.0 * nudge * whole);
    double h = theta * whole, last_h = h, last = 0.0;
    for (int i = 0; i < tries; i++) {
        try_step(c, h);
        stepper_guarded(c, c->begin + h, c->end, after);
        const double secant = (after[which] - last) / (h - last_h);
        if (c->sliding[which] && i > 0 && secant < 0.0) rate = secant;
        if (fabs(after[which]) <= stepper_reach(c, which, c->begin + h, c->end) || !(rate < 0.0)) break;
        const double nearer = h - after[which] / rate;
        if (!(nearer > 0.0 && nearer <= whole) || i == tries - 1) break;
        last_h = h;
        last = after[which];
        h = nearer;
    }
}

/// Returns true if all switching functions certainly keep their signs, by their values and derivatives at both ends of
/// the step. The last step of a part may begin and end so near to a switch that its function counts as zero: then the
/// next part finds the sides.
static bool is_clear(stepper *c, bool last) {
    const double end = c->begin + c->length;
    double *from = stepper_row(c, ROW_FROM), *to = stepper_row(c, ROW_TO);
    if (!c->system->switch_gradient || c->sliding_count > 0) return false;
    stepper_guarded(c, c->begin, c->start, from);
    stepper_guarded(c, end, c->end, to);
    for (size_t i = 0; i < c->system->switch_count; i++) {
        if (last && !c->sliding[i] && fmax(fabs(from[i]), fabs(to[i])) <= stepper_reach(c, i, end, c->end)) continue;
        if (c->held[i] > 0 || !(from[i] > 0.0) || !(to[i] > 0.0)) return false;
        const double third = c->sides[i] * c->length / 3.0;
        const double rise = third * stepper_rate(c, i, c->begin, c->start, c->first);
        if (bernstein_clear(from[i], from[i] + rise, to[i] - third * stepper_rate(c, i, end, c->end, c->last), to[i]) <
            0.5)
            return false;
    }
    return true;
}

/// The first part of a step, up to a share of its length.
typedef struct beginning {
    stepper *c;
    double share;
} beginning;

static void observe_beginning(void *context, double theta, double *values) {
    const beginning *part = context;
    observe(part->c, part->share * theta, values);
}

/// Searches the part before a zero again, until no earlier zero is found. Near the end of a contact the share of a
/// sliding friction may change rapidly between the points at which a whole step is sampled.
static void look_closer(stepper *c, double *theta, size_t *which) {
    enum { LOOKS = 8 };
    const double same = 1.0 - 1e-9;
    double nearer;
    size_t other;
    for (int i = 0; i < LOOKS; i++) {
        beginning part = {c, *theta};
        const crossing_search search = {observe_beginning, &part, c->system->switch_count, c->held,
                                        stepper_row(c, ROW_SEARCH)};
        if (!crossing_first(&search, &nearer, &other) || !(nearer < same)) return;
        *theta *= nearer;
        *which = other;
    }
}

/// Returns true if the step just tried must end at a switch, and writes the theta of this end (0: the step's beginning)
/// and the switch.
static bool meets_switch(stepper *c, double until, double *theta, size_t *which) {
    // A step as short as a few roundings of the time cannot hold a crossing: a zero of its interpolant is rounding.
    const bool sliver = c->length <= 2.0 * DBL_EPSILON * fmax(fabs(c->begin), 1.0);
    if (c->system->switch_count == 0 || sliver || is_clear(c, c->begin + c->length >= until)) {
        if (c->observed && c->eager) stepper_interpolate(c);
        return false;
    }
    const crossing_search search = {observe, c, c->system->switch_count, c->held, stepper_row(c, ROW_SEARCH)};
    stepper_interpolate(c);
    if (!crossing_first(&search, theta, which)) return false;
    if (c->sliding_count > 0 && *theta > 0.0) look_closer(c, theta, which);
    return true;
}

/// Moves the motion to the end of the step.
static void go_on(stepper *c, double t) {
    c->t = t;
    memcpy(c->x, c->end, c->dimension * sizeof *c->x);
    memset(c->held, 0, c->system->switch_count * sizeof *c->held);
    if (c->sliding_count > 0) stepper_project(c, c->x);
}

/// Returns a length for the next step which leaves no tiny step before `until`.
static double next_length(const stepper *c, double until) {
    const double left = until - c->t;
    if (!c->slot) return left;
    const double most = c->system->switch_count > 0 ? fmin(*c->slot->h, c->system->period / 8.0) : *c->slot->h;
    if (left <= most * 1.01) return left;
    return left < 2.0 * most ? 0.5 * left : most;
}

/// Tries steps of decreasing length until one meets the tolerance.
static whirl_motion accept(stepper *c, double until) {
    adaptive_lanes *slot = c->slot;
    if (!slot) return try_all(c, next_length(c, until)) <= 1.0 ? WHIRL_BOUNDED : WHIRL_DIVERGED;
    *slot->t = c->t;
    for (;;) {
        const double length = next_length(c, until);
        const double error = try_all(c, length);
        const bool cut = c->halts && length < *slot->h;
        *slot->error = error * error;
        if (c->method->one->judge(slot)) {
            // The small error of a step cut short by an instant does not slow down the growth of the next ones.
            if (cut) *slot->before = 1.0;
            return WHIRL_BOUNDED;
        }
        if (*slot->special > 0.5) return isfinite(error) ? WHIRL_STUCK : WHIRL_DIVERGED;
    }
}

whirl_motion stepper_step(stepper *c, double until) {
    enum { MAX_STAYS = 8 };
    for (int stays = 0;; stays++) {
        double theta = 1.0;
        size_t which = 0;
        c->begin = c->t;
        memcpy(c->start, c->x, c->dimension * sizeof *c->x);
        if (c->crossed || c->sliding_count > 0) {
            stepper_slope(c, c->t, c->x, c->first);
        } else {
            memcpy(c->first, c->last, c->dimension * sizeof *c->x);
        }
        for (size_t d = 0; d < c->dimension; d++)
            if (!isfinite(c->first[d])) return WHIRL_DIVERGED;
        const whirl_motion motion = accept(c, until);
        if (motion != WHIRL_BOUNDED) return motion;
        c->crossed = meets_switch(c, until, &theta, &which);
        if (!c->crossed) {
            stepper_vary(c);
            go_on(c, c->length < until - c->begin ? c->begin + c->length : until);
            return judge(c);
        }
        if (++c->switchings > MAX_SWITCHINGS) return WHIRL_STUCK;
        if (theta > 0.0) {
            land(c, theta, which);
            if (c->observed) stepper_interpolate(c);
            try_varied(c);
            stepper_vary(c);
            go_on(c, c->begin + c->length);
        }
        stepper_cross_varied(c, which);
        if (theta > 0.0) return judge(c);
        // The state is so near to the switch that the interpolant, which is exact to the tolerance, contradicts the
        // derivatives there.
        if (stays >= MAX_STAYS && c->held[which] > 0) c->held[which] = CROSSING_ALONG;
    }
}
