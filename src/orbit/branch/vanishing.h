/// Test functions of an orbit, which vanish at special points.
#ifndef ORBIT_VANISHING_H
#define ORBIT_VANISHING_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

/// Returns the test function of a kind. Folds and crossings: the product of (multiplier - 1); doublings: of (multiplier
/// + 1); pairs on the unit circle: of (product of two - 1); each over its possible size. Equilibria: the products of
/// eigenvalues and of sums of two. Grazes: the touch's extreme nearest to zero.
double vanishing_value(whirl_special kind, size_t touch, const whirl_orbit *orbit);

/// Finds the two multipliers whose product is nearest to 1, or eigenvalues whose sum is nearest to 0: false if they are
/// real. *angle as whirl_branch_point has it.
bool vanishing_pair(const whirl_orbit *orbit, double *angle);

#endif
