/// Prints, for `whirl check`, how forces repeat that do not turn with the shaft.
#ifndef CLI_PHASES_H
#define CLI_PHASES_H

#include "whirl/engine/rotor.h"
#include "whirl/engine/study.h"

/// Prints lines if forces of the batch's machines do not repeat with the shaft: the phase of sections (the shaft's, or
/// that of the keyphasor of `rotor`), the period of the forces or that they have none, and the names of the verdicts.
/// Returns errors of the machines.
whirl_status print_phases(const whirl_study *study, const whirl_batch *batch, const whirl_rotor *rotor);

#endif
