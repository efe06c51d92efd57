/// Functions of an orbit that vanish where it changes.
#ifndef ORBIT_VANISHING_H
#define ORBIT_VANISHING_H

#include "whirl/engine/orbit.h"

/// The function that goes through zero where an orbit is special: for folds and crossings the product of (multiplier -
/// 1), for doublings of (multiplier + 1), for pairs on the unit circle of (product of two - 1), each over what it may
/// be; of equilibria the products of eigenvalues and of sums of two. At a graze the extreme nearest to zero of that
/// touch.
double vanishing_value(whirl_special kind, size_t touch, const whirl_orbit *orbit);

/// The two multipliers whose product is nearest to 1, or eigenvalues whose sum is nearest to 0: false where they are
/// real. *angle as whirl_branch_point has it.
bool vanishing_pair(const whirl_orbit *orbit, double *angle);

#endif
