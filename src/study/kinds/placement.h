/// Unbalances by rule (API 617): where they stand and how large they are, once for all points of a batch.
#ifndef STUDY_PLACEMENT_H
#define STUDY_PLACEMENT_H

#include "whirl/study.h"

/// Finds those that the options of the batch ask for: *placed [*count], to be freed by free; none where they ask for
/// none. They are of the machine as its parameters are without what varies, at the largest running speed.
/// WHIRL_BAD_INPUT with a sentence where that has no such mode or station; WHIRL_NO_MEMORY.
whirl_status placement_find(const whirl_study *study, const whirl_batch *batch, whirl_placed **placed, size_t *count);

#endif
