/// Balance and norms of matrices.
#ifndef BASE_MATRIX_BALANCE_H
#define BASE_MATRIX_BALANCE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Scales rows and columns by powers of two, so that their norms become similar: the eigenvalues stay to the bit, and
/// the norm approaches the largest of them (Osborne 1960; Parlett, Reinsch 1969). `a` is [n][n], row-major. An
/// eigenvector of the original matrix is that of the balanced one, component by component times scale [n] (may be
/// NULL).
void matrix_balance(size_t n, double *a, double *scale);

/// Returns the smaller of the largest row sum and the largest column sum of moduli, a bound of all eigenvalues.
double matrix_norm(size_t n, const double *a);

#ifdef __cplusplus
}
#endif

#endif
