// Evidence other than the exponent, on sections whose answers are known: the 0-1 test, correlation, rotation numbers,
// multipliers.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "correlation.h"
#include "multiplier.h"
#include "near.h"
#include "rotation.h"
#include "section.h"
#include "synthetic.h"
#include "zero_one.h"

static const double two_pi = 6.283185307179586, golden = 0.38196601125010515;

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

static section section_of(const whirl_record *record) {
    return (section){record->section_count, record->dimension, record->section};
}

/// Turns a constant angle p[0] a step, on p[1] curves in turn.
static void turning_map(const double *p, size_t step, double *z, double *v) {
    (void)v;
    z[0] += (double)step < p[1] ? 0.0 : p[0];
    z[1] = (double)(step % (size_t)p[1]);
    v[0] = 1.0;
}

/// A folded closed curve in three dimensions, whose parameter is no angle: a step goes p[0] along it.
static void on_curve(const double *z, double *point) {
    const double along = two_pi * (z[0] + 0.05 * sin(two_pi * z[0]));
    point[0] = cos(along) + 0.2 * cos(2.0 * along) + 7.0 * z[1];
    point[1] = 0.6 * sin(along + 0.3) + 0.1 * z[1];
    point[2] = 0.4 * sin(3.0 * along);
}

static whirl_record *record_rotation(double turn, int curves, size_t watch) {
    const map_system system = {.map = turning_map,
                               .embed = on_curve,
                               .dimension = 2,
                               .section_dimension = 3,
                               .parameters = {turn / curves, curves},
                               .start = {0.123}};
    return record_map(&system, 8, watch, 100);
}

static double zero_one(const map_system *system, size_t watch) {
    whirl_record *record = record_map(system, 2000, watch, 100);
    const section points = section_of(record);
    const double k = zero_one_test(&points, motion_size(record));
    free(record);
    return k;
}

/// Chaos that mixes: logistic maps that are conjugate to the tent or published as chaotic, the Henon map, the standard
/// map at large K.
static void zero_one_sees_chaos(void **state) {
    (void)state;
    const double r[] = {3.7, 3.8, 3.9, 4.0};
    for (size_t i = 0; i < COUNT_OF(r); i++) {
        const map_system system = {
            .map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {r[i]}, .start = {0.3123}};
        assert_true(zero_one(&system, 650) > 0.9);
    }
    const map_system henon = {
        .map = henon_map, .dimension = 2, .section_dimension = 2, .parameters = {1.4, 0.3}, .start = {0.1, 0.1}};
    assert_true(zero_one(&henon, 650) > 0.9);
    const map_system standard = {.map = standard_map,
                                 .embed = on_circle,
                                 .dimension = 2,
                                 .section_dimension = 2,
                                 .parameters = {6.0},
                                 .start = {0.1, 0.2}};
    assert_true(zero_one(&standard, 650) > 0.9);
    assert_true(isnan(zero_one(&henon, 99)));
}

/// The 0-1 test finds no chaos in rotations, periodic points and slow spirals; if nothing moves it has no answer.
static void zero_one_sees_order(void **state) {
    (void)state;
    const double turns[] = {golden, 0.41421356, 0.27201965, 0.1, 0.25, 0.003};
    for (size_t i = 0; i < COUNT_OF(turns); i++) {
        whirl_record *record = record_rotation(turns[i], 1, 650);
        const section points = section_of(record);
        assert_true(fabs(zero_one_test(&points, motion_size(record))) < 0.2);
        free(record);
    }
    const map_system spiral = {
        .map = spiral_map, .dimension = 2, .section_dimension = 2, .parameters = {0.9999, 0.31}, .start = {0.5}};
    assert_true(fabs(zero_one(&spiral, 650)) < 0.2);
    const map_system rest = {
        .map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {2.5}, .start = {0.3}};
    assert_true(isnan(zero_one(&rest, 650)));
}

/// The logistic map at r = 4 has no memory (its points are uncorrelated, although each follows from the one before);
/// rotations never forget.
static void memory(void **state) {
    (void)state;
    const map_system system = {
        .map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {4.0}, .start = {0.3123}};
    whirl_record *record = record_map(&system, 100, 1000, 100);
    section points = section_of(record);
    correlation c = correlation_find(&points, 1e-12);
    assert_true(c.late < 0.2);
    assert_near(c.time, 1.0, 0.0);
    points.count = 63;
    assert_true(isnan(correlation_find(&points, 1e-12).late));
    free(record);

    record = record_rotation(golden, 1, 1000);
    points = section_of(record);
    c = correlation_find(&points, 1e-12);
    assert_true(c.late > 0.98 && isnan(c.time));
    assert_true(isnan(correlation_find(&points, 10.0).late)); // a motion no larger than rounding errors
    free(record);
}

