#include "elimination.h"

#include <math.h>

static void elimination_exchange(size_t count, double *a, double *b) {
    for (size_t i = 0; i < count; i++) {
        const double kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

static size_t find_pivot(size_t n, const double *a, size_t k) {
    size_t pivot = k;
    for (size_t i = k + 1; i < n; i++)
        if (fabs(a[i * n + k]) > fabs(a[pivot * n + k])) pivot = i;
    return pivot;
}

bool elimination_decompose(size_t n, double *a, size_t *order) {
    for (size_t i = 0; i < n * n; i++)
        if (!isfinite(a[i])) return false;
    for (size_t k = 0; k < n; k++) {
        const double *from = a + k * n;
        order[k] = find_pivot(n, a, k);
        if (order[k] != k) elimination_exchange(n, a + k * n, a + order[k] * n);
        if (!(fabs(from[k]) > 0.0)) return false;
        for (size_t i = k + 1; i < n; i++) {
            double *row = a + i * n;
            if (row[k] == 0.0) continue;
            const double share = row[k] /= from[k];
            for (size_t j = k + 1; j < n; j++) row[j] -= share * from[j];
        }
    }
    return true;
}

void elimination_solve(size_t n, const double *a, const size_t *order, double *b) {
    for (size_t k = 0; k < n; k++) elimination_exchange(1, b + k, b + order[k]);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < i; k++) b[i] -= a[i * n + k] * b[k];
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; k++) b[i] -= a[i * n + k] * b[k];
        b[i] /= a[i * n + i];
    }
}
