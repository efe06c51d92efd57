// Orbits of settled motions: multipliers against closed forms, and motions that seem to be near a stable orbit and are
// not: past a fold, near a saddle, outside an unstable torus.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/analyze.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- systems

/// x'' + 2 zeta w x' + w^2 x = cos t.
typedef struct oscillator {
    double w, zeta;
} oscillator;

static void oscillate(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const oscillator *o = model;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = cos(t) - 2 * o->zeta * o->w * x[1] - o->w * o->w * x[0];
}

static void oscillate_near(const void *model, double t, const double *forcing, const double *x, const double *sides,
                           size_t count, const double *dx, double *ddxdt) {
    const oscillator *o = model;
    (void)t, (void)forcing, (void)x, (void)sides;
    for (size_t k = 0; k < count; k++) {
        ddxdt[2 * k] = dx[2 * k + 1];
        ddxdt[2 * k + 1] = -2 * o->zeta * o->w * dx[2 * k + 1] - o->w * o->w * dx[2 * k];
    }
}

static double oscillate_shrinks(const void *model, double t, const double *forcing, const double *x,
                                const double *sides) {
    const oscillator *o = model;
    (void)t, (void)forcing, (void)x, (void)sides;
    return -2 * o->zeta * o->w;
}

/// Duffing's oscillator with two wells: x'' + 0.3 x' - x + x^3 = a cos 1.2 t, in tau = 1.2 t.
static const double duffing_rate = 1.2, duffing_damping = 0.3;

static void duffing(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)forcing;
    dxdt[0] = x[1] / duffing_rate;
    dxdt[1] = (x[0] - x[0] * x[0] * x[0] - duffing_damping * x[1] + *(const double *)model * cos(t)) / duffing_rate;
}

static void duffing_near(const void *model, double t, const double *forcing, const double *x, const double *sides,
                         size_t count, const double *dx, double *ddxdt) {
    (void)model, (void)t, (void)forcing, (void)sides;
    for (size_t k = 0; k < count; k++) {
        ddxdt[2 * k] = dx[2 * k + 1] / duffing_rate;
        ddxdt[2 * k + 1] = ((1 - 3 * x[0] * x[0]) * dx[2 * k] - duffing_damping * dx[2 * k + 1]) / duffing_rate;
    }
}

/// Two uncoupled equations: x0' = -0.5 x0 + cos t, which gives the motion a size, and x1' = f(x1).
typedef struct forced_pair {
    double (*f)(double), (*slope)(double);
} forced_pair;

static void pair_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const forced_pair *b = model;
    (void)forcing;
    dxdt[0] = -0.5 * x[0] + cos(t);
    dxdt[1] = b->f(x[1]);
}

static void pair_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                         size_t count, const double *dx, double *ddxdt) {
    const forced_pair *b = model;
    (void)t, (void)forcing, (void)sides;
    for (size_t k = 0; k < count; k++) {
        ddxdt[2 * k] = -0.5 * dx[2 * k];
        ddxdt[2 * k + 1] = b->slope(x[1]) * dx[2 * k + 1];
    }
}

/// Returns x': a bottleneck at 0, 1e-4 beyond the fold of two equilibria, and an equilibrium at 1.
static double past_fold(double x) {
    return (1e-4 + x * x) * (1 - x);
}
static double past_fold_slope(double x) {
    return 2 * x * (1 - x) - (1e-4 + x * x);
}

/// Returns x': a saddle at 0 that motions leave slowly, and an equilibrium at 1.
static double slow_saddle(double x) {
    return 0.01 * x * (1 - x * x);
}
static double slow_saddle_slope(double x) {
    return 0.01 * (1 - 3 * x * x);
}

/// x1, x2: a focus whose multipliers have the modulus 1 - 1e-4, inside an unstable torus of radius r0; a stable one of
/// radius 0.2 lies outside. r' = r (r^2 - r0^2) (0.04 - r^2) / 0.04.
static const double torus = 3.989422804014327e-3; // r0^2 = 1e-4/(2 pi)

static double torus_rate(double square) {
    return (square - torus * torus) * (0.04 - square) / 0.04;
}

static void weak_focus(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double rate = torus_rate(x[1] * x[1] + x[2] * x[2]), turn = 0.31;
    (void)model, (void)forcing;
    dxdt[0] = -0.5 * x[0] + cos(t);
    dxdt[1] = rate * x[1] - turn * x[2];
    dxdt[2] = rate * x[2] + turn * x[1];
}

static void near_weak_focus(const void *model, double t, const double *forcing, const double *x, const double *sides,
                            size_t count, const double *dx, double *ddxdt) {
    const double square = x[1] * x[1] + x[2] * x[2], rate = torus_rate(square), turn = 0.31;
    const double slope = (0.04 - square - (square - torus * torus)) / 0.04;
    (void)model, (void)t, (void)forcing, (void)sides;
    for (size_t k = 0; k < count; k++, dx += 3, ddxdt += 3) {
        const double along = 2 * slope * (x[1] * dx[1] + x[2] * dx[2]);
        ddxdt[0] = -0.5 * dx[0];
        ddxdt[1] = rate * dx[1] - turn * dx[2] + along * x[1];
        ddxdt[2] = rate * dx[2] + turn * dx[1] + along * x[2];
    }
}

