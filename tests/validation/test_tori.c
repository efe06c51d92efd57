// Tori: their curves, rotation numbers and exponents, against closed forms and long motions by another integrator.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_branch.h"
#include "support_check.h"
#include "support_torus.h"

static const double pi = 3.14159265358979323846;

static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    *forcing = cos(t);
}

// ---------------------------------------------------------------- a torus in closed form

/// z' = (p + i(w + b |z|^2)) z - (s + q |z|^2) |z|^2 z and x' = cos t - x, in other coordinates: u = Re z,
/// v = Im z/(1 - e Re z), x + u^2. With s = 1, q = 0 the circle |z|^2 = p is a torus, stable, of rotation number w + b
/// p and exponents -4 pi p and -2 pi a revolution; with s = -1 that of |z|^2 = -p is unstable.
enum { GROWTH, ANGULAR, BEND, SHAPE, SIGN, FIFTH };

static void bent(const double *p, double drive, const double complex X[3], double complex out[3]) {
    const double complex a = X[0], part = 1.0 - p[SHAPE] * a, b = X[1] * part, x = X[2] - a * a, square = a * a + b * b;
    const double complex radial = p[GROWTH] - (p[SIGN] + p[FIFTH] * square) * square,
                         turn = p[ANGULAR] + p[BEND] * square;
    const double complex da = radial * a - turn * b, db = turn * a + radial * b;
    out[0] = da;
    out[1] = db / part + p[SHAPE] * b * da / (part * part);
    out[2] = drive - x + 2.0 * a * da;
}

static void bent_slope(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double complex X[3] = {x[0], x[1], x[2]};
    double complex out[3];
    (void)t;
    bent(model, *f, X, out);
    for (int i = 0; i < 3; i++) dxdt[i] = creal(out[i]);
}

/// Computes the tangent by complex steps, exact to rounding.
static void bent_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                         size_t count, const double *u, double *out) {
    (void)t, (void)sides;
    for (size_t k = 0; k < count; k++, u += 3, out += 3) {
        const double h = 1e-40;
        const double complex X[3] = {x[0] + I * h * u[0], x[1] + I * h * u[1], x[2] + I * h * u[2]};
        double complex found[3];
        bent(model, *f, X, found);
        for (int i = 0; i < 3; i++) out[i] = cimag(found[i]) / h;
    }
}

static double bent_divergence(const void *model, double t, const double *f, const double *x, const double *sides) {
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        double u[3] = {0.0}, out[3];
        u[i] = 1.0;
        bent_tangent(model, t, f, x, sides, 1, u, out);
        sum += out[i];
    }
    return sum;
}

static test_family bent_family(double growth, double angular, double sign) {
    return (test_family){.system = {.dimension = 3,
                                    .period = 2.0 * pi,
                                    .forcing_count = 1,
                                    .forcing = cosine,
                                    .rhs = bent_slope,
                                    .tangent = bent_tangent,
                                    .divergence = bent_divergence},
                         .p = {growth, angular, 0.1, 0.4, sign},
                         .varied = GROWTH};
}

/// Computes the point of the torus at an angle, at t = 0: x = (cos t + sin t)/2.
static void bent_point(const double *p, double angle, double *X) {
    const double radius = sqrt(fabs(p[GROWTH])), a = radius * cos(angle);
    X[0] = a;
    X[1] = radius * sin(angle) / (1.0 - p[SHAPE] * a);
    X[2] = 0.5 + a * a;
}

/// Returns sections of the motion on the torus, one every `revolutions`; from a start off it by `aside`.
static double *bent_sections(const test_family *family, size_t count, size_t revolutions, double aside) {
    const double *p = family->p, square = fabs(p[GROWTH]);
    double *points = calloc(3 * count, sizeof *points);
    assert_non_null(points);
    for (size_t m = 0; m < count; m++) {
        const double turns = (double)(m * revolutions) * (p[ANGULAR] + p[BEND] * square);
        bent_point(p, 2.0 * pi * fmod(turns, 1.0), points + 3 * m);
        points[3 * m + 1] *= 1.0 + aside;
    }
    return points;
}

/// Returns the largest difference of |z|^2 - |p| and of x from the closed form, along the curve.
static double bent_error(const test_family *family, const whirl_torus *torus) {
    const double *p = family->p;
    double error = 0.0, X[3];
    for (int j = 0; j < 500; j++) {
        whirl_torus_at(torus, 0.7 + 0.01 * pi * j, X);
        const double a = X[0], b = X[1] * (1.0 - p[SHAPE] * a), off = a * a + b * b - fabs(p[GROWTH]);
        error = fmax(error, fmax(fabs(off), fabs(X[2] - a * a - 0.5)));
    }
    return error;
}

