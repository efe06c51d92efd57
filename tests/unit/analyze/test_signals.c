// Measured signals against motions that are known in closed form.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
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

// ---------------------------------------------------------------- a shaft that runs up

enum { RATE = 10000, SECONDS = 2, COUNT = RATE * SECONDS, MAX_PULSES = COUNT / 2 + 1, CHANNELS = 2 };

/// Turns of a shaft whose speed, in turns a second, grows from `speed` by `growth` a second.
typedef struct run_up {
    double speed, growth;
} run_up;

static double turns_at(const run_up *run, double time) {
    return time * (run->speed + 0.5 * run->growth * time);
}

static double time_of(const run_up *run, double turns) {
    return 2.0 * turns / (run->speed + sqrt(run->speed * run->speed + 2.0 * run->growth * turns));
}

static double time_at[COUNT], voltage[COUNT], values[CHANNELS * COUNT], instants[MAX_PULSES];

/// A keyphasor whose voltage rises in proportion to the angle from -5 V to 5 V about each whole turn, and falls again a
/// fifth of a turn later.
static void fill_keyphasor(const run_up *run) {
    for (size_t i = 0; i < COUNT; i++) {
        time_at[i] = (double)i / RATE;
        const double part = remainder(turns_at(run, time_at[i]) - 0.1, 1.0);
        voltage[i] = fmin(fmax(100.0 * (0.1 - fabs(part)), -5.0), 5.0);
    }
}

/// Writes the pulses at the whole turns within the samples, and returns their number.
static size_t exact_pulses(const run_up *run) {
    const size_t whole = (size_t)turns_at(run, time_at[COUNT - 1]);
    for (size_t k = 0; k <= whole; k++) instants[k] = time_of(run, (double)k);
    return whole + 1;
}

static void pulses_of_a_run_up(void **state) {
    (void)state;
    const run_up run = {20.0, 4.0};
    double threshold, hysteresis;
    size_t pulses;
    fill_keyphasor(&run);
    assert_ok(whirl_signals_threshold(voltage, COUNT, &threshold, &hysteresis));
    assert_near(threshold, 0.0, 0.0);
    assert_near(hysteresis, 2.0, 0.0);
    // Within a step of the samples the angle bends by growth step^2/8, which is 5e-9 turns or 2.5e-10 s.
    assert_ok(whirl_signals_pulses(time_at, voltage, COUNT, threshold, hysteresis, true, instants, &pulses));
    assert_int_equal(pulses, 47); // the turns 1 to 47 of 48; the first sample stands on the edge of turn 0
    double worst = 0.0;
    for (size_t k = 0; k < pulses; k++) worst = fmax(worst, fabs(instants[k] - time_of(&run, (double)(k + 1))));
    print_message("pulses of a run-up: to %.2g s\n", worst);
    assert_true(worst < 3e-10);
    assert_ok(whirl_signals_pulses(time_at, voltage, COUNT, threshold, hysteresis, false, instants, &pulses));
    assert_int_equal(pulses, 48);
    for (size_t k = 0; k < pulses; k++) assert_near(instants[k], time_of(&run, (double)k + 0.2), 3e-10);
}

