#include "varied.h"

#include <stdio.h>
#include <string.h>

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

whirl_status varied_orbit(const whirl_study *study, const whirl_batch *batch, double value, size_t count,
                          const varied_parameter *parameters, const whirl_orbit *orbit,
                          const whirl_orbit_options *options, size_t instants, double *lengths,
                          whirl_orbit_sensitivity **out) {
    whirl_sensitivity *by[WHIRL_MAX_SENSITIVITIES + 1] = {NULL};
    whirl_extended *extended = NULL;
    whirl_status status = whirl_ok();
    for (size_t p = 0; p < count && status.code == WHIRL_OK; p++) {
        varied_given given;
        const whirl_batch along = varied_along(batch, parameters[p].name, value, given);
        status = whirl_sensitivity_new(study, &along, parameters[p].value, parameters[p].reach, &by[p]);
        if (status.code == WHIRL_OK && lengths) lengths[1 + p] = whirl_sensitivity_length(by[p], &lengths[0]);
    }
    if (status.code == WHIRL_OK) status = whirl_extended_new(count, by, &extended);
    if (status.code == WHIRL_OK) status = whirl_orbit_sensitivity_new(extended, orbit, options, instants, out);
    whirl_extended_free(extended);
    for (size_t p = 0; p < count; p++) whirl_sensitivity_free(by[p]);
    return status;
}
