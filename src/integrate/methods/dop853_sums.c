#include "dop853_sums.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/// Size below which weights are 0: they vanish by the tableau's own conditions, and are rounding.
static const double nothing = 1e-12;

/// Converts weights of velocities to weights of accelerations: multiplies them by the matrix of the tableau.
static void through_velocities(const double *weights, size_t count, double product[DOP853_SLOPES]) {
    memset(product, 0, DOP853_SLOPES * sizeof *product);
    for (size_t j = 0; j < count; j++)
        for (size_t k = 0; k < DOP853_SLOPES - 1; k++) product[k] += weights[j] * dop853_a[j][k];
}

/// Returns the sums whose weights are the rows of `weights`, without slopes that no row uses.
static slope_sums sums_of(const double (*weights)[DOP853_SLOPES], size_t count, size_t apart) {
    slope_sums sums = {0};
    for (size_t j = 0; j < DOP853_SLOPES; j++) {
        bool used = false;
        for (size_t i = 0; i < count; i++) used = used || fabs(weights[i][j]) >= nothing;
        if (!used) continue;
        for (size_t i = 0; i < count; i++)
            sums.weight[sums.count][i] = fabs(weights[i][j]) < nothing ? 0.0 : weights[i][j];
        sums.place[sums.count++] = j * apart;
    }
    return sums;
}

/// Writes two rows: the weights [count] of accelerations for positions, and those for velocities.
static void put_state(const double *weights, size_t count, double rows[SUMS_OF_STATE][DOP853_SLOPES]) {
    through_velocities(weights, count, rows[POSITION]);
    memset(rows[VELOCITY], 0, sizeof rows[VELOCITY]);
    memcpy(rows[VELOCITY], weights, count * sizeof *weights);
}

void dop853_sums_fill(dop853_sums *sums, size_t apart) {
    double rows[MAX_SUMS][DOP853_SLOPES];
    memset(sums, 0, sizeof *sums);
    for (size_t i = 1; i < DOP853_SLOPES; i++) {
        put_state(dop853_a[i], DOP853_SLOPES - 1, rows);
        sums->stage[i] = sums_of((const double(*)[DOP853_SLOPES])rows, SUMS_OF_STATE, apart);
    }
    put_state(dop853_e5, DOP853_STAGES, rows);
    put_state(dop853_e3, DOP853_STAGES, rows + SUMS_OF_STATE);
    sums->error = sums_of((const double(*)[DOP853_SLOPES])rows, SUMS_OF_ERROR, apart);
    for (size_t i = 0; i < DOP853_DENSE; i++) {
        put_state(dop853_d[i], DOP853_SLOPES, rows);
        sums->dense[i] = sums_of((const double(*)[DOP853_SLOPES])rows, SUMS_OF_STATE, apart);
        for (size_t j = 0; j < DOP853_SLOPES; j++) sums->dense_drift[i] += dop853_d[i][j];
    }
}
