// Watched quantities are folded as their lines in whirl/engine/watched.h say: each fold, of values and of squares,
// agrees with the closed form of a sinusoid at equal distances over whole periods.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "kernels/watched_kernel.h"
#include "watch.h"

enum { INSTANTS = 1000 };

static const double mean = 3.0, amplitude = 2.0; // positive: a root knows no sign

static double value_at(int i) {
    return mean + amplitude * cos(2.0 * 3.14159265358979323846 * i / INSTANTS);
}

static double folded(whirl_fold fold, bool square) {
    double so_far = fold_none(fold);
    for (int i = 0; i < INSTANTS; i++) {
        const double value = value_at(i);
        so_far = watched_with(fold, square ? value * value : value, so_far);
    }
    return fold_end(fold, square, so_far, 1.0 / INSTANTS);
}

static void every_fold_has_its_closed_form(void **state) {
    const double rms = sqrt(mean * mean + 0.5 * amplitude * amplitude);
    const struct {
        whirl_fold fold;
        bool square;
        double expected;
    } rows[] = {{WHIRL_LARGEST, false, mean + amplitude},
                {WHIRL_LARGEST, true, mean + amplitude},
                {WHIRL_SMALLEST, false, mean - amplitude},
                {WHIRL_SMALLEST, true, mean - amplitude},
                {WHIRL_MEAN, false, mean},
                {WHIRL_MEAN, true, rms},
                {WHIRL_SUM, false, INSTANTS * mean},
                {WHIRL_SUM, true, sqrt(INSTANTS) * rms}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_true(fabs(folded(rows[i].fold, rows[i].square) / rows[i].expected - 1.0) < 1e-13);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_fold_has_its_closed_form)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
