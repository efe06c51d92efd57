// When a motion counts as settled, with a phase among its coordinates.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "settling.h"

/// Returns the revolutions until the sequence 1e-6 (1 + 2^-n), together with a phase that turns by `rate`, counts as
/// settled; 1000 if it never does.
static int revolutions(double rate) {
    const double turns[2] = {0.0, 6.283185307179586476925};
    settling *s = settling_new(&(whirl_system){.dimension = 2, .turns = turns});
    int n = 0;
    assert_non_null(s);
    for (; n < 1000; n++) {
        const double x[2] = {1e-6 * (1.0 + exp2(-n)), fmod(rate * n, turns[1])};
        if (settling_note(s, x)) break;
    }
    settling_free(s);
    return n;
}

/// The first return to 1e-11 of the size is at n = 37, where 2^-n < 1e-11. It is the first of the 35 in a row that are
/// needed.
static void phases_have_no_part(void **unused) {
    (void)unused;
    const int expected = 37 + 34;
    assert_int_equal(revolutions(0.0), expected);
    assert_int_equal(revolutions(1.7), expected);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(phases_have_no_part)};
    return cmocka_run_group_tests_name("settling", tests, NULL, NULL);
}
