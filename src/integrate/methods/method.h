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
    /// Makes the workspace of an integrator whose other members are set.
    whirl_status (*start)(whirl_integrator *integrator);
    /// `perturbations` is NULL where there are none.
    whirl_motion (*revolve)(whirl_integrator *integrator, double *x, whirl_perturbations *perturbations,
                            whirl_observe_fn observe, void *observer);
    size_t rows; ///< rows of the workspace `slopes`
    void (*end)(whirl_integrator *integrator);
    const struct method *located;     ///< the same with located contacts, where that is a choice
    const struct lanes_method *lanes; ///< the adaptive method in lanes, or NULL
    /// For fixed steps, returns |R(z)| at z = real + i imaginary, by which a step multiplies the mode exp(z t / h).
    /// Else NULL.
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

// ---------------------------------------------------------------- dop853_sums
// The pair of dop853_tableau.h for x'' = f(t, x, x'): the slopes of positions are velocities, which are sums of
// accelerations themselves. So every state within a step is
//
//     q + c h v + h^2 sum_j position_j a_j,      v + h sum_j velocity_j a_j,
//
// with accelerations a_j alone, which halves what is kept of a step.

/// Weighted sums that run over the same slopes, side by side; the weights of some may be zero.
enum { POSITION, VELOCITY, SUMS_OF_STATE, SUMS_OF_ERROR = 4, MAX_SUMS = 4 };
typedef struct slope_sums {
    size_t count;
    size_t place[DOP853_SLOPES]; ///< first of the slopes, `apart` numbers from one to the next
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
    size_t *perturbation;     ///< [dimension] by which a column is found, that of a position or of a rate
    sparse_rows by_q, by_v;   ///< the Jacobian of the rates by positions and by rates
    sparse_rows lower, upper; ///< factors of the sum of both
} sparsity;

/// Makes the sparsity of a machine with so many positions and rates; depends as in whirl_lanes, NULL: all depend on
/// all. In one block, freed by free(); NULL where there is no memory.
sparsity *sparsity_new(size_t degrees, size_t rates, void (*depends)(const void *model, bool *table),
                       const void *model);

// ---------------------------------------------------------------- stiffest
// The stiffest phase of a motion: where the balanced Jacobian is largest, and what a step of a given length does
// there.

/// A search among phases, with its workspace.
typedef struct phase_search {
    const whirl_system *system;
    double norm;       ///< norm of the stiffest Jacobian so far
    double solved;     ///< the norm of that whose eigenvalues are in real and imaginary
    double *stiffest;  ///< [dimension][dimension] balanced
    double *jacobian;  ///< [dimension][dimension] workspace
    double *unit;      ///< [dimension][dimension] workspace
    double *real;      ///< [dimension]
    double *imaginary; ///< [dimension]
    double *state;     ///< [dimension] workspace
    double *x;         ///< [dimension] for the caller
} phase_search;

/// A search with its workspace in one block, `block`, to be freed by free; false without memory.
bool phase_search_begin(phase_search *s, const whirl_system *system, double **block);

/// Looks at a phase: a whirl_observe_fn whose observer is the search.
void phase_search_note(void *search, double t, const double *x);

/// The eigenvalues at the stiffest phase, in real and imaginary; false where they cannot be found.
bool phase_search_solve(phase_search *s);

/// After phase_search_solve: the largest of |R(h lambda)| / max(1, |exp(h lambda)|), at least 1.
double phase_search_growth(const phase_search *s, double (*amplification)(double, double), double h);

/// Returns how many steps a period keep it below what counts as unstable: `steps`, or more within a few parts in a
/// hundred.
double phase_search_steps(const phase_search *s, double (*amplification)(double, double), double steps);

#endif
