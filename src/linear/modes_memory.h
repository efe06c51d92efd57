/// Memory for modes, and modes about a known state.
#ifndef LINEAR_MODES_MEMORY_H
#define LINEAR_MODES_MEMORY_H

#include "whirl/engine/linear.h"

/// Allocates room for `count` modes and `count` real eigenvalues, with both counts at 0; NULL without memory.
whirl_modes *modes_allocate(size_t dimension, size_t count);

/// Moves overdamped modes behind the others and keeps the order of both.
whirl_status modes_put_overdamped_last(whirl_modes *modes);

/// Computes the modes by rising imaginary part, about the equilibrium; if `held`, about `start`, which then counts as
/// the equilibrium.
whirl_status modes_about(const whirl_system *system, const double *start, bool held, whirl_modes **out);

#endif
