/// Curves of solutions: N equations for N + 1 unknowns, of which the last one is the parameter.
#ifndef ORBIT_CURVE_H
#define ORBIT_CURVE_H

#include "newton.h"
#include "whirl/status.h"

typedef struct curve {
    size_t count; ///< N
    void *context;
    /// As newton_problem has them, the derivative [N][N + 1].
    bool (*evaluate)(void *context, const double *u, double *value, double *derivative);
    double (*size)(void *context, const double *u, const double *value);
    double tolerance;
    double *scale;   ///< [N + 1] what counts as 1 in lengths along the curve
    double *matrix;  ///< [N + 1][N + 1] the derivative at the last point that was found, a direction in the last row
    bool known;      ///< there was one
    double *factors; ///< [N + 1][N + 1] of the matrix, with `order` [N + 1]
    size_t *order;
    bool decomposed;                ///< they are there
    double share;                   ///< as newton_problem has it
    double *values;                 ///< [N + 1] workspace
    const double *direction, *from; ///< of the search under way
} curve;

/// How a curve is followed: the bounds of its parameter, and the lengths of its steps.
typedef struct curve_way {
    double from, to;
    double least_step, step, most_step;
} curve_way;

/// WHIRL_BAD_INPUT where bounds or steps make no sense, or a curve that begins at `value` begins beyond the bounds.
whirl_status curve_check(const curve_way *way, double value);

/// Makes room for a curve whose other members are set. False where memory is lacking. Freed by curve_end.
bool curve_begin(curve *c);
void curve_end(curve *c);

/// a . b with lengths as the scale has them.
double curve_dot(const curve *c, const double *a, const double *b);

/// Scales a direction [N + 1] to length 1. False where it has none.
bool curve_make_unit(const curve *c, double *direction);

/// The parameter's own direction, of length 1, towards larger values.
void curve_parameter_direction(const curve *c, double *direction);

/// Turns a tangent to the side where the parameter changes in the direction of `direction` (+1, -1).
void curve_turn(const curve *c, int direction, double *tangent);

/// Carries u [N + 1] to the curve, across `direction`: by steps that have no part along it.
newton_result curve_correct(curve *c, const double *direction, double *u);

/// By what the next step may be longer: more where Newton's method found the point with ease.
double curve_pace(const newton_result *result);

/// The curve's direction at the last point found, of length 1, on the side of `along`, found as that with a part along
/// `across`. False where the equations' derivative loses more than one rank, or it has no such part.
bool curve_tangent(curve *c, const double *across, const double *along, double *tangent);

/// Where another curve crosses the last point found: its direction there, of length 1 and across `tangent`, of what the
/// derivative comes nearest to leaving at 0.
bool curve_other(curve *c, const double *tangent, double *other);

#endif
