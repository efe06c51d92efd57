/// Studies of machines at rest, any number of them in a case, each at every condition that the case names.
#ifndef CASE_PLAN_RESTING_H
#define CASE_PLAN_RESTING_H

#include "plan.h"

/// Reads the studies of machines at rest, and the conditions that they are done at.
void resting_read(case_reader *reader, const machine_parts *machine, plan_parts *parts);

/// Makes their batches, behind those that are there, as plan_make does.
void resting_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

#endif
