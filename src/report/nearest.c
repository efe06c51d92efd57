// Finds the parameter value nearest to a value that a user writes: one rule for the command, Python and Octave.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/handles.h"
#include "whirl/internal/shown.h"

/// Accepted relative distance if all values are equal, so that there is no step.
static const double share_of_a_lone_value = 0.01;

/// Returns the largest (sign 1) or smallest (-1) of the values [count], or NaN without values; *step: the accepted
/// distance beyond it, which is the step to the nearest other value.
static double nearest_end(const double *values, size_t count, double sign, double *step) {
    double end = NAN;
    *step = INFINITY;
    for (size_t i = 0; i < count; i++)
        if (isfinite(values[i]) && !(sign * values[i] <= sign * end)) end = values[i];
    for (size_t i = 0; i < count; i++)
        if (isfinite(values[i]) && values[i] != end) *step = fmin(*step, fabs(end - values[i]));
    if (!isfinite(*step)) *step = share_of_a_lone_value * fabs(end);
    return end;
}

whirl_status whirl_nearest_value(const whirl_result *result, const char *parameter, const double *values, size_t count,
                                 const char *text, size_t *index) {
    // Read the value with its unit.
    const char *const unit = whirl_result_parameter_unit(result, parameter);
    char name[WHIRL_NAME_SIZE], without_unit[160] = "";
    double value, below, above;
    whirl_status status = whirl_quantity_value(text, unit, &value);
    if (status.code != WHIRL_OK) return status;
    // Refuse a value beyond both ends by more than rounding.
    const double low = nearest_end(values, count, -1.0, &below), high = nearest_end(values, count, 1.0, &above);
    if (isnan(low)) return whirl_fail(WHIRL_BAD_INPUT, "no point has a value of %.63s", parameter);
    const double size = whirl_result_shown_unit(result, parameter, name, sizeof name), rounding = 1.0 + 1e-9;
    if (value < low - rounding * below || value > high + rounding * above) {
        if (size != 1.0 && !text[strcspn(text, "abcdfghijklmnopqrstuvwxyz")])
            snprintf(without_unit, sizeof without_unit, " (a number without a unit is in %.63s)", unit);
        if (low == high)
            return whirl_fail(WHIRL_BAD_INPUT, "%.63s is '%.60s', expected %.6g%s%.63s%s", parameter, text, low / size,
                              *name ? " " : "", name, without_unit);
        return whirl_fail(WHIRL_BAD_INPUT, "%.63s is '%.60s', expected %.6g to %.6g%s%.63s%s", parameter, text,
                          low / size, high / size, *name ? " " : "", name, without_unit);
    }
    // Find the nearest point.
    double best = INFINITY;
    for (size_t i = 0; i < count; i++)
        if (fabs(values[i] - value) < best) best = fabs(values[i] - value), *index = i;
    return status;
}
