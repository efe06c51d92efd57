// Recurrence: the number of revolutions after which the motion comes back, and how closely. Periods up to 64 are
// compared by all returns of the window. A longer period is compared only if the section has three of them, and then
// only if its last point returned.
#include <math.h>
#include <stdbool.h>

#include "recurrence.h"
#include "section.h"

/// Returns the largest |z(n+k) - z(n)| among `count` points from `first` on.
static double return_distance(const section *all, size_t first, size_t count, size_t k) {
    double largest = 0.0;
    for (size_t n = first; n + k < first + count; n++) largest = fmax(largest, section_distance(all, n, n + k));
    return largest;
}

/// Returns the least return distance after a proper divisor of k. It is small if the supposed P-k has a shorter period.
static double divisor_distance(const section *all, size_t first, size_t count, size_t k) {
    double least = INFINITY;
    for (size_t j = 1; 2 * j <= k; j++) {
        if (k % j == 0) least = fmin(least, return_distance(all, first, count, j));
    }
    return least;
}

static double settling_trend(const section *all, size_t k, double size) {
    size_t quarter = all->count / 4;
    if (quarter < k + 2) quarter = k + 2 < all->count ? k + 2 : all->count;
    const double rounding = 1e-15 * size;
    const double early = return_distance(all, 0, quarter, k);
    const double late = return_distance(all, all->count - quarter, quarter, k);
    return (late + rounding) / (early + rounding);
}

enum { MIN_RETURNS = 4 };

/// Finds the period up to 64 that returns within the tolerance, or else the one that returns best.
static void try_short_periods(const section *all, double size, double tolerance, recurrence *found) {
    for (size_t k = 1; k <= SHORT_PERIOD && k + MIN_RETURNS <= found->window; k++) {
        const double distance = return_distance(all, all->count - found->window, found->window, k) / size;
        found->longest = (int)k;
        if (found->period > 0 && !(distance < found->distance)) continue;
        found->period = (int)k;
        found->distance = distance;
        if (distance <= tolerance) break;
    }
}

/// Finds a longer period that returns within the tolerance, if none up to 64 does.
static void try_long_periods(const section *all, double size, double tolerance, recurrence *found) {
    for (size_t k = SHORT_PERIOD + 1; k <= WHIRL_MAX_PERIOD && 3 * k <= all->count; k++) {
        const size_t window = 3 * k > found->window ? 3 * k : found->window, last = all->count - 1;
        found->longest = (int)k;
        if (section_distance(all, last - k, last) > tolerance * size) continue;
        const double distance = return_distance(all, all->count - window, window, k) / size;
        if (!(distance <= tolerance)) continue;
        found->window = window;
        found->period = (int)k;
        found->distance = distance;
        return;
    }
}

recurrence recurrence_find(const section *all, size_t record_count, double size, double tolerance) {
    // Short records use the revolutions before them, so that every period up to 64 is seen twice.
    enum { SHORTEST_WINDOW = 2 * SHORT_PERIOD };
    size_t window = record_count > SHORTEST_WINDOW ? record_count : SHORTEST_WINDOW;
    if (window > all->count) window = all->count;
    recurrence found = {.window = window, .distance = NAN, .separation = INFINITY, .trend = NAN};
    try_short_periods(all, size, tolerance, &found);
    if (found.distance > tolerance) try_long_periods(all, size, tolerance, &found);
    if (found.period > 0) {
        const size_t first = all->count - found.window;
        found.separation = divisor_distance(all, first, found.window, (size_t)found.period) / size;
        found.trend = settling_trend(all, (size_t)found.period, size);
    }
    return found;
}

/// Returns the root mean square of |z(n+k) - z(n)| over all points.
static double mean_return(const section *all, size_t k) {
    double squares = 0.0;
    for (size_t n = 0; n + k < all->count; n++) {
        const double away = section_distance(all, n, n + k);
        squares += away * away;
    }
    return sqrt(squares / (double)(all->count - k));
}

double drift_round(const section *all, const recurrence *returns, double size) {
    // A circle is 2 pi/sqrt 2 times as long as half the diagonal of its bounds. The points lie on k branches, each of
    // which covers 1/k of that length.
    const double way = 4.44, nearest = 0.1, evenness = 0.5, steady = 0.05;
    if (!(returns->distance > recurrence_tolerance && returns->distance < nearest)) return NAN;
    if (!(fabs(returns->trend - 1.0) < steady)) return NAN;
    const double step = mean_return(all, (size_t)returns->period) / size, round = way / step;
    const bool enough = (double)all->count > enough_rounds * round;
    return step < evenness * returns->distance || enough ? (double)NAN : round;
}
