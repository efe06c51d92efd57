/// How long a study takes, by a few of its revolutions.
#ifndef CLI_ESTIMATE_H
#define CLI_ESTIMATE_H

#include "whirl/engine/study.h"

/// Seconds that a batch takes on so many cores, to within a factor of two or so; of motions that settle at most. NaN
/// where it is not known: of branches, of machines at rest, which take next to nothing, and of very large ones;
/// infinite where a revolution takes over 5 s. Takes a tenth of a second or so itself, and no longer than a few
/// revolutions of one machine. WHIRL_NO_MEMORY.
whirl_status estimate_seconds(const whirl_study *study, const whirl_batch *batch, int cores, double *seconds);

#endif
