// Studies of tolerances against closed forms: moments, indices, probabilities and quantiles, each within its own stated
// error, and errors that fall with the number of samples.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/case.h"
#include "whirl/engine/spread.h"
#include "whirl/engine/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 4096 };

/// A Jeffcott rotor, whose amplitude is e w^2/sqrt((k - w^2)^2 + (2 zeta w)^2).
static const char jeffcott[] = "whirl: 1\n"
                               "parameters: {omega: 0.95 rad/s, zeta: 0.04, k: 1 N/m, e: 1 m}\n"
                               "rotor:\n"
                               "  speed: = omega\n"
                               "  length_scale: 1 m\n"
                               "  stations:\n"
                               "    disc: {mass: 1 kg, damping: = 2*zeta, eccentricity: = e}\n"
                               "  elements:\n"
                               "    - shaft: {between: [disc, ground], k1: = k}\n"
                               "study:\n"
                               "  unbalance: {}\n"
                               "  tolerances:\n"
                               "    parameters: {zeta: {from: 0.02, to: 0.06}, k: 1 N/m +- 10 %%, e: +- 20 %%}\n"
                               "    samples: %d\n"
                               "    seed: %d\n"
                               "    indices: yes\n"
                               "    of: [{field: unbalance/axes, column: major, at: disc, below: 12 m}]\n";

/// A rotor that vibrates by the eccentricity alone, which is 10 plus the function of Ishigami and Homma 1990.
static const char ishigami[] = "whirl: 1\n"
                               "parameters: {x1: 0, x2: 0, x3: 0}\n"
                               "rotor:\n"
                               "  speed: 1 rad/s\n"
                               "  length_scale: 1 m\n"
                               "  stations:\n"
                               "    disc: {mass: 1 kg, eccentricity: = 20 + sin(x1) + 7*sin(x2)^2 + 0.1*x3^4*sin(x1)}\n"
                               "  elements:\n"
                               "    - shaft: {between: [disc, ground], k1: 2 N/m}\n"
                               "study:\n"
                               "  unbalance: {}\n"
                               "  tolerances:\n"
                               "    parameters:\n"
                               "      x1: {from: = -pi, to: = pi}\n"
                               "      x2: {from: = -pi, to: = pi}\n"
                               "      x3: {from: = -pi, to: = pi}\n"
                               "    samples: %d\n"
                               "    seed: %d\n"
                               "    indices: yes\n";

/// The same rotor, whose amplitude is its eccentricity: a truncated normal one, and a uniform one with it.
static const char amplitude[] = "whirl: 1\n"
                                "parameters: {a: 2, b: 1}\n"
                                "rotor:\n"
                                "  speed: 1 rad/s\n"
                                "  length_scale: 1 m\n"
                                "  stations:\n"
                                "    disc: {mass: 1 kg, eccentricity: = a + b}\n"
                                "  elements:\n"
                                "    - shaft: {between: [disc, ground], k1: 2 N/m}\n"
                                "study:\n"
                                "  unbalance: {}\n"
                                "  tolerances:\n"
                                "    parameters: {a: %s, b: %s}\n"
                                "    samples: %d\n"
                                "    seed: %d\n"
                                "    of: [{field: unbalance/axes, column: major, at: disc, below: %s}]\n";

static whirl_result *run(const char *text) {
    whirl_case *object;
    whirl_result *result;
    require_ok(whirl_case_parse(text, strlen(text), "case", NULL, &object));
    require_ok(whirl_case_run(object, &(whirl_run_options){.threads = 2}, &result));
    whirl_case_free(object);
    return result;
}

static whirl_spread spread_of(const whirl_result *result) {
    const whirl_table *table = whirl_result_role(result, WHIRL_ROLE_TOLERANCES);
    whirl_spread_of of;
    whirl_spread spread;
    assert_non_null(table);
    assert_true(whirl_table_asked(result, table, 0, &of));
    require_ok(whirl_table_spread(result, table, &of, 0, 0, &spread));
    assert_int_equal(spread.failed, 0);
    return spread;
}

