/// Options with which a study's points find orbits.
#ifndef STUDY_ORBIT_OPTIONS_H
#define STUDY_ORBIT_OPTIONS_H

#include "whirl/engine/orbit.h"

/// Returns options for orbits by the method "rodas5p", or else dop853, at a relative tolerance.
whirl_orbit_options orbit_options_by(const char *method, double rtol);

#endif
