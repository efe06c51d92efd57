/// First zero of a function within a step.
#ifndef INTEGRATE_CROSSING_H
#define INTEGRATE_CROSSING_H

#include <stdbool.h>
#include <stddef.h>

/// Writes the `count` values of functions that are positive until they are crossed, at `theta` of the step, 0 to 1.
typedef void crossing_values(void *context, double theta, double *values);

enum { CROSSING_ROWS = 12, CROSSING_DEGREE = 8 };

/// Number of leading terms of a function that vanish where it begins at zero. The zero at theta = 0 is ignored.
enum {
    CROSSING_STEEP = 1,                  ///< the function is zero, its derivative is not
    CROSSING_LEVEL = 2,                  ///< its derivative is zero too
    CROSSING_ALONG = CROSSING_DEGREE + 1 ///< all zeros of the function are ignored
};

typedef struct crossing_search {
    crossing_values *values;
    void *context;
    size_t count;
    const int *held; ///< [count] 0, or a CROSSING_ number for a function that begins at zero
    double *work;    ///< [CROSSING_ROWS][count]
} crossing_search;

/// Finds the first zero. Returns true with its theta and the function's index. Also finds two zeros in one step, where
/// a function only dips below zero: every function is replaced by a polynomial, which its Bernstein coefficients bound.
bool crossing_first(const crossing_search *search, double *theta, size_t *which);

#endif
