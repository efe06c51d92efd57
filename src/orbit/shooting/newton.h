/// Newton's method for a few hundred equations, damped.
#ifndef ORBIT_NEWTON_H
#define ORBIT_NEWTON_H

#include <stdbool.h>
#include <stddef.h>

/// Equations F(u) = 0.
typedef struct newton_problem {
    size_t count; ///< of equations and of unknowns
    void *context;
    /// Writes F(u) [count] and, unless NULL, the derivative [count][count]. False where it cannot be told.
    bool (*evaluate)(void *context, const double *u, double *value, double *derivative);
    /// The largest of F over what counts as 1 in it.
    double (*size)(void *context, const double *u, const double *value);
    /// [count][count] and [count]: NULL, or a derivative from nearby, decomposed, with which steps are taken for as
    /// long as they lead on well: they cost no derivative.
    const double *nearby;
    const size_t *nearby_order;
    /// NULL, or by what share such a step left F the last time (1: not known): where it promises to be enough, F is not
    /// looked at before its derivative is.
    double *share;
    const double *scale; ///< [count] what counts as 1 in u; NULL: 1
    double tolerance;    ///< of that size
    int most_steps, most_halvings;
} newton_problem;

/// What came of it.
typedef struct newton_result {
    bool found;
    int steps;
    double size; ///< of F, at the last u
} newton_result;

/// Carries u [count] from a start to a zero, by steps that are halved, at most so often, until they lead nearer. The
/// last call of evaluate is that of the final u, with the derivative, where it was found. F that cannot get smaller any
/// more for rounding counts as zero up to 100 times the tolerance. Not found where memory is lacking, too.
newton_result newton_solve(const newton_problem *problem, double *u);

#endif
