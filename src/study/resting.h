/// Points of machines at rest, whose motion is not followed.
#ifndef STUDY_RESTING_H
#define STUDY_RESTING_H

#include "passes.h"

/// Computes the points of a pass, on all threads. Errors and stops are the tracker's. WHIRL_NO_MEMORY.
whirl_status resting_work(study_run *run, const pass *p);

#endif
