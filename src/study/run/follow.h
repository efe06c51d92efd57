/// Follows chaotic motions that may be transient.
#ifndef STUDY_FOLLOW_H
#define STUDY_FOLLOW_H

#include <stddef.h>

#include "study_run.h"

/// Follows chaotic motions whose chaos may end, as far as the budget allows, and subtracts their cost from it. *done is
/// their number. The tracker reports stops.
whirl_status follow_points(study_run *run, int round, double *budget, size_t *done);

#endif
