// The last turns of a run, as samples at equal angles of the shaft.
#include "turn_history.h"
#include "two_pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

turn_samples turn_samples_new(size_t samples, size_t probes, size_t contacts, size_t torques, size_t shafts) {
    turn_samples made = {
        .samples = samples, .probes = probes, .contacts = contacts, .torques = torques, .shafts = shafts};
    made.width = 1 + 2 * probes + 2 * contacts + torques + RUNUP_SHAFT_NUMBERS * shafts;
    made.numbers = calloc((samples + 4) * made.width, sizeof *made.numbers);
    for (size_t i = 0; i < 2 && made.numbers; i++) {
        made.ends[i].numbers = made.numbers + (samples + 2 * i) * made.width;
        made.ends[i].slopes = made.ends[i].numbers + made.width;
    }
    return made;
}

/// Interpolates at the share `s` of a step, by the cubic between two values with slopes by time.
static double turn_between(double low, double high, double slope_low, double slope_high, double step, double s) {
    const double t = 1.0 - s;
    return t * low + s * high + s * t * ((t - s) * (low - high) + step * (t * slope_low - s * slope_high));
}

/// Returns the share of the step at which the shaft has an angle, by the secant method within a bracket (Illinois).
static double turn_share_at(const turn_instant *low, const turn_instant *high, double angle) {
    const double step = high->numbers[0] - low->numbers[0];
    double a = 0.0, b = 1.0, fa = low->angle - angle, fb = high->angle - angle, s = fa == 0.0 ? 0.0 : 1.0;
    for (int i = 0; i < 60 && fa * fb < 0.0 && b - a > 1e-15; i++) {
        s = (a * fb - b * fa) / (fb - fa);
        const double f = turn_between(low->angle, high->angle, low->speed, high->speed, step, s) - angle;
        if (fabs(f) < 1e-15) break;
        if ((f < 0.0) == (fb < 0.0))
            b = s, fb = f, fa *= 0.5;
        else
            a = s, fa = f, fb *= 0.5;
    }
    return s;
}

void turn_samples_fill(turn_samples *to, const turn_instant *low, const turn_instant *high) {
    const double spacing = two_pi / (double)to->samples, step = high->numbers[0] - low->numbers[0];
    const double first = fmax(ceil(low->angle / spacing - 1e-9), 0.0);
    for (size_t j = (size_t)first; j < to->samples && (double)j * spacing < high->angle - 1e-9 * spacing; j++) {
        const double angle = (double)j * spacing;
        const double s = angle - low->angle < 1e-9 * spacing ? 0.0 : turn_share_at(low, high, angle);
        double *row = to->numbers + j * to->width;
        for (size_t i = 0; i < to->width; i++) row[i] = (1.0 - s) * low->numbers[i] + s * high->numbers[i];
        for (size_t i = 0; i < 2 * to->probes && s > 0.0; i++)
            row[1 + i] =
                turn_between(low->numbers[1 + i], high->numbers[1 + i], low->slopes[i], high->slopes[i], step, s);
    }
}

turn_history turn_history_new(size_t capacity, const turn_samples *of) {
    turn_history made = {.capacity = capacity, .turn = of->samples * of->width, .end = (double)NAN};
    made.numbers = calloc(2 * capacity * made.turn + 1, sizeof *made.numbers);
    return made;
}

void turn_history_add(turn_history *to, const double *numbers, double end) {
    if (to->held == 2 * to->capacity) {
        to->held = to->capacity;
        memcpy(to->numbers, to->numbers + to->capacity * to->turn, to->capacity * to->turn * sizeof *to->numbers);
    }
    memcpy(to->numbers + to->held++ * to->turn, numbers, to->turn * sizeof *numbers);
    to->end = end;
}

const double *turn_history_last(const turn_history *of, size_t turns) {
    return turns > of->held || turns > of->capacity ? NULL : of->numbers + (of->held - turns) * of->turn;
}
