/// Data sets: labels with their faults, and sensors.
#ifndef CASE_PLAN_DATASET_H
#define CASE_PLAN_DATASET_H

#include "machine.h"
#include "plan_course.h"
#include "plan_parts.h"
#include "schema.h"

/// Reads the data set of a study, if it has one.
void dataset_read(case_reader *reader, const machine_parts *machine, plan_parts *parts);

/// Adds the batch of a data set's records to the batches of plan_make. Its motions are long and dense enough for the
/// samples.
void dataset_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result);

/// Finds the run of a record, whose number is batch->sampled, with the values of its parameters: `keys` of the run, and
/// its course, to which it adds the lead. WHIRL_BAD_INPUT with a sentence.
whirl_status dataset_run(const setting_list *keys, const whirl_batch *batch, valuation *v, course_run *course,
                         whirl_runup_options *options);

#endif
