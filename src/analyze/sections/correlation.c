// Correlation of the points of the section with those `lag` revolutions later. It decays in mixing chaos, and recurs on
// tori and periodic motions.
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "correlation.h"
#include "section.h"

/// Returns the sum over n of (z(n) - mean) . (z(n + lag) - mean), divided by the geometric mean of the sums of squares
/// of the earlier and of the later points.
static double correlation_at(const section *all, const double *mean, size_t lag) {
    const size_t d = all->dimension;
    double product = 0.0, early = 0.0, late = 0.0;
    for (size_t n = 0; n + lag < all->count; n++) {
        const double *a = all->points + n * d, *b = all->points + (n + lag) * d;
        for (size_t i = 0; i < d; i++) {
            product += (a[i] - mean[i]) * (b[i] - mean[i]);
            early += (a[i] - mean[i]) * (a[i] - mean[i]);
            late += (b[i] - mean[i]) * (b[i] - mean[i]);
        }
    }
    return early > 0.0 && late > 0.0 ? product / sqrt(early * late) : 0.0;
}

/// Returns the root mean square distance of the points from their mean.
static double correlation_spread(const section *all, const double *mean) {
    double sum = 0.0;
    for (size_t n = 0; n < all->count; n++)
        for (size_t i = 0; i < all->dimension; i++) {
            const double away = all->points[n * all->dimension + i] - mean[i];
            sum += away * away;
        }
    return sqrt(sum / (double)all->count);
}

correlation correlation_find(const section *all, double least) {
    enum { MAX_POINTS = 1000, MIN_POINTS = 64 };
    const double forgotten = 0.2; // three standard errors of the correlation of 225 independent points
    const section points = section_tail(all, MAX_POINTS);
    const size_t longest = points.count / 4;
    correlation found = {NAN, NAN};
    if (points.count < MIN_POINTS) return found;
    // Subtract the mean.
    double *mean = calloc(points.dimension, sizeof *mean);
    if (!mean) return found;
    for (size_t n = 0; n < points.count; n++)
        for (size_t i = 0; i < points.dimension; i++)
            mean[i] += points.points[n * points.dimension + i] / (double)points.count;
    // Find the last lag with a significant correlation, and the largest at long lags.
    size_t last = 0; // last lag with a significant correlation
    const bool moves = correlation_spread(&points, mean) > least;
    found.late = moves ? 0.0 : NAN;
    for (size_t lag = 1; lag <= longest && moves; lag++) {
        const double size = fabs(correlation_at(&points, mean, lag));
        if (size > forgotten) last = lag;
        if (lag > longest / 2) found.late = fmax(found.late, size);
    }
    if (moves && last <= longest / 2) found.time = (double)(last + 1);
    free(mean);
    return found;
}
