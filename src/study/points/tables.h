/// Tables of the result of a run.
#ifndef STUDY_TABLES_H
#define STUDY_TABLES_H

#include <stddef.h>

#include "study_run.h"
#include "whirl/engine/study.h"

/// Makes a result with one table a batch, without blocks. *result holds what was made also after a failure.
whirl_status tables_new(const whirl_study *study, whirl_result **result);

/// Makes the blocks, or leaves those of tables of `memory` bytes or more (0: 256 MB) in the journal.
whirl_status tables_fill(const study_run *run, size_t memory);

/// Reduces a table to the slots with wanted [count] not 0, and records their old indices in table->slots.
/// WHIRL_NO_MEMORY.
whirl_status table_close_up(whirl_table *table, const unsigned char *wanted);

/// Sets the blocks of points that are not done to NaN.
void tables_blank(whirl_result *result);

#endif
