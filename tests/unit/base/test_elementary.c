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

/// Error in units in the last place of the true value, which 64-bit significands give to 1/1000 of one.
static double error_in_ulps(double value, long double truth) {
    int exponent;
    frexpl(truth, &exponent);
    const long double ulp = ldexpl(1.0L, exponent - DBL_MANT_DIG);
    return (double)fabsl(((long double)value - truth) / ulp);
}

static void test_inverse_root(void **state) {
    double worst = 0.0;
    uint64_t seed = 11;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        const double a = exp2((i % 2 ? 2.0 : 1900.0) * (uniform(&seed) - 0.5));
        worst = fmax(worst, error_in_ulps(v_inverse_root(a), 1.0L / sqrtl((long double)a)));
    }
    printf("largest error: 1/sqrt(a) %.3f units in the last place\n", worst);
    assert_true(worst < 1.5);
    assert_true(isnan(v_inverse_root(NAN)));
}

/// atan(y/x), x > 0, as the film has it, with a division of its own.
static double arctan_quotient(double y, double x) {
    const arctan_fold fold = v_arctan_fold(y, x);
    return v_arctan_unfold(fold.numerator / fold.denominator, fold.centre, y);
}

static void test_whole_range(void **state) {
    double worst = 0.0;
    uint64_t seed = 7;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        // Quotients from 2^-60 to 2^60, dense about the borders tan(pi/8) and tan(3 pi/8).
        const double spread = i % 2 ? 4.0 : 120.0;
        const double x = exp2(spread * 0.5 * (uniform(&seed) - 0.5)), y = exp2(spread * 0.5 * (uniform(&seed) - 0.5));
        worst = fmax(worst, error_in_ulps(arctan_quotient(i % 3 ? y : -y, x),
                                          atan2l((long double)(i % 3 ? y : -y), (long double)x)));
    }
    printf("largest error %.3f units in the last place\n", worst);
    assert_true(worst < 3.0);
}

static void test_special_values(void **state) {
    (void)state;
    assert_true(arctan_quotient(0.0, 1.0) == 0.0);
    assert_true(signbit(arctan_quotient(-0.0, 1.0)));
    assert_true(arctan_quotient(1.0, 1.0) == atan(1.0));
    assert_true(arctan_quotient(-1.0, 1.0) == -atan(1.0));
    assert_true(arctan_quotient(1.0, 1e-300) == 2 * atan(1.0));
    assert_true(arctan_quotient(1e-300, 1.0) == 1e-300);
    assert_true(isnan(arctan_quotient(NAN, 1.0)) && isnan(arctan_quotient(1.0, NAN)));
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sine_and_cosine), cmocka_unit_test(test_whole_range),
                                       cmocka_unit_test(test_special_values), cmocka_unit_test(test_inverse_root)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
