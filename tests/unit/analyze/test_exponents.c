// Largest Lyapunov exponents and their errors, on sequences and maps whose values are known.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "mean_growth.h"
#include "near.h"
#include "synthetic.h"

/// Returns standard normal numbers from a linear congruential generator (Knuth's MMIX), by Box and Muller.
static double normal(uint64_t *seed) {
    double u[2];
    for (size_t i = 0; i < 2; i++) {
        *seed = *seed * 6364136223846793005u + 1442695040888963407u;
        u[i] = ((double)(*seed >> 11) + 0.5) / 9007199254740992.0;
    }
    return sqrt(-2.0 * log(u[0])) * cos(6.283185307179586 * u[1]);
}

/// The mean of AR(1) x' = phi x + e has the standard deviation 1/((1 - phi) sqrt(n)) for unit e. Errors of single
/// sequences scatter (15 or 31 degrees of freedom); their root mean square must meet it.
static void correlated_noise(void **state) {
    (void)state;
    enum { COUNT = 6400, TRIALS = 200 };
    const double coefficients[] = {0.0, 0.8, 0.95, -0.8};
    double *values = malloc(COUNT * sizeof *values);
    assert_non_null(values);
    for (size_t c = 0; c < 4; c++) {
        const double phi = coefficients[c], expected = 1.0 / ((1.0 - phi) * sqrt(COUNT));
        uint64_t seed = 42 + c;
        double claimed = 0.0, actual = 0.0;
        for (size_t t = 0; t < TRIALS; t++) {
            double x = normal(&seed) / sqrt(1.0 - phi * phi);
            for (size_t i = 0; i < COUNT; i++) {
                values[i] = 0.3 + x;
                x = phi * x + normal(&seed);
            }
            const whirl_estimate e = estimate_mean(values, COUNT);
            claimed += e.error * e.error / TRIALS;
            actual += (e.value - 0.3) * (e.value - 0.3) / TRIALS;
        }
        assert_near(sqrt(actual) / expected, 1.0, 0.15); // the mean is what theory says
        assert_near(sqrt(claimed) / expected, 1.08,
                    0.17); // and the error not below it; the larger of two is a little above
    }
    free(values);
}

/// The sharp mean of a regular sequence: 0.1 + cos(n sqrt 2) has the mean 0.1.
static void regular_sequences(void **state) {
    (void)state;
    double values[600];
    for (size_t i = 0; i < 600; i++) values[i] = 0.1 + cos((double)i * sqrt(2.0));
    whirl_estimate e = estimate_regular_mean(values, 600, 1);
    assert_near(e.value, 0.1, 1e-9);
    assert_true(fabs(e.value - 0.1) <= e.error + 1e-12 && e.error < 1e-5);
    for (size_t i = 0; i < 600; i++) values[i] = i % 7 == 0 ? 3.0 : -1.0;
    e = estimate_regular_mean(values, 600, 7);
    assert_near(e.value, -3.0 / 7.0, 1e-14);
    assert_near(e.error, 0.0, 1e-14);
}

static void assert_exponent(const map_system *system, double expected, double most_error) {
    whirl_record *record = record_map(system, 1000, 20000, 10000);
    const whirl_estimate e = whirl_lyapunov_largest(record);
    assert_true(e.error <= most_error);
    assert_true(fabs(e.value - expected) <= 4.0 * e.error + 1e-12);
    free(record);
}

static void known_exponents(void **state) {
    (void)state;
    // r = 4 is conjugate to the tent map: ln 2. (A start whose orbit does not fall on 0 in doubles.)
    assert_exponent(
        &(map_system){
            .map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {4.0}, .start = {0.3123}},
        log(2.0), 0.01);
    // Henon (a = 1.4, b = 0.3): 0.41922 (Sprott 2003, table A.2).
    assert_exponent(
        &(map_system){
            .map = henon_map, .dimension = 2, .section_dimension = 2, .parameters = {1.4, 0.3}, .start = {0.1, 0.1}},
        0.41922, 0.01);
    // P-2 at r = 3.2: half of ln |4 + 2 r - r^2|.
    assert_exponent(
        &(map_system){.map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {3.2}, .start = {0.3}},
        0.5 * log(fabs(4.0 + 2.0 * 3.2 - 3.2 * 3.2)), 1e-3);
    // An invertible circle map off its tongues: 0.
    assert_exponent(
        &(map_system){
            .map = circle_map, .embed = on_circle, .dimension = 1, .section_dimension = 2, .parameters = {0.4371, 0.7}},
        0.0, 1e-3);
    // A spiral of modulus 0.97.
    assert_exponent(&(map_system){.map = spiral_map,
                                  .dimension = 2,
                                  .section_dimension = 2,
                                  .parameters = {0.97, 0.123},
                                  .start = {0.1, 0.0}},
                    log(0.97), 1e-6);
}

/// The first tenth of the growth, in which the perturbation turns, does not count. Without a perturbation the exponent
/// is NaN.
static void first_tenth_does_not_count(void **state) {
    (void)state;
    double growth[100];
    for (size_t i = 0; i < 100; i++) growth[i] = i < 10 ? 5.0 : 0.25;
    whirl_record record = {.growth_count = 100, .growth = growth};
    const whirl_estimate e = whirl_lyapunov_largest(&record);
    assert_near(e.value, 0.25, 1e-15);
    assert_near(e.error, 0.0, 1e-15);
    record.growth_count = 0;
    assert_true(isnan(whirl_lyapunov_largest(&record).value));
    record = (whirl_record){.growth_count = 100, .growth = growth, .motion = WHIRL_DIVERGED};
    assert_true(isnan(whirl_lyapunov_largest(&record).value));
}

