/// Pitchforks that are reached on their side branch.
#ifndef ORBIT_MIRRORED_H
#define ORBIT_MIRRORED_H

#include <stdbool.h>

#include "follower.h"
#include "whirl/engine/branch.h"

/// Locates the pitchfork between two waypoints of its side branch. `out` receives the orbit of the other branch there,
/// or no orbit if there is none. *image becomes true if the side branch beyond the pitchfork is its own mirror image.
/// The only error is WHIRL_NO_MEMORY.
whirl_status mirrored_locate(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out,
                             bool *image);

#endif
