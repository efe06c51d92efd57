#include "support_torus.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const double pi = 3.14159265358979323846;

/// Carries x over one period by the classical method of Runge and Kutta.
static void carry(slope_fn slope, const void *model, size_t n, double period, int steps, double *x) {
    const double h = period / steps;
    for (int i = 0; i < steps; i++) {
        static const double share[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};
        double k[MAX_COORDINATES] = {0.0}, sum[MAX_COORDINATES] = {0.0}, at[MAX_COORDINATES];
        for (int stage = 0; stage < 4; stage++) {
            for (size_t j = 0; j < n; j++) at[j] = x[j] + share[stage] * h * k[j];
            slope(model, (i + share[stage]) * h, at, k);
            for (size_t j = 0; j < n; j++) sum[j] += weight[stage] * k[j];
        }
        for (size_t j = 0; j < n; j++) x[j] += h / 6.0 * sum[j];
    }
}

double *long_motion(slope_fn slope, const void *model, size_t n, double period, int steps, const double *start,
                    int settling, size_t count) {
    double x[MAX_COORDINATES], *points = calloc(count * n, sizeof *points);
    assert_non_null(points);
    memcpy(x, start, n * sizeof *x);
    for (int k = 0; k < settling; k++) carry(slope, model, n, period, steps, x);
    for (size_t m = 0; m < count; m++) {
        memcpy(points + m * n, x, n * sizeof *x);
        carry(slope, model, n, period, steps, x);
    }
    return points;
}

double folded_turns(double turns) {
    const double part = turns - floor(turns);
    return fmin(part, 1.0 - part);
}

double mean_turn(const double *points, size_t n, size_t count) {
    double centre[2] = {0.0}, sum = 0.0, weights = 0.0;
    for (size_t m = 0; m < count; m++)
        for (size_t i = 0; i < 2; i++) centre[i] += points[m * n + i] / (double)count;
    for (size_t m = 0; m + 1 < count; m++) {
        const double *a = points + m * n, *b = a + n, part = (double)(m + 1) / (double)count;
        const double from = atan2(a[1] - centre[1], a[0] - centre[0]), to = atan2(b[1] - centre[1], b[0] - centre[0]);
        const double turn = (to - from) / (2.0 * pi), weight = exp(-1.0 / (part * (1.0 - part)));
        sum += weight * (turn - floor(turn));
        weights += weight;
    }
    return folded_turns(sum / weights);
}

static double square_between(size_t n, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

/// Returns, of 120 equally spaced angles, the one whose point on the curve is nearest to p.
static double near_angle(const whirl_torus *torus, const double *p) {
    enum { LOOKS = 120 };
    double nearest = INFINITY, angle = 0.0, x[MAX_COORDINATES];
    for (int j = 0; j < LOOKS; j++) {
        whirl_torus_at(torus, 2.0 * pi * j / LOOKS, x);
        const double square = square_between(torus->dimension, x, p);
        if (square < nearest) angle = 2.0 * pi * j / LOOKS;
        nearest = fmin(nearest, square);
    }
    return angle;
}

/// Returns Newton's step from an angle to that of the curve's point nearest to p.
static double step_to_nearest(const whirl_torus *torus, const double *p, double angle) {
    const double h = 1e-4;
    double slope = 0.0, bend = 0.0, x[3][MAX_COORDINATES];
    for (int j = 0; j < 3; j++) whirl_torus_at(torus, angle + (j - 1) * h, x[j]);
    for (size_t i = 0; i < torus->dimension; i++) {
        const double d = (x[2][i] - x[0][i]) / (2.0 * h), dd = (x[2][i] - 2.0 * x[1][i] + x[0][i]) / (h * h);
        slope += (x[1][i] - p[i]) * d;
        bend += d * d + (x[1][i] - p[i]) * dd;
    }
    return -slope / bend;
}

double distance_from(const whirl_torus *torus, const double *points, size_t count) {
    double largest = 0.0, x[MAX_COORDINATES];
    for (size_t m = 0; m < count; m++) {
        const double *p = points + m * torus->dimension;
        double angle = near_angle(torus, p);
        for (int k = 0; k < 6; k++) angle += step_to_nearest(torus, p, angle);
        whirl_torus_at(torus, angle, x);
        largest = fmax(largest, sqrt(square_between(torus->dimension, x, p)));
    }
    return largest;
}
