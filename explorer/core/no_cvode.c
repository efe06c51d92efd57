// The methods of SUNDIALS are known here by name, so that cases that ask for them are read; they cannot start.
#include "method.h"

static whirl_status start(whirl_integrator *integrator) {
    return whirl_fail(WHIRL_BAD_INPUT, "method %s needs SUNDIALS, which the explorer does not have; take dop853",
                      integrator->method->about.name);
}

static whirl_motion revolve(whirl_integrator *integrator, double *x, whirl_disturbances *disturbances,
                            whirl_observe_fn observe, void *observer) {
    (void)integrator, (void)x, (void)disturbances, (void)observe, (void)observer;
    return WHIRL_STUCK;
}

static void end(whirl_integrator *integrator) {
    (void)integrator;
}

const method cvode_adams_method = {
    .about = {"cvode-adams", "not in the explorer", true}, .start = start, .revolve = revolve, .end = end};
const method cvode_bdf_method = {
    .about = {"cvode-bdf", "not in the explorer", true}, .start = start, .revolve = revolve, .end = end};
