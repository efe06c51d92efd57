// Rational functions fitted to samples: known ones are found again, others come near and stay stable.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "rational_fit.h"

enum { SAMPLES = RATIONAL_MAX_SAMPLES };

static const rational_fit two_pairs = {
    .constant = {1e6, 2e5, -3e5, 2e6},
    .slope = {100.0, 30.0, -20.0, 400.0},
    .pair_count = 2,
    .pairs = {{.w = 250.0, .g = 90.0, .place = {2e5, 1e5, 3e4, -4e5}, .rate = {5e4, 0.0, 2e5, 1e5}},
              {.w = 500.0, .g = 1700.0, .place = {1e6, -2e5, 2e5, 5e5}, .rate = {-3e5, 1e5, 4e4, 9e5}}}};

static void take(const rational_fit *from, double low, double high, size_t count, double *w, rational_sample *out) {
    for (size_t k = 0; k < count; k++) {
        w[k] = low + (high - low) * (double)k / (double)(count - 1);
        out[k] = rational_fit_value(from, w[k]);
    }
}

static bool make(size_t count, const double *w, const rational_sample *samples, size_t pairs, rational_fit *out) {
    return rational_fit_poles(1, count, w, samples, pairs, out) && rational_fit_numbers(count, w, samples, out);
}

/// Returns the largest relative difference over many frequencies.
static double apart(const rational_fit *one, const rational_fit *other, double low, double high) {
    double most = 0.0;
    for (int k = 0; k <= 1000; k++) {
        const double w = low + (high - low) * k / 1000.0;
        const rational_sample expected = rational_fit_value(one, w);
        rational_sample found = rational_fit_value(other, w);
        for (int e = 0; e < RATIONAL_ENTRIES; e++)
            for (int part = 0; part < 2; part++) found.entry[e][part] -= expected.entry[e][part];
        most = fmax(most, rational_size(&found) / rational_size(&expected));
    }
    return most;
}

static void close_to(double found, double expected, double share) {
    if (!(fabs(found - expected) <= share * fabs(expected))) fail_msg("%.17g, expected %.17g", found, expected);
}

/// A fit of samples of a rational function finds its poles and residues: a pair that whirls and two real poles (-181.4
/// and -1518.6), from 0 and from above 0.
static void found_again(void **state) {
    static const double lows[] = {0.0, 40.0};
    (void)state;
    for (int from = 0; from < 2; from++) {
        double w[SAMPLES];
        rational_sample samples[SAMPLES];
        rational_fit found;
        take(&two_pairs, lows[from], 900.0, 20, w, samples);
        assert_true(make(20, w, samples, 2, &found));
        assert_int_equal(found.pair_count, 2);
        const int first = found.pairs[0].w < found.pairs[1].w ? 0 : 1;
        for (int j = 0; j < 2; j++) {
            const rational_pair *own = &found.pairs[j == 0 ? first : 1 - first], *known = &two_pairs.pairs[j];
            close_to(own->w, known->w, 1e-9);
            close_to(own->g, known->g, 1e-9);
            for (int e = 0; e < RATIONAL_ENTRIES; e++) {
                assert_true(fabs(own->place[e] - known->place[e]) < 1e-9 * 1e6);
                assert_true(fabs(own->rate[e] - known->rate[e]) < 1e-9 * 1e6);
            }
        }
        for (int e = 0; e < RATIONAL_ENTRIES; e++) {
            close_to(found.constant[e], two_pairs.constant[e], 1e-8);
            close_to(found.slope[e], two_pairs.slope[e], 1e-8);
        }
        assert_true(apart(&two_pairs, &found, 0.0, 2000.0) < 1e-9);
    }
}

/// A fit with more poles than the function has is as good.
static void with_poles_to_spare(void **state) {
    double w[SAMPLES];
    rational_sample samples[SAMPLES];
    (void)state;
    take(&two_pairs, 0.0, 900.0, SAMPLES, w, samples);
    for (size_t pairs = 2; pairs <= RATIONAL_MAX_PAIRS; pairs++) {
        rational_fit found;
        assert_true(make(SAMPLES, w, samples, pairs, &found));
        assert_true(apart(&two_pairs, &found, 0.0, 900.0) < 1e-9);
        for (size_t j = 0; j < pairs; j++) assert_true(found.pairs[j].g > 0.0 && found.pairs[j].w > 0.0);
    }
}

/// Constants are fitted, with and without poles.
static void constants(void **state) {
    const rational_fit flat = {.constant = {1e6, 0.0, 5.0, 2e6}, .slope = {300.0, 0.0, 0.0, 0.0}};
    double w[8];
    rational_sample samples[8];
    (void)state;
    take(&flat, 10.0, 100.0, 8, w, samples);
    for (size_t pairs = 0; pairs <= 3; pairs++) {
        rational_fit found;
        assert_true(make(8, w, samples, pairs, &found));
        assert_true(apart(&flat, &found, 10.0, 100.0) < 1e-12);
    }
}

/// Samples that are off by a part in a thousand are met to about as much, by stable poles.
static void with_noise(void **state) {
    double w[SAMPLES];
    rational_sample samples[SAMPLES];
    uint32_t random = 1;
    (void)state;
    take(&two_pairs, 0.0, 900.0, SAMPLES, w, samples);
    for (size_t k = 0; k < SAMPLES; k++)
        for (int e = 0; e < RATIONAL_ENTRIES; e++)
            for (int part = 0; part < 2; part++) {
                random = random * 1664525u + 1013904223u;
                samples[k].entry[e][part] *= 1.0 + 1e-3 * (2.0 * random / 4294967296.0 - 1.0);
            }
    for (size_t pairs = 2; pairs <= RATIONAL_MAX_PAIRS; pairs++) {
        rational_fit found;
        assert_true(make(SAMPLES, w, samples, pairs, &found));
        assert_true(apart(&two_pairs, &found, 0.0, 900.0) < 5e-3);
        for (size_t j = 0; j < pairs; j++) assert_true(found.pairs[j].g > 0.0);
    }
}

/// A function with an unstable pole is approximated as well as stable poles can. The fit of a damping that falls with
/// the frequency has no negative damping beyond the samples.
static void fits_are_stable(void **state) {
    double w[SAMPLES];
    rational_sample samples[SAMPLES];
    rational_fit unstable = two_pairs, found;
    (void)state;
    unstable.pairs[0].g = -90.0;
    take(&unstable, 0.0, 900.0, SAMPLES, w, samples);
    assert_true(make(SAMPLES, w, samples, 2, &found));
    for (size_t j = 0; j < 2; j++) assert_true(found.pairs[j].g > 0.0);
    // Damping that falls with the frequency, K = 1e6, C = 1000 - w: the straight end of it is no function's slope.
    for (size_t k = 0; k < SAMPLES; k++) {
        w[k] = 30.0 * (double)k;
        samples[k] = (rational_sample){{{1e6, w[k] * (1000.0 - w[k])}, {0.0, 0.0}, {0.0, 0.0}, {1e6, 0.0}}};
    }
    assert_true(make(SAMPLES, w, samples, 1, &found));
    assert_true(found.slope[0] >= -1e-6);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(found_again), cmocka_unit_test(with_poles_to_spare),
                                       cmocka_unit_test(constants), cmocka_unit_test(with_noise),
                                       cmocka_unit_test(fits_are_stable)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
