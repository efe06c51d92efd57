/// Checks of options of tori.
#ifndef ORBIT_TORUS_OPTIONS_H
#define ORBIT_TORUS_OPTIONS_H

#include "whirl/engine/torus.h"
#include "whirl/status.h"

/// Returns WHIRL_BAD_INPUT with a sentence for invalid options.
whirl_status torus_check_options(const whirl_torus_options *options);

#endif
