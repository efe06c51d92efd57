#include "varied.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "five_points.h"

/// Returns the place of the value of a parameter that the batch itself varies, `*value` for the first one; NULL for
/// other parameters.
static double *varied_axis(whirl_batch *batch, const char *name, double *value) {
    if (strcmp(batch->parameter, name) == 0) return value;
    if (strcmp(batch->second, name) == 0) return &batch->second_value;
    return strcmp(batch->third, name) == 0 ? &batch->third_value : NULL;
}

whirl_batch varied_batch(const whirl_batch *batch, const char *name, double x, varied_given given, double *value) {
    whirl_batch out = *batch;
    double *const own = varied_axis(&out, name, value);
    if (own) {
        *own = x;
        return out;
    }
    out.given_count = 0;
    for (size_t i = 0; i < batch->given_count; i++)
        if (strcmp(batch->given[i].name, name) != 0) given[out.given_count++] = batch->given[i];
    given[out.given_count++] = (whirl_given){name, x};
    out.given = given;
    return out;
}

/// Returns the batch with `name` as its parameter. All machines have the batch's own parameter at `value`.
static whirl_batch varied_along(const whirl_batch *batch, const char *name, double value, varied_given given) {
    double own = value;
    whirl_batch out = *batch;
    double *const axis = varied_axis(&out, name, &own);
    if (axis) {
        // The parameter that the batch varies, and its first one, exchange their places.
        if (axis == &own) return out;
        char *const from = axis == &out.second_value ? out.second : out.third;
        snprintf(from, WHIRL_NAME_SIZE, "%s", batch->parameter);
        snprintf(out.parameter, sizeof out.parameter, "%s", name);
        *axis = value;
        return out;
    }
    out = varied_batch(batch, name, value, given, &own);
    // varied_batch has put `name` last; the batch's own parameter takes its place.
    out.given_count--;
    if (*out.parameter) given[out.given_count++] = (whirl_given){batch->parameter, value};
    snprintf(out.parameter, sizeof out.parameter, "%s", name);
    return out;
}

/// An extended machine, with the sensitivities that it borrows.
typedef struct varied_machine {
    size_t count;
    whirl_sensitivity *by[WHIRL_MAX_SENSITIVITIES + 1];
    whirl_extended *extended;
} varied_machine;

static void varied_machine_free(varied_machine *m) {
    whirl_extended_free(m->extended);
    for (size_t p = 0; p < m->count; p++) whirl_sensitivity_free(m->by[p]);
}

/// Makes the machine of the batch at `value` with the parameters as states; freed in any case.
static whirl_status varied_machine_make(const whirl_study *study, const whirl_batch *batch, double value, size_t count,
                                        const varied_parameter *parameters, varied_machine *out) {
    whirl_status status = whirl_ok();
    *out = (varied_machine){.count = count};
    for (size_t p = 0; p < count && status.code == WHIRL_OK; p++) {
        varied_given given;
        const whirl_batch along = varied_along(batch, parameters[p].name, value, given);
        status = whirl_sensitivity_new(study, &along, parameters[p].value, parameters[p].reach, &out->by[p]);
    }
    return status.code == WHIRL_OK ? whirl_extended_new(count, out->by, &out->extended) : status;
}

whirl_status varied_orbit(const whirl_study *study, const whirl_batch *batch, double value, size_t count,
                          const varied_parameter *parameters, const whirl_orbit *orbit,
                          const whirl_orbit_options *options, size_t instants, double *lengths,
                          whirl_orbit_sensitivity **out) {
    varied_machine m;
    whirl_status status = varied_machine_make(study, batch, value, count, parameters, &m);
    for (size_t p = 0; p < count && lengths && status.code == WHIRL_OK; p++)
        lengths[1 + p] = whirl_sensitivity_length(m.by[p], &lengths[0]);
    if (status.code == WHIRL_OK) status = whirl_orbit_sensitivity_new(m.extended, orbit, options, instants, out);
    varied_machine_free(&m);
    return status;
}

