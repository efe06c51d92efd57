/// Where orbits of an even number of revolutions close after half of them: at the doubling of another branch.
#ifndef ORBIT_HALVED_H
#define ORBIT_HALVED_H

#include "follower.h"

/// Whether orbits close after half their time between two waypoints. There the branch ends, beyond which it is the same
/// as before, half its time later. By how much they are elsewhere after half the time goes through 0 there, and only
/// there it can turn round within a step.
bool halved_between(const waypoint *from, const waypoint *to);

/// Adds the last point of such a branch, where its orbits close after half their time. Errors are those of memory.
whirl_status halved_add(follower *f, const waypoint *from, const waypoint *to);

#endif
