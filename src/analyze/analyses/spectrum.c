// Amplitude spectra in orders of the running speed, and the full spectrum of x + iy, which separates forward from
// backward whirl. The record holds whole revolutions, so whole orders and their fractions 1/record lie on bins.
#include "spectrum.h"
#include "analysis.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "spectral_lines.h"
#include "synchronous.h"
#include "transform.h"

static const double pi = 3.141592653589793238463;

size_t spectrum_bins(size_t revolutions, size_t samples_per_revolution, double highest_order) {
    const double last_whole = (double)((revolutions * samples_per_revolution - 1) / 2);
    const double wanted = floor(highest_order * (double)revolutions * (1.0 + 1e-12));
    return (size_t)fmin(wanted, last_whole) + 1;
}

/// Writes the periodic Hann window of `count` samples, which sums to count/2.
static void hann_window(size_t count, double *window) {
    for (size_t j = 0; j < count; j++) {
        const double s = sin(pi * (double)j / (double)count);
        window[j] = s * s;
    }
}

/// Removes the mean and applies the window. The mean is weighted by the window: a plain mean over a fractional number
/// of periods of a line would leave an offset, which leaks into other lines. True if more than the rounding of the mean
/// is left.
static bool window_samples(const double *samples, const double *window, size_t count, double *windowed) {
    double mean = 0.0, largest = 0.0, scale = 0.0;
    for (size_t j = 0; j < count; j++) mean += samples[j] * window[j];
    mean /= 0.5 * (double)count;
    for (size_t j = 0; j < count; j++) {
        windowed[j] = (samples[j] - mean) * window[j];
        largest = fmax(largest, fabs(windowed[j]));
        scale = fmax(scale, fabs(samples[j]));
    }
    return largest > 1e-12 * scale;
}

static double squares_of(const double *samples, size_t count) {
    double sum = 0.0;
    for (size_t j = 0; j < count; j++) sum += samples[j] * samples[j];
    return sum;
}

/// enough: share of the motion's mean square which the lines should hold; if they hold less, lines are searched at
/// higher orders, too. at_rest: sizes below this share of the largest displacement are no motion.
static const double enough = 0.99, at_rest = 1e-7;

/// Fills in the bins and the lines between them. Searches `bins` bins, then twice, four times ... as many up to `most`,
/// until they hold enough of `square`, the motion's mean square. The squares of all bins sum to 3 times the mean
/// square: Parseval's theorem for windowed samples. `power` has space for `most`. Returns the mean square of the lines.
static double spectrum_fill(whirl_spectrum *spectrum, const wave_transform *wave, double square, size_t bins,
                            size_t most, double *power) {
    double held = 0.0, lines = 0.0;
    for (size_t k = 0; k < bins; k++) {
        const whirl_line bin = spectrum_line((double)k, wave_transform_at(wave, (double)k));
        power[k] = bin.x * bin.x + bin.y * bin.y;
        held += power[k];
        if (k < spectrum->count) {
            spectrum->x[k] = bin.x;
            spectrum->y[k] = bin.y;
            spectrum->forward[k] = bin.forward;
            spectrum->backward[k] = bin.backward;
        }
        if (k + 1 == bins && held < 3.0 * enough * square) bins = 2 * bins < most ? 2 * bins : most;
    }
    spectrum->line_count = spectrum_lines(wave, power, bins, spectrum->lines);
    for (size_t l = 0; l < spectrum->line_count; l++) {
        whirl_line *line = &spectrum->lines[l];
        line->order *= spectrum->resolution;
        lines += 0.5 * (line->x * line->x + line->y * line->y);
    }
    return lines;
}

/// Returns the largest magnitude of the samples.
static double largest_of(const double *samples, size_t count) {
    double largest = 0.0;
    for (size_t j = 0; j < count; j++) largest = fmax(largest, fabs(samples[j]));
    return largest;
}

