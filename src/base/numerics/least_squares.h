/// Nonlinear least squares with bounds, by the method of Levenberg and Marquardt.
#ifndef BASE_LEAST_SQUARES_H
#define BASE_LEAST_SQUARES_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The problem: minimize |r(p)|^2 for p between bounds.
typedef struct least_squares {
    size_t unknowns, count; ///< numbers of p and of r
    void *context;          ///< passed to both functions
    /// Writes r [count] and its derivatives by p [count][unknowns]. False where they cannot be computed.
    bool (*evaluate)(void *context, const double *p, double *residuals, double *derivatives);
    /// Called for the p of the last evaluation when the method goes there; optional.
    void (*accept)(void *context);
    const double *low, *high; ///< [unknowns] bounds; infinite: none
    const double *scale;      ///< [unknowns] size of a change of each p that matters, above 0
    double tolerance;         ///< largest change of p in the last step, as part of p (of the scale near p = 0)
    int most_steps;           ///< most evaluations
} least_squares;

/// Ends of the method.
typedef enum least_squares_end {
    LEAST_SQUARES_FOUND,   ///< at a minimum: steps are shorter than the tolerance, or the sum cannot fall by more than
                           ///< a millionth of the variance
    LEAST_SQUARES_STEPS,   ///< most_steps were taken
    LEAST_SQUARES_STUCK,   ///< no shorter step makes the sum smaller
    LEAST_SQUARES_NOWHERE, ///< r cannot be computed at the start
    LEAST_SQUARES_MEMORY   ///< memory is exhausted
} least_squares_end;

/// Result of the method.
typedef struct least_squares_result {
    least_squares_end end;
    int steps;  ///< evaluations
    double sum; ///< |r|^2 at p
} least_squares_result;

/// Moves p [unknowns] from a start within the bounds to a local minimum, and writes the residuals [count] and
/// derivatives [count][unknowns] there. A step solves min |J d + r|^2 + l |D d|^2 over the p that are not held at a
/// bound, and is cut at the bounds. D holds the largest norms of columns so far (More 1978); the damping l depends on
/// the ratio of actual and predicted gain (Nielsen 1999).
least_squares_result least_squares_solve(const least_squares *problem, double *p, double *residuals,
                                         double *derivatives);

/// Rank and condition at a minimum.
typedef struct least_squares_facts {
    size_t rank; ///< number of combinations of p that r depends on
    double
        condition; ///< largest over smallest singular value of J with columns of length 1; infinite without full rank
} least_squares_facts;

/// Computes from derivatives [count][unknowns] the standard errors of p for residuals of standard deviation 1
/// [unknowns] (infinite for a p that belongs to a combination on which r does not depend), and correlations
/// [unknowns][unknowns] (NaN with such a p). False without memory.
bool least_squares_describe(size_t unknowns, size_t count, const double *derivatives, double *errors,
                            double *correlations, least_squares_facts *facts);

/// Returns the half-width, in standard errors, of the two-sided 95 % interval of Student's distribution with `degrees`
/// degrees of freedom. The error is below 1e-4 from 3 degrees on (Abramowitz, Stegun 1964, 26.7.5).
double least_squares_student(size_t degrees);

#ifdef __cplusplus
}
#endif
#endif
