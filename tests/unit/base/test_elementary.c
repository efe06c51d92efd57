// The kernels' elementary functions against the C library's in extended precision, over their whole range.
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#define VECTOR_ISA VECTOR_SCALAR
#include "elementary.h"

static double uniform(uint64_t *seed) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

/// Returns the error in units in the last place of the true value, which has 64-bit significands: 1/1000 of a unit.
static double error_in_ulps(double value, long double truth) {
    int exponent;
    frexpl(truth, &exponent);
    const long double ulp = ldexpl(1.0L, exponent - DBL_MANT_DIG);
    return (double)fabsl(((long double)value - truth) / ulp);
}

static void test_root(void **state) {
    double worst = 0.0;
    uint64_t seed = 11;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        const double a = exp2((i % 2 ? 2.0 : 1900.0) * (uniform(&seed) - 0.5));
        worst = fmax(worst, error_in_ulps(v_root_of_3_over(a), sqrtl(3.0L / (long double)a)));
    }
    printf("largest error: sqrt(3/a) %.3f units in the last place\n", worst);
    assert_true(worst < 1.5);
    assert_true(isnan(v_root_of_3_over(NAN)));
}

static void test_other_roots(void **state) {
    double worst[2] = {0.0};
    uint64_t seed = 13;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        const double a = exp2((i % 2 ? 4.0 : 1900.0) * (uniform(&seed) - 0.5));
        worst[0] = fmax(worst[0], error_in_ulps(v_over_root(a), 1.0L / sqrtl((long double)a)));
        worst[1] = fmax(worst[1], error_in_ulps(v_ninth_root(a), powl((long double)a, 1.0L / 9.0L)));
    }
    printf("largest errors: 1/sqrt %.3f, ninth root %.3f units in the last place\n", worst[0], worst[1]);
    assert_true(worst[0] < 2.5 && worst[1] < 2.5);
    assert_true(v_pow(2.0, 0.5) == sqrt(2.0) && isnan(v_pow(0.0, 0.5)) && isnan(v_pow(-1.0, 0.5)));
    assert_true(isnan(v_ninth_root(NAN)) && isnan(v_over_root(NAN)));
}

/// Returns atan(y/x) for x > 0 by the division of the film's kernel.
static double angle_of(double y, double x) {
    const double over = x / (x * x + y * y);
    return v_half_angle(x * over - 0.5, y * over);
}

static void test_whole_range(void **state) {
    double worst = 0.0;
    uint64_t seed = 7;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        // Quotients from 2^-60 to 2^60, dense about 1.
        const double spread = i % 2 ? 4.0 : 120.0;
        const double x = exp2(spread * 0.5 * (uniform(&seed) - 0.5)), y = exp2(spread * 0.5 * (uniform(&seed) - 0.5));
        const long double truth = atan2l((long double)(i % 3 ? y : -y), (long double)x);
        worst = fmax(worst, (double)fabsl((long double)angle_of(i % 3 ? y : -y, x) - truth));
    }
    printf("largest error: angle %.3f 2^-52\n", worst / DBL_EPSILON);
    assert_true(worst < 2.0 * DBL_EPSILON);
}

static void test_special_values(void **state) {
    (void)state;
    const double near = 2.0 * DBL_EPSILON, pi_2 = 1.57079632679489661923;
    assert_true(fabs(angle_of(0.0, 1.0)) < near && fabs(angle_of(-0.0, 1.0)) < near);
    assert_true(fabs(angle_of(1.0, 1.0) - 0.5 * pi_2) < near && fabs(angle_of(1.0, 1e-300) - pi_2) < near);
    assert_true(angle_of(-1.0, 1.0) == -angle_of(1.0, 1.0) && angle_of(-1.0, 1e-300) == -angle_of(1.0, 1e-300));
    assert_true(isnan(angle_of(NAN, 1.0)) && isnan(angle_of(1.0, NAN)));
}

/// Angles that are added to others need a small absolute error.
static void test_sine_and_cosine_of_small_angles(void **state) {
    double worst = 0.0, s, c;
    uint64_t seed = 17;
    (void)state;
    for (int i = 0; i < 2000000; i++) {
        const double r = (uniform(&seed) - 0.5) * (i % 2 ? 1.5707963267948966 : 0.1);
        v_sincos_small(r, &s, &c);
        worst = fmax(worst, fmax((double)fabsl(s - sinl(r)), (double)fabsl(c - cosl(r))));
    }
    printf("largest error: small angles %.3f 2^-52\n", worst / DBL_EPSILON);
    assert_true(worst < 0.75 * DBL_EPSILON);
    v_sincos_small(0.0, &s, &c);
    assert_true(s == 0.0 && c == 1.0);
}

