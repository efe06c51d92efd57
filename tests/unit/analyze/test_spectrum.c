// Spectra against the sinusoids that were put in.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "near.h"
#include "whirl/engine/analyze.h"
#include "whirl/internal/spectrum.h"

static const double two_pi = 6.283185307179586476925;

enum { REVOLUTIONS = 100, SAMPLES = 64, COUNT = REVOLUTIONS * SAMPLES };

/// One sinusoid of a test signal: x = a cos(order tau + p), y = b cos(order tau + q).
typedef struct tone {
    double order, a, p, b, q;
} tone;

/// Makes the record of a sum of tones about (x0, y0).
static whirl_record record_of_tones(const tone *tones, size_t tone_count, double x0, double y0) {
    static const whirl_probe probe = {.name = "disc", .y = 1};
    double *waveform = malloc(2 * COUNT * sizeof(double));
    assert_non_null(waveform);
    for (size_t j = 0; j < COUNT; j++) {
        const double tau = two_pi * (double)(j + 1) / SAMPLES;
        waveform[j] = x0;
        waveform[COUNT + j] = y0;
        for (size_t t = 0; t < tone_count; t++) {
            waveform[j] += tones[t].a * cos(tones[t].order * tau + tones[t].p);
            waveform[COUNT + j] += tones[t].b * cos(tones[t].order * tau + tones[t].q);
        }
    }
    return (whirl_record){.probe_count = 1,
                          .probes = &probe,
                          .record_count = REVOLUTIONS,
                          .sample_count = COUNT,
                          .samples_per_revolution = SAMPLES,
                          .waveform = waveform};
}

static whirl_spectrum *spectrum_of(const tone *tones, size_t tone_count) {
    whirl_record record = record_of_tones(tones, tone_count, 3.0, -7.0);
    whirl_spectrum *spectrum;
    assert_int_equal(whirl_spectrum_new(&record, 0, 5.0, &spectrum).code, WHIRL_OK);
    free(record.waveform);
    return spectrum;
}

static void assert_line(const whirl_line *line, double order, double x, double y, double forward, double backward,
                        double tolerance) {
    assert_near(line->order, order, tolerance);
    assert_near(line->x, x, tolerance);
    assert_near(line->y, y, tolerance);
    assert_near(line->forward, forward, tolerance);
    assert_near(line->backward, backward, tolerance);
}

/// A circle with the rotation has no backward part, one against it no forward part, on a bin and between bins.
static void circles(void **state) {
    (void)state;
    const double orders[] = {1.0, 0.5, 0.41273, 2.23456};
    for (size_t i = 0; i < 4; i++) {
        const tone forward = {orders[i], 0.3, 0.7, 0.3, 0.7 - 0.25 * two_pi};
        whirl_spectrum *spectrum = spectrum_of(&forward, 1);
        assert_int_equal(spectrum->line_count, 1);
        assert_line(&spectrum->lines[0], orders[i], 0.3, 0.3, 0.3, 0.0, 1e-10);
        whirl_spectrum_free(spectrum);
        const tone backward = {orders[i], 0.3, 0.7, 0.3, 0.7 + 0.25 * two_pi};
        spectrum = spectrum_of(&backward, 1);
        assert_int_equal(spectrum->line_count, 1);
        assert_line(&spectrum->lines[0], orders[i], 0.3, 0.3, 0.0, 0.3, 1e-10);
        whirl_spectrum_free(spectrum);
    }
}

/// x = a cos, y = b sin is the sum of circles of (a + b)/2 forward and (a - b)/2 backward.
static void ellipse(void **state) {
    (void)state;
    const tone t = {1.7, 0.5, 0.2, 0.2, 0.2 - 0.25 * two_pi};
    whirl_spectrum *spectrum = spectrum_of(&t, 1);
    assert_int_equal(spectrum->line_count, 1);
    assert_line(&spectrum->lines[0], 1.7, 0.5, 0.2, 0.35, 0.15, 1e-10);
    whirl_spectrum_free(spectrum);
}

