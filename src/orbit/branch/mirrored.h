/// Pitchforks reached along their side branch.
#ifndef ORBIT_MIRRORED_H
#define ORBIT_MIRRORED_H

#include <stdbool.h>

#include "follower.h"
#include "whirl/engine/branch.h"

/// Locates the pitchfork between two waypoints of its side branch: `out` with the orbit of the other branch there, or
/// without an orbit if there is none. *image is true if the side branch beyond it is its own mirror image. The only
/// error is WHIRL_NO_MEMORY.
whirl_status mirrored_locate(follower *f, const waypoint *from, const waypoint *to, whirl_branch_point *out,
                             bool *image);

#endif
