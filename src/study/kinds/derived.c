// Derivatives of a point's numbers by parameters of the case: at rest by extrapolated differences of machines, of
// motions by the derivative of their periodic orbit.
#include "derived.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "derived_fields.h"
#include "five_points.h"
#include "orbit_options.h"
#include "resting_point.h"
#include "richardson.h"
#include "two_pi.h"
#include "varied.h"

/// A point, the numbers that are differentiated there, and the place of their derivatives.
typedef struct derived {
    const whirl_study *study;
    const whirl_batch *batch;
    const whirl_derivatives *by;
    const whirl_layout *layout;
    double value;                               ///< value of the batch's parameter
    size_t count;                               ///< number of numbers
    whirl_spread_at numbers[WHIRL_MAX_DERIVED]; ///< places of the numbers in blocks
    double *parameters, *found, *slopes;        ///< the fields in the block
    /// [parameters] Least first distances from the values, above 0 for parameters that are 0; or NULL.
    const double *reaches;
} derived;

/// Begins the derivatives of a point, all missing; false if the layout has no fields for them.
static bool derived_begin(derived *d, const whirl_study *study, const whirl_batch *batch, double value,
                          const whirl_system *system, const whirl_layout *layout, double *block) {
    const whirl_field *parameters = whirl_layout_field(layout, WHIRL_FIELD_SENSITIVITY_PARAMETERS);
    const whirl_field *numbers = whirl_layout_field(layout, WHIRL_FIELD_SENSITIVITY_NUMBERS);
    const whirl_field *slopes = whirl_layout_field(layout, WHIRL_FIELD_SENSITIVITY_SLOPES);
    if (!batch->derivatives || !parameters || !numbers || !slopes) return false;
    *d = (derived){.study = study,
                   .batch = batch,
                   .by = batch->derivatives,
                   .layout = layout,
                   .value = value,
                   .parameters = block + parameters->offset,
                   .found = block + numbers->offset,
                   .slopes = block + slopes->offset};
    d->count = derived_list(d->by, system, layout, d->numbers);
    for (size_t i = 0; i < d->count; i++) d->found[i] = NAN;
    for (size_t i = 0; i < 2 * d->count * d->by->parameter_count; i++) d->slopes[i] = NAN;
    // A parameter has the value of the case, of the condition, or one that the batch varies.
    for (size_t p = 0; p < d->by->parameter_count; p++) {
        const char *name = d->by->parameters[p].name;
        d->parameters[p] = d->by->parameters[p].value;
        for (size_t i = 0; i < batch->given_count; i++)
            if (strcmp(batch->given[i].name, name) == 0) d->parameters[p] = batch->given[i].value;
        if (strcmp(batch->parameter, name) == 0) d->parameters[p] = value;
        if (strcmp(batch->second, name) == 0) d->parameters[p] = batch->second_value;
        if (strcmp(batch->third, name) == 0) d->parameters[p] = batch->third_value;
    }
    return true;
}

/// Notes a derivative. Notes 0 in place of rounding: if a change of the parameter by its whole value would change the
/// number by less than 1e-9 of the number.
static void derived_note(derived *d, size_t number, size_t parameter, double slope, double error) {
    const double noise =
        d->parameters[parameter] == 0.0 ? 0.0 : 1e-9 * fabs(d->found[number] / d->parameters[parameter]);
    double *row = d->slopes + 2 * (number * d->by->parameter_count + parameter);
    row[0] = fabs(slope) <= noise ? 0.0 : slope;
    row[1] = fabs(slope) <= noise && error > 0.0 ? fmax(error, noise) : error;
}

/// Index that stands for the batch's own parameter.
enum { ALONG = WHIRL_MAX_SENSITIVITIES };

/// Returns the name of a parameter.
static const char *derived_name(const derived *d, size_t parameter) {
    return parameter == ALONG ? d->batch->parameter : d->by->parameters[parameter].name;
}

/// Returns the value of a parameter at the point.
static double derived_value(const derived *d, size_t parameter) {
    return parameter == ALONG ? d->value : d->parameters[parameter];
}

/// Returns the first distance from the value of a parameter: a part of it, or a given one if that is larger.
static double derived_reach(const derived *d, size_t parameter, double part) {
    const double own = part * fabs(derived_value(d, parameter));
    return d->reaches && parameter != ALONG ? fmax(own, d->reaches[parameter]) : own;
}

/// Returns true for a failure of one machine, which leaves its derivative missing.
static bool derived_is_missing(const whirl_status *status) {
    return status->code == WHIRL_BAD_INPUT || status->code == WHIRL_NUMERICAL_FAILURE;
}

/// Computes numbers [count] at a distance h from the value of a parameter. A failure of one machine
/// (derived_is_missing) leaves the derivative missing.
typedef whirl_status derived_fn(const void *of, double h, double *numbers);

/// A series of differences of numbers, by distances that begin at `reach`.
typedef struct derived_series {
    double reach;
    double enough; ///< error of a slope, divided by the slope, below which the series ends
    double good;   ///< error of a slope, divided by the slope, above which a second series begins at a smaller distance
} derived_series;

/// Returns the series for numbers that are smooth to rounding.
static derived_series series_from(double reach) {
    return (derived_series){reach, 1e-10, 1e-8};
}

/// Derives numbers [count] by levels of distances from `reach` on, until all errors are below `enough` of the slope; a
/// slope is replaced if the new error is smaller.
static whirl_status derived_levels(double reach, double enough, size_t count, derived_fn *compute, const void *of,
                                   double *slopes, double *errors) {
    double lines[WHIRL_MAX_DERIVED][RICHARDSON_LEVELS] = {{0.0}}, above[WHIRL_MAX_DERIVED], below[WHIRL_MAX_DERIVED];
    double slope[WHIRL_MAX_DERIVED] = {0.0}, error[WHIRL_MAX_DERIVED] = {0.0};
    bool known = false;
    for (size_t k = 0; k < RICHARDSON_LEVELS && !known; k++) {
        const double step = richardson_step(reach, k);
        whirl_status status = compute(of, step, above);
        if (status.code == WHIRL_OK) status = compute(of, 0.0 - step, below);
        if (status.code != WHIRL_OK) return status;
        known = k > 1;
        for (size_t i = 0; i < count; i++) {
            const bool rounded = richardson_add(above[i], below[i], step, k, lines[i], &slope[i], &error[i]);
            known = known && (rounded || error[i] <= enough * fabs(slope[i]) || isnan(slope[i]) || errors[i] == 0.0);
        }
    }
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(error[i]) || error[i] >= errors[i]) continue;
        slopes[i] = slope[i];
        errors[i] = error[i];
    }
    return whirl_ok();
}

