/// A branch that is being followed.
#ifndef ORBIT_FOLLOWER_H
#define ORBIT_FOLLOWER_H

#include "curve.h"
#include "equations.h"
#include "shooting.h"
#include "whirl/engine/orbit.h"

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

/// The share that the parameter has in a tangent of length 1.
double follower_lean(const follower *f, const double *tangent);

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

// ---------------------------------------------------------------- describe
// Orbits in memory.

/// The orbit of nodes whose segments have just been carried with derivatives. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT where it
/// cannot be followed.
whirl_status orbit_describe(shooting *s, const double *nodes, double period, double residual, whirl_orbit **out);

/// The multiplier that shifts along the orbit have, of an orbit with a time of its own; SIZE_MAX of others.
size_t orbit_own_multiplier(const whirl_orbit *orbit);

// ---------------------------------------------------------------- distance
// How far states are apart at sections.

/// Of two states [dimension], over the largest coordinate of the first; what turns is left out.
double states_distance(const whirl_system *system, const double *a, const double *b);

/// From one section of an orbit to the next, in numbers of its nodes; an orbit with a time of its own has one section.
size_t orbit_stride(const whirl_orbit *orbit);

// ---------------------------------------------------------------- halved
// Where orbits of an even number of revolutions close after half of them: at the doubling of another branch.

/// Whether orbits close after half their time between two waypoints. There the branch ends, beyond which it is the same
/// as before, half its time later. By how much they are elsewhere after half the time goes through 0 there, and only
/// there it can turn round within a step.
bool halved_between(const waypoint *from, const waypoint *to);

/// Adds the last point of such a branch, where its orbits close after half their time. Errors are those of memory.
whirl_status halved_add(follower *f, const waypoint *from, const waypoint *to);

// ---------------------------------------------------------------- mirrored
// Pitchforks reached along their side branch.

/// Locates the pitchfork between two waypoints of its side branch: `out` with the orbit of the other branch there, or
/// without an orbit if there is none. *image is true if the side branch beyond it is its own mirror image. Errors are
/// those of memory.
whirl_status mirrored_locate(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out,
                             bool *image);

// ---------------------------------------------------------------- normal_form
// What begins at a special point: whether it is there where the orbit is unstable, or where it is stable.

/// The cubic coefficient of the normal form at a doubling, a Neimark-Sacker or a Hopf point (Kuznetsov 2004, 5.4) of an
/// orbit whose segments were carried with derivatives, as whirl_branch_point has it. NaN where memory is lacking, a
/// motion beside it leaves its bounds, the point is of another kind, or a pair of multipliers is within 1e-3 of a
/// strong resonance (a third or a fourth of a turn). angle as whirl_branch_point has it.
double normal_form(shooting *s, const whirl_orbit *orbit, whirl_special kind, double angle);

// ---------------------------------------------------------------- rest
// The equations of an equilibrium, in the place of an orbit's.

/// Writes what the forces come to at a node, of what does not turn: slope [kept]; with `derivatives` the matrix becomes
/// its Jacobian and the volume its trace. False where it is not finite.
bool rest_slope(shooting *s, const double *node, double *slope, bool derivatives);

/// The largest sum of a row of the Jacobian.
double rest_rate(const shooting *s);

/// The largest of the slope [kept], over what a Jacobian of that rate makes of a coordinate of that size.
double rest_size(const shooting *s, const double *slope, double size, double rate);

// ---------------------------------------------------------------- special
// Where the stability of orbits changes along a branch, or a contact.

/// Special points between two waypoints: adds them to the branch in their order, without a fold where the branch turns
/// back at a pitchfork.
whirl_status special_locate(follower *f, const waypoint *from, const waypoint *to, bool pitchfork);

/// Locates where a multiplier passes 1 between two waypoints: `out` without an orbit if none does. The caller owns the
/// orbit. Errors are those of memory.
whirl_status special_crossing(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out);

// ---------------------------------------------------------------- touch
// Contacts along an orbit, and how near it comes to beginning or losing one.

/// Follows the orbit's nodes: its bounds and touches. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT where the motion leaves its
/// bounds.
whirl_status touch_find(shooting *s, whirl_orbit *orbit);

// ---------------------------------------------------------------- vanishing
// Functions of an orbit that vanish where it changes.

/// The function that goes through zero where an orbit is special: for folds and crossings the product of (multiplier -
/// 1), for doublings of (multiplier + 1), for pairs on the unit circle of (product of two - 1), each over what it may
/// be; of equilibria the products of eigenvalues and of sums of two. At a graze the extreme nearest to zero of that
/// touch.
double vanishing_value(whirl_special kind, size_t touch, const whirl_orbit *orbit);

/// The two multipliers whose product is nearest to 1, or eigenvalues whose sum is nearest to 0: false where they are
/// real. *angle as whirl_branch_point has it.
bool vanishing_pair(const whirl_orbit *orbit, double *angle);

#endif
