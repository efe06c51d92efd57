// Sensors against closed forms: sums of orders through filters of known response, converters, noise and pulses.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/sensors.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TURNS = 120, INSTANTS = 256, COUNT = TURNS * INSTANTS, PER_TURN = 64, TAKEN = 100 * PER_TURN };

static const double two_pi = 6.283185307179586476925, scale = 1e-4, clock_rate = 40.0; // m, rad/s

static double waveform[2 * COUNT];
static float taken[TAKEN];

/// Makes the record of the motion x = cos(order angle) scales, y = 0 at all instants.
static whirl_record turning(double order) {
    static const whirl_probe probe = {.name = "disc", .x = 0, .y = 1, .vx = 2, .vy = 3};
    for (size_t j = 0; j < COUNT; j++)
        waveform[j] = cos(two_pi * fmod(order * (double)(j + 1) / INSTANTS, 1.0)), waveform[COUNT + j] = 0.0;
    return (whirl_record){.probe_count = 1,
                          .probes = &probe,
                          .period = two_pi,
                          .sample_count = COUNT,
                          .samples_per_revolution = INSTANTS,
                          .waveform = waveform};
}

/// Takes samples; at other rates fewer, which the record has.
static size_t take(const whirl_record *record, const whirl_channel *channel, double per_turn) {
    const size_t samples = (size_t)(100.0 * fmin(per_turn, PER_TURN));
    const whirl_sampling sampling = {.samples = samples,
                                     .rate = per_turn * clock_rate / two_pi,
                                     .from = 10.0,
                                     .seed = 7,
                                     .length = scale,
                                     .clock = clock_rate};
    const whirl_status status = whirl_channels_sample(record, channel, 1, &sampling, taken);
    assert_string_equal(status.message, "");
    return samples;
}

static whirl_channel plain(whirl_sensor sensor) {
    return (whirl_channel){
        .name = "", .sensor = sensor, .low = -INFINITY, .high = INFINITY, .sensitivity = 1.0, .pulses = 1};
}

/// Returns the amplitude and phase of an order in what was taken, which begins after whole turns.
static double complex found(double order, double per_turn) {
    double complex sum = 0.0;
    for (size_t k = 0; k < TAKEN; k++) sum += taken[k] * cexp(-I * two_pi * order * (double)k / per_turn);
    return sum * 2.0 / TAKEN;
}

/// Displacement, velocity and acceleration of orders that the filter passes; at equal angles, and at another rate.
static void passed_orders(void **unused) {
    (void)unused;
    static const double orders[] = {0.5, 1.0, 3.58, 10.0, 26.0};
    static const whirl_sensor sensors[] = {WHIRL_SENSOR_PROXIMITY, WHIRL_SENSOR_VELOCITY, WHIRL_SENSOR_ACCELEROMETER};
    double worst[3] = {0.0};
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++)
        for (size_t s = 0; s < 3; s++) {
            const whirl_record record = turning(orders[i]);
            const whirl_channel channel = plain(sensors[s]);
            const double w = orders[i] * clock_rate;
            const double complex expected =
                scale * cpow(I * w, (double)s) * cexp(I * two_pi * fmod(10.0 * orders[i], 1.0));
            take(&record, &channel, PER_TURN);
            worst[s] = fmax(worst[s], cabs(found(orders[i], PER_TURN) - expected) / cabs(expected));
        }
    check_within("sensors", "displacement of orders to 0.41 of the rate, relative error", 0.0, worst[0], 1e-4);
    check_within("sensors", "velocity of these", 0.0, worst[1], 1e-4);
    check_within("sensors", "acceleration of these", 0.0, worst[2], 1.1e-4);
    // 51.2 samples a turn: no two lie alike among the instants of four turns.
    const whirl_record record = turning(5.0);
    const whirl_channel channel = plain(WHIRL_SENSOR_PROXIMITY);
    const size_t samples = take(&record, &channel, 51.2);
    double error = 0.0;
    for (size_t k = 0; k < samples; k++)
        error = fmax(error, fabs(taken[k] - scale * cos(two_pi * 5.0 * (double)k / 51.2)) / scale);
    check_within("sensors", "displacement at a rate that turns are no multiple of, largest error", 0.0, error, 1e-4);
}

