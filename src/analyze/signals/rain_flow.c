// Rain flow: ranges of a load history that close hysteresis loops, by three points (ASTM E1049-85, 5.4.4), and their
// damage by Palmgren and Miner's sum (Miner 1945, J. Appl. Mech. 12, A159).
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "signal_check.h"

/// Returns true if the history turns at `middle`, between the last point that counts and the next sample.
static bool rain_flow_turns(double last, double middle, double next) {
    return (middle > last && next < middle) || (middle < last && next > middle);
}

/// Writes to `points` the first and last sample, and the peaks and valleys between them. Equal samples in a row count
/// as one. Returns their number.
static size_t rain_flow_turning(const double *values, size_t count, double *points) {
    size_t found = 1;
    points[0] = values[0];
    double middle = values[0];
    for (size_t i = 1; i < count; i++) {
        if (rain_flow_turns(points[found - 1], middle, values[i])) points[found++] = middle;
        middle = values[i];
    }
    if (middle != points[found - 1]) points[found++] = middle;
    return found;
}

whirl_status whirl_signals_rain_flow(const double *values, size_t count, double *cycles, size_t *rows) {
    *rows = 0;
    const whirl_status status = signal_check_channels(values, count, 1, 1);
    if (status.code != WHIRL_OK) return status;
    double *points = malloc(2 * count * sizeof *points);
    if (!points) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the rain flow of %zu samples", count);
    double *open = points + count;
    const size_t turning = rain_flow_turning(values, count, points);

    // `open` has the points whose ranges are not counted yet; the first one is the standard's starting point.
    size_t left = 0;
    for (size_t i = 0; i < turning; i++) {
        open[left++] = points[i];
        while (left >= 3) {
            const double from = open[left - 3], to = open[left - 2], range = fabs(to - from);
            if (fabs(open[left - 1] - to) < range) break;
            double *cycle = cycles + WHIRL_SIGNALS_CYCLE * (*rows)++;
            cycle[0] = range, cycle[1] = 0.5 * (from + to);
            cycle[2] = left == 3 ? 0.5 : 1.0;
            if (left == 3) { // the range begins at the starting point: half a cycle, and the next point is the start
                open[0] = open[1], open[1] = open[2];
                left = 2;
            } else { // a closed loop: both its points are left out
                open[left - 3] = open[left - 1];
                left -= 2;
            }
        }
    }
    // Ranges that close no loop are half cycles.
    for (size_t i = 0; i + 1 < left; i++) {
        double *cycle = cycles + WHIRL_SIGNALS_CYCLE * (*rows)++;
        cycle[0] = fabs(open[i + 1] - open[i]), cycle[1] = 0.5 * (open[i] + open[i + 1]), cycle[2] = 0.5;
    }
    free(points);
    return whirl_ok();
}

// ---------------------------------------------------------------- damage

static whirl_status damage_check(const double *ranges, const double *lives, size_t points, double slope,
                                 double endurance) {
    if (points < 1) return whirl_fail(WHIRL_BAD_INPUT, "the S-N curve has no point, expected one and a slope, or more");
    if (points == 1 && !(slope > 0.0 && slope <= 1000.0))
        return whirl_fail(WHIRL_BAD_INPUT, "the slope of the S-N curve is %g, expected a number above 0", slope);
    if (!(endurance >= 0.0) || !isfinite(endurance))
        return whirl_fail(WHIRL_BAD_INPUT, "the endurance limit is %g, expected a range of 0 (none) or more",
                          endurance);
    for (size_t i = 0; i < points; i++) {
        if (!(ranges[i] > 0.0 && lives[i] > 0.0) || !isfinite(ranges[i]) || !isfinite(lives[i]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "point %zu of the S-N curve is a range of %g and %g cycles, expected "
                              "numbers above 0",
                              i, ranges[i], lives[i]);
        if (i > 0 && !(ranges[i] < ranges[i - 1] && lives[i] > lives[i - 1]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "point %zu of the S-N curve is a range of %g and %g cycles after %g and "
                              "%g, expected smaller ranges and longer lives in turn",
                              i, ranges[i], lives[i], ranges[i - 1], lives[i - 1]);
    }
    return whirl_ok();
}

/// Returns the cycles to failure of a range up to the largest of the curve. Over logarithms the curve consists of
/// straight lines, the last of which is extended.
static double damage_life(double range, const double *ranges, const double *lives, size_t points, double slope) {
    if (points == 1) return lives[0] * pow(ranges[0] / range, slope);
    size_t i = 1;
    while (i + 1 < points && range < ranges[i]) i++;
    const double part = log(range / ranges[i - 1]) / log(ranges[i] / ranges[i - 1]);
    return lives[i - 1] * pow(lives[i] / lives[i - 1], part);
}

whirl_status whirl_signals_damage(const double *cycles, size_t rows, const double *ranges, const double *lives,
                                  size_t points, double slope, double endurance, double *damage) {
    *damage = 0.0;
    const whirl_status status = damage_check(ranges, lives, points, slope, endurance);
    if (status.code != WHIRL_OK) return status;
    double sum = 0.0;
    for (size_t i = 0; i < rows; i++) {
        const double *cycle = cycles + WHIRL_SIGNALS_CYCLE * i;
        if (!(cycle[0] >= 0.0 && cycle[2] >= 0.0) || !isfinite(cycle[0]) || !isfinite(cycle[2]))
            return whirl_fail(WHIRL_BAD_INPUT, "row %zu is %g cycles of the range %g, expected numbers of 0 or more", i,
                              cycle[2], cycle[0]);
        if (cycle[0] == 0.0 || cycle[0] <= endurance) continue;
        if (points > 1 && cycle[0] > ranges[0])
            return whirl_fail(WHIRL_BAD_INPUT,
                              "row %zu has the range %g, expected at most %g, where the S-N curve begins", i, cycle[0],
                              ranges[0]);
        sum += cycle[2] / damage_life(cycle[0], ranges, lives, points, slope);
    }
    *damage = sum;
    return whirl_ok();
}
