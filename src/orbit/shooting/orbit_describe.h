/// Orbits in memory.
#ifndef ORBIT_ORBIT_DESCRIBE_H
#define ORBIT_ORBIT_DESCRIBE_H

#include <stddef.h>

#include "shooting.h"
#include "whirl/engine/orbit.h"

/// Makes the orbit of nodes whose segments have just been carried with derivatives. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT if
/// the motion leaves its bounds.
whirl_status orbit_describe(shooting *s, const double *nodes, double period, double residual, whirl_orbit **out);

/// Returns the index of the trivial multiplier of an orbit with a free period, or SIZE_MAX for other orbits.
size_t orbit_own_multiplier(const whirl_orbit *orbit);

#endif
