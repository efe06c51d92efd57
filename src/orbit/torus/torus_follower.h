/// A branch of tori that is being followed.
#ifndef ORBIT_TORUS_FOLLOWER_H
#define ORBIT_TORUS_FOLLOWER_H

#include "curve.h"
#include "torus_equations.h"

/// A point on the way, with as many nodes as it takes.
typedef struct torus_waypoint {
    size_t count;        ///< nodes
    double *u, *tangent; ///< unknowns, room for the most nodes
    whirl_torus *torus;  ///< NULL: none was found
    bool rough;          ///< one was found that is not accurate with the most nodes
    double pace;         ///< curve_pace
} torus_waypoint;

typedef struct torus_follower {
    torus_equations equations;
    curve curve;
    const whirl_torus_branch_options *options;
    size_t room;                         ///< unknowns with the most nodes
    double *trial, *direction, *forward; ///< [room] of the search under way
} torus_follower;

/// Makes one at a value, for tori of so many revolutions; what turns on and on is at sections where it is in `at`
/// [dimension]. Its
/// curve has no nodes yet. Errors as torus_equations_make and those of options. Freed by torus_follower_end, whether it
/// was made or not.
whirl_status torus_follower_begin(torus_follower *f, const whirl_family *family, size_t revolutions, size_t dimension,
                                  const double *at, double value, const whirl_torus_branch_options *options);
void torus_follower_end(torus_follower *f);

whirl_status torus_waypoint_new(const torus_follower *f, torus_waypoint *out);
void torus_waypoint_free(torus_waypoint *p);

/// Gives the curve so many nodes, and lengths by the size of u, which has them. False where memory is lacking.
bool torus_follower_resize(torus_follower *f, size_t count, const double *u);

/// The point across `direction` from the trial, its tangent on the side of `forward`; the search has all three, with as
/// many nodes as the equations, and takes more where accuracy asks for them. WHIRL_NO_MEMORY.
whirl_status torus_follower_find(torus_follower *f, torus_waypoint *out);

#endif
