/// First looks, and the verdicts that they do not give.
#ifndef EXPLORER_LOOKS_H
#define EXPLORER_LOOKS_H

#include "core.h"

/// Whether a run at the length that was asked for may say something else than this block.
bool look_is_provisional(const plan *p, const double *block);

/// Makes the block of a provisional point say "undetermined"; its evidence stays.
void look_withhold(const plan *p, double *block);

/// Why there is no verdict, in a sentence.
void look_reason(const plan *p, text *sentence);

#endif
