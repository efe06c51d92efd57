// Sides of a motion's switches, changes of side at their zeros, and sliding along them (Filippov 1988).
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crossing.h"
#include "stepper.h"
#include "stepper_parts.h"

// ---------------------------------------------------------------- switching functions and their derivatives

static double sides_value(const stepper *c, size_t which, double t, const double *x) {
    double *values = stepper_row(c, ROW_VALUE);
    c->system->switches(c->system->model, t, x, values);
    return values[which];
}

double stepper_rate(const stepper *c, size_t which, double t, const double *x, const double *slope) {
    double *gradient = c->work, rate;
    if (c->system->switch_gradient) {
        c->system->switch_gradient(c->system->model, t, x, which, gradient, &rate);
        for (size_t d = 0; d < c->dimension; d++) rate += gradient[d] * slope[d];
        return rate;
    }
    const double step = 1e-6 * c->system->period;
    for (size_t d = 0; d < c->dimension; d++) c->work[d] = x[d] + step * slope[d];
    rate = sides_value(c, which, t + step, c->work);
    for (size_t d = 0; d < c->dimension; d++) c->work[d] = x[d] - step * slope[d];
    return (rate - sides_value(c, which, t - step, c->work)) / (2.0 * step);
}

/// Returns the change of a switching function if every coordinate changes by `absolute` plus `relative` times itself.
/// Without a gradient it assumes that the function changes by one when a coordinate does.
static double change_by(const stepper *c, size_t which, double t, const double *x, double absolute, double relative) {
    double *gradient = c->work, by_time, change = 0.0;
    if (!c->system->switch_gradient) {
        for (size_t d = 0; d < c->dimension; d++) change = fmax(change, absolute + relative * fabs(x[d]));
        return change;
    }
    c->system->switch_gradient(c->system->model, t, x, which, gradient, &by_time);
    for (size_t d = 0; d < c->dimension; d++) change += fabs(gradient[d]) * (absolute + relative * fabs(x[d]));
    return change;
}

double stepper_reach(const stepper *c, size_t which, double t, const double *x) {
    return change_by(c, which, t, x, 1e-3 * c->atol, fmax(1e-3 * c->rtol, 4.0 * DBL_EPSILON));
}

// ---------------------------------------------------------------- slopes

static void slope_on(const stepper *c, double t, const double *x, const double *sides, double *dxdt) {
    const whirl_system *system = c->system;
    double forcing[WHIRL_MAX_FORCING];
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    if (system->rhs_on_sides)
        system->rhs_on_sides(system->model, t, forcing, x, sides, dxdt);
    else
        system->rhs(system->model, t, forcing, x, dxdt);
}

bool stepper_solve(size_t n, double matrix[MAX_SLIDING][MAX_SLIDING], double *right) {
    for (size_t k = 0; k < n; k++) {
        size_t pivot = k;
        for (size_t i = k + 1; i < n; i++)
            if (fabs(matrix[i][k]) > fabs(matrix[pivot][k])) pivot = i;
        if (!(fabs(matrix[pivot][k]) > 0.0)) return false;
        for (size_t j = 0; j < n; j++) {
            const double swap = matrix[k][j];
            matrix[k][j] = matrix[pivot][j];
            matrix[pivot][j] = swap;
        }
        const double swap = right[k];
        right[k] = right[pivot];
        right[pivot] = swap;
        for (size_t i = k + 1; i < n; i++) {
            const double factor = matrix[i][k] / matrix[k][k];
            for (size_t j = k; j < n; j++) matrix[i][j] -= factor * matrix[k][j];
            right[i] -= factor * right[k];
        }
    }
    // Back substitution.
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++) right[k] -= matrix[k][j] * right[j];
        right[k] /= matrix[k][k];
    }
    return true;
}

size_t stepper_list_sliding(const stepper *c, size_t list[MAX_SLIDING]) {
    size_t count = 0;
    for (size_t i = 0; i < c->system->switch_count; i++)
        if (c->sliding[i]) list[count++] = i;
    return count;
}

/// Computes the slope of a motion that slides along switches. It is the slope on their lower sides, plus a share of the
/// difference that each upper side makes. (The effects of the switches add up, so that the convex combination of all
/// sides has this form.) Writes the shares, which are between 0 and 1 as long as the motion stays on the switch.
void stepper_slope_along(const stepper *c, double t, const double *x, double *dxdt, double *share) {
    const size_t n = c->dimension;
    size_t list[MAX_SLIDING];
    // Compute the slope on the lower sides, and what each upper side adds.
    const size_t count = stepper_list_sliding(c, list);
    double matrix[MAX_SLIDING][MAX_SLIDING], *added = c->work + n, *sides = stepper_row(c, ROW_SIDES);
    memcpy(sides, c->sides, c->system->switch_count * sizeof *sides);
    for (size_t i = 0; i < count; i++) sides[list[i]] = -1.0;
    slope_on(c, t, x, sides, dxdt);
    for (size_t j = 0; j < count; j++) {
        sides[list[j]] = 1.0;
        slope_on(c, t, x, sides, added + j * n);
        sides[list[j]] = -1.0;
        for (size_t d = 0; d < n; d++) added[j * n + d] -= dxdt[d];
    }
    // Find the shares with which no switching function changes along the slope.
    for (size_t i = 0; i < count; i++) {
        double by_time;
        c->system->switch_gradient(c->system->model, t, x, list[i], c->work, &by_time);
        share[i] = -by_time;
        for (size_t d = 0; d < n; d++) share[i] -= c->work[d] * dxdt[d];
        for (size_t j = 0; j < count; j++) {
            matrix[i][j] = 0.0;
            for (size_t d = 0; d < n; d++) matrix[i][j] += c->work[d] * added[j * n + d];
        }
    }
    if (!stepper_solve(count, matrix, share)) // the two sides do not keep the motion on the switch
        for (size_t i = 0; i < count; i++) share[i] = 0.0;
    for (size_t j = 0; j < count; j++)
        for (size_t d = 0; d < n; d++) dxdt[d] += share[j] * added[j * n + d];
}

