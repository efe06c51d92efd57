/// What lies between two neighbouring points of a study of machines at rest.
#ifndef STUDY_CRITICAL_H
#define STUDY_CRITICAL_H

#include "whirl/engine/study.h"

/// A machine of a batch at rest, with its modes.
typedef struct resting_machine {
    whirl_machine machine;
    whirl_modes *modes;
    double value;
} resting_machine;

/// Makes one. Errors as those of the machine, and of whirl_modes_new.
whirl_status resting_new(const whirl_study *study, const whirl_batch *batch, double value, resting_machine *out);
void resting_free(resting_machine *r);

/// Locates critical speeds and thresholds of stability between two points, to 1e-10 of the parameter: at most `most`
/// are written to found, *count is how many.
whirl_status critical_locate(const whirl_study *study, const whirl_batch *batch, const resting_machine *from,
                             const resting_machine *to, whirl_critical *found, size_t most, size_t *count);

#endif
