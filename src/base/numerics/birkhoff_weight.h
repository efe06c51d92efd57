/// The weights of Birkhoff averages: a smooth bump over the points, with which means along a quasi-periodic motion
/// converge faster than any power of their number (Das, Saiki, Sander, Yorke 2017).
#ifndef BASE_BIRKHOFF_WEIGHT_H
#define BASE_BIRKHOFF_WEIGHT_H

#include <math.h>
#include <stddef.h>

/// Returns the weight of point n of `count`; not normalized.
static inline double birkhoff_weight(size_t n, size_t count) {
    const double t = (double)(n + 1) / (double)(count + 1);
    return exp(-1.0 / (t * (1.0 - t)));
}

#endif
