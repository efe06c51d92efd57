// Resamples signals by the angle of the shaft: sections and samples at equal angles between pulses.
// The instant of an angle is a monotone cubic through the pulses (Fritsch and Carlson 1980, SIAM J. Numer. Anal. 17,
// 238); a signal at an instant is a polynomial through the samples around it (Fyfe and Munck 1997, Mech. Syst. Signal
// Process. 11, 187).
#include <math.h>
#include <stdlib.h>

#include "signal_check.h"
#include "two_pi.h"

// ---------------------------------------------------------------- the angle

/// Returns the duration of a revolution at pulse k: the slope of the parabola through it and its neighbours, limited so
/// that the cubics stay monotone.
static double slope_at(const double *instants, size_t pulses, size_t k) {
    if (pulses == 2) return instants[1] - instants[0];
    const size_t middle = k == 0 ? 1 : k == pulses - 1 ? pulses - 2 : k;
    const double before = instants[middle] - instants[middle - 1], after = instants[middle + 1] - instants[middle];
    const double slope = 0.5 * (before + after) + (after - before) * ((double)k - (double)middle);
    const double least = k < middle ? before : k > middle ? after : fmin(before, after);
    return fmin(fmax(slope, 0.0), 3.0 * least);
}

/// A revolution: the instants of its pulses, and the durations of a revolution at them.
typedef struct revolution {
    double first, last, begins, ends;
} revolution;

static revolution revolution_at(const double *instants, size_t pulses, size_t k) {
    return (revolution){instants[k], instants[k + 1], slope_at(instants, pulses, k), slope_at(instants, pulses, k + 1)};
}

/// Returns the instant at which the shaft has turned by a part (0 to 1) of a revolution.
static double instant_at(const revolution *turn, double part) {
    if (part == 0.0 || part == 1.0) return part == 1.0 ? turn->last : turn->first;
    const double length = turn->last - turn->first, rest = 1.0 - part;
    const double later =
        part * (length * part * (1.0 + 2.0 * rest) + turn->begins * rest * rest - turn->ends * part * rest);
    return fmin(fmax(turn->first + later, turn->first), turn->last);
}

// ---------------------------------------------------------------- the signals

/// Samples whose weighted sum is a polynomial's value at an instant.
typedef struct stencil {
    size_t first, nodes;
    double weights[WHIRL_SIGNALS_HIGHEST_ORDER + 1];
} stencil;

