#include "kept.h"

#include <math.h>
#include <stdlib.h>

struct whirl_kept_blocks {
    const whirl_keeper *keeper;
    size_t batch, dimension;
    size_t point;     ///< whose block is in memory, `count` of the table for none
    double *end;      ///< [dimension] asked for with the block
    double numbers[]; ///< [layout.size] the block, and then the end
};

whirl_status kept_new(whirl_table *table, const whirl_keeper *keeper, size_t batch, size_t dimension) {
    const size_t size = table->layout.size;
    whirl_kept_blocks *kept = table->kept = malloc(sizeof *kept + (size + dimension) * sizeof(double));
    if (!kept) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point");
    *kept = (whirl_kept_blocks){keeper, batch, dimension, table->count, NULL};
    kept->end = kept->numbers + size;
    return whirl_ok();
}

const double *kept_block(const whirl_table *table, size_t point) {
    whirl_kept_blocks *kept = table->kept;
    const whirl_keeper *keeper = kept->keeper;
    const size_t size = table->layout.size;
    if (kept->point == point) return kept->numbers;
    kept->point = table->count;
    if (table->done && !table->done[point])
        for (size_t i = 0; i < size; i++) kept->numbers[i] = NAN;
    else if (!keeper->recall(keeper->context, kept->batch, point, kept->numbers, size, kept->end, kept->dimension))
        return NULL;
    kept->point = point;
    return kept->numbers;
}
