// The observed order of dop853 is eight, across contacts and reversals of sharp friction as well.
//
// Steps are at most an eighth of a period long where there are switches. A tolerance that nothing exceeds makes them exactly that, so
// that the same motion in twice as many periods, half as long, runs on half the step.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"

static const double pi = 3.14159265358979323846;

enum { LEVELS = 3 };

/// The state after `duration`, in that many periods.
static void end_state(whirl_system system, const double *start, double duration, int periods, double *end) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    system.period = duration / periods;
    snprintf(options.method, sizeof options.method, "dop853");
    options.rtol = 1e3;
    options.atol = 1e-3;
    require_ok(whirl_integrator_new(&system, &options, &integrator));
    memcpy(end, start, system.dimension * sizeof *end);
    revolve(integrator, end, periods);
    whirl_integrator_free(integrator);
}

/// Errors of the first coordinate fall by 2^8 when steps are halved.
static void check_order(const char *name, const whirl_system *system, const double *start, double duration,
                        int coarsest, double exact) {
    double errors[LEVELS], end[2];
    for (int i = 0; i < LEVELS; i++) {
        end_state(*system, start, duration, coarsest << i, end);
        errors[i] = fabs(end[0] - exact);
    }
    check_within("dop853",
                 words("order on the %s, from steps of %.2g to steps of %.2g", name, duration / coarsest / 8.0,
                       duration / (coarsest << (LEVELS - 1)) / 8.0),
                 8.0, log2(errors[0] / errors[LEVELS - 1]) / (LEVELS - 1), 0.5);
    check_holds("dop853", words("the error on the %s falls at every halving", name),
                errors[1] < errors[0] / 50.0 && errors[2] < errors[1] / 50.0);
}

// ---------------------------------------------------------------- a spring with a stop

/// x'' = -x - stiffness (x - gap) [x > gap].
static const double gap = 0.5, stiffness = 8.0;

static void stop_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                          double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -x[0] - (sides[0] > 0.0 ? stiffness * (x[0] - gap) : 0.0);
}
static void stop_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double side = x[0] - gap;
    stop_on_sides(model, t, forcing, x, &side, dxdt);
}
static void stop_switch(const void *model, double t, const double *x, double *values) {
    (void)model, (void)t;
    values[0] = x[0] - gap;
}

static void order_across_contacts(void **unused) {
    (void)unused;
    const whirl_system system = {
        .dimension = 2, .rhs = stop_rhs, .rhs_on_sides = stop_on_sides, .switch_count = 1, .switches = stop_switch};
    // From x = -1 to the gap as -cos t; in contact about gap stiffness/w^2 with frequency w for `contact`; then away again.
    const double start[2] = {-1.0, 0.0}, speed = sqrt(1.0 - gap * gap), flight = pi - acos(gap);
    const double w = sqrt(1.0 + stiffness), shift = gap / (w * w);
    const double contact = 2.0 * (pi / 2.0 - atan2(shift * w, speed)) / w, after = 1.2;
    check_order("spring with a stop", &system, start, flight + contact + after, 2, cos(acos(gap) + after));
}

// ---------------------------------------------------------------- a block with sharp friction

/// x'' = -x - friction sgn x'.
static const double friction = 0.15;

static void block_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                           double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -x[0] - friction * sides[0];
}
static void block_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double side = x[1] > 0.0 ? 1.0 : -1.0;
    block_on_sides(model, t, forcing, x, &side, dxdt);
}
static void block_switch(const void *model, double t, const double *x, double *values) {
    (void)model, (void)t;
    values[0] = x[1];
}

static void order_across_reversals(void **unused) {
    (void)unused;
    const whirl_system system = {
        .dimension = 2, .rhs = block_rhs, .rhs_on_sides = block_on_sides, .switch_count = 1, .switches = block_switch};
    // Two half swings take 2 friction off the amplitude each; the third, from 0.4 about 0.15, ends before it stops.
    const double start[2] = {1.0, 0.0}, after = 0.8;
    check_order("block with sharp friction", &system, start, 2.0 * pi + after, 1, friction + 0.25 * cos(after));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_across_contacts),
        cmocka_unit_test(order_across_reversals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
