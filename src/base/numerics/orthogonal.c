// Householder's reflections, without a library's overhead for small matrices: products of many factors take thousands
// of them.
#include <math.h>
#include <string.h>

#include "matrix.h"

enum { TOGETHER = 4 }; ///< columns to which a reflection is applied at once

/// Applies the reflection of column k of r to the rows from k on of `count` columns, at most TOGETHER. The reflection's
/// vector has component k equal to 1, and below it the entries of the column.
static inline void reflect_some(size_t n, const double *r, size_t k, double twice, double *columns, size_t count) {
    double sum[TOGETHER];
    for (size_t c = 0; c < count; c++) sum[c] = columns[k * n + c];
    for (size_t i = k + 1; i < n; i++)
        for (size_t c = 0; c < count; c++) sum[c] += r[i * n + k] * columns[i * n + c];
    for (size_t c = 0; c < count; c++) sum[c] *= twice;
    for (size_t c = 0; c < count; c++) columns[k * n + c] -= sum[c];
    for (size_t i = k + 1; i < n; i++)
        for (size_t c = 0; c < count; c++) columns[i * n + c] -= sum[c] * r[i * n + k];
}

/// Applies the reflection of column k of r to all columns from `first` on.
static void orthogonal_reflect(size_t n, const double *r, size_t k, double *rows, size_t first) {
    double square = 1.0;
    for (size_t i = k + 1; i < n; i++) square += r[i * n + k] * r[i * n + k];
    const double twice = 2.0 / square;
    size_t j = first;
    for (; j + TOGETHER <= n; j += TOGETHER) reflect_some(n, r, k, twice, rows + j, TOGETHER);
    for (; j < n; j++) reflect_some(n, r, k, twice, rows + j, 1);
}

/// Replaces column k of r: below the diagonal by the vector of the reflection that makes these entries vanish, on it by
/// the entry that remains. A column whose entries below are 0 stays.
static void make_reflection(size_t n, double *r, size_t k) {
    const double first = r[k * n + k];
    double largest = 0.0, square = 0.0;
    for (size_t i = k; i < n; i++) largest = fmax(largest, fabs(r[i * n + k]));
    for (size_t i = k; i < n && largest > 0.0; i++) square += (r[i * n + k] / largest) * (r[i * n + k] / largest);
    const double length = largest * sqrt(square), apart = first > 0.0 ? first + length : first - length;
    for (size_t i = k + 1; i < n; i++) r[i * n + k] = apart == 0.0 ? 0.0 : r[i * n + k] / apart;
    r[k * n + k] = first > 0.0 ? -length : length;
}

bool matrix_orthogonal(size_t n, const double *a, double *q, double *r) {
    for (size_t i = 0; i < n * n; i++)
        if (!isfinite(a[i])) return false;
    memcpy(r, a, n * n * sizeof *r);
    for (size_t k = 0; k + 1 < n; k++) {
        make_reflection(n, r, k);
        orthogonal_reflect(n, r, k, r, k + 1);
    }
    for (size_t i = 0; i < n * n; i++) q[i] = i % (n + 1) == 0 ? 1.0 : 0.0;
    for (size_t k = n; k-- > 0;)
        if (k + 1 < n) orthogonal_reflect(n, r, k, q, k);
    for (size_t i = 0; i < n; i++) {
        const double sign = r[i * n + i] < 0.0 ? -1.0 : 1.0;
        for (size_t k = 0; k < i; k++) r[i * n + k] = 0.0;
        for (size_t k = i; k < n; k++) r[i * n + k] *= sign;
        for (size_t k = 0; k < n; k++) q[k * n + i] *= sign;
    }
    return true;
}
