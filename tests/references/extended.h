/// Functions that the programs in extended precision share. Define N, the number of coordinates of a state, before.
#ifndef REFERENCES_EXTENDED_H
#define REFERENCES_EXTENDED_H

#include <complex.h>
#include <math.h>
#include <string.h>

typedef long double real;

static const real pi = 3.141592653589793238462643383279502884L;

/// Solves matrix x = right in place of right, n of them; the determinant.
static real solve(real matrix[N + 1][N + 1], real *right, int n) {
    real determinant = 1.0L;
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++)
            if (fabsl(matrix[i][k]) > fabsl(matrix[pivot][k])) pivot = i;
        if (pivot != k) determinant = -determinant;
        for (int j = 0; j < n; j++) {
            const real other = matrix[k][j];
            matrix[k][j] = matrix[pivot][j], matrix[pivot][j] = other;
        }
        const real other = right[k];
        right[k] = right[pivot], right[pivot] = other;
        determinant *= matrix[k][k];
        for (int i = k + 1; i < n; i++) {
            const real factor = matrix[i][k] / matrix[k][k];
            for (int j = k; j < n; j++) matrix[i][j] -= factor * matrix[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) right[i] -= matrix[i][j] * right[j];
        right[i] /= matrix[i][i];
    }
    return determinant;
}

/// Computes the characteristic polynomial z^N + c[N - 1] z^(N - 1) + ... + c[0] of a matrix, whose last column is left
/// out, from the traces of its powers (Newton's identities).
static void characteristic(const real matrix[N][N + 1], real c[N]) {
    real power[N][N], next[N][N], trace[N + 1];
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) power[i][j] = matrix[i][j];
    for (int k = 1; k <= N; k++) {
        trace[k] = 0.0L;
        for (int i = 0; i < N; i++) trace[k] += power[i][i];
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                next[i][j] = 0.0L;
                for (int l = 0; l < N; l++) next[i][j] += power[i][l] * matrix[l][j];
            }
        memcpy(power, next, sizeof power);
    }
    for (int k = 1; k <= N; k++) {
        real sum = trace[k];
        for (int l = 1; l < k; l++) sum += c[N - l] * trace[k - l];
        c[N - k] = -sum / k;
    }
}

/// Computes the zeros of that polynomial (Durand, Kerner).
static void find_zeros(const real c[N], long double complex z[N]) {
    for (int i = 0; i < N; i++) z[i] = cpowl(0.4L + 0.9L * I, i);
    for (int n = 0; n < 1000; n++)
        for (int i = 0; i < N; i++) {
            long double complex value = 1.0L;
            for (int k = N - 1; k >= 0; k--) value = value * z[i] + c[k];
            for (int j = 0; j < N; j++)
                if (j != i) value /= z[i] - z[j];
            z[i] -= value;
        }
}

static void exchange(long double complex *a, long double complex *b) {
    const long double complex other = *a;
    *a = *b, *b = other;
}

#endif
