// Switches between the ends of a fixed step, and the saltation there.
#include "unlocated.h"

#include <string.h>

#include "saltation.h"

enum { START, END_SLOPE, BETWEEN, BEFORE, AFTER, GRADIENT };

static bool sees(const whirl_system *system) {
    return system->switch_count > 0 && system->switch_gradient && system->rhs_on_sides;
}

/// Rows of what there is of every switch: at the beginning and end of the step, at a change; sides.
enum { OF_BEGINNING, OF_END, OF_CHANGE, SIDES };

static double *of_switches(const unlocated_step *step, int which) {
    return step->before + (size_t)which * step->system->switch_count;
}

static double *row(const unlocated_step *step, int which) {
    return step->rows + (size_t)which * step->system->dimension;
}

void unlocated_begin(unlocated_step *step, double t, const double *x) {
    const whirl_system *system = step->system;
    if (!sees(system)) return;
    step->t = t;
    memcpy(row(step, START), x, system->dimension * sizeof *x);
    if (!step->known) system->switches(system->model, t, x, step->before);
    step->known = true;
}

static void slope_at(const whirl_system *system, double t, const double *x, const double *sides, double *slope) {
    double forcing[WHIRL_MAX_FORCING];
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    system->rhs_on_sides(system->model, t, forcing, x, sides, slope);
}

/// The state at theta of the step, by its ends and the slopes there.
static void between(const unlocated_step *step, const double *end, double theta, double *x) {
    const double *start = row(step, START), *last = row(step, END_SLOPE);
    const double left = 1.0 - theta, h = step->length;
    for (size_t d = 0; d < step->system->dimension; d++)
        x[d] = left * left * ((1.0 + 2.0 * theta) * start[d] + theta * h * step->slope[d]) +
               theta * theta * ((3.0 - 2.0 * theta) * end[d] - left * h * last[d]);
}

static void signs(const whirl_system *system, const double *values, double *sides) {
    for (size_t i = 0; i < system->switch_count; i++) sides[i] = values[i] > 0.0 ? 1.0 : -1.0;
}

/// Halves the step down to where switch `which` changes; BETWEEN gets the state and `values` the switches there.
static double find_change(const unlocated_step *step, const double *end, size_t which, double *values) {
    enum { HALVINGS = 50 };
    const whirl_system *system = step->system;
    const bool from = step->before[which] > 0.0;
    double low = 0.0, high = 1.0, middle = 0.5;
    for (int i = 0; i < HALVINGS; i++, middle = 0.5 * (low + high)) {
        between(step, end, middle, row(step, BETWEEN));
        system->switches(system->model, step->t + middle * step->length, row(step, BETWEEN), values);
        *((values[which] > 0.0) == from ? &low : &high) = middle;
    }
    return step->t + middle * step->length;
}

static void saltate_at(const unlocated_step *step, const double *end, size_t which, whirl_disturbances *disturbances) {
    const whirl_system *system = step->system;
    double *values = of_switches(step, OF_CHANGE), *sides = of_switches(step, SIDES), by_time;
    const double t = find_change(step, end, which, values), *x = row(step, BETWEEN);
    signs(system, values, sides);
    sides[which] = step->before[which] > 0.0 ? 1.0 : -1.0;
    slope_at(system, t, x, sides, row(step, BEFORE));
    sides[which] = -sides[which];
    slope_at(system, t, x, sides, row(step, AFTER));
    system->switch_gradient(system->model, t, x, which, row(step, GRADIENT), &by_time);
    disturbances->volume += saltate(system->dimension, row(step, BEFORE), row(step, AFTER), row(step, GRADIENT),
                                    by_time, disturbances->count, disturbances->vectors);
}

void unlocated_saltate(unlocated_step *step, const double *x, whirl_disturbances *disturbances) {
    const whirl_system *system = step->system;
    double *after = of_switches(step, OF_END), *sides = of_switches(step, SIDES);
    bool changed = false;
    if (!sees(system)) return;
    system->switches(system->model, step->t + step->length, x, after);
    for (size_t i = 0; i < system->switch_count; i++) {
        if ((step->before[i] > 0.0) == (after[i] > 0.0)) continue;
        signs(system, after, sides);
        if (!changed) slope_at(system, step->t + step->length, x, sides, row(step, END_SLOPE));
        changed = true;
        saltate_at(step, x, i, disturbances);
    }
    memcpy(step->before, after, system->switch_count * sizeof *after);
}
