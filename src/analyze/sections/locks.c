// Locks that a motion on closed curves excludes. Near a lock on P-q the slow phase psi = 2 pi (q theta - p n) of a
// motion that goes round its curve by theta turns obeys psi' = delta + s sin psi (Adler 1946; further harmonics are
// smaller by powers of q for a smooth curve). It is locked for |delta| <= s, else it drifts. A locked motion never
// completes a turn of psi. It also moves unevenly: while psi moves by x radians about its fastest point, for delta = s,
// its speed s (1 + cos psi) changes by x^2/16. So a motion that completes turns, or that moves more evenly than this,
// is not locked.
#include <math.h>
#include <stdbool.h>

#include "birkhoff_weight.h"
#include "curves.h"
#include "locks.h"
#include "rotation.h"
#include "section.h"
#include "two_pi.h"

enum { SHORTEST_LIMIT = 96 };

int longest_lock(const section *all, int curves) {
    const size_t points = all->count < ROTATION_POINTS ? all->count : ROTATION_POINTS;
    const int step = curves > 0 ? curves : 1, third = (int)points / 3 / step * step;
    return third > SHORTEST_LIMIT ? third : SHORTEST_LIMIT;
}

/// Returns the weighted mean square of the returns after q revolutions, `count` of them from `first` on. It measures
/// the square of the speed of psi on any curve, since the q starting places of returns are spread evenly along it.
static double mean_square_return(const section *points, size_t q, size_t first, size_t count) {
    double weights = 0.0, sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double w = birkhoff_weight(i, count), away = section_distance(points, first + i, first + i + q);
        weights += w;
        sum += w * away * away;
    }
    return sum / weights;
}

/// Returns true if returns after q revolutions vary less than a lock allows. `turns`: turns of psi over all points.
/// Three windows, each of half of the returns, have centres that are a quarter of the returns apart. If psi moves by x
/// in a lock over all returns, the speeds of the windows differ by (x/4)^2/4, and the squares of the speeds by twice
/// that.
static bool goes_evenly(const section *points, size_t q, double turns) {
    const double margin = 5.0;
    const size_t returns = points->count - q, half = returns / 2;
    const double way = two_pi * turns * (double)returns / (double)points->count, least = way * way / 32.0;
    double slowest = INFINITY, fastest = 0.0;
    for (size_t window = 0; window < 3; window++) {
        const double square = mean_square_return(points, q, window * (returns - half) / 2, half);
        slowest = fmin(slowest, square);
        fastest = fmax(fastest, square);
    }
    return fastest - slowest < least / margin * fastest;
}

int locks_excluded(const section *all, const closed_curves *curves, double rotation) {
    // The weighted mean of the speed, the rotation number, is at most 2.6 times the plain mean.
    const double whole_turns = 3.0;
    const int limit = longest_lock(all, curves->count);
    const section points = section_tail(all, ROTATION_POINTS);
    const size_t visits = points.count / (size_t)curves->count;
    if (isnan(rotation)) return curves->neighbours <= limit ? curves->neighbours - 1 : limit;
    for (int q = curves->count; q <= limit; q += curves->count) {
        const double phase = q / curves->count * rotation, turns = fabs(phase - round(phase)) * (double)visits;
        if (turns > whole_turns) continue;
        if (3 * (size_t)q > points.count || !goes_evenly(&points, (size_t)q, turns)) return q - 1;
    }
    return limit;
}
