/// Newton's method for a few hundred equations, damped.
#ifndef ORBIT_NEWTON_H
#define ORBIT_NEWTON_H

#include <stdbool.h>
#include <stddef.h>

/// Equations F(u) = 0.
typedef struct newton_problem {
    size_t count; ///< number of equations and of unknowns
    void *context;
    /// Writes F(u) [count] and, unless NULL, the derivative [count][count]. False if they cannot be computed.
    bool (*evaluate)(void *context, const double *u, double *value, double *derivative);
    /// Returns the largest number of F in units of the equations.
    double (*size)(void *context, const double *u, const double *value);
    /// NULL, or the factors [count][count] and their order [count] of a derivative from nearby. They are used as long
    /// as their steps converge well, which saves a derivative.
    const double *nearby;
    const size_t *nearby_order;
    /// NULL, or the factor by which the last step with a derivative from nearby reduced F (1: unknown). If it predicts
    /// that the next step converges, F is evaluated only together with its derivative.
    double *share;
    const double *scale; ///< [count] units of u; NULL: 1
    double tolerance;    ///< largest size of F at a zero
    int most_steps, most_halvings;
} newton_problem;

/// Result of Newton's method.
typedef struct newton_result {
    bool found;
    int steps;
    double size; ///< size of F at the last u
} newton_result;

/// Moves u [count] from a start to a zero. Steps are halved, up to a limit, until they lead nearer. If a zero is found,
/// the last call of evaluate was at the final u, with the derivative. If rounding keeps F from getting smaller, F up to
/// 100 times the tolerance counts as zero. Without memory no zero is found.
newton_result newton_solve(const newton_problem *problem, double *u);

#endif
