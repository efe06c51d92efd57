/// A machine of a batch as analyses at rest take it, with functions that make it at other speeds.
#ifndef STUDY_RESTING_POINT_H
#define STUDY_RESTING_POINT_H

#include "whirl/engine/study.h"

/// A batch at a value of its parameter.
typedef struct resting_place {
    const whirl_study *study;
    const whirl_batch *batch; ///< with the placed unbalances
    double value;
} resting_place;

/// Returns the point of a machine without modes, critical points and other equilibria. It borrows the place and the
/// machine.
whirl_resting resting_point_of(const resting_place *at, const whirl_machine *machine);

#endif
