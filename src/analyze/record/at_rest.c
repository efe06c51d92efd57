// Rest: a motion that is constant, as far as its steps resolve it, at an equilibrium. What moves is as small as the
// errors of the steps, so neither returns nor a perturbed copy mean anything. The equilibrium and its eigenvalues
// decide instead. See docs/theory.md, "Rest".
#include "at_rest.h"
#include "two_pi.h"

#include <math.h>
#include <stdlib.h>

#include "section.h"
#include "turns.h"

/// Largest size of a motion at rest, over the state's size.
static const double near_enough = 1e-5;

/// Returns the scale that a state has at least. The steps do not resolve a motion below `near_enough` of this scale, or
/// it is rounding.
static double least_scale(const whirl_integrate_options *integrate) {
    const double tolerances = 100.0, rounding = 1e-12;
    return fmax(whirl_method_is_adaptive(integrate->method) ? tolerances * integrate->atol : 0.0, rounding) /
           near_enough;
}

/// Returns the largest coordinate, or `scale` if that is larger.
static double scale_of(const whirl_record *record, double scale) {
    for (size_t i = 0; i < record->dimension; i++)
        scale = fmax(scale, fmax(fabs(record->low[i]), fabs(record->high[i])));
    return scale;
}

/// Returns the largest distance of the record's bounds from x.
static double reach_from(const whirl_record *record, const double *x) {
    double squares = 0.0;
    for (size_t i = 0; i < record->dimension; i++) {
        const double away = fmax(fabs(record->low[i] - x[i]), fabs(record->high[i] - x[i]));
        squares += away * away;
    }
    return sqrt(squares);
}

static bool has_turns(const whirl_system *system) {
    for (size_t i = 0; i < system->dimension; i++)
        if (turns_on(system->turns, i)) return true;
    return false;
}

/// Returns true if no force moves the system from x at any instant of a revolution: oscillating forces do no more than
/// a displacement by 1e-10 of the scale would. `work` has dimension (dimension + 1) numbers, `forcing` those of the
/// system.
static bool stays_at(const whirl_system *system, const double *x, double scale, double *work, double *forcing) {
    enum { INSTANTS = 16 };
    const double unmoved = 1e-10;
    const size_t d = system->dimension;
    double *slope = work, *jacobian = work + d;
    if (whirl_rest_slope(system, x, slope, jacobian).code != WHIRL_OK) return false;
    for (int k = 0; k < INSTANTS; k++) {
        const double t = system->period * k / INSTANTS;
        if (system->forcing) system->forcing(system->model, t, forcing);
        system->rhs(system->model, t, forcing, x, slope);
        for (size_t i = 0; i < d; i++) {
            double stiffness = 0.0;
            for (size_t j = 0; j < d; j++) stiffness += fabs(jacobian[i * d + j]);
            if (!(fabs(slope[i]) <= unmoved * scale * stiffness)) return false;
        }
    }
    return true;
}

/// Finds the mode that decays most slowly, or grows fastest, per revolution. Its frequency is in orders.
static void take_slowest(const whirl_modes *modes, double period, whirl_record_rest *rest) {
    rest->growth = modes->growth * period;
    for (size_t i = 0; i < modes->count; i++)
        if (modes->modes[i].real == modes->growth) rest->order = modes->modes[i].imaginary * period / two_pi;
}

whirl_status at_rest_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record) {
    const size_t d = record->dimension;
    if (record->motion != WHIRL_BOUNDED || !system->tangent || has_turns(system)) return whirl_ok();
    const double scale = scale_of(record, least_scale(integrate));
    if (!(reach_from(record, record->end) <= 2.0 * near_enough * scale)) return whirl_ok();
    whirl_modes *modes;
    const whirl_status status = whirl_modes_new(system, record->end, &modes);
    if (status.code != WHIRL_OK) return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
    double *work = malloc((d * (d + 1) + system->forcing_count + 1) * sizeof *work);
    const double away = reach_from(record, modes->rest) / scale;
    if (work && away <= near_enough && stays_at(system, modes->rest, scale, work, work + d * (d + 1))) {
        record->rest = (whirl_record_rest){.found = true, .distance = away};
        take_slowest(modes, system->period, &record->rest);
    }
    whirl_modes_free(modes);
    free(work);
    return work ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to look for where a motion rests");
}
