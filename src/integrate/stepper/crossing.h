/// Where a function first passes zero within a step.
#ifndef INTEGRATE_CROSSING_H
#define INTEGRATE_CROSSING_H

#include <stdbool.h>
#include <stddef.h>

/// Writes the `count` values of functions that are positive until they are crossed, at `theta` of the step, 0 to 1.
typedef void crossing_values(void *context, double theta, double *values);

typedef struct crossing_search {
    crossing_values *values;
    void *context;
    size_t count;
    /// [count] 0; 1 for a function that begins at zero, 2 where its derivative begins at zero, too: the zero at theta =
    /// 0 is not one that is looked for. CROSSING_ALONG: no zero of this function is.
    const int *held;
    double *work; ///< [CROSSING_ROWS][count]
} crossing_search;

enum { CROSSING_ROWS = 12, CROSSING_DEGREE = 8, CROSSING_ALONG = CROSSING_DEGREE + 1 };

/// The first zero: true with its place and the function's index. Two zeros in one step, where a function only dips
/// below zero, are seen: every function is replaced by a polynomial, whose Bernstein coefficients bound it.
bool crossing_first(const crossing_search *search, double *theta, size_t *which);

#endif