/// Computes the spectrum of x and y [count], `turn` samples per revolution. `spectrum` has space for its bins. Lines
/// are searched in `bins` bins, or in up to `most` if these hold too little of the motion. False without memory.
static bool spectrum_analyse(const double *of_x, const double *of_y, size_t count, size_t turn, size_t bins,
                             size_t most, whirl_spectrum *spectrum) {
    double *x = malloc((3 * count + most) * sizeof *x);
    if (!x) return false;
    double *y = x + count, *window = y + count, *power = window + count;
    hann_window(count, window);
    const bool moves_x = window_samples(of_x, window, count, x);
    const bool moves_y = window_samples(of_y, window, count, y);
    wave_transform *wave = moves_x || moves_y ? wave_transform_new(x, y, count, 0.5 * (double)count) : NULL;
    if (wave) {
        // Squares of the window have the mean 3/8.
        const double largest = fmax(largest_of(of_x, count), largest_of(of_y, count));
        const double square = (squares_of(x, count) + squares_of(y, count)) / (0.375 * (double)count);
        const bool still = sqrt(square) < at_rest * largest;
        const double lines = spectrum_fill(spectrum, wave, square, bins, still ? bins : most, power);
        if (!still) spectrum->line_share = fmin(lines / square, 1.0);
        spectrum->synchronous = synchronous_part(wave, turn, largest);
    }
    const bool done = wave || (!moves_x && !moves_y);
    wave_transform_free(wave);
    free(x);
    return done;
}

static whirl_spectrum *empty_spectrum(size_t bins, double resolution) {
    whirl_spectrum *spectrum = calloc(1, sizeof *spectrum + 4 * bins * sizeof(double));
    if (!spectrum) return NULL;
    spectrum->synchronous = synchronous_none();
    spectrum->line_share = NAN;
    spectrum->count = bins;
    spectrum->resolution = resolution;
    spectrum->x = (double *)(spectrum + 1);
    spectrum->y = spectrum->x + bins;
    spectrum->forward = spectrum->y + bins;
    spectrum->backward = spectrum->forward + bins;
    return spectrum;
}

whirl_status spectrum_of(const double *x, const double *y, size_t count, size_t samples_per_revolution,
                         double highest_order, bool further, whirl_spectrum **spectrum) {
    *spectrum = NULL;
    if (!(highest_order > 0.0)) {
        return whirl_fail(WHIRL_BAD_INPUT, "the highest order is %g, expected a number above 0", highest_order);
    }
    const size_t revolutions = count / samples_per_revolution;
    const size_t kept = spectrum_bins(revolutions, samples_per_revolution, highest_order);
    // Two more bins give a line at the highest order a neighbour on its right.
    const size_t bins = spectrum_bins(revolutions, samples_per_revolution, highest_order + 2.0 / (double)revolutions);

    const size_t most = further ? spectrum_bins(revolutions, samples_per_revolution, INFINITY) : bins;

    whirl_spectrum *made = empty_spectrum(kept, 1.0 / (double)revolutions);
    if (!made || !spectrum_analyse(x, y, count, samples_per_revolution, bins, most, made)) {
        whirl_spectrum_free(made);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the spectrum of %zu samples", count);
    }
    *spectrum = made;
    return whirl_ok();
}

static void spectrum_swap(double *one, double *other) {
    const double kept = *one;
    *one = *other;
    *other = kept;
}

/// Swaps directions for a shaft that turns clockwise: motion from x to y is backward there.
static void swap_directions(whirl_spectrum *spectrum) {
    double *forward = spectrum->forward;
    spectrum->forward = spectrum->backward;
    spectrum->backward = forward;
    for (size_t l = 0; l < spectrum->line_count; l++)
        spectrum_swap(&spectrum->lines[l].forward, &spectrum->lines[l].backward);
    spectrum_swap(&spectrum->synchronous.amplitude[2], &spectrum->synchronous.amplitude[3]);
    spectrum_swap(&spectrum->synchronous.lag[2], &spectrum->synchronous.lag[3]);
}

