#include "balance_equations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

void balance_add(balance_normal *of, const double complex *a, double complex b, double weight) {
    for (size_t i = 0; i < of->n; i++) {
        of->side[i] += weight * conj(a[i]) * b;
        for (size_t j = 0; j < of->n; j++) of->matrix[i][j] += weight * conj(a[i]) * a[j];
    }
}

/// Returns true if the columns are independent, from the normal equations of columns of length 1. A pivot of
/// Cholesky's method is the square of the part of a column that the columns before it do not span.
static bool are_distinct(size_t n, const double complex *matrix) {
    static const double least = 1e-10; // smallest pivot of independent columns
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
    if (!are_distinct(n, matrix)) return false;
    // A complex number is laid out as an array of two (C17, 6.2.5).
    if (!matrix_solve_complex(n, (const double *)matrix, 1, (double *)of->side)) return false;
    for (size_t i = 0; i < n; i++) of->side[i] /= scale[i];
    return true;
}

void balance_within(const balance_normal *of, const double *limits, double complex *amounts) {
    enum { MAX_SWEEPS = 100000 };
    bool within = true;
    double largest = 0.0;
    for (size_t i = 0; i < of->n; i++) {
        within = within && cabs(amounts[i]) <= limits[i];
        largest = fmax(largest, fmin(cabs(amounts[i]), limits[i]));
    }
    for (int sweep = 0; sweep < MAX_SWEEPS && !within; sweep++) {
        double change = 0.0;
        for (size_t i = 0; i < of->n; i++) {
            double complex rest = of->side[i];
            for (size_t j = 0; j < of->n; j++)
                if (j != i) rest -= of->matrix[i][j] * amounts[j];
            double complex best = rest / creal(of->matrix[i][i]);
            if (cabs(best) > limits[i]) best *= limits[i] / cabs(best);
            change = fmax(change, cabs(best - amounts[i]));
            amounts[i] = best;
        }
        within = change <= 1e-13 * largest;
    }
}

/// Computes significance as 1/sqrt(G_ii (G^-1)_ii), where G is the matrix of the normal equations.
double balance_condition(const balance_normal *of, double *significance) {
    const size_t n = of->n, all = 2 * n;
    double *square = calloc(2 * all * all + all + 1, sizeof *square);
    for (size_t i = 0; i < n; i++) significance[i] = NAN;
    if (!square) return NAN;
    double *values = square + all * all, *vectors = values + all, condition = NAN;
    // Write the Hermitian matrix A + i B as the symmetric one [A -B; B A], which has each eigenvalue twice.
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            square[i * all + j] = square[(n + i) * all + n + j] = creal(of->matrix[i][j]);
            square[(n + i) * all + j] = cimag(of->matrix[i][j]);
            square[i * all + n + j] = -cimag(of->matrix[i][j]);
        }
    if (matrix_symmetric_modes(all, square, NULL, values, vectors)) condition = sqrt(values[all - 1] / values[0]);
    for (size_t i = 0; i < n && isfinite(condition); i++) {
        balance_normal unit = *of;
        memset(unit.side, 0, sizeof unit.side);
        unit.side[i] = 1.0;
        if (balance_unknowns(&unit)) significance[i] = 1.0 / sqrt(creal(of->matrix[i][i]) * creal(unit.side[i]));
    }
    free(square);
    return condition;
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