static void check_bent(const test_family *family, const whirl_torus *torus, const char *what) {
    const double *p = family->p, k = (double)torus->revolutions, square = fabs(p[GROWTH]);
    const double across = -4.0 * pi * p[GROWTH];
    check_within("tori", words("%s: the curve, off its own", what), 0.0, bent_error(family, torus), 1e-7);
    check_within("tori", "its rotation number", folded_turns(k * (p[ANGULAR] + p[BEND] * square)), torus->rotation,
                 1e-10);
    check_within("tori", "its larger exponent", fmax(across, -2.0 * pi), torus->exponents[0], 1e-6);
    check_within("tori", "its smaller exponent", fmin(across, -2.0 * pi), torus->exponents[1], 1e-6);
    check_within("tori", "sum of exponents by the divergence", across - 2.0 * pi, torus->volume, 1e-6);
    assert_int_equal(p[GROWTH] < 0.0, torus->unstable);
}

static whirl_torus *find_torus(const test_family *family, const double *points, size_t count, size_t revolutions,
                               const whirl_torus_options *options) {
    const whirl_system system = system_of(family);
    whirl_torus *torus;
    require_ok(whirl_torus_find(&system, points, count, revolutions, NAN, options, &torus));
    return torus;
}

static void tori_in_closed_form(void **state) {
    static const struct {
        double growth, angular, sign;
        size_t revolutions;
        const char *what;
    } rows[] = {{0.36, 0.3137, 1.0, 1, "circle, rotation .3497"},
                {0.36, 1.7113, 1.0, 1, "circle, rotation 1.7473"},
                {0.25, 0.3137, 1.0, 2, "circle, two revolutions"},
                {-0.36, 0.3137, -1.0, 1, "circle, unstable"},
                {1.0, 0.0871, 1.0, 1, "circle, wide"}};
    whirl_torus_options options = whirl_torus_default();
    options.accuracy = 1e-10;
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const test_family family = bent_family(rows[i].growth, rows[i].angular, rows[i].sign);
        // A hundredth off the unstable one motions leave their bounds within a revolution.
        const double aside = rows[i].growth < 0.0 ? 1e-3 : 1e-2;
        double *points = bent_sections(&family, 600, rows[i].revolutions, aside);
        whirl_torus *torus = find_torus(&family, points, 600, rows[i].revolutions, &options);
        print_message("%zu nodes, error %.2g, tail %.2g, exponents off %.2g\n", torus->node_count, torus->error,
                      torus->tail, torus->exponent_errors[0]);
        check_bent(&family, torus, rows[i].what);
        const whirl_system system = system_of(&family);
        double line, amplitude;
        require_ok(whirl_torus_line(&system, torus, &options, 0, &line, &amplitude));
        check_within("tori", "the frequency that is seen", rows[i].angular + 0.1 * fabs(rows[i].growth), line, 1e-10);
        check_within("tori", "its amplitude", sqrt(fabs(rows[i].growth)), amplitude, 1e-8);
        whirl_torus_free(torus);
        free(points);
    }
}

// ---------------------------------------------------------------- from its beginning to its end

