#include "harmonics.h"
#include "two_pi.h"

#include <math.h>
#include <string.h>

/// Returns angle j of `count` equally spaced ones, rad.
static double angle_of(size_t j, size_t count) {
    return two_pi * (double)j / (double)count;
}

void harmonics_of(size_t count, size_t n, const double *points, double *series) {
    memset(series, 0, count * n * sizeof *series);
    for (size_t h = 0; h <= count / 2; h++) {
        double *c = series + (h > 0 ? 2 * h - 1 : 0) * n, *s = c + n;
        for (size_t j = 0; j < count; j++) {
            const double angle = angle_of(h * j % count, count), share = (h > 0 ? 2.0 : 1.0) / (double)count;
            const double by_cosine = share * cos(angle), by_sine = share * sin(angle);
            for (size_t i = 0; i < n; i++) c[i] += by_cosine * points[j * n + i];
            for (size_t i = 0; i < n && h > 0; i++) s[i] += by_sine * points[j * n + i];
        }
    }
}

/// Evaluates the harmonics up to `most`.
static void harmonics_evaluate(size_t most, size_t n, const double *series, double angle, double *value,
                               double *slope) {
    memcpy(value, series, n * sizeof *value);
    if (slope) memset(slope, 0, n * sizeof *slope);
    for (size_t h = 1; h <= most; h++) {
        const double *a = series + (2 * h - 1) * n, *b = a + n, order = (double)h;
        const double c = cos(order * angle), s = sin(order * angle);
        for (size_t i = 0; i < n; i++) value[i] += a[i] * c + b[i] * s;
        for (size_t i = 0; i < n && slope; i++) slope[i] += order * (b[i] * c - a[i] * s);
    }
}

void harmonics_at(size_t count, size_t n, const double *series, double angle, double *value, double *slope) {
    harmonics_evaluate(count / 2, n, series, angle, value, slope);
}

void harmonics_spread(size_t count, size_t n, const double *series, double from, size_t many, double *values,
                      double *slopes) {
    const size_t most = (many < count ? many : count) / 2;
    for (size_t j = 0; j < many; j++)
        harmonics_evaluate(most, n, series, from + angle_of(j, many), values + j * n, slopes ? slopes + j * n : NULL);
}

void harmonics_weights(size_t count, double angle, double *weights, double *slopes) {
    for (size_t k = 0; k < count; k++) {
        const double away = angle - angle_of(k, count);
        double sum = 0.5, slope = 0.0;
        for (size_t h = 1; h <= count / 2; h++) {
            sum += cos((double)h * away);
            slope -= (double)h * sin((double)h * away);
        }
        weights[k] = 2.0 * sum / (double)count;
        slopes[k] = 2.0 * slope / (double)count;
    }
}

double harmonics_size(size_t n, const double *series, size_t harmonic) {
    const double *a = series + (harmonic > 0 ? 2 * harmonic - 1 : 0) * n;
    double sum = 0.0;
    for (size_t i = 0; i < (harmonic > 0 ? 2 : 1) * n; i++) sum += a[i] * a[i];
    return sqrt(sum);
}
