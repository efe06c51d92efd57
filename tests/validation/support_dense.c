#include "support_dense.h"

static void exchange(double complex *one, double complex *other) {
    const double complex kept = *one;
    *one = *other;
    *other = kept;
}

void solve_dense(size_t n, size_t width, double complex *a, double complex *b) {
    for (size_t k = 0; k < n; k++) {
        size_t best = k;
        for (size_t i = k + 1; i < n; i++)
            if (cabs(a[i * width + k]) > cabs(a[best * width + k])) best = i;
        for (size_t j = 0; j < n; j++) exchange(&a[k * width + j], &a[best * width + j]);
        exchange(&b[k], &b[best]);
        for (size_t i = k + 1; i < n; i++) {
            const double complex factor = a[i * width + k] / a[k * width + k];
            for (size_t j = k; j < n; j++) a[i * width + j] -= factor * a[k * width + j];
            b[i] -= factor * b[k];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++) b[k] -= a[k * width + j] * b[j];
        b[k] /= a[k * width + k];
    }
}
