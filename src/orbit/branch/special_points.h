/// Special points: changes of stability, or of contact, along a branch.
#ifndef ORBIT_SPECIAL_POINTS_H
#define ORBIT_SPECIAL_POINTS_H

#include <stdbool.h>

#include "follower.h"
#include "whirl/engine/branch.h"

/// Locates the special points between two waypoints, and adds them to the branch in their order. A fold is left out if
/// `pitchfork` is true: the branch turns back there at a pitchfork.
whirl_status special_locate(follower *f, const waypoint *from, const waypoint *to, bool pitchfork);

/// Locates where a multiplier passes 1 between two waypoints. `out` has no orbit if none does; otherwise the caller
/// owns the orbit. The only error is WHIRL_NO_MEMORY.
whirl_status special_crossing(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out);

#endif
