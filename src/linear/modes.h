/// Room for modes, and those about a state that is known.
#ifndef LINEAR_MODES_H
#define LINEAR_MODES_H

#include "whirl/engine/linear.h"

/// For `count` modes and as many real eigenvalues, none of which are there yet; NULL without memory.
whirl_modes *modes_allocate(size_t dimension, size_t count);

/// whirl_modes_new, or (held) about a state that is taken for the equilibrium as it is.
whirl_status modes_about(const whirl_system *system, const double *start, bool held, whirl_modes **out);

#endif
