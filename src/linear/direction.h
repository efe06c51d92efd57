/// The direction of a whirl.
#ifndef LINEAR_DIRECTION_H
#define LINEAR_DIRECTION_H

#include "whirl/system.h"

/// Of a motion Re(v exp(i w t)), v [dimension][2]: whirl_mode.direction.
double whirl_direction(const whirl_system *system, const double *v);

#endif