/// Derives numbers [count] at h = 0: slopes and their errors, NaN if they cannot be found. The first distance is that
/// of the series, or a smaller one if machines there are impossible or have no place of rest. If the error of some
/// slope is not good, a second series begins at a sixteenth of this distance. This helps near a double mode, for
/// example: a number that is not smooth over the first distance is smooth over the second one.
static whirl_status derived_extrapolate(derived_series series, size_t count, derived_fn *compute, const void *of,
                                        double *slopes, double *errors) {
    enum { NEARER = 7 };
    for (size_t i = 0; i < count; i++) {
        slopes[i] = NAN;
        errors[i] = INFINITY;
    }
    double reach = series.reach;
    for (int tries = 0; tries < NEARER; tries++, reach *= 0.25) {
        whirl_status status = derived_levels(reach, series.enough, count, compute, of, slopes, errors);
        if (derived_is_missing(&status)) continue;
        bool good = true;
        for (size_t i = 0; i < count; i++) good = good && !(errors[i] > series.good * fabs(slopes[i]));
        if (status.code == WHIRL_OK && !good && tries + 1 < NEARER)
            status = derived_levels(0.0625 * reach, series.enough, count, compute, of, slopes, errors);
        if (status.code != WHIRL_OK && !derived_is_missing(&status)) return status;
        break;
    }
    for (size_t i = 0; i < count; i++)
        if (isinf(errors[i])) errors[i] = NAN;
    return whirl_ok();
}

/// A value v at which g(v, p) = 0, and the function that computes g at other values of v or of a parameter p.
typedef struct derived_implicit {
    derived_fn *compute; ///< computes g [1]
    void *of;
    size_t *parameter; ///< index of the parameter in `of`, which changes
    double by, off;    ///< g_v and its error
} derived_implicit;

/// Derives g by one parameter.
static whirl_status implicit_by(const derived_implicit *g, size_t parameter, double reach, double *by, double *off) {
    *g->parameter = parameter;
    return derived_extrapolate(series_from(reach), 1, g->compute, g->of, by, off);
}

/// Derives v by one parameter: -g_p/g_v.
static whirl_status implicit_slope(const derived_implicit *g, size_t parameter, double reach, double *slope,
                                   double *error) {
    double by = NAN, off = NAN;
    const whirl_status status = implicit_by(g, parameter, reach, &by, &off);
    *slope = 0.0 - by / g->by;
    *error = (off + fabs(*slope) * g->off) / fabs(g->by);
    return status;
}

// ---------------------------------------------------------------- machines at rest

/// A machine at rest whose numbers are differentiated by one parameter.
typedef struct derived_rest {
    derived *of;
    const resting_machine *own; ///< the machine at the parameter's value, whose modes are followed
    size_t parameter;           ///< index of that parameter; ALONG: the batch's own
    double *block;              ///< [layout->size] workspace
} derived_rest;

/// Another machine, with its batch.
typedef struct derived_other {
    whirl_batch batch;
    varied_given given;
    resting_machine machine;
} derived_other;

/// Makes the machine at the distance h from the value of the parameter, and follows the modes to it.
static whirl_status derived_machine(const derived_rest *r, double h, derived_other *out) {
    const derived *d = r->of;
    double value = r->own->value;
    const double at = r->parameter == ALONG ? value : d->parameters[r->parameter];
    out->batch = varied_batch(d->batch, derived_name(d, r->parameter), at + h, out->given, &value);
    out->machine = (resting_machine){.value = value};
    if (!r->own->modes) return d->study->machine(d->study->family, &out->batch, value, &out->machine.machine);
    const whirl_status status = resting_new(d->study, &out->batch, value, &out->machine);
    return status.code == WHIRL_OK ? resting_follow(r->own, &out->machine) : status;
}

/// Returns the row of a mode's number in another machine's block; SIZE_MAX if the mode is lost.
static size_t derived_row(const whirl_spread_at *at, const resting_machine *to) {
    static const char *const of_modes[] = {WHIRL_FIELD_MODES_FREQUENCY,  WHIRL_FIELD_MODES_NATURAL,
                                           WHIRL_FIELD_MODES_GROWTH,     WHIRL_FIELD_MODES_DAMPING_RATIO,
                                           WHIRL_FIELD_MODES_DECREMENT,  WHIRL_FIELD_MODES_TORSION,
                                           WHIRL_FIELD_MODES_AXIAL_SHARE};
    bool follows = false;
    for (size_t i = 0; i < sizeof of_modes / sizeof *of_modes; i++)
        follows = follows || strcmp(at->field->name, of_modes[i]) == 0;
    if (!follows || !to->before) return at->index;
    for (size_t i = 0; i < to->modes->count; i++)
        if (to->before[i] == at->index + 1) return i < at->field->rows ? i : SIZE_MAX;
    return SIZE_MAX;
}

/// Reads the numbers of a block, in SI.
static void derived_read(const derived *d, const resting_machine *of, const double *block, double *numbers) {
    for (size_t i = 0; i < d->count; i++) {
        const whirl_spread_at *at = &d->numbers[i];
        const whirl_field *field = at->field;
        const size_t index = derived_row(at, of);
        const bool is_length = strcmp(whirl_column_unit(field, at->index % field->columns), "length") == 0;
        numbers[i] = index == SIZE_MAX ? (double)NAN
                                       : block[field->offset + at->which * field->rows * field->columns + index] *
                                             (is_length ? of->machine.length : 1.0);
    }
}

static whirl_status derived_rest_numbers(const void *of, double h, double *numbers) {
    const derived_rest *r = of;
    const derived *d = r->of;
    derived_other other;
    whirl_status status = derived_machine(r, h, &other);
    if (status.code == WHIRL_OK) {
        const resting_place at = {d->study, &other.batch, other.machine.value};
        whirl_resting point = resting_point_of(&at, &other.machine.machine);
        point.modes = other.machine.modes;
        point.before = other.machine.before;
        status = whirl_analyze_resting(&point, &d->batch->record, d->batch->analyses, d->layout, r->block);
    }
    if (status.code == WHIRL_OK) derived_read(d, &other.machine, r->block, numbers);
    resting_free(&other.machine);
    return status;
}

