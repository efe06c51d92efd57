// The observed order of RK4 on smooth systems is four.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "support_rotor.h"

static const double pi = 3.14159265358979323846;

enum { LEVELS = 4 };

/// Computes the state after the revolutions at that many steps each.
static void end_state(const whirl_system *system, const double *start, int steps, int revolutions, double *end) {
    whirl_integrator *integrator = make_integrator(system, "rk4", steps);
    memcpy(end, start, system->dimension * sizeof *end);
    revolve(integrator, end, revolutions);
    whirl_integrator_free(integrator);
}

static double distance(size_t n, const double *a, const double *b) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum);
}

/// Halves the step from `coarsest` on and compares log2 of the ratio of successive differences with 4.
static void check_order(const char *name, const whirl_system *system, const double *start, int coarsest,
                        int revolutions) {
    double ends[LEVELS][MAX_DIMENSION];
    for (int i = 0; i < LEVELS; i++) end_state(system, start, coarsest << i, revolutions, ends[i]);
    for (int i = 0; i + 2 < LEVELS; i++) {
        const double coarse = distance(system->dimension, ends[i], ends[i + 1]);
        const double fine = distance(system->dimension, ends[i + 1], ends[i + 2]);
        check_within("RK4", words("order on the %s, %d to %d steps", name, coarsest << i, coarsest << (i + 2)), 4.0,
                     log2(coarse / fine), 0.05);
    }
}

static void harmonic_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -x[0];
}

static void order_on_a_harmonic_oscillator(void **unused) {
    (void)unused;
    const whirl_system system = {.dimension = 2, .period = 6.28318530717958647692, .rhs = harmonic_rhs};
    const double start[2] = {1.0, 0.0};
    double end[2];
    check_order("harmonic oscillator", &system, start, 64, 5);
    // One step multiplies x + iy-like pairs by a polynomial whose phase lags by h^5/120: after 10 pi by 10 pi h^4/120.
    const double h = 2.0 * pi / 256.0;
    end_state(&system, start, 256, 5, end);
    check_within("RK4", "phase error on the harmonic oscillator after 10 pi, over 10 pi h^4/120", 1.0,
                 fabs(atan2(end[1], end[0])) / (10.0 * pi * pow(h, 4.0) / 120.0), 0.01);
    // ... and shrinks by h^6/144 a step.
    check_within("RK4", "loss of amplitude after 10 pi, over 10 pi h^5/144", 1.0,
                 (1.0 - hypot(end[0], end[1])) / (10.0 * pi * pow(h, 5.0) / 144.0), 0.01);
}

static void mathieu_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -(2.0 - cos(2.0 * t)) * x[0];
}

static void order_on_mathieu(void **unused) {
    (void)unused;
    const whirl_system system = {.dimension = 2, .period = 3.14159265358979323846, .rhs = mathieu_rhs};
    const double start[2] = {1.0, 0.5};
    check_order("Mathieu equation", &system, start, 64, 4);
}

static void order_on_a_rotor_in_a_film(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_film_rotor(0.2, 0.1, 0.3);
    const double start[4] = {0.1, -0.2, 0.0, 0.0};
    check_order("rotor in a film", whirl_rotor_system(rotor), start, 256, 2);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_on_a_harmonic_oscillator),
        cmocka_unit_test(order_on_mathieu),
        cmocka_unit_test(order_on_a_rotor_in_a_film),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
