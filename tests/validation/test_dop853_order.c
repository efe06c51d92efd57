// The observed order of dop853 is eight and that of rodas5p five, across contacts and reversals of sharp friction as
// well.
//
// Systems with switches are integrated in steps of at most an eighth of the period. A tolerance so loose that no error
// exceeds it gives steps of exactly that length. The same motion in twice as many periods, each half as long, then has
// steps of half the length.
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

/// Computes the state after `duration`, in `periods` periods.
static void end_state(const char *method, whirl_system system, const double *start, double duration, int periods,
                      double *end) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    system.period = duration / periods;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.rtol = 1.0;
    options.atol = 1e3; // no step is refused
    require_ok(whirl_integrator_new(&system, &options, &integrator));
    memcpy(end, start, system.dimension * sizeof *end);
    revolve(integrator, end, periods);
    whirl_integrator_free(integrator);
}

/// A motion that is known until some time after its last switch.
typedef struct known_motion {
    const char *name;
    whirl_system system;
    double start[2], last_switch;
    double (*position)(double after);
} known_motion;

static const struct tested_method {
    const char *name;
    double order;
    int periods[LEVELS];
    double least[LEVELS - 1]; ///< factors by which the error falls from one level to the next
} methods[] = {{"dop853", 8.0, {2, 3, 4}, {100.0, 30.0}}, {"rodas5p", 5.0, {8, 16, 32}, {15.0, 15.0}}};
enum { METHODS = sizeof methods / sizeof *methods };

/// Checks that errors decrease with that power of the step: their root mean square over motions of different lengths,
/// since the place of switches within steps matters, too.
static void check_order_of(const struct tested_method *method, const known_motion *motion) {
    double errors[LEVELS] = {0}, end[2];
    for (double after = 0.4; after < 1.4; after += 0.05)
        for (int i = 0; i < LEVELS; i++) {
            end_state(method->name, motion->system, motion->start, motion->last_switch + after, method->periods[i],
                      end);
            const double error = end[0] - motion->position(after);
            errors[i] += error * error;
        }
    const int *n = method->periods;
    check_within(method->name, words("order on the %s, from %d to %d steps", motion->name, 8 * n[0], 8 * n[LEVELS - 1]),
                 method->order, 0.5 * log2(errors[0] / errors[LEVELS - 1]) / log2((double)n[LEVELS - 1] / n[0]), 0.5);
    check_holds(method->name, words("the error on the %s falls with every refinement", motion->name),
                errors[1] < errors[0] / method->least[0] && errors[2] < errors[1] / method->least[1]);
}

static void check_order(const known_motion *motion) {
    for (int m = 0; m < METHODS; m++) check_order_of(&methods[m], motion);
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

static double velocity_at_the_stop(double after) {
    return cos(acos(gap) + after);
}

static void order_across_contacts(void **unused) {
    (void)unused;
    // From x = -1 to the gap as -cos t; in contact about gap stiffness/w^2 with frequency w; then away again.
    const double speed = sqrt(1.0 - gap * gap), w = sqrt(1.0 + stiffness), shift = gap / (w * w);
    const double flight = pi - acos(gap), contact = 2.0 * (pi / 2.0 - atan2(shift * w, speed)) / w;
    check_order(&(known_motion){.name = "spring with a stop",
                                .system = {.dimension = 2,
                                           .rhs = stop_rhs,
                                           .rhs_on_sides = stop_on_sides,
                                           .switch_count = 1,
                                           .switches = stop_switch},
                                .start = {-1.0, 0.0},
                                .last_switch = flight + contact,
                                .position = velocity_at_the_stop});
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

static double third_swing(double after) {
    return friction + 0.25 * cos(after);
}

static void order_across_reversals(void **unused) {
    (void)unused;
    // Two half swings take 2 friction off the amplitude each; the third, from 0.4 about 0.15, ends before it stops.
    check_order(&(known_motion){.name = "block with sharp friction",
                                .system = {.dimension = 2,
                                           .rhs = block_rhs,
                                           .rhs_on_sides = block_on_sides,
                                           .switch_count = 1,
                                           .switches = block_switch},
                                .start = {1.0, 0.0},
                                .last_switch = 2.0 * pi,
                                .position = third_swing});
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_across_contacts),
        cmocka_unit_test(order_across_reversals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