// ---------------------------------------------------------------- located critical speeds and thresholds

/// A critical speed or threshold: the zero of the frequency of a mode less the speed, or of its growth.
typedef struct derived_zero {
    derived_rest rest; ///< `own` is the machine at the critical value
    size_t mode;       ///< the mode there
    bool growth;
} derived_zero;

static double zero_of(const derived_zero *z, const resting_machine *at, size_t mode) {
    const whirl_mode *own = &at->modes->modes[mode];
    return at->machine.clock * (z->growth ? own->real : own->imaginary) - (z->growth ? 0.0 : fabs(at->machine.speed));
}

static whirl_status derived_zero_number(const void *of, double h, double *number) {
    const derived_zero *z = of;
    derived_other other;
    const whirl_status status = derived_machine(&z->rest, h, &other);
    const resting_machine *own = &other.machine;
    *number = NAN;
    for (size_t i = 0; status.code == WHIRL_OK && own->before && i < own->modes->count; i++)
        if (own->before[i] == z->mode + 1) *number = zero_of(z, own, i);
    resting_free(&other.machine);
    return status;
}

/// Derives the value of a critical speed or threshold, a row of the field modes/critical, by all parameters, and notes
/// it.
static whirl_status derived_critical(derived *d, size_t number, const double *row) {
    // Make the machine there, and find the mode whose function is 0.
    resting_machine own;
    whirl_status status = resting_new(d->study, d->batch, row[1], &own);
    if (status.code != WHIRL_OK) return derived_is_missing(&status) ? whirl_ok() : status;
    derived_zero z = {.rest = {.of = d, .own = &own}, .growth = row[0] == WHIRL_ONSET || row[0] == WHIRL_RECOVERY};
    for (size_t i = 1; i < own.modes->count; i++)
        if (fabs(zero_of(&z, &own, i)) < fabs(zero_of(&z, &own, z.mode))) z.mode = i;
    if (own.modes->count > 0 && own.modes->period == 0.0) {
        derived_implicit g = {.compute = derived_zero_number, .of = &z, .parameter = &z.rest.parameter};
        status = implicit_by(&g, ALONG, 0.125 * fabs(row[1]), &g.by, &g.off);
        for (size_t p = 0; p < d->by->parameter_count && status.code == WHIRL_OK; p++) {
            double slope, error;
            status = implicit_slope(&g, p, derived_reach(d, p, 0.125), &slope, &error);
            if (status.code == WHIRL_OK) derived_note(d, number, p, slope, error);
        }
    }
    resting_free(&own);
    return status;
}

static bool derived_is_critical(const whirl_spread_at *at) {
    return strcmp(at->field->name, WHIRL_FIELD_MODES_CRITICAL) == 0 && at->index % at->field->columns == 1;
}

/// Returns the series of a parameter. Numbers of run-ups contain the errors of their steps, which limit the accuracy of
/// slopes. They also vary more with a parameter than numbers of machines at rest.
static derived_series rest_series(const derived *d, size_t parameter) {
    const double size = fabs(d->parameters[parameter]);
    const bool runs = whirl_analysis_has(d->batch->analyses, "runup");
    return runs ? (derived_series){size / 64.0, 1e-6, 1e-3} : series_from(0.125 * size);
}

whirl_status derived_at_rest(const whirl_study *study, const whirl_batch *batch, const resting_machine *own,
                             const whirl_layout *layout, double *block) {
    derived d;
    if (!derived_begin(&d, study, batch, own->value, own->machine.system, layout, block)) return whirl_ok();
    derived_rest r = {.of = &d, .own = own, .block = calloc(layout->size + 1, sizeof *r.block)};
    if (!r.block) return whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of a point");
    whirl_status status = whirl_ok();
    // The numbers themselves are in the block.
    const resting_machine here = {.machine = own->machine};
    derived_read(&d, &here, block, d.found);
    for (size_t p = 0; p < d.by->parameter_count && status.code == WHIRL_OK; p++) {
        double slopes[WHIRL_MAX_DERIVED], errors[WHIRL_MAX_DERIVED];
        r.parameter = p;
        status = derived_extrapolate(rest_series(&d, p), d.count, derived_rest_numbers, &r, slopes, errors);
        for (size_t i = 0; i < d.count && status.code == WHIRL_OK; i++)
            if (isfinite(d.found[i]) && !derived_is_critical(&d.numbers[i]))
                derived_note(&d, i, p, slopes[i], errors[i]);
    }
    for (size_t i = 0; i < d.count && status.code == WHIRL_OK; i++) {
        const whirl_spread_at *at = &d.numbers[i];
        if (isfinite(d.found[i]) && derived_is_critical(at))
            status = derived_critical(&d, i, block + at->field->offset + at->index - 1);
    }
    free(r.block);
    return status;
}

// ---------------------------------------------------------------- periodic motions

/// A periodic motion whose numbers are differentiated.
typedef struct derived_motion {
    derived *of;
    whirl_orbit_options options;
    whirl_orbit *orbit;
    whirl_orbit_sensitivity *slopes;
    double lengths[1 + WHIRL_MAX_SENSITIVITIES]; ///< metres of a unit of displacement, and their derivatives
} derived_motion;

/// A station's path over the orbit's instants, in metres, and its derivatives: x, y [all][1 + parameters].
typedef struct derived_path {
    size_t all, width;
    double *x, *y;
} derived_path;

/// Makes the path, of a twist in rad; `x` is NULL without memory.
static void path_make(const derived_motion *m, const whirl_probe *probe, bool twist, derived_path *path) {
    const whirl_orbit_sensitivity *s = m->slopes;
    const double length = twist ? 1.0 : m->lengths[0];
    *path = (derived_path){.all = s->revolutions * s->instants, .width = 1 + s->count};
    path->x = calloc(2 * path->all * path->width + 1, sizeof *path->x);
    if (!path->x) return;
    path->y = path->x + path->all * path->width;
    for (size_t k = 0; k < path->all; k++)
        for (size_t c = 0; c < 2; c++) {
            double *to = (c == 0 ? path->x : path->y) + k * path->width;
            const double value = whirl_probe_value(probe, s->states + k * s->dimension, c);
            to[0] = length * value;
            for (size_t p = 0; p < s->count; p++)
                to[1 + p] = length * whirl_probe_value(probe, s->slopes + (k * s->count + p) * s->dimension, c) +
                            m->lengths[1 + p] * (twist ? value / m->lengths[0] : value);
        }
}

