// Measured signals: the analyses of computed motions over plain arrays.
#include "whirl/signals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "recurrence.h"
#include "section.h"
#include "signal_check.h"
#include "spectrum.h"
#include "zero_one.h"

_Static_assert((int)WHIRL_SIGNALS_COLUMNS == (int)SPECTRUM_COLUMNS, "rows are handed on as they are");
_Static_assert((int)WHIRL_SIGNALS_LINES >= (int)WHIRL_MAX_LINES, "callers have room for all lines");

// ---------------------------------------------------------------- spectra

size_t whirl_signals_orders(size_t count, size_t samples, double highest_order) {
    if (samples < 3 || count < samples || count % samples != 0 || !(highest_order > 0.0)) return 0;
    return spectrum_bins(count / samples, samples, highest_order);
}

static whirl_status check_turned(const double *x, const double *y, size_t count, size_t samples) {
    if (samples < 3)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu samples per revolution, expected 3 or more", samples);
    if (count % samples != 0)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu samples, expected whole revolutions of %zu", count, samples);
    if (count / samples < WHIRL_SIGNALS_MIN_REVOLUTIONS)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu revolutions, expected at least %d for a spectrum",
                          count / samples, WHIRL_SIGNALS_MIN_REVOLUTIONS);
    const whirl_status status = signal_check_channels(x, count, 1, 1);
    return status.code == WHIRL_OK && y ? signal_check_channels(y, count, 1, 1) : status;
}

whirl_status whirl_signals_spectrum(const double *x, const double *y, size_t count, size_t samples,
                                    double highest_order, double *orders, double *lines, size_t *line_count,
                                    double *synchronous) {
    *line_count = 0;
    whirl_status status = check_turned(x, y, count, samples);
    if (status.code != WHIRL_OK) return status;
    double *nothing = y ? NULL : calloc(count, sizeof *nothing);
    if (!y && !nothing) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the spectrum of %zu samples", count);
    whirl_spectrum *spectrum;
    status = spectrum_of(x, y ? y : nothing, count, samples, highest_order, false, &spectrum);
    free(nothing);
    if (status.code != WHIRL_OK) return status;
    *line_count = spectrum->line_count;
    spectrum_rows(spectrum, lines, orders);
    memcpy(synchronous, spectrum->synchronous.amplitude, sizeof spectrum->synchronous.amplitude);
    memcpy(synchronous + 4, spectrum->synchronous.lag, sizeof spectrum->synchronous.lag);
    whirl_spectrum_free(spectrum);
    return whirl_ok();
}

size_t whirl_signals_frequencies(size_t window) {
    return window > 0 ? spectrum_bins(window, 1, INFINITY) : 0;
}

whirl_status whirl_signals_spectrogram(const double *x, const double *y, size_t count, size_t window, size_t step,
                                       double *rows) {
    enum { MIN_WINDOW = 8, COLUMNS = 4 };
    if (window < MIN_WINDOW || window > count)
        return whirl_fail(WHIRL_BAD_INPUT, "a window has %zu samples, expected %d to %zu, all there are", window,
                          MIN_WINDOW, count);
    if (step < 1) return whirl_fail(WHIRL_BAD_INPUT, "windows are 0 samples apart, expected at least 1");
    const size_t bins = whirl_signals_frequencies(window), windows = (count - window) / step + 1;
    if (windows > WHIRL_SIGNALS_MAX / (COLUMNS * bins))
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu windows of %zu frequencies, expected at most %d numbers",
                          windows, bins, WHIRL_SIGNALS_MAX);
    whirl_status status = signal_check_channels(x, count, 1, 1);
    if (status.code == WHIRL_OK && y) status = signal_check_channels(y, count, 1, 1);
    if (status.code != WHIRL_OK) return status;
    double *nothing = y ? NULL : calloc(window, sizeof *nothing);
    if (!y && !nothing) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a window of %zu samples", window);
    for (size_t row = 0; row < windows && status.code == WHIRL_OK; row++) {
        // With one sample per revolution, orders are frequencies over the sampling rate.
        whirl_spectrum *spectrum;
        status = spectrum_of(x + row * step, y ? y + row * step : nothing, window, 1, INFINITY, false, &spectrum);
        if (status.code != WHIRL_OK) break;
        for (size_t bin = 0; bin < bins; bin++) {
            double *own = rows + COLUMNS * (row * bins + bin);
            own[0] = spectrum->x[bin], own[1] = spectrum->y[bin];
            own[2] = spectrum->forward[bin], own[3] = spectrum->backward[bin];
        }
        whirl_spectrum_free(spectrum);
    }
    free(nothing);
    return status;
}

// ---------------------------------------------------------------- sections

whirl_status whirl_signals_size(const double *values, size_t count, size_t channels, double *size) {
    const whirl_status status = signal_check_channels(values, count, channels, 1);
    if (status.code != WHIRL_OK) return status;
    double squares = 0.0;
    for (size_t c = 0; c < channels; c++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            low = fmin(low, values[c * count + i]);
            high = fmax(high, values[c * count + i]);
        }
        squares += 0.25 * (high - low) * (high - low);
    }
    *size = sqrt(squares);
    return whirl_ok();
}

whirl_status whirl_signals_zero_one(const double *points, size_t count, size_t dimension, double size, double *k) {
    whirl_status status = signal_check_points(points, count, dimension, ZERO_ONE_MIN);
    if (status.code == WHIRL_OK) status = signal_check_size(size);
    if (status.code != WHIRL_OK) return status;
    const section all = {count, dimension, points};
    *k = zero_one_test(&all, size);
    return whirl_ok();
}

whirl_status whirl_signals_returns(const double *points, size_t count, size_t dimension, double size, double tolerance,
                                   int *period, double *distance) {
    enum { MIN_POINTS = 5, MAX_POINTS = 20000 }; // every period is compared over all points
    whirl_status status = signal_check_points(points, count, dimension, MIN_POINTS);
    if (status.code == WHIRL_OK) status = signal_check_size(size);
    if (status.code != WHIRL_OK) return status;
    if (!(tolerance >= 0.0)) return whirl_fail(WHIRL_BAD_INPUT, "the tolerance is %g, expected 0 or more", tolerance);
    const section all = {count, dimension, points}, last = section_tail(&all, MAX_POINTS);
    const recurrence found = recurrence_find(&last, last.count, size, tolerance);
    *period = found.period;
    *distance = found.distance;
    return whirl_ok();
}
