/// The direction of a whirl.
#ifndef LINEAR_DIRECTION_H
#define LINEAR_DIRECTION_H

#include "whirl/engine/system.h"

/// Twice the signed area that two shapes share, out [2], a Hermitian form: that of a shape with itself is its
/// direction, but for its size. Above 0 forward.
void direction_area(const whirl_system *system, const double *a, const double *b, double out[2]);

/// Of a motion Re(v exp(i w t)), v [dimension][2]: whirl_mode.direction.
double whirl_direction(const whirl_system *system, const double *v);

#endif
