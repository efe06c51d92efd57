/// Test functions of an orbit, which vanish at special points.
#ifndef ORBIT_VANISHING_H
#define ORBIT_VANISHING_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

/// Returns the test function of a kind. For orbits these are products: at folds and crossings of branches of
/// (multiplier - 1), at doublings of (multiplier + 1), at Neimark-Sacker points of (product of two multipliers - 1);
/// each factor is divided by its possible size. For equilibria they are the products of eigenvalues, and of sums of two
/// eigenvalues. For grazes it is the extreme of the switching function nearest to zero.
double vanishing_value(whirl_special kind, size_t touch, const whirl_orbit *orbit);

/// Finds the two multipliers whose product is nearest to 1, or the two eigenvalues whose sum is nearest to 0. Returns
/// false if they are real. *angle is as in whirl_branch_point.
bool vanishing_pair(const whirl_orbit *orbit, double *angle);

#endif
