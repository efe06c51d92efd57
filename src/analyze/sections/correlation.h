/// Correlation of a section with its later points.
#ifndef ANALYZE_CORRELATION_H
#define ANALYZE_CORRELATION_H

#include "section.h"

/// Correlations of the last 1000 points of a section with later ones among them: how long the motion remembers a state.
typedef struct correlation {
    double late; ///< largest modulus of the correlation at lags from 1/8 to 1/4 of the number of points
    double time; ///< revolutions after which it stays below 0.2; NaN if it does not
} correlation;

/// Computes the correlation. It is NaN for fewer than 64 points, and if the root mean square spread is not above
/// `least`.
correlation correlation_find(const section *all, double least);

#endif
