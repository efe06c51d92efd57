/// A branch that is being followed.
#ifndef ORBIT_FOLLOWER_H
#define ORBIT_FOLLOWER_H

#include "curve.h"
#include "equations.h"

/// A point on the way.
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

/// Makes one at a value. Errors as equations_make. Freed by follower_end, whether it was made or not.
whirl_status follower_begin(follower *f, const whirl_family *family, const whirl_orbit *start, double value,
                            const whirl_branch_options *options);
void follower_end(follower *f);

/// Lets what counts as 1 be the size of the equations' present nodes, and `tangent` [unknowns] be of length 1 by it.
void follower_scale(follower *f, double *tangent);

/// The value of the parameter at u.
double follower_value(const follower *f, const double *u);

/// The unknowns of the equations' nodes at a value: u [unknowns].
void follower_take(const follower *f, double value, double *u);

/// The point across `direction` from u [unknowns], with its orbit and its tangent on the side of `along`; none (orbit
/// NULL) where none is found. Errors are those of memory.
whirl_status follower_find(follower *f, const double *u, const double *direction, const double *along, waypoint *out);
whirl_status waypoint_new(const follower *f, waypoint *out);
void waypoint_free(waypoint *p);

/// Two points of a branch, a and b, say what is expected of it nearby, where it is over its parameter and hardly bent;
/// elsewhere, or where they have no orbit, all that is known is the tangent of the point `from` to set out from.
///
/// Across what a point is looked for: the parameter's own direction, so that its value stays and one machine does, or
/// the tangent. `direction` [unknowns] is room for it.
const double *follower_across(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from,
                              double *direction);

/// Writes where the point is expected that is `length` along the tangent of `from`: by the cubic over the parameter
/// through both with their tangents, or on the tangent.
void follower_predict(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from, double length,
                      double *u);

/// How far b is along the tangent of a, with what is known of both. work [unknowns]
double follower_length(const follower *f, const waypoint *a, const waypoint *b, double *work);

/// Adds a point to a branch, which then owns the orbit; its end is WHIRL_END_STOPPED where that was asked for.
whirl_status branch_add(whirl_branch *branch, const whirl_branch_options *options, const whirl_branch_point *point);

/// The status that following a branch comes to: where motions were stopped on the way that is its end, and what else
/// was found wrong since means nothing, but for memory.
whirl_status branch_finish(whirl_branch *branch, const whirl_branch_options *options, whirl_status status);

#endif
