/// Observation of one motion, instant after instant.
#ifndef INTEGRATE_WATCH_H
#define INTEGRATE_WATCH_H

#include <math.h>

#include "whirl/engine/ensemble.h"

/// Returns the initial value of a fold.
static inline double fold_none(whirl_fold fold) {
    return fold == WHIRL_LARGEST ? -(double)INFINITY : fold == WHIRL_SMALLEST ? (double)INFINITY : 0.0;
}

/// Returns the final value of a fold; share: 1 divided by the number of instants.
static inline double fold_end(whirl_fold fold, bool square, double folded, double share) {
    const double value = fold == WHIRL_MEAN ? folded * share : folded;
    return square ? sqrt(value) : value;
}

/// Adds the state x to the observations, whose numbers lie `stride` apart. touching [contact_count], with the same
/// stride, is 1 for contacts that were closed at the previous instant; it is set to the present instant.
void watch_instant(const whirl_system *system, const double *x, size_t stride, const whirl_ensemble_seen *seen,
                   double *touching);

#endif
