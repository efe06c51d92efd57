/// The 0-1 test for chaos of a section.
#ifndef ANALYZE_ZERO_ONE_H
#define ANALYZE_ZERO_ONE_H

#include "section.h"

/// Least number of points.
enum { ZERO_ONE_MIN = 100 };

/// Returns K of the 0-1 test for chaos over the last 4000 points: near 1 in chaos, near 0 for regular motion (possibly
/// negative). `size` is that of the motion. NaN for fewer than ZERO_ONE_MIN points, or if nothing moves.
double zero_one_test(const section *all, double size);

#endif
