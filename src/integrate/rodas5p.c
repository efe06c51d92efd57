// Steps of Rodas5P for one machine: any system, on fixed sides of its switches or along them, with disturbances.
//
// The Jacobian is the system's own; of systems that give none, and of motions along switches, it is found by
// differences of order 2, good to 1e-10. The derivative by time alone comes from differences of order 4.
#include <float.h>
#include <math.h>
#include <string.h>

#include "stepper.h"

/// Rows of the stepper: the slope at the beginning, the increments, the slope at the end, workspace.
enum { FIRST_INCREMENT = 1, END_SLOPE = FIRST_INCREMENT + RODAS5P_STAGES, RATE, RIGHT, BESIDE };

/// The stepper's workspace of its own: columns of the matrix, unit vectors, numbers of the pivots' rows.
static double *matrix_of(const stepper *c) {
    return c->own;
}
static double *units_of(const stepper *c) {
    return c->own + c->dimension * c->dimension;
}
static double *pivots_of(const stepper *c) {
    return c->own + 2 * c->dimension * c->dimension;
}

static size_t room(size_t dimension) {
    return (2 * dimension + 1) * dimension;
}

// ---------------------------------------------------------------- derivatives

static void exact_columns(const stepper *c) {
    const whirl_system *system = c->system;
    const size_t n = c->dimension;
    double forcing[WHIRL_MAX_FORCING], *unit = units_of(c);
    if (system->forcing_count > 0) system->forcing(system->model, c->begin, forcing);
    memset(unit, 0, n * n * sizeof *unit);
    for (size_t i = 0; i < n; i++) unit[i * n + i] = 1.0;
    system->tangent(system->model, c->begin, forcing, c->start, system->rhs_on_sides ? c->sides : NULL, n, unit,
                    matrix_of(c));
}

static void difference_columns(const stepper *c) {
    const size_t n = c->dimension;
    double *below = c->k[RIGHT], *x = c->stage;
    memcpy(x, c->start, n * sizeof *x);
    for (size_t j = 0; j < n; j++) {
        double *column = matrix_of(c) + j * n;
        const double apart = 0x1p-17 * (fabs(x[j]) + c->atol / c->rtol), at = x[j];
        x[j] = at + apart;
        const double high = x[j];
        stepper_slope(c, c->begin, x, column);
        x[j] = at - apart;
        stepper_slope(c, c->begin, x, below);
        for (size_t i = 0; i < n; i++) column[i] = (column[i] - below[i]) / (high - x[j]);
        x[j] = at;
    }
}

/// The derivative of the slope by time alone, by times within the revolution.
static void take_rate(const stepper *c) {
    static const double weights[] = {-25.0, 48.0, -36.0, 16.0, -3.0};
    const size_t n = c->dimension;
    const double step = 0x1p-13 * c->system->period;
    const double apart = c->begin + 4.0 * step <= c->system->period ? step : -step;
    double *rate = c->k[RATE], *beside = c->k[BESIDE];
    for (size_t d = 0; d < n; d++) rate[d] = weights[0] * c->k[0][d];
    for (int i = 1; i <= 4; i++) {
        stepper_slope(c, c->begin + i * apart, c->start, beside);
        for (size_t d = 0; d < n; d++) rate[d] += weights[i] * beside[d];
    }
    for (size_t d = 0; d < n; d++) rate[d] /= 12.0 * apart;
}

// ---------------------------------------------------------------- equations of a stage

/// The Jacobian in columns becomes 1/(gamma h) - J, decomposed with the largest pivots; false where it is singular.
static bool decompose(const stepper *c, double h) {
    const size_t n = c->dimension;
    double *matrix = matrix_of(c), *pivots = pivots_of(c);
    for (size_t i = 0; i < n * n; i++) matrix[i] = -matrix[i];
    for (size_t i = 0; i < n; i++) matrix[i * n + i] += 1.0 / (rodas5p_gamma * h);
    for (size_t j = 0; j < n; j++) {
        double *column = matrix + j * n;
        size_t pivot = j;
        for (size_t i = j + 1; i < n; i++)
            if (fabs(column[i]) > fabs(column[pivot])) pivot = i;
        pivots[j] = (double)pivot;
        if (!(fabs(column[pivot]) > 0.0)) return false;
        for (size_t m = 0; m < n; m++) {
            const double swap = matrix[m * n + j];
            matrix[m * n + j] = matrix[m * n + pivot];
            matrix[m * n + pivot] = swap;
        }
        for (size_t i = j + 1; i < n; i++) column[i] /= column[j];
        for (size_t m = j + 1; m < n; m++) {
            double *later = matrix + m * n;
            for (size_t i = j + 1; later[j] != 0.0 && i < n; i++) later[i] -= column[i] * later[j];
        }
    }
    return true;
}