/// The synchronous part of tones whose amplitudes and phases are known, with others on and off the bins. x = a
/// cos(tau + p) lags by -p; a circle at the angle tau + p is forward and lags by -p, one at -tau + p backward and
/// passes x at p.
static void synchronous_part(void **state) {
    (void)state;
    const double quarter = 0.25 * two_pi, degree = two_pi / 360.0;
    const tone tones[] = {{1.0, 0.5, 0.0, 0.5, -quarter},                          // forward, no lag
                          {1.0, 0.2, 40.0 * degree, 0.2, 40.0 * degree + quarter}, // backward
                          {0.5, 0.7, 0.3, 0.1, 0.2},
                          {2.0, 0.9, 1.0, 0.4, 2.0},
                          {1.37, 0.3, 0.1, 0.2, 0.4}};
    const double complex x = 0.5 + 0.2 * cexp(I * 40.0 * degree), y = -0.5 * I + 0.2 * I * cexp(I * 40.0 * degree);
    const double amplitude[] = {cabs(x), cabs(y), 0.5, 0.2};
    const double lag[] = {360.0 - carg(x) / degree, -carg(y) / degree, 0.0, 320.0};
    whirl_spectrum *spectrum = spectrum_of(tones, 5);
    for (int i = 0; i < 4; i++) {
        assert_near(spectrum->synchronous.amplitude[i], amplitude[i], 1e-6); // 1.37 leaks so much at 37 bins
        assert_near(remainder(spectrum->synchronous.lag[i] - lag[i], 360.0), 0.0, 1e-4);
    }
    whirl_spectrum_free(spectrum);
    spectrum = spectrum_of(tones, 1);
    assert_near(spectrum->synchronous.amplitude[2], 0.5, 1e-13);
    assert_true(isnan(spectrum->synchronous.lag[3])); // a rounding error has no phase
    whirl_spectrum_free(spectrum);
    spectrum = spectrum_of(tones, 0);
    assert_true(spectrum->synchronous.amplitude[0] == 0.0);
    assert_true(isnan(spectrum->synchronous.lag[0]));
    whirl_spectrum_free(spectrum);
}

/// Lines between bins whose leakage overlaps have the values that each has alone, small ones next to large ones, too.
static void several_tones(void **state) {
    (void)state;
    const tone tones[] = {{0.41237, 0.070, 0.3, 0.050, 1.0},
                          {1.0, 0.053, 2.0, 0.11, -1.0},
                          {0.58763, 0.033, -0.4, 0.041, 2.2},
                          {1.0613, 0.002, 1.0, 0.0011, 0.1},
                          {3.0, 0.0129, 0.9, 0.0004, 0.0}};
    const size_t largest_first[] = {1, 0, 2, 4, 3};
    whirl_spectrum *spectrum = spectrum_of(tones, 5);
    assert_int_equal(spectrum->line_count, 5);
    for (size_t l = 0; l < 5; l++) {
        const tone *t = &tones[largest_first[l]];
        assert_near(spectrum->lines[l].order, t->order, 1e-7);
        assert_near(spectrum->lines[l].x, t->a, 1e-8);
        assert_near(spectrum->lines[l].y, t->b, 1e-8);
    }
    whirl_spectrum_free(spectrum);
}

/// A line d bins from a bin shows there with sin(pi d)/(pi d (1 - d^2)) of its amplitude (Harris 1978, eq. 27), and
/// far away falls with the cube of the distance: 1e-4 at 10 bins, 2e-7 at 100.
static void hann_lobe(void **state) {
    (void)state;
    const double offsets[] = {0.0, 0.2, 0.5};
    for (size_t i = 0; i < 3; i++) {
        const double d = offsets[i];
        const tone t = {(150.0 - d) / REVOLUTIONS, 1.0, 0.4, 0.0, 0.0};
        whirl_spectrum *spectrum = spectrum_of(&t, 1);
        for (int k = -2; k <= 2; k++) {
            const double away = d + k, angle = 0.5 * two_pi * away;
            const double expected = fabs(away) < 1e-9             ? 1.0
                                    : fabs(fabs(away) - 1) < 1e-9 ? 0.5
                                                                  : fabs(sin(angle) / (angle * (1.0 - away * away)));
            assert_near(spectrum->x[150 + k], expected, 1e-5);
            assert_near(spectrum->y[150 + k], 0.0, 1e-6);
        }
        assert_true(spectrum->x[160] < 4e-4);
        assert_true(spectrum->x[250] < 1e-6);
        whirl_spectrum_free(spectrum);
    }
}

/// Bins are orders 0 to 5, a hundredth apart. A line at the highest order is found, a small one beyond it is not.
static void range(void **state) {
    (void)state;
    const tone tones[] = {{5.0, 0.1, 0.0, 0.1, 0.3}, {5.5, 0.005, 0.0, 0.005, 0.3}};
    whirl_spectrum *spectrum = spectrum_of(tones, 2);
    assert_int_equal(spectrum->count, 501);
    assert_near(spectrum->resolution, 0.01, 1e-15);
    assert_int_equal(spectrum->line_count, 1);
    assert_near(spectrum->lines[0].order, 5.0, 1e-4);
    assert_near(spectrum->lines[0].x, 0.1, 1e-5);
    whirl_spectrum_free(spectrum);
}