static void test_sine_and_cosine(void **state) {
    double worst[2] = {0.0, 0.0};
    uint64_t seed = 23;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        // Over [0, 8 pi], every other time close to a multiple of pi/4: down to 2^-70 from it, which rounding makes 0.
        const double eighths = (double)(int)(33.0 * uniform(&seed)), apart = exp2(-70.0 * uniform(&seed));
        const double pi_4 = 0.785398163397448309616;
        double t = i % 2 ? 32.0 * pi_4 * uniform(&seed) : eighths * pi_4 + (i % 4 ? apart : -apart);
        t = fmin(fmax(t, 0.0), 32.0 * pi_4);
        double s, c;
        v_sincos(t, &s, &c);
        // Beyond 64 bits near the zeros: the C library's extended functions are exact to their last place there too.
        if (t > 0.0) worst[0] = fmax(worst[0], error_in_ulps(s, sinl((long double)t)));
        worst[1] = fmax(worst[1], error_in_ulps(c, cosl((long double)t)));
    }
    printf("largest errors: sin %.3f, cos %.3f units in the last place\n", worst[0], worst[1]);
    assert_true(worst[0] < 1.0 && worst[1] < 1.0);
    double s, c;
    v_sincos(0.0, &s, &c);
    assert_true(s == 0.0 && c == 1.0);
    v_sincos(NAN, &s, &c);
    assert_true(isnan(s) && isnan(c));
}

/// Phases that turn many times in a revolution, in both directions, need a small absolute error.
static void test_sine_and_cosine_of_large_angles(void **state) {
    double worst = 0.0, s, c;
    uint64_t seed = 29;
    (void)state;
    for (int i = 0; i < 2000000; i++) {
        const double t = (i % 2 ? 20000.0 : 100.0) * (uniform(&seed) - 0.5);
        v_sincos(t, &s, &c);
        worst = fmax(worst, fmax((double)fabsl(s - sinl(t)), (double)fabsl(c - cosl(t))));
    }
    printf("largest error: large angles %.3f 2^-52\n", worst / DBL_EPSILON);
    assert_true(worst < 0.5 * DBL_EPSILON);
}

static void test_logarithm(void **state) {
    double worst = 0.0;
    uint64_t seed = 31;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        // All sizes, every other time close to 1, down to 2^-52 from it.
        const double apart = exp2(-52.0 * uniform(&seed)),
                     a = i % 2 ? exp2(2040.0 * (uniform(&seed) - 0.5)) : 1.0 + (i % 4 ? 0.5 * apart : apart);
        if (a != 1.0) worst = fmax(worst, error_in_ulps(v_log(a), logl((long double)a)));
    }
    printf("largest error: ln %.3f units in the last place\n", worst);
    assert_true(worst < 1.5);
    assert_true(v_log(1.0) == 0.0);
    assert_true(isnan(v_log(0.0)) && isnan(v_log(-1.0)) && isnan(v_log(NAN)));
}

static void test_exponential(void **state) {
    double worst = 0.0;
    uint64_t seed = 37;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        const double a = (i % 2 ? 1416.0 : 2.0) * (uniform(&seed) - 0.5);
        worst = fmax(worst, error_in_ulps(v_exp(a), expl((long double)a)));
    }
    printf("largest error: exp %.3f units in the last place\n", worst);
    assert_true(worst < 1.0);
    assert_true(v_exp(0.0) == 1.0 && v_exp(-800.0) == 0.0 && isinf(v_exp(800.0)) && isnan(v_exp(NAN)));
}

static void test_power(void **state) {
    double worst = 0.0;
    uint64_t seed = 41;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        const double a = exp2((i % 2 ? 2.0 : 100.0) * (uniform(&seed) - 0.5)), b = 10.0 * (uniform(&seed) - 0.5);
        const double size = 1.0 + fabs(b * log(a));
        worst = fmax(worst, error_in_ulps(v_pow(a, b), powl((long double)a, (long double)b)) / size);
    }
    printf("largest error: a^b %.3f (1 + |b ln a|) units in the last place\n", worst);
    assert_true(worst < 2.0);
    assert_true(v_pow(0.3, 0.0) == 1.0 && v_pow(1.0, 0.7) == 1.0);
    assert_true(isnan(v_pow(0.0, 2.0)) && isnan(v_pow(-1.0, 0.0)) && isnan(v_pow(NAN, 0.0)));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_logarithm),
                                       cmocka_unit_test(test_exponential),
                                       cmocka_unit_test(test_power),
                                       cmocka_unit_test(test_sine_and_cosine),
                                       cmocka_unit_test(test_sine_and_cosine_of_large_angles),
                                       cmocka_unit_test(test_sine_and_cosine_of_small_angles),
                                       cmocka_unit_test(test_whole_range),
                                       cmocka_unit_test(test_special_values),
                                       cmocka_unit_test(test_root),
                                       cmocka_unit_test(test_other_roots)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