whirl_status whirl_spectrum_new(const whirl_record *record, size_t probe, double highest_order,
                                whirl_spectrum **spectrum) {
    *spectrum = NULL;
    if (record->sample_count == 0) return whirl_fail(WHIRL_BAD_INPUT, "the record holds no samples of a waveform");
    if (probe >= record->probe_count + record->extra_count) {
        return whirl_fail(WHIRL_BAD_INPUT, "there is no probe %zu, the record has %zu", probe,
                          record->probe_count + record->extra_count);
    }
    const size_t count = record->sample_count;
    double *x = malloc(2 * count * sizeof *x);
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the spectrum of %zu samples", count);
    fill_seen(record, probe, count, x);
    const whirl_status status =
        spectrum_of(x, x + count, count, record->samples_per_revolution, highest_order, true, spectrum);
    free(x);
    if (status.code == WHIRL_OK && record->probes[probe].clockwise) swap_directions(*spectrum);
    return status;
}

void whirl_spectrum_free(whirl_spectrum *spectrum) {
    free(spectrum);
}

static size_t most_lines(const block_shape *shape) {
    (void)shape;
    return WHIRL_MAX_LINES;
}

static size_t kept_bins(const block_shape *shape) {
    if (!shape->options->spectra) return 0;
    return spectrum_bins((size_t)shape->options->record, shape->samples_per_revolution, shape->options->highest_order);
}

static size_t lines_of_axial(const block_shape *shape) {
    return rows_of_axial(shape) * most_lines(shape);
}

static size_t lines_of_twist(const block_shape *shape) {
    return rows_of_twist(shape) * most_lines(shape);
}

static size_t bins_of_twist(const block_shape *shape) {
    return rows_of_twist(shape) * kept_bins(shape);
}

static size_t bins_of_axial(const block_shape *shape) {
    return rows_of_axial(shape) * kept_bins(shape);
}

enum {
    LINES,
    AMPLITUDE,
    SYNCHRONOUS,
    LAG,
    SHARE,
    AXIAL_LINES,
    AXIAL_AMPLITUDE,
    AXIAL_SYNCHRONOUS,
    AXIAL_LAG,
    TWIST_LINES,
    TWIST_AMPLITUDE,
    TWIST_SYNCHRONOUS,
    TWIST_LAG,
    FIELD_COUNT
};

static const field_plan fields[FIELD_COUNT] = {
    [LINES] = {WHIRL_FIELD_SPECTRUM_LINES, "length", "order, x, y, forward, backward (0-p amplitudes)",
               WHIRL_PER_STATION, SPECTRUM_COLUMNS, most_lines},
    [AMPLITUDE] = {WHIRL_FIELD_SPECTRUM_AMPLITUDE, "length", "order, x, y, forward, backward (0-p amplitudes)",
                   WHIRL_PER_STATION, SPECTRUM_COLUMNS, kept_bins},
    [SYNCHRONOUS] = {WHIRL_FIELD_SPECTRUM_SYNCHRONOUS, "length", "x, y, forward, backward (0-p amplitudes)",
                     WHIRL_PER_STATION, 4, NULL},
    [SHARE] = {WHIRL_FIELD_SPECTRUM_SHARE, "1", "share of the motion's mean square about its mean that the lines hold",
               WHIRL_PER_STATION, 1, NULL},
    [LAG] = {WHIRL_FIELD_SPECTRUM_SYNCHRONOUS_LAG, "deg", "x, y, forward, backward", WHIRL_PER_STATION, 4, NULL},
    [AXIAL_LINES] = {WHIRL_FIELD_SPECTRUM_AXIAL_LINES, "length",
                     "order, amplitude (0-p amplitudes of axial displacements; missing where the station does not move "
                     "along its shaft)",
                     WHIRL_PER_STATION, 2, lines_of_axial},
    [AXIAL_AMPLITUDE] = {WHIRL_FIELD_SPECTRUM_AXIAL_AMPLITUDE, "length",
                         "order, amplitude (0-p amplitudes of axial displacements)", WHIRL_PER_STATION, 2,
                         bins_of_axial},
    [AXIAL_SYNCHRONOUS] = {WHIRL_FIELD_SPECTRUM_AXIAL_SYNCHRONOUS, "length",
                           "0-p amplitude of the axial displacement at the speed", WHIRL_PER_STATION, 1, rows_of_axial},
    [AXIAL_LAG] = {WHIRL_FIELD_SPECTRUM_AXIAL_LAG, "deg",
                   "angle by which the peak of the axial displacement comes after the mark", WHIRL_PER_STATION, 1,
                   rows_of_axial},
    [TWIST_LINES] = {WHIRL_FIELD_SPECTRUM_TWIST_LINES, "rad",
                     "order, amplitude (amplitudes of twists; missing where the station does not twist, or moves "
                     "no other way)",
                     WHIRL_PER_STATION, 2, lines_of_twist},
    [TWIST_AMPLITUDE] = {WHIRL_FIELD_SPECTRUM_TWIST_AMPLITUDE, "rad", "order, amplitude (amplitudes of twists)",
                         WHIRL_PER_STATION, 2, bins_of_twist},
    [TWIST_SYNCHRONOUS] = {WHIRL_FIELD_SPECTRUM_TWIST_SYNCHRONOUS, "rad", "amplitude of the twist at the speed",
                           WHIRL_PER_STATION, 1, rows_of_twist},
    [TWIST_LAG] = {WHIRL_FIELD_SPECTRUM_TWIST_LAG, "deg", "angle by which the peak of the twist comes after the mark",
                   WHIRL_PER_STATION, 1, rows_of_twist},
};

