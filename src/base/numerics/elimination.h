/// Elimination with row exchanges that skips zeros, for mostly zero matrices (those of an orbit's segments, one after
/// the other), and for many right-hand sides one after the other.
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
