/// Distances of states at sections.
#ifndef ORBIT_SECTION_DISTANCE_H
#define ORBIT_SECTION_DISTANCE_H

#include <stddef.h>

#include "whirl/engine/orbit.h"

/// Returns the distance of two states [dimension], over the largest coordinate of the first, without coordinates that
/// turn.
double states_distance(const whirl_system *system, const double *a, const double *b);

/// Returns the distance between sections of an orbit, in numbers of its nodes; an orbit with a free period has one
/// section.
size_t orbit_stride(const whirl_orbit *orbit);

#endif
