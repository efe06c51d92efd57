/// Points of a pass that belong to this run, if several runs share a study.
#ifndef STUDY_SHARE_H
#define STUDY_SHARE_H

#include "pass.h"
#include "study_run.h"

/// Reduces a pass over all points of a batch to those of the run's share, or to those that may be dealt to it; its
/// slots are to be freed. WHIRL_NO_MEMORY.
whirl_status share_pass(const study_run *run, pass *p);

/// Reduces a pass that confirms carried points to the points that this run has computed.
void share_confirmed(const study_run *run, pass *p);

#endif
