// Verdicts on maps whose regime is proved: superstable cycles and Misiurewicz points of the logistic map, the Lozi map,
// hyperbolic maps of the torus, rotations.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "synthetic.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

/// Returns the verdict on 650 iterates. It must be the expected one, or for a trap at least not a wrong one.
static whirl_verdict judge(const map_system *system, size_t transient) {
    whirl_record *record = record_map(system, transient, 650, 100);
    record->revolutions = (double)(transient + 650);
    const whirl_verdict verdict = whirl_judge(record);
    free(record);
    return verdict;
}

static void assert_verdict(const map_system *system, size_t transient, const char *expected, const char *label) {
    const whirl_verdict verdict = judge(system, transient);
    char name[64], reason[400];
    whirl_verdict_name(&verdict, name, sizeof name);
    whirl_verdict_reason(&verdict, reason, sizeof reason);
    if (strcmp(name, expected) != 0) fail_msg("%s: %s, expected %s; %s", label, name, expected, reason);
}

static map_system logistic(double r) {
    return (map_system){
        .map = logistic_map, .dimension = 1, .section_dimension = 1, .parameters = {r}, .start = {0.3123}};
}

/// Makes the system of a rotation by `turn` turns, whose section is a circle.
static map_system rotation(double turn) {
    return (map_system){.map = circle_map,
                        .embed = on_circle,
                        .dimension = 1,
                        .section_dimension = 2,
                        .parameters = {turn, 0.0},
                        .start = {0.1}};
}

static double iterate(double r, double x, int count) {
    for (int i = 0; i < count; i++) x = r * x * (1.0 - x);
    return x;
}

