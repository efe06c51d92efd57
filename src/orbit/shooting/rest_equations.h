/// The equations of an equilibrium, which replace those of an orbit.
#ifndef ORBIT_REST_EQUATIONS_H
#define ORBIT_REST_EQUATIONS_H

#include <stdbool.h>

#include "shooting.h"

/// Writes the accelerations at a node of the coordinates that do not turn: slope [kept]. With `derivatives`, the matrix
/// becomes their Jacobian, and the volume its trace. Returns false if they are not finite.
bool rest_slope(shooting *s, const double *node, double *slope, bool derivatives);

/// Returns the largest row sum of the Jacobian.
double rest_rate(const shooting *s);

/// Returns the largest number of the slope [kept], divided by rate times size, the slope that a coordinate of this size
/// has through a Jacobian of this rate.
double rest_size(const shooting *s, const double *slope, double size, double rate);

#endif