static void a_branch_in_closed_form(void **state) {
    (void)state;
    test_family family = bent_family(-0.1, 0.31, 1.0);
    family.start[2] = 0.5;
    family.start[0] = 0.01;
    const whirl_family machines = family_of(&family);
    const whirl_branch_options orbits = whirl_branch_default(-0.1, 1.0);
    whirl_orbit *start = find_orbit(&family, 1, &orbits.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &orbits);
    const whirl_branch_point *point = special_point(branch, WHIRL_NEIMARK_SACKER, 0);
    assert_non_null(point);
    whirl_torus_branch_options options = whirl_torus_branch_default(-0.1, 1.0);
    options.torus.accuracy = 1e-9;
    options.most_step = 0.2;
    whirl_torus *first;
    whirl_torus_branch *tori;
    double value;
    require_ok(whirl_torus_begin(&machines, point, 1e-5, &options, &first, &value));
    check_within("tori", words("a torus of radius %.1g: its rotation number", first->radius), 0.31, first->rotation,
                 1e-8);
    whirl_torus_free(first);
    require_ok(whirl_torus_begin(&machines, point, 0.05, &options, &first, &value));
    family.p[GROWTH] = value;
    check_bent(&family, first, "first torus");
    require_ok(whirl_torus_follow(&machines, first, value, 1, &options, &tori));
    double curve = 0.0, rotation = 0.0, exponent = 0.0;
    size_t most = 0;
    for (size_t i = 0; i < tori->count; i++) {
        const whirl_torus *torus = tori->points[i].torus;
        family.p[GROWTH] = tori->points[i].value;
        most = torus->node_count > most ? torus->node_count : most;
        curve = fmax(curve, bent_error(&family, torus));
        rotation = fmax(rotation, fabs(torus->rotation - 0.31 - 0.1 * family.p[GROWTH]));
        exponent = fmax(exponent, fabs(torus->exponents[0] - fmax(-4.0 * pi * family.p[GROWTH], -2.0 * pi)));
    }
    print_message("%zu tori, up to %zu nodes: %s\n", tori->count, most, tori->why);
    check_within("tori", words("branch to p = 1: largest error of %zu curves", tori->count), 0.0, curve, 1e-6);
    check_within("tori", "of their rotation numbers", 0.0, rotation, 1e-9);
    check_within("tori", "of their larger exponents", 0.0, exponent, 1e-6);
    assert_int_equal(WHIRL_TORUS_END_OF_RANGE, tori->end);
    whirl_torus_branch *back;
    const whirl_torus_point *last = &tori->points[tori->count - 1];
    require_ok(whirl_torus_follow(&machines, last->torus, last->value, -1, &options, &back));
    print_message("%zu tori: %s\n", back->count, back->why);
    assert_int_equal(WHIRL_TORUS_SHRANK, back->end);
    whirl_torus_branch_free(back);
    whirl_torus_branch_free(tori);
    whirl_torus_free(first);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

/// With s = -1, q = 1 the torus that begins at p = 0 is unstable, goes to p = -1/4, turns there where |z|^2 = 1/2, and
/// comes back stable: p = |z|^4 - |z|^2, its exponent across 4 pi (|z|^2 - 2 |z|^4).
static void a_branch_turns(void **state) {
    (void)state;
    test_family family = bent_family(-0.1, 0.3137, -1.0);
    family.p[FIFTH] = 1.0;
    family.start[2] = 0.5;
    const whirl_family machines = family_of(&family);
    const whirl_branch_options orbits = whirl_branch_default(-0.3, 0.2);
    whirl_orbit *start = find_orbit(&family, 1, &orbits.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &orbits);
    const whirl_branch_point *point = special_point(branch, WHIRL_NEIMARK_SACKER, 0);
    assert_non_null(point);
    assert_true(point->criticality > 0.0);
    whirl_torus_branch_options options = whirl_torus_branch_default(-0.3, 0.2);
    options.torus.accuracy = 1e-10;
    options.most_step = 0.1;
    whirl_torus *first;
    whirl_torus_branch *tori;
    double value, least = 0.0, curve = 0.0, exponent = 0.0;
    require_ok(whirl_torus_begin(&machines, point, 0.05, &options, &first, &value));
    assert_int_equal(1, first->unstable);
    require_ok(whirl_torus_follow(&machines, first, value, -1, &options, &tori));
    for (size_t i = 0; i < tori->count; i++) {
        const whirl_torus *torus = tori->points[i].torus;
        const double *X = torus->nodes, b = X[1] * (1.0 - family.p[SHAPE] * X[0]), square = X[0] * X[0] + b * b;
        const double across = 4.0 * pi * (square - 2.0 * square * square);
        least = fmin(least, tori->points[i].value);
        curve = fmax(curve, fabs(square * square - square - tori->points[i].value));
        exponent = fmax(exponent, fabs(torus->exponents[0] - fmax(across, -2.0 * pi)));
        assert_int_equal(square < 0.5, torus->unstable);
    }
    print_message("%zu tori, least p = %.8f: %s\n", tori->count, least, tori->why);
    assert_int_equal(WHIRL_TORUS_END_OF_RANGE, tori->end);
    check_within("tori", words("circle that turns at p = -1/4: its %zu radii", tori->count), 0.0, curve, 1e-7);
    check_within("tori", "of their exponents", 0.0, exponent, 1e-6);
    check_within("tori", "least p of these tori", -0.25, least, 5e-3);
    whirl_torus_branch_free(tori);
    whirl_torus_free(first);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

typedef struct bounds {
    const double *p;
    double low, high, off;
    size_t calls;
} bounds;

static void widen(void *context, double t, const double *X) {
    bounds *b = context;
    const double part = X[1] * (1.0 - b->p[SHAPE] * X[0]), square = X[0] * X[0] + part * part;
    b->low = fmin(b->low, X[0]);
    b->high = fmax(b->high, X[0]);
    b->off = fmax(b->off, fmax(fabs(square - b->p[GROWTH]), fabs(X[2] - X[0] * X[0] - 0.5 * (cos(t) + sin(t)))));
    b->calls++;
}

/// All numbers along the branch lie on the torus, whose first coordinate tends to the circle's radius.
static void extremes_along_a_torus(void **state) {
    (void)state;
    const test_family family = bent_family(0.36, 0.3137, 1.0);
    const whirl_system system = system_of(&family);
    const whirl_torus_options options = whirl_torus_default();
    double *points = bent_sections(&family, 400, 2, 0.0);
    whirl_torus *torus = find_torus(&family, points, 400, 2, &options);
    bounds seen = {.p = family.p};
    require_ok(whirl_torus_observe(&system, torus, &options, 24, 128, widen, &seen));
    assert_int_equal(24 * 128 * 2, seen.calls);
    check_within("tori", "seen along a circle: off the torus", 0.0, seen.off, 1e-6);
    check_within("tori", "its highest", 0.6, seen.high, 1e-3);
    check_within("tori", "its lowest", -0.6, seen.low, 1e-3);
    whirl_torus_free(torus);
    free(points);
}

// ---------------------------------------------------------------- long motions by another integrator

/// x'' - mu (1 - x^2) x' + x = F cos W t; p: mu, F, W.
enum { MU, STRENGTH, RATE };

static void van_der_pol_slope(const void *model, double t, const double *x, double *slope) {
    const double *p = model;
    slope[0] = x[1];
    slope[1] = p[MU] * (1.0 - x[0] * x[0]) * x[1] - x[0] + p[STRENGTH] * cos(p[RATE] * t);
}

static void van_der_pol(const void *model, double t, const double *f, const double *x, double *slope) {
    (void)f;
    van_der_pol_slope(model, t, x, slope);
}

static void van_der_pol_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                                size_t count, const double *u, double *out) {
    const double *p = model;
    (void)t, (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, u += 2, out += 2) {
        out[0] = u[1];
        out[1] = p[MU] * (1.0 - x[0] * x[0]) * u[1] - (1.0 + 2.0 * p[MU] * x[0] * x[1]) * u[0];
    }
}

static double van_der_pol_divergence(const void *model, double t, const double *f, const double *x,
                                     const double *sides) {
    const double *p = model;
    (void)t, (void)f, (void)sides;
    return p[MU] * (1.0 - x[0] * x[0]);
}

static test_family van_der_pol_family(double mu, double strength, double rate) {
    return (test_family){.system = {.dimension = 2,
                                    .period = 2.0 * pi / rate,
                                    .rhs = van_der_pol,
                                    .tangent = van_der_pol_tangent,
                                    .divergence = van_der_pol_divergence},
                         .p = {mu, strength, rate},
                         .varied = STRENGTH};
}

static void van_der_pol_and_a_long_motion(void **state) {
    static const double rows[][3] = {{0.5, 0.5, 1.7}, {1.0, 0.4, 2.3}};
    enum { SETTLING = 300, COUNT = 3000, STEPS = 800, CHECKED = 300 };
    const double start[2] = {1.5, 0.0};
    whirl_torus_options options = whirl_torus_default();
    options.accuracy = 1e-9;
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const test_family family = van_der_pol_family(rows[i][MU], rows[i][STRENGTH], rows[i][RATE]);
        double *points =
            long_motion(van_der_pol_slope, family.p, 2, family.system.period, STEPS, start, SETTLING, COUNT);
        whirl_torus *torus = find_torus(&family, points, CHECKED, 1, &options);
        print_message("%zu nodes, radius %.3f, error %.2g, exponent %.8f (%.2g)\n", torus->node_count, torus->radius,
                      torus->error, torus->exponents[0], torus->exponent_errors[0]);
        check_within("tori",
                     words("van der Pol, mu = %g, F = %g, W = %g: rotation", rows[i][0], rows[i][1], rows[i][2]),
                     mean_turn(points, 2, COUNT), torus->rotation, 1e-9);
        check_within("tori", "largest distance of 300 of its sections from the curve", 0.0,
                     distance_from(torus, points + 2 * (size_t)(COUNT - CHECKED), CHECKED), 1e-8);
        check_within("tori", "its exponent, and the mean divergence", torus->volume, torus->exponents[0], 1e-7);
        whirl_torus_free(torus);
        free(points);
    }
}

