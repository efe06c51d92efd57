/// Machines side by side in vector lanes, beside each of them alone.
#ifndef SUPPORT_LANES_H
#define SUPPORT_LANES_H

#include <stddef.h>

#include "whirl/rotor.h"

/// Carries `count` rotors [count] of one structure from rest over revolutions, by `method`: each alone, and all in the
/// lanes of every instruction set `sets` (ended by NULL) that this processor has, which must give the same bits. The
/// largest difference of a coordinate between the two.
double compare_lanes_with_alone(const char *method, const char *const *sets, whirl_rotor *const *rotors, size_t count,
                                int revolutions);

#endif