void stepper_slope(const stepper *c, double t, const double *x, double *dxdt) {
    double share[MAX_SLIDING];
    if (c->sliding_count > 0)
        stepper_slope_along(c, t, x, dxdt, share);
    else
        slope_on(c, t, x, c->sides, dxdt);
}

// ---------------------------------------------------------------- sides

void stepper_guarded(const stepper *c, double t, const double *x, double *values) {
    double share[MAX_SLIDING];
    c->system->switches(c->system->model, t, x, values);
    for (size_t i = 0; i < c->system->switch_count; i++) values[i] *= c->sides[i];
    if (c->sliding_count == 0) return;
    stepper_slope_along(c, t, x, c->work + (MAX_SLIDING + 1) * c->dimension, share);
    size_t at = 0;
    for (size_t i = 0; i < c->system->switch_count; i++)
        if (c->sliding[i]) {
            values[i] =
                share[at] * (1.0 - share[at]) / (1.0 + share[at] * share[at]); // smooth even where 1/share is not
            at++;
        }
}

/// Derivatives of a switching function along the motion on one side.
typedef struct departure {
    double rate, bend; ///< first and second derivative by time
    bool level;        ///< the first derivative is so small that only the second decides
} departure;

/// Computes the derivatives of switch `which` at the present state, where it is zero, with its side set to `side`.
static departure departure_on(stepper *c, size_t which, double side) {
    double *slope = c->work + (MAX_SLIDING + 1) * c->dimension, *later = slope + c->dimension, size = 0.0;
    const double step = 1e-5 * c->system->period, kept = c->sides[which];
    c->sides[which] = side;
    stepper_slope(c, c->t, c->x, slope);
    departure out = {.rate = stepper_rate(c, which, c->t, c->x, slope)};
    for (size_t d = 0; d < c->dimension; d++) {
        later[d] = c->x[d] + step * slope[d];
        size = fmax(size, fabs(c->x[d]));
    }
    stepper_slope(c, c->t + step, later, slope);
    out.bend = (stepper_rate(c, which, c->t + step, later, slope) - out.rate) / step;
    c->sides[which] = kept;
    // A function with this rate and bend turns at rate^2/(2 bend) beyond zero. If that is within rounding, the rate
    // says nothing: the function is level.
    out.level = out.rate * out.rate <= 16.0 * DBL_EPSILON * size * fabs(out.bend);
    return out;
}

/// Returns true if the function moves to `side`.
static bool moves_to(const departure *d, double side) {
    return side * (d->level ? d->bend : d->rate) > 0.0;
}

/// Rows of a trial step: four slopes, two states.
enum { TRIAL_ROWS = 6, TRIAL_STEPS = 8 };

/// Carries x from t with the present sides, by a classical Runge-Kutta step of length h. rows: four slopes, a state.
static void trial_step(stepper *c, double t, double h, double *x, double *rows) {
    static const double shares[4] = {0.0, 0.5, 0.5, 1.0}, weights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    const size_t n = c->dimension;
    double *at = rows + 4 * n;
    for (size_t k = 0; k < 4; k++) {
        for (size_t d = 0; d < n; d++) at[d] = x[d] + (k > 0 ? shares[k] * h * rows[(k - 1) * n + d] : 0.0);
        stepper_slope(c, t + shares[k] * h, at, rows + k * n);
    }
    for (size_t k = 0; k < 4; k++)
        for (size_t d = 0; d < n; d++) x[d] += weights[k] * h * rows[k * n + d];
}

/// Returns true if, with its side set to `side`, the function is on that side after TRIAL_STEPS steps, and farther
/// there than after half of them. Used if first and second derivatives are inconclusive.
static bool moves_there_later(stepper *c, size_t which, double side, double *rows) {
    const size_t n = c->dimension;
    const double h = c->system->period / (64.0 * TRIAL_STEPS), kept = c->sides[which];
    double *x = rows + 5 * n, half = 0.0;
    c->sides[which] = side;
    memcpy(x, c->x, n * sizeof *x);
    for (int k = 0; k < TRIAL_STEPS; k++) {
        trial_step(c, c->t + k * h, h, x, rows);
        if (2 * (k + 1) == TRIAL_STEPS) half = side * sides_value(c, which, c->t + (k + 1) * h, x);
    }
    const double whole = side * sides_value(c, which, c->t + TRIAL_STEPS * h, x);
    c->sides[which] = kept;
    return whole > half && half > 0.0;
}

