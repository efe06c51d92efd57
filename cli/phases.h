/// What `whirl check` says of forces that do not turn with the shaft.
#ifndef CLI_PHASES_H
#define CLI_PHASES_H

#include "whirl/engine/rotor.h"
#include "whirl/engine/study.h"

/// Lines on standard output where forces of the batch's machines have phases of their own: by which phase sections are
/// taken (that of the shaft, or of the keyphasor of `rotor`), after how many revolutions forces repeat, or that they
/// fit none, and what the verdicts will be called. Errors as those of the machines.
whirl_status tell_phases(const whirl_study *study, const whirl_batch *batch, const whirl_rotor *rotor);

#endif
