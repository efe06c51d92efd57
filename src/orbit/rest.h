/// The equations of an equilibrium, in the place of an orbit's.
#ifndef ORBIT_REST_H
#define ORBIT_REST_H

#include "shooting.h"

/// Writes what the forces come to at a node, of what does not turn: slope [kept]; with `derivatives` the matrix becomes
/// its Jacobian and the volume its trace. False where it is not finite.
bool rest_slope(shooting *s, const double *node, double *slope, bool derivatives);

/// The largest of the slope, over what the Jacobian makes of the node's largest coordinate.
double rest_size(const shooting *s, const double *node, const double *slope);

#endif