enum { SEEDS = 8, ESTIMATES = 8 };

/// Estimates against their exact values: mean, variance, then first and total index of each of three parameters.
typedef struct tally {
    double squares[ESTIMATES]; ///< sums of (estimate - exact)^2 / error^2
    double errors;             ///< sum of relative errors of the mean
    size_t far;                ///< estimates more than four standard errors away
} tally;

static void compare(tally *of, const whirl_spread *s, const double exact[ESTIMATES]) {
    const whirl_estimate found[ESTIMATES] = {s->mean,
                                             s->variance,
                                             s->indices[0].first,
                                             s->indices[0].total,
                                             s->indices[1].first,
                                             s->indices[1].total,
                                             s->indices[2].first,
                                             s->indices[2].total};
    assert_int_equal(s->index_count, 3);
    for (size_t i = 0; i < ESTIMATES; i++) {
        const double away = (found[i].value - exact[i]) / found[i].error;
        of->squares[i] += away * away;
        of->far += fabs(away) > 4.0;
    }
    of->errors += s->mean.error / fabs(s->mean.value);
}

/// Repeats a study with many seeds: estimates differ from exact values by as much as their errors say. The sum of
/// squares of 8 values of Student's t with 15 degrees of freedom lies between 1 and 36 in 99.9 % of cases.
static double repeat(const char *format, int samples, const double exact[ESTIMATES]) {
    tally all = {.far = 0};
    char text[SIZE];
    for (int seed = 1; seed <= SEEDS; seed++) {
        snprintf(text, sizeof text, format, samples, seed);
        whirl_result *result = run(text);
        const whirl_spread spread = spread_of(result);
        compare(&all, &spread, exact);
        whirl_result_free(result);
    }
    for (size_t i = 0; i < ESTIMATES; i++)
        if (all.squares[i] > 36.0 || all.squares[i] < 1.0)
            fail_msg("estimate %zu of %d samples: squares of %g over %d seeds", i, samples, all.squares[i], SEEDS);
    assert_in_range(all.far, 0, 2);
    return all.errors / SEEDS;
}

/// Closed form of N4 (Gauss-Legendre and tanh-sinh quadrature, 12 digits).
static void test_amplitude_of_three(void **state) {
    (void)state;
    static const double exact[ESTIMATES] = {7.972948590013, 12.62118093502, .146118406047, .285974921208,
                                            .638358887065,  .784778608639,  .067154739900, .079429019638};
    const double few = repeat(jeffcott, 128, exact), many = repeat(jeffcott, 512, exact);
    assert_true(many < few / 2.0); // what independent samples would gain
}

/// Ishigami and Homma 1990, a = 7, b = 0.1; the amplitude is the eccentricity at this speed.
static void test_ishigami(void **state) {
    (void)state;
    const double pi = 3.14159265358979324, a = 7.0, b = 0.1, p4 = pow(pi, 4), p8 = p4 * p4;
    const double first = 0.5 * pow(1.0 + b * p4 / 5.0, 2), second = a * a / 8.0, both = 8.0 * b * b * p8 / 225.0;
    const double all = first + second + both;
    const double exact[ESTIMATES] = {20.0 + a / 2.0, all,          first / all, (first + both) / all,
                                     second / all,   second / all, 0.0,         both / all};
    const double few = repeat(ishigami, 128, exact), many = repeat(ishigami, 512, exact);
    assert_true(many < few / 2.0);
}

/// Returns 1 if an estimate is as near to the exact value as its error says of 95 % of cases: 2.13 standard errors from
/// 16 replicates.
static size_t is_near(whirl_estimate found, double exact) {
    return fabs(found.value - exact) < 2.13 * found.error;
}

