/// The polynomial through the numbers at five equally spaced instants.
#ifndef STUDY_FIVE_POINTS_H
#define STUDY_FIVE_POINTS_H

#include <math.h>

enum { FIVE = 5 };

/// Returns the polynomial through the numbers f [5] at the distance t from the middle instant, in distances of
/// instants. Writes its first two derivatives unless NULL.
static inline double five_points(const double f[FIVE], double t, double *first, double *second) {
    const double d1 = (f[0] - 8.0 * f[1] + 8.0 * f[3] - f[4]) / 12.0;
    const double d2 = (0.0 - f[0] + 16.0 * f[1] - 30.0 * f[2] + 16.0 * f[3] - f[4]) / 12.0;
    const double d3 = (f[4] - 2.0 * f[3] + 2.0 * f[1] - f[0]) / 2.0;
    const double d4 = f[0] - 4.0 * f[1] + 6.0 * f[2] - 4.0 * f[3] + f[4];
    if (first) *first = d1 + t * (d2 + t * (d3 / 2.0 + t * d4 / 6.0));
    if (second) *second = d2 + t * (d3 + t * d4 / 2.0);
    return f[2] + t * (d1 + t * (d2 / 2.0 + t * (d3 / 6.0 + t * d4 / 24.0)));
}

/// Returns the distance from the middle instant, -1 to 1, of the polynomial's maximum (sign 1), minimum (-1) or either
/// (0) next to it, by Newton's method.
static inline double five_points_extreme(const double f[FIVE], double sign) {
    double first, second, t = 0.0;
    for (int i = 0; i < 8; i++) {
        five_points(f, t, &first, &second);
        if (sign == 0.0 ? second != 0.0 : sign * second < 0.0) t = fmin(fmax(t - first / second, -1.0), 1.0);
    }
    return t;
}

#endif
