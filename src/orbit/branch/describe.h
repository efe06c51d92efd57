/// Orbits in memory.
#ifndef ORBIT_DESCRIBE_H
#define ORBIT_DESCRIBE_H

#include "shooting.h"

/// The orbit of nodes whose segments have just been carried with derivatives. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT where it
/// cannot be followed.
whirl_status orbit_describe(shooting *s, const double *nodes, double period, double residual, whirl_orbit **out);

/// The multiplier that shifts along the orbit have, of an orbit with a time of its own; SIZE_MAX of others.
size_t orbit_own_multiplier(const whirl_orbit *orbit);

#endif
