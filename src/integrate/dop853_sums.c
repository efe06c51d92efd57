#include "dop853_sums.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/// Weights that vanish by the tableau's own conditions are left as rounding.
static const double nothing = 1e-12;

static slope_sum sum_of(const double *weights, size_t count) {
    slope_sum sum = {0};
    for (size_t j = 0; j < count; j++) {
        if (fabs(weights[j]) < nothing) continue;
        sum.slope[sum.count] = j;
        sum.weight[sum.count++] = weights[j];
    }
    if (sum.count == 0) sum.count = 1; // of weight zero
    return sum;
}

/// weights of velocities as weights of accelerations: weights times the matrix of the tableau.
static void through_velocities(const double *weights, size_t count, double product[DOP853_SLOPES]) {
    memset(product, 0, DOP853_SLOPES * sizeof *product);
    for (size_t j = 0; j < count; j++)
        for (size_t k = 0; k < DOP853_SLOPES - 1; k++) product[k] += weights[j] * dop853_a[j][k];
}

/// The sums that have the rows of `weights`.
static slope_sums sums_of(const double (*weights)[DOP853_SLOPES], size_t count, size_t apart) {
    slope_sums sums = {0};
    for (size_t j = 0; j < DOP853_SLOPES; j++) {
        bool used = false;
        for (size_t i = 0; i < count; i++) used = used || fabs(weights[i][j]) >= nothing;
        if (!used) continue;
        for (size_t i = 0; i < count; i++)
            sums.weight[sums.count][i] = fabs(weights[i][j]) < nothing ? 0.0 : weights[i][j];
        sums.place[sums.count] = j * apart;
        sums.slope[sums.count++] = j;
    }
    return sums;
}

void dop853_sums_fill(dop853_sums *sums, size_t apart) {
    double rows[MAX_SUMS][DOP853_SLOPES];
    memset(sums, 0, sizeof *sums);
    for (size_t i = 1; i < DOP853_SLOPES; i++) {
        through_velocities(dop853_a[i], DOP853_SLOPES - 1, rows[0]);
        memset(rows[1], 0, sizeof rows[1]);
        memcpy(rows[1], dop853_a[i], sizeof dop853_a[i]);
        sums->stage[i] = sums_of((const double(*)[DOP853_SLOPES])rows, SUMS_OF_STAGE, apart);
    }
    memset(rows, 0, sizeof rows);
    through_velocities(dop853_e5, DOP853_STAGES, rows[0]);
    memcpy(rows[1], dop853_e5, sizeof dop853_e5);
    through_velocities(dop853_e3, DOP853_STAGES, rows[2]);
    memcpy(rows[3], dop853_e3, sizeof dop853_e3);
    sums->error = sums_of((const double(*)[DOP853_SLOPES])rows, SUMS_OF_ERROR, apart);
    for (size_t i = 0; i < DOP853_DENSE; i++) {
        sums->velocity_dense[i] = sum_of(dop853_d[i], DOP853_SLOPES);
        through_velocities(dop853_d[i], DOP853_SLOPES, rows[0]);
        sums->position_dense[i] = sum_of(rows[0], DOP853_SLOPES);
        for (size_t j = 0; j < DOP853_SLOPES; j++) sums->dense_drift[i] += dop853_d[i][j];
    }
}
