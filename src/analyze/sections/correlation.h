/// Correlation of a section with its later points.
#ifndef ANALYZE_CORRELATION_H
#define ANALYZE_CORRELATION_H

#include "section.h"

/// Memory of the section: correlation over the last 1000 points.
typedef struct correlation {
    double late; ///< largest correlation (in modulus) of points between 1/8 and 1/4 of the points apart
    double time; ///< revolutions after which it stays below 0.2; NaN if it does not
} correlation;

/// Computes the correlation. It is NaN for fewer than 64 points, and if the root mean square spread is not above
/// `least`.
correlation correlation_find(const section *all, double least);

#endif