static double *put_row(double *out, const whirl_line *line) {
    const double row[SPECTRUM_COLUMNS] = {line->order, line->x, line->y, line->forward, line->backward};
    for (size_t c = 0; c < SPECTRUM_COLUMNS; c++) *out++ = row[c];
    return out;
}

void spectrum_rows(const whirl_spectrum *spectrum, double *lines, double *bins) {
    for (size_t l = 0; l < spectrum->line_count; l++) lines = put_row(lines, &spectrum->lines[l]);
    for (size_t k = 0; k < spectrum->count && bins; k++) {
        const whirl_line bin = {(double)k * spectrum->resolution, spectrum->x[k], spectrum->y[k], spectrum->forward[k],
                                spectrum->backward[k]};
        bins = put_row(bins, &bin);
    }
}

static void put_spectrum(const whirl_spectrum *spectrum, const block_view *view, size_t station) {
    spectrum_rows(spectrum, view_numbers(view, LINES, station), view_numbers(view, AMPLITUDE, station));
    memcpy(view_numbers(view, SYNCHRONOUS, station), spectrum->synchronous.amplitude, 4 * sizeof(double));
    *view_numbers(view, SHARE, station) = spectrum->line_share;
    memcpy(view_numbers(view, LAG, station), spectrum->synchronous.lag, 4 * sizeof(double));
}

/// Fills in the spectrum of axial displacements or twists of a station, which is that of x.
static void put_extra_spectrum(const whirl_spectrum *spectrum, const block_view *view, const whirl_extra *of) {
    const bool twists = of->twists;
    double *lines = view_numbers(view, twists ? TWIST_LINES : AXIAL_LINES, of->station);
    double *bins = view_numbers(view, twists ? TWIST_AMPLITUDE : AXIAL_AMPLITUDE, of->station);
    for (size_t l = 0; l < spectrum->line_count; l++) {
        *lines++ = spectrum->lines[l].order;
        *lines++ = spectrum->lines[l].x;
    }
    for (size_t k = 0; k < spectrum->count && bins; k++) {
        *bins++ = (double)k * spectrum->resolution;
        *bins++ = spectrum->x[k];
    }
    *view_numbers(view, twists ? TWIST_SYNCHRONOUS : AXIAL_SYNCHRONOUS, of->station) =
        spectrum->synchronous.amplitude[0];
    *view_numbers(view, twists ? TWIST_LAG : AXIAL_LAG, of->station) = spectrum->synchronous.lag[0];
}

static whirl_status spectrum_compute(const whirl_record *record, const whirl_record_options *options,
                                     const block_view *view) {
    for (size_t s = 0; s < record->probe_count + record->extra_count; s++) {
        whirl_spectrum *spectrum;
        const whirl_status status = whirl_spectrum_new(record, s, options->highest_order, &spectrum);
        if (status.code != WHIRL_OK) return status;
        if (s < record->probe_count)
            put_spectrum(spectrum, view, s);
        else
            put_extra_spectrum(spectrum, view, &record->extras[s - record->probe_count]);
        whirl_spectrum_free(spectrum);
    }
    return whirl_ok();
}

const analysis_plan spectrum_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_waveform = true, .compute = spectrum_compute};
