/// A method of integration: a table of functions, one file a method.
#ifndef INTEGRATE_METHOD_H
#define INTEGRATE_METHOD_H

#include "whirl/engine/integrate.h"

enum { SPARE_ROWS = 4 };

struct whirl_integrator {
    const whirl_system *system;
    whirl_integrate_options options;
    const struct method *method;
    void *workspace; ///< of the method
    size_t most_perturbations;
    size_t most_steps; ///< that the adaptive methods of rotors try in all: then revolutions end early; 0: any number
    /// [method->rows][1 + most_perturbations][dimension], then [SPARE_ROWS][dimension]: workspace for the state and its
    /// perturbations
    double *slopes;
};

typedef struct method {
    whirl_method about;
    /// Makes the workspace of an integrator whose other members are set.
    whirl_status (*start)(whirl_integrator *integrator);
    /// `perturbations` is NULL where there are none.
    whirl_motion (*revolve)(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                            whirl_observe_fn observe, void *observer);
    size_t rows; ///< of the workspace `slopes`
    void (*end)(whirl_integrator *integrator);
    const struct method *located;     ///< the same with located contacts, where that is a choice
    const struct lanes_method *lanes; ///< the adaptive method in lanes, or NULL
    /// Of fixed steps: |R(z)| at z = real + i imaginary, by which a step multiplies the mode exp(z t / h). Else NULL.
    double (*amplification)(double real, double imaginary);
    double (*work)(const whirl_integrator *integrator); ///< done so far, in right-hand sides, or NULL
} method;

extern const method auto_method, rk4_method, rk4_located_method, dop853_method, rodas5p_method, cvode_adams_method,
    cvode_bdf_method;
extern const struct lanes_method dop853_in_lanes, rodas5p_in_lanes;

/// |R(z)| of the explicit methods, by their formulas.
double rk4_amplification(double real, double imaginary);
double dop853_amplification(double real, double imaginary);

/// The adaptive method in lanes that the options ask for; NULL where they ask for another.
const struct lanes_method *adaptive_in_lanes(const whirl_integrate_options *options);

/// The method of that name. WHIRL_BAD_INPUT that names the nearest one when there is none.
whirl_status method_find(const char *name, const method **found);

/// WHIRL_BAD_INPUT where the system or the options are none.
whirl_status check_options(const whirl_system *system, const whirl_integrate_options *options);

/// The divergence at (t, x); not a number where the system gives none.
double divergence_at(const whirl_system *system, double t, const double *forcing, const double *x, const double *sides);

/// Bounded or diverged, by the options' limit.
whirl_motion state_motion(const whirl_integrator *integrator, const double *x);

#endif
