// Closed curves as trigonometric polynomials: exact for curves that are such.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "harmonics.h"

enum { COUNT = 9, MANY = 31, N = 2 };

static const double two_pi = 6.283185307179586476925;

/// Computes a curve with harmonics up to the fourth, which nine points determine, and its derivative.
static void curve_at(double t, double *x, double *slope) {
    x[0] = 1.5 + cos(t) - 0.25 * sin(2.0 * t) + 0.125 * cos(4.0 * t);
    x[1] = -0.5 + 2.0 * sin(t) + 0.375 * cos(3.0 * t) - 0.0625 * sin(4.0 * t);
    slope[0] = -sin(t) - 0.5 * cos(2.0 * t) - 0.5 * sin(4.0 * t);
    slope[1] = 2.0 * cos(t) - 1.125 * sin(3.0 * t) - 0.25 * cos(4.0 * t);
}

static void make_points(size_t count, double *points) {
    double slope[N];
    for (size_t j = 0; j < count; j++) curve_at(two_pi * (double)j / (double)count, points + N * j, slope);
}

static void assert_near(double expected, double obtained) {
    assert_true(fabs(expected - obtained) < 1e-13);
}

static void series_hold_the_curve(void **state) {
    (void)state;
    double points[COUNT * N], series[COUNT * N], x[N], slope[N], value[N], derivative[N];
    make_points(COUNT, points);
    harmonics_of(COUNT, N, points, series);
    assert_near(1.5, series[0]);
    assert_near(1.0, series[N]);             // cos t of the first coordinate
    assert_near(2.0, series[2 * N + 1]);     // sin t of the second
    assert_near(-0.0625, series[8 * N + 1]); // sin 4t
    assert_near(sqrt(5.0), harmonics_size(N, series, 1));
    assert_near(0.375, harmonics_size(N, series, 3));
    for (int k = 0; k < 50; k++) {
        curve_at(-3.0 + 0.37 * k, x, slope);
        harmonics_at(COUNT, N, series, -3.0 + 0.37 * k, value, derivative);
        for (int i = 0; i < N; i++) {
            assert_near(x[i], value[i]);
            assert_near(slope[i], derivative[i]);
        }
    }
}

static void weights_give_the_same(void **state) {
    (void)state;
    double points[COUNT * N], weights[COUNT], slopes[COUNT], x[N], slope[N];
    make_points(COUNT, points);
    for (int k = 0; k < 50; k++) {
        const double angle = -3.0 + 0.37 * k;
        double sum = 0.0, value[N] = {0.0}, derivative[N] = {0.0};
        harmonics_weights(COUNT, angle, weights, slopes);
        curve_at(angle, x, slope);
        for (int j = 0; j < COUNT; j++) {
            sum += weights[j];
            for (int i = 0; i < N; i++) {
                value[i] += weights[j] * points[N * j + i];
                derivative[i] += slopes[j] * points[N * j + i];
            }
        }
        assert_near(1.0, sum);
        for (int i = 0; i < N; i++) {
            assert_near(x[i], value[i]);
            assert_near(slope[i], derivative[i]);
        }
    }
}

/// With more points the curve stays the same; with fewer, its last harmonics are left out.
static void points_may_be_more_or_fewer(void **state) {
    (void)state;
    double points[COUNT * N], series[COUNT * N], spread[MANY * N], expected[MANY * N], slopes[MANY * N], x[N], slope[N];
    make_points(COUNT, points);
    harmonics_of(COUNT, N, points, series);
    harmonics_spread(COUNT, N, series, 0.0, MANY, spread, slopes);
    make_points(MANY, expected);
    for (int i = 0; i < MANY * N; i++) assert_near(expected[i], spread[i]);
    curve_at(two_pi * 5.0 / MANY, x, slope);
    for (int i = 0; i < N; i++) assert_near(slope[i], slopes[N * 5 + i]);
    harmonics_spread(COUNT, N, series, 0.3, 5, spread, NULL);
    for (int j = 0; j < 5; j++) {
        const double t = 0.3 + two_pi * j / 5;
        assert_near(1.5 + cos(t) - 0.25 * sin(2.0 * t), spread[N * j]);
        assert_near(-0.5 + 2.0 * sin(t), spread[N * j + 1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(series_hold_the_curve), cmocka_unit_test(weights_give_the_same),
                                       cmocka_unit_test(points_may_be_more_or_fewer)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
