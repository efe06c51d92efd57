// Orders over the turns of a record against sums of sinusoids.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
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

enum { TURNS = 7, SAMPLES = 12, CHANNELS = 2, COUNT = TURNS * SAMPLES, ORDERS = 4 };
static double turned[CHANNELS * COUNT], vectors[2 * CHANNELS * ORDERS * TURNS];
static const double orders[ORDERS] = {0.0, 0.5, 1.0, 2.0};

/// Fills two channels: means 3 and -2, and orders 1/2, 1, 2 and 5 of known amplitudes and lags, half as large in the
/// second channel.
static void fill(void) {
    for (size_t i = 0; i < COUNT; i++) {
        const double angle = two_pi * (double)(i + 1) / SAMPLES;
        const double z = 4.0 * cos(0.5 * angle - 0.4) + 7.0 * cos(angle - 1.0) + cos(2.0 * angle + 0.3);
        turned[i] = 3.0 + z + 5.0 * cos(5.0 * angle);
        turned[COUNT + i] = -2.0 + 0.5 * z;
    }
}

static void check_rows(size_t rows, const double amplitude[ORDERS], const double lag[ORDERS]) {
    for (size_t c = 0; c < CHANNELS; c++) {
        for (size_t k = 0; k < ORDERS; k++) {
            const double size = k == 0 ? (c == 0 ? 3.0 : -2.0) : amplitude[k] * (c == 0 ? 1.0 : 0.5);
            for (size_t row = 0; row < rows; row++) {
                const double *vector = vectors + 2 * ((c * ORDERS + k) * rows + row);
                assert_near(vector[0], size * cos(lag[k]), 1e-13);
                assert_near(vector[1], -size * sin(lag[k]), 1e-13);
            }
        }
    }
}

/// Integrals over two turns separate all orders; the seventh turn is left out.
static void orders_do_not_leak(void **state) {
    (void)state;
    const double amplitude[ORDERS] = {1.0, 4.0, 7.0, 1.0}, lag[ORDERS] = {0.0, 0.4, 1.0, -0.3};
    fill();
    memset(vectors, 0x7f, sizeof vectors);
    assert_ok(whirl_signals_track(turned, CHANNELS, TURNS, SAMPLES, orders, ORDERS, 2, vectors));
    check_rows(3, amplitude, lag);
    uint64_t kept;
    memcpy(&kept, vectors + 2 * CHANNELS * ORDERS * 3, sizeof kept);
    assert_true(kept == 0x7f7f7f7f7f7f7f7fULL); // nothing is written behind the rows
    assert_ok(whirl_signals_track(turned, CHANNELS, 6, SAMPLES, orders, 0, 2, vectors));
}

/// A mean that drifts by d a turn leaks into 1X by d/pi, as the integral of a ramp says.
static void a_drift_leaks_as_its_integral(void **state) {
    (void)state;
    enum { FINE = 4000 };
    static double ramp[2 * FINE];
    double once[4];
    const double one = 1.0;
    for (size_t i = 0; i < 2 * FINE; i++) ramp[i] = (double)(i + 1) / FINE;
    assert_ok(whirl_signals_track(ramp, 1, 2, FINE, &one, 1, 1, once));
    // 2/(2 pi) int (angle/2 pi) e^(-i angle) d angle = i/pi, the sum of FINE samples differs by 1/FINE.
    for (size_t row = 0; row < 2; row++) {
        assert_near(once[2 * row], 0.0, 1.001 / FINE);
        assert_near(once[2 * row + 1], 1.0 / (0.5 * two_pi), 1e-6);
    }
}

static void refusals(void **state) {
    (void)state;
    const double half = 0.5, sixth = 6.0, negative = -1.0, none = NAN;
    fill();
    assert_refused(whirl_signals_track(turned, 2, TURNS, SAMPLES, &half, 1, 1, vectors),
                   "the order 0.5 has no whole number of periods in 1 revolutions, expected a multiple of 1");
    assert_refused(whirl_signals_track(turned, 2, TURNS, SAMPLES, &sixth, 1, 1, vectors),
                   "an order is 6, expected 0 or more and below half of 12 samples");
    assert_refused(whirl_signals_track(turned, 2, TURNS, SAMPLES, &negative, 1, 1, vectors), "an order is -1");
    assert_refused(whirl_signals_track(turned, 2, TURNS, SAMPLES, &none, 1, 1, vectors), "an order is nan");
    assert_refused(whirl_signals_track(turned, 2, TURNS, SAMPLES, orders, 1, 8, vectors),
                   "orders are tracked over 8 revolutions, expected 1 to 7");
    assert_refused(whirl_signals_track(turned, 2, TURNS, SAMPLES, orders, 1, 0, vectors), "over 0 revolutions");
    assert_refused(whirl_signals_track(turned, 2, TURNS, 2, orders, 1, 1, vectors), "there are 2 samples per");
    assert_refused(whirl_signals_track(turned, 2, SIZE_MAX / 2, SAMPLES, orders, 1, 1, vectors), "expected at most");
    assert_refused(whirl_signals_track(turned, 0, TURNS, SAMPLES, orders, 1, 1, vectors), "there is no channel");
    turned[COUNT + 3] = INFINITY;
    assert_refused(whirl_signals_track(turned, 2, TURNS, SAMPLES, orders, 1, 1, vectors),
                   "sample 3 of channel 1 is inf");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orders_do_not_leak),
        cmocka_unit_test(a_drift_leaks_as_its_integral),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
