// Branches of tori by pseudo-arclength continuation, like those of orbits.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "section_map.h"
#include "torus_describe.h"
#include "torus_equations.h"
#include "torus_follower.h"

whirl_torus_branch_options whirl_torus_branch_default(double from, double to) {
    return (whirl_torus_branch_options){.torus = whirl_torus_default(),
                                        .from = from,
                                        .to = to,
                                        .step = 0.01,
                                        .least_step = 1e-4,
                                        .most_step = 0.05,
                                        .most_points = 200};
}

/// State of the continuation: its present and next waypoints.
typedef struct torus_walk {
    torus_waypoint now, next;
    double step;
    double *before;     ///< [capacity] the present curve with as many nodes as the next one
    bool rough, shrank; ///< reasons why the last try failed
    size_t capacity;    ///< capacity of the branch in points
} torus_walk;

static double torus_branch_value_at(const torus_follower *f, const torus_waypoint *p) {
    return p->u[p->count * f->equations.n + 1];
}

// ---------------------------------------------------------------- points

static whirl_status add_point(const torus_follower *f, torus_walk *w, torus_waypoint *p, whirl_torus_branch *b) {
    if (whirl_stop_is_set(f->options->stop)) { // what was found since a stop is discarded
        b->end = WHIRL_TORUS_STOPPED;
        return whirl_ok();
    }
    if (b->count == w->capacity) {
        const size_t capacity = 2 * w->capacity + 16;
        whirl_torus_point *points = realloc(b->points, capacity * sizeof *points);
        if (!points) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu tori", capacity);
        b->points = points;
        w->capacity = capacity;
    }
    const whirl_torus_branch_options *o = f->options;
    const whirl_torus_point point = {.value = torus_branch_value_at(f, p), .torus = p->torus};
    b->points[b->count++] = point;
    p->torus = NULL; // the branch owns it
    if (o->found && !o->found(o->context, point.value, point.torus)) b->end = WHIRL_TORUS_STOPPED;
    return whirl_ok();
}

static void go_to_next(torus_walk *w) {
    const torus_waypoint kept = w->now;
    w->now = w->next;
    w->next = kept;
}

/// Gives the present curve `count` nodes, and its tangent the length 1 in the units of that size.
static bool take_nodes(torus_follower *f, torus_walk *w, size_t count) {
    torus_equations *e = &f->equations;
    torus_waypoint *now = &w->now;
    const bool good = torus_resample(e, now->count, now->u, count, now->u) &&
                      torus_resample(e, now->count, now->tangent, count, now->tangent);
    if (!good || !torus_follower_resize(f, count, now->u)) return false;
    now->count = count;
    torus_equations_refer(e, now->u);
    return curve_make_unit(&f->curve, now->tangent);
}

// ---------------------------------------------------------------- steps

/// Returns the cosine between the deviations of two curves, with equally many nodes, from their means. It is negative
/// if the second curve has shrunk through a point to the other side.
static double torus_branch_likeness(const torus_equations *e, const double *a, const double *b) {
    const size_t n = e->n;
    double both = 0.0, first = 0.0, second = 0.0;
    for (size_t i = 0; i < n; i++) {
        double mean_a = 0.0, mean_b = 0.0;
        for (size_t j = 0; j < e->count; j++) {
            mean_a += a[j * n + i] / (double)e->count;
            mean_b += b[j * n + i] / (double)e->count;
        }
        for (size_t j = 0; j < e->count; j++) {
            const double away_a = a[j * n + i] - mean_a, away_b = b[j * n + i] - mean_b;
            both += away_a * away_b;
            first += away_a * away_a;
            second += away_b * away_b;
        }
    }
    return both / sqrt(first * second);
}

/// Tries a step. *good becomes true if the step found a curve that continues the branch.
static whirl_status torus_branch_try_step(torus_follower *f, torus_walk *w, bool *good) {
    torus_equations *e = &f->equations;
    enum { FEW = 4 }; // steps within which a curve may shrink to a point
    const double least_likeness = 0.5, least_turn = 0.9;
    *good = w->shrank = w->rough = false;
    if (!take_nodes(f, w, w->now.count)) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus");
    for (size_t i = 0; i <= f->curve.count; i++) f->trial[i] = w->now.u[i] + w->step * w->now.tangent[i];
    memcpy(f->direction, w->now.tangent, (f->curve.count + 1) * sizeof *f->direction);
    memcpy(f->forward, w->now.tangent, (f->curve.count + 1) * sizeof *f->forward);
    const whirl_status status = torus_follower_find(f, &w->next);
    if (status.code != WHIRL_OK || !w->next.torus) return status;
    if (!torus_resample(e, w->now.count, w->now.u, e->count, w->before))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus");
    const double like = torus_branch_likeness(e, w->before, w->next.u),
                 turn = curve_dot(&f->curve, f->forward, w->next.tangent);
    w->rough = w->next.rough;
    w->shrank = like < 0.0 && w->next.torus->radius < FEW * w->step * torus_equations_reach(e, w->next.u);
    *good = !w->rough && like > least_likeness && (turn > least_turn || w->step <= 8.0 * f->options->least_step);
    return status;
}

