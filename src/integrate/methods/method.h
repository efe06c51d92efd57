/// A method of integration: a table of functions. Each method has its file.
#ifndef INTEGRATE_METHOD_H
#define INTEGRATE_METHOD_H

#include "whirl/engine/integrate.h"

#include <stddef.h>

enum { SPARE_ROWS = 4 };

struct whirl_integrator {
    const whirl_system *system;
    whirl_integrate_options options;
    const struct method *method;
    void *workspace; ///< workspace of the method
    size_t most_perturbations;
    /// Limit of the steps tried since the start, for adaptive methods of rotors; at the limit a revolution ends early.
    /// 0: no limit.
    size_t most_steps;
    /// [method->rows][1 + most_perturbations][dimension], then [SPARE_ROWS][dimension]: workspace for the state and its
    /// perturbations
    double *slopes;
};

typedef struct method {
    whirl_method about;
    /// Makes the workspace of an integrator; its other members are already set.
    whirl_status (*start)(whirl_integrator *integrator);
    /// Carries x over a revolution; perturbations: NULL for none.
    whirl_motion (*revolve)(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                            whirl_observe_fn observe, void *observer);
    size_t rows; ///< rows of the workspace `slopes`
    void (*end)(whirl_integrator *integrator);
    const struct method *located;     ///< the variant of the method with located contacts; NULL: there is only one
    const struct lanes_method *lanes; ///< the adaptive method in lanes, or NULL
    /// For fixed steps, returns |R(z)| at z = real + i imaginary, the factor by which a step multiplies the mode exp(z
    /// t / h). NULL for other methods.
    double (*amplification)(double real, double imaginary);
    double (*work)(const whirl_integrator *integrator); ///< work done so far, in right-hand sides; or NULL
} method;

extern const method auto_method, rk4_method, rk4_located_method, dop853_method, rodas5p_method, cvode_adams_method,
    cvode_bdf_method;
extern const struct lanes_method dop853_in_lanes, rodas5p_in_lanes;

/// Functions |R(z)| of the explicit methods.
double rk4_amplification(double real, double imaginary);
double dop853_amplification(double real, double imaginary);

/// Returns the adaptive method in lanes which the options name, or NULL if they name another method.
const struct lanes_method *adaptive_in_lanes(const whirl_integrate_options *options);

/// Finds a method by its name. If there is none, returns WHIRL_BAD_INPUT with the nearest name.
whirl_status method_find(const char *name, const method **found);

/// Checks the system and the options. WHIRL_BAD_INPUT if one of them is invalid.
whirl_status check_options(const whirl_system *system, const whirl_integrate_options *options);

/// Returns the divergence at (t, x), or NaN if the system does not provide it.
double divergence_at(const whirl_system *system, double t, const double *forcing, const double *x, const double *sides);

/// Returns WHIRL_BOUNDED or WHIRL_DIVERGED, by the options' limit.
whirl_motion state_motion(const whirl_integrator *integrator, const double *x);

#endif
