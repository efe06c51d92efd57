// Slow motions whose regime is known: a motion that settles on P-1 over tens of thousands of revolutions is recognised
// long before it returns, and motions that only resemble it are not judged P-1.
//
// All are driven by cos t. With the rate a per revolution (a/2 pi per unit of time, s below):
// - beats: x'' + 2 s x' + w^2 x = cos t, one oscillator or two, with irrational w: settles, by exp(-a) a revolution;
// - heat: T' = -s T + cos t, alone or behind a second body: settles;
// - a focus of Hopf's normal form, r' = -s r - b r^3, of either sign of b, r small against sqrt(s/|b|): settles;
// - the same beyond the point of Hopf, r' = s r - s r^3, from outside and inside the circle r = 1: quasi-periodic;
// - r' = s (1 - r) about a circle: quasi-periodic;
// - a place where two orbits have just vanished, x' = s (1/400 + x^2): it comes closer, passes, and is lost;
// - r' = +s r: leaves.
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

static const double two_pi = 6.28318530717958647693;

enum kind { BEATS, TWO_BEATS, HEAT, TWO_HEATS, FOCUS, HARD_FOCUS, OUTSIDE, INSIDE, CIRCLE, GHOST, LEAVES, KINDS };

static const struct {
    const char *name;
    size_t dimension;
    double start[4];
    bool settles;
} kinds[KINDS] = {
    [BEATS] = {"beats", 2, {1.0, 0.0}, true},
    [TWO_BEATS] = {"two beats", 4, {1.0, 0.0, 0.5, 0.0}, true},
    [HEAT] = {"heat", 1, {2.0}, true},
    [TWO_HEATS] = {"two bodies", 2, {2.0, 0.0}, true},
    [FOCUS] = {"focus", 2, {0.1, 0.0}, true},
    [HARD_FOCUS] = {"hard focus", 2, {0.1, 0.0}, true},
    [OUTSIDE] = {"outside", 2, {1.3, 0.0}, false},
    [INSIDE] = {"inside", 2, {0.6, 0.0}, false},
    [CIRCLE] = {"circle", 2, {1.5, 0.0}, false},
    [GHOST] = {"ghost", 1, {-1.0}, false},
    [LEAVES] = {"leaves", 2, {0.1, 0.0}, false},
};

/// Computes the slope of a rotation by 0.618... turns a revolution, with r' = slope r.
static void turn(const double *x, double slope, double t, double *dxdt) {
    const double w = 0.6180339887498949;
    dxdt[0] = slope * x[0] - w * x[1] + 0.02 * cos(t);
    dxdt[1] = slope * x[1] + w * x[0];
}

/// Computes the slopes of a motion; p: rate, kind.
static int slopes(double t, const double *x, const double *p, double *dxdt, void *context) {
    const double s = p[0] / two_pi, square = x[0] * x[0] + (kinds[(int)p[1]].dimension > 1 ? x[1] * x[1] : 0.0);
    (void)context;
    switch ((enum kind)p[1]) {
    case TWO_BEATS:
        dxdt[2] = x[3];
        dxdt[3] = cos(t) - 4.0 * s * x[3] - 5.0 * x[2];
        // falls through
    case BEATS:
        dxdt[0] = x[1];
        dxdt[1] = cos(t) - 2.0 * s * x[1] - 2.0 * x[0];
        return 0;
    case TWO_HEATS:
        dxdt[0] = -2.0 * s * (x[0] - x[1]) + cos(t);
        dxdt[1] = 3.0 * s * (x[0] - x[1]) - s * x[1];
        return 0;
    case HEAT:
        dxdt[0] = -s * x[0] + cos(t);
        return 0;
    case FOCUS:
    case HARD_FOCUS:
        turn(x, -s - ((enum kind)p[1] == FOCUS ? 1.0 : -1.0) * s * square, t, dxdt);
        return 0;
    case OUTSIDE:
    case INSIDE:
        turn(x, s - s * square, t, dxdt);
        return 0;
    case CIRCLE:
        turn(x, s * (1.0 / sqrt(square) - 1.0), t, dxdt);
        return 0;
    case GHOST:
        dxdt[0] = s * (0.0025 + x[0] * x[0]) + 0.001 * cos(t);
        return 0;
    case LEAVES:
        turn(x, s, t, dxdt);
        return 0;
    case KINDS:
        break;
    }
    return 1;
}

enum { RATES = 5 };

static const double rates[RATES] = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2};

static whirl_result *run(enum kind kind) {
    whirl_user_system *system;
    whirl_job *job;
    whirl_result *result;
    require_ok(whirl_user_system_new(kinds[kind].name, kinds[kind].dimension, &system));
    require_ok(whirl_user_system_parameter(system, "rate", rates[0], "1", ""));
    require_ok(whirl_user_system_parameter(system, "kind", kind, "1", ""));
    for (size_t i = 0; i < kinds[kind].dimension; i++)
        require_ok(whirl_user_system_start(system, i, kinds[kind].start[i]));
    require_ok(whirl_user_system_rates(system, slopes, NULL));
    require_ok(whirl_user_system_vary(system, "rate", rates, RATES));
    require_ok(whirl_user_system_set(system, "transient", "100"));
    require_ok(whirl_user_system_set(system, "record", "100"));
    require_ok(whirl_user_system_set(system, "method", "dop853"));
    require_ok(whirl_user_system_set(system, "rtol", "1e-10"));
    require_ok(whirl_user_system_set(system, "confirm", "yes"));
    require_ok(whirl_user_system_analyze(system, "regime"));
    require_ok(whirl_job_of_user_system(system, &job));
    require_ok(whirl_job_threads(job, 1));
    require_ok(whirl_job_run(job, &result));
    whirl_job_free(job);
    whirl_user_system_free(system);
    return result;
}

