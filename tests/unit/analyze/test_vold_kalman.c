// Vold-Kalman order tracking against 40-digit solutions of the dense normal equations, closed forms and signals that
// are known.
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

// ---------------------------------------------------------------- two orders of a run-up, and a line between them

enum { COUNT = 80, ORDERS = 2 };
static double y[COUNT], phases[ORDERS * COUNT], found[2 * ORDERS * COUNT];
static const double widths[ORDERS] = {2.0, 2.0};

static void fill(double phase_at_first) {
    for (size_t i = 0; i < COUNT; i++) {
        const double t = (double)i / 200.0, phase = two_pi * (5.0 * t + 10.0 * t * t);
        phases[i] = phase + phase_at_first, phases[COUNT + i] = 2.0 * (phase + phase_at_first);
        y[i] = (1.0 + 0.5 * t) * cos(phase + 0.3) + 0.4 * cos(2.0 * phase - 1.1) + 0.2 * cos(two_pi * 17.0 * t);
    }
}

static double largest_error(const double expected[ORDERS][3][2]) {
    const size_t at[3] = {0, 40, 79};
    double worst = 0.0;
    for (size_t k = 0; k < ORDERS; k++)
        for (size_t i = 0; i < 3; i++)
            for (size_t part = 0; part < 2; part++)
                worst = fmax(worst, fabs(found[2 * (k * COUNT + at[i]) + part] - expected[k][i][part]));
    return worst;
}

/// Amplitudes and weights agree to the twelve digits of a computation in 40 digits.
static void digits_of_two_orders(void **state) {
    (void)state;
    static const double one[ORDERS][3][2] = {
        {{1.065960739212, 0.171935893687}, {1.085661288785, 0.313774356593}, {1.235496151702, 0.34870636993}},
        {{0.191560714038, -0.378296630355}, {0.07603888476, -0.383368801036}, {0.127856840246, -0.34778313966}}};
    static const double two[ORDERS][3][2] = {
        {{0.936331151617, 0.107525544132}, {1.07391210888, 0.298574129075}, {1.308154048215, 0.428194633638}},
        {{0.228169617846, -0.410201267671}, {0.093703045629, -0.364802403778}, {0.094332927781, -0.309638559367}}};
    double weight;
    fill(0.0);
    assert_ok(whirl_signals_vold_kalman_weight(2.0, 200.0, 1, &weight));
    assert_near(weight, 20.487083826251, 5e-13);
    assert_ok(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, ORDERS, widths, 1, found));
    const double first = largest_error(one);
    assert_ok(whirl_signals_vold_kalman_weight(2.0, 200.0, 2, &weight));
    assert_near(weight, 652.150950399, 5e-10);
    assert_ok(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, ORDERS, widths, 2, found));
    const double second = largest_error(two);
    print_message("two orders of a run-up: 1 pole %.2g, 2 poles %.2g\n", first, second);
    assert_true(first < 1e-12 && second < 1e-12);
}

/// Another zero of the angle turns amplitudes and changes nothing else; another unit of time changes no bit.
static void zero_and_unit_do_not_matter(void **state) {
    (void)state;
    static double usual[2 * ORDERS * COUNT];
    fill(0.0);
    assert_ok(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, ORDERS, widths, 2, usual));
    const double slow[ORDERS] = {2.0 / 1024.0, 2.0 / 1024.0};
    assert_ok(whirl_signals_vold_kalman(y, COUNT, 200.0 / 1024.0, phases, ORDERS, slow, 2, found));
    assert_memory_equal(found, usual, sizeof usual);
    fill(0.7);
    assert_ok(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, ORDERS, widths, 2, found));
    for (size_t k = 0; k < ORDERS; k++) {
        const double c = cos(0.7 * (double)(k + 1)), s = sin(0.7 * (double)(k + 1));
        for (size_t i = k * COUNT; i < (k + 1) * COUNT; i++) {
            assert_near(found[2 * i], usual[2 * i] * c + usual[2 * i + 1] * s, 1e-11);
            assert_near(found[2 * i + 1], usual[2 * i + 1] * c - usual[2 * i] * s, 1e-11);
        }
    }
}

// ---------------------------------------------------------------- the gain

