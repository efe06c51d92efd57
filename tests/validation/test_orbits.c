// Periodic orbits and their multipliers: against closed forms, printed digits, and each other by other segments.
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
#include "support_flow.h"
#include "support_rotor.h"
#include "whirl/engine/rotor.h"

static const double pi = 3.14159265358979323846;

static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    *forcing = cos(t);
}

// ---------------------------------------------------------------- Duffing's oscillator of NLvib's first example

/// x'' + .05 x' + x + .1 x^3 = .18 cos(W t) in tau = W t; p: W.
static void duffing(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double W = *(const double *)model;
    (void)t;
    dxdt[0] = x[1];
    dxdt[1] = (0.18 * *f - 0.05 * W * x[1] - x[0] - 0.1 * x[0] * x[0] * x[0]) / (W * W);
}

static void duffing_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                            size_t count, const double *u, double *out) {
    const double W = *(const double *)model;
    (void)t, (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, u += 2, out += 2) {
        out[0] = u[1];
        out[1] = (-0.05 * W * u[1] - (1.0 + 0.3 * x[0] * x[0]) * u[0]) / (W * W);
    }
}

static double duffing_divergence(const void *model, double t, const double *f, const double *x, const double *sides) {
    (void)t, (void)f, (void)x, (void)sides;
    return -0.05 / *(const double *)model;
}

static test_family duffing_family(double W) {
    return (test_family){.system = {.dimension = 2,
                                    .period = 2.0 * pi,
                                    .forcing_count = 1,
                                    .forcing = cosine,
                                    .rhs = duffing,
                                    .tangent = duffing_tangent,
                                    .divergence = duffing_divergence},
                         .p = {W},
                         .start = {0.5, 0.1}};
}

/// Digits of the states by RK4 in extended precision with 6000 steps, which errs by some 1e-14; asked 1e-10.
static void duffing_has_the_printed_states(void **state) {
    static const struct {
        double W, x, v, trace;
    } rows[] = {{0.8, 0.47276339331008, 0.05060272290166, -0.209626838108},
                {1.0, 1.21974613859089, 0.49276763592742, 1.352727585784}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        test_family family = duffing_family(rows[i].W);
        family.start[0] = rows[i].W < 0.9 ? 0.5 : 1.2;
        const whirl_orbit_options options = whirl_orbit_default();
        whirl_orbit *orbit = find_orbit(&family, 1, &options);
        check_within("orbits", words("NLvib 01, W = %g: x(0)", rows[i].W), rows[i].x, orbit->nodes[0], 2e-13);
        check_within("orbits", words("NLvib 01, W = %g: dx/dtau(0)", rows[i].W), rows[i].v, orbit->nodes[1], 2e-13);
        const whirl_multiplier *m = orbit->multipliers;
        check_within("orbits", words("NLvib 01, W = %g: trace", rows[i].W), rows[i].trace, m[0].real + m[1].real,
                     1e-12);
        check_within("orbits", words("NLvib 01, W = %g: ln of the determinant", rows[i].W),
                     -2.0 * pi * 0.05 / rows[i].W, sum_of_logarithms(orbit), 1e-12);
        whirl_orbit_free(orbit);
    }
}

// ---------------------------------------------------------------- linear systems

/// x'' + (a - 2 q cos 2 t) x = 0 over pi, as tau = 2 t over 2 pi; p: a, q.
static void mathieu_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                            size_t count, const double *u, double *out) {
    const double *p = model;
    (void)t, (void)x, (void)sides;
    for (size_t k = 0; k < count; k++, u += 2, out += 2) {
        out[0] = u[1];
        out[1] = -0.25 * (p[0] - 2.0 * p[1] * *f) * u[0];
    }
}

static void mathieu(const void *model, double t, const double *f, const double *x, double *dxdt) {
    mathieu_tangent(model, t, f, x, NULL, 1, x, dxdt);
}