/// Computes the mean over the orbit of one coordinate and its derivatives, out [width].
static void path_mean(const derived_path *path, const double *of, double *out) {
    for (size_t i = 0; i < path->width; i++) {
        out[i] = 0.0;
        for (size_t k = 0; k < path->all; k++) out[i] += of[k * path->width + i] / (double)path->all;
    }
}

/// Computes the largest (sign 1) or smallest (-1) radius of the path between instants, and the derivatives of the
/// radius at that place: out [width].
static void path_extreme(const derived_path *path, double sign, double *out) {
    // Find the instant nearest to the extreme.
    const size_t all = path->all, width = path->width;
    size_t at = 0;
    if (all == 0) return;
    double best = -INFINITY, f[FIVE];
    for (size_t k = 0; k < all; k++) {
        const double radius = sign * hypot(path->x[k * width], path->y[k * width]);
        if (radius > best) at = k;
        best = fmax(best, radius);
    }
    // Find the extreme of the square of the radius near it, by Newton's method.
    size_t near[5];
    for (size_t i = 0; i < 5; i++) near[i] = (at + all + i - 2) % all;
    for (size_t i = 0; i < 5; i++) {
        const double x = path->x[near[i] * width], y = path->y[near[i] * width];
        f[i] = x * x + y * y;
    }
    const double t = five_points_extreme(f, sign), square = five_points(f, t, NULL, NULL);
    out[0] = sqrt(fmax(square, 0.0));
    for (size_t p = 1; p < width; p++) {
        for (size_t i = 0; i < 5; i++) {
            const double *x = path->x + near[i] * width, *y = path->y + near[i] * width;
            f[i] = 2.0 * (x[0] * x[p] + y[0] * y[p]);
        }
        out[p] = five_points(f, t, NULL, NULL) / (2.0 * out[0]);
    }
}

/// Computes the largest (sign 1) or least (-1) x of the path between instants, and its derivatives, out [width].
static void path_end(const derived_path *path, double sign, double *out) {
    const size_t all = path->all, width = path->width;
    size_t at = 0, near[5];
    double f[FIVE];
    if (all == 0) return;
    for (size_t k = 1; k < all; k++)
        if (sign * path->x[k * width] > sign * path->x[at * width]) at = k;
    for (size_t i = 0; i < 5; i++) near[i] = (at + all + i - 2) % all;
    for (size_t i = 0; i < 5; i++) f[i] = path->x[near[i] * width];
    const double t = five_points_extreme(f, sign);
    for (size_t p = 0; p < width; p++) {
        for (size_t i = 0; i < 5; i++) f[i] = path->x[near[i] * width + p];
        out[p] = five_points(f, t, NULL, NULL);
    }
}

/// Computes the synchronous part of the path along x, along y, forward or backward: its amplitude or, if `lags`, its
/// lag in degrees, with derivatives, out [width].
static void path_synchronous(const derived_path *path, size_t instants, size_t part, bool lags, double *out) {
    double real = 0.0, imaginary = 0.0;
    for (size_t p = 0; p < path->width; p++) {
        // Compute the sums of z exp(-i tau) for x, y, and (x + iy)/2, (x - iy)/2.
        double xr = 0.0, xi = 0.0, yr = 0.0, yi = 0.0;
        for (size_t k = 0; k < path->all; k++) {
            const double tau = two_pi * (double)(k % instants) / (double)instants, weight = 2.0 / (double)path->all;
            const double x = weight * path->x[k * path->width + p], y = weight * path->y[k * path->width + p];
            xr += x * cos(tau);
            xi -= x * sin(tau);
            yr += y * cos(tau);
            yi -= y * sin(tau);
        }
        const double sign = part == 2 ? 1.0 : -1.0;
        const double r = part == 0 ? xr : part == 1 ? yr : 0.5 * (xr - sign * yi);
        const double i = part == 0 ? xi : part == 1 ? yi : 0.5 * (xi + sign * yr);
        if (p == 0) {
            real = r;
            imaginary = i;
            out[0] = lags ? fmod(360.0 - 360.0 / two_pi * atan2(i, r), 360.0) : hypot(r, i);
        } else if (lags) {
            out[p] = 360.0 / two_pi * (imaginary * r - real * i) / (real * real + imaginary * imaginary);
        } else {
            out[p] = (real * r + imaginary * i) / hypot(real, imaginary);
        }
    }
}

/// Fields of numbers of motions besides x and y.
static const struct {
    const char *motion, *amplitude, *lag;
    bool twists;
} derived_extras[] = {
    {WHIRL_FIELD_ORBIT_AXIAL, WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS, WHIRL_FIELD_SPECTRUM_AXIAL_LAG, false},
    {WHIRL_FIELD_ORBIT_TWIST, WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS, WHIRL_FIELD_SPECTRUM_TWIST_LAG, true}};

/// Returns the probe of a number: that of a station, or of its axial displacement or twist; NULL if it does not move
/// so. *kind: index of the latter's fields, or their number.
static const whirl_probe *motion_probe(const whirl_system *system, const whirl_spread_at *at, size_t *kind) {
    enum { KINDS = sizeof derived_extras / sizeof *derived_extras };
    const char *name = at->field->name;
    for (*kind = 0; *kind < KINDS; ++*kind)
        if (strcmp(name, derived_extras[*kind].motion) == 0 || strcmp(name, derived_extras[*kind].amplitude) == 0 ||
            strcmp(name, derived_extras[*kind].lag) == 0)
            break;
    if (*kind == KINDS) return &system->probes[at->which];
    for (size_t i = 0; i < system->extra_count; i++)
        if (system->extras[i].station == at->which && system->extras[i].twists == derived_extras[*kind].twists)
            return &system->probes[system->probe_count + i];
    return NULL;
}

