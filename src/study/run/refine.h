/// Computes doubtful points again.
#ifndef STUDY_REFINE_H
#define STUDY_REFINE_H

#include "study_run.h"

/// Computes doubtful points again until the budget is spent or none is left. The tracker reports stops.
whirl_status refine_points(study_run *run);

#endif
