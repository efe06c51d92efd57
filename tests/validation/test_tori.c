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
#include "whirl/torus.h"

static const double pi = 3.14159265358979323846;

static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    *forcing = cos(t);
}

// ---------------------------------------------------------------- a torus in closed form

/// z' = (p + i(w + b |z|^2)) z - s |z|^2 z beside x' = cos t - x, seen in other coordinates: u = Re z,
/// v = Im z/(1 - e Re z), x + u^2. With s = 1 the circle |z|^2 = p is a torus, stable, of rotation number w + b p and
/// exponents -4 pi p and -2 pi a revolution; with s = -1 that of |z|^2 = -p is unstable.
enum { GROWTH, ANGULAR, BEND, SHAPE, SIGN };

static void bent(const double *p, double drive, const double complex X[3], double complex out[3]) {
    const double complex a = X[0], part = 1.0 - p[SHAPE] * a, b = X[1] * part, x = X[2] - a * a, square = a * a + b * b;
    const double complex radial = p[GROWTH] - p[SIGN] * square, turn = p[ANGULAR] + p[BEND] * square;
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

/// By complex steps, exact to rounding.
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

/// The point of the torus at an angle, at t = 0: x = (cos t + sin t)/2.
static void bent_point(const double *p, double angle, double *X) {
    const double radius = sqrt(fabs(p[GROWTH])), a = radius * cos(angle);
    X[0] = a;
    X[1] = radius * sin(angle) / (1.0 - p[SHAPE] * a);
    X[2] = 0.5 + a * a;
}

/// Sections of the motion on the torus, one every `revolutions`; off it by `aside`.
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

/// Largest difference of |z|^2 - |p| and of x from its own, along the curve.
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

static double folded(double turns) {
    const double part = turns - floor(turns);
    return fmin(part, 1.0 - part);
}

static void check_bent(const test_family *family, const whirl_torus *torus, const char *what) {
    const double *p = family->p, k = (double)torus->revolutions, square = fabs(p[GROWTH]);
    const double across = -4.0 * pi * p[GROWTH];
    check_within("tori", words("%s: the curve, off its own", what), 0.0, bent_error(family, torus), 1e-7);
    check_within("tori", "its rotation number", folded(k * (p[ANGULAR] + p[BEND] * square)), torus->rotation, 1e-10);
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
    } rows[] = {{0.36, 0.3137, 1.0, 1, "circle, rotation .3497"},   {0.36, 1.7113, 1.0, 1, "circle, rotation 1.7473"},
                {0.25, 0.3137, 1.0, 2, "circle, two revolutions"}, {-0.36, 0.3137, -1.0, 1, "circle, unstable"},
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
    whirl_torus *first;
    whirl_torus_branch *tori;
    double value;
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(tori_in_closed_form),
                                       cmocka_unit_test(a_branch_in_closed_form)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
