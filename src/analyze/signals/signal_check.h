/// Checks of measured signals before any analysis.
#ifndef ANALYZE_SIGNAL_CHECK_H
#define ANALYZE_SIGNAL_CHECK_H

#include <stddef.h>

#include "whirl/signals.h"

/// Checks channels [channels][count] of numbers, at least `fewest` samples each.
whirl_status signal_check_channels(const double *values, size_t count, size_t channels, size_t fewest);

/// Checks points [count][dimension], at least `fewest`.
whirl_status signal_check_points(const double *points, size_t count, size_t dimension, size_t fewest);

/// Checks instants of samples [count], which grow and leave no gap.
whirl_status signal_check_time(const double *time, size_t count);

/// Checks at least two instants of pulses, which grow.
whirl_status signal_check_pulses(const double *instants, size_t pulses);

/// Checks pulses and samples: none of the pulses is before or after the samples, which are at least `fewest`.
whirl_status signal_check_turns(const double *time, size_t count, size_t fewest, const double *instants, size_t pulses);

/// Checks the size of a motion, against which distances are judged.
whirl_status signal_check_size(double size);

#endif
