// Records along orbits that are known in closed form and that every motion near them leaves.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/analyze.h"

static const double pi = 3.14159265358979323846;

/// x = cos(w t), y = sin(w t). Driven: x'' = k^2 x - (k^2 + w^2) cos(w t), which perturbations leave by the factor
/// exp(2 pi k) a revolution. Free: x'' = -w^2 x + k (x^2 + y^2 - 1) x', and so y. One contact, closed where x > 0.6.
typedef struct saddle {
    double k, w;
    bool driven;
} saddle;

static void rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const saddle *s = model;
    const double swing[2] = {cos(s->w * t), sin(s->w * t)}, r2 = x[0] * x[0] + x[1] * x[1];
    (void)forcing;
    for (int i = 0; i < 2; i++) {
        dxdt[i] = x[i + 2];
        dxdt[i + 2] = s->driven ? s->k * s->k * x[i] - (s->k * s->k + s->w * s->w) * swing[i]
                                : -s->w * s->w * x[i] + s->k * (r2 - 1.0) * x[i + 2];
    }
}

static void tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                    size_t count, const double *dx, double *ddxdt) {
    const saddle *s = model;
    const double r2 = x[0] * x[0] + x[1] * x[1];
    (void)t, (void)forcing, (void)sides;
    for (; count > 0; count--, dx += 4, ddxdt += 4)
        for (int i = 0; i < 2; i++) {
            ddxdt[i] = dx[i + 2];
            ddxdt[i + 2] = s->driven ? s->k * s->k * dx[i]
                                     : -s->w * s->w * dx[i] + s->k * (r2 - 1.0) * dx[i + 2] +
                                           2.0 * s->k * (x[0] * dx[0] + x[1] * dx[1]) * x[i + 2];
        }
}

static void wall(const void *model, const double *x, double *force) {
    (void)model;
    force[0] = fmax(0.0, x[0] - 0.6);
}

static const whirl_probe probe = {.name = "disc", .x = 0, .y = 1, .vx = 2, .vy = 3};

static whirl_system system_of(const saddle *s) {
    return (whirl_system){.dimension = 4,
                          .period = 2.0 * pi,
                          .rhs = rhs,
                          .tangent = tangent,
                          .contact_count = 1,
                          .contacts = wall,
                          .probe_count = 1,
                          .probes = &probe,
                          .model = s};
}

/// Computes the state at time t in closed form.
static void state_at(const saddle *s, double t, double x[4]) {
    x[0] = cos(s->w * t);
    x[1] = sin(s->w * t);
    x[2] = -s->w * x[1];
    x[3] = s->w * x[0];
}

/// Makes the record of the saddle's motion over 8 revolutions.
static whirl_record *record(const saddle *s, size_t revolutions, size_t segments) {
    const whirl_system system = system_of(s);
    const whirl_orbit like = {
        .dimension = 4, .revolutions = revolutions, .period = 2.0 * pi / s->w, .segment_count = segments};
    whirl_orbit *orbit = whirl_orbit_new(&like);
    assert_non_null(orbit);
    for (size_t j = 0; j < segments; j++) state_at(s, like.period * (double)j / (double)segments, orbit->nodes + 4 * j);
    const whirl_orbit_options options = whirl_orbit_default();
    whirl_record_options wanted = whirl_record_default();
    wanted.transient = 0;
    wanted.record = 8;
    wanted.waveform = true;
    whirl_record *made;
    const whirl_status status = whirl_record_along(&system, orbit, &options, &wanted, &made);
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
    whirl_orbit_free(orbit);
    return made;
}

