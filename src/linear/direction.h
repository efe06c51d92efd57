/// The direction of a whirl.
#ifndef LINEAR_DIRECTION_H
#define LINEAR_DIRECTION_H

#include "whirl/engine/system.h"

/// Writes twice the signed area of two shapes, a Hermitian form, to out [2]. The area of a shape with itself, divided
/// by the size of the shape, is its direction: above 0 forward.
void direction_area(const whirl_system *system, const double *a, const double *b, double out[2]);

/// Sets the displacements of probes to 0 in a mode v [dimension][2] in which they are rounding: a mode of tilts alone,
/// or of a node between stations.
void direction_drop_rounding(const whirl_system *system, double *v);

/// Returns the direction (whirl_mode.direction) of a motion Re(v exp(i w t)), v [dimension][2].
double whirl_direction(const whirl_system *system, const double *v);

#endif
