/// Whether the options of tori make sense.
#ifndef ORBIT_TORUS_OPTIONS_H
#define ORBIT_TORUS_OPTIONS_H

#include "whirl/engine/torus.h"

/// WHIRL_BAD_INPUT with a sentence where they do not.
whirl_status torus_check_options(const whirl_torus_options *options);

#endif
