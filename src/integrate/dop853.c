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

enum { DISTURBANCE_ROWS = DOP853_STAGES + 2 };

static void set_variation(const whirl_integrator *integrator, whirl_disturbances *disturbances) {
    carrier_variation *v = &((carrier *)integrator->workspace)->variation;
    const size_t row = integrator->most_disturbances * integrator->system->dimension;
    v->set = disturbances;
    if (!disturbances) return;
    for (size_t i = 0; i < DOP853_STAGES; i++) v->k[i] = integrator->slopes + i * row;
    v->stage = integrator->slopes + DOP853_STAGES * row;
    v->upper = v->stage + row;
    v->spare = integrator->slopes + DISTURBANCE_ROWS * row;
}

static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_disturbances *disturbances,
                            whirl_observe_fn observe, void *observer) {
    carrier *c = integrator->workspace;
    const double period = integrator->system->period;
    const int instants = integrator->options.steps_per_revolution;
    double *seen = c->end;
    int instant = 1;
    c->observed = observe != NULL;
    set_variation(integrator, disturbances);
    whirl_motion motion = carrier_begin(c, integrator->system, x);
    if (motion == WHIRL_BOUNDED) carrier_vary_begin(c);
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
    .disturbance_rows = DISTURBANCE_ROWS,
    .end = end,
};
