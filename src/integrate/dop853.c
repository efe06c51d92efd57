// The pair of Dormand and Prince of orders 8(5,3) with located switches, for one machine.
//
// Every revolution begins with a length of step that depends on its first state alone, so that nothing is remembered from one
// call to the next.
#include <stdlib.h>
#include <string.h>

#include "carrier.h"
#include "method.h"

static whirl_status start(whirl_integrator *integrator) {
    integrator->workspace =
        carrier_new(integrator->system->dimension, integrator->system->switch_count, &integrator->options);
    return integrator->workspace ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for dop853");
}

static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_observe_fn observe, void *observer) {
    carrier *c = integrator->workspace;
    const double period = integrator->system->period;
    const int instants = integrator->options.steps_per_revolution;
    double *seen = c->end;
    int instant = 1;
    c->observed = observe != NULL;
    whirl_motion motion = carrier_begin(c, integrator->system, x);
    while (motion == WHIRL_BOUNDED && c->t < period) {
        motion = carrier_step(c, period);
        for (; motion == WHIRL_BOUNDED && observe && instant < instants; instant++) {
            const double t = period * ((double)instant / instants);
            if (t > c->t) break;
            carrier_between(c, (t - c->begin) / c->length, seen);
            observe(observer, t, seen);
        }
    }
    memcpy(x, c->x, c->dimension * sizeof *x);
    if (motion == WHIRL_BOUNDED && observe) observe(observer, period, x);
    return motion;
}

static void end(whirl_integrator *integrator) {
    free(integrator->workspace);
}

const method dop853_method = {
    .about = {"dop853", "Dormand-Prince of order 8(5,3), steps by the tolerance, contacts located", true},
    .start = start,
    .revolve = revolve,
    .end = end,
};
