/// The formulas of dop853_tableau.h for x'' = f(t, x, x'). The slopes of positions are velocities, which are sums of
/// accelerations themselves. So every state within a step is
///
///     q + c h v + h^2 sum_j position_j a_j,      v + h sum_j velocity_j a_j,
///
/// with accelerations a_j alone. This halves the numbers that are stored of a step.
#ifndef INTEGRATE_DOP853_SUMS_H
#define INTEGRATE_DOP853_SUMS_H

#include "dop853_tableau.h"

#include <stddef.h>

/// Several weighted sums over the same slopes; some weights may be zero.
enum { POSITION, VELOCITY, SUMS_OF_STATE, SUMS_OF_ERROR = 4, MAX_SUMS = 4 };
typedef struct slope_sums {
    size_t count;
    size_t place[DOP853_SLOPES]; ///< indices of the slopes
    double weight[DOP853_SLOPES][MAX_SUMS];
} slope_sums;

/// The weighted sums of a step.
typedef struct dop853_sums {
    slope_sums stage[DOP853_SLOPES]; ///< position and velocity at which a slope is taken; row 12 is the result
    slope_sums error; ///< errors of position and velocity by the formula of order 5, then by that of order 3
    slope_sums dense[DOP853_DENSE];   ///< the interpolant's polynomials, of position and velocity
    double dense_drift[DOP853_DENSE]; ///< factor of h v in the positions' polynomials
} dop853_sums;

/// Computes the sums; `apart` is the distance of the slopes in memory, in numbers.
void dop853_sums_fill(dop853_sums *sums, size_t apart);

#endif
