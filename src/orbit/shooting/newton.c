#include "newton.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "elimination.h"

typedef struct newton_work {
    double *value, *tried, *step, *at; ///< [count]
    double *derivative, *there;        ///< [count][count] at u and at the trial point
    double *own;                       ///< [count][count] factors of the derivative at u
    size_t *own_order;                 ///< [count]
    const double *factors;             ///< factors of the derivative that steps use
    const size_t *order;
    double trusted; ///< size of F before a step whose result was not evaluated; 0: none
} newton_work;

static bool newton_decompose(const newton_problem *p, newton_work *w, const double *derivative) {
    memcpy(w->own, derivative, p->count * p->count * sizeof *derivative);
    w->factors = w->own;
    w->order = w->own_order;
    return elimination_decompose(p->count, w->own, w->own_order);
}

/// Computes the Newton step from a value of F. Returns false if it is not finite.
static bool step_from(const newton_problem *p, const newton_work *w, const double *value, double *step) {
    memcpy(step, value, p->count * sizeof *step);
    elimination_solve(p->count, w->factors, w->order, step);
    for (size_t i = 0; i < p->count; i++)
        if (!isfinite(step[i])) return false;
    return true;
}

static double newton_measure(const newton_problem *p, const double *u, double *value, double *derivative) {
    if (!p->evaluate(p->context, u, value, derivative)) return INFINITY;
    const double size = p->size(p->context, u, value);
    return isfinite(size) ? size : (double)INFINITY;
}

static double newton_length(const newton_problem *p, const double *step) {
    double sum = 0.0;
    for (size_t i = 0; i < p->count; i++) {
        const double part = p->scale ? step[i] / p->scale[i] : step[i];
        sum += part * part;
    }
    return sqrt(sum);
}

/// Returns true if the trial point is nearer to the zero: F is smaller there, or the next step with the same derivative
/// would be shorter. The latter does not depend on the units of the equations (Deuflhard 2011, 3.3).
static bool is_nearer(const newton_problem *p, newton_work *w, double size, double now, double share) {
    if (now < size) return true;
    return isfinite(now) && step_from(p, w, w->tried, w->at) &&
           newton_length(p, w->at) < (1.0 - 0.5 * share) * newton_length(p, w->step);
}

/// Moves along the step as far as it leads nearer to the zero. Returns the size of F there, infinite if no part of the
/// step leads nearer.
static double newton_move(const newton_problem *p, newton_work *w, double size, double *u) {
    double share = 1.0, gone = 0.0;
    for (int k = 0; k <= p->most_halvings; k++, share *= 0.5) {
        for (size_t i = 0; i < p->count; i++) u[i] -= (share - gone) * w->step[i];
        gone = share;
        const double now = newton_measure(p, u, w->tried, w->there);
        if (is_nearer(p, w, size, now, share)) {
            double *there = w->there;
            w->there = w->derivative;
            w->derivative = there;
            memcpy(w->value, w->tried, p->count * sizeof *w->value);
            return now;
        }
    }
    for (size_t i = 0; i < p->count; i++) u[i] += gone * w->step[i];
    return INFINITY;
}

/// Returns true if another step will certainly be the last, judged by the last reduction of F.
static bool is_last(const newton_problem *p, double size) {
    return p->share && 4.0 * *p->share * size <= p->tolerance;
}

/// Iterates with the derivative from nearby, as long as each step leaves at most a quarter of F. Returns true if that
/// converges.
static bool iterate_nearby(const newton_problem *p, newton_work *w, double *u) {
    w->factors = p->nearby;
    w->order = p->nearby_order;
    double size = newton_measure(p, u, w->value, NULL);
    for (int k = 0; k < p->most_steps && size > p->tolerance && isfinite(size); k++) {
        if (!step_from(p, w, w->value, w->step)) return false;
        memcpy(w->at, u, p->count * sizeof *u);
        for (size_t i = 0; i < p->count; i++) u[i] -= w->step[i];
        w->trusted = is_last(p, size) ? size : 0.0;
        if (w->trusted > 0.0) return true;
        const double now = newton_measure(p, u, w->value, NULL);
        if (!(now <= 0.25 * size)) {
            if (!(now <= size)) memcpy(u, w->at, p->count * sizeof *u);
            return false;
        }
        if (p->share) *p->share = now / size;
        size = now;
    }
    return size <= p->tolerance;
}

static newton_result newton_iterate(const newton_problem *p, newton_work *w, double *u) {
    enum { FAR = 2 }; // cost in steps of a nearby derivative that failed
    const bool far = p->nearby && !iterate_nearby(p, w, u);
    newton_result result = {.size = newton_measure(p, u, w->value, w->derivative)};
    if (w->trusted > 0.0) *p->share = result.size / w->trusted;
    if (!isfinite(result.size)) return result;
    for (result.steps = far ? FAR : 0; result.steps < p->most_steps; result.steps++) {
        result.found = result.size <= p->tolerance;
        if (result.found) return result;
        const bool known = newton_decompose(p, w, w->derivative) && step_from(p, w, w->value, w->step);
        const double now = known ? newton_move(p, w, result.size, u) : (double)INFINITY;
        if (!isfinite(now)) {
            result.found = result.size <= 100.0 * p->tolerance;
            if (result.found) newton_measure(p, u, w->value, w->derivative);
            return result;
        }
        result.size = now;
    }
    result.found = result.size <= p->tolerance;
    return result;
}

newton_result newton_solve(const newton_problem *p, double *u) {
    const size_t n = p->count;
    double *memory = malloc((4 * n + 3 * n * n + 1) * sizeof *memory), *matrices = memory ? memory + 4 * n : NULL;
    size_t *order = malloc((n + 1) * sizeof *order);
    newton_result result = {.size = INFINITY};
    if (memory && order) {
        newton_work work = {.value = memory,
                            .tried = memory + n,
                            .step = memory + 2 * n,
                            .at = memory + 3 * n,
                            .derivative = matrices,
                            .there = matrices + n * n,
                            .own = matrices + 2 * n * n,
                            .own_order = order};
        result = newton_iterate(p, &work, u);
    }
    free(memory);
    free(order);
    return result;
}
