// The equations of motion of a rotor in SI, for programs with their own integrators.
#include "whirl/engine/rotor.h"

#include <math.h>

whirl_status whirl_rotor_rates(const whirl_rotor *rotor, double t, const double *x, double *dxdt) {
    const whirl_system *system = whirl_rotor_system(rotor);
    const size_t half = system->dimension / 2;
    if (system->dimension != 4 * system->probe_count)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the rotor has %zu states, expected x and y of its %zu stations and their velocities alone: "
                          "tilts, turning phases and nodes of shafts have no place here",
                          system->dimension, system->probe_count);
    const double length = whirl_rotor_length_scale(rotor), clock = whirl_rotor_clock(rotor);
    double forcing[WHIRL_MAX_FORCING] = {0}, scaled[4 * WHIRL_MAX_PROBES];
    for (size_t i = 0; i < half; ++i) scaled[i] = x[i] / length;
    for (size_t i = half; i < 2 * half; ++i) scaled[i] = x[i] / (length * clock);
    double tau = fmod(clock * t, system->period);
    if (tau < 0.0) tau += system->period;
    if (system->forcing_count > 0) system->forcing(system->model, tau, forcing);
    system->rhs(system->model, tau, forcing, scaled, dxdt);
    for (size_t i = 0; i < half; ++i) dxdt[i] *= length * clock;
    for (size_t i = half; i < 2 * half; ++i) dxdt[i] *= length * clock * clock;
    return whirl_ok();
}