// ---------------------------------------------------------------- recording

static whirl_record *record(const whirl_system *system, const char *method, bool orbits, bool settle, int transient,
                            const double *start) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *made;
    strcpy(integrate.method, method);
    integrate.steps_per_revolution = 256;
    options.waveform = true;
    options.orbits = orbits;
    options.settle = settle;
    options.transient = transient;
    const whirl_status status = whirl_record_motion(system, &integrate, &options, start, NULL, &made);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    return made;
}

static const whirl_probe probe = {.name = "mass", .x = 0, .y = 0, .vx = 1, .vy = 1};

/// Makes a system of two coordinates without its equations.
static whirl_system plane_system(const void *model) {
    return (whirl_system){.dimension = 2, .period = 2 * pi, .probe_count = 1, .probes = &probe, .model = model};
}

static whirl_system oscillator_system(const oscillator *model) {
    whirl_system system = plane_system(model);
    system.rhs = oscillate;
    system.tangent = oscillate_near;
    system.divergence = oscillate_shrinks;
    return system;
}

static whirl_system duffing_system(const double *force) {
    whirl_system system = plane_system(force);
    system.rhs = duffing;
    system.tangent = duffing_near;
    return system;
}

static whirl_system pair_system(const forced_pair *law) {
    whirl_system system = plane_system(law);
    system.rhs = pair_rhs;
    system.tangent = pair_tangent;
    return system;
}

// ---------------------------------------------------------------- tests

/// The multipliers are exp(2 pi (-zeta w +- i w sqrt(1 - zeta^2))), also if the motion was moved to its orbit before it
/// settled.
static void multipliers_of_a_linear_oscillator(void **state) {
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    const oscillator model = {.w = 1.7, .zeta = 0.02};
    const whirl_system system = oscillator_system(&model);
    const double decay = model.zeta * model.w * 2 * pi, turn = 2 * pi * model.w * sqrt(1 - model.zeta * model.zeta);
    // rk4 turns too far by (w h)^4/120 of the angle.
    const double turned = 2 * pi * model.w * pow(model.w * 2 * pi / 256, 4) / 120;
    const double start[2] = {3, 0}, tolerances[] = {1.1 * turned, 1e-10, 1e-8};
    (void)state;
    for (size_t i = 0; i < 6; i++) {
        whirl_record *r = record(&system, methods[i / 2], true, i % 2, 1100, start);
        const double *m = r->orbit.multipliers, tolerance = tolerances[i / 2];
        assert_int_equal(r->orbit.search, WHIRL_ORBIT_STABLE);
        assert_int_equal(r->orbit.period, 1);
        assert_int_equal(r->orbit.multiplier_count, 2);
        assert_true(fabs(r->orbit.modulus - exp(-decay)) < tolerance);
        assert_true(fabs(m[0] - exp(-decay) * cos(turn)) < tolerance);
        assert_true(fabs(fabs(m[1]) - exp(-decay) * fabs(sin(turn))) < tolerance && m[1] == -m[3]);
        assert_true(fabs(r->orbit.volume + 2 * decay) < 1e-9);
        const whirl_verdict verdict = whirl_judge(r);
        assert_int_equal(verdict.regime, WHIRL_PERIODIC);
        assert_int_equal(verdict.period, 1);
        assert_int_equal(verdict.agreement, WHIRL_HIGH);
        assert_true(fabs(verdict.exponent.value + decay) < 1e-6);
        // Amplitude and bounds of cos t/(w^2 - 1) with little damping, in closed form; the record is full.
        const double amplitude = 1 / hypot(model.w * model.w - 1, 2 * model.zeta * model.w);
        assert_true(fabs(r->high[0] - amplitude) < 1e-3 * amplitude && fabs(r->low[0] + amplitude) < 1e-3 * amplitude);
        assert_true(fabs(r->max_radius[0] - r->high[0]) < 1e-3);
        assert_true(fabs(r->mean[0]) < 1e-6);
        assert_int_equal(r->section_count, 650);
        assert_int_equal(r->sample_count, 100 * r->samples_per_revolution);
        for (size_t n = 0; n < r->sample_count; n += 997) {
            const double t = 2 * pi * (double)(n + 1) / (double)r->samples_per_revolution;
            const double lag = atan2(2 * model.zeta * model.w, model.w * model.w - 1);
            assert_true(fabs(r->waveform[n] - amplitude * cos(t - lag)) < 1e-6);
        }
        assert_true(i % 2 ? r->orbit.set_at > 0 && r->revolutions < 120 : r->revolutions == 1200);
        whirl_record_free(r);
    }
}