/// Returns the last sample that is not after an instant.
static size_t sample_before(const double *time, size_t count, double instant) {
    size_t low = 0, high = count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (time[middle] <= instant)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/// Returns Lagrange's polynomial through the order + 1 samples around an instant, centred where possible.
static stencil stencil_at(const double *time, size_t count, double instant, int order) {
    const size_t before = sample_before(time, count, instant), side = (size_t)order / 2;
    stencil s = {.first = before > side ? before - side : 0, .nodes = (size_t)order + 1};
    if (s.first > count - s.nodes) s.first = count - s.nodes;
    const double *t = time + s.first;
    for (size_t i = 0; i < s.nodes; i++) {
        s.weights[i] = 1.0;
        for (size_t j = 0; j < s.nodes; j++)
            if (j != i) s.weights[i] *= (instant - t[j]) / (t[i] - t[j]);
    }
    return s;
}

static double stencil_sum(const stencil *s, const double *values) {
    double sum = 0.0;
    for (size_t i = 0; i < s->nodes; i++) sum += s->weights[i] * values[s->first + i];
    return sum;
}

static whirl_status order_tracking_check(const double *time, const double *values, size_t count, size_t channels,
                                         const double *instants, size_t pulses, int order) {
    if (order < 1 || order > WHIRL_SIGNALS_HIGHEST_ORDER || order % 2 == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "the order of interpolation is %d, expected 1, 3, 5, 7 or 9", order);
    const whirl_status status = signal_check_turns(time, count, (size_t)order + 1, instants, pulses);
    return status.code == WHIRL_OK ? signal_check_channels(values, count, channels, 1) : status;
}

whirl_status whirl_signals_section(const double *time, const double *values, size_t count, size_t channels,
                                   const double *instants, size_t pulses, double phase, int order, double *section,
                                   size_t *points) {
    *points = 0;
    const whirl_status status = order_tracking_check(time, values, count, channels, instants, pulses, order);
    if (status.code != WHIRL_OK) return status;
    if (!(phase >= 0.0 && phase < two_pi))
        return whirl_fail(WHIRL_BAD_INPUT, "the phase of the section is %g rad, expected 0 or more and below 2 pi",
                          phase);
    const double part = phase / two_pi;
    *points = part > 0.0 ? pulses - 1 : pulses;
    for (size_t k = 0; k < *points; k++) {
        double instant = instants[k];
        if (part > 0.0) {
            const revolution turn = revolution_at(instants, pulses, k);
            instant = instant_at(&turn, part);
        }
        const stencil s = stencil_at(time, count, instant, order);
        for (size_t c = 0; c < channels; c++) section[k * channels + c] = stencil_sum(&s, values + c * count);
    }
    return whirl_ok();
}

whirl_status whirl_signals_samples(const double *time, size_t count, const double *instants, size_t pulses,
                                   size_t *samples) {
    *samples = 0;
    const whirl_status status = signal_check_turns(time, count, 2, instants, pulses);
    if (status.code != WHIRL_OK) return status;
    size_t most = 8;
    for (size_t k = 0; k + 1 < pulses; k++) {
        const size_t between = sample_before(time, count, instants[k + 1]) - sample_before(time, count, instants[k]);
        most = between > most ? between : most;
    }
    *samples = most + most % 2;
    return whirl_ok();
}

whirl_status whirl_signals_resample(const double *time, const double *values, size_t count, size_t channels,
                                    const double *instants, size_t pulses, size_t samples, int order,
                                    double *resampled) {
    const whirl_status status = order_tracking_check(time, values, count, channels, instants, pulses, order);
    if (status.code != WHIRL_OK) return status;
    const size_t revolutions = pulses - 1;
    if (samples < 3 || samples > WHIRL_SIGNALS_MAX / channels / revolutions)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "there are to be %zu samples per revolution, expected at least 3 and at most %d numbers in all", samples,
            WHIRL_SIGNALS_MAX);
    for (size_t at = 0; at < revolutions * samples; at++) {
        const double part = (double)(at % samples + 1) / (double)samples;
        const revolution turn = revolution_at(instants, pulses, at / samples);
        const double instant = instant_at(&turn, part);
        const stencil s = stencil_at(time, count, instant, order);
        for (size_t c = 0; c < channels; c++)
            resampled[c * revolutions * samples + at] = stencil_sum(&s, values + c * count);
    }
    return whirl_ok();
}

