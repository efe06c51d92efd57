#include "matrix_balance.h"

#include <math.h>
#include <stdbool.h>

/// Computes the sums of moduli of row and column i, without the diagonal.
static void off_diagonal_sums(size_t n, const double *a, size_t i, double *row, double *column) {
    *row = *column = 0.0;
    for (size_t k = 0; k < n; k++) {
        if (k == i) continue;
        *row += fabs(a[i * n + k]);
        *column += fabs(a[k * n + i]);
    }
}

void matrix_balance(size_t n, double *a, double *scale) {
    enum { MAX_SWEEPS = 32 };
    bool changed = true;
    for (size_t i = 0; scale && i < n; i++) scale[i] = 1.0;
    for (int sweep = 0; sweep < MAX_SWEEPS && changed; sweep++) {
        changed = false;
        for (size_t i = 0; i < n; i++) {
            double row, column;
            off_diagonal_sums(n, a, i, &row, &column);
            if (!(row > 0.0) || !(column > 0.0) || !isfinite(row) || !isfinite(column)) continue;
            // With the power of two nearest to sqrt(row / column), column * factor and row / factor are alike.
            const double factor = exp2(round(0.5 * log2(row / column)));
            if (column * factor + row / factor >= 0.95 * (row + column)) continue;
            for (size_t k = 0; k < n; k++) {
                a[i * n + k] /= factor;
                a[k * n + i] *= factor;
            }
            if (scale) scale[i] *= factor;
            changed = true;
        }
    }
}

double matrix_norm(size_t n, const double *a) {
    double largest_row = 0.0, largest_column = 0.0;
    for (size_t i = 0; i < n; i++) {
        double row, column;
        off_diagonal_sums(n, a, i, &row, &column);
        largest_row = fmax(largest_row, row + fabs(a[i * n + i]));
        largest_column = fmax(largest_column, column + fabs(a[i * n + i]));
    }
    return fmin(largest_row, largest_column);
}
