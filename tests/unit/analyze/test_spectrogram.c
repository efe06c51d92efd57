// Spectra of windows over time against sinusoids on their frequencies, and the loss of a sweep against error functions.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "near.h"
#include "whirl/signals.h"

static const double two_pi = 6.283185307179586476925;

#define assert_ok(call) assert_string_equal((call).message, "")

static void assert_refused(whirl_status status, const char *words) {
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    if (!strstr(status.message, words)) fail_msg("'%s' does not say '%s'", status.message, words);
}

/// A Hann window keeps the part of the amplitude of a sweep that quadrature and error functions of complex arguments
/// give.
static void loss_of_a_sweep(void **state) {
    (void)state;
    static const double known[3][2] = {{0.25, 0.9995372077858}, {1.0, 0.992644641011}, {4.0, 0.8942682817821}};
    double kept, again;
    for (size_t i = 0; i < 3; i++) {
        assert_ok(whirl_signals_sweep(known[i][0], &kept));
        assert_near(kept, known[i][1], i == 1 ? 5e-13 : 5e-14);
        assert_ok(whirl_signals_sweep(-known[i][0], &again));
        assert_near(again, kept, 0.0);
    }
    assert_ok(whirl_signals_sweep(0.0, &kept));
    assert_near(kept, 1.0, 1e-15);
    // Small sweeps: 1 - (pi s)^2 (<u^4> - <u^2>^2)/2 with <u^2> = 1/12 - 1/(2 pi^2), <u^4> = 1/80 - 1/(4 pi^2) + 3/(2
    // pi^4) of the window.
    const double pi = 0.5 * two_pi, squares = 1.0 / 12.0 - 0.5 / (pi * pi);
    const double fourths = 1.0 / 80.0 - 0.25 / (pi * pi) + 1.5 / (pi * pi * pi * pi);
    assert_ok(whirl_signals_sweep(0.01, &kept));
    assert_near(kept, 1.0 - 0.5e-4 * pi * pi * (fourths - squares * squares), 1e-11);
    // Large sweeps: the stationary phase in the middle, where the window is twice its mean.
    assert_ok(whirl_signals_sweep(1e6, &kept));
    assert_near(kept, 2e-3, 1e-8);
    assert_refused(whirl_signals_sweep(1.1e6, &kept), "the sweep is 1.1e+06, expected at most 1e+06");
    assert_refused(whirl_signals_sweep(NAN, &kept), "the sweep is nan");
}

enum { COUNT = 200, WINDOW = 40, STEP = 30, ROWS = (COUNT - WINDOW) / STEP + 1, BINS = 20 };
static double x[COUNT], y[COUNT], rows[ROWS * BINS * 4];

static void check_bin(size_t row, size_t bin, const double expected[4]) {
    for (size_t c = 0; c < 4; c++) assert_near(rows[(row * BINS + bin) * 4 + c], expected[c], 1e-13);
}

/// An ellipse of frequency 5 and a mean have the same amplitudes in all windows, half of them in the next bins.
static void ellipse_in_all_windows(void **state) {
    (void)state;
    assert_int_equal(whirl_signals_frequencies(WINDOW), BINS);
    assert_int_equal(whirl_signals_frequencies(WINDOW + 1), BINS + 1);
    assert_int_equal(whirl_signals_frequencies(0), 0);
    for (size_t i = 0; i < COUNT; i++) {
        const double angle = two_pi * 5.0 * (double)i / WINDOW;
        x[i] = 1.0 + 3.0 * cos(angle), y[i] = -2.0 + 1.5 * sin(angle);
    }
    assert_ok(whirl_signals_spectrogram(x, y, COUNT, WINDOW, STEP, rows));
    const double line[4] = {3.0, 1.5, 2.25, 0.75}, next[4] = {1.5, 0.75, 1.125, 0.375}, none[4] = {0};
    for (size_t row = 0; row < ROWS; row++) {
        check_bin(row, 4, next), check_bin(row, 5, line), check_bin(row, 6, next);
        for (size_t bin = 0; bin < BINS; bin++)
            if (bin < 4 || bin > 6) check_bin(row, bin, none);
    }
    assert_ok(whirl_signals_spectrogram(x, NULL, COUNT, WINDOW, STEP, rows));
    const double alone[4] = {3.0, 0.0, 1.5, 1.5};
    check_bin(ROWS - 1, 5, alone);
}

static void refusals(void **state) {
    (void)state;
    memset(x, 0, sizeof x);
    assert_refused(whirl_signals_spectrogram(x, NULL, COUNT, 7, STEP, rows),
                   "a window has 7 samples, expected 8 to 200");
    assert_refused(whirl_signals_spectrogram(x, NULL, COUNT, 201, STEP, rows), "a window has 201 samples");
    assert_refused(whirl_signals_spectrogram(x, NULL, COUNT, WINDOW, 0, rows), "windows are 0 samples apart");
    assert_refused(whirl_signals_spectrogram(x, NULL, 900000000, 100000, 1, rows), "windows of 50000 frequencies");
    x[7] = NAN;
    assert_refused(whirl_signals_spectrogram(y, x, COUNT, WINDOW, STEP, rows), "sample 7 of channel 0 is nan");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loss_of_a_sweep),
        cmocka_unit_test(ellipse_in_all_windows),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
