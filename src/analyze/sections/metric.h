/// Norm in which a linear map shrinks every vector.
#ifndef ANALYZE_METRIC_H
#define ANALYZE_METRIC_H

#include <stdbool.h>
#include <stddef.h>

/// Computes for a map m [n][n] whose eigenvalues are all within the unit circle the matrix p = sum over j of (m^j)'
/// m^j. In its norm, |v|^2 = v' p v, every step shortens every vector: |v|^2 falls by v' v, even in directions in which
/// the Euclidean length grows for a while (Lyapunov 1892; the sum is computed by doubling). *shrinks receives the least
/// share by which a step shortens a vector. `work` has 3 n^2 numbers. Returns false if m does not shrink, if it shrinks
/// too slowly for the sum to converge, and without memory.
bool metric_make(size_t n, const double *m, double *p, double *shrinks, double *work);

/// Returns the length of v [n] in that norm.
double metric_length(size_t n, const double *p, const double *v);

#endif