/// Sets the side to which trial steps lead. If they lead to neither, the side stays. Zeros of this switch are ignored
/// in the next step.
static void choose_by_trial(stepper *c, size_t which) {
    double *rows = calloc(TRIAL_ROWS * c->dimension, sizeof *rows);
    c->held[which] = CROSSING_ALONG;
    if (rows && moves_there_later(c, which, 1.0, rows))
        c->sides[which] = 1.0;
    else if (rows && moves_there_later(c, which, -1.0, rows))
        c->sides[which] = -1.0;
    free(rows);
}

static bool can_slide(const stepper *c) {
    return c->system->rhs_on_sides && c->system->switch_gradient && c->sliding_count < MAX_SLIDING;
}

/// Begins to slide along a switch.
static void begin_sliding(stepper *c, size_t which) {
    c->sliding[which] = true;
    c->sliding_count++;
    stepper_project(c, c->x);
}

/// Ends sliding, on the side to which the motion leaves: the upper one if the share of the upper side has come to 1.
static void end_sliding(stepper *c, size_t which) {
    double share[MAX_SLIDING];
    size_t at = 0;
    stepper_slope_along(c, c->t, c->x, c->work + (MAX_SLIDING + 1) * c->dimension, share);
    for (size_t i = 0; i < which; i++) at += c->sliding[i];
    c->sides[which] = share[at] > 0.5 ? 1.0 : -1.0;
    c->sliding[which] = false;
    c->sliding_count--;
    c->held[which] = CROSSING_LEVEL;
}

/// Returns true if both sides push the motion onto the switch.
static bool both_push(const departure *below, const departure *above) {
    return below->rate > 0.0 && !below->level && above->rate < 0.0 && !above->level;
}

void stepper_cross(stepper *c, size_t which) {
    if (c->sliding[which]) {
        end_sliding(c, which);
        return;
    }
    const double from = c->sides[which];
    const departure below = departure_on(c, which, -1.0), above = departure_on(c, which, 1.0);
    const departure *back = from < 0.0 ? &below : &above, *onward = from < 0.0 ? &above : &below;
    if (can_slide(c) && both_push(&below, &above)) {
        begin_sliding(c, which);
    } else if (moves_to(onward, -from)) {
        c->sides[which] = -from;
        c->held[which] = onward->level ? CROSSING_LEVEL : CROSSING_STEEP;
    } else if (moves_to(back, from)) {
        c->held[which] = back->level ? CROSSING_LEVEL : CROSSING_STEEP;
    } else {
        choose_by_trial(c, which);
    }
}

void stepper_find_sides(stepper *c) {
    const whirl_system *system = c->system;
    double *values = stepper_row(c, ROW_FOUND);
    memset(c->held, 0, system->switch_count * sizeof *c->held);
    memset(c->sliding, 0, system->switch_count * sizeof *c->sliding);
    c->sliding_count = 0;
    if (system->switch_count == 0) return;
    system->switches(system->model, c->t, c->x, values);
    // Switches that are not near zero have the side of their sign.
    for (size_t i = 0; i < system->switch_count; i++) c->sides[i] = values[i] > 0.0 ? 1.0 : -1.0;
    // At a switch near zero the motion slides, or leaves to one side. If derivatives do not show to which, trial steps
    // on both sides do.
    for (size_t i = 0; i < system->switch_count; i++) {
        if (fabs(values[i]) > change_by(c, i, c->t, c->x, 0.0, 16.0 * DBL_EPSILON)) continue;
        const departure below = departure_on(c, i, -1.0), above = departure_on(c, i, 1.0);
        if (can_slide(c) && both_push(&below, &above)) {
            begin_sliding(c, i);
        } else if (moves_to(&above, 1.0) || moves_to(&below, -1.0)) {
            const departure *taken = moves_to(&above, 1.0) ? &above : &below;
            c->sides[i] = taken == &above ? 1.0 : -1.0;
            c->held[i] = taken->level ? CROSSING_LEVEL : CROSSING_STEEP;
        } else {
            choose_by_trial(c, i);
        }
    }
}

void stepper_project(const stepper *c, double *x) {
    double *gradient = c->work, by_time;
    for (int turn = 0; turn < 2; turn++)
        for (size_t i = 0; i < c->system->switch_count; i++) {
            if (!c->sliding[i]) continue;
            double square = 0.0;
            c->system->switch_gradient(c->system->model, c->t, x, i, gradient, &by_time);
            for (size_t d = 0; d < c->dimension; d++) square += gradient[d] * gradient[d];
            const double by = sides_value(c, i, c->t, x) / square;
            for (size_t d = 0; d < c->dimension; d++) x[d] -= by * gradient[d];
        }
}