/// Returns the zero of f^count(1/2) - target(r) in (low, high), where it changes sign.
static double bisect(double low, double high, int count, double (*target)(double r)) {
    const double sign = iterate(low, 0.5, count) - target(low);
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (low + high);
        *((iterate(middle, 0.5, count) - target(middle)) * sign > 0.0 ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static double critical_point(double r) {
    (void)r;
    return 0.5;
}

static double fixed_point(double r) {
    return 1.0 - 1.0 / r;
}

/// Calls `visit` for all r in 3 < r < 4 at which f^count(1/2) meets the target; returns how many there were.
static int for_all_roots(int count, double (*target)(double r), bool (*visit)(double r, int count)) {
    const int grid = 200000;
    int found = 0;
    for (int i = 0; i < grid; i++) {
        const double low = 3.0 + (i + 0.5) / grid, high = low + 1.0 / grid;
        if (high >= 4.0) break;
        const double a = iterate(low, 0.5, count) - target(low), b = iterate(high, 0.5, count) - target(high);
        if ((a > 0.0) != (b > 0.0)) found += visit(bisect(low, high, count, target), count);
    }
    return found;
}

static bool is_superstable(double r, int period) {
    for (int k = 1; k < period; k++)
        if (period % k == 0 && fabs(iterate(r, 0.5, k) - 0.5) < 1e-8) return false;
    map_system system = logistic(r);
    char expected[16], label[64];
    system.start[0] = 0.5 + 1e-6; // some windows are so narrow that other starts take long
    snprintf(expected, sizeof expected, "P-%d", period);
    snprintf(label, sizeof label, "superstable at r = %.10f", r);
    assert_verdict(&system, 5000, expected, label);
    return true;
}

/// A cycle through 1/2 attracts. There are 1, 1, 2, 3, 5, 9 and 16 of the periods 2 to 8 (Metropolis, Stein, Stein
/// 1973).
static void superstable_cycles(void **state) {
    (void)state;
    const int known[] = {1, 1, 2, 3, 5, 9, 16};
    for (int period = 2; period <= 8; period++)
        assert_int_equal(for_all_roots(period, critical_point, is_superstable), known[period - 2]);
}

/// The superstable cycles of the cascade are recognized up to the longest period, and the one beyond it is not. Long
/// periods are not recognized if less than three periods are watched; the reason says so.
static void long_periods(void **state) {
    (void)state;
    const double near[] = {3.5546408628, 3.5666673799, 3.5692435316, 3.5697952937, 3.5699134654};
    const char *names[] = {"P-8", "P-16", "P-32", "P-64", "P-128"};
    for (int i = 0; i < 5; i++) {
        const double r = bisect(near[i] - 1e-7 / (1 << i), near[i] + 1e-7 / (1 << i), 8 << i, critical_point);
        const map_system system = logistic(r);
        assert_verdict(&system, 50000, names[i], names[i]);
    }
    const map_system beyond = logistic(3.5699387742);
    assert_true(fabs(iterate(3.5699387742, 0.3123, 200256) - iterate(3.5699387742, 0.3123, 200000)) < 1e-12);
    assert_true(fabs(iterate(3.5699387742, 0.3123, 200128) - iterate(3.5699387742, 0.3123, 200000)) > 1e-7);
    assert_verdict(&beyond, 100000, "undetermined", "P-256");
    const map_system unseen = logistic(3.5699134654);
    const int watched[] = {300, 383, 384}, looked_for[] = {100, 127, 128};
    for (int i = 0; i < 3; i++) {
        whirl_record *record = record_map(&unseen, 50000, watched[i], 100);
        const whirl_verdict verdict = whirl_judge(record);
        char reason[400], reported[64];
        free(record);
        assert_int_equal(verdict.longest_period, looked_for[i]);
        assert_int_equal(verdict.regime, i == 2 ? WHIRL_PERIODIC : WHIRL_UNDETERMINED);
        whirl_verdict_reason(&verdict, reason, sizeof reason);
        snprintf(reported, sizeof reported, "does not return within %d revolutions (longer periods need",
                 looked_for[i]);
        if (i < 2 && !strstr(reason, reported)) fail_msg("%s: no '%s'", reason, reported);
    }
}

/// Computes x' = x/2 towards the next point of a fixed list of 96: the motion repeats after 96 points by construction.
static void listed_map(const double *p, size_t step, double *z, double *v) {
    const double target = fmod(p[1] * (double)(step % (size_t)p[0]) * (double)(step % (size_t)p[0]), 1.0);
    v[0] *= 0.5;
    z[0] = target + 0.5 * (z[0] - target);
}

/// Every period from 65 to 128 is recognized, with points in random order.
static void listed_periods(void **state) {
    (void)state;
    for (int k = 65; k <= 130; k++) {
        const map_system system = {.map = listed_map,
                                   .dimension = 1,
                                   .section_dimension = 1,
                                   .parameters = {k, 0.6180339887498949},
                                   .start = {0.3}};
        char expected[16];
        snprintf(expected, sizeof expected, "P-%d", k);
        assert_verdict(&system, 1000, k <= WHIRL_MAX_PERIOD ? expected : "undetermined", expected);
    }
}

/// Alternates between two points; a third coordinate shrinks by p[0] a step, or passes a bottleneck where p[1] + y^2
/// nearly vanishes.
static void approaching_map(const double *p, size_t step, double *z, double *v) {
    const double slope = p[0] + 2.0 * z[1];
    z[1] = p[2] > 0.0 ? z[1] + p[1] + z[1] * z[1] : p[0] * z[1];
    v[1] *= p[2] > 0.0 ? slope : p[0];
    v[0] = 0.0;
    z[0] = (step % 2 ? 0.2 : 0.7) + p[3] * z[1];
}

/// A motion that approaches P-2 at a steady rate is judged as P-2 before it arrives, with fair confidence at most. A
/// motion that slows down in the bottleneck that two orbits have left is not.
static void convergence_is_foreseen(void **state) {
    const map_system even = {.map = approaching_map,
                             .dimension = 2,
                             .section_dimension = 1,
                             .parameters = {0.98, 0.0, 0.0, 1.0},
                             .start = {0.7, 0.3}};
    const map_system passing = {.map = approaching_map,
                                .dimension = 2,
                                .section_dimension = 1,
                                .parameters = {1.0, 1e-7, 1.0, 0.004},
                                .start = {0.7, -0.3}};
    (void)state;
    const whirl_verdict verdict = judge(&even, 0);
    assert_true(verdict.recurrence > 1e-6);
    assert_verdict(&even, 0, "P-2", "an even approach");
    assert_int_equal(verdict.agreement, WHIRL_FAIR);
    whirl_record *record = record_map(&passing, 0, 230, 100);
    const whirl_verdict other = whirl_judge(record);
    free(record);
    assert_true(other.recurrence > 1e-6 && other.recurrence < 1e-4 && other.exponent.value < 0.0);
    assert_int_equal(other.regime, WHIRL_UNDETERMINED);
}

static bool is_misiurewicz(double r, int count) {
    // 1/2 must land on the fixed point from elsewhere, which is so when f^(count - 1) lands on its other preimage.
    if (fabs(iterate(r, 0.5, count - 1) - fixed_point(r)) < 1e-8) return false;
    const map_system system = logistic(r);
    char label[64];
    snprintf(label, sizeof label, "Misiurewicz point r = %.10f", r);
    assert_verdict(&system, 2000, "chaotic", label);
    return true;
}

/// If 1/2 is mapped onto the unstable fixed point, almost all motions are chaotic (Misiurewicz 1981).
static void misiurewicz_points(void **state) {
    (void)state;
    int found = 0;
    for (int count = 3; count <= 9; count++) found += for_all_roots(count, fixed_point, is_misiurewicz);
    assert_true(found >= 25);
    const map_system full = logistic(4.0);
    assert_verdict(&full, 2000, "chaotic", "r = 4");
}

/// x' = 1 + y - a |x|, y' = b x: chaotic for all b in (0, 1) and a between max(1 + b, (3b + 1)/sqrt 2 ...) and 2 - b/2,
/// of which these lie well inside (Misiurewicz 1980).
static void lozi_map(const double *p, size_t step, double *z, double *v) {
    const double x = z[0], vx = v[0];
    (void)step;
    v[0] = v[1] - p[0] * (x < 0.0 ? -vx : vx);
    v[1] = p[1] * vx;
    z[0] = 1.0 + z[1] - p[0] * fabs(x);
    z[1] = p[1] * x;
}

static void lozi(void **state) {
    (void)state;
    const double rows[][2] = {{1.7, 0.5}, {1.7, 0.3}, {1.75, 0.4}, {1.65, 0.2}, {1.8, 0.1}, {1.6, 0.3}};
    for (size_t i = 0; i < COUNT_OF(rows); i++) {
        const map_system system = {.map = lozi_map,
                                   .dimension = 2,
                                   .section_dimension = 2,
                                   .parameters = {rows[i][0], rows[i][1]},
                                   .start = {0.1, 0.1}};
        assert_verdict(&system, 2000, "chaotic", "Lozi");
    }
}

/// x' = (p + 1) x + y, y' = p x + y modulo 1: hyperbolic, determinant 1.
static void cat_map(const double *p, size_t step, double *z, double *v) {
    double *const pairs[2] = {z, v};
    (void)step;
    for (int i = 0; i < 2; i++) {
        const double x = pairs[i][0], y = pairs[i][1];
        pairs[i][0] = (p[0] + 1.0) * x + y;
        pairs[i][1] = p[0] * x + y;
    }
    z[0] -= floor(z[0]);
    z[1] -= floor(z[1]);
}

static void on_torus(const double *z, double *point) {
    for (int i = 0; i < 2; i++) {
        point[2 * i] = cos(6.283185307179586 * z[i]);
        point[2 * i + 1] = sin(6.283185307179586 * z[i]);
    }
}

static void cats(void **state) {
    (void)state;
    for (int p = 1; p <= 4; p++) {
        const map_system system = {.map = cat_map,
                                   .embed = on_torus,
                                   .dimension = 2,
                                   .section_dimension = 4,
                                   .parameters = {p},
                                   .start = {0.31234567, 0.71236541}};
        assert_verdict(&system, 100, "chaotic", "map of the torus");
    }
}

/// A rational rotation returns but does not attract: it is not judged periodic. Neither is a slow drift.
static void neutral_returns(void **state) {
    (void)state;
    const double turns[] = {0.5, 1.0 / 3.0, 0.4, 0.4 + 1e-9, 0.25 + 1e-7, 0.4 + 1e-5};
    for (size_t i = 0; i < COUNT_OF(turns); i++) {
        const map_system system = rotation(turns[i]);
        assert_verdict(&system, 100, "undetermined", "rational rotation");
    }
}

/// The golden mean and other rotations far from rational ones are quasi-periodic, with high confidence.
static void rotations(void **state) {
    (void)state;
    const double turns[] = {0.38196601125, 0.41421356237, 0.27201964951, 0.2360679775,  0.44948974278,
                            0.30277563773, 0.16227766017, 0.26794919243, 0.35889894354, 0.47213595500};
    for (size_t i = 0; i < COUNT_OF(turns); i++) {
        const map_system system = rotation(turns[i]);
        assert_verdict(&system, 100, "quasi-periodic (1 curve)", "rotation");
        const whirl_verdict verdict = judge(&system, 100);
        assert_int_equal(verdict.agreement, WHIRL_HIGH);
        assert_int_equal(verdict.confidence, WHIRL_FAIR);
        assert_true(fabs(verdict.rotation - turns[i]) < 1e-9);
    }
    // sqrt 17 - 4 = [0; 8, 8, 8, ...] lies so close to 8/65 that its neighbours are 65 iterates apart. It goes by 1.2
    // places between them in 650, evenly: it is not locked.
    const map_system close = rotation(0.12310562562);
    const whirl_verdict loose = judge(&close, 100);
    char reason[400];
    assert_int_equal(loose.neighbours, 65);
    assert_int_equal(loose.unlocked, 650 / 3);
    assert_int_equal(loose.agreement, WHIRL_HIGH);
    whirl_verdict_reason(&loose, reason, sizeof reason);
    assert_non_null(strstr(reason, "locks up to P-216 are excluded, longer ones are not"));
}

/// Slow rotations do not fill their curve in the revolutions watched. The length of a round, 1/|k turns - p| iterates,
/// is reported to a third; with the advised `watch` the curve is recognized.
static void drifts(void **state) {
    const double turns[] = {0.4992615, 0.5003, 0.0009, 1.0 / 3.0 + 3e-4, 0.25 - 1.6e-4, 0.0011};
    const int branches[] = {2, 2, 1, 3, 4, 1};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(turns); i++) {
        const map_system system = rotation(turns[i]);
        const double phase = turns[i] * branches[i], round_trip = 1.0 / fabs(phase - round(phase));
        whirl_record *record = record_map(&system, 100, 650, 650);
        const whirl_verdict verdict = whirl_judge(record);
        char reason[400];
        free(record);
        assert_int_equal(verdict.regime, WHIRL_UNDETERMINED);
        assert_int_equal(verdict.recurrence_period, branches[i]);
        assert_true(fabs(verdict.round / round_trip - 1.0) < 1.0 / 3.0);
        assert_int_equal(verdict.advice.remedy, WHIRL_LONGER_WATCH);
        whirl_verdict_reason(&verdict, reason, sizeof reason);
        assert_non_null(strstr(reason, "drifts evenly"));
        whirl_verdict later = verdict;
        size_t watch = 650;
        for (int times = 0; times < 2 && later.curves == 0; times++) {
            watch = (size_t)((double)watch * later.advice.factor);
            whirl_record *longer = record_map(&system, 100, watch, 650);
            later = whirl_judge(longer);
            free(longer);
        }
        if (later.curves != 1) fail_msg("%g: no curve in %zu; %s", turns[i], watch, reason);
    }
}

/// Computes two rotations; the second has its own size.
static void two_rotations_map(const double *p, size_t step, double *z, double *v) {
    (void)step, (void)v;
    for (int i = 0; i < 2; i++) z[i] = fmod(z[i] + p[i], 1.0);
}

static void embed_two(const double *z, double size, double *point) {
    on_torus(z, point);
    point[2] *= size;
    point[3] *= size;
}

static void on_wide_torus(const double *z, double *point) {
    embed_two(z, 0.5, point);
}

static void on_thin_torus(const double *z, double *point) {
    embed_two(z, 2e-3, point);
}

/// Judges the record with the growth of all perturbations. The first two neither grow nor decay. The others decay, and
/// so does the second at the rate `second` if that is below 0.
static whirl_verdict judge_with_exponents(whirl_record *record, double second) {
    const size_t d = record->dimension, count = record->growth_count;
    double *growths = malloc(count * (d + 1) * sizeof *growths);
    assert_non_null(growths);
    for (size_t n = 0; n < count; n++) {
        growths[n * d] = record->growth[n];
        for (size_t i = 1; i < d; i++) growths[n * d + i] = i == 1 ? second : -0.5;
        growths[count * d + n] = growths[n * d] + second - 0.5 * (double)(d - 2);
    }
    record->growths = growths;
    record->volume = growths + count * d;
    const whirl_verdict verdict = whirl_judge(record);
    free(growths);
    return verdict;
}

/// The section of a torus of three frequencies is a surface. It may look like a curve, but is not judged as one; the
/// exponents identify it.
static void surfaces(void **state) {
    void (*const embeddings[])(const double *, double *) = {on_wide_torus, on_thin_torus};
    const double turns[][2] = {
        {0.38196601125, 0.41421356237}, {0.2360679775, 0.7320508}, {0.1622776, 0.3819660}, {0.27201964951, 0.0917}};
    int reported = 0;
    (void)state;
    for (size_t i = 0; i < 8; i++) {
        const map_system system = {.map = two_rotations_map,
                                   .embed = embeddings[i / 4],
                                   .dimension = 2,
                                   .section_dimension = 4,
                                   .parameters = {turns[i % 4][0], turns[i % 4][1]},
                                   .start = {0.1, 0.2}};
        char name[64];
        const whirl_verdict alone = judge(&system, 100);
        assert_true(alone.agreement < WHIRL_HIGH);
        assert_int_equal(alone.curves, 0);
        whirl_record *record = record_map(&system, 100, 2000, 100);
        const whirl_verdict verdict = judge_with_exponents(record, 0.0);
        free(record);
        assert_int_equal(verdict.curves, 0);
        assert_true(verdict.agreement < WHIRL_HIGH);
        if (verdict.regime != WHIRL_QUASI_PERIODIC) continue;
        whirl_verdict_name(&verdict, name, sizeof name);
        assert_string_equal(name, "quasi-periodic (3 frequencies)");
        reported++;
    }
    assert_true(reported >= 7);
}

/// For a curve exponents give the same verdict as its points. With a second exponent below zero, curves that are not
/// smooth are accepted, too.
static void curves_with_exponents(void **state) {
    const double seconds[] = {0.0, -0.01, -1.0};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(seconds); i++) {
        const map_system system = rotation(0.38196601125);
        whirl_record *record = record_map(&system, 100, 650, 100);
        const whirl_verdict verdict = judge_with_exponents(record, seconds[i]);
        free(record);
        assert_int_equal(verdict.curves, 1);
        assert_int_equal(verdict.frequencies, 2);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(superstable_cycles),
        cmocka_unit_test(long_periods),
        cmocka_unit_test(listed_periods),
        cmocka_unit_test(convergence_is_foreseen),
        cmocka_unit_test(misiurewicz_points),
        cmocka_unit_test(lozi),
        cmocka_unit_test(cats),
        cmocka_unit_test(neutral_returns),
        cmocka_unit_test(rotations),
        cmocka_unit_test(drifts),
        cmocka_unit_test(surfaces),
        cmocka_unit_test(curves_with_exponents),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
