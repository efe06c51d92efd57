/// A method of integration: a table of functions, one file a method.
#ifndef INTEGRATE_METHOD_H
#define INTEGRATE_METHOD_H

#include "dop853_tableau.h"
#include "whirl/engine/integrate.h"

#include <stdbool.h>
#include <stddef.h>

enum { SPARE_ROWS = 4 };

struct whirl_integrator {
    const whirl_system *system;
    whirl_integrate_options options;
    const struct method *method;
    void *workspace; ///< workspace of the method
    size_t most_perturbations;
    size_t most_steps; ///< most steps that the adaptive methods of rotors try in all: then revolutions end early; 0:
                       ///< any number
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
    const struct method *located;     ///< the variant with located contacts, if the method has both
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

/// Returns the adaptive method in lanes that the options name; NULL if they name another method.
const struct lanes_method *adaptive_in_lanes(const whirl_integrate_options *options);

/// Finds a method by its name. WHIRL_BAD_INPUT, with the nearest name, if there is none.
whirl_status method_find(const char *name, const method **found);

/// Checks the system and the options. WHIRL_BAD_INPUT if one of them is invalid.
whirl_status check_options(const whirl_system *system, const whirl_integrate_options *options);

/// Returns the divergence at (t, x); NaN if the system does not provide it.
double divergence_at(const whirl_system *system, double t, const double *forcing, const double *x, const double *sides);

/// Returns whether the motion is bounded or diverged, by the options' limit.
whirl_motion state_motion(const whirl_integrator *integrator, const double *x);

// ---------------------------------------------------------------- dop853_sums
// The pair of dop853_tableau.h for x'' = f(t, x, x'): the slopes of positions are velocities, which are sums of
// accelerations themselves. So every state within a step is
//
//     q + c h v + h^2 sum_j position_j a_j,      v + h sum_j velocity_j a_j,
//
// with accelerations a_j alone, which halves what is kept of a step.

/// Several weighted sums over the same slopes; some weights may be zero.
enum { POSITION, VELOCITY, SUMS_OF_STATE, SUMS_OF_ERROR = 4, MAX_SUMS = 4 };
typedef struct slope_sums {
    size_t count;
    size_t place[DOP853_SLOPES]; ///< indices of the slopes
    double weight[DOP853_SLOPES][MAX_SUMS];
} slope_sums;

typedef struct dop853_sums {
    slope_sums stage[DOP853_SLOPES]; ///< position, velocity where a slope is taken; row 12 is the result
    slope_sums error; ///< errors of position and velocity by the formula of order 5, then by that of order 3
    slope_sums dense[DOP853_DENSE];   ///< the interpolant's polynomials, of position and velocity
    double dense_drift[DOP853_DENSE]; ///< factor of h v in the positions' polynomials
} dop853_sums;

void dop853_sums_fill(dop853_sums *sums, size_t apart);

// ---------------------------------------------------------------- sparsity
// Sparsity: entries of a Jacobian, and of the factors of an implicit method's matrix, that can differ from zero: the
// same for all lanes, found once for a structure.

/// Columns of row i are in the runs begin[i] to before begin[i + 1], ascending: run r in the columns run[2 r] to before
/// run[2 r + 1].
typedef struct sparse_rows {
    size_t *begin, *run;
} sparse_rows;

typedef struct sparsity {
    size_t perturbations;
    size_t *perturbation;     ///< [dimension] perturbation that determines a column, for positions and rates
    sparse_rows by_q, by_v;   ///< the Jacobian of the rates by positions and by rates
    sparse_rows lower, upper; ///< factors of the sum of both
} sparsity;

/// Finds the sparsity of a machine with `degrees` positions and `rates` rates; depends as in whirl_lanes, NULL: every
/// rate depends on every coordinate. One block, which the caller frees by free(); NULL without memory.
sparsity *sparsity_new(size_t degrees, size_t rates, void (*depends)(const void *model, bool *table),
                       const void *model);

// ---------------------------------------------------------------- stiffest
// The stiffest phase of a motion: where the balanced Jacobian is largest, and what a step of a given length does
// there.

/// A search among phases, with its workspace.
typedef struct phase_search {
    const whirl_system *system;
    double norm;       ///< norm of the stiffest Jacobian so far
    double solved;     ///< norm of the Jacobian whose eigenvalues are in real and imaginary
    double *stiffest;  ///< [dimension][dimension] balanced
    double *jacobian;  ///< [dimension][dimension] workspace
    double *unit;      ///< [dimension][dimension] workspace
    double *real;      ///< [dimension]
    double *imaginary; ///< [dimension]
    double *state;     ///< [dimension] workspace
    double *x;         ///< [dimension] for the caller
} phase_search;

/// Makes a search with its workspace in one block, `block`, which the caller frees by free(). Returns false without
/// memory.
bool phase_search_begin(phase_search *s, const whirl_system *system, double **block);

/// Inspects a phase: a whirl_observe_fn whose observer is the search.
void phase_search_note(void *search, double t, const double *x);

/// Computes the eigenvalues at the stiffest phase, in real and imaginary; returns false if they do not converge.
bool phase_search_solve(phase_search *s);

/// After phase_search_solve: the largest of |R(h lambda)| / max(1, |exp(h lambda)|), at least 1.
double phase_search_growth(const phase_search *s, double (*amplification)(double, double), double h);

/// Returns the number of steps in a period that keeps the growth below the limit of instability: `steps`, or a larger
/// number to a few percent.
double phase_search_steps(const phase_search *s, double (*amplification)(double, double), double steps);

#endif
