/// Studies of tolerances: distributions of parameters, and batches of samples of other batches.
#ifndef CASE_PLAN_TOLERANCES_H
#define CASE_PLAN_TOLERANCES_H

#include "machine.h"
#include "plan_parts.h"
#include "schema.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/study.h"

/// Reads the distribution of the parameter that a key names; false after a problem with its name.
bool distribution_read(case_reader *reader, const file_node *where, distribution_parts *own);

/// Evaluates a distribution; returns false after a problem.
bool distribution_make(case_reader *reader, valuation *v, const distribution_parts *own, whirl_tolerance *to);

/// Reads distributions and limits.
void tolerances_read(case_reader *reader, plan_parts *parts);

/// Adds a batch of samples for every batch of points, motions or machines at rest, after all others.
void tolerances_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

#endif
