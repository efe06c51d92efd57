/// A branch that is being followed: waypoints, predictions and corrections.
#ifndef ORBIT_FOLLOWER_H
#define ORBIT_FOLLOWER_H

#include "curve.h"
#include "equations.h"
#include "shooting.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

/// A point of the continuation.
typedef struct waypoint {
    double *u, *tangent; ///< [unknowns]
    whirl_orbit *orbit;
    double pace; ///< curve_pace
} waypoint;

typedef struct follower {
    orbit_equations equations;
    curve curve;
    const whirl_branch_options *options;
    whirl_branch *branch;
} follower;

/// Makes the follower of a branch that begins at a value. Errors as equations_make. Freed by follower_end, after a
/// failure too.
whirl_status follower_begin(follower *f, const whirl_family *family, const whirl_orbit *start, double value,
                            const whirl_branch_options *options);
void follower_end(follower *f);

/// Sets the unit lengths from the present nodes' size, and scales `tangent` [unknowns] to length 1.
void follower_scale(follower *f, double *tangent);

/// Returns the parameter at u.
double follower_value(const follower *f, const double *u);

/// Returns the share of the parameter in a tangent of length 1.
double follower_lean(const follower *f, const double *tangent);

/// Writes the unknowns of the equations' nodes at a value: u [unknowns].
void follower_take(const follower *f, double value, double *u);

/// Finds the point of the branch that lies orthogonal to `direction` from u [unknowns], its orbit, and its tangent on
/// the side of `along`. The orbit is NULL if none is found. The only error is WHIRL_NO_MEMORY.
whirl_status follower_find(follower *f, const double *u, const double *direction, const double *along, waypoint *out);
whirl_status waypoint_new(const follower *f, waypoint *out);
void waypoint_free(waypoint *p);

/// Chooses how points near two points a and b of a branch are predicted and found: by both points if the branch is a
/// function of its parameter and hardly bent, otherwise by the tangent of the point `from` alone.
///
/// Returns the direction orthogonal to which a point is searched: the parameter's own, so that the parameter and
/// therefore the machine stay the same, or the tangent. `direction` [unknowns] is scratch.
const double *follower_across(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from,
                              double *direction);

/// Predicts the point that is `length` along the tangent of `from`: by the cubic over the parameter through both points
/// with their tangents, or on the tangent.
void follower_predict(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from, double length,
                      double *u);

/// Returns how far b is along the tangent of a. work [unknowns]
double follower_length(const follower *f, const waypoint *a, const waypoint *b, double *work);

#endif
