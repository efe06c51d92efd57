/// Dense matrices: linear equations, eigenvalues, modes. By Eigen (but for matrix_orthogonal), which is compiled for
/// the browser, too, and gives the same bits wherever IEEE arithmetic is kept, whatever the processor (of eigenvectors
/// all but the last ones, where compilers divide complex numbers in their own ways).
///
/// All matrices are row-major. Every function returns false where memory is lacking, where a number is not finite, and
/// where its own comment says so; what it was to write is then undefined. Of order 0 everything is true and nothing
/// written.
#ifndef BASE_MATRIX_H
#define BASE_MATRIX_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The modes of K v = lambda M v: k, m [n][n] symmetric (their lower triangles are read), m positive definite, or NULL
/// for 1. values [n] ascend; vectors [mode][n] have v' M v = 1, and the first of their largest components is positive.
/// By Cholesky's factors of M and the symmetric QR algorithm (Golub, Van Loan 2013, 8.3, 8.7). False where m is not
/// positive definite.
bool matrix_symmetric_modes(size_t n, const double *k, const double *m, double *values, double *vectors);

/// All eigenvalues of a [n][n], which is overwritten: real [n], imaginary [n], in no order but that the two of a pair
/// stand together, the one with the positive imaginary part first. vectors, where not NULL: [value][n][2], real and
/// imaginary parts, of Euclidean length 1, the first of their largest components real and positive. By balancing and
/// Francis' double shifts (Golub, Van Loan 2013, 7.5). False where these do not converge, or, with errno ENOMEM,
/// without memory.
bool matrix_eigen(size_t n, double *a, double *real, double *imaginary, double *vectors);

/// ... and how far rounding may have moved each, rounding [n], or NULL: the norm of the balanced matrix times the least
/// number that is seen beside 1, and, of slow ones with hardly any damping, times the condition of the eigenvalue
/// (Golub, Van Loan 2013, 7.2.2). vectors are wanted then.
bool matrix_eigen_rounding(size_t n, double *a, double *real, double *imaginary, double *vectors, double *rounding);

/// Solves A x = b for `count` right-hand sides, b [count][n], by elimination with row exchanges; b becomes x. False
/// where a pivot vanishes.
bool matrix_solve(size_t n, const double *a, size_t count, double *b);

/// ... in complex numbers: a [n][n][2], b [count][n][2], real and imaginary parts.
bool matrix_solve_complex(size_t n, const double *a, size_t count, double *b);

/// ... where a is symmetric and positive definite (its lower triangle is read), by Cholesky's factors. False where it
/// is not.
bool matrix_solve_definite(size_t n, const double *a, size_t count, double *b);

/// ... where a may be singular: the shortest x whose A x comes nearest to b, with singular directions left out that are
/// below `tolerance` times the largest (complete orthogonal decomposition). One right-hand side b [n]. Returns the rank
/// in `rank`, where not NULL.
bool matrix_solve_shortest(size_t n, const double *a, double tolerance, double *b, size_t *rank);

/// a [n][n] becomes h with a = q h q', nothing below the first subdiagonal of h and q [n][n] orthogonal (Householder's
/// reflections: Golub, Van Loan 2013, 7.4.3).
bool matrix_hessenberg(size_t n, double *a, double *q);

/// a = q r [n][n] with orthonormal columns q and r upper triangular, no number on its diagonal negative (Householder's
/// reflections: Golub, Van Loan 2013, 5.2). a and q may be one.
bool matrix_orthogonal(size_t n, const double *a, double *q, double *r);

#ifdef __cplusplus
}
#endif

#endif
