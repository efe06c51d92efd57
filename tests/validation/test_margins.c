// Peaks of responses, amplification factors and separation margins against the closed form of a damped rotor of one
// degree of freedom: N1,2 = 1/sqrt(1 - 2 z^2 +- 2 z sqrt(1 - z^2)) times its natural frequency.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/internal/response_peaks.h"

enum { POINTS = 3201, MAX_PEAKS = 8 };

/// Computes amplitude and lag in degrees of x'' + 2 z x' + x = r^2 cos(r t) for r from `from` to `to`, plus `second`
/// times the response of an oscillator with the natural frequency 1.1.
static void respond(double z, double second, double from, double to, double *r, double *size, double *lag) {
    for (size_t i = 0; i < POINTS; i++) {
        r[i] = from + (to - from) * (double)i / (POINTS - 1);
        const double s = r[i] / 1.1;
        const double a = 1.0 - r[i] * r[i], b = 2.0 * z * r[i], c = 1.0 - s * s, d = 2.0 * z * s;
        const double real = r[i] * r[i] * (a / (a * a + b * b) + second * c / (c * c + d * d));
        const double imaginary = -r[i] * r[i] * (b / (a * a + b * b) + second * d / (c * c + d * d));
        size[i] = hypot(real, imaginary);
        lag[i] = fmod(360.0 - atan2(imaginary, real) * 180.0 / 3.14159265358979323846, 360.0);
    }
}

static void amplification_of_one_degree_of_freedom(void **unused) {
    static const struct {
        double z, peak, low, high, factor;
    } rows[] = {{0.06, 1.003619557380, 0.948055218187, 1.070258904806, 8.212678235335},
                {0.2, NAN, NAN, NAN, 2.072570732708}};
    static double r[POINTS], size[POINTS], lag[POINTS];
    (void)unused;
    for (size_t i = 0; i < 2; i++) {
        whirl_response_peak peaks[MAX_PEAKS];
        respond(rows[i].z, 0.0, 0.5, 2.0, r, size, lag);
        const size_t count = whirl_response_peaks(POINTS, r, size, lag, MAX_PEAKS, peaks);
        check_within("B13", words("damping ratio %g: peaks", rows[i].z), 1.0, (double)count, 0.0);
        check_within("B13", words("damping ratio %g: amplification", rows[i].z), rows[i].factor, peaks[0].amplification,
                     2e-7 * rows[i].factor);
        check_holds("B13", words("damping ratio %g: by half power", rows[i].z), peaks[0].way == WHIRL_BY_HALF_POWER);
        if (isnan(rows[i].peak)) continue;
        check_within("B13", "damping ratio 0.06: speed of the peak", rows[i].peak, peaks[0].speed, 1e-7);
        check_within("B13", "damping ratio 0.06: lower speed of half power", rows[i].low, peaks[0].low, 1e-8);
        check_within("B13", "damping ratio 0.06: upper speed of half power", rows[i].high, peaks[0].high, 1e-8);
    }
}

static void margins(void **unused) {
    (void)unused;
    check_within("B13", "margin below, amplification 8.212678235335, %", 14.467478791,
                 whirl_margin_required(8.212678235335, false), 1e-8);
    check_within("B13", "margin above, amplification 8.212678235335, %", 24.467478791,
                 whirl_margin_required(8.212678235335, true), 1e-8);
    check_within("B13", "margin, amplification 2.072570732708, %", 0.0, whirl_margin_required(2.072570732708, true),
                 0.0);
}

