#include "table.h"

#include <math.h>

/// Returns the slope at an end, by the parabola through three points, limited to stay monotone (Fritsch, Carlson 1980).
static double table_end_slope(double near, double far, double rise, double next) {
    const double slope = ((2.0 * near + far) * rise - near * next) / (near + far);
    if (slope * rise <= 0.0) return 0.0;
    return rise * next < 0.0 && fabs(slope) > 3.0 * fabs(rise) ? 3.0 * rise : slope;
}

static double table_width(const double *x, size_t i) {
    return x[i + 1] - x[i];
}

static double table_rise(const double *x, const double *y, size_t i) {
    return (y[i + 1] - y[i]) / table_width(x, i);
}

/// Returns the slope at an inner point: the weighted harmonic mean of the rises on both sides, 0 at an extreme.
static double table_slope(size_t count, const double *x, const double *y, size_t i) {
    if (count == 2) return table_rise(x, y, 0);
    if (i == 0) return table_end_slope(table_width(x, 0), table_width(x, 1), table_rise(x, y, 0), table_rise(x, y, 1));
    if (i == count - 1)
        return table_end_slope(table_width(x, i - 1), table_width(x, i - 2), table_rise(x, y, i - 1),
                               table_rise(x, y, i - 2));
    const double before = table_rise(x, y, i - 1), after = table_rise(x, y, i);
    if (before * after <= 0.0) return 0.0;
    const double a = 2.0 * table_width(x, i) + table_width(x, i - 1),
                 b = table_width(x, i) + 2.0 * table_width(x, i - 1);
    return (a + b) / (a / before + b / after);
}

bool table_rises(size_t count, const double *x) {
    for (size_t i = 1; i < count; i++)
        if (!(x[i] > x[i - 1])) return false;
    return true;
}

double table_value(size_t count, const double *x, const double *y, double at) {
    size_t i = 0;
    while (i + 2 < count && at > x[i + 1]) i++;
    const double h = table_width(x, i), s = (at - x[i]) / h, r = 1.0 - s;
    return y[i] * r * r * (1.0 + 2.0 * s) + y[i + 1] * s * s * (1.0 + 2.0 * r) +
           h * s * r * (r * table_slope(count, x, y, i) - s * table_slope(count, x, y, i + 1));
}

double table_rate(size_t count, const double *x, const double *y, double at) {
    size_t i = 0;
    while (i + 2 < count && at > x[i + 1]) i++;
    const double s = (at - x[i]) / table_width(x, i), r = 1.0 - s;
    return 6.0 * r * s * table_rise(x, y, i) + r * (r - 2.0 * s) * table_slope(count, x, y, i) +
           s * (s - 2.0 * r) * table_slope(count, x, y, i + 1);
}
