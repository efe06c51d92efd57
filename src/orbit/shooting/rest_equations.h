/// Equations of an equilibrium, used in place of an orbit's.
#ifndef ORBIT_REST_EQUATIONS_H
#define ORBIT_REST_EQUATIONS_H

#include <stdbool.h>

#include "shooting.h"

/// Writes the accelerations at a node, of coordinates that do not turn: slope [kept]; with `derivatives` the matrix
/// becomes their Jacobian and the volume its trace. False if they are not finite.
bool rest_slope(shooting *s, const double *node, double *slope, bool derivatives);

/// Returns the largest row sum of the Jacobian.
double rest_rate(const shooting *s);

/// Returns the largest of the slope [kept], relative to a Jacobian of that rate times a coordinate of that size.
double rest_size(const shooting *s, const double *slope, double size, double rate);

#endif