static void solve(const stepper *c, double *x) {
    const size_t n = c->dimension;
    const double *matrix = matrix_of(c), *pivots = pivots_of(c);
    for (size_t j = 0; j < n; j++) {
        const size_t pivot = (size_t)pivots[j];
        const double swap = x[j];
        x[j] = x[pivot];
        x[pivot] = swap;
    }
    for (size_t j = 0; j < n; j++)
        for (size_t i = j + 1; i < n; i++) x[i] -= matrix[j * n + i] * x[j];
    for (size_t j = n; j-- > 0;) {
        x[j] /= matrix[j * n + j];
        for (size_t i = 0; i < j; i++) x[i] -= matrix[j * n + i] * x[j];
    }
}

/// from + the sum of the rows before row `count`, by weights.
static void sum_rows(size_t size, const double *weights, int count, double *const *rows, const double *from,
                     double *out) {
    memcpy(out, from, size * sizeof *out);
    for (int j = 0; j < count; j++)
        for (size_t d = 0; d < size; d++) out[d] += weights[j] * rows[j][d];
}

// ---------------------------------------------------------------- the step

/// The norm of an error over the tolerance.
static double over_tolerance(const stepper *c, const double *error) {
    double square = 0.0;
    for (size_t d = 0; d < c->dimension; d++) square += (error[d] / c->scale[d]) * (error[d] / c->scale[d]);
    return sqrt(square / (double)c->dimension);
}

/// The three sums of the interpolant for coordinate d.
static void sum_polynomials(const stepper *c, size_t d, double e[RODAS5P_DENSE - 1]) {
    for (int p = 0; p < RODAS5P_DENSE - 1; p++) {
        e[p] = 0.0;
        for (int j = 0; j < RODAS5P_STAGES; j++) e[p] += rodas5p_h[p][j] * c->k[FIRST_INCREMENT + j][d];
    }
}

/// The error of the interpolant in the middle of the step, which that of the end does not tell where all is stiff: what
/// (1/(gamma h) - J)^-1 makes of the residual of the equations there.
static double error_between(const stepper *c, double h) {
    double *x = c->stage, *slope = c->k[BESIDE], *right = c->k[RIGHT];
    for (size_t d = 0; d < c->dimension; d++) {
        double e[RODAS5P_DENSE - 1];
        const double way = c->end[d] - c->start[d];
        sum_polynomials(c, d, e);
        x[d] = c->start[d] + 0.5 * way + 0.25 * (e[0] + 0.5 * e[1] + 0.25 * e[2]);
        right[d] = (way + 0.25 * (e[1] + e[2])) / h;
    }
    stepper_slope(c, c->begin + 0.5 * h, x, slope);
    for (size_t d = 0; d < c->dimension; d++) right[d] -= slope[d];
    solve(c, right);
    return over_tolerance(c, right);
}

static void take_increment(const stepper *c, int i, double h) {
    const size_t n = c->dimension;
    double *const *u = c->k + FIRST_INCREMENT, *right = c->k[RIGHT];
    sum_rows(n, rodas5p_a[i], i, u, c->start, c->stage);
    if (i == 0)
        memcpy(right, c->k[0], n * sizeof *right);
    else
        stepper_slope(c, c->begin + rodas5p_c[i] * h, c->stage, right);
    memset(u[i], 0, n * sizeof *u[i]);
    sum_rows(n, rodas5p_g[i], i, u, u[i], u[i]);
    for (size_t d = 0; d < n; d++) u[i][d] = right[d] + u[i][d] / h + h * rodas5p_d[i] * c->k[RATE][d];
    solve(c, u[i]);
}

static double try_step(stepper *c, double h) {
    const size_t n = c->dimension;
    const double *last = c->k[FIRST_INCREMENT + RODAS5P_STAGES - 1];
    if (c->system->tangent && c->sliding_count == 0)
        exact_columns(c);
    else
        difference_columns(c);
    take_rate(c);
    if (!decompose(c, h)) return NAN;
    for (int i = 0; i < RODAS5P_STAGES; i++) take_increment(c, i, h);
    for (size_t d = 0; d < n; d++) c->end[d] = c->stage[d] + last[d];
    stepper_slope(c, c->begin + h, c->end, c->k[END_SLOPE]);
    for (size_t d = 0; d < n; d++)
        if (!isfinite(c->k[END_SLOPE][d])) return NAN;
    stepper_set_scales(c, c->start, c->end);
    const double error = over_tolerance(c, last), between = error_between(c, h);
    return isfinite(between) ? fmax(error, between) : NAN;
}

