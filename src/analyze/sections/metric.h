/// Norm in which a linear map shrinks every vector.
#ifndef ANALYZE_METRIC_H
#define ANALYZE_METRIC_H

#include <stdbool.h>
#include <stddef.h>

/// For a map m [n][n] whose eigenvalues are all within the unit circle: p = sum over j of (m^j)' m^j, so that |v|^2 =
/// v' p v shrinks by v' v with every step, whatever directions grow for a while (Lyapunov 1892; the sum by doubling).
/// *shrinks is the least share by which a step shortens a vector. `room` has 3 n^2 numbers. False if m does not shrink,
/// or too slowly for the sum to converge, and without memory.
bool metric_make(size_t n, const double *m, double *p, double *shrinks, double *room);

/// Returns the length of v [n] in that norm.
double metric_length(size_t n, const double *p, const double *v);

#endif