whirl_status whirl_signals_angle(const double *instants, size_t pulses, const double *time, size_t count,
                                 double *angle) {
    const whirl_status status = signal_check_pulses(instants, pulses);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < count; i++) {
        if (!(time[i] >= instants[0] && time[i] <= instants[pulses - 1]))
            return whirl_fail(WHIRL_BAD_INPUT, "sample %zu is at %.17g, expected a time of the pulses, %.17g to %.17g",
                              i, time[i], instants[0], instants[pulses - 1]);
        const size_t before = sample_before(instants, pulses, time[i]), k = before + 2 > pulses ? pulses - 2 : before;
        const revolution turn = revolution_at(instants, pulses, k);
        // The cubic is monotone: bisect to 2^-60 of a turn.
        double low = time[i] >= turn.last ? 1.0 : 0.0, step = time[i] > turn.first ? 0.5 : 0.0;
        for (int halved = 0; low < 1.0 && halved < 60; halved++, step *= 0.5)
            if (instant_at(&turn, low + step) <= time[i]) low += step;
        angle[i] = two_pi * ((double)k + low);
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- orders over turns

static whirl_status track_check(const double *resampled, size_t channels, size_t turns, size_t samples,
                                const double *orders, size_t count, size_t revolutions) {
    // Check the record.
    if (samples < 3)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu samples per revolution, expected 3 or more", samples);
    if (revolutions < 1 || revolutions > turns)
        return whirl_fail(WHIRL_BAD_INPUT, "orders are tracked over %zu revolutions, expected 1 to %zu, the record's",
                          revolutions, turns);
    if (turns > WHIRL_SIGNALS_MAX / samples)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu revolutions of %zu samples, expected at most %d numbers",
                          turns, samples, WHIRL_SIGNALS_MAX);
    // Each order needs whole periods in the window, below half the rate of samples.
    for (size_t k = 0; k < count; k++) {
        const double cycles = orders[k] * (double)revolutions;
        if (!(orders[k] >= 0.0 && orders[k] < 0.5 * (double)samples))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "an order is %g, expected 0 or more and below half of %zu samples per "
                              "revolution",
                              orders[k], samples);
        if (fabs(cycles - round(cycles)) > 1e-9)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the order %g has no whole number of periods in %zu revolutions, "
                              "expected a multiple of %g",
                              orders[k], revolutions, 1.0 / (double)revolutions);
    }
    return signal_check_channels(resampled, turns * samples, channels, 1);
}

whirl_status whirl_signals_track(const double *resampled, size_t channels, size_t turns, size_t samples,
                                 const double *orders, size_t count, size_t revolutions, double *vectors) {
    const whirl_status status = track_check(resampled, channels, turns, samples, orders, count, revolutions);
    if (status.code != WHIRL_OK) return status;

    // Sample j of a block is at the angle 2 pi (j + 1)/samples; e^(-i order angle) has the period of a block.
    const size_t block = revolutions * samples, rows = turns / revolutions;
    double *wave = malloc(2 * block * sizeof *wave);
    if (!wave) return whirl_fail(WHIRL_NO_MEMORY, "no memory to track orders over %zu samples", block);
    for (size_t j = 0; j < block; j++) {
        const double angle = two_pi * (double)j / (double)block;
        wave[2 * j] = cos(angle), wave[2 * j + 1] = -sin(angle);
    }
    for (size_t k = 0; k < count; k++) {
        const size_t cycles = (size_t)round(orders[k] * (double)revolutions);
        const double scale = (cycles > 0 ? 2.0 : 1.0) / (double)block;
        for (size_t at = 0; at < channels * rows; at++) {
            const size_t channel = at / rows, row = at % rows;
            const double *z = resampled + channel * turns * samples + row * block;
            double re = 0.0, im = 0.0;
            for (size_t j = 0, place = cycles; j < block; j++, place = (place + cycles) % block) {
                re += z[j] * wave[2 * place];
                im += z[j] * wave[2 * place + 1];
            }
            double *vector = vectors + 2 * ((channel * count + k) * rows + row);
            vector[0] = scale * re, vector[1] = scale * im;
        }
    }
    free(wave);
    return whirl_ok();
}

whirl_status whirl_signals_axes(const double *u, const double *v, size_t count, double first, double second, double *x,
                                double *y) {
    whirl_status status = signal_check_channels(u, count, 1, 1);
    if (status.code == WHIRL_OK) status = signal_check_channels(v, count, 1, 1);
    if (status.code != WHIRL_OK) return status;
    const double across = sin(second - first);
    if (!(fabs(across) > 0.01))
        return whirl_fail(WHIRL_BAD_INPUT, "the probes are at %g and %g rad, expected two that are not in one line",
                          first, second);
    for (size_t i = 0; i < count; i++) {
        const double a = u[i], b = v[i];
        x[i] = (a * sin(second) - b * sin(first)) / across;
        y[i] = (b * cos(first) - a * cos(second)) / across;
    }
    return whirl_ok();
}
