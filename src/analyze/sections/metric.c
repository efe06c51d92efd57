#include "metric.h"

#include <math.h>
#include <string.h>

#include "matrix.h"

/// Computes out = a b, or a' b.
static void metric_multiply(size_t n, const double *a, bool transposed, const double *b, double *out) {
    memset(out, 0, n * n * sizeof *out);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            const double factor = transposed ? a[k * n + i] : a[i * n + k];
            for (size_t j = 0; j < n; j++) out[i * n + j] += factor * b[k * n + j];
        }
}

/// Adds (power)' p power to p; returns true if that changed it. *finite: the sum is a number.
static bool metric_add(size_t n, const double *power, double *p, double *work, bool *finite) {
    double most = 0.0, added = 0.0;
    metric_multiply(n, p, false, power, work);
    metric_multiply(n, power, true, work, work + n * n);
    for (size_t i = 0; i < n * n; i++) {
        most = fmax(most, fabs(p[i]));
        added = fmax(added, fabs(work[n * n + i]));
        p[i] += work[n * n + i];
    }
    *finite = isfinite(added);
    return *finite && added > 1e-17 * most;
}

bool metric_make(size_t n, const double *m, double *p, double *shrinks, double *work) {
    enum { MAX_DOUBLINGS = 24 };
    const size_t size = n * n;
    double *power = work;
    bool finite = true;
    int k = 0;
    memcpy(power, m, size * sizeof *m);
    for (size_t i = 0; i < size; i++) p[i] = i % (n + 1) == 0 ? 1.0 : 0.0;
    while (k < MAX_DOUBLINGS && metric_add(n, power, p, work + size, &finite)) {
        metric_multiply(n, power, false, power, work + size);
        memcpy(power, work + size, size * sizeof *power);
        k++;
    }
    if (!finite || k == MAX_DOUBLINGS) return false;
    memcpy(power, p, size * sizeof *p);
    if (!matrix_symmetric_modes(n, power, NULL, work + size, work + 2 * size)) return false;
    *shrinks = 1.0 - sqrt(fmax(1.0 - 1.0 / work[size + n - 1], 0.0));
    return true;
}

double metric_length(size_t n, const double *p, const double *v) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) sum += v[i] * p[i * n + k] * v[k];
    return sqrt(fmax(sum, 0.0));
}
