#include "signal_parts.h"

#include <math.h>
#include <string.h>

#include "matrix.h"

void balance_add(balance_normal *of, const double complex *a, double complex b, double weight) {
    for (size_t i = 0; i < of->n; i++) {
        of->side[i] += weight * conj(a[i]) * b;
        for (size_t j = 0; j < of->n; j++) of->matrix[i][j] += weight * conj(a[i]) * a[j];
    }
}

/// Cholesky's pivots tell how much of each unknown the ones before leave.
static bool are_told_apart(size_t n, const double complex *matrix) {
    static const double least = 1e-10; // of what remains of an unknown beside the others, in squares
    double complex rest[BALANCE_UNKNOWNS * BALANCE_UNKNOWNS];
    memcpy(rest, matrix, n * n * sizeof *rest);
    for (size_t k = 0; k < n; k++) {
        const double pivot = creal(rest[k * n + k]);
        if (!(pivot > least)) return false;
        for (size_t i = k + 1; i < n; i++)
            for (size_t j = k + 1; j < n; j++) rest[i * n + j] -= rest[i * n + k] * rest[k * n + j] / pivot;
    }
    return true;
}

bool balance_unknowns(balance_normal *of) {
    const size_t n = of->n;
    double scale[BALANCE_UNKNOWNS];
    double complex matrix[BALANCE_UNKNOWNS * BALANCE_UNKNOWNS] = {0.0};
    for (size_t i = 0; i < n; i++) {
        scale[i] = sqrt(creal(of->matrix[i][i]));
        if (!(scale[i] > 0.0)) return false;
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) matrix[i * n + j] = of->matrix[i][j] / (scale[i] * scale[j]);
        of->side[i] /= scale[i];
    }
    if (!are_told_apart(n, matrix)) return false;
    // A complex number is laid out as an array of two (C17, 6.2.5).
    if (!matrix_solve_complex(n, (const double *)matrix, 1, (double *)of->side)) return false;
    for (size_t i = 0; i < n; i++) of->side[i] /= scale[i];
    return true;
}

size_t balance_unknown_count(const whirl_balance *of) {
    return of->mode_count > 0 ? of->mode_count : of->plane_count;
}

size_t balance_mode_of(const whirl_balance *of, double speed) {
    size_t best = 0;
    for (size_t i = 1; i < of->mode_count; i++)
        if (fabs(of->modes[i].speed - speed) < fabs(of->modes[best].speed - speed)) best = i;
    return best;
}

double complex balance_effect(const whirl_correction *of, const double (*influence)[2], size_t planes, size_t unknown) {
    double complex sum = 0.0;
    if (of->set_count == 0) return balance_number(influence[unknown]);
    for (size_t p = 0; p < planes; p++) sum += balance_number(influence[p]) * balance_number(of->sets[unknown][p]);
    return sum;
}
