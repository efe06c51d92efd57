/// Where the stability of orbits changes along a branch, or a contact.
#ifndef ORBIT_SPECIAL_H
#define ORBIT_SPECIAL_H

#include "follower.h"

/// Special points between two waypoints: adds them to the branch in their
/// order.
whirl_status special_locate(follower *f, const waypoint *from, const waypoint *to);

#endif
