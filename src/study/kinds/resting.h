/// Points of machines at rest, whose motion is not followed.
#ifndef STUDY_RESTING_H
#define STUDY_RESTING_H

#include "passes.h"

/// Points that one thread, or one share, takes at a time: neighbours share the modes of the point between them.
enum { RESTING_PIECE = 8 };

/// Computes the points of a pass, on all threads. Errors and stops are the tracker's. WHIRL_NO_MEMORY.
whirl_status resting_work(study_run *run, const pass *p);

#endif
