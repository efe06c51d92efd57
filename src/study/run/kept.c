#include "kept.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "passes.h"

struct whirl_kept_blocks {
    const whirl_keeper *keeper;
    size_t batch, dimension;
    size_t point;     ///< point whose block is in memory, SIZE_MAX for none
    double *widths;   ///< [count] final widths of a refined map's points; else NULL
    double *end;      ///< [dimension] scratch for the state that comes with a block
    double numbers[]; ///< [layout.size] the block, and then the end
};

whirl_status kept_new(whirl_table *table, const whirl_keeper *keeper, size_t batch, size_t dimension) {
    const size_t size = table->layout.size;
    whirl_kept_blocks *kept = table->kept = malloc(sizeof *kept + (size + dimension) * sizeof(double));
    if (!kept) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point");
    *kept = (whirl_kept_blocks){.keeper = keeper, .batch = batch, .dimension = dimension, .point = SIZE_MAX};
    kept->end = kept->numbers + size;
    return whirl_ok();
}

void kept_free(whirl_kept_blocks *kept) {
    if (kept) free(kept->widths);
    free(kept);
}

void kept_forget(whirl_kept_blocks *kept) {
    kept->point = SIZE_MAX;
}

whirl_status kept_make_widths(const whirl_table *table) {
    table->kept->widths = calloc(table->count + 1, sizeof *table->kept->widths);
    kept_forget(table->kept);
    return table->kept->widths ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", table->count);
}

void kept_note_width(const whirl_table *table, size_t point, double width) {
    table->kept->widths[point] = width;
}

const double *kept_block(const whirl_table *table, size_t point) {
    whirl_kept_blocks *kept = table->kept;
    const whirl_keeper *keeper = kept->keeper;
    const size_t size = table->layout.size;
    if (kept->point == point) return kept->numbers;
    const size_t slot = table->slots ? table->slots[point] : point;
    kept_forget(kept);
    if (table->done && !table->done[point])
        for (size_t i = 0; i < size; i++) kept->numbers[i] = NAN;
    else if (!keeper->recall(keeper->context, kept->batch, slot, kept->numbers, size, kept->end, kept->dimension))
        return NULL;
    else if (kept->widths)
        kept->numbers[whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_WIDTH)->offset] = kept->widths[point];
    kept->point = point;
    return kept->numbers;
}