/// Noise about the threshold gives one pulse where the hysteresis is above it, and as many as it has edges without.
static void hysteresis_holds_back_noise(void **state) {
    (void)state;
    const double t[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, v[] = {-1, 3, -0.5, 1, -0.4, 2, -3, 1, 3, -3, 0};
    double found[6];
    size_t pulses;
    assert_ok(whirl_signals_pulses(t, v, 11, 0.0, 0.5, true, found, &pulses));
    assert_int_equal(pulses, 3);
    assert_near(found[0], 0.25, 1e-15);
    assert_near(found[1], 6.75, 1e-15);
    assert_near(found[2], 10.0, 0.0);
    assert_ok(whirl_signals_pulses(t, v, 11, 0.0, 0.0, true, found, &pulses));
    assert_int_equal(pulses, 5);
}

static void speed_between_pulses(void **state) {
    (void)state;
    const run_up run = {20.0, 4.0};
    double speed[100];
    fill_keyphasor(&run);
    const size_t pulses = exact_pulses(&run);
    assert_ok(whirl_signals_speed(instants, pulses, speed));
    for (size_t k = 0; k + 1 < pulses; k++) {
        const double middle = 0.5 * (instants[k] + instants[k + 1]); // where a constant acceleration has its mean
        assert_near(speed[k], two_pi * (run.speed + run.growth * middle), 1e-9);
    }
}

// ---------------------------------------------------------------- by the angle

/// A polynomial of a degree that is the order of interpolation or less comes back exactly, at uneven samples and at the
/// ends of them; one of a higher degree does not.
static void polynomials_are_interpolated(void **state) {
    (void)state;
    enum { SAMPLES = 40, PULSES = 7 };
    const double pulses[PULSES] = {0.0, 1.1, 2.3, 3.2, 4.4, 5.3, 6.0};
    double t[SAMPLES], v[SAMPLES], section[PULSES];
    size_t points;
    for (int i = 0; i < SAMPLES; i++) t[i] = 6.0 * i / (SAMPLES - 1) + 0.05 * sin(3.0 * i);
    t[0] = 0.0, t[SAMPLES - 1] = 6.0;
    for (int order = 1; order <= WHIRL_SIGNALS_HIGHEST_ORDER; order += 2) {
        for (int degree = order; degree <= order + 1; degree++) {
            double worst = 0.0;
            for (int i = 0; i < SAMPLES; i++) v[i] = pow(t[i] - 3.0, degree);
            assert_ok(whirl_signals_section(t, v, SAMPLES, 1, pulses, PULSES, 0.0, order, section, &points));
            assert_int_equal(points, PULSES);
            for (size_t k = 0; k < PULSES; k++)
                worst = fmax(worst, fabs(section[k] - pow(pulses[k] - 3.0, degree)) / pow(3.0, degree));
            assert_true(degree == order ? worst < 1e-14 : worst > 1e-13);
        }
    }
}

/// At a pulse that coincides with a sample the value is that of the sample, to the bit.
static void samples_at_pulses_stay(void **state) {
    (void)state;
    const double t[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
    const double v[] = {0.3, -7.1, 1e5, 2e-7, 3.3, 0.7, 19.0, -2.5, 1.0 / 3.0, 12.0};
    const double pulses[] = {0.1, 0.3, 0.4, 0.9, 1.0}, expected[] = {0.3, 1e5, 2e-7, 1.0 / 3.0, 12.0};
    double section[5];
    size_t points;
    for (int order = 1; order <= 9; order += 2) {
        assert_ok(whirl_signals_section(t, v, 10, 1, pulses, 5, 0.0, order, section, &points));
        assert_memory_equal(section, expected, sizeof expected);
    }
}

/// While the shaft runs up, angles between the pulses are interpolated by the cubic. Its slopes miss t'''/6, at the
/// ends t'''/3, so that the part s of the first turn comes s (1 - s) ((1 - s)/3 + s/6) t''' too late: at most 0.064
/// t''' = 0.2 growth^2/speed^5 s, 2e-5 turns here.
static void phases_of_a_run_up(void **state) {
    (void)state;
    const run_up run = {20.0, 4.0};
    const double phase = 1.234;
    double section[CHANNELS * 64];
    size_t points;
    fill_keyphasor(&run);
    for (size_t i = 0; i < COUNT; i++) {
        values[i] = cos(two_pi * turns_at(&run, time_at[i]) - 0.4);
        values[COUNT + i] = turns_at(&run, time_at[i]);
    }
    const size_t pulses = exact_pulses(&run);
    const double most = 0.2 * run.growth * run.growth / pow(run.speed, 4.0); // turns
    assert_ok(whirl_signals_section(time_at, values, COUNT, 2, instants, pulses, phase, 7, section, &points));
    assert_int_equal(points, pulses - 1);
    double worst = 0.0;
    for (size_t k = 0; k < points; k++) {
        assert_near(section[2 * k], cos(phase - 0.4), two_pi * most);
        worst = fmax(worst, fabs(section[2 * k + 1] - (double)k - phase / two_pi));
    }
    print_message("phases of a run-up: to %.2g turns\n", worst);
    assert_true(worst < most && worst > 0.01 * most);
}

/// The time of equal angles never decreases, for any pulses.
static void angles_stay_monotone(void **state) {
    (void)state;
    const double pulses[] = {0.0, 0.1, 5.0, 5.001, 5.002, 19.0, 20.0};
    double t[201], turned[6 * 50], last = 0.0;
    for (int i = 0; i <= 200; i++) t[i] = 0.1 * i;
    assert_ok(whirl_signals_resample(t, t, 201, 1, pulses, 7, 50, 1, turned));
    for (size_t i = 0; i < 300; i++) {
        assert_true(turned[i] >= last);
        last = turned[i];
    }
    for (size_t k = 1; k < 7; k++) assert_near(turned[50 * k - 1], pulses[k], 1e-14);
}

// ---------------------------------------------------------------- spectra

/// Fills two channels with three orders, while the speed grows by a tenth.
static void fill_orders(const run_up *run) {
    fill_keyphasor(run);
    for (size_t i = 0; i < COUNT; i++) {
        const double angle = two_pi * turns_at(run, time_at[i]);
        values[i] = 2.0 + cos(angle - 0.7) + 0.4 * cos(0.5 * angle) + 0.1 * cos(3.0 * angle + 1.0);
        values[COUNT + i] = sin(angle - 0.7) + 0.4 * cos(0.5 * angle) - 0.1 * sin(3.0 * angle + 1.0);
    }
}

static size_t lines_between(const double *pulses, size_t count, size_t samples, double lines[][5],
                            double *synchronous) {
    size_t found;
    const size_t turned = (count - 1) * samples;
    double *buffer = malloc(2 * turned * sizeof *buffer);
    assert_non_null(buffer);
    assert_ok(whirl_signals_resample(time_at, values, COUNT, 2, pulses, count, samples, 7, buffer));
    assert_ok(
        whirl_signals_spectrum(buffer, buffer + turned, turned, samples, 6.0, NULL, &lines[0][0], &found, synchronous));
    free(buffer);
    return found;
}

static void orders_of_a_run_up(void **state) {
    (void)state;
    const run_up run = {40.0, 2.0};
    double lines[WHIRL_SIGNALS_LINES][5], synchronous[8];
    size_t samples;
    fill_orders(&run);
    const size_t pulses = exact_pulses(&run);
    assert_ok(whirl_signals_samples(time_at, COUNT, instants, pulses, &samples));
    assert_int_equal(samples, 250); // 248.5 from the first pulse to the second
    const size_t found = lines_between(instants, pulses, samples, lines, synchronous);
    const double expected[3][5] = {
        {1.0, 1.0, 1.0, 1.0, 0.0}, {0.5, 0.4, 0.4, 0.2 * sqrt(2.0), 0.2 * sqrt(2.0)}, {3.0, 0.1, 0.1, 0.0, 0.1}};
    assert_true(found >= 3);
    double worst = 0.0;
    for (size_t l = 0; l < 3; l++)
        for (size_t i = 0; i < 5; i++) worst = fmax(worst, fabs(lines[l][i] - expected[l][i]));
    print_message("orders of a run-up: to %.2g\n", worst);
    assert_true(worst < 2e-6); // angles miss 0.2 growth^2/speed^4 turns at most, 2e-6 rad
    for (size_t l = 3; l < found; l++) assert_true(lines[l][1] < 2e-4 && lines[l][2] < 2e-4);
    assert_near(synchronous[0], 1.0, 2e-6);
    assert_near(synchronous[4], 0.7 * 360.0 / two_pi, 1e-3); // x lags by 0.7 rad behind the pulse
    assert_near(synchronous[6], 0.7 * 360.0 / two_pi, 1e-3);
    // By the mean speed alone the line smears: it is the pulses between that straighten it.
    const double last = instants[pulses - 1];
    for (size_t k = 0; k < pulses; k++) instants[k] = last * (double)k / (double)(pulses - 1);
    lines_between(instants, pulses, samples, lines, synchronous);
    assert_true(lines[0][1] < 0.9);
}

/// x = a cos, y = b sin of the angle is (a + b)/2 forward and (a - b)/2 backward, whatever the probes' angles.
static void ellipse(void **state) {
    (void)state;
    enum { TURNS = 40, SAMPLES = 25, N = TURNS * SAMPLES };
    const double a = 0.5, b = 0.2, first = 0.25 * two_pi / 2.0, second = 0.7 * two_pi / 2.0;
    double u[N], v[N], x[N], y[N], lines[16][5], synchronous[8];
    size_t found;
    for (int i = 0; i < N; i++) {
        const double angle = two_pi * (i + 1) / SAMPLES, px = a * cos(angle), py = b * sin(angle);
        u[i] = px * cos(first) + py * sin(first);
        v[i] = px * cos(second) + py * sin(second);
    }
    assert_ok(whirl_signals_axes(u, v, N, first, second, x, y));
    const size_t count = whirl_signals_orders(N, SAMPLES, 5.0);
    assert_int_equal(count, 5 * TURNS + 1);
    double *orders = malloc(5 * count * sizeof *orders);
    assert_non_null(orders);
    assert_ok(whirl_signals_spectrum(x, y, N, SAMPLES, 5.0, orders, &lines[0][0], &found, synchronous));
    const double expected[5] = {1.0, a, b, 0.5 * (a + b), 0.5 * (a - b)};
    assert_int_equal(found, 1);
    for (size_t i = 0; i < 5; i++) {
        assert_near(lines[0][i], expected[i], 1e-12);
        assert_near(orders[5 * TURNS + i], expected[i], 1e-12);
    }
    for (size_t i = 0; i < 4; i++) assert_near(synchronous[i], expected[i + 1], 1e-12);
    free(orders);
    // Probes on x and y measure x and y.
    assert_ok(whirl_signals_axes(u, v, N, 0.0, 0.25 * two_pi, x, y));
    for (int i = 0; i < N; i++) assert_near(fabs(x[i] - u[i]) + fabs(y[i] - v[i]), 0.0, 1e-15);
}

// ---------------------------------------------------------------- sections

static double logistic_k(double r, size_t count) {
    double *points = malloc(count * sizeof *points), x = 0.3123, k, size;
    assert_non_null(points);
    for (int n = 0; n < 1000; n++) x = r * x * (1.0 - x);
    for (size_t n = 0; n < count; n++) points[n] = x = r * x * (1.0 - x);
    assert_ok(whirl_signals_size(points, count, 1, &size));
    assert_ok(whirl_signals_zero_one(points, count, 1, size, &k));
    free(points);
    return k;
}

/// The logistic map as Gottwald and Melbourne (2009) have it: r = 3.55 has period 8, r = 3.97 is chaotic.
static void zero_one_test_of_the_logistic_map(void **state) {
    (void)state;
    const double regular = logistic_k(3.55, 2000), chaotic = logistic_k(3.97, 2000);
    print_message("K of the logistic map: %.4f at r = 3.55, %.4f at r = 3.97\n", regular, chaotic);
    assert_true(fabs(regular) < 0.1);
    assert_true(chaotic > 0.95);
    const double still[100] = {0};
    double k;
    assert_ok(whirl_signals_zero_one(still, 100, 1, 1.0, &k));
    assert_true(isnan(k));
}

/// Period k: of N points k (N/k)(N/k - 1)/2 pairs recur, and the diagonal at distance j k has N - j k points.
static void recurrence_of_periods(void **state) {
    (void)state;
    enum { N = 120 };
    double points[2 * N], rate, determinism, laminarity, size, distance;
    size_t longest;
    int period;
    for (size_t k = 1; k <= 6; k++) {
        for (size_t n = 0; n < N; n++) {
            points[2 * n] = cos(two_pi * (double)(n % k) / (double)k);
            points[2 * n + 1] = sin(two_pi * (double)(n % k) / (double)k);
        }
        assert_ok(whirl_signals_recurrence(points, N, 2, 0.01, 2, &rate, &determinism, &laminarity, &longest));
        assert_near(rate, (double)(N / k - 1) / (N - 1), 1e-15);
        // Only the last diagonal of k = 1 is shorter than 2.
        assert_near(determinism, k == 1 ? 1.0 - 2.0 / (N * (N - 1.0)) : 1.0, 1e-15);
        assert_near(laminarity, k == 1 ? 1.0 : 0.0, 0.0);
        assert_int_equal(longest, N - k);
        assert_ok(whirl_signals_returns(points, N, 2, 1.0, 1e-12, &period, &distance));
        assert_int_equal(period, k);
        assert_true(distance <= 1e-12);
    }
    assert_ok(whirl_signals_size(points, N, 2, &size));
    // Two points, then two others: every stay has two, so that all points stand in vertical lines of two.
    for (size_t n = 0; n < N; n++) points[n] = n % 4 < 2 ? 0.0 : 1.0;
    assert_ok(whirl_signals_recurrence(points, N, 1, 0.5, 2, &rate, &determinism, &laminarity, &longest));
    assert_near(laminarity, 1.0, 0.0);
    assert_ok(whirl_signals_recurrence(points, N, 1, 0.5, 3, &rate, &determinism, &laminarity, &longest));
    assert_near(laminarity, 0.0, 0.0);
    for (size_t n = 0; n < N; n++) points[n] = (double)n;
    assert_ok(whirl_signals_recurrence(points, N, 1, 0.5, 2, &rate, &determinism, &laminarity, &longest));
    assert_near(rate, 0.0, 0.0);
    assert_true(isnan(determinism) && longest == 0);
}

/// Points of period 2 with noise up to 0.02 of the size: the smallest period that returns within the tolerance is
/// found.
static void a_period_in_noise(void **state) {
    (void)state;
    enum { N = 400 };
    double points[N], distance;
    uint32_t seed = 1;
    int period;
    for (size_t n = 0; n < N; n++) {
        seed = seed * 1664525U + 1013904223U;
        points[n] = (n % 2 ? 1.0 : -1.0) + 0.02 * ((double)seed / 4294967296.0 - 0.5);
    }
    assert_ok(whirl_signals_returns(points, N, 1, 1.0, 0.05, &period, &distance));
    assert_int_equal(period, 2);
    assert_true(distance > 0.015 && distance < 0.02); // the noise spans 0.02
    assert_ok(whirl_signals_returns(points, N, 1, 1.0, 1e-6, &period, &distance));
    assert_true(distance > 1e-6);
}

// ---------------------------------------------------------------- what is refused

enum { FEW = 200 };
static double t[FEW], v[2 * FEW], out[64 * FEW];
static const double pulses[] = {1.0, 2.0, 3.0, 4.0, 5.0};

static void fill_few(void) {
    for (int i = 0; i < FEW; i++) {
        t[i] = 0.05 * i;
        v[i] = sin(6.0 * t[i]);
        v[FEW + i] = cos(6.0 * t[i]);
    }
}

static whirl_status few_section(size_t count, size_t channels, size_t pulse_count, double phase, int order) {
    size_t points;
    return whirl_signals_section(t, v, count, channels, pulses, pulse_count, phase, order, out, &points);
}

static whirl_status few_resampled(const double *instants_given, size_t pulse_count, size_t samples) {
    return whirl_signals_resample(t, v, FEW, 2, instants_given, pulse_count, samples, 7, out);
}

static void gaps_are_refused(void **state) {
    (void)state;
    double a, b, few_pulses[FEW];
    size_t found;
    fill_few();
    v[FEW + 17] = NAN;
    assert_refused(few_section(FEW, 2, 5, 0.0, 7), "sample 17 of channel 1 is nan");
    assert_refused(whirl_signals_size(v, FEW, 2, &a), "sample 17 of channel 1");
    v[3] = INFINITY;
    assert_refused(few_resampled(pulses, 5, 16), "sample 3 of channel 0 is inf");
    v[3] = -1e300;
    assert_refused(whirl_signals_threshold(v, FEW, &a, &b), "sample 3 of channel 0 is -1e+300");
    assert_refused(whirl_signals_pulses(t, v, FEW, 0.0, 0.1, true, few_pulses, &found), "sample 3 of channel 0");
    fill_few();
    t[9] = NAN;
    assert_refused(few_section(FEW, 2, 5, 0.0, 7), "the time of sample 9 is nan");
    t[9] = t[8];
    assert_refused(few_section(FEW, 2, 5, 0.0, 7), "sample 9 is at 0.4");
    fill_few();
    for (int i = 100; i < FEW; i++) t[i] += 3.0;
    assert_refused(few_section(FEW, 2, 5, 0.0, 7), "there is a gap: samples 99 and 100 are 3.05 apart");
    fill_few();
}

static void wrong_pulses_are_refused(void **state) {
    (void)state;
    const double unsorted[] = {1.0, 3.0, 2.0}, early[] = {-1.0, 2.0}, late[] = {1.0, 20.0}, broken[] = {1.0, NAN};
    double speed[4], a, b, flat[FEW] = {0};
    size_t found;
    fill_few();
    assert_refused(few_resampled(unsorted, 3, 16), "pulse 2 is at 2, not after pulse 1 at 3");
    assert_refused(few_resampled(early, 2, 16), "pulse 0 is at -1, expected a time of the samples, 0 to 9.95");
    assert_refused(few_resampled(late, 2, 16), "pulse 1 is at 20");
    assert_refused(few_resampled(broken, 2, 16), "the time of pulse 1 is nan");
    assert_refused(few_resampled(pulses, 1, 16), "there are 1 pulses, expected at least 2");
    assert_refused(few_resampled(pulses, 0, 16), "there are 0 pulses");
    assert_refused(whirl_signals_speed(pulses, 1, speed), "there are 1 pulses");
    assert_refused(whirl_signals_samples(t, FEW, pulses, 1, &found), "there are 1 pulses");
    assert_refused(whirl_signals_threshold(flat, FEW, &a, &b), "the keyphasor is 0 all the time");
    assert_ok(whirl_signals_pulses(t, flat, FEW, 0.5, 0.1, true, out, &found));
    assert_int_equal(found, 0);
    assert_refused(whirl_signals_pulses(t, v, FEW, NAN, 0.1, true, out, &found), "the threshold is nan");
    assert_refused(whirl_signals_pulses(t, v, FEW, 0.0, -1.0, true, out, &found), "the hysteresis is -1");
    assert_refused(whirl_signals_pulses(t, v, 0, 0.0, 0.1, true, out, &found), "there are 0 samples");
}

static void sizes_that_mean_nothing_are_refused(void **state) {
    (void)state;
    double number, other, third;
    size_t found, longest;
    int period;
    fill_few();
    assert_refused(few_section(FEW, 2, 5, 0.0, 2), "the order of interpolation is 2");
    assert_refused(few_section(FEW, 2, 5, 0.0, 11), "the order of interpolation is 11");
    assert_refused(few_section(FEW, 2, 5, 6.3, 7), "the phase of the section is 6.3");
    assert_refused(few_section(FEW, 2, 5, NAN, 7), "the phase of the section is nan");
    assert_refused(few_section(7, 2, 5, 0.0, 7), "there are 7 samples, expected at least 8");
    assert_refused(few_section(FEW, 0, 5, 0.0, 7), "there is no channel");
    assert_refused(few_section(SIZE_MAX, 2, 5, 0.0, 7), "expected at most 1000000000 numbers");
    assert_refused(few_section(FEW, SIZE_MAX, 5, 0.0, 7), "expected at most 1000000000 numbers");
    assert_refused(few_section(FEW, 2, SIZE_MAX, 0.0, 7), "expected at most 1000000000 numbers");
    assert_refused(few_resampled(pulses, 5, 2), "there are to be 2 samples per revolution");
    assert_refused(few_resampled(pulses, 5, SIZE_MAX), "samples per revolution, expected at least 3");
    assert_refused(whirl_signals_axes(v, v + FEW, FEW, 0.3, 0.3 + 0.5 * two_pi, out, out), "not in one line");
    assert_refused(whirl_signals_axes(v, v + FEW, FEW, NAN, 0.3, out, out), "the probes are at nan");
    assert_refused(whirl_signals_size(v, 0, 1, &number), "there are 0 samples");
    assert_refused(whirl_signals_zero_one(v, 99, 1, 1.0, &number), "there are 99 points, expected at least 100");
    assert_refused(whirl_signals_zero_one(v, 100, 1, 0.0, &number), "the size of the motion is 0");
    assert_refused(whirl_signals_zero_one(v, SIZE_MAX, 3, 1.0, &number), "expected at most 1000000000 numbers");
    assert_refused(whirl_signals_returns(v, 4, 1, 1.0, 0.1, &period, &number), "there are 4 points");
    assert_refused(whirl_signals_returns(v, 9, 1, 1.0, NAN, &period, &number), "the tolerance is nan");
    assert_refused(whirl_signals_recurrence(v, 9, 1, NAN, 2, &number, &other, &third, &longest), "the radius is nan");
    assert_refused(whirl_signals_recurrence(v, 9, 1, 0.1, 1, &number, &other, &third, &longest), "the shortest line");
    assert_refused(whirl_signals_recurrence(v, 1, 1, 0.1, 2, &number, &other, &third, &longest), "there are 1 points");
    assert_refused(whirl_signals_recurrence(v, 20001, 1, 0.1, 2, &number, &other, &third, &longest), "at most 20000");
    assert_refused(whirl_signals_spectrum(v, NULL, 30, 10, 5.0, NULL, out, &found, out), "there are 3 revolutions");
    assert_refused(whirl_signals_spectrum(v, NULL, 45, 10, 5.0, NULL, out, &found, out), "expected whole revolutions");
    assert_refused(whirl_signals_spectrum(v, v, 50, 2, 5.0, NULL, out, &found, out), "there are 2 samples");
    assert_refused(whirl_signals_spectrum(v, v, 50, 10, -1.0, NULL, out, &found, out), "the highest order is -1");
    assert_refused(whirl_signals_spectrum(v, v, 50, 10, NAN, NULL, out, &found, out), "the highest order is nan");
    assert_int_equal(whirl_signals_orders(45, 10, 5.0) + whirl_signals_orders(0, 10, 5.0), 0);
    assert_int_equal(whirl_signals_orders(50, 0, 5.0) + whirl_signals_orders(50, 10, NAN), 0);
}

/// Unusual but valid signals have an answer.
static void strange_signals_are_answered(void **state) {
    (void)state;
    const double two[] = {0.0, 9.95};
    double lines[16][5], synchronous[8];
    size_t found;
    fill_few();
    assert_ok(few_section(FEW, 2, 2, 0.0, 9));
    assert_ok(few_resampled(two, 2, 16)); // one revolution alone, over all samples
    memset(v, 0, sizeof v);
    assert_ok(whirl_signals_spectrum(v, NULL, 40, 10, INFINITY, NULL, &lines[0][0], &found, synchronous));
    assert_int_equal(found, 0);
    assert_int_equal(whirl_signals_orders(40, 10, INFINITY), 20);
    for (int i = 0; i < 40; i++) v[i] = i % 2 ? 1e100 : -1e100;
    assert_ok(whirl_signals_spectrum(v, v, 40, 10, 5.0, NULL, &lines[0][0], &found, synchronous));
}

/// Returns a number of a pseudo-random sequence (Numerical Recipes' quick one): mostly ordinary, at times a gap, an
/// infinity or a huge number.
static double any_number(uint32_t *seed) {
    *seed = *seed * 1664525U + 1013904223U;
    const uint32_t kind = *seed >> 20;
    *seed = *seed * 1664525U + 1013904223U;
    const double ordinary = (double)*seed / 4294967296.0 - 0.5;
    return kind == 0 ? (double)NAN : kind == 1 ? (double)INFINITY : kind < 40 ? ordinary * 1e100 : ordinary;
}

static double *any_numbers(uint32_t *seed, size_t count, bool growing) {
    double *numbers = malloc((count + !count) * sizeof *numbers), at = 0.0; // no room beyond them
    assert_non_null(numbers);
    for (size_t i = 0; i < count; i++) {
        const double number = any_number(seed);
        at += growing ? fabs(number) : 0.0;
        numbers[i] = growing ? at : number;
    }
    return numbers;
}

/// Arrays of all sizes, with whatever in them, have an answer or a sentence. That none is read or written beyond its
/// end is seen by the sanitizers.
static void any_arrays_have_an_answer(void **state) {
    (void)state;
    uint32_t seed = 20;
    size_t answered[18] = {0};
    for (size_t round = 0; round < 3000; round++) {
        const size_t count = round % 41, many = 1 + round % 3, pulse_count = round % 7, samples = round % 19;
        double *time = any_numbers(&seed, count, round % 5 > 0), *signal = any_numbers(&seed, many * count, false);
        double *pulse = any_numbers(&seed, pulse_count, round % 4 > 0), numbers[16 * 5 + 8];
        double *result =
            malloc((many * pulse_count * samples + 4 * count * count + pulse_count * many + 200) * sizeof *result);
        double phase[41];
        const double order = (double)(round % 5) - 1.0;
        size_t found;
        int period;
        assert_non_null(result);
        for (size_t k = 0; k < pulse_count; k++) pulse[k] *= 0.1 * (double)count;
        const double size = any_number(&seed), level = any_number(&seed), width = 0.1 * fabs(level);
        for (size_t i = 0; i < count; i++) phase[i] = 0.1 * (double)round / 300.0 * (double)i + 0.01 * signal[i];
        const whirl_status said[] = {
            whirl_signals_threshold(signal, count, numbers, numbers + 1),
            whirl_signals_pulses(time, signal, count, level, size, round % 2 == 0, result, &found),
            whirl_signals_speed(pulse, pulse_count, result),
            whirl_signals_section(time, signal, count, many, pulse, pulse_count, level, (int)(round % 11), result,
                                  &found),
            whirl_signals_samples(time, count, pulse, pulse_count, &found),
            whirl_signals_resample(time, signal, count, many, pulse, pulse_count, samples, (int)(round % 11), result),
            whirl_signals_axes(signal, signal, count, size, level, result, result),
            whirl_signals_spectrum(signal, NULL, count, samples, size * 10.0, NULL, numbers, &found, numbers + 80),
            whirl_signals_size(signal, count, many, numbers),
            whirl_signals_zero_one(signal, many * count, 1, fabs(size), numbers),
            whirl_signals_returns(signal, count, many, fabs(size), fabs(level), &period, numbers),
            whirl_signals_recurrence(signal, count, many, size, samples, numbers, numbers + 1, numbers + 2, &found),
            whirl_signals_angle(pulse, pulse_count, time, count, result),
            whirl_signals_track(signal, 1, samples ? count / samples : 0, samples, &order, 1, 1 + round % 2, result),
            whirl_signals_vold_kalman(signal, count, 1.0, phase, 1, &width, 1 + (int)(round % 2), result),
            whirl_signals_spectrogram(signal, NULL, count, 5 + round % 19, round % 4, result),
            whirl_signals_sweep(size, numbers),
            whirl_signals_rain_flow(signal, count, result, &found)};
        for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
            assert_true(said[i].code == WHIRL_OK || (said[i].code == WHIRL_BAD_INPUT && *said[i].message));
            answered[i] += said[i].code == WHIRL_OK;
        }
        free(time), free(signal), free(pulse), free(result);
    }
    for (size_t i = 0; i < 18; i++)
        if (answered[i] <= 20) fail_msg("function %zu answered %zu times", i, answered[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pulses_of_a_run_up),
        cmocka_unit_test(hysteresis_holds_back_noise),
        cmocka_unit_test(speed_between_pulses),
        cmocka_unit_test(polynomials_are_interpolated),
        cmocka_unit_test(samples_at_pulses_stay),
        cmocka_unit_test(phases_of_a_run_up),
        cmocka_unit_test(angles_stay_monotone),
        cmocka_unit_test(orders_of_a_run_up),
        cmocka_unit_test(ellipse),
        cmocka_unit_test(zero_one_test_of_the_logistic_map),
        cmocka_unit_test(recurrence_of_periods),
        cmocka_unit_test(a_period_in_noise),
        cmocka_unit_test(gaps_are_refused),
        cmocka_unit_test(wrong_pulses_are_refused),
        cmocka_unit_test(sizes_that_mean_nothing_are_refused),
        cmocka_unit_test(strange_signals_are_answered),
        cmocka_unit_test(any_arrays_have_an_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