static void expect_closed_form(const saddle *s, const whirl_record *r, double tolerance) {
    double x[4], error = 0.0;
    assert_int_equal(r->motion, WHIRL_BOUNDED);
    assert_int_equal(r->section_count, 8);
    assert_int_equal(r->sample_count, 8 * r->samples_per_revolution);
    for (size_t n = 0; n < 8; n++) {
        state_at(s, 2.0 * pi * (double)(n + 1), x);
        for (size_t i = 0; i < 4; i++) error = fmax(error, fabs(r->section[4 * n + i] - x[i]));
    }
    for (size_t i = 0; i < r->sample_count; i++) {
        state_at(s, 2.0 * pi * (double)(i + 1) / (double)r->samples_per_revolution, x);
        error = fmax(error, fabs(r->waveform[i] - x[0]));
        error = fmax(error, fabs(r->waveform[r->sample_count + i] - x[1]));
    }
    if (!(error <= tolerance)) fail_msg("off by %g, expected at most %g", error, tolerance);
    assert_true(fabs(r->max_radius[0] - 1.0) < 1e-9 && fabs(r->min_radius[0] - 1.0) < 1e-9);
    assert_true(fabs(r->mean[0]) < 1e-9 && fabs(r->mean[1]) < 1e-9);
    assert_true(r->backward[0] == 0.0);
    // Bounds are those of instants: 512 a revolution, or an orbit.
    const double between = 1.0 - cos(pi / 512.0);
    for (size_t i = 0; i < 2; i++)
        assert_true(fabs(r->low[i] + 1.0) < between + 1e-9 && fabs(r->high[i] - 1.0) < between + 1e-9);
    assert_true(fabs(r->contact_share[0] - acos(0.6) / pi) <= 1.0 / 512.0);
    assert_true(fabs(r->contact_force[0] - 0.4) < 1e-9);
}

// After 8 revolutions from one start alone rounding would have grown by exp(16 pi k), 4e43.
static void saddle_orbits_are_not_left(void **state) {
    (void)state;
    const saddle s = {.k = 2.0, .w = 1.0, .driven = true};
    for (size_t segments = 1; segments <= 4; segments++) { // 3 do not divide the instants
        whirl_record *r = record(&s, 1, segments);
        expect_closed_form(&s, r, 1e-8);
        assert_true(r->contact_number[0] == 8.0);
        whirl_record_free(r);
    }
}

static void orbits_of_several_revolutions_come_in_turn(void **state) {
    (void)state;
    const saddle s = {.k = 0.2, .w = 0.5, .driven = false};
    for (size_t segments = 1; segments <= 3; segments += 2) {
        whirl_record *r = record(&s, 2, 2 * segments);
        expect_closed_form(&s, r, 1e-8);
        assert_true(r->contact_number[0] == 4.0);
        whirl_record_free(r);
    }
}

// Revolutions of the clock lie between instants of the orbit, h = 2 pi/512 apart: chords miss slopes by h^3/6 of the
// third derivative, and so the cubics by less than 1e-7.
static void orbits_with_a_time_of_their_own_go_on(void **state) {
    (void)state;
    const saddle s = {.k = 0.2, .w = 0.48, .driven = false};
    for (size_t segments = 1; segments <= 2; segments++) {
        whirl_record *r = record(&s, 0, segments);
        expect_closed_form(&s, r, 1e-7);
        assert_true(r->contact_number[0] == 4.0); // 8 revolutions, 0.48 each
        whirl_record_free(r);
    }
}

static void equilibria_stay(void **state) {
    (void)state;
    const saddle s = {.k = 1.0, .w = 0.0, .driven = true};
    const whirl_system system = system_of(&s);
    const whirl_orbit like = {.dimension = 4, .segment_count = 1};
    whirl_orbit *orbit = whirl_orbit_new(&like);
    assert_non_null(orbit);
    orbit->nodes[0] = 1.0;
    const whirl_orbit_options options = whirl_orbit_default();
    whirl_record_options wanted = whirl_record_default();
    wanted.transient = 0;
    wanted.record = 3;
    wanted.waveform = true;
    whirl_record *r;
    assert_int_equal(whirl_record_along(&system, orbit, &options, &wanted, &r).code, WHIRL_OK);
    for (size_t i = 0; i < r->sample_count; i++)
        assert_true(r->waveform[i] == 1.0 && r->waveform[r->sample_count + i] == 0.0);
    assert_true(r->low[0] == 1.0 && r->high[0] == 1.0 && r->mean[0] == 1.0 && r->contact_share[0] == 1.0);
    assert_true(r->contact_number[0] == 0.0);
    whirl_record_free(r);
    whirl_orbit_free(orbit);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(saddle_orbits_are_not_left),
        cmocka_unit_test(orbits_of_several_revolutions_come_in_turn),
        cmocka_unit_test(orbits_with_a_time_of_their_own_go_on),
        cmocka_unit_test(equilibria_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