/// Extrapolates the parameter to where a linear quantity vanishes, which is `one` at the last point and `two` at the
/// one before.
static double torus_branch_vanishing(const whirl_torus_point *last, const whirl_torus_point *before, double one,
                                     double two) {
    return last->value - one * (before->value - last->value) / (two - one);
}

/// Returns the parameter to which the square of the radius extrapolates as 0.
static double shrinking_value(const torus_follower *f, const torus_walk *w, const whirl_torus_branch *b) {
    const whirl_torus_point *last = &b->points[b->count - 1];
    const whirl_torus_point next = {torus_branch_value_at(f, &w->next), w->next.torus};
    const whirl_torus_point *other = b->count > 1 ? last - 1 : &next;
    const double one = last->torus->radius, two = other->torus->radius;
    return torus_branch_vanishing(last, other, one * one, two * two);
}

/// Returns the parameter to which the square of the distance from a resonance extrapolates as 0, if the last two tori
/// approach one.
static double locking_value(const whirl_torus_branch *b) {
    const whirl_torus_point *last = &b->points[b->count - 1];
    const double q = (double)last->torus->resonance, own = last->torus->rotation;
    if (b->count < 2 || q == 0.0) return NAN;
    const double one = own - round(q * own) / q, two = last[-1].torus->rotation - round(q * own) / q;
    return one * two > 0.0 && fabs(one) < fabs(two) ? torus_branch_vanishing(last, last - 1, one * one, two * two)
                                                    : NAN;
}

/// Ends the branch where no step of allowed length continues it.
static void give_up(const torus_follower *f, const torus_walk *w, whirl_torus_branch *b) {
    const double value = b->points[b->count - 1].value;
    char why[WHIRL_MESSAGE_SIZE];
    if (w->shrank) {
        b->end = WHIRL_TORUS_SHRANK;
        b->limit = shrinking_value(f, w, b);
        snprintf(b->why, sizeof b->why, "the torus shrinks to an orbit, whose Neimark-Sacker point is near %.8g",
                 b->limit);
    } else if (w->rough) {
        b->end = WHIRL_TORUS_ROUGH;
        b->limit = locking_value(b);
        torus_say_rough(&f->equations, w->next.torus, why, sizeof why);
        snprintf(b->why, sizeof b->why, "beyond %.8g %.300s", value, why);
    } else {
        b->end = WHIRL_TORUS_LOST;
        snprintf(b->why, sizeof b->why, "beyond %.8g steps of %.2g find no torus", value, w->step);
    }
}

static bool torus_branch_is_within(const torus_follower *f, const torus_waypoint *p) {
    const double value = torus_branch_value_at(f, p);
    return value >= fmin(f->options->from, f->options->to) && value <= fmax(f->options->from, f->options->to);
}

/// Adds the last point, at the bound of the parameter.
static whirl_status end_at_bound(torus_follower *f, torus_walk *w, whirl_torus_branch *b) {
    const torus_equations *e = &f->equations;
    const size_t last = e->count * e->n + 1;
    const double value = w->next.u[last], before = torus_branch_value_at(f, &w->now);
    const double low = fmin(f->options->from, f->options->to), high = fmax(f->options->from, f->options->to);
    const double bound = value > high ? high : low, share = (bound - before) / (value - before);
    if (!torus_resample(e, w->now.count, w->now.u, e->count, w->before))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus");
    for (size_t i = 0; i < last; i++) f->trial[i] = w->before[i] + share * (w->next.u[i] - w->before[i]);
    f->trial[last] = bound;
    curve_parameter_direction(&f->curve, f->direction);
    memcpy(f->forward, w->next.tangent, (last + 1) * sizeof *f->forward);
    const whirl_status status = torus_follower_find(f, &w->next);
    b->end = WHIRL_TORUS_END_OF_RANGE;
    snprintf(b->why, sizeof b->why, "the parameter left its bounds at %.8g", bound);
    if (status.code != WHIRL_OK || !w->next.torus || w->next.rough || share <= 0.0) return status;
    return add_point(f, w, &w->next, b);
}

