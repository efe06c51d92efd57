/// Previews, and their provisional verdicts.
#ifndef EXPLORER_LOOKS_H
#define EXPLORER_LOOKS_H

#include "core.h"

/// Returns true if a run of the requested length may change this block's verdict.
bool look_is_provisional(const plan *p, const double *block);

/// Sets the verdict of a provisional point to "undetermined"; its evidence stays.
void look_withhold(const plan *p, double *block);

/// Writes the reason why there is no verdict, a sentence.
void look_reason(const plan *p, text *sentence);

#endif
