/// Starts from neighbours: every place of a study goes on from where motions of its neighbours ended, on attractors
/// that none of its own have come to, round after round.
///
/// What a round does follows from the blocks alone, and every such start has a slot of its own: threads, journals and
/// interruptions change no bit.
#ifndef STUDY_NEIGHBOURS_H
#define STUDY_NEIGHBOURS_H

#include "passes.h"

/// Makes the rounds of all batches that have them, once all their points are there, and confirmed where they are.
/// Stops are the tracker's. WHIRL_NO_MEMORY.
whirl_status neighbours_work(study_run *run);

/// Leaves in the tables the starts that were asked for. WHIRL_NO_MEMORY.
whirl_status neighbours_end(study_run *run);

/// Frees the origins.
void neighbours_free(study_run *run);

#endif
