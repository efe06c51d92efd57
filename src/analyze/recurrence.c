// Recurrence: after how many revolutions the motion comes back to where it was, and how closely.
#include <math.h>

#include "section.h"

/// Largest |z(n+k) - z(n)| among `count` points from `first` on.
static double return_distance(const section *all, size_t first, size_t count, size_t k) {
    double largest = 0.0;
    for (size_t n = first; n + k < first + count; n++) largest = fmax(largest, section_distance(all, n, n + k));
    return largest;
}

/// How far the points of a would-be P-k are from being fewer: for k = p j the shortest return over j.
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

recurrence recurrence_find(const section *all, size_t record_count, double size) {
    // Short records borrow from the revolutions watched before them, so that every period up to 64 is seen twice.
    enum { SHORTEST_WINDOW = 2 * WHIRL_MAX_PERIOD, FEWEST_RETURNS = 4 };
    size_t window = record_count > SHORTEST_WINDOW ? record_count : SHORTEST_WINDOW;
    if (window > all->count) window = all->count;
    const size_t first = all->count - window;
    recurrence found = {.window = window, .distance = NAN, .separation = INFINITY, .trend = NAN};
    for (size_t k = 1; k <= WHIRL_MAX_PERIOD && k + FEWEST_RETURNS <= window; k++) {
        const double distance = return_distance(all, first, window, k) / size;
        if (found.period > 0 && !(distance < found.distance)) continue;
        found.period = (int)k;
        found.distance = distance;
        if (distance <= recurrence_tolerance) break;
    }
    if (found.period > 0) {
        found.separation = divisor_distance(all, first, window, (size_t)found.period) / size;
        found.trend = settling_trend(all, (size_t)found.period, size);
    }
    return found;
}
