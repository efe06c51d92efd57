// The saltation matrix. A perturbed motion meets the switch slightly earlier or later, and has the slope of the other
// side in between.
#include "saltation.h"

#include <math.h>

static double saltation_dot(size_t n, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

double saltate(size_t dimension, const double *before, const double *after, const double *gradient, double by_time,
               size_t count, double *perturbations) {
    const double rate = saltation_dot(dimension, gradient, before) + by_time;
    if (!(fabs(rate) > 0.0)) return 0.0;
    for (size_t k = 0; k < count; k++) {
        double *u = perturbations + k * dimension;
        const double earlier = saltation_dot(dimension, gradient, u) / rate;
        for (size_t i = 0; i < dimension; i++) u[i] += (after[i] - before[i]) * earlier;
    }
    return log(fabs((saltation_dot(dimension, gradient, after) + by_time) / rate));
}
