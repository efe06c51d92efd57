/// Fixed steps that are too long for a motion, tolerances that are too coarse for it, and their effect on its verdict.
#ifndef ANALYZE_STEPS_H
#define ANALYZE_STEPS_H

#include <stdbool.h>
#include <stddef.h>

#include "section.h"

/// Fills record->steps of a finished motion whose record->rest is known. Fixed steps are judged by a few revolutions of
/// the motion, the absolute tolerance by the motion's size.
whirl_status steps_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record);

/// Corrects a verdict for steps that are too long: it becomes undetermined if they are unstable or far from the exact
/// motion, and loses confidence if they are coarse.
void steps_weigh(whirl_verdict *verdict, const whirl_step_quality *steps);

/// Writes why steps leave a verdict undetermined; false if they do not.
bool steps_reason(const whirl_verdict *verdict, char *text, size_t size);

#endif
