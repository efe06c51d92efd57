/// The equilibrium of a mean system.
#ifndef LINEAR_MEAN_REST_H
#define LINEAR_MEAN_REST_H

#include "mean.h"

/// Finds the equilibrium of a system that is already prepared, as whirl_equilibrium does.
whirl_status rest_find(mean_system *m, double *x);

#endif
