/// Transform of two windowed coordinates at any frequency, also between bins.
#ifndef ANALYZE_TRANSFORM_H
#define ANALYZE_TRANSFORM_H

#include <complex.h>
#include <stddef.h>

typedef struct wave_transform wave_transform;

/// Makes the transform of x and y [count]; `window_sum` is the sum of their window. Returns NULL without memory. Freed
/// by wave_transform_free.
wave_transform *wave_transform_new(const double *x, const double *y, size_t count, double window_sum);
void wave_transform_free(wave_transform *transform);

/// Returns the number of samples.
size_t wave_transform_count(const wave_transform *transform);

/// Sums of x and of y times exp(-2 pi i bin j/count), divided by the window's sum. For a sinusoid a e^(i theta) +
/// conj(a) e^(-i theta) at that frequency this is its amplitude a. Exact to 1e-14 of the largest amplitude.
typedef struct wave_amplitudes {
    double complex x, y;
} wave_amplitudes;
wave_amplitudes wave_transform_at(const wave_transform *transform, double bin); // bin >= 0

#endif