/// Probability of a limit and quantiles of the sum of a in [1, 3] and b in [0.5, 1.5], whose distribution is a
/// trapezium: P(a + b > 4) is 1/16, the median 3, and 5 % lie below 1.5 + sqrt(0.2).
static void test_probability(void **state) {
    (void)state;
    size_t inside = 0, near[3] = {0};
    double errors = 0.0;
    for (int seed = 1; seed <= SEEDS; seed++) {
        char text[SIZE];
        snprintf(text, sizeof text, amplitude, "2 +- 1", "1 +- 50 %", 512, seed, "4 m");
        whirl_result *result = run(text);
        const whirl_spread s = spread_of(result);
        inside += s.beyond.from < 0.0625 && 0.0625 < s.beyond.to;
        near[0] += is_near(s.beyond.of, 0.0625);
        near[1] += is_near(s.quantiles[2], 3.0);
        near[2] += is_near(s.quantiles[0], 1.5 + sqrt(0.2));
        errors += s.beyond.of.error / SEEDS;
        assert_true(s.least > 1.5 && s.most < 4.5 && s.samples == 512);
        whirl_result_free(result);
    }
    // Intervals of independent samples are wide for these, whose errors are smaller.
    assert_int_equal(inside, SEEDS);
    assert_true(errors < sqrt(0.0625 * 0.9375 / 512.0));
    // With a probability of 95 % for each, fewer than 6 of 8 cases are near once in 300 times.
    for (size_t i = 0; i < 3; i++)
        if (near[i] < 6) fail_msg("estimate %zu: near in %zu of %d cases", i, near[i], SEEDS);
}

/// Mean and variance of a normal distribution cut off on one side: with the inverse Mills ratio.
static void test_truncated_normal(void **state) {
    (void)state;
    const double pi = 3.14159265358979324, cut = -0.5, density = exp(-0.5 * cut * cut) / sqrt(2.0 * pi);
    const double above = 0.5 * erfc(cut / sqrt(2.0)), ratio = density / above;
    const double mean = 3.0 + 0.4 * ratio, variance = 0.16 * (1.0 + cut * ratio - ratio * ratio);
    size_t near[3] = {0};
    for (int seed = 1; seed <= SEEDS; seed++) {
        char text[SIZE];
        snprintf(text, sizeof text, amplitude, "{distribution: normal, mean: 2, deviation: 0.4, from: 1.8}",
                 "{from: 0.9999999, to: 1.0000001}", 1024, seed, "3 m");
        whirl_result *result = run(text);
        const whirl_spread s = spread_of(result);
        near[0] += is_near(s.mean, mean);
        near[1] += is_near(s.variance, variance);
        near[2] += is_near(s.beyond.of, 0.5 / above);
        assert_true(s.mean.error < 0.4 / sqrt(1024.0) / 4.0);
        whirl_result_free(result);
    }
    for (size_t i = 0; i < 3; i++)
        if (near[i] < 6) fail_msg("estimate %zu: near in %zu of %d cases", i, near[i], SEEDS);
}

/// Quantiles of distributions against erfc, also far out in a tail.
static void test_quantiles_of_distributions(void **state) {
    (void)state;
    static const double shares[] = {1e-9, 1e-4, 0.02, 0.3, 0.5, 0.7, 0.98, 0.9999};
    const whirl_tolerance whole = {.mean = 1.0, .deviation = 2.0, .low = -INFINITY, .high = INFINITY};
    const whirl_tolerance tail = {.mean = 0.0, .deviation = 1.0, .low = 6.0, .high = INFINITY};
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        const double x = whirl_tolerance_value(&whole, shares[i]), y = whirl_tolerance_value(&tail, shares[i]);
        assert_true(fabs(0.5 * erfc((1.0 - x) / 2.0 * sqrt(0.5)) / shares[i] - 1.0) < 1e-12);
        const double left = erfc(y * sqrt(0.5)) / erfc(6.0 * sqrt(0.5));
        assert_true(fabs(left - (1.0 - shares[i])) < 1e-10 && y >= 6.0);
    }
}

