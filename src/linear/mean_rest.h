/// The equilibrium of a mean system.
#ifndef LINEAR_MEAN_REST_H
#define LINEAR_MEAN_REST_H

#include "mean.h"

/// Finds the equilibrium, as whirl_equilibrium does, of a system that is already prepared.
whirl_status rest_find(mean_system *m, double *x);

#endif