/// Orders beyond 0.58 of the sampling rate, which would be aliased, are removed.
static void stopped_orders(void **unused) {
    (void)unused;
    double worst = 0.0;
    for (int i = 0; 0.58 * PER_TURN + 1.37 * i < 0.5 * INSTANTS; i++) {
        const double order = 0.58 * PER_TURN + 1.37 * i;
        const whirl_record record = turning(order);
        const whirl_channel channel = plain(WHIRL_SENSOR_PROXIMITY);
        double most = 0.0;
        take(&record, &channel, PER_TURN);
        for (size_t k = 0; k < TAKEN; k++) most = fmax(most, fabs((double)taken[k]) / scale);
        worst = fmax(worst, most);
    }
    check_within("sensors", "remainder of orders from 0.58 of the rate on", 0.0, worst, 1.1e-4);
}

/// An accelerometer is a mass on a spring, and a high pass.
static void electronics(void **unused) {
    (void)unused;
    const double hertz = clock_rate / two_pi;
    double worst[2] = {0.0};
    for (int i = 0; i < 9; i++) {
        const double order = 1.0 + 3.0 * i;
        const whirl_record record = turning(order);
        const double w = order * clock_rate, natural = 20.0 * clock_rate, damping = 0.1, corner = 3.0 * clock_rate;
        whirl_channel channel = plain(WHIRL_SENSOR_ACCELEROMETER);
        channel.resonance = 20.0 * hertz;
        channel.damping = damping;
        take(&record, &channel, PER_TURN);
        const double complex mass = natural * natural / (natural * natural - w * w + 2.0 * I * damping * natural * w);
        worst[0] = fmax(worst[0], cabs(found(order, PER_TURN) / (-w * w * scale) / mass - 1.0));
        channel = plain(WHIRL_SENSOR_PROXIMITY);
        channel.gap = 1e-3;
        channel.high_pass = 3.0 * hertz;
        take(&record, &channel, PER_TURN);
        worst[1] = fmax(worst[1], cabs(found(order, PER_TURN) / scale / (I * w / (corner + I * w)) - 1.0));
    }
    // A straight line between instants loses (w h)^2/12: 0.031 of order 25.
    check_within("sensors", "accelerometer with a resonance at order 20, orders 1 to 25", 0.0, worst[0], 0.033);
    check_within("sensors", "high pass at order 3, orders 1 to 25", 0.0, worst[1], 0.033);
}

/// A sensor has a range, a converter and noise.
static void converter(void **unused) {
    (void)unused;
    const whirl_record record = turning(1.0);
    whirl_channel channel = plain(WHIRL_SENSOR_PROXIMITY);
    channel.gap = 1e-3;
    channel.sensitivity = 7870.0;
    channel.bits = 12;
    channel.full_scale = 10.0;
    const double step = 10.0 / 2048.0;
    take(&record, &channel, PER_TURN);
    double off = 0.0, error = 0.0;
    for (size_t k = 0; k < TAKEN; k++) {
        const double exact = 7870.0 * (1e-3 + scale * cos(two_pi * (double)k / PER_TURN));
        off = fmax(off, fabs((double)taken[k] / step - rint((double)taken[k] / step)));
        error = fmax(error, fabs(taken[k] - exact) / step);
    }
    check_within("sensors", "distance from a step of 12 bits, steps", 0.0, off, 1e-3);
    check_within("sensors", "largest error of rounding, steps", 0.5, error, 0.03);
    // The converter ends at 2047/2048 of its range, the sensor at its own.
    channel.full_scale = 8.0;
    take(&record, &channel, PER_TURN);
    double most = 0.0;
    for (size_t k = 0; k < TAKEN; k++) most = fmax(most, taken[k]);
    check_within("sensors", "largest signal of a converter to 8 V with 12 bits, V", 8.0 * 2047.0 / 2048.0, most, 1e-6);
    channel.bits = 0;
    channel.high = 1.05e-3;
    const size_t samples = take(&record, &channel, 64.0);
    most = 0.0;
    for (size_t k = 0; k < samples; k++) most = fmax(most, taken[k]);
    check_within("sensors", "largest signal of a sensor up to 1.05 mm, V", 7870.0 * 1.05e-3, most, 0.06);
    // Noise: mean, deviation and the share within one deviation, each within four of its own standard errors.
    whirl_channel noisy = plain(WHIRL_SENSOR_PROXIMITY);
    noisy.sensitivity = 0.0;
    noisy.noise = 2.0;
    take(&record, &noisy, PER_TURN);
    double sum = 0.0, squares = 0.0, near = 0.0;
    for (size_t k = 0; k < TAKEN; k++) {
        sum += taken[k];
        squares += (double)taken[k] * taken[k];
        near += fabs((double)taken[k]) < 2.0;
    }
    check_within("sensors", "mean of noise of 2 V", 0.0, sum / TAKEN, 4.0 * 2.0 / sqrt(TAKEN));
    check_within("sensors", "its standard deviation, V", 2.0, sqrt(squares / TAKEN), 4.0 * 2.0 / sqrt(2.0 * TAKEN));
    check_within("sensors", "its share within one of these", 0.682689492137086, near / TAKEN,
                 4.0 * sqrt(0.6827 * 0.3173 / TAKEN));
}

