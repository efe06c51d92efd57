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
    /// Returns the largest of F in units of the equations.
    double (*size)(void *context, const double *u, const double *value);
    /// [count][count] and [count]: NULL, or the factors of a derivative from nearby, used as long as its steps converge
    /// well: it saves a derivative.
    const double *nearby;
    const size_t *nearby_order;
    /// NULL, or the part of F that such a step left the last time (1: unknown). If it promises convergence, F is
    /// evaluated only together with its derivative.
    double *share;
    const double *scale; ///< [count] units of u; NULL: 1
    double tolerance;    ///< tolerance of that size
    int most_steps, most_halvings;
} newton_problem;

/// Result of Newton's method.
typedef struct newton_result {
    bool found;
    int steps;
    double size; ///< size of F at the last u
} newton_result;

/// Moves u [count] from a start to a zero, by steps that are halved, up to a limit, until they lead nearer. If it is
/// found, the last call of evaluate is that of the final u, with the derivative. F that rounding keeps from getting
/// smaller counts as zero up to 100 times the tolerance. Also not found without memory.
newton_result newton_solve(const newton_problem *problem, double *u);

#endif
