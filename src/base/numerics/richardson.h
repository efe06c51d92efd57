/// Computes derivatives by central differences at steps h, h/2, h/4, ..., extrapolated to a step of 0 (Richardson
/// 1911). Of the extrapolations it takes the one that differs least from its neighbours (Ridders 1982).
#ifndef BASE_RICHARDSON_H
#define BASE_RICHARDSON_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/// Largest number of levels, each with half the step of the one before.
enum { RICHARDSON_LEVELS = 7 };

/// Returns the step of level `level`, from 0; `reach` is the step of level 0.
static inline double richardson_step(double reach, size_t level) {
    return ldexp(reach, -(int)level);
}

/// Adds level k to Neville's table, of which `line` [RICHARDSON_LEVELS] is the last line; `above` and `below` are the
/// function's values a step above and below. Updates the derivative and its error (`off`); a NaN changes neither after
/// the first level.
/// Returns true if the error is a rounding error, so that further levels cannot reduce it.
static inline bool richardson_add(double above, double below, double step, size_t k, double line[RICHARDSON_LEVELS],
                                  double *derivative, double *off) {
    // 4^j - 1, by which the difference of two entries is divided.
    static const double less[RICHARDSON_LEVELS] = {0.0, 3.0, 15.0, 63.0, 255.0, 1023.0, 4095.0};
    // Compute the first entry, a difference over twice the step, and its rounding error.
    const double rounding = 8.0 * DBL_EPSILON * fmax(fabs(above), fabs(below)) / step;
    double before = line[0], entry = (above - below) / (2.0 * step);
    line[0] = entry;
    if (k == 0) {
        *derivative = entry;
        *off = INFINITY;
    }
    // Extrapolate to a step of 0, and keep the entry that changes least.
    for (size_t j = 1; j <= k; j++) {
        const double next = entry + (entry - before) / less[j];
        const double own = fmax(fabs(next - entry), fabs(next - before)) + rounding;
        if (own < *off) {
            *derivative = next;
            *off = own;
        }
        before = line[j];
        line[j] = entry = next;
    }
    // Take the last entry if no level gave a finite error.
    if (k + 1 == RICHARDSON_LEVELS && !isfinite(*off)) *derivative = entry;
    return *off <= 2.0 * rounding;
}

#endif
