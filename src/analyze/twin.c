// The growth of a small disturbance (Benettin et al. 1980), by a second trajectory that is drawn back every revolution.
#include "twin.h"

#include <float.h>
#include <math.h>

/// Size of the disturbance relative to the state: far above rounding, far below anything that matters.
static const double disturbance_size = 1e-8;

static double norm(const double *x, size_t count) {
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) sum += x[i] * x[i];
    return sqrt(sum);
}

static void twin_place(trajectory_twin *twin, const double *x) {
    for (size_t i = 0; i < twin->dimension; i++) twin->x[i] = x[i] + twin->distance / sqrt((double)twin->dimension);
}

void twin_begin(trajectory_twin *twin, const double *x) {
    const double size = norm(x, twin->dimension);
    twin->distance = disturbance_size * (size > 1e-12 ? size : 1.0);
    twin_place(twin, x);
}

double twin_growth(trajectory_twin *twin, const double *x, bool bounded) {
    double distance = 0.0;
    for (size_t i = 0; i < twin->dimension; i++) {
        const double d = twin->x[i] - x[i];
        distance += d * d;
    }
    distance = sqrt(distance);
    const bool lost = !(distance > DBL_EPSILON * norm(x, twin->dimension));
    if (lost || !bounded || !isfinite(distance)) {
        twin_place(twin, x);
        return lost && bounded ? log(DBL_EPSILON / disturbance_size) : -log(disturbance_size);
    }
    const double factor = twin->distance / distance;
    for (size_t i = 0; i < twin->dimension; i++) twin->x[i] = x[i] + factor * (twin->x[i] - x[i]);
    return log(distance / twin->distance);
}
