// Peaks of a response over the speed: amplification factors, and the separation margins that they require.
#include <math.h>

#include "whirl/internal/response_peaks.h"

/// A response at rising speeds.
typedef struct curve {
    size_t count;
    const double *x, *y;
} curve;

/// Interpolates between points i and i + 1, with the cubic through these and one more on either side (the parabola at
/// the ends).
static double peaks_between(const curve *c, size_t i, double at) {
    const size_t first = i > 0 ? i - 1 : 0, after = i + 3 < c->count ? i + 3 : c->count;
    double sum = 0.0;
    for (size_t j = first; j < after; j++) {
        double weight = 1.0;
        for (size_t k = first; k < after; k++)
            if (k != j) weight *= (at - c->x[k]) / (c->x[j] - c->x[k]);
        sum += weight * c->y[j];
    }
    return sum;
}

enum { HALVINGS = 60 };

/// Returns the location of the largest value between points i - 1 and i + 1, by ternary search.
static double top_of(const curve *c, size_t i) {
    double low = c->x[i - 1], high = c->x[i + 1];
    for (int n = 0; n < HALVINGS; n++) {
        const double one = low + (high - low) / 3.0, other = high - (high - low) / 3.0;
        const double below = peaks_between(c, one < c->x[i] ? i - 1 : i, one);
        const double above = peaks_between(c, other < c->x[i] ? i - 1 : i, other);
        if (below < above)
            low = one;
        else
            high = other;
    }
    return 0.5 * (low + high);
}

/// Returns the speed at which the response falls to `level` on a side (-1, 1) of peak i before it rises again; NaN if
/// it does not fall so far.
static double side_of(const curve *c, size_t i, int side, double level) {
    size_t from = i;
    while ((side < 0 ? from > 0 : from + 1 < c->count) && c->y[from] > level) {
        const size_t next = side < 0 ? from - 1 : from + 1;
        if (c->y[next] > c->y[from]) return NAN;
        from = next;
    }
    if (c->y[from] > level) return NAN;
    const size_t left = side < 0 ? from : from - 1;
    double low = c->x[left], high = c->x[left + 1];
    for (int n = 0; n < HALVINGS; n++) {
        const double middle = 0.5 * (low + high);
        if ((peaks_between(c, left, middle) > level) == (side < 0))
            high = middle;
        else
            low = middle;
    }
    return 0.5 * (low + high);
}

/// Returns the slope of the phase across peak i, rad per rad/s, by differences.
static double phase_slope(const curve *c, const double *lags, size_t i) {
    const double degrees = remainder(lags[i + 1] - lags[i - 1], 360.0);
    return degrees / 180.0 * 3.14159265358979323846 / (c->x[i + 1] - c->x[i - 1]);
}

static whirl_response_peak peak_at(const curve *c, const double *lags, size_t i) {
    whirl_response_peak peak = {.speed = top_of(c, i)};
    peak.amplitude = peaks_between(c, peak.speed < c->x[i] ? i - 1 : i, peak.speed);
    const double level = peak.amplitude / 1.41421356237309504880;
    peak.low = side_of(c, i, -1, level);
    peak.high = side_of(c, i, 1, level);
    if (!isnan(peak.low) && !isnan(peak.high)) {
        peak.amplification = peak.speed / (peak.high - peak.low);
    } else if (isnan(peak.low) && isnan(peak.high)) {
        peak.way = WHIRL_BY_PHASE_SLOPE;
        peak.amplification = 0.5 * peak.speed * fabs(phase_slope(c, lags, i));
    } else {
        peak.way = WHIRL_BY_ONE_SIDE;
        peak.amplification = peak.speed / (2.0 * fabs(peak.speed - (isnan(peak.low) ? peak.high : peak.low)));
    }
    peak.points = 2.0 * peak.speed / peak.amplification / (c->x[i + 1] - c->x[i - 1]);
    return peak;
}

static bool is_peak(const curve *c, size_t i) {
    return i > 0 && i + 1 < c->count && c->y[i] > c->y[i - 1] && c->y[i] >= c->y[i + 1];
}

size_t whirl_response_peaks(size_t count, const double *speeds, const double *amplitudes, const double *lags,
                            size_t most, whirl_response_peak *peaks) {
    const curve c = {count, speeds, amplitudes};
    size_t found = 0;
    for (size_t i = 1; i < count && found < most; i++)
        if (is_peak(&c, i)) peaks[found++] = peak_at(&c, lags, i);
    return found;
}

/// Interpolates at a speed from the first point to the last.
static double peaks_value_at(const curve *c, double at) {
    size_t i = 0;
    while (i + 2 < c->count && c->x[i + 1] < at) i++;
    return c->count > 1 ? peaks_between(c, i, at) : c->y[0];
}

double whirl_response_largest(size_t count, const double *speeds, const double *amplitudes, double low, double high) {
    static const double same = 1e-9; // an end may be given in another unit than a point
    const curve c = {count, speeds, amplitudes};
    if (count == 0 || low < speeds[0] * (1.0 - same) || high > speeds[count - 1] * (1.0 + same)) return NAN;
    double largest = fmax(peaks_value_at(&c, low), peaks_value_at(&c, high));
    for (size_t i = 0; i < count; i++) {
        if (speeds[i] >= low && speeds[i] <= high) largest = fmax(largest, amplitudes[i]);
        if (!is_peak(&c, i)) continue;
        const double top = top_of(&c, i);
        if (top >= low && top <= high) largest = fmax(largest, peaks_value_at(&c, top));
    }
    return largest;
}

double whirl_margin_required(double amplification, bool above) {
    if (!(amplification >= 2.5)) return 0.0;
    return (above ? 10.0 : 0.0) + 17.0 * (1.0 - 1.0 / (amplification - 1.5));
}
