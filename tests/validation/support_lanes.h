/// Machines side by side in vector lanes, compared with each of them alone.
#ifndef SUPPORT_LANES_H
#define SUPPORT_LANES_H

#include <stddef.h>

#include "whirl/engine/rotor.h"

/// Carries `count` rotors of one structure over revolutions from a state [dimension], in lanes and one by one by the
/// integrator, with `steps` a revolution or to rounding: where they end [count][dimension].
void carry_both(const char *method, int steps, whirl_rotor *const *rotors, size_t count, const double *start,
                int revolutions, double *in_lanes, double *alone);

/// Carries `count` rotors [count] of one structure from rest over revolutions, by `method`: each alone, and all in the
/// lanes of every instruction set `sets` (ended by NULL) that this processor has, which must give the same bits. The
/// largest difference of a coordinate between the two.
double compare_lanes_with_alone(const char *method, const char *const *sets, whirl_rotor *const *rotors, size_t count,
                                int revolutions);

#endif
