/// Functions of extended machines that are private to this folder, in addition to whirl/engine/sensitivity.h.
#ifndef STUDY_EXTENDED_H
#define STUDY_EXTENDED_H

#include <stdbool.h>

#include "whirl/engine/sensitivity.h"

/// Returns true if memory ran out in a function of the system, so that its numbers are not valid.
bool extended_exhausted(const whirl_extended *extended);

#endif