/// Computes a number of a station, and its derivatives, out [1 + parameters].
static whirl_status motion_number(const derived_motion *m, const whirl_system *system, const whirl_spread_at *at,
                                  double *out) {
    enum { KINDS = sizeof derived_extras / sizeof *derived_extras, LEAST = 1, LARGEST = 2 };
    derived_path path;
    size_t kind;
    const whirl_probe *probe = motion_probe(system, at, &kind);
    for (size_t i = 0; !probe && i < 1 + m->slopes->count; i++) out[i] = (double)NAN;
    if (!probe) return whirl_ok();
    path_make(m, probe, kind < KINDS && derived_extras[kind].twists, &path);
    if (!path.x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of a motion");
    const char *name = at->field->name;
    if (kind < KINDS && strcmp(name, derived_extras[kind].motion) == 0 && at->index >= LEAST)
        path_end(&path, at->index == LARGEST ? 1.0 : -1.0, out);
    else if (kind < KINDS && strcmp(name, derived_extras[kind].motion) == 0)
        path_mean(&path, path.x, out);
    else if (kind < KINDS)
        path_synchronous(&path, m->slopes->instants, 0, strcmp(name, derived_extras[kind].lag) == 0, out);
    else if (strcmp(name, WHIRL_FIELD_ORBIT_MEAN) == 0)
        path_mean(&path, at->index == 0 ? path.x : path.y, out);
    else if (strcmp(name, WHIRL_FIELD_ORBIT_MAX_RADIUS) == 0 || strcmp(name, WHIRL_FIELD_ORBIT_MIN_RADIUS) == 0)
        path_extreme(&path, strcmp(name, WHIRL_FIELD_ORBIT_MAX_RADIUS) == 0 ? 1.0 : -1.0, out);
    else
        path_synchronous(&path, m->slopes->instants, at->index, strcmp(name, WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG) == 0,
                         out);
    free(path.x);
    return whirl_ok();
}

/// An orbit whose largest multiplier is differenced by one parameter.
typedef struct derived_multiplier {
    const derived_motion *of;
    size_t parameter;
} derived_multiplier;

static whirl_status derived_multiplier_number(const void *of, double h, double *number) {
    const derived_multiplier *m = of;
    const derived *d = m->of->of;
    const whirl_orbit *own = m->of->orbit;
    const size_t n = own->dimension;
    varied_given given;
    double value = d->value;
    const whirl_batch batch =
        varied_batch(d->batch, derived_name(d, m->parameter), d->parameters[m->parameter] + h, given, &value);
    whirl_machine machine = {.system = NULL};
    whirl_orbit *orbit = NULL;
    double *x = calloc(n + 1, sizeof *x);
    whirl_status status = x ? d->study->machine(d->study->family, &batch, value, &machine)
                            : whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of a motion");
    for (size_t i = 0; i < n && status.code == WHIRL_OK; i++)
        x[i] = own->nodes[i] + h * m->of->slopes->slopes[m->parameter * n + i];
    if (status.code == WHIRL_OK)
        status = whirl_orbit_find(machine.system, x, own->revolutions, &m->of->options, &orbit);
    if (status.code == WHIRL_OK) *number = whirl_orbit_largest(orbit);
    whirl_orbit_free(orbit);
    if (machine.release) machine.release(machine.owner);
    free(x);
    return status;
}

/// Lists all parameters and, `along`, the batch's own one after these. Returns their number.
static size_t derived_parameters(const derived *d, bool along, varied_parameter all[WHIRL_MAX_SENSITIVITIES + 1]) {
    const size_t count = d->by->parameter_count;
    for (size_t p = 0; p < count + along; p++) {
        const size_t parameter = p < count ? p : ALONG;
        all[p] = (varied_parameter){derived_name(d, parameter), derived_value(d, parameter), 0.0};
        if (all[p].value == 0.0) all[p].reach = derived_reach(d, parameter, 0.0);
    }
    return count + along;
}

/// Derives the states of an orbit by all parameters and, `along`, by the batch's own one after these. `lengths`, if not
/// NULL, gets the metres of a unit of displacement and their derivatives.
static whirl_status derived_orbit(const derived *d, bool along, const whirl_orbit *orbit,
                                  const whirl_orbit_options *options, size_t instants, double *lengths,
                                  whirl_orbit_sensitivity **out) {
    varied_parameter all[WHIRL_MAX_SENSITIVITIES + 1];
    const size_t count = derived_parameters(d, along, all);
    return varied_orbit(d->study, d->batch, d->value, count, all, orbit, options, instants, lengths, out);
}

/// Finds the orbit of the motion, and differentiates its states by all parameters.
static whirl_status motion_derive(derived_motion *m, const whirl_system *system, const double *end, size_t period) {
    enum { MAX_INSTANTS = 512, MIN_INSTANTS = 128, ROOM = 1 << 25 };
    // Large machines have fewer instants, so that their perturbations fit in memory.
    size_t instants = MAX_INSTANTS;
    const size_t numbers = system->dimension * (system->dimension + m->of->by->parameter_count) * period;
    while (instants > MIN_INSTANTS && numbers * instants > ROOM) instants /= 2;
    const whirl_status status = whirl_orbit_find(system, end, period, &m->options, &m->orbit);
    if (status.code != WHIRL_OK) return status;
    return derived_orbit(m->of, false, m->orbit, &m->options, instants, m->lengths, &m->slopes);
}

/// Fills in all numbers of a motion.
static whirl_status motion_fill(derived_motion *m, const whirl_system *system) {
    derived *d = m->of;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < d->count && status.code == WHIRL_OK; i++) {
        const whirl_spread_at *at = &d->numbers[i];
        if (strcmp(at->field->name, WHIRL_FIELD_FLOQUET_MODULUS) != 0) {
            double numbers[1 + WHIRL_MAX_SENSITIVITIES] = {NAN};
            status = motion_number(m, system, at, numbers);
            if (status.code != WHIRL_OK || !isfinite(numbers[0])) continue;
            d->found[i] = numbers[0];
            for (size_t p = 0; p < d->by->parameter_count; p++) derived_note(d, i, p, numbers[1 + p], 0.0);
            continue;
        }
        d->found[i] = whirl_orbit_largest(m->orbit);
        for (size_t p = 0; p < d->by->parameter_count && status.code == WHIRL_OK; p++) {
            double slope, error;
            const derived_multiplier own = {m, p};
            status = derived_extrapolate(series_from(fabs(d->parameters[p]) / 256.0), 1, derived_multiplier_number,
                                         &own, &slope, &error);
            derived_note(d, i, p, slope, error);
        }
    }
    return status;
}

// ---------------------------------------------------------------- motions that are not periodic

/// Number of pairs of records on both sides of the value of a parameter, and the 97.5 % quantile of Student's
/// distribution for as many pairs less one.
enum { STATISTICS_PAIRS = 4 };
static const double statistics_student = 3.182446;

