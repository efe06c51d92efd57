/// Branches of orbits, and curves of their special points over two parameters.
#ifndef STUDY_TRACING_H
#define STUDY_TRACING_H

#include "passes.h"

/// Traces what a pass is about into its table, which then has as many points as were found. Errors and stops are the
/// tracker's. WHIRL_NO_MEMORY.
whirl_status tracing_work(study_run *run, const pass *p);

#endif
