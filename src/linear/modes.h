/// Room for modes.
#ifndef LINEAR_MODES_H
#define LINEAR_MODES_H

#include "whirl/linear.h"

/// For `count` modes and as many real eigenvalues, none of which are there yet; NULL without memory.
whirl_modes *modes_allocate(size_t dimension, size_t count);

#endif