static double gain(double weight, double distance, int poles) {
    return 1.0 / (1.0 + weight * weight * pow(2.0 * sin(0.5 * two_pi * distance), 2 * poles));
}

/// A line next to the tracked frequency passes with the gain 1/(1 + r^2 (2 sin(pi f/rate))^2p), half the power at the
/// edge of the band, also in a band of 1e-4 of the rate, whose normal equations would have no digit.
static void gain_of_a_line(void **state) {
    (void)state;
    enum { LONG = 400000 };
    double *line = malloc(4 * sizeof *line * LONG), *phase = line + LONG, *out = phase + LONG;
    assert_non_null(line);
    double worst = 0.0;
    for (int poles = 1; poles <= 2; poles++) {
        const double width = 1e-3 / (poles == 2 ? 10.0 : 1.0), offsets[] = {0.5, 0.2, 1.5};
        for (size_t o = 0; o < 3; o++) {
            double weight;
            assert_ok(whirl_signals_vold_kalman_weight(width, 1.0, poles, &weight));
            for (size_t i = 0; i < LONG; i++) {
                phase[i] = two_pi * fmod(0.2 * (double)i, 1.0) + two_pi * floor(0.2 * (double)i);
                line[i] = cos(phase[i] + two_pi * offsets[o] * width * ((double)i - LONG / 2));
            }
            assert_ok(whirl_signals_vold_kalman(line, LONG, 1.0, phase, 1, &width, poles, out));
            const double line_gain = gain(weight, offsets[o] * width, poles);
            if (o == 0) assert_near(line_gain, sqrt(0.5), 1e-9);
            // The conjugate half of a real line is in phase in the middle, at 0.4 of the rate from the order.
            const double error = out[LONG] - line_gain - gain(weight, 0.4 + offsets[o] * width, poles);
            worst = fmax(worst, fabs(error));
        }
    }
    free(line);
    print_message("gain of a line, bands of 1e-3 and 1e-4 of the rate: to %.2g\n", worst);
    assert_true(worst < 1e-8);
}

/// A line of another shaft crosses an order: both are found at the crossing when they are solved together, and not when
/// one is solved alone.
static void crossing_orders_together(void **state) {
    (void)state;
    enum { MANY = 4000, MIDDLE = MANY / 2 };
    static double signal[MANY], both[2 * MANY], out[4 * MANY];
    const double band[2] = {2.0, 2.0};
    for (size_t i = 0; i < MANY; i++) {
        const double t = (double)i / 1000.0;
        both[i] = two_pi * (30.0 * t + 5.0 * t * t); // 30 to 70 Hz, 50 Hz at 2 s
        both[MANY + i] = two_pi * 50.0 * t;
        signal[i] = 2.0 * cos(both[i] - 0.4) + 1.0 * cos(both[MANY + i] + 1.0);
    }
    assert_ok(whirl_signals_vold_kalman(signal, MANY, 1000.0, both, 2, band, 2, out));
    double worst = 0.0;
    for (size_t i = MANY / 4; i < 3 * MANY / 4; i++) {
        worst = fmax(worst, hypot(out[2 * i] - 2.0 * cos(0.4), out[2 * i + 1] + 2.0 * sin(0.4)));
        worst = fmax(worst, hypot(out[2 * (MANY + i)] - cos(1.0), out[2 * (MANY + i) + 1] - sin(1.0)));
    }
    assert_ok(whirl_signals_vold_kalman(signal, MANY, 1000.0, both, 1, band, 2, out));
    const double alone = hypot(out[2 * MIDDLE] - 2.0 * cos(0.4), out[2 * MIDDLE + 1] + 2.0 * sin(0.4));
    print_message("crossing lines: together to %.2g, alone to %.2g\n", worst, alone);
    assert_true(worst < 1e-3 && alone > 0.3);
}

// ---------------------------------------------------------------- the angle

