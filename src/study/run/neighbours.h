/// Starts from neighbours: each place of a study is started from the ends of its neighbours' motions on attractors that
/// none of its own starts reached, round after round. A round depends on the blocks alone, and every such start has its
/// own slot, so threads, journals and interruptions change no bit.
#ifndef STUDY_NEIGHBOURS_H
#define STUDY_NEIGHBOURS_H

#include "study_run.h"

/// Runs the rounds of all batches that ask for them, after all points are computed and confirmed. The tracker reports
/// stops. WHIRL_NO_MEMORY.
whirl_status neighbours_work(study_run *run);

/// Removes from the tables the slots of starts that were never used. WHIRL_NO_MEMORY.
whirl_status neighbours_end(study_run *run);

/// Frees the origins.
void neighbours_free(study_run *run);

#endif
