// Rain flow against the example of ASTM E1049 and another sequence, and damage against closed forms.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "near.h"
#include "whirl/signals.h"

#define assert_ok(call) assert_string_equal((call).message, "")

static void assert_refused(whirl_status status, const char *words) {
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    if (!strstr(status.message, words)) fail_msg("'%s' does not say '%s'", status.message, words);
}

enum { SAMPLES = 4001 };
static double cycles[SAMPLES][WHIRL_SIGNALS_CYCLE];
static size_t rows;

static double cycles_of(double range) {
    double sum = 0.0;
    for (size_t i = 0; i < rows; i++) sum += cycles[i][0] == range ? cycles[i][2] : 0.0;
    return sum;
}

static void check_counts(const double *values, size_t count, const double (*expected)[2], size_t ranges) {
    double all = 0.0, known = 0.0;
    assert_ok(whirl_signals_rain_flow(values, count, *cycles, &rows));
    for (size_t i = 0; i < ranges; i++) {
        assert_near(cycles_of(expected[i][0]), expected[i][1], 0.0);
        known += expected[i][1];
    }
    for (size_t i = 0; i < rows; i++) all += cycles[i][2];
    assert_near(all, known, 0.0);
}

static const double standard[] = {-2, 1, -3, 5, -1, 3, -4, 4, -2};

static void sequences(void **state) {
    (void)state;
    static const double expected[][2] = {{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1}, {9, 0.5}};
    check_counts(standard, 9, expected, 5);
    // The standard's rows: A-B, B-C, then the cycle E-F, C-D, and D-G, G-H, H-I at the end.
    static const double all[][3] = {{3, -0.5, 0.5}, {4, -1, 0.5}, {4, 1, 1},  {8, 1, 0.5},
                                    {9, 0.5, 0.5},  {8, 0, 0.5},  {6, 1, 0.5}};
    assert_int_equal(rows, 7);
    assert_memory_equal(cycles, all, sizeof all);
    static const double other[] = {0, 6, -4, 2, -1, 5, -5, 3, -2, 1, -3, 4, 0};
    static const double counts[][2] = {{3, 2}, {4, 0.5}, {6, 1.5}, {9, 1.5}, {11, 0.5}};
    check_counts(other, 13, counts, 5);
}

/// Samples between peaks and equal ones change nothing; a mirrored history has the same ranges and mirrored means; a
/// larger one larger ranges.
static void invariances_of_the_count(void **state) {
    (void)state;
    double fine[8 * 9], mirrored[9], first[7][3];
    assert_ok(whirl_signals_rain_flow(standard, 9, *cycles, &rows));
    memcpy(first, cycles, sizeof first);
    for (size_t i = 0; i < 72; i++) {
        const size_t at = i / 8, next = at < 8 ? at + 1 : at;
        const double part = i % 8 < 3 ? 0.0 : 0.25 * (double)(i % 8 - 3);
        fine[i] = standard[at] + part * (standard[next] - standard[at]);
    }
    assert_ok(whirl_signals_rain_flow(fine, 72, *cycles, &rows));
    assert_int_equal(rows, 7);
    assert_memory_equal(cycles, first, sizeof first);
    for (size_t i = 0; i < 9; i++) mirrored[i] = -1024.0 * standard[i];
    assert_ok(whirl_signals_rain_flow(mirrored, 9, *cycles, &rows));
    assert_int_equal(rows, 7);
    for (size_t i = 0; i < 7; i++) {
        assert_near(cycles[i][0], 1024.0 * first[i][0], 0.0);
        assert_near(cycles[i][1], -1024.0 * first[i][1], 0.0);
        assert_near(cycles[i][2], first[i][2], 0.0);
    }
    const double flat[] = {2, 2, 2}, step[] = {1, 1, 4, 4};
    assert_ok(whirl_signals_rain_flow(flat, 3, *cycles, &rows));
    assert_int_equal(rows, 0);
    assert_ok(whirl_signals_rain_flow(step, 4, *cycles, &rows));
    assert_true(rows == 1 && cycles[0][0] == 3.0 && cycles[0][1] == 2.5 && cycles[0][2] == 0.5);
}

