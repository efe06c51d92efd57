#include "finished.h"

#include <stdlib.h>

whirl_status finished_points(const whirl_table *whole, finished *out) {
    size_t count = 0;
    for (size_t i = 0; i < whole->count; ++i) count += whirl_table_done(whole, i);
    *out = (finished){.table = *whole};
    whirl_table *table = &out->table;
    // The first owns all: points, slots, values, scales and branches of one block.
    size_t *points = out->points = malloc(count * (2 * sizeof(size_t) + 2 * sizeof(double) + sizeof(int)) + 1);
    if (!points) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", count);
    table->slots = points + count;
    table->values = (double *)(table->slots + count);
    if (whole->length_scales) table->length_scales = table->values + count;
    table->branch = (int *)(table->values + 2 * count);
    table->blocks = NULL;
    table->kept = NULL;
    table->done = NULL;
    table->count = 0;
    table->planned = whirl_table_planned(whole);
    for (size_t i = 0; i < whole->count; ++i) {
        if (!whirl_table_done(whole, i)) continue;
        const size_t at = table->count++;
        points[at] = i;
        table->slots[at] = whirl_table_slot(whole, i);
        table->values[at] = whole->values[i];
        if (whole->length_scales) table->length_scales[at] = whole->length_scales[i];
        table->branch[at] = whole->branch[i];
    }
    return whirl_ok();
}

void finished_free(finished *points) {
    free(points->points);
    points->points = NULL;
}