/// If a range ends on the side of a peak, or another peak is near, there is one point of half power or none. For small
/// damping both other ways give 1/(2 z), too.
static void other_ways(void **unused) {
    static double r[POINTS], size[POINTS], lag[POINTS];
    static const double z = 0.01;
    whirl_response_peak peaks[MAX_PEAKS];
    (void)unused;
    respond(z, 0.0, 0.995, 1.1, r, size, lag);
    assert_int_equal(whirl_response_peaks(POINTS, r, size, lag, MAX_PEAKS, peaks), 1);
    check_holds("B13", "without the left side: by one side", peaks[0].way == WHIRL_BY_ONE_SIDE && isnan(peaks[0].low));
    check_within("B13", "without the left side: amplification", 50.0, peaks[0].amplification, 1.0);
    respond(z, 0.0, 0.995, 1.005, r, size, lag);
    assert_int_equal(whirl_response_peaks(POINTS, r, size, lag, MAX_PEAKS, peaks), 1);
    check_holds("B13", "without both sides: by the slope of the phase", peaks[0].way == WHIRL_BY_PHASE_SLOPE);
    check_within("B13", "without both sides: amplification", 50.0, peaks[0].amplification, 1.0);
    respond(0.06, 0.8, 0.5, 2.0, r, size, lag);
    assert_int_equal(whirl_response_peaks(POINTS, r, size, lag, MAX_PEAKS, peaks), 2);
    check_holds("B13", "two peaks that merge: no half power between them",
                isnan(peaks[0].high) && isnan(peaks[1].low) && !isnan(peaks[0].low) && !isnan(peaks[1].high));
}

/// With 8 points in the half-power width, wherever they lie, the factor has an error below 1 %.
static void few_points(void **unused) {
    static const double z = 0.01;
    double worst = 0.0, widest = 0.0, r[200], size[200], lag[200];
    (void)unused;
    for (int shift = 0; shift < 10; shift++) {
        whirl_response_peak peaks[MAX_PEAKS];
        const double step = 0.02 / 8.0;
        for (size_t i = 0; i < 200; i++) {
            r[i] = 0.75 + step * ((double)i + shift / 10.0);
            const double a = 1.0 - r[i] * r[i], b = 2.0 * z * r[i];
            size[i] = r[i] * r[i] / hypot(a, b);
            lag[i] = atan2(b, a) * 180.0 / 3.14159265358979323846;
        }
        assert_int_equal(whirl_response_peaks(200, r, size, lag, MAX_PEAKS, peaks), 1);
        worst = fmax(worst, fabs(peaks[0].amplification / 49.97 - 1.0));
        widest = fmax(widest, peaks[0].points);
    }
    check_within("B13", "8 points in the width: largest relative error of the amplification", 0.0, worst, 0.01);
    check_within("B13", "8 points in the width: points reported", 8.0, widest, 0.1);
}

/// The largest amplitude between two speeds that lie between points is found at the lower or upper end, or at the top
/// of a peak.
static void largest_in_a_range(void **unused) {
    static const double z = 0.06;
    static const struct {
        const char *what;
        double low, high, at;
    } rows[] = {
        {"upper end", 0.6012, 0.8034, 0.8034}, {"lower end", 1.2017, 1.6, 1.2017}, {"top", 0.9, 1.1, 1.00361955738}};
    double r[301], size[301];
    (void)unused;
    for (size_t i = 0; i < 301; i++) {
        r[i] = 0.5 + 0.005 * (double)i;
        size[i] = r[i] * r[i] / hypot(1.0 - r[i] * r[i], 2.0 * z * r[i]);
    }
    for (size_t i = 0; i < 3; i++) {
        const double s = rows[i].at * rows[i].at, expected = s / hypot(1.0 - s, 2.0 * z * rows[i].at);
        check_within("B13", words("largest between two speeds: %s", rows[i].what), expected,
                     whirl_response_largest(301, r, size, rows[i].low, rows[i].high), 1e-5 * expected);
    }
    const double at = 0.9017, expected = at * at / hypot(1.0 - at * at, 2.0 * z * at);
    check_within("B13", "largest at one speed between points", expected, whirl_response_largest(301, r, size, at, at),
                 1e-5 * expected);
    check_holds("B13", "largest between two speeds that points do not reach: none",
                isnan(whirl_response_largest(301, r, size, 0.4, 0.9)) &&
                    isnan(whirl_response_largest(301, r, size, 1.5, 2.1)));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(amplification_of_one_degree_of_freedom),
        cmocka_unit_test(margins),
        cmocka_unit_test(other_ways),
        cmocka_unit_test(few_points),
        cmocka_unit_test(largest_in_a_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
