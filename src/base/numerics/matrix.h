/// Dense matrices: linear equations, eigenvalues, modes. All functions but matrix_orthogonal use Eigen, in the browser,
/// too. Results have the same bits on all processors with IEEE arithmetic. Only eigenvectors may differ in their last
/// bits, because compilers divide complex numbers in different ways.
///
/// All matrices are row-major. Every function returns false without memory, if a number is not finite, and in the cases
/// that its own comment names; its output is then undefined. For order 0 all return true and write nothing.
#ifndef BASE_MATRIX_H
#define BASE_MATRIX_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Computes the modes of K v = lambda M v: k, m [n][n] symmetric (their lower triangles are read), m positive definite,
/// or NULL for 1. values [n] ascend; vectors [mode][n] have v' M v = 1, and the first of their largest components is
/// positive. By Cholesky's factors of M and the symmetric QR algorithm (Golub, Van Loan 2013, 8.3, 8.7). False if m is
/// not positive definite.
bool matrix_symmetric_modes(size_t n, const double *k, const double *m, double *values, double *vectors);

/// Computes all eigenvalues of a [n][n], which is overwritten: real [n], imaginary [n], unsorted, except that the two
/// of a pair are adjacent, positive imaginary part first. vectors, unless NULL: [value][n][2], real and imaginary
/// parts, of Euclidean length 1, the first of their largest components real and positive. By balancing and Francis'
/// double shifts (Golub, Van Loan 2013, 7.5). False if these do not converge, or, with errno ENOMEM, without memory.
bool matrix_eigen(size_t n, double *a, double *real, double *imaginary, double *vectors);

/// Computes eigenvalues like matrix_eigen. Unless NULL, rounding [n] becomes a bound of each eigenvalue's rounding
/// error: the norm of the balanced matrix times the rounding unit. For slow eigenvalues the bound is multiplied by
/// their condition (Golub, Van Loan 2013, 7.2.2). `rounding` requires `vectors`.
bool matrix_eigen_rounding(size_t n, double *a, double *real, double *imaginary, double *vectors, double *rounding);

/// Computes eigenvalues and vectors like matrix_eigen, from the inverse of a, which stays. The slowest eigenvalues are
/// the largest of the inverse, so that large numbers of a do not hide them. rounding [n]: how far one rounding of each
/// number of a may move each eigenvalue, |u'| |a| |v| times the rounding unit, with the rows u' and columns v of
/// eigenvectors, u' v = 1. False also for a singular matrix.
bool matrix_eigen_by_inverse(size_t n, const double *a, double *real, double *imaginary, double *vectors,
                             double *rounding);

/// Solves A x = b for `count` right-hand sides, b [count][n], by elimination with row exchanges; b becomes x. False if
/// a pivot vanishes.
bool matrix_solve(size_t n, const double *a, size_t count, double *b);

/// Solves in complex numbers: a [n][n][2], b [count][n][2], real and imaginary parts.
bool matrix_solve_complex(size_t n, const double *a, size_t count, double *b);

/// Solves for a symmetric and positive definite (its lower triangle is read), by Cholesky's factors. False if
/// a is not positive definite.
bool matrix_solve_definite(size_t n, const double *a, size_t count, double *b);

/// Solves for a that may be singular: b [n] becomes the least-squares solution of least norm, by a complete orthogonal
/// decomposition (Golub, Van Loan 2013, 5.5.2). The rank is the number of pivots, in a QR decomposition with exchange
/// of columns, above `tolerance` times the largest; smaller ones count as 0. Writes the rank to `rank`, unless NULL.
bool matrix_solve_shortest(size_t n, const double *a, double tolerance, double *b, size_t *rank);

/// Reduces a [n][n] to h with a = q h q', nothing below the first subdiagonal of h and q [n][n] orthogonal
/// (Householder's reflections: Golub, Van Loan 2013, 7.4.3).
bool matrix_hessenberg(size_t n, double *a, double *q);

/// Decomposes a = q r [n][n] with orthonormal columns q and r upper triangular, its diagonal not negative
/// (Householder's reflections: Golub, Van Loan 2013, 5.2). a and q may be one.
bool matrix_orthogonal(size_t n, const double *a, double *q, double *r);

#ifdef __cplusplus
}
#endif

#endif
