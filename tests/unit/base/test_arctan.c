// The kernels' arctangent against the C library's in extended precision, over the whole range.
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#define VECTOR_ISA VECTOR_SCALAR
#include "arctan.h"

static double uniform(uint64_t *seed) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

/// Error in units in the last place of the true value, which 64-bit significands give to 1/1000 of one.
static double error_in_ulps(double y, double x) {
    const long double truth = atan2l((long double)y, (long double)x);
    int exponent;
    frexpl(truth, &exponent);
    const long double ulp = ldexpl(1.0L, exponent - DBL_MANT_DIG);
    return (double)fabsl(((long double)v_arctan_quotient(y, x) - truth) / ulp);
}

static void test_whole_range(void **state) {
    double worst = 0.0;
    uint64_t seed = 7;
    (void)state;
    for (int i = 0; i < 4000000; i++) {
        // Quotients from 2^-60 to 2^60, dense about the borders tan(pi/8) and tan(3 pi/8).
        const double spread = i % 2 ? 4.0 : 120.0;
        const double x = exp2(spread * 0.5 * (uniform(&seed) - 0.5)), y = exp2(spread * 0.5 * (uniform(&seed) - 0.5));
        worst = fmax(worst, error_in_ulps(i % 3 ? y : -y, x));
    }
    printf("largest error %.3f units in the last place\n", worst);
    assert_true(worst < 2.5);
}

static void test_special_values(void **state) {
    (void)state;
    assert_true(v_arctan_quotient(0.0, 1.0) == 0.0);
    assert_true(signbit(v_arctan_quotient(-0.0, 1.0)));
    assert_true(v_arctan_quotient(1.0, 1.0) == atan(1.0));
    assert_true(v_arctan_quotient(-1.0, 1.0) == -atan(1.0));
    assert_true(v_arctan_quotient(1.0, 1e-300) == 2 * atan(1.0));
    assert_true(v_arctan_quotient(1e-300, 1.0) == 1e-300);
    assert_true(isnan(v_arctan_quotient(NAN, 1.0)) && isnan(v_arctan_quotient(1.0, NAN)));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_whole_range), cmocka_unit_test(test_special_values)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
