// Effect on perturbations of a fixed step that has gone over a switch.
//
// The step ignores the switch, so that its derivative misses the effect of the jump of the right-hand side. The
// saltation matrix at the point where the step's cubic meets the switch corrects this at the step's end, to first order
// in the step. It is the identity where the right-hand side is continuous, as in an elastic contact.
#include <string.h>

#include "saltation.h"
#include "stepper.h"
#include "stepper_parts.h"

static bool sees(const whirl_system *system) {
    return system->switch_count > 0 && system->switch_gradient && system->rhs_on_sides;
}

void unlocated_begin(stepper *c, const double *x) {
    if (!sees(c->system)) return;
    memcpy(c->start, x, c->dimension * sizeof *x);
    c->begin = c->t;
    if (c->crossed) c->system->switches(c->system->model, c->t, x, stepper_row(c, ROW_FROM));
    c->crossed = false; // the switches at the beginning are those at the end of the step before
}

static void take_sides(stepper *c, const double *values) {
    for (size_t i = 0; i < c->system->switch_count; i++) c->sides[i] = values[i] > 0.0 ? 1.0 : -1.0;
}

/// Bisects the step for the change of switch `which`. Computes the state there (c->stage), its time and its sides.
static double find_change(stepper *c, size_t which, bool from) {
    enum { HALVINGS = 50 };
    double low = 0.0, high = 1.0, t = c->begin, *values = stepper_row(c, ROW_FOUND);
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (low + high);
        t = c->begin + middle * c->length;
        stepper_between(c, middle, c->stage);
        c->system->switches(c->system->model, t, c->stage, values);
        *((values[which] > 0.0) == from ? &low : &high) = middle;
    }
    take_sides(c, values);
    return t;
}

static void saltate_at(stepper *c, size_t which, bool from, whirl_perturbations *perturbations) {
    const size_t n = c->dimension;
    double *before = c->rows, *after = before + n, *gradient = after + n, by_time;
    const double t = find_change(c, which, from);
    c->sides[which] = from ? 1.0 : -1.0;
    stepper_slope(c, t, c->stage, before);
    c->sides[which] = -c->sides[which];
    stepper_slope(c, t, c->stage, after);
    c->system->switch_gradient(c->system->model, t, c->stage, which, gradient, &by_time);
    perturbations->volume += saltate(n, before, after, gradient, by_time, perturbations->count, perturbations->vectors);
}

void unlocated_saltate(stepper *c, double t, const double *slope, const double *x, whirl_perturbations *perturbations) {
    const whirl_system *system = c->system;
    double *from = stepper_row(c, ROW_FROM), *to = stepper_row(c, ROW_TO);
    bool changed = false;
    c->t = t;
    if (!sees(system)) return;
    c->length = t - c->begin;
    system->switches(system->model, t, x, to);
    for (size_t i = 0; i < system->switch_count; i++) {
        if ((from[i] > 0.0) == (to[i] > 0.0)) continue;
        if (!changed) {
            memcpy(c->first, slope, c->dimension * sizeof *slope);
            memcpy(c->end, x, c->dimension * sizeof *x);
            take_sides(c, to);
            stepper_slope(c, t, x, c->last);
            stepper_interpolate(c);
        }
        changed = true;
        saltate_at(c, i, from[i] > 0.0, perturbations);
    }
    memcpy(from, to, system->switch_count * sizeof *to);
}
