/// How far states are apart at sections.
#ifndef ORBIT_DISTANCE_H
#define ORBIT_DISTANCE_H

#include "whirl/engine/orbit.h"

/// Of two states [dimension], over the largest coordinate of the first; what turns is left out.
double states_distance(const whirl_system *system, const double *a, const double *b);

/// From one section of an orbit to the next, in numbers of its nodes; an orbit with a time of its own has one section.
size_t orbit_stride(const whirl_orbit *orbit);

#endif
