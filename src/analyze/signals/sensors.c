// Sensors, their electronics, and the sampling of their signals.
#include "whirl/engine/sensors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lock.h"
#include "random.h"
#include "two_pi.h"

const char *whirl_sensor_name(whirl_sensor sensor) {
    static const char *const names[] = {"proximity", "velocity", "accelerometer", "keyphasor",
                                        "proximity|velocity|accelerometer|keyphasor"};
    return names[sensor];
}

const char *whirl_sensor_unit(whirl_sensor sensor) {
    static const char *const units[] = {"m", "m/s", "m/s2", "1", ""};
    return units[sensor];
}

const char *whirl_sensor_sensitivity_unit(whirl_sensor sensor) {
    static const char *const units[] = {"V/m", "V s/m", "V s2/m", "V", ""};
    return units[sensor];
}

// ---------------------------------------------------------------- the sensor, at the instants of the waveform

/// The instants of a waveform, and the motion at them.
typedef struct sensor_grid {
    size_t count;
    double step;               ///< s
    const double *motion;      ///< [stations][2][count] displacements
    const whirl_probe *probes; ///< [stations]
    size_t turn;               ///< instants of a revolution, of which the last one ends it; 0: `angle` has the angles
    const double *angle;       ///< [count] rad, of the shaft
} sensor_grid;

/// Returns the angle of the shaft at an instant, in revolutions; only its fraction has a meaning.
static double sensor_revolutions(const sensor_grid *grid, size_t instant) {
    return grid->turn > 0 ? (double)((instant + 1) % grid->turn) / (double)grid->turn : grid->angle[instant] / two_pi;
}

