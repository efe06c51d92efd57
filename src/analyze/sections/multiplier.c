// The largest Floquet multiplier of a periodic motion, from how the section settles: close to the orbit, d(n) = z(n +
// k) - z(n) obeys d(n + k) = mu d(n) for a real multiplier, and d(n + 2k) = a d(n + k) - b d(n) for a pair with the sum
// a and the product b.
#include <math.h>
#include <stdbool.h>

#include "multiplier.h"
#include "section.h"

enum { MIN_RETURNS = 12, MAX_RETURNS = 64 };

static double multiplier_coordinate(const section *all, size_t n, size_t k, size_t i) {
    return all->points[(n + k) * all->dimension + i] - all->points[n * all->dimension + i];
}

/// Sums of the products of d(n), d(n + k) and d(n + 2k) over all returns n; the products of each n are divided by
/// |d(n)|^2.
typedef struct products {
    size_t count;
    double p[3][3];
} products;

static void add_return(const section *all, size_t n, size_t k, double square, products *sums) {
    for (size_t i = 0; i < all->dimension; i++) {
        double d[3];
        for (size_t j = 0; j < 3; j++) d[j] = multiplier_coordinate(all, n + j * k, k, i);
        for (size_t a = 0; a < 3; a++)
            for (size_t b = 0; b < 3; b++) sums->p[a][b] += d[a] * d[b] / square;
    }
    sums->count++;
}

/// Collects the last returns that are small enough to be linear and large enough not to be rounding.
static products multiplier_collect(const section *all, size_t k, double size, double rounding) {
    const double most = 1e-2 * size, least = fmin(1e3 * rounding, 1e-4) * size;
    products sums = {0};
    for (size_t end = all->count; end > 3 * k && sums.count < MAX_RETURNS; end--) {
        const size_t n = end - 1 - 3 * k;
        const double first = section_distance(all, n, n + k), last = section_distance(all, n + 2 * k, n + 3 * k);
        if (first <= most && last >= least) add_return(all, n, k, first * first, &sums);
    }
    return sums;
}

multiplier multiplier_find(const section *all, int period, double size, double rounding) {
    const double well_fit = 1e-4; // share of the squares that may stay unexplained
    const multiplier none = {NAN, NAN};
    if (period < 1) return none;
    const products s = multiplier_collect(all, (size_t)period, size, rounding);
    if (s.count < MIN_RETURNS) return none;
    const double mu = s.p[0][1] / s.p[0][0];
    if (s.p[1][1] - mu * s.p[0][1] <= well_fit * s.p[1][1]) return (multiplier){mu, 0.0};
    // Solve the normal equations of d2 = a d1 - b d0.
    const double determinant = s.p[1][1] * s.p[0][0] - s.p[0][1] * s.p[0][1];
    const double a = (s.p[1][2] * s.p[0][0] - s.p[0][2] * s.p[0][1]) / determinant;
    const double b = (s.p[1][2] * s.p[0][1] - s.p[0][2] * s.p[1][1]) / determinant;
    const double left = s.p[2][2] - a * s.p[1][2] + b * s.p[0][2];
    if (!(left <= well_fit * s.p[2][2])) return none;
    const double discriminant = 0.25 * a * a - b;
    if (discriminant < 0.0) return (multiplier){0.5 * a, sqrt(-discriminant)};
    return (multiplier){0.5 * a + (a < 0.0 ? -1.0 : 1.0) * sqrt(discriminant), 0.0};
}