/// All exponents are the means of their columns; the mean growth of the volume is their sum.
static void all_exponents(void **state) {
    (void)state;
    enum { N = 3, COUNT = 50 };
    double growths[COUNT][N], volume[COUNT];
    whirl_estimate exponents[N];
    for (size_t i = 0; i < COUNT; i++) {
        for (size_t k = 0; k < N; k++) growths[i][k] = i < COUNT / 10 ? 7.0 : 0.5 - (double)k + (i % 2 ? 0.1 : -0.1);
        volume[i] = -1.5;
    }
    const whirl_record record = {.dimension = N, .growth_count = COUNT, .growths = growths[0], .volume = volume};
    assert_true(whirl_lyapunov_spectrum(&record, exponents));
    // 45 revolutions count, of which 23 have 0.1 more.
    for (size_t k = 0; k < N; k++) {
        assert_near(exponents[k].value, 0.5 - (double)k + 0.1 / 45.0, 1e-14);
        assert_true(exponents[k].error > 0.0 && exponents[k].error < 0.05);
    }
    const whirl_record one = {.dimension = N, .growth_count = COUNT, .growth = volume};
    assert_false(whirl_lyapunov_spectrum(&one, exponents));
    assert_true(isnan(exponents[0].value) && isnan(exponents[2].error));
}

/// Kaplan and Yorke's own example, Henon's map: 1 + 0.4192/1.6232 = 1.258; and the ends of the formula.
static void dimension_of_an_attractor(void **state) {
    (void)state;
    const whirl_estimate henon[] = {{0.4192, 1e-4}, {-1.6232, 1e-4}};
    assert_near(whirl_kaplan_yorke(henon, 2), 1.25826, 1e-5);
    const whirl_estimate point[] = {{-0.1, 1e-3}, {-0.2, 1e-3}};
    assert_near(whirl_kaplan_yorke(point, 2), 0.0, 0.0);
    const whirl_estimate curve[] = {{-1e-4, 1e-4}, {-0.2, 1e-3}, {-0.3, 1e-3}};
    assert_near(whirl_kaplan_yorke(curve, 3), 1.0, 0.0);
    const whirl_estimate conservative[] = {{0.3, 1e-3}, {0.0, 1e-4}, {-0.3, 1e-3}};
    assert_near(whirl_kaplan_yorke(conservative, 3), 3.0, 0.0);
    const whirl_estimate strange[] = {{0.2, 1e-3}, {0.1, 1e-3}, {-0.15, 1e-3}, {-0.6, 1e-3}};
    assert_near(whirl_kaplan_yorke(strange, 4), 3.25, 1e-14);
    const whirl_estimate unknown[] = {{NAN, NAN}};
    assert_true(isnan(whirl_kaplan_yorke(unknown, 1)));
}

/// Makes a record with the exponents -0.1, with a scatter, and -0.3, whose sum differs from the growth of the volume by
/// `miss`.
static whirl_record *balanced_record(double scatter, double miss) {
    enum { COUNT = 640 };
    whirl_record *record = calloc(1, sizeof *record + 4 * COUNT * sizeof(double));
    assert_non_null(record);
    double *numbers = (double *)(record + 1);
    *record = (whirl_record){.dimension = 2, .growth_count = COUNT};
    record->growth = numbers;
    record->growths = numbers + COUNT;
    record->volume = numbers + 3 * (size_t)COUNT;
    uint64_t seed = 5;
    for (size_t i = 0; i < COUNT; i++) {
        record->growths[2 * i] = record->growth[i] = -0.1 + scatter * normal(&seed);
        record->growths[2 * i + 1] = -0.3;
        record->volume[i] = record->growth[i] - 0.3 - miss;
    }
    return record;
}

/// The error of the sum of exponents is added to every error; if errors do not explain it, there are no exponents.
static void sums_that_miss(void **state) {
    (void)state;
    static const struct {
        double scatter, miss;
        bool failed;
    } rows[] = {{0.0, 1e-5, false}, {0.0, 1e-3, true}, {0.0, -2.93, true}, {0.5, 2e-3, false}, {0.5, 0.5, true}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        whirl_record *record = balanced_record(rows[i].scatter, rows[i].miss);
        whirl_estimate exponents[2], largest = whirl_lyapunov_largest(record);
        assert_int_equal(whirl_lyapunov_spectrum(record, exponents), !rows[i].failed);
        assert_int_equal(isnan(exponents[0].value) && isnan(exponents[1].error), rows[i].failed);
        assert_int_equal(isnan(largest.value) && isnan(largest.error), rows[i].failed);
        const double missed = balance_growth(record).miss;
        assert_near(missed, fabs(rows[i].miss), 1e-12);
        if (!rows[i].failed) {
            assert_near(largest.value, exponents[0].value, 1e-15);
            assert_true(exponents[1].error >= missed * (1.0 - 1e-9) && largest.error >= missed * (1.0 - 1e-9));
        }
        record->volume[600] = NAN; // it slid along a switch: nothing is known of the sum
        assert_true(whirl_lyapunov_spectrum(record, exponents));
        free(record);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(correlated_noise), cmocka_unit_test(regular_sequences),
        cmocka_unit_test(known_exponents),  cmocka_unit_test(first_tenth_does_not_count),
        cmocka_unit_test(all_exponents),    cmocka_unit_test(dimension_of_an_attractor),
        cmocka_unit_test(sums_that_miss),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
