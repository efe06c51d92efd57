/// Machines of a study whose speed changes.
#ifndef SUPPORT_RUNS_H
#define SUPPORT_RUNS_H

#include "whirl/engine/running.h"
#include "whirl/engine/study.h"

/// A point of the first batch of a study.
typedef struct run_point {
    const whirl_study *study;
    double value;                ///< of the batch's parameter
    size_t count;                ///< events of its run that have happened
    const unsigned char *events; ///< [count] their indices, in their order
    const whirl_stop *stop;      ///< NULL, or ends its runs
} run_point;

/// Makes the machine of a point with its own bearings at a speed, rad/s, 0: its own; spools: as whirl_machine_at.
/// `context` is a run_point.
whirl_status run_point_machine(const void *context, double speed, const double *spools, whirl_machine *machine);

#endif
