#include "signal_check.h"

#include <math.h>
#include <stdbool.h>

/// Returns true for a valid number: instruments mark missing values by NaN, infinities or huge numbers, whose squares
/// would overflow.
static bool is_number(double value) {
    return fabs(value) <= 1e100;
}

/// Checks the size of a table [many][count]: at least one channel, `fewest` samples, at most WHIRL_SIGNALS_MAX numbers.
static whirl_status check_extent(const char *what, size_t count, size_t many, size_t fewest) {
    if (count < fewest)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu %s, expected at least %zu", count, what, fewest);
    if (many == 0) return whirl_fail(WHIRL_BAD_INPUT, "there is no channel, expected at least 1");
    if (count > WHIRL_SIGNALS_MAX / many)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu times %zu %s, expected at most %d numbers", many, count, what,
                          WHIRL_SIGNALS_MAX);
    return whirl_ok();
}

whirl_status signal_check_channels(const double *values, size_t count, size_t channels, size_t fewest) {
    const whirl_status status = check_extent("samples", count, channels, fewest);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < channels * count; i++) {
        if (is_number(values[i])) continue;
        return whirl_fail(WHIRL_BAD_INPUT, "sample %zu of channel %zu is %g, expected a number: cut signals at gaps",
                          i % count, i / count, values[i]);
    }
    return whirl_ok();
}

whirl_status signal_check_points(const double *points, size_t count, size_t dimension, size_t fewest) {
    const whirl_status status = check_extent("points", count, dimension, fewest);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < count * dimension; i++) {
        if (is_number(points[i])) continue;
        return whirl_fail(WHIRL_BAD_INPUT, "coordinate %zu of point %zu is %g, expected a number", i % dimension,
                          i / dimension, points[i]);
    }
    return whirl_ok();
}

/// Checks that instants are numbers and grow; `what` names one of them.
static whirl_status check_growth(const char *what, const double *instants, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (!is_number(instants[i]))
            return whirl_fail(WHIRL_BAD_INPUT, "the time of %s %zu is %g, expected a number", what, i, instants[i]);
        if (i > 0 && !(instants[i] > instants[i - 1]))
            return whirl_fail(WHIRL_BAD_INPUT, "%s %zu is at %.17g, not after %s %zu at %.17g: time has to grow", what,
                              i, instants[i], what, i - 1, instants[i - 1]);
    }
    return whirl_ok();
}

whirl_status signal_check_time(const double *time, size_t count) {
    const double longest = 10.0; // mean steps; polynomials through samples farther apart are meaningless
    whirl_status status = check_extent("samples", count, 1, 2);
    if (status.code == WHIRL_OK) status = check_growth("sample", time, count);
    if (status.code != WHIRL_OK) return status;
    const double mean = (time[count - 1] - time[0]) / (double)(count - 1);
    for (size_t i = 1; i < count; i++) {
        const double step = time[i] - time[i - 1];
        if (step > longest * mean)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "there is a gap: samples %zu and %zu are %g apart, %.3g times as long as samples usually "
                              "are",
                              i - 1, i, step, step / mean);
    }
    return whirl_ok();
}

whirl_status signal_check_pulses(const double *instants, size_t pulses) {
    const whirl_status status = check_extent("pulses", pulses, 1, 2);
    return status.code == WHIRL_OK ? check_growth("pulse", instants, pulses) : status;
}

whirl_status signal_check_turns(const double *time, size_t count, size_t fewest, const double *instants,
                                size_t pulses) {
    whirl_status status = check_extent("samples", count, 1, fewest);
    if (status.code == WHIRL_OK) status = signal_check_time(time, count);
    if (status.code == WHIRL_OK) status = signal_check_pulses(instants, pulses);
    if (status.code != WHIRL_OK) return status;
    const size_t outside = instants[0] < time[0] ? 0 : pulses - 1;
    if (instants[0] < time[0] || instants[pulses - 1] > time[count - 1])
        return whirl_fail(WHIRL_BAD_INPUT, "pulse %zu is at %.17g, expected a time of the samples, %.17g to %.17g",
                          outside, instants[outside], time[0], time[count - 1]);
    return whirl_ok();
}

whirl_status signal_check_size(double size) {
    if (size > 0.0 && is_number(size)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "the size of the motion is %g, expected a number above 0", size);
}
