// The methods that carry one machine with located switches: that of Dormand and Prince of orders 8(5,3), Rodas5P, and
// RK4 on a fixed grid, whose steps are split where they meet a switch.
//
// The first step of every revolution of an adaptive method has a length that depends on the first state alone: nothing
// is remembered from one call to the next.
#include <stdlib.h>
#include <string.h>

#include "method.h"
#include "stepper.h"
#include "stepper_parts.h"

static whirl_status stepper_start(whirl_integrator *integrator) {
    integrator->workspace = stepper_new(integrator->method->lanes, integrator->system, &integrator->options);
    return integrator->workspace ? whirl_ok()
                                 : whirl_fail(WHIRL_NO_MEMORY, "no memory for %s", integrator->method->about.name);
}

static void set_variation(const whirl_integrator *integrator, whirl_perturbations *perturbations) {
    stepper *c = integrator->workspace;
    c->variation.set = perturbations;
    if (perturbations) stepper_follow(c, integrator->most_perturbations, integrator->slopes);
}

static whirl_motion stepper_begin_motion(whirl_integrator *integrator, const double *x,
                                         whirl_perturbations *perturbations) {
    stepper *c = integrator->workspace;
    set_variation(integrator, perturbations);
    const whirl_motion motion = stepper_begin(c, integrator->system, x);
    if (motion == WHIRL_BOUNDED) stepper_vary_begin(c);
    return motion;
}

/// Reports the instants from `instant` on up to the motion's time. Returns the next instant.
static int stepper_report(stepper *c, double period, int instants, int instant, whirl_observe_fn observe,
                          void *observer) {
    for (; instant <= instants; instant++) {
        const double t = period * ((double)instant / instants);
        if (t > c->t) return instant;
        if (observe && t < c->t) {
            stepper_interpolate(c);
            stepper_between(c, (t - c->begin) / c->length, c->stage);
        }
        if (observe) observe(observer, t, t < c->t ? c->stage : c->x);
    }
    return instant;
}

/// Returns true if a revolution must end early.
static bool is_cut_short(const whirl_integrator *integrator) {
    const stepper *c = integrator->workspace;
    return whirl_stop_is_set(integrator->system->stop) ||
           (integrator->most_steps > 0 && c->tried >= integrator->most_steps);
}

/// Carries x over a revolution. Steps of rk4 end at every instant. Steps of adaptive methods do so only if
/// perturbations are observed at instants.
static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                            whirl_observe_fn observe, void *observer) {
    stepper *c = integrator->workspace;
    const double period = integrator->system->period;
    const int instants = integrator->options.steps_per_revolution;
    const bool halts = !c->slot || (perturbations && perturbations->at_instants);
    int instant = 1;
    c->observed = c->slot && observe;
    c->eager = perturbations != NULL; // perturbations use the memory of the interpolant's slopes
    c->halts = c->slot && halts;
    whirl_motion motion = stepper_begin_motion(integrator, x, perturbations);
    while (motion == WHIRL_BOUNDED && c->t < period && !is_cut_short(integrator)) {
        motion = stepper_step(c, halts ? period * ((double)instant / instants) : period);
        if (motion == WHIRL_BOUNDED && (observe || halts))
            instant = stepper_report(c, period, instants, instant, observe, observer);
    }
    memcpy(x, c->x, c->dimension * sizeof *x);
    return motion;
}

size_t whirl_integrator_steps(const whirl_integrator *integrator) {
    return integrator->method->lanes ? ((const stepper *)integrator->workspace)->tried : 0;
}

static void stepper_end(whirl_integrator *integrator) {
    stepper_free(integrator->workspace);
}

/// Returns the work of all steps, in evaluations of the right-hand side. A step of n coordinates counts as 10 for its
/// stages, n for its Jacobian, and n^2/100 for the solution of its equations (measured).
static double rodas5p_work(const whirl_integrator *integrator) {
    const double n = (double)integrator->system->dimension;
    return (double)((const stepper *)integrator->workspace)->tried * (10.0 + n + 0.01 * n * n);
}

const method auto_method = {
    .about = {"auto", "the method that suits the machine: dop853, or rodas5p where dop853 would need very many steps",
              true, true, false},
    .start = stepper_start,
    .revolve = revolve,
    .rows = PERTURBATION_ROWS,
    .end = stepper_end,
    .lanes = &dop853_in_lanes,
};

const method dop853_method = {
    .about = {"dop853", "Dormand-Prince of order 8(5,3), steps by the tolerance, contacts located", true, true, false},
    .start = stepper_start,
    .revolve = revolve,
    .rows = PERTURBATION_ROWS,
    .end = stepper_end,
    .lanes = &dop853_in_lanes,
};

const method rodas5p_method = {
    .about = {"rodas5p", "Rosenbrock-Wanner of order 5(4) for stiff machines, steps by the tolerance, contacts located",
              true, true, false},
    .start = stepper_start,
    .revolve = revolve,
    .rows = PERTURBATION_ROWS,
    .end = stepper_end,
    .lanes = &rodas5p_in_lanes,
    .work = rodas5p_work,
};

const method rk4_located_method = {
    .about = {"rk4", "Runge-Kutta of order 4, fixed steps that are split at contacts", false, true, false},
    .start = stepper_start,
    .revolve = revolve,
    .rows = PERTURBATION_ROWS,
    .end = stepper_end,
    .amplification = rk4_amplification,
};
