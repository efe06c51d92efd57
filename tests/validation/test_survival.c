// Lifetime of chaos: copies of motions whose mean life is known.
//
// The section of the flow follows a map (test_verdicts_maps.c): a parabola that overshoots the interval 0 .. 1 by p
// loses a motion after pi/(2 sqrt(p)) revolutions in the mean, by the density 1/(pi sqrt(x (1 - x))) of p = 0, with
// which nothing is ever lost; nor is it of Henon's map with a = 1.4.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine.h"

static const double pi = 3.14159265358979323846;

/// Computes the slopes of a flow whose section is a map: a parabola that exceeds the interval by p, or Henon's (p =
/// -1).
static int relay(double t, const double *x, const double *p, double *dxdt, void *context) {
    const double s = sin(t), to = s > 0.0 ? 25.0 * s * s : 0.0, back = s < 0.0 ? 25.0 * s * s : 0.0;
    const bool henon = p[0] < 0.0;
    const double square = 4.0 * (1.0 + fmax(p[0], 0.0)) * x[0] * (1.0 - x[0]), bend = 20.0;
    const double holed = square < 40.0 ? log1p(exp(bend * (square + 1.0))) / bend - 1.0 : square;
    const double next[2] = {henon ? 1.0 - 1.4 * x[0] * x[0] + x[1] : holed, henon ? 0.3 * x[0] : 0.0};
    (void)context;
    for (size_t i = 0; i < 2; i++) {
        dxdt[2 + i] = to * (next[i] - x[2 + i]);
        dxdt[i] = back * (x[2 + i] - x[i]);
    }
    return 0;
}

static void rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)forcing;
    (void)relay(t, x, model, dxdt, NULL);
}

static whirl_integrate_options steps(void) {
    whirl_integrate_options options = whirl_integrate_default(); // rk4
    options.steps_per_revolution = 64;
    return options;
}

/// Follows copies of a motion that was chaotic for 400 revolutions. Returns false if it was not.
static bool follow_copies(double p, double start, double exponent, whirl_survival *found) {
    const whirl_system system = {.dimension = 4, .period = 2.0 * pi, .rhs = rhs, .model = &p};
    const double x[] = {start, 0.0, 0.0, 0.0};
    const whirl_integrate_options integrate = steps();
    whirl_record_options options = whirl_record_default();
    whirl_record *record;
    options.transient = 200;
    options.record = options.watch = 200;
    options.growth = WHIRL_GROWTH_NONE;
    options.waveform_revolutions = 0;
    require_ok(whirl_record_motion(&system, &integrate, &options, x, NULL, &record));
    // Flat at -1, where lost motions are.
    bool chaotic = record->motion == WHIRL_BOUNDED && record->end[0] > -0.99 + (p < 0.0 ? -1.0 : 0.0);
    if (chaotic) require_ok(whirl_record_survival(&system, &integrate, record, exponent, found));
    whirl_record_free(record);
    return chaotic;
}

static void ends_are_counted(void **state) {
    const double holes[] = {1e-5, 3e-6, 1e-6, 1e-7};
    double ends = 0.0, expected = 0.0;
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        whirl_survival found;
        double start = 0.2;
        while (!follow_copies(holes[i], start, log(2.0), &found)) start += 0.01;
        assert_int_equal(found.copies, 32); // it goes alone
        const double life = 0.5 * pi / sqrt(holes[i]), lived = 3.0 * 12800.0 / found.copies,
                     mean = found.copies * -expm1(-lived / life);
        // Each copy ends once: binomial. The revolutions in which they part and those that are looked at add some.
        const double more = found.copies * -expm1(-(lived + 200.0) / life);
        assert_true(found.ended >= mean - 4.0 * sqrt(mean) && found.ended <= more + 4.0 * sqrt(more));
        assert_true(found.cost >= found.revolutions);
        // The mean life in a verdict, all revolutions over the ends, is the true one.
        assert_true(fabs(found.revolutions / found.ended / life - 1.0) <= 4.0 / sqrt(found.ended) + 400.0 / life);
        ends += found.ended;
        expected += mean;
    }
    assert_true(ends >= expected - 3.0 * sqrt(expected) && ends <= 2.0 * expected + 3.0 * sqrt(expected));
}

