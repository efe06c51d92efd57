/// Memory for modes, and modes about a known state.
#ifndef LINEAR_MODES_H
#define LINEAR_MODES_H

#include "whirl/engine/linear.h"

/// Allocates memory for `count` modes and `count` real eigenvalues, with both counts at 0. Returns NULL without memory.
whirl_modes *modes_allocate(size_t dimension, size_t count);

/// Computes the shares of twists and of axial displacements in the kinetic energy of a shape [dimension][2], as in
/// whirl_mode.
void modes_shares(const whirl_system *system, const double *shape, double *torsion, double *axial);

/// Moves overdamped modes behind the others, and keeps the order within both groups.
whirl_status modes_put_overdamped_last(whirl_modes *modes);

/// Computes the modes in the order of rising imaginary part, about the equilibrium, which is searched from `start`. If
/// `held`, `start` itself counts as the equilibrium.
whirl_status modes_about(const whirl_system *system, const double *start, bool held, whirl_modes **out);

#endif
