// Properties of a single state: the divergence of the flow there, and whether the motion is still bounded.
#include <math.h>

#include "method.h"

double divergence_at(const whirl_system *system, double t, const double *forcing, const double *x,
                     const double *sides) {
    return system->divergence ? system->divergence(system->model, t, forcing, x, sides) : NAN;
}

whirl_motion state_motion(const whirl_integrator *integrator, const double *x) {
    for (size_t i = 0; i < integrator->system->dimension; i++)
        if (!(fabs(x[i]) <= integrator->options.limit)) return WHIRL_DIVERGED; // NaN too
    return WHIRL_BOUNDED;
}
