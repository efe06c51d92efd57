/// Blocks of a table that lie with the keeper of its run: one at a time is in memory.
#ifndef STUDY_KEPT_H
#define STUDY_KEPT_H

#include "whirl/study.h"

/// Leaves the blocks of the table of that batch with the keeper; states have `dimension` numbers. Freed by free.
whirl_status kept_new(whirl_table *table, const whirl_keeper *keeper, size_t batch, size_t dimension);

/// The block of a point, NULL where the keeper does not know it; of one that is not done, NaN.
const double *kept_block(const whirl_table *table, size_t point);

#endif