/// A sequence with correlation a^lag: a = 0.9 falls below 0.2 after ln 0.2/ln 0.9 = 15.3 steps.
static void memory_has_a_length(void **state) {
    (void)state;
    enum { COUNT = 1000 };
    static double values[COUNT];
    uint64_t seed = 7;
    double x = 0.0;
    for (size_t n = 0; n < COUNT; n++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        x = 0.9 * x + (double)(seed >> 11) / 9007199254740992.0 - 0.5;
        values[n] = x;
    }
    const section points = {COUNT, 1, values};
    const correlation c = correlation_find(&points, 1e-12);
    assert_true(c.time > 8.0 && c.time < 40.0); // the estimate itself scatters by some 0.1
}

static void rotation_numbers(void **state) {
    (void)state;
    const struct {
        double turn, expected;
        size_t watch;
        double tolerance;
    } rows[] = {{golden, golden, 650, 1e-10},
                {1.0 - golden, golden, 650, 1e-10},
                {0.41421356237, 0.41421356237, 650, 1e-10},
                {0.0827625302982, 0.0827625302982, 650, 1e-8},
                {golden, golden, 150, 1e-4},
                {golden, golden, 5000, 1e-12}};
    for (size_t i = 0; i < COUNT_OF(rows); i++)
        for (int curves = 1; curves <= 3; curves++) {
            whirl_record *record = record_rotation(rows[i].turn, curves, (size_t)curves * rows[i].watch);
            const section points = section_of(record);
            assert_near(rotation_number(&points, curves), rows[i].expected, rows[i].tolerance);
            free(record);
        }
}

/// Points that do not go round a curve have no rotation number, and neither have too few points.
static void no_rotation_number(void **state) {
    (void)state;
    const map_system henon = {
        .map = henon_map, .dimension = 2, .section_dimension = 2, .parameters = {1.4, 0.3}, .start = {0.1, 0.1}};
    whirl_record *record = record_map(&henon, 1000, 650, 100);
    section points = section_of(record);
    assert_true(isnan(rotation_number(&points, 1)));
    free(record);
    record = record_rotation(golden, 1, 650);
    points = section_of(record);
    assert_true(isnan(rotation_number(&points, 0)));
    points.count = 20;
    assert_true(isnan(rotation_number(&points, 1)));
    free(record);
}

/// z(n) = A re(c mu^n) + B re(c' nu^n) about a P-k whose points lie 1 apart.
static multiplier find_multiplier(double complex mu, double complex nu, int period, double amplitude) {
    enum { COUNT = 650 };
    static double points[COUNT][3];
    for (size_t n = 0; n < COUNT; n++) {
        const double complex z = amplitude * cpow(mu, (double)n / period), w = amplitude * cpow(nu, (double)n / period);
        points[n][0] = (double)(n % (size_t)period) + creal(z) + 0.3 * creal(w);
        points[n][1] = 0.7 * creal(z) - 0.4 * cimag(z);
        points[n][2] = 2.0 + creal(w);
    }
    const section all = {COUNT, 3, points[0]};
    return multiplier_find(&all, period, 1.0, 1e-12);
}

static void multipliers(void **state) {
    (void)state;
    for (int period = 1; period <= 4; period++) {
        multiplier m = find_multiplier(0.9, 0.4, period, 1e-3);
        assert_near(m.real, 0.9, 1e-4);
        assert_near(m.imaginary, 0.0, 0.0);
        m = find_multiplier(0.6 + 0.7 * I, 0.2, period, 1e-3);
        assert_near(m.real, 0.6, 1e-4);
        assert_near(m.imaginary, 0.7, 1e-4);
    }
    const multiplier flip = find_multiplier(-0.95, 0.3, 1, 1e-3);
    assert_near(flip.real, -0.95, 1e-4);
    assert_near(flip.imaginary, 0.0, 0.0);
    assert_true(isnan(find_multiplier(0.9, 0.4, 1, 1e-15).real)); // nothing but rounding
    const double still[2] = {0.0, 0.0};
    const section two = {2, 1, still};
    assert_true(isnan(multiplier_find(&two, 0, 1.0, 1e-12).real));
    assert_true(isnan(multiplier_find(&two, 1, 1.0, 1e-12).real));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zero_one_sees_chaos),
        cmocka_unit_test(zero_one_sees_order),
        cmocka_unit_test(memory),
        cmocka_unit_test(memory_has_a_length),
        cmocka_unit_test(rotation_numbers),
        cmocka_unit_test(no_rotation_number),
        cmocka_unit_test(multipliers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
