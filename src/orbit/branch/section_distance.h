/// Distances of states at sections.
#ifndef ORBIT_SECTION_DISTANCE_H
#define ORBIT_SECTION_DISTANCE_H

#include <stddef.h>

#include "whirl/engine/orbit.h"

/// Returns the distance of two states [dimension], divided by the largest coordinate of the first. Coordinates that
/// turn do not count.
double states_distance(const whirl_system *system, const double *a, const double *b);

/// Returns how many numbers of the nodes of an orbit lie between two sections. An orbit with a free period has one
/// section.
size_t orbit_stride(const whirl_orbit *orbit);

#endif