static bool statistics_go_on(void *batch) {
    return !whirl_stop_is_set(((const whirl_batch *)batch)->stop);
}

/// Records the motion of the machine whose parameter has the value `at`, from `start` on, and reads its numbers; NaN if
/// it does not last. `block` [layout->size] is workspace.
static whirl_status statistics_at(const derived *d, size_t parameter, double at, const double *start, double *block,
                                  double *numbers) {
    varied_given given;
    double value = d->value;
    whirl_batch batch = varied_batch(d->batch, derived_name(d, parameter), at, given, &value);
    const whirl_monitor monitor = {statistics_go_on, &batch};
    resting_machine own = {.value = value};
    whirl_record *record = NULL;
    whirl_status status = d->study->machine(d->study->family, &batch, value, &own.machine);
    if (status.code == WHIRL_OK)
        status = whirl_record_motion(own.machine.system, &batch.integrate, &batch.record, start, &monitor, &record);
    const bool lasts = record && record->motion == WHIRL_BOUNDED;
    if (status.code == WHIRL_OK && lasts)
        status = whirl_analyze(record, &batch.record, batch.analyses, d->layout, block);
    for (size_t i = 0; i < d->count; i++) numbers[i] = NAN;
    if (status.code == WHIRL_OK && lasts) derived_read(d, &own, block, numbers);
    whirl_record_free(record);
    if (own.machine.release) own.machine.release(own.machine.owner);
    return status;
}

/// Derives all numbers by a parameter: the slopes of the lines through 0 that fit best to the halves of the differences
/// of pairs of records, over their distances from the value.
static whirl_status statistics_derive(derived *d, size_t parameter, const double *start, double *block) {
    double halves[STATISTICS_PAIRS][WHIRL_MAX_DERIVED], above[WHIRL_MAX_DERIVED], below[WHIRL_MAX_DERIVED];
    const double value = d->parameters[parameter], first = d->by->difference * fabs(value) / STATISTICS_PAIRS;
    double squares = 0.0;
    for (size_t k = 0; k < STATISTICS_PAIRS; k++) {
        const double h = first * (double)(k + 1);
        whirl_status status = statistics_at(d, parameter, value + h, start, block, above);
        if (status.code == WHIRL_OK) status = statistics_at(d, parameter, value - h, start, block, below);
        if (status.code != WHIRL_OK) return status;
        for (size_t i = 0; i < d->count; i++) halves[k][i] = 0.5 * (above[i] - below[i]);
        squares += h * h;
    }
    for (size_t i = 0; i < d->count; i++) {
        double product = 0.0, scatter = 0.0;
        for (size_t k = 0; k < STATISTICS_PAIRS; k++) product += first * (double)(k + 1) * halves[k][i];
        const double slope = product / squares;
        for (size_t k = 0; k < STATISTICS_PAIRS; k++) {
            const double off = halves[k][i] - slope * first * (double)(k + 1);
            scatter += off * off;
        }
        const double error = statistics_student * sqrt(scatter / (STATISTICS_PAIRS - 1) / squares);
        if (whirl_spread_period(&d->numbers[i]) == 0.0) derived_note(d, i, parameter, slope, error);
    }
    return whirl_ok();
}

/// Derives the numbers of a motion that is not periodic, which ends at state `end`. Its records begin there.
static whirl_status derived_by_statistics(derived *d, const whirl_machine *machine, const double *end,
                                          const double *block) {
    const resting_machine here = {.machine = *machine};
    double *other = calloc(d->layout->size + 1, sizeof *other);
    if (!other) return whirl_fail(WHIRL_NO_MEMORY, "no memory for derivatives of a motion");
    whirl_status status = whirl_ok();
    derived_read(d, &here, block, d->found);
    for (size_t p = 0; p < d->by->parameter_count && status.code == WHIRL_OK; p++) {
        status = statistics_derive(d, p, end, other);
        if (derived_is_missing(&status)) status = whirl_ok();
    }
    free(other);
    return status;
}

whirl_status derived_of_motion(const whirl_study *study, const whirl_batch *batch, double value,
                               const whirl_machine *machine, const double *end, const whirl_layout *layout,
                               double *block) {
    derived d;
    if (!derived_begin(&d, study, batch, value, machine->system, layout, block)) return whirl_ok();
    const whirl_verdict verdict = whirl_block_verdict(layout, block);
    const bool bounded = verdict.regime == WHIRL_QUASI_PERIODIC || verdict.regime == WHIRL_CHAOTIC;
    if (bounded && d.by->difference > 0.0) return derived_by_statistics(&d, machine, end, block);
    // Other motions have derivatives only if they are periodic.
    if (verdict.regime != WHIRL_PERIODIC || verdict.period < 1) return whirl_ok();
    // A batch with a smaller absolute tolerance than the usual 1e-9 gets orbits that are finer in the same ratio.
    const bool stiff = strcmp(batch->integrate.method, "rodas5p") == 0;
    derived_motion m = {.of = &d, .options = orbit_options_by(batch->integrate.method, stiff ? 1e-10 : 1e-13)};
    if (batch->integrate.atol < 1e-9) m.options.integrate.atol *= batch->integrate.atol / 1e-9;
    whirl_status status = motion_derive(&m, machine->system, end, (size_t)verdict.period);
    if (status.code == WHIRL_OK) status = motion_fill(&m, machine->system);
    whirl_orbit_sensitivity_free(m.slopes);
    whirl_orbit_free(m.orbit);
    return derived_is_missing(&status) ? whirl_ok() : status;
}

// ---------------------------------------------------------------- special points of branches

/// A special point at which a multiplier crosses the unit circle, or an eigenvalue the imaginary axis.
typedef struct derived_crossing {
    derived *of;
    const whirl_branch_point *point;
    const whirl_multiplier *own; ///< this multiplier or eigenvalue
    size_t parameter;            ///< index of the parameter that changes; ALONG: the branch's own
    whirl_orbit_options options;
} derived_crossing;

/// Returns the function that is 0 at the point: how far the multiplier is outside the circle, or the eigenvalue's real
/// part.
static double crossing_measure(const whirl_orbit *orbit, const whirl_multiplier *m) {
    return orbit->period == 0.0 ? m->real : hypot(m->real, m->imaginary) - 1.0;
}

