/// Closed curves as trigonometric polynomials through an odd number of points at equal angles.
#ifndef ORBIT_HARMONICS_H
#define ORBIT_HARMONICS_H

#include <stddef.h>

/// Computes the Fourier series of `count` points [count][n]: series [count][n], which is the mean, then cosine and sine
/// of each harmonic.
void harmonics_of(size_t count, size_t n, const double *points, double *series);

/// Evaluates the curve at an angle and, unless NULL, its derivative by the angle: [n].
void harmonics_at(size_t count, size_t n, const double *series, double angle, double *value, double *slope);

/// Evaluates the curve at `many` equally spaced angles, the first of which is `from`: values and, unless NULL, slopes
/// [many][n]. Harmonics which so few points do not resolve are left out.
void harmonics_spread(size_t count, size_t n, const double *series, double from, size_t many, double *values,
                      double *slopes);

/// Computes the weight of each point in the value at an angle, and in its derivative: weights, slopes [count].
void harmonics_weights(size_t count, double angle, double *weights, double *slopes);

/// Returns the Euclidean amplitude of a harmonic.
double harmonics_size(size_t n, const double *series, size_t harmonic);

#endif
