#include "dop853_sums.h"

#include <math.h>
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

/// weights [count] of velocities as weights of accelerations: weights times the matrix of the tableau.
static slope_sum through_velocities(const double *weights, size_t count) {
    double product[DOP853_SLOPES] = {0};
    for (size_t j = 0; j < count; j++)
        for (size_t k = 0; k < DOP853_SLOPES - 1; k++) product[k] += weights[j] * dop853_a[j][k];
    return sum_of(product, DOP853_SLOPES);
}

void dop853_sums_fill(dop853_sums *sums) {
    memset(sums, 0, sizeof *sums);
    for (size_t i = 0; i < DOP853_SLOPES; i++) {
        sums->velocity[i] = sum_of(dop853_a[i], DOP853_SLOPES - 1);
        sums->position[i] = through_velocities(dop853_a[i], DOP853_SLOPES - 1);
    }
    sums->velocity_error5 = sum_of(dop853_e5, DOP853_STAGES);
    sums->position_error5 = through_velocities(dop853_e5, DOP853_STAGES);
    sums->velocity_error3 = sum_of(dop853_e3, DOP853_STAGES);
    sums->position_error3 = through_velocities(dop853_e3, DOP853_STAGES);
    for (size_t i = 0; i < DOP853_DENSE; i++) {
        sums->velocity_dense[i] = sum_of(dop853_d[i], DOP853_SLOPES);
        sums->position_dense[i] = through_velocities(dop853_d[i], DOP853_SLOPES);
        for (size_t j = 0; j < DOP853_SLOPES; j++) sums->dense_drift[i] += dop853_d[i][j];
    }
}
