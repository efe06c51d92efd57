/// The equilibrium of a mean system.
#ifndef LINEAR_EQUILIBRIUM_H
#define LINEAR_EQUILIBRIUM_H

#include "mean.h"

/// Finds the equilibrium of a system that is already prepared, as whirl_equilibrium does.
whirl_status rest_find(mean_system *m, double *x);

#endif
