/// Where a mean system rests.
#ifndef LINEAR_REST_H
#define LINEAR_REST_H

#include "mean.h"

/// whirl_equilibrium of a system that is prepared.
whirl_status rest_find(mean_system *m, double *x);

#endif