/// At the instants of resampled samples the angle is that of the samples; before the first and after the last pulse
/// there is none.
static void angle_of_a_run_up(void **state) {
    (void)state;
    enum { PULSES = 30, EACH = 16, MANY = (PULSES - 1) * EACH };
    double instants[PULSES], time[MANY], times[2000], angle[MANY];
    for (size_t k = 0; k < PULSES; k++) instants[k] = -10.0 + sqrt(100.0 + 2.0 * (double)k); // 10 + t turns a second
    for (size_t i = 0; i < 2000; i++) times[i] = instants[PULSES - 1] * (double)i / 1999.0;
    assert_ok(whirl_signals_resample(times, times, 2000, 1, instants, PULSES, EACH, 1, time)); // of the time itself
    assert_ok(whirl_signals_angle(instants, PULSES, time, MANY, angle));
    for (size_t i = 0; i < MANY; i++) assert_near(angle[i], two_pi * (double)(i + 1) / EACH, 1e-11);
    assert_ok(whirl_signals_angle(instants, PULSES, instants, PULSES, angle));
    for (size_t k = 0; k < PULSES; k++) assert_near(angle[k], two_pi * (double)k, 0.0);
    const double outside[] = {0.1, 9.0}, gap[] = {NAN};
    assert_refused(whirl_signals_angle(instants, PULSES, outside, 2, angle),
                   "sample 1 is at 9, expected a time of the");
    assert_refused(whirl_signals_angle(instants, PULSES, gap, 1, angle), "sample 0 is at nan");
    assert_refused(whirl_signals_angle(instants, 1, outside, 1, angle), "there are 1 pulses");
}

// ---------------------------------------------------------------- what is refused

static void refusals(void **state) {
    (void)state;
    double weight;
    const double none[2] = {2.0, 0.0}, narrow[2] = {1e-4, 1e-4}, wide[2] = {200.0, 2.0};
    fill(0.0);
    assert_refused(whirl_signals_vold_kalman_weight(2.0, 0.0, 1, &weight), "the rate is 0");
    assert_refused(whirl_signals_vold_kalman_weight(2.0, NAN, 1, &weight), "the rate is nan");
    assert_refused(whirl_signals_vold_kalman_weight(2.0, 200.0, 3, &weight), "there are 3 poles, expected 1 or 2");
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, none, 1, found), "the bandwidth is 0");
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, wide, 1, found), "the bandwidth is 200");
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, narrow, 2, found),
                   "the bandwidth is 5e-07 of the rate of samples, too narrow for 2 poles: expected at least 8.08e-06");
    assert_ok(whirl_signals_vold_kalman_weight(8.1e-6, 1.0, 2, &weight));
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, widths, 0, found), "there are 0 poles");
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 0, widths, 1, found), "there are 0 orders");
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 17, widths, 1, found), "there are 17 orders");
    assert_refused(whirl_signals_vold_kalman(y, 5, 200.0, phases, 2, widths, 2, found), "there are 5 samples");
    assert_refused(whirl_signals_vold_kalman(y, 30000000, 200.0, phases, 2, widths, 1, found),
                   "expected at most 12500000 samples");
    phases[COUNT + 7] += 3.2;
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, widths, 1, found),
                   "phase 1 (from 0) turns by 3.555 rad from sample 6 to 7");
    phases[COUNT + 7] = NAN;
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, widths, 1, found),
                   "phase 1 (from 0) is nan at sample 7");
    for (size_t i = 0; i < COUNT; i++) phases[COUNT + i] = two_pi * 1.99 * (double)i / 200.0;
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, widths, 1, found),
                   "phase 1 (from 0) has a frequency of at most 1.99, expected one above its bandwidth, 2");
    fill(0.0);
    for (int poles = 1; poles <= 2; poles++) { // the same order twice, also with another zero of its angle
        for (size_t i = 0; i < COUNT; i++) phases[COUNT + i] = phases[i] + 0.3;
        assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, widths, poles, found),
                       "the orders cannot be separated");
    }
    fill(0.0);
    y[3] = NAN;
    assert_refused(whirl_signals_vold_kalman(y, COUNT, 200.0, phases, 2, widths, 1, found),
                   "sample 3 of channel 0 is nan");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(digits_of_two_orders), cmocka_unit_test(zero_and_unit_do_not_matter),
        cmocka_unit_test(gain_of_a_line),       cmocka_unit_test(crossing_orders_together),
        cmocka_unit_test(angle_of_a_run_up),    cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