/// Replaces displacements by their derivative of order 1 or 2, by central differences of order 8 (Fornberg 1988).
static void derive(const sensor_grid *grid, int order, const double *x, double *out) {
    enum { SIDE = 4 };
    static const double first[SIDE + 1] = {0.0, 4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    static const double second[SIDE + 1] = {-205.0 / 72, 8.0 / 5, -1.0 / 5, 8.0 / 315, -1.0 / 560};
    const double *c = order == 1 ? first : second, sign = order == 1 ? -1.0 : 1.0;
    const double scale = pow(grid->step, -order);
    for (size_t j = SIDE; j + SIDE < grid->count; j++) {
        double sum = c[0] * x[j];
        for (size_t k = 1; k <= SIDE; k++) sum += c[k] * (x[j + k] + sign * x[j - k]);
        out[j] = scale * sum;
    }
    for (size_t j = 0; j < SIDE; j++) {
        out[j] = out[SIDE];
        out[grid->count - 1 - j] = out[grid->count - 1 - SIDE];
    }
}

/// Passes a signal, which is linear between instants, through a spring and mass, exactly: y'' = w^2 (u - y) - 2 d w y'.
/// The mass begins at rest.
static void resonate(const sensor_grid *grid, double frequency, double damping, double *u) {
    const double w = two_pi * frequency, a = damping * w, wd = w * sqrt(1.0 - damping * damping), h = grid->step;
    const double e = exp(-a * h), c = e * cos(wd * h), s = e * sin(wd * h) / wd;
    double y = u[0], v = 0.0, before = u[0];
    for (size_t j = 1; j < grid->count; j++) {
        // The mass follows a signal that rises linearly with this lag. Its distance from that motion decays.
        const double now = u[j], slope = (now - before) / h, lag = 2.0 * damping / w * slope;
        const double dy = y - (before - lag), dv = v - slope;
        y = (c + a * s) * dy + s * dv + now - lag;
        v = -w * w * s * dy + (c - a * s) * dv + slope;
        before = now;
        u[j] = y;
    }
}

/// Removes what is slower than a corner frequency. The filter begins settled at the mean.
static void pass_high(const sensor_grid *grid, double frequency, double *u) {
    const double w = two_pi * frequency, h = grid->step, decay = exp(-w * h);
    double low = 0.0, before = u[0];
    for (size_t j = 0; j < grid->count; j++) low += u[j] / (double)grid->count;
    u[0] -= low;
    for (size_t j = 1; j < grid->count; j++) {
        const double now = u[j], slope = (now - before) / h;
        low = decay * (low - before + slope / w) + now - slope / w;
        before = now;
        u[j] = now - low;
    }
}

/// Computes the signal of a sensor in volts; x and y [count] of its station are workspace.
static void measure(const whirl_channel *channel, const whirl_sampling *sampling, const sensor_grid *grid, double *x,
                    double *out) {
    const double *y = x + grid->count, c = cos(channel->angle), s = sin(channel->angle);
    const size_t n = grid->count;
    // Compute displacements along the sensor. Proximity probes read the surface, and so its runout.
    memcpy(x, grid->motion + channel->station * 2 * n, 2 * n * sizeof *x);
    const whirl_probe *probe = &grid->probes[channel->station];
    for (size_t i = 0; channel->sensor == WHIRL_SENSOR_PROXIMITY && probe->runout_count > 0 && i < 2 * n; i++)
        x[i] += whirl_probe_runout(probe, i / n, sensor_revolutions(grid, i % n));
    for (size_t j = 0; j < n; j++) x[j] = sampling->length * (c * x[j] + s * y[j]);
    // Apply the sensor's law and its electronics.
    if (channel->sensor == WHIRL_SENSOR_PROXIMITY)
        for (size_t j = 0; j < n; j++) out[j] = channel->gap + x[j];
    else
        derive(grid, channel->sensor == WHIRL_SENSOR_VELOCITY ? 1 : 2, x, out);
    if (channel->resonance > 0.0) resonate(grid, channel->resonance, channel->damping, out);
    const bool limited = isfinite(channel->low) || isfinite(channel->high);
    for (size_t j = 0; j < n && limited; j++) out[j] = fmin(fmax(out[j], channel->low), channel->high);
    if (channel->high_pass > 0.0) pass_high(grid, channel->high_pass, out);
    for (size_t j = 0; j < n; j++) out[j] *= channel->sensitivity;
}

// ---------------------------------------------------------------- the antialias filter

enum { PLACES = 1024 }; // places of the filter's table in one sampling interval
static const size_t table_end = (size_t)WHIRL_SENSOR_REACH * PLACES;

/// Returns I0, the modified Bessel function, by its series.
static double bessel_zero(double x) {
    double sum = 1.0, term = 1.0;
    for (int k = 1; term > 1e-17 * sum; k++) {
        term *= 0.25 * x * x / ((double)k * (double)k);
        sum += term;
    }
    return sum;
}

/// Returns the impulse response at distances from 0 to the reach, the same for all records: a sinc under Kaiser's
/// window of 80 dB (Kaiser 1974).
static const double *impulse_response(void) {
    static double table[(size_t)WHIRL_SENSOR_REACH * PLACES + 2];
    static lock filling = LOCK_OPEN;
    static bool filled;
    const double beta = 7.857, pi = 0.5 * two_pi;
    lock_take(&filling);
    for (size_t i = 0; i <= table_end && !filled; i++) {
        const double u = (double)i / PLACES, part = u / WHIRL_SENSOR_REACH;
        table[i] = bessel_zero(beta * sqrt(fmax(0.0, 1.0 - part * part))) * (i == 0 ? 1.0 : sin(pi * u) / (pi * u));
    }
    filled = true;
    lock_leave(&filling);
    return table;
}

/// Weights of instants around the place of a sample.
typedef struct sample_weights {
    size_t first, count; ///< the first instant, and how many
    double phase;        ///< distance of the sample from the first instant, for which the weights were computed
    double *w;           ///< [count]
} sample_weights;

/// Computes the weights of the instants around `place`, a fractional index of an instant, for `ratio` instants a
/// sample. If the weights in `own` are for the same place between two instants, it keeps them.
static void weigh(const double *table, double ratio, double place, sample_weights *own) {
    const double reach = WHIRL_SENSOR_REACH * ratio;
    own->first = (size_t)ceil(place - reach);
    const double phase = place - (double)own->first;
    if (fabs(phase - own->phase) < 1e-9) return;
    own->phase = phase;
    own->count = (size_t)floor(place + reach) - own->first + 1;
    double sum = 0.0;
    for (size_t j = 0; j < own->count; j++) {
        const double at = fabs((double)j - phase) / ratio * PLACES;
        const size_t i = (size_t)at < table_end ? (size_t)at : table_end;
        own->w[j] = table[i] + (at - (double)i) * (table[i + 1] - table[i]);
        sum += own->w[j];
    }
    for (size_t j = 0; j < own->count; j++) own->w[j] /= sum;
}

// ---------------------------------------------------------------- pulses

/// Returns the share of the angles from `from` to `to`, in turns, that pulses cover.
static double pulse_share(const whirl_channel *channel, uint64_t seed, size_t index, double from, double to) {
    const double apart = 1.0 / channel->pulses, half = 0.5 * channel->width / two_pi;
    // Most samples see no pulse and need no random number: normal numbers made from 53 bits are below 9.
    const double farthest = half + 9.0 * channel->jitter / two_pi;
    double covered = 0.0;
    for (double p = fmax(0.0, floor(from / apart) - 1.0); p * apart <= to + apart; p += 1.0) {
        if (p * apart > to + farthest || p * apart < from - farthest) continue;
        double normals[2];
        random_normals(seed, 2 * index + 1, (uint64_t)p, normals);
        const double at = p * apart + channel->jitter / two_pi * normals[0];
        covered += fmax(0.0, fmin(to, at + half) - fmax(from, at - half));
    }
    return fmin(1.0, covered / (to - from));
}

// ---------------------------------------------------------------- the converter

static double convert(const whirl_channel *channel, double value) {
    if (channel->bits == 0) return value;
    const double steps = ldexp(1.0, channel->bits - 1);
    const double code = rint(value / channel->full_scale * steps);
    return fmin(fmax(code, -steps), steps - 1.0) * channel->full_scale / steps;
}

/// Adds noise, and converts volts to the numbers of the channel.
static void sensors_finish(const whirl_channel *channel, uint64_t seed, size_t index, size_t count, double *values,
                           float *out) {
    for (size_t k = 0; k < count; k += 2) {
        double normals[2] = {0.0};
        if (channel->noise > 0.0) random_normals(seed, 2 * index, k / 2, normals);
        for (size_t i = 0; i < 2 && k + i < count; i++)
            out[k + i] = (float)convert(channel, values[k + i] + channel->noise * normals[i]);
    }
}

// ---------------------------------------------------------------- all channels

/// Places of samples: sample k lies at place + k ratio among the instants.
typedef struct sample_places {
    double place, ratio;
    double turned; ///< revolutions of a sample if the speed is constant
} sample_places;

static whirl_status check_places(const sensor_grid *grid, const whirl_sampling *sampling, const sample_places *at) {
    const double reach = WHIRL_SENSOR_REACH * at->ratio, last = at->place + at->ratio * (double)(sampling->samples - 1);
    if (at->ratio < WHIRL_SENSOR_INSTANTS * (1.0 - 1e-9))
        return whirl_fail(WHIRL_BAD_INPUT, "the motion has %.3g instants a sample, expected %d or more", at->ratio,
                          WHIRL_SENSOR_INSTANTS);
    if (at->place < reach || last + reach > (double)(grid->count - 1))
        return whirl_fail(
            WHIRL_BAD_INPUT, "the record is too short for %zu samples at %.6g Hz: it has %.6g s, expected %.6g",
            sampling->samples, sampling->rate, (double)grid->count * grid->step, (last + 2.0 * reach) * grid->step);
    return whirl_ok();
}

/// Samples all channels into values [count][samples].
static void sample_all(const whirl_channel *channels, size_t count, const whirl_sampling *sampling,
                       const sensor_grid *grid, const sample_places *at, const double *signals, const double *table,
                       double *weights, double *values) {
    sample_weights own = {.phase = NAN, .w = weights};
    for (size_t k = 0; k < sampling->samples; k++) {
        weigh(table, at->ratio, at->place + at->ratio * (double)k, &own);
        for (size_t c = 0; c < count; c++) {
            const double *restrict s = signals + c * grid->count + own.first, *restrict w = own.w;
            double sums[8] = {0.0}; // independent, so that additions need not wait for each other
            if (channels[c].sensor == WHIRL_SENSOR_KEYPHASOR) continue;
            size_t j = 0;
            for (; j + 8 <= own.count; j += 8)
                for (size_t i = 0; i < 8; i++) sums[i] += w[j + i] * s[j + i];
            for (; j < own.count; j++) sums[0] += w[j] * s[j];
            for (size_t i = 0; i < 4; i++) sums[i] += sums[i + 4];
            values[c * sampling->samples + k] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        }
    }
}

/// Returns the angle of the shaft at a place among the instants, in revolutions, by linear interpolation.
static double sensor_angle_at(const sensor_grid *grid, double place) {
    const size_t low = (size_t)place < grid->count - 1 ? (size_t)place : grid->count - 2;
    const double share = place - (double)low;
    return ((1.0 - share) * grid->angle[low] + share * grid->angle[low + 1]) / two_pi;
}

/// Fills in the share of each sample's time in which a keyphasor sees a pulse, values [samples].
static void sample_pulses(const whirl_channel *channel, size_t index, const whirl_sampling *sampling,
                          const sensor_grid *grid, const sample_places *at, double *values) {
    const double least = 1e-9; // revolutions: a shaft that stands is within a pulse, or it is not
    for (size_t k = 0; k < sampling->samples; k++) {
        const double place = sampling->from + at->turned * (double)k, instant = at->place + at->ratio * (double)k;
        double from = place - 0.5 * at->turned, to = place + 0.5 * at->turned;
        if (grid->angle) {
            from = sensor_angle_at(grid, instant - 0.5 * at->ratio);
            to = fmax(sensor_angle_at(grid, instant + 0.5 * at->ratio), from + least);
        }
        values[k] = channel->sensitivity * pulse_share(channel, sampling->seed, index, from, to);
    }
}

/// Samples all channels of a motion that has the instants which they need.
static whirl_status sample_channels(const sensor_grid *grid, const sample_places *at, const whirl_channel *channels,
                                    size_t count, const whirl_sampling *sampling, float *out) {
    const size_t n = grid->count, samples = sampling->samples;
    const whirl_status status = check_places(grid, sampling, at);
    if (status.code != WHIRL_OK) return status;
    // Divide the workspace into signals at instants, a station's motion, weights of the filter, and samples.
    const size_t taps = (size_t)(2.0 * WHIRL_SENSOR_REACH * at->ratio) + 4;
    double *signals = malloc(((count + 2) * n + taps + count * samples) * sizeof *signals);
    if (!signals) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu samples of %zu channels", samples, count);
    double *motion = signals + count * n, *weights = motion + 2 * n, *values = weights + taps;
    // Compute the signals of sensors, sample them, fill in the pulses of keyphasors, and convert all to numbers.
    for (size_t c = 0; c < count; c++)
        if (channels[c].sensor != WHIRL_SENSOR_KEYPHASOR)
            measure(&channels[c], sampling, grid, motion, signals + c * n);
    sample_all(channels, count, sampling, grid, at, signals, impulse_response(), weights, values);
    for (size_t c = 0; c < count; c++) {
        double *own = values + c * samples;
        if (channels[c].sensor == WHIRL_SENSOR_KEYPHASOR) sample_pulses(&channels[c], c, sampling, grid, at, own);
        sensors_finish(&channels[c], sampling->seed, c, samples, own, out + c * samples);
    }
    free(signals);
    return whirl_ok();
}

whirl_status whirl_channels_sample(const whirl_record *record, const whirl_channel *channels, size_t count,
                                   const whirl_sampling *sampling, float *out) {
    const double turn = record->period / sampling->clock; // s
    const double instants = (double)record->samples_per_revolution;
    const sensor_grid grid = {.count = record->sample_count,
                              .step = turn / instants,
                              .motion = record->waveform,
                              .probes = record->probes,
                              .turn = record->samples_per_revolution};
    // The first instant of a waveform is one step after the beginning of the record.
    const sample_places at = {sampling->from * instants - 1.0, instants / (sampling->rate * turn),
                              1.0 / (sampling->rate * turn)};
    if (grid.count < 16) return whirl_fail(WHIRL_BAD_INPUT, "the record has no waveform");
    return sample_channels(&grid, &at, channels, count, sampling, out);
}

whirl_status whirl_channels_sample_run(const whirl_run_motion *motion, const whirl_probe *probes, size_t first,
                                       size_t ratio, const whirl_channel *channels, size_t count,
                                       const whirl_sampling *sampling, float *out) {
    const sensor_grid grid = {
        .count = motion->count, .step = motion->step, .motion = motion->x, .probes = probes, .angle = motion->angle};
    const sample_places at = {(double)first, (double)ratio, 0.0};
    if (motion->filled < motion->count || motion->count < 16)
        return whirl_fail(WHIRL_BAD_INPUT, "the motion has %zu of %zu instants", motion->filled, motion->count);
    return sample_channels(&grid, &at, channels, count, sampling, out);
}
