// Discs that tilt: an overhung wheel against the closed form of Stodola and Green, and a rotor of three discs against
// its equations written out in complex numbers and integrated by other steps.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- the overhung wheel

enum { WHEEL_DEGREES = 4, WHEEL_DIMENSION = 2 * WHEEL_DEGREES };

typedef struct wheel {
    double mass, diametral, polar, bending, length, speed;
} wheel;

static whirl_rotor *make_wheel(const wheel *w) {
    const whirl_setting disc[] = {
        {"mass", w->mass, NULL}, {"diametral", w->diametral, NULL}, {"polar", w->polar, NULL}};
    const whirl_setting beam[] = {
        {"between", 0, "ground, wheel"}, {"length", w->length, NULL}, {"bending", w->bending, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(w->speed, 1e-4, &design));
    require_ok(whirl_design_station(design, "wheel", disc, 3));
    require_ok(whirl_design_element(design, "beam", beam, 3));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Writes the magnitudes of the imaginary parts of the eigenvalues at rest, which are the natural frequencies over the
/// speed, each twice; returns the largest real part.
static double natural_orders(const whirl_system *system, double orders[WHEEL_DIMENSION]) {
    double rest[WHEEL_DIMENSION] = {0}, matrix[WHEEL_DIMENSION * WHEEL_DIMENSION], most = 0.0;
    double complex values[WHEEL_DIMENSION];
    assert_int_equal(system->dimension, WHEEL_DIMENSION);
    exact_jacobian(system, 0.0, rest, matrix);
    eigenvalues(WHEEL_DIMENSION, matrix, values);
    for (int i = 0; i < WHEEL_DIMENSION; i++) {
        most = fmax(most, fabs(creal(values[i])));
        orders[i] = fabs(cimag(values[i]));
    }
    return most;
}

/// Returns (k11 - m nu^2)(k22 - I_d nu^2 + I_p omega nu) - k12^2, whose zeros are the frequencies of whirl, backward
/// ones below zero (Green 1948; Den Hartog 1956, sec. 6.7).
static double stodola_green(const wheel *w, double nu) {
    const double k = w->bending / (w->length * w->length * w->length);
    const double k11 = 12.0 * k, k12 = 6.0 * k * w->length, k22 = 4.0 * k * w->length * w->length;
    return (k11 - w->mass * nu * nu) * (k22 - w->diametral * nu * nu + w->polar * w->speed * nu) - k12 * k12;
}

/// Returns the zero between two places of different signs.
static double zero_between(const wheel *w, double low, double high) {
    for (int i = 0; i < 200; i++) {
        const double middle = 0.5 * (low + high);
        *((stodola_green(w, low) > 0.0) == (stodola_green(w, middle) > 0.0) ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static void the_overhung_wheel(void **unused) {
    (void)unused;
    double worst = 0.0, damped = 0.0;
    for (int n = 1; n <= 8; n++) {
        const wheel w = {
            .mass = 16.0, .diametral = 0.12, .polar = 0.23, .bending = 8000.0, .length = 0.4, .speed = 100.0 * n};
        double orders[WHEEL_DIMENSION], expected[4];
        whirl_rotor *rotor = make_wheel(&w);
        damped = fmax(damped, natural_orders(whirl_rotor_system(rotor), orders));
        int count = 0;
        const double step = 0.5;
        for (double nu = -8000.0; nu < 8000.0; nu += step)
            if ((stodola_green(&w, nu) > 0.0) != (stodola_green(&w, nu + step) > 0.0) && count < 4)
                expected[count++] = fabs(zero_between(&w, nu, nu + step)) / w.speed;
        assert_int_equal(count, 4);
        for (int i = 0; i < 4; i++) {
            double nearest = INFINITY;
            for (int k = 0; k < WHEEL_DIMENSION; k++)
                nearest = fmin(nearest, fabs(orders[k] - expected[i]) / expected[i]);
            worst = fmax(worst, nearest);
        }
        whirl_rotor_free(rotor);
    }
    check_within("Discs", "overhung wheel: natural frequencies at 8 speeds, largest relative difference", 0.0, worst,
                 1e-11);
    check_within("Discs", "overhung wheel: largest real part, of no damping", 0.0, damped, 1e-10);
}

// ---------------------------------------------------------------- three discs

enum { DISCS = 3, EQUATIONS = 4 * DISCS };

static const double speed = 310.0, scale = 1e-4, bending = 6000.0, damping = 120.0, gravity = 9.81;
static const double mass[DISCS] = {9.0, 14.0, 6.0}, polar[DISCS] = {0.08, 0.2, 0.05},
                    diametral[DISCS] = {0.05, 0.11, 0.03};
static const double part[DISCS] = {0.25, 0.3, 0.2}; // lengths of the beams, from the clamp on
static const double eccentricity[DISCS] = {2e-5, 0.0, 1e-5}, skew[DISCS] = {0.0, 1e-4, 0.0}, lean = 0.7;

static whirl_rotor *make_three(void) {
    static const char *const names[DISCS] = {"a", "b", "c"}, *const spans[DISCS] = {"ground, a", "a, b", "b, c"};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, scale, &design));
    for (int i = 0; i < DISCS; i++) {
        const whirl_setting disc[] = {{"mass", mass[i], NULL},   {"diametral", diametral[i], NULL},
                                      {"polar", polar[i], NULL}, {"eccentricity", eccentricity[i], NULL},
                                      {"skew", skew[i], NULL},   {"skew_angle", lean, NULL},
                                      {"damping", damping, NULL}};
        require_ok(whirl_design_station(design, names[i], disc, 7));
    }
    for (int i = 0; i < DISCS; i++) {
        const whirl_setting beam[] = {{"between", 0, spans[i]}, {"length", part[i], NULL}, {"bending", bending, NULL}};
        require_ok(whirl_design_element(design, "beam", beam, 3));
    }
    require_ok(whirl_design_element(design, "gravity", (whirl_setting[]){{"acceleration", gravity, NULL}}, 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// In seconds, metres and radians: u = z and phi of every disc, then their velocities. The beams' forces by their
/// energy in the deflection of one end from the tangent at the other, r = z2 - z1 - L phi1 and s = phi2 - phi1: 6 E I
/// r^2/L^3 - 6 E I r s/L^2 + 2 E I s^2/L.
static void three_discs(double t, const double complex *u, double complex *slope) {
    const double complex turning = cexp(I * speed * t);
    double complex force[DISCS], moment[DISCS];
    for (int i = 0; i < DISCS; i++) {
        const double complex v = u[2 * DISCS + 2 * i], w = u[2 * DISCS + 2 * i + 1];
        force[i] = mass[i] * eccentricity[i] * speed * speed * turning - I * mass[i] * gravity - damping * v;
        moment[i] =
            I * polar[i] * speed * w + (diametral[i] - polar[i]) * speed * speed * skew[i] * cexp(I * lean) * turning;
    }
    for (int i = 0; i < DISCS; i++) {
        const double L = part[i];
        const double complex z1 = i > 0 ? u[2 * i - 2] : 0.0, phi1 = i > 0 ? u[2 * i - 1] : 0.0;
        const double complex r = u[2 * i] - z1 - L * phi1, s = u[2 * i + 1] - phi1;
        const double complex by_r = bending * (12.0 * r / (L * L * L) - 6.0 * s / (L * L));
        const double complex by_s = bending * (4.0 * s / L - 6.0 * r / (L * L));
        force[i] -= by_r;
        moment[i] -= by_s;
        if (i == 0) continue;
        force[i - 1] += by_r;
        moment[i - 1] += L * by_r + by_s;
    }
    for (int i = 0; i < DISCS; i++) {
        slope[2 * i] = u[2 * DISCS + 2 * i];
        slope[2 * i + 1] = u[2 * DISCS + 2 * i + 1];
        slope[2 * DISCS + 2 * i] = force[i] / mass[i];
        slope[2 * DISCS + 2 * i + 1] = moment[i] / diametral[i];
    }
}

/// Integrates the three discs from rest over `revolutions` by the classical method.
static void integrate_three(int revolutions, int steps, double complex *u) {
    const double h = 2.0 * pi / (speed * steps);
    double complex k[4][EQUATIONS], stage[EQUATIONS];
    for (long n = 0; n < (long)revolutions * steps; n++) {
        const double t = (double)n * h;
        three_discs(t, u, k[0]);
        for (int i = 0; i < EQUATIONS; i++) stage[i] = u[i] + 0.5 * h * k[0][i];
        three_discs(t + 0.5 * h, stage, k[1]);
        for (int i = 0; i < EQUATIONS; i++) stage[i] = u[i] + 0.5 * h * k[1][i];
        three_discs(t + 0.5 * h, stage, k[2]);
        for (int i = 0; i < EQUATIONS; i++) stage[i] = u[i] + h * k[2][i];
        three_discs(t + h, stage, k[3]);
        for (int i = 0; i < EQUATIONS; i++) u[i] += h / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
    }
}

static void carry_three(const char *method, double tolerance) {
    enum { REVOLUTIONS = 5 };
    whirl_rotor *rotor = make_three();
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    double x[8 * DISCS] = {0}, worst = 0.0, size = 0.0;
    double complex u[EQUATIONS] = {0};
    char what[96];
    strcpy(options.method, method);
    options.steps_per_revolution = 4096;
    options.rtol = 1e-12;
    options.atol = 1e-14;
    assert_int_equal(system->dimension, 8 * DISCS);
    require_ok(whirl_integrator_new(system, &options, &integrator));
    for (int i = 0; i < REVOLUTIONS; i++)
        assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
    integrate_three(REVOLUTIONS, 16384, u);
    for (int i = 0; i < DISCS; i++) {
        const whirl_probe *probe = &system->probes[i];
        size = fmax(size, cabs(u[2 * i]) / scale);
        worst = fmax(worst, cabs(u[2 * i] / scale - (x[probe->x] + I * x[probe->y])));
        worst = fmax(worst, cabs(u[2 * DISCS + 2 * i] / (scale * speed) - (x[probe->vx] + I * x[probe->vy])));
    }
    assert_true(size > 0.1);
    snprintf(what, sizeof what, "three discs after %d revolutions by %s, in length scales", REVOLUTIONS, method);
    check_within("Discs", what, 0.0, worst, tolerance);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

static void three_discs_alone(void **unused) {
    (void)unused;
    carry_three("dop853", 1e-9);
    carry_three("rk4", 1e-9);
}

/// In lanes, where coordinates of stations and tilts are carried alike.
static void three_discs_in_lanes(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853"};
    whirl_rotor *rotor = make_three();
    for (int m = 0; m < 2; m++) {
        whirl_integrate_options options = whirl_integrate_default();
        whirl_ensemble *ensemble;
        double x[8 * DISCS] = {0}, worst = 0.0;
        double complex u[EQUATIONS] = {0};
        strcpy(options.method, methods[m]);
        options.steps_per_revolution = 4096;
        options.rtol = 1e-12;
        options.atol = 1e-14;
        require_ok(whirl_ensemble_new(whirl_rotor_system(rotor), &options, 3, &ensemble));
        for (size_t l = 0; l < 3; l++) require_ok(whirl_ensemble_load(ensemble, l, whirl_rotor_system(rotor), x));
        for (int i = 0; i < 3; i++) whirl_ensemble_revolve(ensemble, 3, NULL);
        whirl_ensemble_state(ensemble, 2, x);
        integrate_three(3, 16384, u);
        for (int i = 0; i < DISCS; i++) {
            const whirl_probe *probe = &whirl_rotor_system(rotor)->probes[i];
            worst = fmax(worst, cabs(u[2 * i] / scale - (x[probe->x] + I * x[probe->y])));
        }
        check_within("Discs", m == 0 ? "the same in lanes by rk4" : "the same in lanes by dop853", 0.0, worst, 1e-9);
        whirl_ensemble_free(ensemble);
    }
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_overhung_wheel), cmocka_unit_test(three_discs_alone),
                                       cmocka_unit_test(three_discs_in_lanes)};
    return cmocka_run_group_tests_name("discs", tests, NULL, NULL);
}
