/// Elimination with row exchanges that skips zeros, for matrices that are mostly zero, such as those of shooting over
/// several segments of an orbit. A matrix is decomposed once for any number of right-hand sides.
#ifndef BASE_ELIMINATION_H
#define BASE_ELIMINATION_H

#include <stdbool.h>
#include <stddef.h>

/// Decomposes a [n][n], row-major, in place; order [n] are the rows exchanged. False if a number is not finite or a
/// pivot vanishes.
bool elimination_decompose(size_t n, double *a, size_t *order);

/// Solves for b [n], which becomes the solution.
void elimination_solve(size_t n, const double *a, const size_t *order, double *b);

#endif
