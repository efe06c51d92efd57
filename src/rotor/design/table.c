#include "table.h"

#include <math.h>

/// At an end the parabola through three points, kept from turning back (Fritsch, Carlson 1980).
static double end_slope(double near, double far, double rise, double next) {
    const double slope = ((2.0 * near + far) * rise - near * next) / (near + far);
    if (slope * rise <= 0.0) return 0.0;
    return rise * next < 0.0 && fabs(slope) > 3.0 * fabs(rise) ? 3.0 * rise : slope;
}

static double width(const double *x, size_t i) {
    return x[i + 1] - x[i];
}

static double rise(const double *x, const double *y, size_t i) {
    return (y[i + 1] - y[i]) / width(x, i);
}

/// At a point in the middle the weighted harmonic mean of the rises to either side, 0 at an extreme.
static double slope_at(size_t count, const double *x, const double *y, size_t i) {
    if (count == 2) return rise(x, y, 0);
    if (i == 0) return end_slope(width(x, 0), width(x, 1), rise(x, y, 0), rise(x, y, 1));
    if (i == count - 1) return end_slope(width(x, i - 1), width(x, i - 2), rise(x, y, i - 1), rise(x, y, i - 2));
    const double before = rise(x, y, i - 1), after = rise(x, y, i);
    if (before * after <= 0.0) return 0.0;
    const double a = 2.0 * width(x, i) + width(x, i - 1), b = width(x, i) + 2.0 * width(x, i - 1);
    return (a + b) / (a / before + b / after);
}

double table_value(size_t count, const double *x, const double *y, double at) {
    size_t i = 0;
    while (i + 2 < count && at > x[i + 1]) i++;
    const double h = width(x, i), s = (at - x[i]) / h, r = 1.0 - s;
    return y[i] * r * r * (1.0 + 2.0 * s) + y[i + 1] * s * s * (1.0 + 2.0 * r) +
           h * s * r * (r * slope_at(count, x, y, i) - s * slope_at(count, x, y, i + 1));
}
