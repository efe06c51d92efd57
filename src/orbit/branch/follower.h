/// A branch that is being followed, and the parts of its continuation.
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

/// Makes one at a value. Errors as equations_make. Freed by follower_end, after a failure too.
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

/// Finds the point orthogonal to `direction` from u [unknowns], with its orbit, and its tangent on the side of `along`;
/// orbit NULL if none is found. The only error is WHIRL_NO_MEMORY.
whirl_status follower_find(follower *f, const double *u, const double *direction, const double *along, waypoint *out);
whirl_status waypoint_new(const follower *f, waypoint *out);
void waypoint_free(waypoint *p);

/// Prediction near two points a and b of a branch: by both if the branch is a function of its parameter and hardly
/// bent, else by the tangent of the point `from` alone.
///
/// Returns the direction orthogonal to which a point is searched: the parameter's own, so that its value and therefore
/// its machine stay the same, or the tangent. `direction` [unknowns] is scratch.
const double *follower_across(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from,
                              double *direction);

/// Predicts the point that is `length` along the tangent of `from`: by the cubic over the parameter through both points
/// with their tangents, or on the tangent.
void follower_predict(const follower *f, const waypoint *a, const waypoint *b, const waypoint *from, double length,
                      double *u);

/// Returns how far b is along the tangent of a. work [unknowns]
double follower_length(const follower *f, const waypoint *a, const waypoint *b, double *work);

/// Adds a point to a branch, which then owns the orbit; sets the end WHIRL_END_STOPPED if a stop was requested.
whirl_status branch_add(whirl_branch *branch, const whirl_branch_options *options, const whirl_branch_point *point);

/// Returns the final status of a continuation: after a stop that is the branch's end, and later errors except
/// WHIRL_NO_MEMORY are ignored.
whirl_status branch_finish(whirl_branch *branch, const whirl_branch_options *options, whirl_status status);

// ---------------------------------------------------------------- describe
// Orbits in memory.

/// Makes the orbit of nodes whose segments have just been carried with derivatives. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT if
/// it cannot be followed.
whirl_status orbit_describe(shooting *s, const double *nodes, double period, double residual, whirl_orbit **out);

/// Returns the index of the trivial multiplier of an orbit with a free period; SIZE_MAX for others.
size_t orbit_own_multiplier(const whirl_orbit *orbit);

// ---------------------------------------------------------------- distance
// Distances of states at sections.

/// Returns the distance of two states [dimension], over the largest coordinate of the first, without coordinates that
/// turn.
double states_distance(const whirl_system *system, const double *a, const double *b);

/// Returns the distance between sections of an orbit, in numbers of its nodes; an orbit with a free period has one
/// section.
size_t orbit_stride(const whirl_orbit *orbit);

// ---------------------------------------------------------------- halved
// Ends of branches of orbits with an even number of revolutions, where they close after half of them: at the doubling
// of another branch.

/// Returns true if orbits between two waypoints close after half their time. The branch ends there: beyond, it repeats
/// itself with a shift of half the time. The distance of an orbit from its half-time shift changes sign there, or turns
/// round within a step.
bool halved_between(const waypoint *from, const waypoint *to);

/// Adds the last point of such a branch, where its orbits close after half their time. The only error is
/// WHIRL_NO_MEMORY.
whirl_status halved_add(follower *f, const waypoint *from, const waypoint *to);

// ---------------------------------------------------------------- mirrored
// Pitchforks reached along their side branch.

/// Locates the pitchfork between two waypoints of its side branch: `out` with the orbit of the other branch there, or
/// without an orbit if there is none. *image is true if the side branch beyond it is its own mirror image. The only
/// error is WHIRL_NO_MEMORY.
whirl_status mirrored_locate(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out,
                             bool *image);

// ---------------------------------------------------------------- normal_form
// Criticality: whether the motion that begins at a special point exists where the orbit is unstable, or where it is
// stable.

/// Returns the cubic coefficient of the normal form at a doubling, a Neimark-Sacker or a Hopf point (Kuznetsov 2004,
/// 5.4) of an orbit whose segments were carried with derivatives; see whirl_branch_point, also for angle. NaN without
/// memory, if a motion near the orbit leaves its bounds, for other points, or if a pair of multipliers is within 1e-3
/// of a strong resonance (a third or a fourth of a turn).
double normal_form(shooting *s, const whirl_orbit *orbit, whirl_special kind, double angle);

// ---------------------------------------------------------------- rest
// Equations of an equilibrium, used in place of an orbit's.

/// Writes the accelerations at a node, of coordinates that do not turn: slope [kept]; with `derivatives` the matrix
/// becomes their Jacobian and the volume its trace. False if they are not finite.
bool rest_slope(shooting *s, const double *node, double *slope, bool derivatives);

/// Returns the largest row sum of the Jacobian.
double rest_rate(const shooting *s);

/// Returns the largest of the slope [kept], relative to a Jacobian of that rate times a coordinate of that size.
double rest_size(const shooting *s, const double *slope, double size, double rate);

// ---------------------------------------------------------------- special
// Special points: changes of stability, or of contact, along a branch.

/// Locates the special points between two waypoints and adds them to the branch in their order, except a fold where the
/// branch turns back at a pitchfork.
whirl_status special_locate(follower *f, const waypoint *from, const waypoint *to, bool pitchfork);

/// Locates where a multiplier passes 1 between two waypoints: `out` without an orbit if none does. The caller owns the
/// orbit. The only error is WHIRL_NO_MEMORY.
whirl_status special_crossing(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out);

// ---------------------------------------------------------------- touch
// Contacts along an orbit, and their distance from opening or closing.

/// Follows the orbit's nodes: sets its bounds and touches. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT if the motion leaves its
/// bounds.
whirl_status touch_find(shooting *s, whirl_orbit *orbit);

// ---------------------------------------------------------------- vanishing
// Test functions of an orbit, which vanish at special points.

/// Returns the test function of a kind. Folds and crossings: the product of (multiplier - 1); doublings: of (multiplier
/// + 1); pairs on the unit circle: of (product of two - 1); each over its possible size. Equilibria: the products of
/// eigenvalues and of sums of two. Grazes: the touch's extreme nearest to zero.
double vanishing_value(whirl_special kind, size_t touch, const whirl_orbit *orbit);

/// Finds the two multipliers whose product is nearest to 1, or eigenvalues whose sum is nearest to 0: false if they are
/// real. *angle as whirl_branch_point has it.
bool vanishing_pair(const whirl_orbit *orbit, double *angle);

#endif
