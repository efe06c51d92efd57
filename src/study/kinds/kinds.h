/// The kinds of points that studies compute (whirl_kind), each with how it is computed and shared: one file of this
/// folder and one line of the registry.
#ifndef STUDY_KINDS_H
#define STUDY_KINDS_H

#include "passes.h"

typedef struct study_kind {
    const char *name; ///< of its whirl_kind
    size_t piece;     ///< points that stay together where they are shared or dealt out and are not carried; 0: all
    /// Computes the points of a pass, on all threads; errors and stops are the tracker's; WHIRL_NO_MEMORY. NULL: they
    /// are drawn from chains, side by side with those of other passes.
    whirl_status (*work)(study_run *run, const pass *p);
} study_kind;

/// Of the points of a batch.
const study_kind *study_kind_of(const whirl_batch *batch);

extern const study_kind rest_kind, branch_kind, torus_kind;

#endif
