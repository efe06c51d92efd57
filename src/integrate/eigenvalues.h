/// Eigenvalues of small real matrices, in plain C: what the explorer computes it computes without a linear algebra
/// library.
#ifndef INTEGRATE_EIGENVALUES_H
#define INTEGRATE_EIGENVALUES_H

#include <stdbool.h>
#include <stddef.h>

/// Scales rows and columns by powers of two, so that their norms come near each other: the eigenvalues stay to the bit,
/// and the norm comes near the largest of them (Osborne 1960; Parlett, Reinsch 1969). `a` is [n][n], row-major.
void matrix_balance(size_t n, double *a);

/// The smaller of the largest row sum and the largest column sum of moduli: no eigenvalue is larger.
double matrix_norm(size_t n, const double *a);

/// All eigenvalues: real [n], imaginary [n], in no order. `a` is overwritten. By Householder's reduction to
/// Hessenberg's form and Francis' implicit double shifts (Golub, Van Loan 2013, 7.4 and 7.5). False where it does not
/// converge (never met on finite matrices).
bool matrix_eigenvalues(size_t n, double *a, double *real, double *imaginary);

#endif
