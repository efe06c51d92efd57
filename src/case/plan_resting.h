/// Studies of machines at rest, any number of them in a case, each at every condition that the case names.
#ifndef CASE_PLAN_RESTING_H
#define CASE_PLAN_RESTING_H

#include "machine.h"
#include "plan_parts.h"
#include "schema.h"

/// Reads the studies of machines at rest, and their conditions.
void resting_read(case_reader *reader, const machine_parts *machine, plan_parts *parts);

/// Makes the batches of studies at rest after the existing ones, as plan_make does.
void resting_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

#endif
