/// Contacts along an orbit, and how near it comes to beginning or losing one.
#ifndef ORBIT_TOUCH_H
#define ORBIT_TOUCH_H

#include "shooting.h"

/// Follows the orbit's nodes: its bounds and touches. WHIRL_NO_MEMORY; WHIRL_BAD_INPUT where the motion leaves its
/// bounds.
whirl_status touch_find(shooting *s, whirl_orbit *orbit);

#endif
