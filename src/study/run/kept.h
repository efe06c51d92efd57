/// Blocks of a table that lie with the keeper of its run: one at a time is in memory.
#ifndef STUDY_KEPT_H
#define STUDY_KEPT_H

#include "whirl/engine/study.h"

/// Leaves the blocks of the table of that batch with the keeper; states have `dimension` numbers. Freed by
/// kept_free.
whirl_status kept_new(whirl_table *table, const whirl_keeper *keeper, size_t batch, size_t dimension);

void kept_free(whirl_kept_blocks *kept);

/// After points of the table have come to other places.
void kept_forget(whirl_kept_blocks *kept);

/// Room for the widths of the points of a refined map, and one of them: their blocks were kept before these were known,
/// and are given with them from then on. WHIRL_NO_MEMORY.
whirl_status kept_make_widths(const whirl_table *table);
void kept_note_width(const whirl_table *table, size_t point, double width);

/// The block of a point, NULL where the keeper does not know it; of one that is not done, NaN.
const double *kept_block(const whirl_table *table, size_t point);

#endif
