#include "journal_blocks.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

struct whirl_journal_blocks {
    const whirl_point_store *journal;
    size_t batch, dimension;
    size_t point;     ///< point whose block is in memory, SIZE_MAX for none
    double *widths;   ///< [count] final widths of a refined map's points; else NULL
    double *end;      ///< [dimension] scratch for the state that comes with a block
    double numbers[]; ///< [layout.size] the block, and then the end
};

whirl_status journal_blocks_new(whirl_table *table, const whirl_point_store *journal, size_t batch, size_t dimension) {
    const size_t size = table->layout.size;
    whirl_journal_blocks *own = table->journal_blocks = malloc(sizeof *own + (size + dimension) * sizeof(double));
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a point");
    *own = (whirl_journal_blocks){.journal = journal, .batch = batch, .dimension = dimension, .point = SIZE_MAX};
    own->end = own->numbers + size;
    return whirl_ok();
}

void journal_blocks_free(whirl_journal_blocks *own) {
    if (own) free(own->widths);
    free(own);
}

void journal_blocks_forget(whirl_journal_blocks *own) {
    own->point = SIZE_MAX;
}

whirl_status journal_blocks_make_widths(const whirl_table *table) {
    table->journal_blocks->widths = calloc(table->count + 1, sizeof *table->journal_blocks->widths);
    journal_blocks_forget(table->journal_blocks);
    return table->journal_blocks->widths ? whirl_ok()
                                         : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", table->count);
}

void journal_blocks_note_width(const whirl_table *table, size_t point, double width) {
    table->journal_blocks->widths[point] = width;
}

const double *journal_blocks_of(const whirl_table *table, size_t point) {
    whirl_journal_blocks *own = table->journal_blocks;
    const whirl_point_store *journal = own->journal;
    const size_t size = table->layout.size;
    if (own->point == point) return own->numbers;
    const size_t slot = table->slots ? table->slots[point] : point;
    journal_blocks_forget(own);
    if (table->done && !table->done[point])
        for (size_t i = 0; i < size; i++) own->numbers[i] = NAN;
    else if (!journal->recall(journal->context, own->batch, slot, own->numbers, size, own->end, own->dimension))
        return NULL;
    else if (own->widths)
        own->numbers[whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_WIDTH)->offset] = own->widths[point];
    own->point = point;
    return own->numbers;
}
