/// How far a verdict can be trusted, and what would settle it.
#ifndef ANALYZE_CONFIDENCE_H
#define ANALYZE_CONFIDENCE_H

#include "whirl/analyze.h"

/// Fills agreement, confidence and advice of a verdict that is judged. `record` is what it was judged from.
void weigh_verdict(whirl_verdict *verdict, const whirl_record *record);

#endif
