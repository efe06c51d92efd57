// Slow roll: the 1X that a station shows at a low speed, by a bow or a runout, is subtracted from its 1X at all speeds.
#include <complex.h>
#include <math.h>

#include "runup_parts.h"
#include "synchronous.h"

/// Returns the 1X of x (axis 0) or y (axis 1) in a row as a vector, or NaN where the row is missing.
static double complex slow_roll_vector(const block_view *view, size_t station, size_t row, size_t axis) {
    enum { COLUMNS = 2 * RUNUP_ORDERS };
    const double size = view_numbers(view, AMPLITUDE, station)[COLUMNS * row + axis];
    const double lag = view_numbers(view, LAG, station)[COLUMNS * row + axis];
    // An amplitude that is only rounding has no lag, and counts as 0.
    return isnan(lag) && isfinite(size) ? 0.0 : size * cexp(-I * lag * 3.141592653589793238463 / 180.0);
}

/// Finds the first two consecutive rows between whose speeds `speed` lies. False if no two rows enclose it.
static bool slow_roll_rows(const double *speeds, size_t rows, double speed, size_t found[2]) {
    size_t before = rows;
    for (size_t row = 0; row < rows; row++) {
        if (isnan(speeds[row])) continue;
        if (before < rows && (speeds[before] - speed) * (speeds[row] - speed) <= 0.0) {
            found[0] = before, found[1] = row;
            return true;
        }
        before = row;
    }
    return false;
}

/// Returns the largest change of a station's 1X from its slow roll, as a share of its largest 1X in the run. Only rows
/// next to `at` count whose speeds are within WHIRL_SLOW_ROLL_RANGE of the speed.
static double slow_roll_change(const block_view *view, size_t station, const double complex roll[2], const size_t at[2],
                               double speed, size_t rows) {
    const double *speeds = view_numbers(view, SPEED, 0);
    double change = 0.0, largest = 0.0;
    for (size_t axis = 0; axis < 2; axis++) {
        for (size_t row = 0; row < rows; row++)
            largest = fmax(largest, cabs(slow_roll_vector(view, station, row, axis)));
        for (int way = -1; way <= 1; way += 2)
            for (size_t row = way < 0 ? at[0] : at[1]; row < rows; row += (size_t)way) { // before 0 comes SIZE_MAX
                if (isnan(speeds[row])) continue;
                const bool next = row == at[0] || row == at[1];
                if (!next && fabs(speeds[row] / speed - 1.0) > WHIRL_SLOW_ROLL_RANGE) break;
                change = fmax(change, cabs(slow_roll_vector(view, station, row, axis) - roll[axis]));
            }
    }
    return largest > 0.0 ? change / largest : 0.0;
}

void runup_fill_slow_roll(const block_view *view, const whirl_runup_options *options, size_t probes) {
    // Find the rows on both sides of the speed of slow roll.
    const size_t rows = (size_t)options->rows;
    const double *speeds = view_numbers(view, SPEED, 0);
    size_t at[2];
    if (options->slow_roll == 0.0 || !slow_roll_rows(speeds, rows, options->slow_roll, at)) return;
    const double apart = speeds[at[1]] - speeds[at[0]];
    const double share = apart != 0.0 ? (options->slow_roll - speeds[at[0]]) / apart : 0.0;
    // Interpolate the slow roll of each station.
    for (size_t p = 0; p < probes; p++) {
        double complex roll[2];
        double *vector = view_numbers(view, SLOW_ROLL, p), *change = view_numbers(view, SLOW_ROLL_CHANGE, p);
        for (size_t axis = 0; axis < 2; axis++) {
            roll[axis] =
                (1.0 - share) * slow_roll_vector(view, p, at[0], axis) + share * slow_roll_vector(view, p, at[1], axis);
            vector[2 * axis] = creal(roll[axis]);
            vector[2 * axis + 1] = -cimag(roll[axis]);
        }
        // Subtract the slow roll at all speeds, unless it changes too much near its own speed.
        *change = slow_roll_change(view, p, roll, at, options->slow_roll, rows);
        for (size_t row = 0; row < rows && *change <= WHIRL_MAX_SLOW_ROLL_CHANGE; row++) {
            const double complex x = slow_roll_vector(view, p, row, 0) - roll[0];
            const double complex y = slow_roll_vector(view, p, row, 1) - roll[1];
            if (isnan(creal(x)) || isnan(creal(y))) continue;
            const whirl_synchronous part = synchronous_of(x, y, view_numbers(view, RADIUS, p)[row]);
            for (size_t axis = 0; axis < 2; axis++) {
                view_numbers(view, COMPENSATED, p)[2 * row + axis] = part.amplitude[axis];
                view_numbers(view, COMPENSATED_LAG, p)[2 * row + axis] = part.lag[axis];
            }
        }
    }
}
