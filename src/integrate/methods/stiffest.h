/// The stiffest phase of a motion: where the balanced Jacobian is largest, and what a step of a given length does
/// there.
#ifndef INTEGRATE_STIFFEST_H
#define INTEGRATE_STIFFEST_H

#include "method.h"

/// A search among phases, with its workspace.
typedef struct phase_search {
    const whirl_system *system;
    double norm;       ///< of the stiffest Jacobian so far
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

/// ... and how many steps a period keep it below what counts as unstable: `steps`, or more within a few parts in a
/// hundred.
double phase_search_steps(const phase_search *s, double (*amplification)(double, double), double steps);

#endif
