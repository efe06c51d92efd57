/// Search for the stiffest phase of a motion, where the balanced Jacobian is largest, and the effect of a step of a
/// given length there.
#ifndef INTEGRATE_STIFFEST_H
#define INTEGRATE_STIFFEST_H

#include "whirl/engine/system.h"

#include <stdbool.h>

/// A search among phases, with its workspace.
typedef struct phase_search {
    const whirl_system *system;
    double norm;       ///< norm of the stiffest Jacobian so far
    double solved;     ///< norm of the Jacobian whose eigenvalues `real` and `imaginary` hold
    double *stiffest;  ///< [dimension][dimension] balanced
    double *jacobian;  ///< [dimension][dimension] workspace
    double *unit;      ///< [dimension][dimension] workspace
    double *real;      ///< [dimension]
    double *imaginary; ///< [dimension]
    double *state;     ///< [dimension] workspace
    double *x;         ///< [dimension] for the caller
} phase_search;

/// Makes a search. Its workspace is one block, *block, which the caller frees with free(). Returns false without
/// memory.
bool phase_search_begin(phase_search *s, const whirl_system *system, double **block);

/// Inspects a phase. It is a whirl_observe_fn whose observer is the search.
void phase_search_note(void *search, double t, const double *x);

/// Computes the eigenvalues at the stiffest phase, in `real` and `imaginary`. Returns false if they do not converge.
bool phase_search_solve(phase_search *s);

/// Returns the largest |R(h lambda)| / max(1, |exp(h lambda)|), at least 1. To be called after phase_search_solve.
double phase_search_growth(const phase_search *s, double (*amplification)(double, double), double h);

/// Returns the number of steps in a period that keeps the growth below the limit of instability: `steps`, or a larger
/// number, to a few percent.
double phase_search_steps(const phase_search *s, double (*amplification)(double, double), double steps);

#endif