// ---------------------------------------------------------------- where tori end

/// Follows the torus of van der Pol's oscillator from a long motion at a small force to larger ones.
static whirl_torus_branch *follow_van_der_pol(test_family *family, double to, double accuracy, size_t most_nodes) {
    enum { COUNT = 600 };
    const double start[2] = {2.0, 0.0};
    const whirl_family machines = family_of(family);
    whirl_torus_branch_options options = whirl_torus_branch_default(0.5 * family->p[STRENGTH], to);
    options.torus.accuracy = accuracy;
    options.torus.most_nodes = most_nodes;
    options.most_step = 0.2;
    double *points = long_motion(van_der_pol_slope, family->p, 2, family->system.period, 400, start, 200, COUNT);
    whirl_torus *torus = find_torus(family, points, COUNT, 1, &options.torus);
    whirl_torus_branch *tori;
    require_ok(whirl_torus_follow(&machines, torus, family->p[STRENGTH], 1, &options, &tori));
    const whirl_torus_point *last = &tori->points[tori->count - 1];
    print_message("%zu tori to F = %.6f, the last of %zu nodes, rotation %.6f: %s\n", tori->count, last->value,
                  last->torus->node_count, last->torus->rotation, tori->why);
    whirl_torus_free(torus);
    free(points);
    return tori;
}