static whirl_status derived_crossing_number(const void *of, double h, double *number) {
    const derived_crossing *c = of;
    const derived *d = c->of;
    const whirl_orbit *own = c->point->orbit;
    varied_given given;
    double value = d->value;
    const whirl_batch batch =
        varied_batch(d->batch, derived_name(d, c->parameter), derived_value(d, c->parameter) + h, given, &value);
    whirl_machine machine = {.system = NULL};
    whirl_orbit *orbit = NULL;
    whirl_status status = d->study->machine(d->study->family, &batch, value, &machine);
    if (status.code == WHIRL_OK)
        status = own->period == 0.0
                     ? whirl_orbit_rest(machine.system, own->nodes, &c->options, &orbit)
                     : whirl_orbit_find(machine.system, own->nodes, own->revolutions, &c->options, &orbit);
    // Take the multiplier nearest to the point's own.
    double nearest = INFINITY;
    for (size_t i = 0; status.code == WHIRL_OK && i < orbit->multiplier_count; i++) {
        const whirl_multiplier *m = &orbit->multipliers[i];
        const double away = hypot(m->real - c->own->real, fabs(m->imaginary) - fabs(c->own->imaginary));
        if (away < nearest) *number = crossing_measure(orbit, m);
        nearest = fmin(nearest, away);
    }
    whirl_orbit_free(orbit);
    if (machine.release) machine.release(machine.owner);
    return status;
}

/// Derives the value of a doubling, Neimark-Sacker or Hopf point by all parameters, and notes it.
static whirl_status derived_by_crossing(derived *d, const whirl_branch_point *point,
                                        const whirl_orbit_options *options) {
    // The multiplier or eigenvalue that crosses is the nearest one.
    const whirl_orbit *orbit = point->orbit;
    derived_crossing c = {.of = d, .point = point, .own = orbit->multipliers, .options = *options};
    for (size_t i = 1; i < orbit->multiplier_count; i++)
        if (fabs(crossing_measure(orbit, &orbit->multipliers[i])) < fabs(crossing_measure(orbit, c.own)))
            c.own = &orbit->multipliers[i];
    derived_implicit g = {.compute = derived_crossing_number, .of = &c, .parameter = &c.parameter};
    whirl_status status = implicit_by(&g, ALONG, fabs(d->value) / 1024.0, &g.by, &g.off);
    for (size_t p = 0; p < d->by->parameter_count && status.code == WHIRL_OK; p++) {
        double slope, error;
        status = implicit_slope(&g, p, derived_reach(d, p, 1.0 / 1024.0), &slope, &error);
        if (status.code == WHIRL_OK) derived_note(d, 0, p, slope, error);
    }
    return status;
}

/// Derives the value of a fold of forced orbits by all parameters, and notes it. Near a fold the derivatives s_p and
/// s_v of the orbit by a parameter and by the branch's own one grow along the same direction, the null vector. The
/// value stays at the fold if s_p + s_v dv/dp stays finite along that direction: dv/dp = -s_p/s_v.
static whirl_status derived_fold(derived *d, const whirl_branch_point *point, const whirl_orbit_options *options) {
    const size_t parameters = d->by->parameter_count, n = point->orbit->dimension;
    whirl_orbit_sensitivity *slopes = NULL;
    const whirl_status status = derived_orbit(d, true, point->orbit, options, 4, NULL, &slopes);
    double square = 0.0;
    const double *along = slopes ? slopes->slopes + parameters * n : NULL;
    for (size_t i = 0; along && i < n; i++) square += along[i] * along[i];
    for (size_t p = 0; along && p < parameters; p++) {
        double product = 0.0;
        for (size_t i = 0; i < n; i++) product += slopes->slopes[p * n + i] * along[i];
        const double slope = 0.0 - product / square;
        // The part across the null vector stays of the size 1, while the part along it grows without limit.
        derived_note(d, 0, p, slope, fabs(slope) / sqrt(square));
    }
    whirl_orbit_sensitivity_free(slopes);
    return status;
}

/// A graze whose value is derived.
typedef struct derived_graze {
    derived *of;
    const whirl_branch_point *point;
    const whirl_orbit_options *options;
} derived_graze;

/// Finds the orbit of the branch at a distance from the graze.
static whirl_status graze_orbit(const derived_graze *g, double distance, whirl_orbit **orbit) {
    const derived *d = g->of;
    whirl_machine machine = {.system = NULL};
    *orbit = NULL;
    whirl_status status = d->study->machine(d->study->family, d->batch, d->value + distance, &machine);
    if (status.code == WHIRL_OK)
        status =
            whirl_orbit_find(machine.system, g->point->orbit->nodes, g->point->orbit->revolutions, g->options, orbit);
    if (machine.release) machine.release(machine.owner);
    return status;
}

/// Derives the value of the graze by all parameters from an orbit at a distance from it, -g_p/g_v where g is the
/// extreme of the switching function: slopes [parameters].
static whirl_status graze_slopes(const derived_graze *g, double distance, double *slopes) {
    derived near = *g->of;
    const size_t count = near.by->parameter_count;
    varied_parameter all[WHIRL_MAX_SENSITIVITIES + 1];
    double by[WHIRL_MAX_SENSITIVITIES + 1];
    whirl_orbit *orbit;
    near.value += distance;
    derived_parameters(&near, true, all);
    whirl_status status = graze_orbit(g, distance, &orbit);
    if (status.code == WHIRL_OK)
        status = varied_extreme(near.study, near.batch, near.value, count + 1, all, orbit, g->options,
                                orbit->touches[g->point->touch].index, by);
    for (size_t p = 0; p < count && status.code == WHIRL_OK; p++) slopes[p] = 0.0 - by[p] / by[count];
    whirl_orbit_free(orbit);
    return status;
}

/// Derives the value of a graze by all parameters, and notes it. The orbit is smooth on the side of the graze where the
/// contact closes less often. The slopes there are extrapolated to the graze.
static whirl_status derived_by_graze(derived *d, const whirl_branch_point *point, const whirl_orbit_options *options) {
    const derived_graze g = {d, point, options};
    const double distance = 1e-6 * fabs(d->value);
    size_t closings[2] = {0, 0};
    whirl_status status = whirl_ok();
    for (size_t side = 0; side < 2 && status.code == WHIRL_OK; side++) {
        whirl_orbit *orbit;
        status = graze_orbit(&g, side == 0 ? distance : 0.0 - distance, &orbit);
        if (status.code == WHIRL_OK) closings[side] = whirl_touch_closings(&orbit->touches[point->touch]);
        whirl_orbit_free(orbit);
    }
    if (status.code != WHIRL_OK || closings[0] == closings[1]) return status;
    const double away = closings[0] < closings[1] ? distance : 0.0 - distance;
    double slopes[2][WHIRL_MAX_SENSITIVITIES];
    for (size_t k = 0; k < 2 && status.code == WHIRL_OK; k++)
        status = graze_slopes(&g, (double)(k + 1) * away, slopes[k]);
    for (size_t p = 0; p < d->by->parameter_count && status.code == WHIRL_OK; p++) {
        const double slope = 2.0 * slopes[0][p] - slopes[1][p];
        derived_note(d, 0, p, slope, 1e-4 * fabs(slopes[0][p] - slopes[1][p]));
    }
    return status;
}

