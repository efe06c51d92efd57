/// Tori that begin at the Neimark-Sacker points of branches.
#ifndef STUDY_TORI_H
#define STUDY_TORI_H

#include "passes.h"

/// Follows those of a pass, whose batch stands after that of the branches, on all threads. Errors and stops are the
/// tracker's.
whirl_status tori_work(study_run *run, const pass *p);

#endif