/// Adds the next point.
static whirl_status torus_branch_advance(torus_follower *f, torus_walk *w, whirl_torus_branch *b, bool *ended) {
    const whirl_torus_branch_options *o = f->options;
    bool good;
    whirl_status status;
    while (status = torus_branch_try_step(f, w, &good), status.code == WHIRL_OK && !good) {
        *ended = w->shrank || w->step <= o->least_step;
        if (*ended) give_up(f, w, b);
        if (*ended) return status;
        w->step = fmax(0.5 * w->step, o->least_step);
    }
    if (status.code != WHIRL_OK) return status;
    *ended = !torus_branch_is_within(f, &w->next);
    if (*ended) return end_at_bound(f, w, b);
    const size_t wanted = torus_nodes_wanted(&f->equations, w->next.u, w->next.torus->error);
    status = add_point(f, w, &w->next, b);
    w->step = fmin(fmax(w->step * w->next.pace, o->least_step), o->most_step);
    go_to_next(w);
    // Use fewer nodes if many are unnecessary; more are used as soon as they are needed.
    if (10 * wanted < 7 * w->now.count && status.code == WHIRL_OK && !take_nodes(f, w, wanted))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus");
    return status;
}

// ---------------------------------------------------------------- the branch

/// Finds the first point and its direction.
static whirl_status torus_branch_begin(torus_follower *f, torus_walk *w, const whirl_torus *start, double value,
                                       int direction, whirl_torus_branch *b) {
    torus_equations *e = &f->equations;
    const size_t last = start->node_count * e->n + 1;
    if (start->node_count > f->options->torus.most_nodes)
        return whirl_fail(WHIRL_BAD_INPUT, "a torus of %zu nodes, expected at most %zu of the branch",
                          start->node_count, f->options->torus.most_nodes);
    for (size_t j = 0; j < start->node_count; j++)
        section_map_take(e->map, start->nodes + j * start->dimension, f->trial + j * e->n);
    f->trial[last - 1] = 6.283185307179586476925 * start->rotation;
    f->trial[last] = value;
    if (!torus_follower_resize(f, start->node_count, f->trial))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus of %zu nodes", start->node_count);
    torus_equations_refer(e, f->trial);
    curve_parameter_direction(&f->curve, f->direction);
    memcpy(f->forward, f->direction, (last + 1) * sizeof *f->forward);
    whirl_status status = torus_follower_find(f, &w->now);
    if (status.code == WHIRL_OK && (!w->now.torus || w->now.rough))
        status = whirl_fail(WHIRL_BAD_INPUT, "no torus was found near the given start of a branch");
    if (status.code != WHIRL_OK) return status;
    curve_turn(&f->curve, direction, w->now.tangent);
    return add_point(f, w, &w->now, b);
}

static whirl_status torus_branch_follow(torus_follower *f, torus_walk *w, const whirl_torus *start, double value,
                                        int direction, whirl_torus_branch *b) {
    bool ended = false;
    whirl_status status = torus_branch_begin(f, w, start, value, direction, b);
    w->step = f->options->step;
    while (status.code == WHIRL_OK && !ended && b->end != WHIRL_TORUS_STOPPED && b->count < f->options->most_points)
        status = torus_branch_advance(f, w, b, &ended);
    if (ended) return status;
    const bool stopped = b->end == WHIRL_TORUS_STOPPED;
    if (!stopped) b->end = WHIRL_TORUS_END_OF_POINTS;
    snprintf(b->why, sizeof b->why, "%s", stopped ? "it was stopped" : "as many points as were asked for");
    return status;
}

whirl_status whirl_torus_follow(const whirl_family *family, const whirl_torus *start, double value, int direction,
                                const whirl_torus_branch_options *options, whirl_torus_branch **branch) {
    torus_follower f;
    torus_walk w = {.step = 0.0};
    *branch = NULL;
    // Make the branch, the equations and two waypoints.
    whirl_torus_branch *b = calloc(1, sizeof *b);
    if (!b) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch of tori");
    b->limit = NAN;
    whirl_status status =
        torus_follower_begin(&f, family, start->revolutions, start->dimension, start->nodes, value, options);
    if (status.code == WHIRL_OK) status = torus_waypoint_new(&f, &w.now);
    if (status.code == WHIRL_OK) status = torus_waypoint_new(&f, &w.next);
    w.before = status.code == WHIRL_OK ? calloc(f.capacity, sizeof *w.before) : NULL;
    if (status.code == WHIRL_OK && !w.before) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a branch of tori");
    // Follow the branch, and hand it over.
    if (status.code == WHIRL_OK) status = torus_branch_follow(&f, &w, start, value, direction, b);
    free(w.before);
    torus_waypoint_free(&w.now);
    torus_waypoint_free(&w.next);
    torus_follower_end(&f);
    if (status.code == WHIRL_OK)
        *branch = b;
    else
        whirl_torus_branch_free(b);
    return status;
}

void whirl_torus_branch_free(whirl_torus_branch *branch) {
    if (!branch) return;
    for (size_t i = 0; i < branch->count; i++) whirl_torus_free(branch->points[i].torus);
    free(branch->points);
    free(branch);
}