static void multipliers_of_mathieu(void **state) {
    static const struct {
        double a, q;
        const char *trace;
    } rows[] = {{1.0, 0.5, "-2.612418906625"}, {2.0, 0.5, "-.797128628431"}, {4.0, 1.0, "2.021314397417"}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const test_family family = {.system = {.dimension = 2,
                                               .period = 2.0 * pi,
                                               .forcing_count = 1,
                                               .forcing = cosine,
                                               .rhs = mathieu,
                                               .tangent = mathieu_tangent},
                                    .p = {rows[i].a, rows[i].q}};
        const whirl_orbit_options options = whirl_orbit_default();
        whirl_orbit *orbit = find_orbit(&family, 1, &options);
        const whirl_multiplier *m = orbit->multipliers;
        check_digits("orbits", words("D3, a = %g, q = %g: trace", rows[i].a, rows[i].q), rows[i].trace,
                     m[0].real + m[1].real);
        check_within("orbits", "D3, product", 1.0, m[0].real * m[1].real - m[0].imaginary * m[1].imaginary, 1e-12);
        whirl_orbit_free(orbit);
    }
}

/// A disc on a shaft of two stiffnesses that turns between its criticals.
static void multipliers_of_unequal_shaft(void **state) {
    static const struct {
        double speed;
        const char *modulus;
    } rows[] = {{0.9, "1.257484822459"}, {1.0, "1.872990869329"}, {1.09, "1.205916208597"}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const shaft_case shaft = {.speed = rows[i].speed, .k1 = 0.8, .k2 = 1.2};
        whirl_rotor *rotor = make_shaft_rotor(&shaft);
        whirl_orbit *orbit;
        const double rest[4] = {0.0};
        const whirl_orbit_options options = whirl_orbit_default();
        require_ok(whirl_orbit_find(whirl_rotor_system(rotor), rest, 1, &options, &orbit));
        check_digits("orbits", words("B2, w = %g: largest modulus", rows[i].speed), rows[i].modulus,
                     hypot(orbit->multipliers[0].real, orbit->multipliers[0].imaginary));
        assert_int_equal(1, orbit->unstable);
        whirl_orbit_free(orbit);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- rotors in films and at their stators

/// The unloaded rotor's circle: its largest modulus is printed to five digits.
static void multipliers_of_the_film_circle(void **state) {
    static const struct {
        double radius, rho;
        const char *modulus;
    } rows[] = {{0.3, 0.304206515539, ".57499"}, {0.5, 0.504787456190, ".10099"}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double start[4] = {rows[i].radius, 0.0, 0.0, rows[i].radius};
        const whirl_orbit_options options = whirl_orbit_default();
        whirl_rotor *rotor = make_film_rotor(0.2, 0.0, rows[i].rho);
        whirl_orbit *orbit;
        require_ok(whirl_orbit_find(whirl_rotor_system(rotor), start, 1, &options, &orbit));
        check_within("orbits", words("A7, radius at rho = %.12g", rows[i].rho), rows[i].radius,
                     hypot(orbit->nodes[0], orbit->nodes[1]), 1e-11);
        check_digits("orbits", words("A7, e = %g: largest modulus", rows[i].radius), rows[i].modulus,
                     hypot(orbit->multipliers[0].real, orbit->multipliers[0].imaginary));
        whirl_orbit_free(orbit);
        whirl_rotor_free(rotor);
    }
}

/// Orbits with contact: one that always touches, one of four revolutions that touches now and then. Digits of whirl's
/// unlike friction and of the multipliers are printed; the product of these is exp(-4 zeta n T) exactly only without
/// damped contacts, which these have not.
static void multipliers_of_rub_orbits(void **state) {
    static const struct {
        double speed;
        size_t revolutions;
        const char *x, *y, *real, *imaginary, *third, *fourth;
        size_t intervals;
    } rows[] = {
        {1.5, 1, "1.3284851484", "-.3705078967", ".54774858", ".61278587", "-.588909", "-.47058333", 1},
        {3.8, 4, "-1.0595706503", "-.5024893815", "-.42213556", ".4797482", ".65282916", ".26620254", 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const rub_case rub = {rows[i].speed, 0.1, 10.0, 0.05, 0.9, 0.5, false, 0.0, 0.0};
        whirl_rotor *rotor = make_rub_rotor(&rub);
        const whirl_system *system = whirl_rotor_system(rotor);
        whirl_integrator *integrator = make_integrator(system, "dop853", 64);
        whirl_orbit_options options = whirl_orbit_default();
        whirl_orbit *orbit;
        double x[MAX_DIMENSION] = {0.1, -0.2};
        size_t node = 0;
        revolve(integrator, x, 400);
        options.segments = 2;
        require_ok(whirl_orbit_find(system, x, rows[i].revolutions, &options, &orbit));
        for (size_t k = 0; k < 2 * rows[i].revolutions; k += 2)
            if (fabs(orbit->nodes[k * 4] - strtod(rows[i].x, NULL)) < 1e-6) node = k;
        check_digits("orbits", words("C4, w = %g: x", rows[i].speed), rows[i].x, orbit->nodes[node * 4]);
        check_digits("orbits", words("C4, w = %g: y", rows[i].speed), rows[i].y, orbit->nodes[node * 4 + 1]);
        // The pair stands where its modulus puts it.
        size_t pair = 0, other[2], others = 0;
        for (size_t k = 0; k < 4; k++) {
            if (orbit->multipliers[k].imaginary > 0.0) pair = k;
            if (orbit->multipliers[k].imaginary == 0.0 && others < 2) other[others++] = k;
        }
        assert_int_equal(2, others);
        check_digits("orbits", words("C4, w = %g: pair, real", rows[i].speed), rows[i].real,
                     orbit->multipliers[pair].real);
        check_digits("orbits", "C4, pair, imaginary", rows[i].imaginary, orbit->multipliers[pair].imaginary);
        check_digits("orbits", "C4, third", rows[i].third, orbit->multipliers[other[0]].real);
        check_digits("orbits", "C4, fourth", rows[i].fourth, orbit->multipliers[other[1]].real);
        check_within("orbits", "C4, sum of logarithms", orbit->volume, sum_of_logarithms(orbit), 1e-9);
        if (rows[i].intervals > 0) check_holds("orbits", "C4, always touches", orbit->touches[0].share == 1.0);
        whirl_orbit_free(orbit);
        whirl_integrator_free(integrator);
        whirl_rotor_free(rotor);
    }
}

/// Synchronous full annular rub: a circle that turns with the shaft, whose largest exponent per unit of 1/omega_n is
/// printed.
static void multipliers_of_full_annular_rub(void **state) {
    static const char *const exponents[] = {"-.014538323", "-.008521731", ".130297887"};
    (void)state;
    for (size_t row = 0; row < 3; row++) {
        double x[MAX_DIMENSION] = {0.0};
        const rub_case rub = start_case_c2(row, x);
        const whirl_orbit_options options = whirl_orbit_default();
        whirl_rotor *rotor = make_rub_rotor(&rub);
        whirl_orbit *orbit;
        require_ok(whirl_orbit_find(whirl_rotor_system(rotor), x, 1, &options, &orbit));
        const double modulus = hypot(orbit->multipliers[0].real, orbit->multipliers[0].imaginary);
        check_digits("orbits", words("C2, row %zu: largest exponent", row + 1), exponents[row],
                     log(modulus) * rub.speed / (2.0 * pi));
        assert_int_equal(row == 2, orbit->unstable > 0);
        whirl_orbit_free(orbit);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- segments

/// The rotor of the paper has multipliers from 1 to 1e-19. Those that doubles resolve within one segment are the same
/// with any number of segments, and with eight the sum of all logarithms is the integral of the divergence.
static void segments_change_no_multiplier(void **state) {
    static const int segments[] = {2, 3, 8, 16};
    (void)state;
    whirl_rotor *rotor = make_paper_rotor(0.6);
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_orbit_options options = whirl_orbit_default();
    double x[MAX_DIMENSION] = {0.0};
    whirl_integrator *integrator = make_integrator(system, "dop853", 64);
    revolve(integrator, x, 300);
    whirl_orbit *one, *many;
    require_ok(whirl_orbit_find(system, x, 1, &options, &one));
    for (size_t i = 0; i < sizeof segments / sizeof *segments; i++) {
        options.segments = segments[i];
        x[0] = one->nodes[0] + 1e-3;
        require_ok(whirl_orbit_find(system, x, 1, &options, &many));
        double apart = 0.0, place = 0.0;
        for (size_t k = 0; k < one->multiplier_count; k++)
            apart = fmax(apart, hypot(one->multipliers[k].real - many->multipliers[k].real,
                                      one->multipliers[k].imaginary - many->multipliers[k].imaginary));
        for (size_t d = 0; d < one->dimension; d++) place = fmax(place, fabs(one->nodes[d] - many->nodes[d]));
        check_within("orbits", words("paper, %d segments: multipliers", segments[i]), 0.0, apart, 1e-10);
        check_within("orbits", words("paper, %d segments: the orbit", segments[i]), 0.0, place, 1e-11);
        if (segments[i] >= 8)
            check_within("orbits", words("paper, %d segments: sum of logarithms", segments[i]), many->volume,
                         sum_of_logarithms(many), 1e-4);
        whirl_orbit_free(many);
    }
    whirl_orbit_free(one);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- an orbit with a time of its own

/// Van der Pol's oscillator; p: mu.
static void van_der_pol(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double mu = *(const double *)model;
    (void)t, (void)f;
    dxdt[0] = x[1];
    dxdt[1] = mu * (1.0 - x[0] * x[0]) * x[1] - x[0];
}

static void van_der_pol_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                                size_t count, const double *u, double *out) {
    const double mu = *(const double *)model;
    (void)t, (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, u += 2, out += 2) {
        out[0] = u[1];
        out[1] = mu * (1.0 - x[0] * x[0]) * u[1] - (1.0 + 2.0 * mu * x[0] * x[1]) * u[0];
    }
}

static double van_der_pol_divergence(const void *model, double t, const double *f, const double *x,
                                     const double *sides) {
    (void)t, (void)f, (void)sides;
    return *(const double *)model * (1.0 - x[0] * x[0]);
}

static test_family van_der_pol_family(double mu) {
    return (test_family){.system = {.dimension = 2,
                                    .period = 1.0,
                                    .rhs = van_der_pol,
                                    .tangent = van_der_pol_tangent,
                                    .divergence = van_der_pol_divergence},
                         .p = {mu}};
}

static void period_of_van_der_pol(void **state) {
    static const struct {
        double mu;
        const char *period;
        double guess;
        int segments;
    } rows[] = {{1.0, "6.6632868593", 6.3, 1}, {1.0, "6.6632868593", 6.5, 4}, {5.0, "11.6122306677", 11.6, 8}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const test_family family = van_der_pol_family(rows[i].mu);
        const whirl_system system = system_of(&family);
        const double start[2] = {2.0, 0.0};
        whirl_orbit_options options = whirl_orbit_default();
        whirl_orbit *orbit;
        options.segments = rows[i].segments;
        require_ok(whirl_orbit_find_free(&system, start, rows[i].guess, &options, &orbit));
        check_digits("orbits", words("D4, mu = %g, %d segments: period", rows[i].mu, rows[i].segments), rows[i].period,
                     orbit->period);
        check_within("orbits", "D4, the multiplier of shifts", 1.0, orbit->multipliers[0].real, 1e-9);
        check_within("orbits", "D4, the other one's logarithm", orbit->volume, log(fabs(orbit->multipliers[1].real)),
                     1e-6);
        check_within("orbits", "D4, the largest modulus but that of shifts", exp(orbit->volume),
                     whirl_orbit_largest(orbit), 1e-9);
        assert_int_equal(0, orbit->unstable);
        whirl_orbit_free(orbit);
    }
}

// ---------------------------------------------------------------- what cannot be found

static void other_motions_are_no_orbits(void **state) {
    (void)state;
    test_family family = duffing_family(1.0);
    const whirl_system system = system_of(&family);
    whirl_orbit_options options = whirl_orbit_default();
    whirl_orbit *orbit = NULL;
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_find(&system, family.start, 0, &options, &orbit).code);
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_find(&system, family.start, 65, &options, &orbit).code);
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_find_free(&system, family.start, -1.0, &options, &orbit).code);
    options.segments = 0;
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_find(&system, family.start, 1, &options, &orbit).code);
    options = whirl_orbit_default();
    options.most_steps = 1;
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_find(&system, family.start, 1, &options, &orbit).code);
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_find_free(&system, family.start, 6.0, &options, &orbit).code);
    // From here Newton's method comes to the equilibrium, which closes after any time.
    const test_family free = van_der_pol_family(1.0);
    const whirl_system oscillator = system_of(&free);
    const double start[2] = {2.0, 0.0};
    options = whirl_orbit_default();
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_find_free(&oscillator, start, 4.75, &options, &orbit).code);
    assert_null(orbit);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(duffing_has_the_printed_states), cmocka_unit_test(multipliers_of_mathieu),
        cmocka_unit_test(multipliers_of_unequal_shaft),   cmocka_unit_test(multipliers_of_the_film_circle),
        cmocka_unit_test(multipliers_of_rub_orbits),      cmocka_unit_test(multipliers_of_full_annular_rub),
        cmocka_unit_test(segments_change_no_multiplier),  cmocka_unit_test(period_of_van_der_pol),
        cmocka_unit_test(other_motions_are_no_orbits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
