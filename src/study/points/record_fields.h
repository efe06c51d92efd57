/// Fields of the records of a data set, in blocks of points.
#ifndef STUDY_RECORD_FIELDS_H
#define STUDY_RECORD_FIELDS_H

#include <stddef.h>

#include "whirl/engine/running.h"
#include "whirl/engine/study.h"

/// Adds the fields "dataset/..." of a data set. WHIRL_BAD_INPUT if it has too many fields.
whirl_status records_add_fields(const whirl_batch *batch, whirl_layout *layout);

/// Notes machine, label, severity and parameters of a record, by its index in the batch, and its signals, in its block.
/// Errors as whirl_channels_sample.
whirl_status records_note(const whirl_batch *batch, size_t point, const whirl_machine *machine,
                          const whirl_record *record, const whirl_layout *layout, double *block);

/// Prepares *motion, which the run of a record fills in. It has no instants if the point has no record of a run.
/// WHIRL_NO_MEMORY. Freed by records_run_free.
whirl_status records_run_new(const whirl_batch *batch, const whirl_machine *machine, whirl_run_motion *motion);
void records_run_free(whirl_run_motion *motion);

/// Returns the number of runs, at most `most` and at least 1, whose motions a thread may keep in memory at once: `most`
/// in a study without records. stations: number of stations in each motion.
size_t records_run_limit(const whirl_batch *batch, size_t stations, size_t most);

/// Notes a record as records_note does, from the motion of its run.
whirl_status records_note_run(const whirl_batch *batch, size_t point, const whirl_machine *machine,
                              const whirl_run_motion *motion, const whirl_layout *layout, double *block);

#endif
