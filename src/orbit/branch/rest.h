/// The equations of an equilibrium, in the place of an orbit's.
#ifndef ORBIT_REST_H
#define ORBIT_REST_H

#include "shooting.h"

/// Writes what the forces come to at a node, of what does not turn: slope [kept]; with `derivatives` the matrix becomes
/// its Jacobian and the volume its trace. False where it is not finite.
bool rest_slope(shooting *s, const double *node, double *slope, bool derivatives);

/// The largest sum of a row of the Jacobian.
double rest_rate(const shooting *s);

/// The largest of the slope [kept], over what a Jacobian of that rate makes of a coordinate of that size.
double rest_size(const shooting *s, const double *slope, double size, double rate);

#endif