/// Lines below a ten-thousandth of the largest are not reported, and of the others only the 16 largest are.
static void few_lines(void **state) {
    (void)state;
    const tone small[] = {{1.0, 1.0, 0.0, 1.0, 0.0}, {2.0, 0.7e-4, 0.0, 0.7e-4, 0.0}};
    whirl_spectrum *spectrum = spectrum_of(small, 2);
    assert_int_equal(spectrum->line_count, 1);
    whirl_spectrum_free(spectrum);
    tone many[20];
    for (size_t i = 0; i < 20; i++) many[i] = (tone){0.2 * (double)(i + 1), 1.0 + (double)i, 0.0, 0.5, 0.0};
    spectrum = spectrum_of(many, 20);
    assert_int_equal(spectrum->line_count, WHIRL_MAX_LINES);
    for (size_t i = 0; i < WHIRL_MAX_LINES; i++) assert_near(spectrum->lines[i].x, 20.0 - (double)i, 1e-3);
    whirl_spectrum_free(spectrum);
}

/// A motion that stands still, but for rounding, has no lines.
static void standstill(void **state) {
    (void)state;
    const tone rounding = {1.3, 1e-16, 0.0, 1e-16, 0.0};
    whirl_spectrum *spectrum = spectrum_of(&rounding, 1);
    assert_int_equal(spectrum->line_count, 0);
    whirl_spectrum_free(spectrum);
}

/// Lines are found at all orders, also above the highest one that is asked for, and the sum of their squares is that of
/// the waveform.
static void lines_hold_the_motion(void **state) {
    // 1X, and a backward whirl far above 5X; to half of the samples.
    static const double orders[] = {5.65, 11.3, 29.7};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        const tone tones[] = {{1.0, 0.15, 0.0, 0.15, -0.25 * two_pi},
                              {orders[i], 20.0, 0.3, 20.0, 0.3 + 0.25 * two_pi}};
        whirl_spectrum *spectrum = spectrum_of(tones, 2);
        assert_line(&spectrum->lines[0], orders[i], 20.0, 20.0, 0.0, 20.0, 1e-3);
        assert_near(spectrum->line_share, 1.0, 1e-4);
        assert_near((double)(spectrum->count - 1) * spectrum->resolution, 5.0, 1e-12);
        whirl_spectrum_free(spectrum);
    }
    // A motion below 5X has its lines there alone: a small one above is left out.
    const tone below[] = {{1.0, 1.0, 0.0, 1.0, 1.0}, {7.0, 0.05, 0.0, 0.05, 1.0}};
    whirl_spectrum *spectrum = spectrum_of(below, 2);
    assert_int_equal(spectrum->line_count, 1);
    assert_near(spectrum->line_share, 1.0 / (1.0 + 0.05 * 0.05), 1e-6);
    whirl_spectrum_free(spectrum);
    // Of thirty equal lines sixteen are reported.
    tone many[30];
    for (int i = 0; i < 30; i++) many[i] = (tone){0.5 + (double)i, 1.0, 0.7 * i * i, 1.0, 1.3 * i * i};
    spectrum = spectrum_of(many, 30);
    assert_near(spectrum->line_share, 16.0 / 30.0, 1e-3);
    whirl_spectrum_free(spectrum);
}

static void bad_input(void **state) {
    (void)state;
    whirl_spectrum *spectrum;
    whirl_record record = {.probe_count = 1, .record_count = 4};
    assert_int_equal(whirl_spectrum_new(&record, 0, 5.0, &spectrum).code, WHIRL_BAD_INPUT);
    assert_null(spectrum);
    record = record_of_tones(NULL, 0, 0.0, 0.0);
    assert_int_equal(whirl_spectrum_new(&record, 1, 5.0, &spectrum).code, WHIRL_BAD_INPUT);
    assert_int_equal(whirl_spectrum_new(&record, 0, 0.0, &spectrum).code, WHIRL_BAD_INPUT);
    free(record.waveform);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circles),       cmocka_unit_test(ellipse),
        cmocka_unit_test(several_tones), cmocka_unit_test(synchronous_part),
        cmocka_unit_test(hann_lobe),     cmocka_unit_test(range),
        cmocka_unit_test(few_lines),     cmocka_unit_test(standstill),
        cmocka_unit_test(bad_input),     cmocka_unit_test(lines_hold_the_motion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