whirl_status derived_of_special(const whirl_study *study, const whirl_batch *batch, const whirl_system *system,
                                const whirl_branch_point *point, const whirl_layout *layout, double *block) {
    derived d;
    if (!derived_begin(&d, study, batch, point->value, system, layout, block)) return whirl_ok();
    const whirl_orbit *orbit = point->orbit;
    const bool forced = orbit->revolutions > 0, crosses = point->special == WHIRL_DOUBLING ||
                                                          point->special == WHIRL_NEIMARK_SACKER ||
                                                          point->special == WHIRL_HOPF;
    if (point->special == WHIRL_REGULAR || d.count != 1) return whirl_ok();
    d.found[0] = point->value;
    const whirl_orbit_options options = whirl_batch_orbits(batch);
    whirl_status status = whirl_ok();
    if (point->special == WHIRL_FOLD && forced) status = derived_fold(&d, point, &options);
    if (point->special == WHIRL_GRAZE && forced) status = derived_by_graze(&d, point, &options);
    if (crosses && orbit->multiplier_count > 0 && (forced || orbit->period == 0.0))
        status = derived_by_crossing(&d, point, &options);
    // The point's value of the branch's own parameter has no derivative by that parameter.
    for (size_t p = 0; p < d.by->parameter_count; p++)
        if (strcmp(d.by->parameters[p].name, batch->parameter) == 0) derived_note(&d, 0, p, NAN, NAN);
    return derived_is_missing(&status) ? whirl_ok() : status;
}

// ---------------------------------------------------------------- single numbers

/// A number that is derived by itself, with the memory that `derived` needs.
typedef struct derived_one {
    derived of;
    whirl_derivatives by;
    whirl_given given[WHIRL_MAX_SENSITIVITIES];
    double parameters[WHIRL_MAX_SENSITIVITIES], reaches[WHIRL_MAX_SENSITIVITIES];
    double found, slopes[2 * WHIRL_MAX_SENSITIVITIES];
} derived_one;

/// Begins the derivatives of a number by parameters.
static void one_begin(derived_one *one, const whirl_study *study, const whirl_batch *batch, double value, size_t count,
                      const varied_parameter *parameters) {
    for (size_t p = 0; p < count; p++) {
        one->given[p] = (whirl_given){parameters[p].name, parameters[p].value};
        one->parameters[p] = parameters[p].value;
        one->reaches[p] = parameters[p].reach;
    }
    one->by = (whirl_derivatives){.parameter_count = count, .parameters = one->given};
    one->of = (derived){.study = study,
                        .batch = batch,
                        .by = &one->by,
                        .value = value,
                        .count = 1,
                        .parameters = one->parameters,
                        .found = &one->found,
                        .slopes = one->slopes,
                        .reaches = one->reaches};
    for (size_t i = 0; i < 2 * count; i++) one->slopes[i] = NAN;
}

whirl_status derived_threshold(const whirl_study *study, const whirl_batch *batch, const whirl_critical *at,
                               size_t count, const varied_parameter *parameters, double *slopes) {
    derived_one one;
    const double row[] = {(double)at->kind, at->value};
    one_begin(&one, study, batch, at->value, count, parameters);
    one.found = at->value;
    const whirl_status status = derived_critical(&one.of, 0, row);
    for (size_t p = 0; p < count; p++) slopes[p] = one.slopes[2 * p];
    return derived_is_missing(&status) ? whirl_ok() : status;
}

/// A mode whose eigenvalue is derived.
typedef struct derived_eigenvalue {
    derived_rest rest;
    size_t mode;
} derived_eigenvalue;

static whirl_status derived_eigenvalue_numbers(const void *of, double h, double *numbers) {
    const derived_eigenvalue *e = of;
    derived_other other;
    const whirl_status status = derived_machine(&e->rest, h, &other);
    const resting_machine *own = &other.machine;
    numbers[0] = numbers[1] = NAN;
    for (size_t i = 0; status.code == WHIRL_OK && own->before && i < own->modes->count; i++) {
        if (own->before[i] != e->mode + 1) continue;
        numbers[0] = own->machine.clock * own->modes->modes[i].real;
        numbers[1] = own->machine.clock * own->modes->modes[i].imaginary;
    }
    resting_free(&other.machine);
    return status;
}

whirl_status derived_mode(const whirl_study *study, const whirl_batch *batch, const resting_machine *own, size_t mode,
                          size_t count, const varied_parameter *parameters, double *slopes) {
    derived_one one;
    one_begin(&one, study, batch, own->value, count, parameters);
    derived_eigenvalue e = {.rest = {.of = &one.of, .own = own}, .mode = mode};
    whirl_status status = whirl_ok();
    for (size_t p = 0; p < count && status.code == WHIRL_OK; p++) {
        double errors[2];
        e.rest.parameter = p;
        status = derived_extrapolate(series_from(derived_reach(&one.of, p, 0.125)), 2, derived_eigenvalue_numbers, &e,
                                     slopes + 2 * p, errors);
    }
    return status;
}

whirl_status derived_special_point(const whirl_study *study, const whirl_batch *batch, const whirl_branch_point *point,
                                   const whirl_orbit_options *options, size_t count, const varied_parameter *parameters,
                                   double *slopes) {
    derived_one one;
    one_begin(&one, study, batch, point->value, count, parameters);
    one.found = point->value;
    const whirl_status status = point->special == WHIRL_FOLD ? derived_fold(&one.of, point, options)
                                                             : derived_by_crossing(&one.of, point, options);
    for (size_t p = 0; p < count; p++) slopes[p] = one.slopes[2 * p];
    return derived_is_missing(&status) ? whirl_ok() : status;
}