/// Pulses of a toothed wheel last for their share of a turn, at their given angles.
static void pulses(void **unused) {
    (void)unused;
    const whirl_record record = turning(1.0);
    whirl_channel channel = plain(WHIRL_SENSOR_KEYPHASOR);
    channel.pulses = 4;
    channel.width = two_pi / 20.0;
    channel.sensitivity = 5.0;
    take(&record, &channel, PER_TURN);
    double sum = 0.0;
    for (size_t k = 0; k < TAKEN; k++) sum += taken[k];
    check_within("sensors", "mean of four pulses of 1/20 of a turn and 5 V", 1.0, sum / TAKEN, 1e-6);
    check_within("sensors", "phase of their fourth order, rad", 0.0, carg(found(4.0, PER_TURN)), 1e-6);
    channel.jitter = 1e-3;
    channel.pulses = 1;
    take(&record, &channel, PER_TURN);
    // A pulse reaches into the samples next to those that it covers.
    double squares = 0.0;
    for (size_t turn = 1; turn < 99; turn++) {
        const float *middle = taken + turn * PER_TURN;
        size_t left = 0, right = 0;
        while (middle[-(ptrdiff_t)left - 1] > 4.999f) left++;
        while (middle[right + 1] > 4.999f) right++;
        const double from = -(double)left - 0.5 - middle[-(ptrdiff_t)left - 1] / 5.0;
        const double to = (double)right + 0.5 + middle[right + 1] / 5.0;
        squares += pow(0.5 * (from + to) * two_pi / PER_TURN, 2.0);
    }
    const double jitter = sqrt(squares / 98.0);
    check_within("sensors", "jitter of a keyphasor, rad", 1e-3, jitter, 4.0 * 1e-3 / sqrt(2.0 * 98.0));
}

/// Channels that cannot be sampled are refused.
static void refused(void **unused) {
    (void)unused;
    const whirl_record record = turning(1.0);
    const whirl_channel channel = plain(WHIRL_SENSOR_PROXIMITY);
    whirl_sampling sampling = {
        .samples = TAKEN, .rate = PER_TURN * clock_rate / two_pi, .from = 0.1, .length = scale, .clock = clock_rate};
    whirl_status status = whirl_channels_sample(&record, &channel, 1, &sampling, taken);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_non_null(strstr(status.message, "too short"));
    sampling.from = 10.0;
    sampling.rate *= 2.0;
    status = whirl_channels_sample(&record, &channel, 1, &sampling, taken);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_non_null(strstr(status.message, "instants a sample"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(passed_orders), cmocka_unit_test(stopped_orders),
                                       cmocka_unit_test(electronics),   cmocka_unit_test(converter),
                                       cmocka_unit_test(pulses),        cmocka_unit_test(refused)};
    return cmocka_run_group_tests_name("sensors", tests, NULL, NULL);
}
