// The number of revolutions after which phases repeat.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "machine.h"

static void ratios(void **unused) {
    (void)unused;
    assert_int_equal(repeats_of(3.0), 1);
    assert_int_equal(repeats_of(0.0), 1);
    assert_int_equal(repeats_of(-1.25), 4);
    assert_int_equal(repeats_of(1.0 / 3.0), 3);
    // All fractions in lowest terms, as they round; not the next numbers that differ by more than rounding.
    for (int q = 2; q <= WHIRL_MAX_REPEATS; q++)
        for (int p = 1; p < 3 * q; p++) {
            int a = p, b = q;
            while (b) {
                const int rest = a % b;
                a = b;
                b = rest;
            }
            assert_int_equal(repeats_of((double)p / q), q / a);
            assert_int_equal(repeats_of((double)p / q * (1.0 + 1e-12)), 0);
        }
    assert_int_equal(repeats_of(1.0 / (WHIRL_MAX_REPEATS + 1)), 0);
    assert_int_equal(repeats_of(sqrt(2.0)), 0);
    // 50 Hz with 1800 rpm and with 1530 rpm.
    assert_int_equal(repeats_of(50.0 * 6.283185307179586476925 / (1800.0 * 6.283185307179586476925 / 60.0)), 3);
    assert_int_equal(repeats_of(50.0 * 6.283185307179586476925 / (1530.0 * 6.283185307179586476925 / 60.0)), 51);
}

static void together(void **unused) {
    (void)unused;
    assert_int_equal(repeats_of_both(2, 3), 6);
    assert_int_equal(repeats_of_both(4, 6), 12);
    assert_int_equal(repeats_of_both(5, 5), 5);
    assert_int_equal(repeats_of_both(0, 5), 0);
    assert_int_equal(repeats_of_both(5, 0), 0);
    assert_int_equal(repeats_of_both(11, 13), 0); // 143
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(ratios), cmocka_unit_test(together)};
    return cmocka_run_group_tests_name("repeats", tests, NULL, NULL);
}
