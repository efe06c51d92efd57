// The transform between bins against its definition.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "transform.h"

static const double two_pi = 6.283185307179586476925;

/// Returns pseudo-random numbers from -1 to 1.
static double random_number(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 4503599627370496.0 - 1.0;
}

static double complex sum(const double *samples, size_t count, double bin) {
    const long double turn = 6.283185307179586476925286766559L / (long double)count;
    long double re = 0.0L, im = 0.0L;
    for (size_t j = 0; j < count; j++) {
        re += (long double)samples[j] * cosl(turn * (long double)bin * (long double)j);
        im -= (long double)samples[j] * sinl(turn * (long double)bin * (long double)j);
    }
    return (double)re + I * (double)im;
}

/// Returns the largest error of the transform of noise in a Hann window, which has all frequencies, over the mean size
/// of the amplitudes.
static double largest_error(size_t count) {
    double *x = malloc(2 * count * sizeof *x), *y = x + count, worst = 0.0, power = 0.0;
    uint64_t state = count;
    assert_non_null(x);
    for (size_t j = 0; j < 2 * count; j++) {
        const double s = sin(0.5 * two_pi * (double)(j % count) / (double)count);
        x[j] = s * s * random_number(&state);
        power += x[j] * x[j];
    }
    wave_transform *wave = wave_transform_new(x, y, count, 1.0);
    assert_non_null(wave);
    assert_int_equal(wave_transform_count(wave), count);
    for (int i = 0; i < 50; i++) {
        const double bin = (i % 5 == 0 ? floor(i * 0.3) : 0.25 * (double)count * (1.0 + random_number(&state)));
        const wave_amplitudes found = wave_transform_at(wave, bin);
        worst = fmax(worst, cabs(found.x - sum(x, count, bin)));
        worst = fmax(worst, cabs(found.y - sum(y, count, bin)));
    }
    wave_transform_free(wave);
    free(x);
    return worst / sqrt(power + 1e-300);
}

static void transform_is_the_sum(void **state) {
    // Whole and broken multiples of powers of two, primes, and next to nothing.
    const size_t counts[] = {1, 2, 3, 7, 64, 100, 1024, 1031, 4096, 6400, 6397, 8191};
    (void)state;
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        const double error = largest_error(counts[i]);
        printf("%5zu samples: %.1e\n", counts[i], error);
        assert_true(error < 1e-14);
    }
}

/// A sinusoid at the frequency of a bin, without a window, has its own amplitude there.
static void window_sum_is_the_unit(void **state) {
    enum { COUNT = 96 };
    double x[COUNT], y[COUNT];
    (void)state;
    for (int j = 0; j < COUNT; j++) {
        x[j] = 0.5 * cos(two_pi * 5 * j / COUNT + 0.3);
        y[j] = 0.25 * sin(two_pi * 5 * j / COUNT);
    }
    wave_transform *wave = wave_transform_new(x, y, COUNT, COUNT);
    assert_non_null(wave);
    const wave_amplitudes found = wave_transform_at(wave, 5.0);
    assert_true(cabs(found.x - 0.25 * cexp(0.3 * I)) < 1e-14);
    assert_true(cabs(found.y - -0.125 * I) < 1e-14);
    wave_transform_free(wave);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(transform_is_the_sum),
                                       cmocka_unit_test(window_sum_is_the_unit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