/// Checks the slowest multiplier of the linear kinds: exp(-rate), and for the two bodies, whose T' = s ((-2, 2), (3,
/// -4)) T, by the root sqrt 7 - 3.
static void near_rate(const whirl_verdict *v, enum kind kind, double rate) {
    const double share = kind == TWO_HEATS ? 3.0 - sqrt(7.0) : 1.0;
    if (kind > TWO_HEATS) return;
    if (!(fabs(v->settling.value + share * rate) <= 1e-6 * rate + 5e-9)) // of steps at the tolerance of 1e-10
        fail_msg("%s: %.12g, expected %.12g", kinds[kind].name, v->settling.value, -share * rate);
}

static void slow_motions(void **state) {
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        whirl_result *result = run((enum kind)kind);
        const whirl_table *table = whirl_result_table(result, "sweep");
        for (size_t i = 0; i < RATES; i++) {
            const whirl_verdict v = whirl_table_verdict(table, i);
            char name[WHIRL_NAME_SIZE], reason[512];
            whirl_verdict_name(&v, name, sizeof name);
            whirl_verdict_reason(&v, reason, sizeof reason);
            const bool settles = v.regime == WHIRL_PERIODIC && v.period == 1;
            if (settles != kinds[kind].settles) fail_msg("%s at %g: %s, %s", kinds[kind].name, rates[i], name, reason);
            // Nothing is wrong with high confidence.
            if (!settles) assert_true(v.confidence < WHIRL_HIGH || v.regime == WHIRL_QUASI_PERIODIC);
            if (!v.settles) continue;
            near_rate(&v, (enum kind)kind, rates[i]);
            assert_true(v.confidence <= WHIRL_FAIR);
            assert_non_null(strstr(reason, "settles on P-1: its distance from the orbit falls by"));
        }
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- two rates near each other

/// Computes the slopes of two bodies; p: two rates per revolution.
static int apart(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    for (size_t i = 0; i < 2; i++) dxdt[i] = cos(t) - p[i] / two_pi * x[i];
    return 0;
}

/// Returns the largest exponent of two uncoupled bodies, by a copy that is followed for some revolutions.
static whirl_estimate exponent_of(const double rate[2], const char *revolutions) {
    whirl_user_system *system;
    whirl_job *job;
    whirl_result *result;
    require_ok(whirl_user_system_new("two bodies apart", 2, &system));
    require_ok(whirl_user_system_parameter(system, "a", rate[0], "1", ""));
    require_ok(whirl_user_system_parameter(system, "b", rate[1], "1", ""));
    require_ok(whirl_user_system_rates(system, apart, NULL));
    require_ok(whirl_user_system_set(system, "transient", "0"));
    require_ok(whirl_user_system_set(system, "record", revolutions));
    require_ok(whirl_user_system_set(system, "settle", "no"));
    require_ok(whirl_user_system_set(system, "method", "cvode-adams"));
    require_ok(whirl_user_system_set(system, "rtol", "1e-10"));
    require_ok(whirl_user_system_analyze(system, "lyapunov"));
    require_ok(whirl_job_of_user_system(system, &job));
    require_ok(whirl_job_threads(job, 1));
    require_ok(whirl_job_run(job, &result));
    const whirl_table *table = whirl_result_table(result, "response");
    const whirl_estimate found = {whirl_table_number(table, 0, WHIRL_FIELD_LYAPUNOV_LARGEST, 0),
                                  whirl_table_number(table, 0, WHIRL_FIELD_LYAPUNOV_ERROR, 0)};
    whirl_result_free(result);
    whirl_job_free(job);
    whirl_user_system_free(system);
    return found;
}

/// Returns logarithm of the length of a perturbation that was (1, 1) n revolutions ago.
static double length_after(const double rate[2], double n) {
    return 0.5 * log(exp(-2.0 * rate[0] * n) + exp(-2.0 * rate[1] * n));
}

/// One perturbed copy does not separate rates that differ by less than 1 / revolutions: its exponent is then a mean of
/// both, weighted by the direction of the copy, and its scatter does not show that.
static void rates_near_each_other(void **state) {
    static const double near[] = {0.0168, 0.0189}, far[] = {0.0168, 0.1};
    (void)state;
    const whirl_estimate mixed = exponent_of(near, "60"), parted = exponent_of(far, "400");
    check_within("exponents", "two rates near each other, 54 revolutions: the mean by the copy's direction",
                 (length_after(near, 60) - length_after(near, 6)) / 54.0, mixed.value, 1e-7);
    check_holds("exponents", "its scatter is less than what it errs by, which is less than 1 / revolutions",
                mixed.error < fabs(mixed.value + near[0]) && fabs(mixed.value + near[0]) < 1.0 / 54.0);
    check_within("exponents", "two rates far from each other, 360 revolutions: the slower one", -far[0], parted.value,
                 1e-5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slow_motions),
        cmocka_unit_test(rates_near_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
