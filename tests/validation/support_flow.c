#include "support_flow.h"

#include <lapacke.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"

whirl_integrator *make_integrator(const whirl_system *system, const char *method, int steps_per_revolution) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.steps_per_revolution = steps_per_revolution;
    options.rtol = 1e-15;
    options.atol = 1e-16;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    return integrator;
}

void revolve(whirl_integrator *integrator, double *x, int revolutions) {
    for (int i = 0; i < revolutions; i++)
        if (whirl_integrator_revolve(integrator, x, NULL, NULL) != WHIRL_BOUNDED)
            fail_msg("the motion ended in revolution %d", i + 1);
}

void flow_jacobian(whirl_integrator *integrator, size_t n, const double *x, int revolutions, double step,
                   double *matrix) {
    static const double offsets[4] = {-2.0, -1.0, 1.0, 2.0}, weights[4] = {1.0, -8.0, 8.0, -1.0};
    memset(matrix, 0, n * n * sizeof *matrix);
    for (size_t j = 0; j < n; j++)
        for (int k = 0; k < 4; k++) {
            double state[MAX_DIMENSION];
            memcpy(state, x, n * sizeof *x);
            state[j] += offsets[k] * step;
            revolve(integrator, state, revolutions);
            for (size_t i = 0; i < n; i++) matrix[i * n + j] += weights[k] * state[i] / (12.0 * step);
        }
}

void find_fixed_point(whirl_integrator *integrator, size_t n, double *x, int revolutions) {
    double matrix[MAX_DIMENSION * MAX_DIMENSION], residual[MAX_DIMENSION], before = INFINITY;
    for (int iteration = 0; iteration < 20; iteration++) {
        memcpy(residual, x, n * sizeof *x);
        revolve(integrator, residual, revolutions);
        double size = 0.0;
        for (size_t i = 0; i < n; i++) {
            residual[i] -= x[i];
            size = fmax(size, fabs(residual[i]));
        }
        // Done when only the integrator's own noise is left.
        if (size < 1e-13 || (size < 1e-9 && size > 0.5 * before)) return;
        before = size;
        flow_jacobian(integrator, n, x, revolutions, 1e-4, matrix);
        for (size_t i = 0; i < n; i++) matrix[i * n + i] -= 1.0;
        solve_linear(n, matrix, residual);
        for (size_t i = 0; i < n; i++) x[i] -= residual[i];
    }
    fail_msg("no fixed point was found");
}

void evaluate_rhs(const whirl_system *system, double t, const double *x, double *dxdt) {
    double forcing[WHIRL_MAX_FORCING];
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    system->rhs(system->model, t, forcing, x, dxdt);
}

void exact_jacobian(const whirl_system *system, double t, const double *x, double *matrix) {
    const size_t n = system->dimension;
    double forcing[WHIRL_MAX_FORCING] = {0.0}, unit[MAX_DIMENSION * MAX_DIMENSION] = {0.0};
    double columns[MAX_DIMENSION * MAX_DIMENSION];
    for (size_t i = 0; i < n; i++) unit[i * n + i] = 1.0;
    if (system->forcing_count > 0) system->forcing(system->model, t, forcing);
    system->tangent(system->model, t, forcing, x, NULL, n, unit, columns);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) matrix[n * i + j] = columns[n * j + i];
}

void rhs_jacobian(const whirl_system *system, double t, const double *x, double step, double *matrix) {
    static const double weights[5] = {5.0 / 6.0, -5.0 / 21.0, 5.0 / 84.0, -5.0 / 504.0, 1.0 / 1260.0};
    const size_t n = system->dimension;
    memset(matrix, 0, n * n * sizeof *matrix);
    for (size_t j = 0; j < n; j++)
        for (int k = 1; k <= 5; k++) {
            double ahead[MAX_DIMENSION], behind[MAX_DIMENSION], state[MAX_DIMENSION];
            memcpy(state, x, n * sizeof *x);
            state[j] = x[j] + k * step;
            evaluate_rhs(system, t, state, ahead);
            state[j] = x[j] - k * step;
            evaluate_rhs(system, t, state, behind);
            for (size_t i = 0; i < n; i++) matrix[i * n + j] += weights[k - 1] * (ahead[i] - behind[i]) / step;
        }
}

