/// What `whirl check` says of forces that do not turn with the shaft.
#ifndef CLI_PHASES_H
#define CLI_PHASES_H

#include "whirl/study.h"

/// One line on standard output where forces of the batch's machines have phases of their own: after how many
/// revolutions they repeat, or that they fit none, and what the verdicts will be called. Errors as those of the
/// machines.
whirl_status tell_phases(const whirl_study *study, const whirl_batch *batch);

#endif
