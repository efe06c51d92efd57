/// Blocks of a table that stay in the journal of its run: one at a time is in memory.
#ifndef STUDY_JOURNAL_BLOCKS_H
#define STUDY_JOURNAL_BLOCKS_H

#include "whirl/engine/study.h"

/// Leaves the blocks of a batch's table with the journal; states have `dimension` numbers. Freed by
/// journal_blocks_free.
whirl_status journal_blocks_new(whirl_table *table, const whirl_point_store *journal, size_t batch, size_t dimension);

void journal_blocks_free(whirl_journal_blocks *blocks);

/// Drops the block in memory, after points of the table were moved.
void journal_blocks_forget(whirl_journal_blocks *blocks);

/// Allocate memory for the widths of a refined map's points, and note one width. Blocks in the journal were written
/// before the widths were known; journal_blocks_of fills them in. WHIRL_NO_MEMORY.
whirl_status journal_blocks_make_widths(const whirl_table *table);
void journal_blocks_note_width(const whirl_table *table, size_t point, double width);

/// Returns the block of a point, NULL if the journal lacks it; NaN for a point that is not done.
const double *journal_blocks_of(const whirl_table *table, size_t point);

#endif
