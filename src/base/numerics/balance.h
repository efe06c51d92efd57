/// The size of matrices, and coordinates that make it tell most.
#ifndef BASE_BALANCE_H
#define BASE_BALANCE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Scales rows and columns by powers of two, so that their norms come near each other: the eigenvalues stay to the bit,
/// and the norm comes near the largest of them (Osborne 1960; Parlett, Reinsch 1969). `a` is [n][n], row-major.
/// An eigenvector of the matrix as it was is that of the balanced one, component by component times scale [n]; NULL
/// where nobody asks.
void matrix_balance(size_t n, double *a, double *scale);

/// The smaller of the largest row sum and the largest column sum of moduli: no eigenvalue is larger.
double matrix_norm(size_t n, const double *a);

#ifdef __cplusplus
}
#endif

#endif
