/// First zero of a function within a step.
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
    /// [count] 0; 1 for a function that begins at zero, 2 if its derivative begins at zero too: the zero at theta = 0
    /// is ignored. CROSSING_ALONG: all zeros of this function are ignored.
    const int *held;
    double *work; ///< [CROSSING_ROWS][count]
} crossing_search;

enum { CROSSING_ROWS = 12, CROSSING_DEGREE = 8, CROSSING_ALONG = CROSSING_DEGREE + 1 };

/// Finds the first zero: returns true with its theta and the function's index. Two zeros in one step, where a function
/// only dips below zero, are found too: every function is replaced by a polynomial, which its Bernstein coefficients
/// bound.
bool crossing_first(const crossing_search *search, double *theta, size_t *which);

#endif
