// Amplitude spectra in orders of the running speed, and the full spectrum of x + iy, which tells forward from
// backward whirl. The record holds whole revolutions, so whole orders and their fractions 1/record lie on bins.
#include <kiss_fft.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "lines.h"

static const double pi = 3.141592653589793238463;

/// Bins 0 ... of a record up to an order, below half the sampling frequency.
static size_t bin_count(size_t revolutions, size_t samples_per_revolution, double highest_order) {
    const double last_whole = (double)((revolutions * samples_per_revolution - 1) / 2);
    const double wanted = floor(highest_order * (double)revolutions * (1.0 + 1e-12));
    return (size_t)fmin(wanted, last_whole) + 1;
}

/// Work of a transform, one block.
typedef struct workspace {
    double *x, *y, *power;
    kiss_fft_cpx *in, *out;
} workspace;

static workspace *workspace_new(size_t samples, size_t bins) {
    workspace *work = malloc(sizeof *work + (2 * samples + bins) * sizeof(double) + 2 * samples * sizeof(kiss_fft_cpx));
    if (!work) return NULL;
    work->x = (double *)(work + 1);
    work->y = work->x + samples;
    work->power = work->y + samples;
    work->in = (kiss_fft_cpx *)(work->power + bins);
    work->out = work->in + samples;
    return work;
}

/// The periodic Hann window, at sample j of count.
static double hann(size_t j, size_t count) {
    const double s = sin(pi * (double)j / (double)count);
    return s * s;
}

/// Removes the mean and applies the window. The mean is weighted by the window: a plain mean over a broken number of
/// periods of a line would leave an offset, which would leak into other lines. Returns the largest value left; what is
/// at the rounding of the mean counts as nothing.
static double window_samples(const double *samples, size_t count, double *windowed) {
    double mean = 0.0, largest = 0.0, scale = 0.0;
    for (size_t j = 0; j < count; j++) mean += samples[j] * hann(j, count);
    mean /= 0.5 * (double)count;
    for (size_t j = 0; j < count; j++) {
        windowed[j] = (samples[j] - mean) * hann(j, count);
        largest = fmax(largest, fabs(windowed[j]));
        scale = fmax(scale, fabs(samples[j]));
    }
    return largest > 1e-12 * scale ? largest : 0.0;
}

/// Transforms x + iy, scaled by `scale` to keep single precision in its range. false: no memory.
static bool transform(workspace *work, size_t count, double scale) {
    kiss_fft_cfg plan = kiss_fft_alloc((int)count, 0, NULL, NULL);
    if (!plan) return false;
    for (size_t j = 0; j < count; j++) {
        work->in[j] = (kiss_fft_cpx){(float)(work->x[j] / scale), (float)(work->y[j] / scale)};
    }
    kiss_fft(plan, work->in, work->out);
    kiss_fft_free(plan);
    return true;
}

/// Amplitudes at bin k from Z(k) and Z(-k): with z = x + iy, X(k) = (Z(k) + conj Z(-k))/2, Y(k) = (Z(k) - conj Z(-k))/2i.
/// `unit` turns the transform into the amplitude of a circular motion.
static whirl_line bin_amplitudes(const workspace *work, size_t count, size_t k, double unit) {
    const kiss_fft_cpx plus = work->out[k], minus = work->out[k == 0 ? 0 : count - k];
    const double pr = unit * (double)plus.r, pi_ = unit * (double)plus.i;
    const double mr = unit * (double)minus.r, mi = unit * (double)minus.i;
    return (whirl_line){.x = hypot(pr + mr, pi_ - mi),
                        .y = hypot(pr - mr, pi_ + mi),
                        .forward = hypot(pr, pi_),
                        .backward = hypot(mr, mi)};
}

static void fill(whirl_spectrum *spectrum, workspace *work, size_t count, size_t bins, double scale) {
    const double unit = scale / (0.5 * (double)count); // the window sums to count/2
    for (size_t k = 0; k < bins; k++) {
        const whirl_line bin = bin_amplitudes(work, count, k, unit);
        work->power[k] = bin.x * bin.x + bin.y * bin.y;
        if (k >= spectrum->count) continue;
        spectrum->x[k] = bin.x;
        spectrum->y[k] = bin.y;
        spectrum->forward[k] = bin.forward;
        spectrum->backward[k] = bin.backward;
    }
    const windowed_pair signal = {count, work->x, work->y};
    spectrum->line_count = spectrum_lines(&signal, work->power, bins, spectrum->lines);
    for (size_t l = 0; l < spectrum->line_count; l++) spectrum->lines[l].order *= spectrum->resolution;
}

