/// Derivatives of the numbers of every point by parameters of the case.
#ifndef CASE_PLAN_SENSITIVITY_H
#define CASE_PLAN_SENSITIVITY_H

#include "plan_parts.h"
#include "schema.h"

/// Reads the parameters, and the numbers that are asked for.
void sensitivity_read(case_reader *reader, plan_parts *parts);

/// Asks for the derivatives at every point of the batches that have some: of responses, sweeps, branches and studies of
/// machines at rest.
void sensitivity_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

#endif
