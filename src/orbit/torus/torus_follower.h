/// A branch of tori that is being followed, and the parts of its continuation.
#ifndef ORBIT_TORUS_FOLLOWER_H
#define ORBIT_TORUS_FOLLOWER_H

#include "curve.h"
#include "torus_equations.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/torus_branch.h"
#include "whirl/status.h"

#include <stddef.h>

/// A point of the continuation, with as many nodes as it needs.
typedef struct torus_waypoint {
    size_t count;        ///< number of nodes
    double *u, *tangent; ///< unknowns, with space for the most nodes
    whirl_torus *torus;  ///< NULL: none was found
    bool rough;          ///< true if a torus was found that is not accurate even with the most nodes
    double pace;         ///< curve_pace
} torus_waypoint;

typedef struct torus_follower {
    torus_equations equations;
    curve curve;
    const whirl_torus_branch_options *options;
    size_t capacity;                     ///< number of unknowns with the most nodes
    double *trial, *direction, *forward; ///< [capacity] of the present search
} torus_follower;

/// Makes the follower at a value, for tori of `revolutions` revolutions. Turning coordinates at sections are those of
/// the state `at` [dimension]. Its curve has no nodes yet. Errors as torus_equations_make, and of invalid options.
/// Freed by torus_follower_end, after a failure too.
whirl_status torus_follower_begin(torus_follower *f, const whirl_family *family, size_t revolutions, size_t dimension,
                                  const double *at, double value, const whirl_torus_branch_options *options);
void torus_follower_end(torus_follower *f);

whirl_status torus_waypoint_new(const torus_follower *f, torus_waypoint *out);
void torus_waypoint_free(torus_waypoint *p);

/// Gives the curve `count` nodes, and unit lengths by the size of u, which has as many. Returns false without memory.
bool torus_follower_resize(torus_follower *f, size_t count, const double *u);

/// Finds the point orthogonal to `direction` from `trial`, and its tangent on the side of `forward`. These three
/// members have as many nodes as the equations. Uses more nodes if accuracy requires them. WHIRL_NO_MEMORY.
whirl_status torus_follower_find(torus_follower *f, torus_waypoint *out);

#endif
