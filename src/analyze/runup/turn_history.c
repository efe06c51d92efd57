// The last turns of a run, as samples at equal angles of the shaft.
#include "turn_history.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double two_pi = 6.283185307179586476925;

turn_samples turn_samples_new(size_t samples, size_t probes, size_t contacts) {
    turn_samples made = {.samples = samples, .probes = probes, .contacts = contacts};
    made.width = 1 + 2 * probes + 2 * contacts;
    made.numbers = calloc(samples * made.width, sizeof *made.numbers);
    return made;
}

/// Cubic between two values with slopes by the angle, at the share `s` of a step; linear where a shaft that stands has
/// no such slope.
static double turn_between(double low, double high, double slope_low, double slope_high, double step, double s) {
    const double t = 1.0 - s, linear = t * low + s * high;
    const double bend = s * t * ((t - s) * (low - high) + step * (t * slope_low - s * slope_high));
    return s == 0.0 || !isfinite(bend) ? linear : linear + bend;
}

/// Gap of a contact: how far it is from closing.
static double turn_gap(const whirl_running *running, const double *x, size_t contact) {
    double values[WHIRL_MAX_SWITCHES];
    const whirl_system *system = running->by_angle;
    system->switches(system->model, 0.0, x, values);
    return -values[running->contact_switch(running, contact)];
}

void turn_samples_fill(turn_samples *to, const whirl_running *running, const turn_instant *low,
                       const turn_instant *high) {
    const whirl_system *system = running->by_angle;
    const double spacing = two_pi / (double)to->samples, step = high->angle - low->angle;
    const double first = fmax(ceil(low->angle / spacing - 1e-9), 0.0);
    const size_t speed = system->dimension - 2, time = system->dimension - 1;
    const double *a = low->state, *b = high->state;
    if (!(step > 0.0)) return;
    for (size_t j = (size_t)first; j < to->samples && (double)j * spacing < high->angle - 1e-9 * spacing; j++) {
        double s = ((double)j * spacing - low->angle) / step;
        if (s < 1e-9) s = 0.0;
        double *row = to->numbers + j * to->width;
        *row++ = turn_between(a[time], b[time], 1.0 / a[speed], 1.0 / b[speed], step, s) / running->unit;
        for (size_t p = 0; p < to->probes; p++)
            for (size_t axis = 0; axis < 2; axis++) {
                const whirl_probe *probe = &system->probes[p];
                *row++ =
                    turn_between(whirl_probe_value(probe, a, axis), whirl_probe_value(probe, b, axis),
                                 whirl_probe_value(probe, a, axis + 2), whirl_probe_value(probe, b, axis + 2), step, s);
            }
        for (size_t c = 0; c < to->contacts; c++) {
            *row++ = (1.0 - s) * low->force[c] + s * high->force[c];
            *row++ = (1.0 - s) * turn_gap(running, a, c) + s * turn_gap(running, b, c);
        }
    }
}

turn_history turn_history_new(size_t room, const turn_samples *of) {
    turn_history made = {.room = room, .turn = of->samples * of->width, .end = (double)NAN};
    made.numbers = calloc(2 * room * made.turn + 1, sizeof *made.numbers);
    return made;
}

void turn_history_add(turn_history *to, const double *numbers, double end) {
    if (to->held == 2 * to->room) {
        to->held = to->room;
        memcpy(to->numbers, to->numbers + to->room * to->turn, to->room * to->turn * sizeof *to->numbers);
    }
    memcpy(to->numbers + to->held++ * to->turn, numbers, to->turn * sizeof *numbers);
    to->end = end;
}

const double *turn_history_last(const turn_history *of, size_t turns) {
    return turns > of->held || turns > of->room ? NULL : of->numbers + (of->held - turns) * of->turn;
}
