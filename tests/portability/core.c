// The core of whirl on a C library other than glibc: forces and motions compared with closed forms.
#include <math.h>
#include <stdio.h>

#include "whirl/engine/integrate.h"
#include "whirl/engine/rotor.h"

static int failures;

static void expect(const char *what, double found, double expected, double tolerance) {
    if (fabs(found - expected) <= tolerance) return;
    fprintf(stderr, "%s is %.17g, expected %.17g within %g\n", what, found, expected, tolerance);
    failures++;
}

/// x'' = -x + 3 cos 2t with x(0) = 0, x'(0) = 1: x = cos t - cos 2t + sin t.
static void oscillator(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -x[0] + 3 * cos(2 * t);
}

/// Errors of 100 periods at the methods' tolerances.
static void carry(const char *method, double tolerance) {
    const whirl_system system = {.dimension = 2, .period = 2 * acos(-1.0), .rhs = oscillator};
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    double x[] = {0, 1};
    snprintf(options.method, sizeof options.method, "%s", method);
    options.rtol = 1e-10;
    const whirl_status status = whirl_integrator_new(&system, &options, &integrator);
    if (status.code != WHIRL_OK) {
        fprintf(stderr, "%s\n", status.message);
        failures++;
        return;
    }
    for (int i = 0; i < 100; i++) whirl_integrator_revolve(integrator, x, NULL, NULL);
    whirl_integrator_free(integrator);
    expect(method, x[0], 0, tolerance);
    expect(method, x[1], 1, tolerance);
}

/// Capone's film of a journal at rest at e = 0.5 with F0 = 1: case A2 of the verification manual.
static void film(void) {
    double force[2];
    whirl_film_force(0.5, 0, 0, 0, force);
    expect("the film's radial force", force[0], -16.0 / 9, 1e-6);
    expect("the film's tangential force", force[1], 4 * acos(-1.0) / (3 * sqrt(3.0)), 1e-6);
}

int main(void) {
    film();
    carry("rk4", 1e-6);
    carry("dop853", 1e-6);
    carry("rodas5p", 1e-6);
    if (failures == 0) puts("the film and three methods agree with closed forms");
    return failures > 0;
}