static void lasting_chaos_has_no_ends(void **state) {
    (void)state;
    for (int i = 0; i < 3; i++) {
        whirl_survival found;
        assert_true(follow_copies(i < 2 ? -1.0 : 0.0, 0.1 + 0.1 * i, i < 2 ? 0.42 : log(2.0), &found));
        assert_int_equal(found.ended, 0);
    }
}

/// Computes verdicts of systems with these values of p.
static whirl_result *run(const double *values, size_t count, int threads) {
    whirl_user_system *system;
    whirl_job *job;
    whirl_result *result;
    require_ok(whirl_user_system_new("relay", 4, &system));
    require_ok(whirl_user_system_parameter(system, "p", -1.0, "1", ""));
    for (size_t i = 0; i < 4; i++) require_ok(whirl_user_system_start(system, i, i % 2 ? 0.0 : 0.2));
    require_ok(whirl_user_system_rates(system, relay, NULL));
    require_ok(whirl_user_system_vary(system, "p", values, count));
    require_ok(whirl_user_system_set(system, "method", "rk4"));
    require_ok(whirl_user_system_set(system, "steps_per_revolution", "64"));
    require_ok(whirl_user_system_set(system, "transient", "300"));
    require_ok(whirl_user_system_set(system, "record", "250"));
    require_ok(whirl_user_system_set(system, "watch", "550"));
    require_ok(whirl_user_system_set(system, "confirm", "yes"));
    require_ok(whirl_user_system_analyze(system, "regime"));
    require_ok(whirl_job_of_user_system(system, &job));
    require_ok(whirl_job_threads(job, threads));
    require_ok(whirl_job_run(job, &result));
    whirl_job_free(job);
    whirl_user_system_free(system);
    return result;
}

/// Henon's map is proven chaotic; the confidence is high, and the reason names the mean life that was proven.
static void verdict_says_how_long(void **state) {
    (void)state;
    const double values[] = {-1.0, -2.0};
    whirl_result *result = run(values, 2, 1), *same = run(values, 2, 3);
    const whirl_table *table = whirl_result_table(result, "sweep"), *other = whirl_result_table(same, "sweep");
    const whirl_verdict v = whirl_table_verdict(table, 0);
    char reason[512], words[64];
    whirl_verdict_reason(&v, reason, sizeof reason);
    assert_int_equal(v.regime, WHIRL_CHAOTIC);
    assert_int_equal(v.confidence, WHIRL_HIGH);
    assert_true(v.survived >= 38400.0);
    snprintf(words, sizeof words, "chaotic for at least %.0f revolutions",
             (v.revolutions + v.followed + v.survived) / 3.0);
    assert_non_null(strstr(reason, words));
    assert_memory_equal(table->blocks, other->blocks, table->count * table->layout.size * sizeof *table->blocks);
    whirl_result_free(result);
    whirl_result_free(same);
}

/// Chaos with a mean life of 6,400 revolutions, half of what high confidence excludes, is not high. By two tolerances
/// alone most of the points that are still chaotic after 550 revolutions would be.
static void shorter_lives_are_not_high(void **state) {
    enum { SYSTEMS = 8 };
    double values[SYSTEMS];
    size_t clear = 0;
    (void)state;
    for (size_t i = 0; i < SYSTEMS; i++) values[i] = (0.9 + 0.014 * (double)i) * 0.25 * pi * pi / (6400.0 * 6400.0);
    whirl_result *result = run(values, SYSTEMS, 1);
    for (size_t i = 0; i < SYSTEMS; i++) {
        const whirl_verdict v = whirl_table_verdict(whirl_result_table(result, "sweep"), i);
        clear += v.regime == WHIRL_CHAOTIC && v.agreement == WHIRL_HIGH;
        assert_false(v.regime == WHIRL_CHAOTIC && v.confidence == WHIRL_HIGH);
    }
    assert_true(clear >= 2);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_counted),
        cmocka_unit_test(lasting_chaos_has_no_ends),
        cmocka_unit_test(verdict_says_how_long),
        cmocka_unit_test(shorter_lives_are_not_high),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
