/// Confidence of a verdict, and what would improve it.
#ifndef ANALYZE_CONFIDENCE_H
#define ANALYZE_CONFIDENCE_H

#include <stdbool.h>

#include "evidence.h"

/// Fills agreement, confidence and advice of a verdict on a bounded motion, from the evidence that it rests on.
void weigh_verdict(whirl_verdict *verdict, const evidence *e, const whirl_record *record);

/// Returns the mean life of chaos below which values are excluded at 95 %, given that no perturbed copy left the chaos.
double verdict_least_life(const whirl_verdict *verdict);

/// Returns true if the section of a motion grows at the rate of perturbations: the motion leaves an unstable one, as in
/// an unstable linear machine.
bool weigh_swelling(const whirl_verdict *verdict);

#endif