/// Returns the time of an instant of an orbit.
static double varied_time(const whirl_system *system, const whirl_orbit_sensitivity *s, size_t instant) {
    return system->period * (double)(instant % s->instants) / (double)s->instants;
}

/// Derives switching function `index` at an instant of an orbit along the orbit's derivatives: out [count].
static void varied_switch_slopes(const varied_machine *m, const whirl_orbit_sensitivity *s, size_t instant,
                                 size_t index, double *work, double *out) {
    const whirl_system *system = whirl_extended_system(m->extended);
    const size_t own = s->dimension;
    double *x = work, *gradient = work + own + s->count, by_time;
    memset(x, 0, (own + s->count) * sizeof *x);
    memcpy(x, s->states + instant * own, own * sizeof *x);
    system->switch_gradient(system->model, varied_time(system, s, instant), x, index, gradient, &by_time);
    for (size_t p = 0; p < s->count; p++) {
        const double *slope = s->slopes + (instant * s->count + p) * own;
        out[p] = gradient[own + p] / whirl_extended_unit(m->extended, p);
        for (size_t i = 0; i < own; i++) out[p] += gradient[i] * slope[i];
    }
}

/// Finds the extreme of a switching function that is nearest to 0, among instants, and derives it: slopes [count].
static whirl_status varied_extreme_slopes(const varied_machine *m, const whirl_orbit_sensitivity *s, size_t index,
                                          double *slopes) {
    const whirl_system *system = whirl_extended_system(m->extended);
    const size_t all = s->revolutions * s->instants, own = s->dimension, width = own + s->count;
    double *values = calloc(all + 2 * width + system->switch_count + FIVE * s->count, sizeof *values);
    if (!values) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the derivatives of a graze");
    double *work = values + all, *switches = work + 2 * width, *rows = switches + system->switch_count;
    // Evaluate the function at all instants.
    for (size_t k = 0; k < all; k++) {
        memcpy(work, s->states + k * own, own * sizeof *work);
        system->switches(system->model, varied_time(system, s, k), work, switches);
        values[k] = switches[index];
    }
    // Find the instant nearest to the extreme that is nearest to 0.
    size_t at = all;
    for (size_t k = 0; k < all; k++) {
        const double before = values[(k + all - 1) % all], after = values[(k + 1) % all];
        const bool extreme = (values[k] - before) * (after - values[k]) <= 0.0;
        if (extreme && (at == all || fabs(values[k]) < fabs(values[at]))) at = k;
    }
    whirl_status status = whirl_ok();
    if (at == all) status = whirl_fail(WHIRL_NUMERICAL_FAILURE, "the graze has no extreme");
    // Derive the function at five instants, and take the derivatives at the extreme between them.
    double f[FIVE];
    for (size_t i = 0; i < FIVE && at < all; i++) {
        const size_t k = (at + all + i - FIVE / 2) % all;
        f[i] = values[k];
        varied_switch_slopes(m, s, k, index, work, rows + i * s->count);
    }
    const double t = at < all ? five_points_extreme(f, 0.0) : 0.0;
    for (size_t p = 0; p < s->count && at < all; p++) {
        for (size_t i = 0; i < FIVE; i++) f[i] = rows[i * s->count + p];
        slopes[p] = five_points(f, t, NULL, NULL);
    }
    free(values);
    return status;
}

whirl_status varied_extreme(const whirl_study *study, const whirl_batch *batch, double value, size_t count,
                            const varied_parameter *parameters, const whirl_orbit *orbit,
                            const whirl_orbit_options *options, size_t index, double *slopes) {
    enum { INSTANTS = 512 };
    varied_machine m;
    whirl_orbit_sensitivity *s = NULL;
    whirl_status status = varied_machine_make(study, batch, value, count, parameters, &m);
    if (status.code == WHIRL_OK) status = whirl_orbit_sensitivity_new(m.extended, orbit, options, INSTANTS, &s);
    if (status.code == WHIRL_OK) status = varied_extreme_slopes(&m, s, index, slopes);
    whirl_orbit_sensitivity_free(s);
    varied_machine_free(&m);
    return status;
}
