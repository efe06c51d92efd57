/// RK4 with disturbances over vector lanes: the block of memory that a kernel works on.
#ifndef INTEGRATE_VARIATIONAL_LANES_H
#define INTEGRATE_VARIATIONAL_LANES_H

#include <stddef.h>

#include "lanes.h"

/// Arrays of the state and its disturbances are [1 + disturbances][rows][stride vectors].
typedef struct variational_lanes {
    const void *model; ///< whose structure all lanes have
    lanes_flow *flow;
    size_t stride, lane_count;
    size_t degrees, disturbances, forcing_count;
    size_t rates;     ///< velocities, and states of first order after them
    int steps, often; ///< disturbances are made orthonormal after every `often` steps
    double step;
    const double *forcing; ///< [2 steps + 1][forcing_count]
    double *numbers;
    double *q, *v, *k[3], *stage_q, *stage_v; ///< rows are degrees of q, rates of all else
    double *now;                              ///< [forcing_count] of all lanes
    double *divergence[4];                    ///< [1] at the stages
    double *volume;                           ///< [1] its integral
    double *lengths; ///< [disturbances] products of what was left of them since the last call of `note`
    void (*note)(struct variational_lanes *lanes); ///< takes their logarithms
    double *growth;                                ///< [disturbances]
} variational_lanes;

typedef void variational_lanes_revolve(variational_lanes *lanes);

/// One for every instruction set of vector.h; NULL where it is not built.
extern variational_lanes_revolve *const variational_lanes_revolves[];
variational_lanes_revolve variational_lanes_scalar, variational_lanes_128, variational_lanes_fma,
    variational_lanes_avx2, variational_lanes_avx512;

#endif
