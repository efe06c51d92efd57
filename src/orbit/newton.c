#include "newton.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

typedef struct newton_work {
    double *value, *tried, *step, *at; ///< [count]
    double *derivative, *there;        ///< [count][count] at u and where it was tried
} newton_work;

static double measure(const newton_problem *p, const double *u, double *value, double *derivative) {
    if (!p->evaluate(p->context, u, value, derivative)) return INFINITY;
    const double size = p->size(p->context, u, value);
    return isfinite(size) ? size : (double)INFINITY;
}

static double length(const newton_problem *p, const double *step) {
    double sum = 0.0;
    for (size_t i = 0; i < p->count; i++) {
        const double part = p->scale ? step[i] / p->scale[i] : step[i];
        sum += part * part;
    }
    return sqrt(sum);
}

/// Whether where it was tried lies nearer to the zero: F is smaller there, or the step that the same derivative would
/// take from there is shorter, which does not hang on what the equations are measured in (Deuflhard 2011, 3.3).
static bool is_nearer(const newton_problem *p, newton_work *w, double size, double now, double share) {
    if (now < size) return true;
    memcpy(w->at, w->tried, p->count * sizeof *w->at);
    return isfinite(now) && matrix_solve(p->count, w->derivative, 1, w->at) &&
           length(p, w->at) < (1.0 - 0.5 * share) * length(p, w->step);
}

/// Goes along the step by as much as leads nearer to the zero; gives the size of F there, infinite where nothing does.
static double go(const newton_problem *p, newton_work *w, double size, double *u) {
    double share = 1.0, gone = 0.0;
    for (int k = 0; k <= p->most_halvings; k++, share *= 0.5) {
        for (size_t i = 0; i < p->count; i++) u[i] -= (share - gone) * w->step[i];
        gone = share;
        const double now = measure(p, u, w->tried, w->there);
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

/// Steps by the derivative from nearby, as long as each leaves a quarter of F at most; whether that is all it takes.
static bool iterate_nearby(const newton_problem *p, newton_work *w, double *u) {
    double size = measure(p, u, w->value, NULL);
    for (int k = 0; k < p->most_steps && size > p->tolerance && isfinite(size); k++) {
        memcpy(w->step, w->value, p->count * sizeof *w->step);
        memcpy(w->at, u, p->count * sizeof *u);
        if (!matrix_solve(p->count, p->nearby, 1, w->step)) return false;
        for (size_t i = 0; i < p->count; i++) u[i] -= w->step[i];
        const double now = measure(p, u, w->value, NULL);
        if (!(now <= 0.25 * size)) {
            if (!(now <= size)) memcpy(u, w->at, p->count * sizeof *u);
            return false;
        }
        size = now;
    }
    return size <= p->tolerance;
}

static newton_result iterate(const newton_problem *p, newton_work *w, double *u) {
    enum { FAR = 2 }; // what a derivative from nearby that did not do counts for
    const bool far = p->nearby && !iterate_nearby(p, w, u);
    newton_result result = {.size = measure(p, u, w->value, w->derivative)};
    if (!isfinite(result.size)) return result;
    for (result.steps = far ? FAR : 0; result.steps < p->most_steps; result.steps++) {
        result.found = result.size <= p->tolerance;
        if (result.found) return result;
        memcpy(w->step, w->value, p->count * sizeof *w->step);
        const double now =
            matrix_solve(p->count, w->derivative, 1, w->step) ? go(p, w, result.size, u) : (double)INFINITY;
        if (!isfinite(now)) {
            result.found = result.size <= 100.0 * p->tolerance;
            if (result.found) measure(p, u, w->value, w->derivative);
            return result;
        }
        result.size = now;
    }
    result.found = result.size <= p->tolerance;
    return result;
}

newton_result newton_solve(const newton_problem *p, double *u) {
    const size_t n = p->count;
    double *room = malloc((4 * n + 2 * n * n + 1) * sizeof *room);
    newton_result result = {.size = INFINITY};
    if (!room) return result;
    newton_work work = {room, room + n, room + 2 * n, room + 3 * n, room + 4 * n, room + 4 * n + n * n};
    result = iterate(p, &work, u);
    free(room);
    return result;
}
