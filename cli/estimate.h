/// Estimates the duration of a study from a few of its revolutions.
#ifndef CLI_ESTIMATE_H
#define CLI_ESTIMATE_H

#include "whirl/engine/study.h"

/// Estimates the seconds that a batch takes on `cores` cores, to within a factor of about two; an upper bound if the
/// study ends transients early (`settle`). NaN if unknown: for branches, very large studies, and studies at rest,
/// except modes that take a second or more. Infinite if a revolution takes over 5 s. The estimate takes about a tenth
/// of a second, at most a few revolutions of one machine. WHIRL_NO_MEMORY.
whirl_status estimate_seconds(const whirl_study *study, const whirl_batch *batch, int cores, double *seconds);

#endif
