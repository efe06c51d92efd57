/// The motion of a run at equal times, interpolated between computed states.
#ifndef ANALYZE_RUN_MOTION_H
#define ANALYZE_RUN_MOTION_H

#include "archive.h"
#include "whirl/engine/running.h"

/// A computed state, by time or by the angle of the shaft.
typedef struct motion_node {
    const double *state, *slope; ///< [dimension] and its derivative by the same variable
    double time;                 ///< s
    double angle, speed, rate;   ///< rad; rad per unit of time; derivative of the speed by time
    bool by_time;                ///< derivatives of the state are by time, not by the angle
} motion_node;

/// Returns true if the time of the next instant is before `end`, s; given times also if they are as late, but for
/// rounding.
bool run_motion_reaches(const whirl_run_motion *to, double end);

/// Begins the motion: instants before time 0 get the displacements of `state` and `angle`, rad.
void run_motion_begin(whirl_run_motion *to, const whirl_probe *probes, const double *state, double angle);

/// Fills in the instants from the first state to before the second one. unit: the unit of time, s. Displacements are
/// polynomials of the fifth degree in time, which have the places, velocities and accelerations of both states at the
/// ends. Angles are cubic in time, which is exact where the rate of the speed is constant.
void run_motion_fill(whirl_run_motion *to, const whirl_probe *probes, const motion_node *low, const motion_node *high,
                     double unit);

/// Returns the error of interpolation at a computed state `middle`: the largest distance of its displacements from
/// those interpolated between the states before and after it, in the machine's unit of length. Raises *size to the
/// largest displacement at `middle`. unit: as in run_motion_fill.
double run_motion_error(size_t probe_count, const whirl_probe *probes, const motion_node *low,
                        const motion_node *middle, const motion_node *high, double unit, double *size);

/// Writes the instants filled in so far to an archive, or reads them from it.
void run_motion_archive(whirl_run_motion *motion, archive *a);

#endif
