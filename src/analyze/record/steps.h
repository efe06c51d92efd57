/// Fixed steps that are too long for a motion, and what its verdict is worth then.
#ifndef ANALYZE_STEPS_H
#define ANALYZE_STEPS_H

#include <stdbool.h>

#include "whirl/engine/analyze.h"

/// Fills record->steps of a finished motion, by a few of its revolutions. Methods with a tolerance are left out.
whirl_status steps_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

/// Takes back what steps that are too long do not bear: the verdict where they are unstable or wrong, confidence where
/// they are coarse.
void steps_weigh(whirl_verdict *verdict, const whirl_step_quality *steps);

/// Why steps leave a verdict open; false where they do not.
bool steps_reason(const whirl_verdict *verdict, char *text, size_t size);

#endif
