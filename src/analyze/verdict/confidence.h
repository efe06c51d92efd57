/// How far a verdict can be trusted, and what would settle it.
#ifndef ANALYZE_CONFIDENCE_H
#define ANALYZE_CONFIDENCE_H

#include "evidence.h"

/// Fills agreement, confidence and advice of a verdict on a bounded motion, from the evidence that it rests on.
void weigh_verdict(whirl_verdict *verdict, const evidence *e, const whirl_record *record);

/// Whether the section of a motion grows as perturbations do: it leaves an unstable one, as a linear machine does.
bool weigh_swelling(const whirl_verdict *verdict);

#endif
