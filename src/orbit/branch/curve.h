/// Solution curves: N equations for N + 1 unknowns, the last of which is the parameter.
#ifndef ORBIT_CURVE_H
#define ORBIT_CURVE_H

#include "newton.h"
#include "whirl/status.h"

typedef struct curve {
    size_t count; ///< N
    void *context;
    /// Function for newton_problem, with the derivative [N][N + 1].
    bool (*evaluate)(void *context, const double *u, double *value, double *derivative);
    double (*size)(void *context, const double *u, const double *value);
    double tolerance;
    double *scale;   ///< [N + 1] unit lengths along the curve
    double *matrix;  ///< [N + 1][N + 1] derivative at the last point found, with a direction in the last row
    bool known;      ///< the matrix is valid
    double *factors; ///< [N + 1][N + 1] factors of the matrix, with the order of its rows [N + 1] in `order`
    size_t *order;
    bool decomposed;                ///< the factors are valid
    double share;                   ///< as in newton_problem
    double *values;                 ///< [N + 1] workspace
    const double *direction, *from; ///< data of the present search
} curve;

/// Range of a curve: the bounds of its parameter, and the lengths of its steps.
typedef struct curve_way {
    double from, to;
    double least_step, step, most_step;
} curve_way;

/// Checks bounds and steps, and that `value`, where a curve begins, is within the bounds. WHIRL_BAD_INPUT.
whirl_status curve_check(const curve_way *way, double value);

/// Allocates the arrays of a curve whose other members are set. False without memory. Freed by curve_end.
bool curve_begin(curve *c);
void curve_end(curve *c);

/// Returns the scalar product of a and b in units of the scale.
double curve_dot(const curve *c, const double *a, const double *b);

/// Scales a direction [N + 1] to length 1. False if it is 0.
bool curve_make_unit(const curve *c, double *direction);

/// Writes the direction of length 1 along the parameter, towards larger values.
void curve_parameter_direction(const curve *c, double *direction);

/// Orients a tangent so that the parameter changes in the direction of `direction` (+1, -1).
void curve_turn(const curve *c, int direction, double *tangent);

/// Moves u [N + 1] to the curve by Newton steps orthogonal to `direction`.
newton_result curve_correct(curve *c, const double *direction, double *u);

/// Returns the factor for the next step: larger if Newton's method converged quickly.
double curve_pace(const newton_result *result);

/// Computes the curve's direction at the last point found, of length 1, on the side of `along`, by solving with
/// `across` as last row. False if the derivative loses more than one rank, or if the direction is orthogonal to
/// `across`.
bool curve_tangent(curve *c, const double *across, const double *along, double *tangent);

/// Computes the direction of another curve that crosses this one at the last point found: of length 1, orthogonal to
/// `tangent`, along which the derivative is smallest.
bool curve_other(curve *c, const double *tangent, double *other);

#endif
