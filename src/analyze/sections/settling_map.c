// The linear map that a slow section follows. Close to an orbit of one revolution the step from each point of the
// section to the next obeys d(n + 1) = M d(n), whatever modes are decaying together. M is fitted by least squares in
// the few directions of d (dynamic mode decomposition: Schmid, J. Fluid Mech. 656 (2010) 5; Tu et al., J. Comput. Dyn.
// 1 (2014) 391). Its largest multiplier gives the settling rate long before the motion returns. Fits to the two halves
// of the section show whether M stays the same. See docs/theory.md, "Slow motions".
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"
#include "section.h"
#include "settling_map.h"

enum { MAX_DIRECTIONS = 10, MAX_DIMENSION = 128, MIN_A_DIRECTION = 6 };

/// Directions smaller than this part of the largest one, or than this number of roundings, are noise.
static const double least_direction = 1e-5, least_roundings = 1e3;

/// Fit of the map to some points.
typedef struct fit {
    double rate;     ///< natural logarithm of the largest multiplier's modulus; NaN without a map
    double residual; ///< unexplained part of the steps, root of squares
} fit;

/// Returns the step from point n to the next one, along coordinate i.
static double step_along(const section *all, size_t n, size_t i) {
    return all->points[(n + 1) * all->dimension + i] - all->points[n * all->dimension + i];
}

/// Finds the main directions of the steps: unit vectors [count][dimension] into `axes`, their sizes into `sizes`.
/// `work` has 2 dimension^2 + dimension numbers.
static size_t main_directions(const section *all, double least, double *axes, double *sizes, double *work) {
    const size_t d = all->dimension, steps = all->count - 1;
    double *square = work, *vectors = work + d * d, *values = vectors + d * d;
    memset(square, 0, d * d * sizeof *square);
    for (size_t n = 0; n < steps; n++)
        for (size_t i = 0; i < d; i++)
            for (size_t k = 0; k <= i; k++) square[i * d + k] += step_along(all, n, i) * step_along(all, n, k);
    if (!matrix_symmetric_modes(d, square, NULL, values, vectors)) return 0;
    const double largest = sqrt(fmax(values[d - 1], 0.0) / (double)steps);
    size_t count = 0;
    while (count < d && count < MAX_DIRECTIONS && (count + 1) * MIN_A_DIRECTION <= steps) {
        const double size = sqrt(fmax(values[d - 1 - count], 0.0) / (double)steps);
        if (!(size > fmax(least_direction * largest, least))) break;
        memcpy(axes + count * d, vectors + (d - 1 - count) * d, d * sizeof *axes);
        sizes[count++] = size;
    }
    return count;
}

/// Projects step n on the main directions, each over its size: out [count].
static void settling_map_project(const section *all, size_t n, size_t count, const double *axes, const double *sizes,
                                 double *out) {
    for (size_t k = 0; k < count; k++) {
        out[k] = 0.0;
        for (size_t i = 0; i < all->dimension; i++) out[k] += axes[k * all->dimension + i] * step_along(all, n, i);
        out[k] /= sizes[k];
    }
}

/// Fits the map from step to step by least squares, map [count][count]. Returns the largest unexplained share of a
/// step.
static double fit_map(const section *all, size_t count, const double *axes, const double *sizes, double *map) {
    double square[MAX_DIRECTIONS * MAX_DIRECTIONS] = {0}, product[MAX_DIRECTIONS * MAX_DIRECTIONS] = {0};
    double now[MAX_DIRECTIONS], next[MAX_DIRECTIONS], left = 0.0, whole = 0.0;
    const size_t pairs = all->count - 2;
    // Sum the normal equations over all pairs of successive points.
    for (size_t n = 0; n < pairs; n++) {
        settling_map_project(all, n, count, axes, sizes, now);
        settling_map_project(all, n + 1, count, axes, sizes, next);
        for (size_t i = 0; i < count; i++)
            for (size_t k = 0; k < count; k++) {
                square[i * count + k] += now[i] * now[k];
                product[i * count + k] += next[i] * now[k];
            }
    }
    // Solve them.
    if (!matrix_solve(count, square, count, product)) return INFINITY;
    memcpy(map, product, count * count * sizeof *map);
    // Compute the share of steps that the map does not explain.
    for (size_t n = 0; n < pairs; n++) {
        settling_map_project(all, n, count, axes, sizes, now);
        settling_map_project(all, n + 1, count, axes, sizes, next);
        for (size_t i = 0; i < count; i++) {
            double away = next[i];
            for (size_t k = 0; k < count; k++) away -= map[i * count + k] * now[k];
            left += sizes[i] * sizes[i] * away * away;
            whole += sizes[i] * sizes[i] * next[i] * next[i];
        }
    }
    return sqrt(left / whole);
}

static fit fit_points(const section *all, double least, double *work) {
    double sizes[MAX_DIRECTIONS], map[MAX_DIRECTIONS * MAX_DIRECTIONS], real[MAX_DIRECTIONS], imaginary[MAX_DIRECTIONS];
    double *axes = work, largest = 0.0;
    const size_t count = main_directions(all, least, axes, sizes, work + MAX_DIRECTIONS * all->dimension);
    if (count == 0) return (fit){NAN, NAN};
    const double residual = fit_map(all, count, axes, sizes, map);
    if (!isfinite(residual) || !matrix_eigen(count, map, real, imaginary, NULL)) return (fit){NAN, NAN};
    for (size_t k = 0; k < count; k++) largest = fmax(largest, hypot(real[k], imaginary[k]));
    return (fit){log(largest), residual};
}

settling_map settling_map_find(const section *all, double size, double rounding) {
    enum { MIN_POINTS = 48 };
    const double well_fit = 1e-2;
    const size_t d = all->dimension, half = all->count / 2;
    settling_map found = {{NAN, NAN}, NAN, NAN};
    if (all->count < MIN_POINTS || d > MAX_DIMENSION) return found;
    double *work = malloc((MAX_DIRECTIONS * d + 2 * d * d + d) * sizeof *work);
    if (!work) return found;
    const double least = least_roundings * rounding * size;
    const section early = {half, d, all->points}, late = section_tail(all, half);
    const fit whole = fit_points(all, least, work), first = fit_points(&early, least, work),
              second = fit_points(&late, least, work);
    free(work);
    const double residual = fmax(whole.residual, fmax(first.residual, second.residual));
    if (!(residual <= well_fit)) return found;
    const double apart = fabs(second.rate - first.rate), scatter = residual / sqrt((double)half);
    found.rate = (whirl_estimate){whole.rate, fmax(0.5 * apart, 0.1 * scatter)};
    // The bend is ds/dt over s^2 for the rate s: 0 for a linear map, 1/2 for x' = -x^2, at least 2 on the way to a
    // circle in Hopf's normal form.
    found.bend = (second.rate - first.rate) / (whole.rate * whole.rate * (double)half);
    found.bend_error = 0.1 * scatter / (whole.rate * whole.rate * (double)half);
    return found;
}

bool settling_map_leads_to_rest(const settling_map *m) {
    const double sigmas = 6.0, bend = 0.25;
    return m->rate.value + sigmas * m->rate.error < 0.0 && fabs(m->bend) + 3.0 * m->bend_error < bend;
}
