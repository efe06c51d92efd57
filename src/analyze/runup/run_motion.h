/// The motion of a run at equal times, interpolated between computed states.
#ifndef ANALYZE_RUN_MOTION_H
#define ANALYZE_RUN_MOTION_H

#include "archive.h"
#include "whirl/engine/running.h"

/// A computed state by time.
typedef struct motion_node {
    const double *state, *slope; ///< [dimension] and its derivative
    double angle, speed;         ///< rad, and rad over the unit of time
} motion_node;

/// Begins the motion: instants before the time 0 have the state at the beginning, and that angle, rad.
void run_motion_begin(whirl_run_motion *to, const whirl_probe *probes, const double *state, double angle);

/// Fills in the instants from `begin` to before `end`, s, the times of two computed states that are `step` units of
/// time apart. Displacements are of the fifth degree in time between both: they have the places, velocities and
/// accelerations of both states. Angles are cubic, which is exact where the rate of the speed is constant.
void run_motion_fill(whirl_run_motion *to, const whirl_probe *probes, const motion_node *low, const motion_node *high,
                     double begin, double end, double step);

/// Writes the instants filled in so far to an archive, or reads them from it.
void run_motion_archive(whirl_run_motion *motion, archive *a);

#endif