/// Follows the orbits of one period from a large force down.
static whirl_branch *entrained_orbits(test_family *family, double from, double to) {
    const double start[2] = {2.0, 0.0};
    const whirl_branch_options options = whirl_branch_default(to, from);
    family->p[STRENGTH] = from;
    double *point = long_motion(van_der_pol_slope, family->p, 2, family->system.period, 400, start, 300, 1);
    memcpy(family->start, point, 2 * sizeof *point);
    whirl_orbit *orbit = find_orbit(family, 1, &options.orbit);
    whirl_branch *branch = follow_branch(family, orbit, -1, &options);
    whirl_orbit_free(orbit);
    free(point);
    return branch;
}

/// Close to its own rate the oscillator is entrained by a fold: two orbits of one period appear on the torus, on which
/// the motion stops. Towards there it takes more and more nodes, and the square of its rotation number falls evenly.
static void a_torus_locks(void **state) {
    (void)state;
    test_family family = van_der_pol_family(0.3, 0.06, 1.03);
    whirl_torus_branch *tori = follow_van_der_pol(&family, 0.3, 1e-4, 151);
    whirl_branch *orbits = entrained_orbits(&family, 0.3, 0.03);
    const whirl_branch_point *fold = special_point(orbits, WHIRL_FOLD, 0);
    const whirl_torus_point *last = &tori->points[tori->count - 1];
    assert_non_null(fold);
    assert_int_equal(WHIRL_TORUS_ROUGH, tori->end);
    const double one = last->torus->rotation, two = last[-1].torus->rotation;
    const double ends = last->value - one * one * (last[-1].value - last->value) / (two * two - one * one);
    check_within("tori", "van der Pol, W = 1.03: F where the torus' rotation ends, and of the fold of orbits",
                 fold->value, ends, 2e-4);
    check_holds("tori", "its last torus is before the fold", last->value < fold->value);
    whirl_branch_free(orbits);
    whirl_torus_branch_free(tori);
}

/// At a larger detuning the torus shrinks to the orbit.
static void a_torus_shrinks(void **state) {
    (void)state;
    test_family family = van_der_pol_family(0.3, 0.2, 1.1);
    whirl_torus_branch *tori = follow_van_der_pol(&family, 0.8, 1e-7, 127);
    whirl_branch *orbits = entrained_orbits(&family, 0.7, 0.1);
    const whirl_branch_point *point = special_point(orbits, WHIRL_NEIMARK_SACKER, 0);
    const whirl_torus_point *last = &tori->points[tori->count - 1];
    assert_non_null(point);
    assert_int_equal(WHIRL_TORUS_SHRANK, tori->end);
    check_within("tori", "van der Pol, W = 1.1: F of the last torus, and of the orbit it shrinks to", point->value,
                 last->value, 1e-3);
    check_within("tori", "rotation numbers of both", point->angle / (2.0 * pi), last->torus->rotation, 1e-3);
    whirl_branch_free(orbits);
    whirl_torus_branch_free(tori);
}

// ---------------------------------------------------------------- what is refused