static whirl_spectrum *empty_spectrum(size_t bins, double resolution) {
    whirl_spectrum *spectrum = calloc(1, sizeof *spectrum + 4 * bins * sizeof(double));
    if (!spectrum) return NULL;
    spectrum->count = bins;
    spectrum->resolution = resolution;
    spectrum->x = (double *)(spectrum + 1);
    spectrum->y = spectrum->x + bins;
    spectrum->forward = spectrum->y + bins;
    spectrum->backward = spectrum->forward + bins;
    return spectrum;
}

static whirl_status check(const whirl_record *record, size_t probe, double highest_order) {
    if (record->sample_count == 0 || record->sample_count > INT_MAX) {
        return whirl_fail(WHIRL_BAD_INPUT, "the record holds %zu samples of a waveform, a spectrum needs 1 to %d",
                          record->sample_count, INT_MAX);
    }
    if (probe >= record->probe_count) {
        return whirl_fail(WHIRL_BAD_INPUT, "there is no probe %zu, the record has %zu", probe, record->probe_count);
    }
    if (!(highest_order > 0.0)) {
        return whirl_fail(WHIRL_BAD_INPUT, "the highest order is %g, expected a number above 0", highest_order);
    }
    return whirl_ok();
}

whirl_status whirl_spectrum_new(const whirl_record *record, size_t probe, double highest_order,
                                whirl_spectrum **spectrum) {
    *spectrum = NULL;
    const whirl_status status = check(record, probe, highest_order);
    if (status.code != WHIRL_OK) return status;
    const size_t count = record->sample_count;
    const size_t revolutions = count / record->samples_per_revolution;
    const size_t kept = bin_count(revolutions, record->samples_per_revolution, highest_order);
    // Two bins more, so that a line at the highest order has a right side.
    const size_t bins =
        bin_count(revolutions, record->samples_per_revolution, highest_order + 2.0 / (double)revolutions);

    whirl_spectrum *made = empty_spectrum(kept, 1.0 / (double)revolutions);
    workspace *work = workspace_new(count, bins);
    bool done = made && work;
    if (done) {
        const double *x = record->waveform + 2 * probe * count;
        const double scale = fmax(window_samples(x, count, work->x), window_samples(x + count, count, work->y));
        if (scale > 0.0) {
            done = transform(work, count, scale);
            if (done) fill(made, work, count, bins, scale);
        }
    }
    free(work);
    if (!done) {
        whirl_spectrum_free(made);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the spectrum of %zu samples", count);
    }
    *spectrum = made;
    return whirl_ok();
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
    return bin_count((size_t)shape->options->record, shape->samples_per_revolution, shape->options->highest_order);
}

enum { LINES, AMPLITUDE, FIELD_COUNT, COLUMNS = 5 };

static const field_plan fields[FIELD_COUNT] = {
    [LINES] = {"lines", "length", "order, x, y, forward, backward", WHIRL_PER_STATION, COLUMNS, most_lines},
    [AMPLITUDE] = {"amplitude", "length", "order, x, y, forward, backward", WHIRL_PER_STATION, COLUMNS, kept_bins},
};

static double *put_row(double *out, const whirl_line *line) {
    const double row[COLUMNS] = {line->order, line->x, line->y, line->forward, line->backward};
    for (size_t c = 0; c < COLUMNS; c++) *out++ = row[c];
    return out;
}

static void put_spectrum(const whirl_spectrum *spectrum, const block_view *view, size_t station) {
    double *lines = view_numbers(view, LINES, station);
    for (size_t l = 0; l < spectrum->line_count; l++) lines = put_row(lines, &spectrum->lines[l]);
    double *amplitude = view_numbers(view, AMPLITUDE, station);
    for (size_t k = 0; k < spectrum->count && amplitude; k++) {
        const whirl_line bin = {(double)k * spectrum->resolution, spectrum->x[k], spectrum->y[k], spectrum->forward[k],
                                spectrum->backward[k]};
        amplitude = put_row(amplitude, &bin);
    }
}

static whirl_status compute(const whirl_record *record, const whirl_record_options *options, const block_view *view) {
    for (size_t s = 0; s < record->probe_count; s++) {
        whirl_spectrum *spectrum;
        const whirl_status status = whirl_spectrum_new(record, s, options->highest_order, &spectrum);
        if (status.code != WHIRL_OK) return status;
        put_spectrum(spectrum, view, s);
        whirl_spectrum_free(spectrum);
    }
    return whirl_ok();
}

const analysis_plan spectrum_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_waveform = true, .compute = compute};
