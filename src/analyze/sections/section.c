#include "section.h"

#include <math.h>
#include <string.h>

#include "matrix.h"

section section_tail(const section *all, size_t count) {
    if (count > all->count) count = all->count;
    return (section){count, all->dimension, all->points + (all->count - count) * all->dimension};
}

double section_distance(const section *all, size_t a, size_t b) {
    const double *p = all->points + a * all->dimension, *q = all->points + b * all->dimension;
    double sum = 0.0;
    for (size_t i = 0; i < all->dimension; i++) sum += (p[i] - q[i]) * (p[i] - q[i]);
    return sqrt(sum);
}

static double largest_coordinate(const whirl_record *record) {
    double largest = 0.0;
    for (size_t i = 0; i < record->dimension; i++)
        largest = fmax(largest, fmax(fabs(record->low[i]), fabs(record->high[i])));
    return largest;
}

double motion_size(const whirl_record *record) {
    double squares = 0.0;
    for (size_t i = 0; i < record->dimension; i++) {
        const double half = 0.5 * (record->high[i] - record->low[i]);
        squares += half * half;
    }
    return fmax(sqrt(squares), fmax(1e-6 * largest_coordinate(record), 1e-12));
}

double motion_rounding(const whirl_record *record) {
    return fmax(1e-12 * largest_coordinate(record), 1e-18) / motion_size(record);
}

// ---------------------------------------------------------------- metric

/// out = a b, or a' b.
static void section_multiply(size_t n, const double *a, bool transposed, const double *b, double *out) {
    memset(out, 0, n * n * sizeof *out);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            const double factor = transposed ? a[k * n + i] : a[i * n + k];
            for (size_t j = 0; j < n; j++) out[i * n + j] += factor * b[k * n + j];
        }
}

/// Adds (power)' p power to p; returns true if that changed it. *finite: the sum is a number.
static bool add_further(size_t n, const double *power, double *p, double *room, bool *finite) {
    double most = 0.0, added = 0.0;
    section_multiply(n, p, false, power, room);
    section_multiply(n, power, true, room, room + n * n);
    for (size_t i = 0; i < n * n; i++) {
        most = fmax(most, fabs(p[i]));
        added = fmax(added, fabs(room[n * n + i]));
        p[i] += room[n * n + i];
    }
    *finite = isfinite(added);
    return *finite && added > 1e-17 * most;
}

bool metric_make(size_t n, const double *m, double *p, double *shrinks, double *room) {
    enum { MAX_DOUBLINGS = 24 };
    const size_t size = n * n;
    double *power = room;
    bool finite = true;
    int k = 0;
    memcpy(power, m, size * sizeof *m);
    for (size_t i = 0; i < size; i++) p[i] = i % (n + 1) == 0 ? 1.0 : 0.0;
    while (k < MAX_DOUBLINGS && add_further(n, power, p, room + size, &finite)) {
        section_multiply(n, power, false, power, room + size);
        memcpy(power, room + size, size * sizeof *power);
        k++;
    }
    if (!finite || k == MAX_DOUBLINGS) return false;
    memcpy(power, p, size * sizeof *p);
    if (!matrix_symmetric_modes(n, power, NULL, room + size, room + 2 * size)) return false;
    *shrinks = 1.0 - sqrt(fmax(1.0 - 1.0 / room[size + n - 1], 0.0));
    return true;
}

double metric_length(size_t n, const double *p, const double *v) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) sum += v[i] * p[i * n + k] * v[k];
    return sqrt(fmax(sum, 0.0));
}