/// Every pair of dimensions of the sequence is a net up to the quality of its parameters: of 2^m points each half of
/// each coordinate has as many, and the first points are those of Joe and Kuo.
static void test_sequence(void **state) {
    (void)state;
    // Points 1 to 3 of the first four dimensions, from the published program.
    static const double points[3][4] = {{.5, .5, .5, .5}, {.25, .75, .75, .75}, {.75, .25, .25, .25}};
    enum { POINTS = 1024, CELLS = 1024 };
    for (size_t i = 0; i < 3; i++)
        for (size_t d = 0; d < 4; d++) assert_true(whirl_sobol(i + 1, d) / 4294967296.0 == points[i][d]);
    for (size_t d = 0; d < 2 * WHIRL_MAX_TOLERANCES; d++) {
        unsigned char seen[CELLS] = {0};
        for (size_t i = 0; i < POINTS; i++) seen[whirl_sobol(i, d) >> 22]++;
        for (size_t c = 0; c < CELLS; c++) assert_int_equal(seen[c], 1);
    }
}

/// Scrambled points keep the stratification, differ between seeds, and the samples of a shorter study come first.
static void test_samples(void **state) {
    (void)state;
    const whirl_tolerance unit[] = {{.low = 0.0, .high = 1.0}, {.low = 0.0, .high = 1.0}};
    const whirl_tolerance_options one = {.samples = 256, .parameters = 2, .seed = 1},
                                  other = {.samples = 1024, .parameters = 2, .seed = 1},
                                  again = {.samples = 256, .parameters = 2, .seed = 2};
    unsigned char seen[WHIRL_REPLICATES][16] = {{0}};
    size_t same = 0;
    for (size_t i = 0; i < 256; i++) {
        double a[2], b[2], c[2];
        whirl_tolerance_values(&one, unit, i, a);
        whirl_tolerance_values(&other, unit, i, b);
        whirl_tolerance_values(&again, unit, i, c);
        assert_memory_equal(a, b, sizeof a);
        same += a[0] == c[0];
        seen[i % WHIRL_REPLICATES][(size_t)(16.0 * a[0])]++;
    }
    assert_int_equal(same, 0);
    for (size_t r = 0; r < WHIRL_REPLICATES; r++)
        for (size_t k = 0; k < 16; k++) assert_int_equal(seen[r][k], 1);
}

/// Samples without a number are counted, and widen the interval: half of these machines rest nowhere.
static void test_failed(void **state) {
    (void)state;
    static const char text[] = "whirl: 1\n"
                               "parameters: {k: 2 N/m, e: 1 m}\n"
                               "rotor:\n"
                               "  speed: 1 rad/s\n"
                               "  length_scale: 1 m\n"
                               "  stations:\n"
                               "    disc: {mass: 1 kg, damping: 0.1 N.s/m, eccentricity: = e}\n"
                               "  elements:\n"
                               "    - shaft: {between: [disc, ground], k1: 2 N/m}\n"
                               "    - bearing: {at: disc, kxx: \"= k > 2 ? 0 : -2\"}\n"
                               "    - gravity: 1 m/s2\n"
                               "study:\n"
                               "  unbalance: {}\n"
                               "  tolerances:\n"
                               "    parameters: {k: 2 N/m +- 10 %}\n"
                               "    samples: 64\n"
                               "    of: [{field: unbalance/axes, column: major, at: disc, below: 1e9 m}]\n";
    whirl_result *result = run(text);
    const whirl_table *table = whirl_result_role(result, WHIRL_ROLE_TOLERANCES);
    whirl_spread_of of;
    whirl_spread s;
    assert_true(whirl_table_asked(result, table, 0, &of));
    require_ok(whirl_table_spread(result, table, &of, 0, 0, &s));
    assert_int_equal(s.samples, 64);
    assert_int_equal(s.failed, 32);
    assert_true(s.beyond.of.value == 0.0 && s.beyond.from == 0.0 && s.beyond.to > 0.5);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_amplitude_of_three),
        cmocka_unit_test(test_ishigami),
        cmocka_unit_test(test_probability),
        cmocka_unit_test(test_truncated_normal),
        cmocka_unit_test(test_quantiles_of_distributions),
        cmocka_unit_test(test_sequence),
        cmocka_unit_test(test_samples),
        cmocka_unit_test(test_failed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