static void expect_refusal(const char *words_of_it, whirl_status status) {
    print_message("%s\n", status.message);
    assert_int_equal(WHIRL_BAD_INPUT, status.code);
    assert_non_null(strstr(status.message, words_of_it));
}

static void wrong_input_is_refused(void **state) {
    (void)state;
    enum { COUNT = 200 };
    const test_family family = bent_family(0.36, 0.3137, 1.0);
    const whirl_system system = system_of(&family);
    whirl_torus_options options = whirl_torus_default();
    double *points = bent_sections(&family, COUNT, 1, 0.0), other[3 * COUNT];
    whirl_torus *torus;
    expect_refusal("expected 64 or more", whirl_torus_find(&system, points, 63, 1, NAN, &options, &torus));
    assert_null(torus);
    expect_refusal("sections 0 revolutions apart", whirl_torus_find(&system, points, COUNT, 0, NAN, &options, &torus));
    for (int i = 0; i < 3 * COUNT; i++) other[i] = points[i % 21];
    expect_refusal("repeat after 7", whirl_torus_find(&system, other, COUNT, 1, NAN, &options, &torus));
    for (int i = 0; i < 3 * COUNT; i++) other[i] = points[i % 3];
    expect_refusal("are one point", whirl_torus_find(&system, other, COUNT, 1, NAN, &options, &torus));
    uint64_t seed = 1;
    for (int i = 0; i < 3 * COUNT; i++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        other[i] = (double)(seed >> 11) / 9007199254740992.0;
    }
    expect_refusal("no closed curve", whirl_torus_find(&system, other, COUNT, 1, NAN, &options, &torus));
    other[5] = NAN;
    expect_refusal("section 1 is not finite", whirl_torus_find(&system, other, COUNT, 1, NAN, &options, &torus));
    // A machine without a torus, at sections of another one's.
    const test_family without = bent_family(-0.05, 0.3137, 1.0);
    const whirl_system dead = system_of(&without);
    expect_refusal("no torus was found", whirl_torus_find(&dead, points, COUNT, 1, NAN, &options, &torus));
    for (int i = 0; i < 3 * COUNT; i++) other[i] = 0.5 * (i % 3 == 2) + 1e-3 * points[i] * (i % 3 < 2);
    expect_refusal("no torus", whirl_torus_find(&dead, other, COUNT, 1, NAN, &options, &torus));
    options.most_nodes = 128;
    expect_refusal("expected an odd number", whirl_torus_find(&system, points, COUNT, 1, NAN, &options, &torus));
    options.most_nodes = 7;
    expect_refusal("not smooth enough", whirl_torus_find(&system, points, COUNT, 1, NAN, &options, &torus));
    assert_null(torus);
    // Its number given, a torus of some error comes without looking for it.
    options = whirl_torus_default();
    options.accuracy = 1e-3;
    require_ok(whirl_torus_find(&system, points, COUNT, 1, 0.3497, &options, &torus));
    assert_true(torus->node_count < 21);
    whirl_torus_branch_options branch = whirl_torus_branch_default(0.5, 1.0);
    const whirl_family machines = family_of(&family);
    whirl_torus_branch *tori;
    double value;
    expect_refusal("a line of coordinate 3", whirl_torus_line(&system, torus, &options, 3, &value, &value));
    expect_refusal("expected a value from 0.5 to 1", whirl_torus_follow(&machines, torus, 0.36, 1, &branch, &tori));
    const whirl_orbit none = {.revolutions = 1};
    whirl_branch_point point = {.special = WHIRL_FOLD, .orbit = (whirl_orbit *)(uintptr_t)&none};
    whirl_torus_free(torus);
    expect_refusal("expected a Neimark-Sacker point",
                   whirl_torus_begin(&machines, &point, 0.1, &branch, &torus, &value));
    point.special = WHIRL_NEIMARK_SACKER;
    point.angle = 2.0 * pi / 3.0;
    expect_refusal("strong resonance", whirl_torus_begin(&machines, &point, 0.1, &branch, &torus, &value));
    free(points);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(tori_in_closed_form),
                                       cmocka_unit_test(a_branch_in_closed_form),
                                       cmocka_unit_test(a_branch_turns),
                                       cmocka_unit_test(extremes_along_a_torus),
                                       cmocka_unit_test(van_der_pol_and_a_long_motion),
                                       cmocka_unit_test(a_torus_locks),
                                       cmocka_unit_test(a_torus_shrinks),
                                       cmocka_unit_test(wrong_input_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
