/// Ends of branches of orbits with an even number of revolutions, where they close after half of them: at the doubling
/// of another branch.
#ifndef ORBIT_HALVED_H
#define ORBIT_HALVED_H

#include <stdbool.h>

#include "follower.h"

/// Returns true if orbits between two waypoints close after half their time. The branch ends there: beyond, it repeats
/// itself with a shift of half the time. The difference of an orbit from its half-time shift reverses its direction
/// between the waypoints.
bool halved_between(const waypoint *from, const waypoint *to);

/// Adds the last point of such a branch, where its orbits close after half their time. The only error is
/// WHIRL_NO_MEMORY.
whirl_status halved_add(follower *f, const waypoint *from, const waypoint *to);

#endif
