/// Lanes of an ensemble that integrators carry, one after the other: any system and method.
#ifndef INTEGRATE_ENSEMBLE_ALONE_H
#define INTEGRATE_ENSEMBLE_ALONE_H

#include "rk4_lanes.h"
#include "whirl/engine/ensemble.h"

typedef struct alone_lanes {
    whirl_integrate_options options;
    size_t followed; ///< most perturbations
    size_t dimension, lane_count;
    whirl_integrator **integrator; ///< [lane_count] NULL: empty lane
    double *state;                 ///< [dimension] workspace
    double *samples;               ///< [sample_capacity][dimension][lane_count]
    size_t sample_capacity;
    // The ensemble whose lanes are carried.
    double *x, *ended;             ///< [dimension][lane_count]; [lane_count] whirl_motion
    const whirl_system **machines; ///< [lane_count]
    whirl_perturbations **beside;  ///< [lane_count] perturbations carried in the next revolution; NULL: none
    const lanes_observe *watched;
} alone_lanes;

/// Makes lanes without machines. Returns NULL without memory.
alone_lanes *alone_lanes_new(const whirl_integrate_options *options, size_t followed, size_t dimension,
                             size_t lane_count);
void alone_lanes_free(alone_lanes *alone);

/// Makes an integrator for the machine of a lane. With a machine of NULL, removes the integrator. Errors as
/// whirl_integrator_new.
whirl_status alone_lanes_load(const alone_lanes *alone, size_t lane, const whirl_system *system);

/// Moves the integrator of a lane to an empty lane.
void alone_lanes_move(const alone_lanes *alone, size_t from, size_t to);

/// Carries the lanes 0 to count - 1 over a revolution. Returns the number of its samples.
size_t alone_lanes_revolve(alone_lanes *alone, size_t count, const whirl_ensemble_observe *observe);

#endif
