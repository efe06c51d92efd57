/// Computes passes of a run, on all threads.
#ifndef STUDY_PASSES_H
#define STUDY_PASSES_H

#include <stddef.h>

#include "pass.h"
#include "study_run.h"

/// Computes the points of all passes, on all threads. The tracker reports errors and stops. WHIRL_NO_MEMORY.
whirl_status passes_work(study_run *run, const pass *passes, size_t count);

/// Returns the outcome of a stage, after its threads have ended: WHIRL_STOPPED if a stop came before its last point.
whirl_status passes_outcome(const study_run *run);

#endif
