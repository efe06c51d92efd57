/// Dense equations of tests that check the library against matrices of their own.
#ifndef SUPPORT_DENSE_H
#define SUPPORT_DENSE_H

#include <complex.h>
#include <stddef.h>

/// Solves a x = b [n], in place of both, by elimination with row exchanges; rows of a are `width` numbers apart.
void solve_dense(size_t n, size_t width, double complex *a, double complex *b);

#endif
