// Weighted Birkhoff averages: the mean of an observable along the motion, weighted by a smooth bump. On tori and
// periodic motions its error falls faster than any power of the number of points, in chaos only like the reciprocal of
// its square root. The agreement of two halves therefore tells these motions apart (Das, Saiki, Sander, Yorke,
// "Quantitative quasiperiodicity", Nonlinearity 30 (2017) 4111; Das, Yorke, "Super convergence of ergodic averages for
// quasiperiodic orbits", Nonlinearity 31 (2018) 491). The halves of a motion that still settles disagree as well.
#include <math.h>

#include "birkhoff.h"
#include "birkhoff_weight.h"
#include "section.h"

/// Weighted averages of one coordinate and of its square about `centre` over `count` points from `first`.
typedef struct moments {
    double mean, square;
} moments;

static moments weighted_moments(const section *all, size_t coordinate, size_t first, size_t count, double centre) {
    double weights = 0.0, sum = 0.0, squares = 0.0;
    for (size_t n = 0; n < count; n++) {
        const double w = birkhoff_weight(n, count);
        const double u = all->points[(first + n) * all->dimension + coordinate] - centre;
        weights += w;
        sum += w * u;
        squares += w * u * u;
    }
    return (moments){sum / weights, squares / weights};
}

/// Comparison of the halves over all coordinates of the section.
typedef struct comparison {
    double difference;  ///< largest of all coordinates' squared differences between the halves: of the means, over the
                        ///< variance; of the mean squares, over the squared variance
    double early, late; ///< sums of the variances of the first and of the second half
} comparison;

static double birkhoff_variance(const section *all, size_t coordinate, double *mean) {
    double sum = 0.0, squares = 0.0;
    for (size_t n = 0; n < all->count; n++) sum += all->points[n * all->dimension + coordinate];
    *mean = sum / (double)all->count;
    for (size_t n = 0; n < all->count; n++) {
        const double u = all->points[n * all->dimension + coordinate] - *mean;
        squares += u * u;
    }
    return squares / (double)all->count;
}

static void compare_halves(const section *all, size_t coordinate, double size, comparison *sums) {
    double centre;
    const double variance = birkhoff_variance(all, coordinate, &centre);
    if (!(sqrt(variance) > 1e-9 * size)) return; // the coordinate moves by rounding only
    const size_t half = all->count / 2;
    const moments early = weighted_moments(all, coordinate, 0, half, centre);
    const moments late = weighted_moments(all, coordinate, all->count - half, half, centre);
    const double mean = (late.mean - early.mean) * (late.mean - early.mean) / variance;
    const double square = (late.square - early.square) * (late.square - early.square) / (variance * variance);
    sums->difference = fmax(sums->difference, fmax(mean, square));
    sums->early += early.square - early.mean * early.mean;
    sums->late += late.square - late.mean * late.mean;
}

regularity regularity_find(const section *all, double size) {
    enum { MIN_POINTS = 16 };
    if (all->count < MIN_POINTS) return (regularity){NAN, NAN};
    comparison sums = {0};
    for (size_t i = 0; i < all->dimension; i++) compare_halves(all, i, size, &sums);
    if (!(sums.early > 0.0)) return (regularity){16.0, 1.0}; // the section is a single point
    return (regularity){fmin(16.0, -0.5 * log10(fmax(sums.difference, 1e-32))),
                        sqrt(fmax(sums.late, 0.0) / sums.early)};
}