/// From periodic motions through doublings to chaos and back: the verdicts of motions that end early are those of
/// motions that run all their way; the product of the multipliers of P-k is e^(-2 pi k damping/rate).
static void early_ends_change_no_verdict(void **state) {
    enum { POINTS = 40 };
    const double start[2] = {1, 0};
    size_t ended = 0, doubled = 0;
    (void)state;
    for (size_t i = 0; i < POINTS; i++) {
        const double force = 0.2 + 0.45 * (double)i / POINTS;
        const whirl_system system = duffing_system(&force);
        whirl_record *whole = record(&system, "rk4", false, false, 1100, start);
        whirl_record *early = record(&system, "rk4", true, true, 1100, start);
        const whirl_verdict expected = whirl_judge(whole), verdict = whirl_judge(early);
        assert_int_equal(verdict.regime, expected.regime);
        assert_int_equal(verdict.period, expected.period);
        if (expected.regime == WHIRL_PERIODIC && early->orbit.multiplier_count > 0) {
            const double *m = early->orbit.multipliers;
            const double product = m[0] * m[2] - m[1] * m[3], k = early->orbit.period;
            assert_int_equal(early->orbit.period, expected.period);
            assert_true(fabs(product * exp(2 * pi * k * duffing_damping / duffing_rate) - 1) < 1e-6);
            assert_true(fabs(log(early->orbit.modulus) / k - expected.exponent.value) < 2e-3);
        }
        ended += early->orbit.set_at > 0;
        doubled += expected.period > 1;
        whirl_record_free(whole);
        whirl_record_free(early);
    }
    assert_true(ended > POINTS / 3 && doubled > 2);
}

/// A motion that a bottleneck or a saddle slows down does not end early; it comes to rest at 1.
static void slow_passages_do_not_end_early(void **state) {
    static const struct {
        forced_pair law;
        double start;
    } traps[] = {{{past_fold, past_fold_slope}, -0.5},
                 {{past_fold, past_fold_slope}, -0.02},
                 {{slow_saddle, slow_saddle_slope}, 1e-3},
                 {{slow_saddle, slow_saddle_slope}, 1e-5}};
    (void)state;
    for (size_t i = 0; i < sizeof traps / sizeof *traps; i++) {
        const whirl_system system = pair_system(&traps[i].law);
        const double start[2] = {0.4, traps[i].start};
        whirl_record *r = record(&system, "rk4", true, true, 1100, start);
        assert_true(fabs(r->end[1] - 1) < 1e-6);
        assert_int_equal(r->orbit.search, WHIRL_ORBIT_STABLE);
        assert_true(fabs(r->orbit.modulus - exp(2 * pi * fmax(traps[i].law.slope(1), -0.5))) < 1e-6);
        whirl_record_free(r);
    }
}

/// A motion that stays exactly on a saddle returns; its orbit is reported as unstable.
static void a_saddle_is_no_verdict_to_trust(void **state) {
    const forced_pair law = {slow_saddle, slow_saddle_slope};
    const whirl_system system = pair_system(&law);
    const double start[2] = {0.4, 0};
    (void)state;
    whirl_record *r = record(&system, "rk4", true, true, 1100, start);
    assert_int_equal(r->orbit.search, WHIRL_ORBIT_UNSTABLE);
    assert_true(fabs(r->orbit.modulus - exp(2 * pi * 0.01)) < 1e-9);
    assert_true(r->orbit.set_at == 0);
    assert_int_equal(whirl_judge(r).agreement, WHIRL_LOW);
    whirl_record_free(r);
}

/// Just outside the unstable torus the motion moves away so slowly that it seems to be at rest. It must not be moved to
/// the focus.
static void an_unstable_torus_is_no_basin(void **state) {
    const whirl_system system = {.dimension = 3,
                                 .period = 2 * pi,
                                 .rhs = weak_focus,
                                 .tangent = near_weak_focus,
                                 .probe_count = 1,
                                 .probes = &probe};
    static const double radii[] = {1.02, 1.2, 2, 4};
    (void)state;
    for (size_t i = 0; i < sizeof radii / sizeof *radii; i++) {
        const double start[3] = {0.4, radii[i] * torus, 0};
        whirl_record *r = record(&system, "rk4", true, true, 3000, start);
        assert_true(r->orbit.set_at == 0);
        assert_true(hypot(r->end[1], r->end[2]) > radii[i] * torus);
        const whirl_verdict verdict = whirl_judge(r);
        assert_true(verdict.regime != WHIRL_PERIODIC || verdict.agreement < WHIRL_HIGH);
        whirl_record_free(r);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(multipliers_of_a_linear_oscillator), cmocka_unit_test(early_ends_change_no_verdict),
        cmocka_unit_test(slow_passages_do_not_end_early),     cmocka_unit_test(a_saddle_is_no_verdict_to_trust),
        cmocka_unit_test(an_unstable_torus_is_no_basin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
