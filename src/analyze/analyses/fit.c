// Fits: the parameters that were found, their uncertainty, and every measured number next to that of the fitted model.
#include <math.h>

#include "analysis.h"
#include "whirl/internal/fit_columns.h"

enum { OUTCOME, UNKNOWN, CORRELATION, MOTION, NUMBER, PROFILE, FIELD_COUNT };

static size_t fit_unknowns(const block_shape *shape) {
    return (size_t)shape->options->fit.unknowns;
}

static size_t fit_motions(const block_shape *shape) {
    return (size_t)shape->options->fit.motions;
}

static size_t fit_numbers(const block_shape *shape) {
    return (size_t)shape->options->fit.numbers;
}

static size_t fit_profiles(const block_shape *shape) {
    return shape->options->fit.profile ? fit_unknowns(shape) : 0;
}

static const field_plan fields[FIELD_COUNT] = {
    [OUTCOME] = {WHIRL_FIELD_FIT_OUTCOME, "1",
                 "end, lost, steps, sum, deviation, degrees, rank, condition (end: 0 at a minimum, 1 after the most "
                 "steps, 2 no shorter step helps, 3 motion `lost` has no orbit at the start; sum of squares over "
                 "noise, and their standard deviation: in m and m2 if no noise is given)",
                 WHIRL_PER_POINT, FIT_OUTCOME_COLUMNS, NULL},
    [UNKNOWN] = {WHIRL_FIELD_FIT_UNKNOWN, "1",
                 "parameter, start, found, error, half, lowest, highest, known (index of the parameter; SI; standard "
                 "error; half the width of the 95 % interval; bounds; known: 0 determined, 1 at a bound, 2 weakly, 3 "
                 "not at all)",
                 WHIRL_PER_POINT, FIT_UNKNOWN_COLUMNS, fit_unknowns},
    [CORRELATION] = {WHIRL_FIELD_FIT_CORRELATION, "1", "coefficients of correlation of the unknowns' errors",
                     WHIRL_PER_POINT, WHIRL_MAX_UNKNOWNS, fit_unknowns},
    [MOTION] =
        {WHIRL_FIELD_FIT_MOTION, "1",
         "speed, multiplier, scatter, time (rad/s; largest modulus of the orbit's multipliers: stable below 1; NaN "
         "for what is no orbit; of statistics: the largest scatter over its noise; of a row of a run-up: s "
         "since its beginning, else NaN)",
         WHIRL_PER_POINT, FIT_MOTION_COLUMNS, fit_motions},
    [NUMBER] = {WHIRL_FIELD_FIT_NUMBER, "1",
                "set, motion, station, angle, quantity, at, measured, model, noise (entry of the data and motion from "
                "0; rad; 0 displacement, 1 and 2 cosine and sine part of an order, 3 its amplitude, 4 displacement "
                "after a time, 5 onset at rest, 6 onset of an orbit, 7 critical speed, 8 frequency and 9 damping ratio "
                "of a mode, 10 largest and 11 smallest displacement, 12 size of a line, 13 share of contact; "
                "revolutions, the order, seconds, the index of the parameter (-1: the speed), or the number "
                "of the mode; SI)",
                WHIRL_PER_POINT, FIT_NUMBER_COLUMNS, fit_numbers},
    [PROFILE] = {WHIRL_FIELD_FIT_PROFILE, "1",
                 "from, to (ends of the 95 % profile interval of each unknown, SI; NaN beyond its bounds)",
                 WHIRL_PER_POINT, 2, fit_profiles},
};

static void fit_fill_unknown(const whirl_fit *fit, const whirl_fit_solution *s, size_t u, double *out) {
    const whirl_fit_unknown *own = &fit->unknowns[u];
    const bool found = s->end != WHIRL_FIT_NO_MOTION;
    out[FIT_PARAMETER] = (double)own->index;
    out[FIT_START] = s->start[u];
    out[FIT_VALUE] = found ? s->value[u] : NAN;
    out[FIT_ERROR] = found ? s->error[u] : NAN;
    out[FIT_HALF] = found ? s->half[u] : NAN;
    out[FIT_LOW] = isfinite(own->low) ? own->low : NAN;
    out[FIT_HIGH] = isfinite(own->high) ? own->high : NAN;
    out[FIT_KNOWN] = found ? (double)s->known[u] : NAN;
}

static whirl_status fit_compute(const whirl_resting *point, const whirl_record_options *options,
                                const block_view *view) {
    // Fill in the outcome; a fit whose motions were lost has no numbers.
    const whirl_fit *fit = point->fit;
    const whirl_fit_solution *s = point->solution;
    const bool found = s->end != WHIRL_FIT_NO_MOTION;
    const double outcome[] = {(double)s->end,
                              found ? NAN : (double)s->lost,
                              (double)s->steps,
                              found ? s->sum : NAN,
                              found ? s->deviation : NAN,
                              found ? (double)s->degrees : NAN,
                              found ? (double)s->rank : NAN,
                              found && isfinite(s->condition) ? s->condition : NAN};
    memcpy(view_numbers(view, OUTCOME, 0), outcome, sizeof outcome);
    // Fill in unknowns and correlations.
    for (size_t u = 0; u < fit->unknown_count; u++) {
        fit_fill_unknown(fit, s, u, view_numbers(view, UNKNOWN, 0) + FIT_UNKNOWN_COLUMNS * u);
        for (size_t k = 0; k < 2 && found && options->fit.profile; k++)
            view_numbers(view, PROFILE, 0)[2 * u + k] = s->profile[u][k];
        for (size_t k = 0; k < fit->unknown_count && found; k++)
            view_numbers(view, CORRELATION, 0)[WHIRL_MAX_UNKNOWNS * u + k] = s->correlation[u][k];
    }
    // Fill in the motions, and the measured numbers next to those of the model.
    for (size_t i = 0; i < fit->motion_count; i++) {
        double *out = view_numbers(view, MOTION, 0) + FIT_MOTION_COLUMNS * i;
        out[FIT_SPEED] = s->speeds[i];
        out[FIT_MULTIPLIER] = s->largest[i];
        out[FIT_SCATTER] = s->scatter[i];
        out[FIT_TIME] = s->times[i];
    }
    for (size_t i = 0; i < fit->number_count; i++) {
        const whirl_fit_number *own = &fit->numbers[i];
        const double row[] = {(double)own->set, (double)own->motion,       (double)own->station,
                              own->angle,       (double)own->quantity,     own->at,
                              own->value,       found ? s->model[i] : NAN, options->fit.noise > 0.0 ? own->noise : NAN};
        memcpy(view_numbers(view, NUMBER, 0) + FIT_NUMBER_COLUMNS * i, row, sizeof row);
    }
    return whirl_ok();
}

const analysis_plan fit_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute_resting = fit_compute};
