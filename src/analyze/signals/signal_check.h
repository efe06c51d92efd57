/// What measured signals have to be before anything is said of them.
#ifndef ANALYZE_SIGNAL_CHECK_H
#define ANALYZE_SIGNAL_CHECK_H

#include <stddef.h>

#include "whirl/signals.h"

/// Channels [channels][count] of numbers, at least `fewest` samples each.
whirl_status signal_check_channels(const double *values, size_t count, size_t channels, size_t fewest);

/// Points [count][dimension], at least `fewest`.
whirl_status signal_check_points(const double *points, size_t count, size_t dimension, size_t fewest);

/// Instants of samples [count], which grow and leave no gap.
whirl_status signal_check_time(const double *time, size_t count);

/// At least two instants of pulses, which grow.
whirl_status signal_check_pulses(const double *instants, size_t pulses);

/// The same, and no pulse lies before or after the samples, which are at least `fewest`.
whirl_status signal_check_turns(const double *time, size_t count, size_t fewest, const double *instants, size_t pulses);

/// A size of the motion against which distances can be judged.
whirl_status signal_check_size(double size);

#endif
