#include "finished.h"

#include <stdlib.h>

#include "mapped.h"

static void copy_point(const whirl_table *whole, size_t from, finished *out) {
    whirl_table *table = &out->table;
    const size_t at = table->count++;
    out->points[at] = from;
    table->slots[at] = whirl_table_slot(whole, from);
    table->values[at] = whole->values[from];
    if (whole->length_scales) table->length_scales[at] = whole->length_scales[from];
    table->branch[at] = whole->branch[from];
}

/// Copies the finished points. One block holds all arrays (points, slots, values, scales, branches) and begins with
/// `points`.
static whirl_status copy_finished(const whirl_table *whole, size_t count, finished *out) {
    const size_t bytes = 2 * sizeof(size_t) + 2 * sizeof(double) + sizeof(int);
    whirl_table *table = &out->table;
    size_t *points = out->points = mapped_take(&out->mapped, count, bytes, MAPPED_MIN);
    if (!points) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", count);
    table->slots = points + count;
    table->values = (double *)(table->slots + count);
    if (whole->length_scales) table->length_scales = table->values + count;
    table->branch = (int *)(table->values + 2 * count);
    table->count = 0;
    for (size_t i = 0; i < whole->count; ++i) {
        mapped_evict_often(out->mapped, i);
        mapped_evict_often(whole->mapped, i);
        if (whirl_table_done(whole, i)) copy_point(whole, i, out);
    }
    return whirl_ok();
}

whirl_status finished_points(const whirl_table *whole, finished *out) {
    size_t count = 0;
    for (size_t i = 0; i < whole->count; ++i) {
        mapped_evict_often(whole->mapped, i);
        count += whirl_table_done(whole, i);
    }
    *out = (finished){.table = *whole};
    whirl_table *table = &out->table;
    table->blocks = NULL;
    table->journal_blocks = NULL;
    table->done = NULL;
    table->planned = whirl_table_planned(whole);
    return count == whole->count ? whirl_ok() : copy_finished(whole, count, out);
}

void finished_free(finished *own) {
    mapped_drop(&own->mapped, own->points);
    own->points = NULL;
}