static void interpolate(stepper *c) {
    for (size_t d = 0; d < c->dimension; d++) {
        double e[RODAS5P_DENSE - 1];
        sum_polynomials(c, d, e);
        c->dense[0][d] = c->end[d] - c->start[d];
        c->dense[1][d] = e[0];
        c->dense[2][d] = e[1] + e[2]; // theta and 1 - theta in turn
        c->dense[3][d] = -e[2];
    }
}

// ---------------------------------------------------------------- disturbances

/// The derivative of the step: with increments w of a disturbance d along those u of the state,
///
///     (1/(gamma h) - J) w_i = J(t_i, x_i) (d + sum_j a_ij w_j) + sum_j g_ij/h w_j + (J d)' (u_i, h d_i)
///
/// where the last is the derivative of J d along the increment and by time, by a difference: good to 1e-9 of what J
/// changes within the step.
static void take_varied_increment(const stepper *c, int i, double h) {
    const stepper_variation *v = &c->variation;
    const size_t n = c->dimension, size = v->set->count * n;
    const double share = 0x1p-10, *u = c->k[FIRST_INCREMENT + i], half = share * h * rodas5p_d[i];
    double *const *w = v->k, *ahead = v->k[RODAS5P_STAGES], *behind = v->k[RODAS5P_STAGES + 1], *x = c->k[BESIDE];
    sum_rows(n, rodas5p_a[i], i, c->k + FIRST_INCREMENT, c->start, x);
    sum_rows(size, rodas5p_a[i], i, w, v->set->vectors, v->stage);
    memset(w[i], 0, size * sizeof *w[i]);
    sum_rows(size, rodas5p_g[i], i, w, w[i], w[i]);
    stepper_apply_jacobian(c, c->begin + rodas5p_c[i] * h, x, v->stage, ahead);
    for (size_t d = 0; d < size; d++) w[i][d] = w[i][d] / h + ahead[d];
    for (size_t d = 0; d < n; d++) x[d] = c->start[d] + share * u[d];
    stepper_apply_jacobian(c, c->begin + half, x, v->set->vectors, ahead);
    for (size_t d = 0; d < n; d++) x[d] = c->start[d] - share * u[d];
    stepper_apply_jacobian(c, c->begin - half, x, v->set->vectors, behind);
    for (size_t d = 0; d < size; d++) w[i][d] += (ahead[d] - behind[d]) / (2.0 * share);
    for (size_t k = 0; k < v->set->count; k++) solve(c, w[i] + k * n);
}

/// The integral of the divergence over the step, by Gauss' formula of order 6 along the interpolant.
static double integrated_divergence(stepper *c) {
    static const double weights[] = {5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0};
    const double apart = 0.5 * sqrt(0.6);
    double sum = 0.0;
    interpolate(c);
    for (int i = 0; i < 3; i++) {
        const double theta = 0.5 + (i - 1) * apart;
        stepper_between(c, theta, c->k[BESIDE]);
        sum += weights[i] * stepper_divergence(c, c->begin + theta * c->length, c->k[BESIDE]);
    }
    return c->length * sum;
}

static double try_varied(stepper *c) {
    stepper_variation *v = &c->variation;
    const whirl_disturbances *set = v->set;
    if (!set) return 0.0;
    const size_t n = c->dimension, size = set->count * n;
    const double *last = v->k[RODAS5P_STAGES - 1];
    double error = 0.0;
    for (int i = 0; i < RODAS5P_STAGES; i++) take_varied_increment(c, i, c->length);
    for (size_t d = 0; d < size; d++) v->end[d] = v->stage[d] + last[d];
    for (size_t k = 0; k < set->count; k++) error = fmax(error, stepper_varied_error(c, k, last + k * n));
    v->volume = integrated_divergence(c);
    return error;
}

// ---------------------------------------------------------------- lengths

static const double safety = 0.92;

/// err^(-1/8) times the error before to the power 1/16: settles at 0.92^16 = 0.26 of the tolerance.
static double longer(double error, double before) {
    const double eighth = sqrt(sqrt(sqrt(fmax(error, 1e-8))));
    return safety * sqrt(sqrt(sqrt(sqrt(before)))) / eighth;
}

static double shorter(double error) {
    const double eighth = sqrt(sqrt(sqrt(error)));
    return safety / (eighth * sqrt(eighth));
}

const formula rodas5p_formula = {.stages = END_SLOPE,
                                 .adaptive = true,
                                 .try_step = try_step,
                                 .interpolate = interpolate,
                                 .try_varied = try_varied,
                                 .longer = longer,
                                 .shorter = shorter,
                                 .room = room};
