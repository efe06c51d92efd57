/// What is seen of one motion, instant after instant.
#ifndef INTEGRATE_WATCH_H
#define INTEGRATE_WATCH_H

#include "whirl/ensemble.h"

/// Adds the state x to what was seen, whose numbers lie `stride` apart, as those of `touching` [contact_count] do: 1
/// where contacts were closed at the instant before, then at this one.
void watch_instant(const whirl_system *system, const double *x, size_t stride, const whirl_ensemble_seen *seen,
                   double *touching);

#endif
