/// Contacts along an orbit, and their distance from opening or closing.
#ifndef ORBIT_TOUCH_H
#define ORBIT_TOUCH_H

#include "shooting.h"
#include "whirl/engine/orbit.h"

/// Follows the orbit's nodes: sets its bounds and touches. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT if the motion leaves its
/// bounds.
whirl_status touch_find(shooting *s, whirl_orbit *orbit);

#endif
