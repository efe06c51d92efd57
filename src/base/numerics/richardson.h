/// Derivatives from central differences at steps h, h/2, h/4, ..., extrapolated to a step of 0 (Richardson 1911); the
/// best level is the one that differs least from its neighbours (Ridders 1982).
#ifndef BASE_RICHARDSON_H
#define BASE_RICHARDSON_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/// Most steps.
enum { RICHARDSON_LEVELS = 7 };

/// Returns the step of a level, from 0.
static inline double richardson_step(double reach, size_t level) {
    return ldexp(reach, -(int)level);
}

/// Adds level k, with the numbers a step above and below, to Neville's table, whose last line is
/// `line` [RICHARDSON_LEVELS]. Keeps the derivative, and in `off` its error: a NaN leaves both as they are. Returns
/// true if the error is rounding, so that further levels add nothing.
static inline bool richardson_add(double above, double below, double step, size_t k, double line[RICHARDSON_LEVELS],
                                  double *derivative, double *off) {
    // The first column has differences over twice the step; rounding limits what they can show.
    const double rounding = 8.0 * DBL_EPSILON * fmax(fabs(above), fabs(below)) / step;
    double before = line[0], entry = (above - below) / (2.0 * step);
    line[0] = entry;
    if (k == 0) {
        *derivative = entry;
        *off = INFINITY;
    }
    // Extrapolate to a step of 0, and keep the entry that changes least.
    for (size_t j = 1; j <= k; j++) {
        const double less = ldexp(1.0, 2 * (int)j) - 1.0, next = entry + (entry - before) / less;
        const double own = fmax(fabs(next - entry), fabs(next - before)) + rounding;
        if (own < *off) {
            *derivative = next;
            *off = own;
        }
        before = line[j];
        line[j] = entry = next;
    }
    // Without a finite estimate take the last entry.
    if (k + 1 == RICHARDSON_LEVELS && !isfinite(*off)) *derivative = entry;
    return *off <= 2.0 * rounding;
}

#endif