/// A sine of 500 periods and the amplitude 50 about any mean: damage n/N.
static void damage_of_a_sine(void **state) {
    (void)state;
    static double sine[SAMPLES];
    const double point = 200.0, life = 1e6, several[] = {400.0, 200.0, 50.0}, lives[] = {1e4, 1e6, 1e8};
    double damage;
    for (size_t i = 0; i < SAMPLES; i++) sine[i] = 30.0 + 50.0 * sin(0.25 * 3.14159265358979323846 * (double)i);
    assert_ok(whirl_signals_rain_flow(sine, SAMPLES, *cycles, &rows));
    // The first and last quarter are half cycles of 50, the rest are 499.5 cycles of 100: N = 1e6 2^5.
    assert_ok(whirl_signals_damage(*cycles, rows, &point, &life, 1, 5.0, 51.0, &damage));
    assert_near(damage, 499.5 / 32e6, 1e-17);
    assert_ok(whirl_signals_damage(*cycles, rows, &point, &life, 1, 5.0, 0.0, &damage));
    assert_near(damage, 499.5 / 32e6 + 1.0 / 1024e6, 1e-17);
    // Between (200, 1e6) and (50, 1e8) over logarithms: half way, 1e7; at 50, 1e8.
    assert_ok(whirl_signals_damage(*cycles, rows, several, lives, 3, 0.0, 0.0, &damage));
    assert_near(damage, 499.5 / 1e7 + 1.0 / 1e8, 1e-15);
    assert_ok(whirl_signals_damage(*cycles, rows, several, lives, 3, 0.0, 100.0 + 1e-9, &damage));
    assert_near(damage, 0.0, 0.0);
    const double extremes[2][3] = {{400.0, 0.0, 2.0}, {12.5, 0.0, 3.0}}; // the first point; the last line goes on
    assert_ok(whirl_signals_damage(*extremes, 2, several, lives, 3, 0.0, 0.0, &damage));
    assert_near(damage, 2.0 / 1e4 + 3.0 / 1e10, 1e-17);
}

static void refusals(void **state) {
    (void)state;
    const double gap[] = {1, NAN, 2}, ranges[] = {400.0, 200.0}, lives[] = {1e4, 1e6}, negative[] = {200.0, -1.0};
    const double high[3] = {401.0, 0.0, 1.0}, broken[3] = {1.0, 0.0, NAN};
    double damage;
    assert_refused(whirl_signals_rain_flow(gap, 3, *cycles, &rows), "sample 1 of channel 0 is nan");
    assert_refused(whirl_signals_rain_flow(gap, 0, *cycles, &rows), "there are 0 samples");
    assert_refused(whirl_signals_damage(high, 1, ranges, lives, 0, 0, 0, &damage), "the S-N curve has no point");
    assert_refused(whirl_signals_damage(high, 1, ranges, lives, 1, 0, 0, &damage), "the slope of the S-N curve is 0");
    assert_refused(whirl_signals_damage(high, 1, ranges, lives, 2, 0, 0, &damage),
                   "row 0 has the range 401, expected at most 400, where the S-N curve begins");
    assert_refused(whirl_signals_damage(high, 1, ranges, ranges, 2, 0, 0, &damage),
                   "point 1 of the S-N curve is a range of 200 and 200 cycles after 400 and 400");
    assert_refused(whirl_signals_damage(high, 1, ranges, negative, 2, 0, 0, &damage), "a range of 200 and -1 cycles");
    assert_refused(whirl_signals_damage(high, 1, ranges, lives, 2, 0, -1, &damage), "the endurance limit is -1");
    assert_refused(whirl_signals_damage(broken, 1, ranges, lives, 2, 0, 0, &damage), "row 0 is nan cycles");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sequences),
        cmocka_unit_test(invariances_of_the_count),
        cmocka_unit_test(damage_of_a_sine),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
