/// After how many revolutions phases come back that turn at ratios of the speed.
#ifndef ROTOR_REPEATS_H
#define ROTOR_REPEATS_H

#include "whirl/engine/system.h"

/// The smallest q up to WHIRL_MAX_REPEATS for which q times `ratio` is whole, to rounding; 0 where there is none.
size_t repeats_of(double ratio);

/// For two phases that come back after a and b revolutions (0: never).
size_t repeats_of_both(size_t a, size_t b);

#endif
