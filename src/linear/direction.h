/// The direction of a whirl.
#ifndef LINEAR_DIRECTION_H
#define LINEAR_DIRECTION_H

#include "whirl/engine/system.h"

/// Writes twice the signed area of two shapes, a Hermitian form, to out [2]. The area of a shape with itself, divided
/// by the shape's size, is its direction: above 0 forward.
void direction_area(const whirl_system *system, const double *a, const double *b, double out[2]);

/// Sets displacements of probes that are rounding to 0, for a mode v [dimension][2] that moves no probe: a mode of
/// tilts alone, or of a node between stations.
void direction_drop_rounding(const whirl_system *system, double *v);

/// Direction (whirl_mode.direction) of a motion Re(v exp(i w t)), v [dimension][2].
double whirl_direction(const whirl_system *system, const double *v);

#endif
