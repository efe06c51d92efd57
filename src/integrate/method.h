/// A method of integration: a table of functions, one file a method.
#ifndef INTEGRATE_METHOD_H
#define INTEGRATE_METHOD_H

#include "whirl/integrate.h"

struct whirl_integrator {
    const whirl_system *system;
    whirl_integrate_options options;
    const struct method *method;
    void *workspace; ///< of the method
};

typedef struct method {
    whirl_method about;
    /// Makes the workspace of an integrator whose other members are set.
    whirl_status (*start)(whirl_integrator *integrator);
    whirl_motion (*revolve)(whirl_integrator *integrator, double *x, whirl_observe_fn observe, void *observer);
    void (*end)(whirl_integrator *integrator);
} method;

extern const method rk4_method, dop853_method, cvode_adams_method, cvode_bdf_method;

/// WHIRL_BAD_INPUT where the system or the options are none.
whirl_status check_options(const whirl_system *system, const whirl_integrate_options *options);

/// Bounded or diverged, by the options' limit.
whirl_motion state_motion(const whirl_integrator *integrator, const double *x);

#endif
