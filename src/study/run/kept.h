/// Blocks of a table that stay in the journal of its run: one at a time is in memory.
#ifndef STUDY_KEPT_H
#define STUDY_KEPT_H

#include "whirl/engine/study.h"

/// Leaves the blocks of a batch's table with the journal; states have `dimension` numbers. Freed by kept_free.
whirl_status kept_new(whirl_table *table, const whirl_keeper *keeper, size_t batch, size_t dimension);

void kept_free(whirl_kept_blocks *kept);

/// Drops the block in memory, after points of the table were moved.
void kept_forget(whirl_kept_blocks *kept);

/// Makes memory for the widths of a refined map's points, and notes one: the journal has blocks from before these were
/// known, and kept_block adds them. WHIRL_NO_MEMORY.
whirl_status kept_make_widths(const whirl_table *table);
void kept_note_width(const whirl_table *table, size_t point, double width);

/// Returns the block of a point, NULL if the journal lacks it; NaN for a point that is not done.
const double *kept_block(const whirl_table *table, size_t point);

#endif