void eigenvalues(size_t n, const double *matrix, double complex *values) {
    double *copy = malloc((n * n + 2 * n) * sizeof *copy), *real = copy + n * n, *imaginary = real + n;
    const lapack_int size = (lapack_int)n;
    assert_non_null(copy);
    memcpy(copy, matrix, n * n * sizeof *copy);
    assert_int_equal(
        0, LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', size, copy, size, real, imaginary, NULL, size, NULL, size));
    for (size_t i = 0; i < n; i++) values[i] = real[i] + I * imaginary[i];
    free(copy);
}

double largest_modulus(size_t n, const double *matrix) {
    double complex values[MAX_DIMENSION];
    double largest = 0.0;
    eigenvalues(n, matrix, values);
    for (size_t i = 0; i < n; i++) largest = fmax(largest, cabs(values[i]));
    return largest;
}

double largest_real_part(size_t n, const double *matrix, double *imaginary) {
    double complex values[MAX_DIMENSION];
    size_t best = 0;
    eigenvalues(n, matrix, values);
    for (size_t i = 1; i < n; i++)
        if (creal(values[i]) > creal(values[best])) best = i;
    if (imaginary) *imaginary = fabs(cimag(values[best]));
    return creal(values[best]);
}

void solve_linear(size_t n, const double *matrix, double *right) {
    double *copy = malloc(n * n * sizeof *copy);
    lapack_int *pivots = malloc(n * sizeof *pivots);
    assert_true(copy && pivots);
    memcpy(copy, matrix, n * n * sizeof *copy);
    assert_int_equal(0, LAPACKE_dgesv(LAPACK_ROW_MAJOR, (lapack_int)n, 1, copy, (lapack_int)n, pivots, right, 1));
    free(copy);
    free(pivots);
}

double determinant(size_t n, const double *matrix) {
    double copy[MAX_DIMENSION * MAX_DIMENSION], product = 1.0;
    lapack_int pivots[MAX_DIMENSION];
    memcpy(copy, matrix, n * n * sizeof *copy);
    // A positive info only says that the determinant is zero.
    assert_true(LAPACKE_dgetrf(LAPACK_ROW_MAJOR, (lapack_int)n, (lapack_int)n, copy, (lapack_int)n, pivots) >= 0);
    for (size_t i = 0; i < n; i++) product *= pivots[i] == (lapack_int)i + 1 ? copy[i * n + i] : -copy[i * n + i];
    return product;
}

double switch_apart(const whirl_system *system, const double *x, size_t which, double step, double *largest) {
    enum { MAX_SIZE = 64 };
    const size_t n = system->dimension;
    double gradient[MAX_SIZE], by_time, worst = 0.0;
    assert_true(n <= MAX_SIZE && system->switch_count <= MAX_SIZE);
    system->switch_gradient(system->model, 0.0, x, which, gradient, &by_time);
    *largest = 0.0;
    for (size_t i = 0; i < n; i++) *largest = fmax(*largest, fabs(gradient[i]));
    for (size_t by = 0; by < n; by++) {
        double y[MAX_SIZE], values[2][MAX_SIZE], slopes[2][MAX_SIZE], unit[MAX_SIZE] = {0}, curved[MAX_SIZE];
        for (int side = 0; side < 2; side++) {
            memcpy(y, x, n * sizeof *y);
            y[by] += side ? step : -step;
            system->switches(system->model, 0.0, y, values[side]);
            system->switch_gradient(system->model, 0.0, y, which, slopes[side], &by_time);
        }
        unit[by] = 1.0;
        system->switch_curvature(system->model, 0.0, x, which, unit, curved);
        worst = fmax(worst, fabs((values[1][which] - values[0][which]) / (2.0 * step) - gradient[by]));
        for (size_t i = 0; i < n; i++)
            worst = fmax(worst, fabs((slopes[1][i] - slopes[0][i]) / (2.0 * step) - curved[i]));
    }
    return worst;
}
