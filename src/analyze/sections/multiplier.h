/// The largest Floquet multiplier of a periodic motion, from the returns of its section.
#ifndef ANALYZE_MULTIPLIER_H
#define ANALYZE_MULTIPLIER_H

#include "section.h"

/// The largest Floquet multiplier of a periodic motion; of a complex pair the one with positive imaginary part.
typedef struct multiplier {
    double real, imaginary;
} multiplier;

/// Finds the multiplier by least squares on the returns z(n + period) - z(n), while they shrink between a hundredth of
/// the motion's size and its rounding. It is NaN if these are too few, or if they do not follow one multiplier or a
/// pair.
multiplier multiplier_find(const section *all, int period, double size, double rounding);

#endif
