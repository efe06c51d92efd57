/// Orbits at which branches begin: those on which a motion settles.
#ifndef STUDY_SETTLED_H
#define STUDY_SETTLED_H

#include "whirl/engine/study.h"

/// Returns options for following branches of a batch within its bounds, with up to `most_points` points.
whirl_branch_options settled_options(const whirl_batch *batch, size_t most_points);

/// Finds the orbit near which the machine of a value settles, or its equilibrium, as the batch's trace says. Errors
/// name the parameter and its value.
whirl_status settled_orbit(const whirl_study *study, const whirl_batch *batch, double value, whirl_orbit **orbit);

#endif
