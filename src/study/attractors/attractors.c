// Groups the points of one machine by the attractor they settled on. Motions without a verdict belong to no group.
#include "attractors.h"

#include <math.h>
#include <stdlib.h>

static int by_points(const void *left, const void *right) {
    const whirl_attractor *a = left, *b = right;
    if (a->points != b->points) return a->points < b->points ? 1 : -1;
    return (a->first > b->first) - (a->first < b->first);
}

/// Adds a point to the attractor that it settled on, or to a new one. Sets *which to its index, or to MAX_ATTRACTORS
/// without one.
static whirl_status attractors_join(const whirl_table *table, size_t point, told_apart *told, size_t *which) {
    *which = MAX_ATTRACTORS;
    const whirl_regime regime = whirl_table_verdict(table, point).regime;
    if (regime == WHIRL_UNDETERMINED || regime == WHIRL_NOT_JUDGED) return whirl_ok();
    motion *own = motion_read(table, point);
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory to tell attractors apart");
    size_t k = 0;
    while (k < told->count && !motion_is_same(told->motions[k], own)) k++;
    if (k < told->count || k == MAX_ATTRACTORS) {
        free(own);
    } else {
        told->found[k] = (whirl_attractor){.first = point};
        told->motions[told->count++] = own;
    }
    if (k < MAX_ATTRACTORS) told->found[k].points += !whirl_table_from_neighbour(table, point);
    *which = k;
    return whirl_ok();
}

/// Computes the shares of all attractors. Their standard errors assume starts that are drawn at random.
static void take_shares(told_apart *told) {
    for (size_t k = 0; k < told->count; k++) {
        const double share = told->done > 0 ? (double)told->found[k].points / (double)told->done : 0.0;
        told->found[k].share = share;
        told->found[k].error = told->done > 0 ? sqrt(share * (1.0 - share) / (double)told->done) : 0.0;
    }
}

whirl_status attractors_tell(const whirl_table *table, const size_t *points, size_t count, size_t *of,
                             told_apart *told) {
    whirl_status status = whirl_ok();
    *told = (told_apart){.count = 0};
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        const size_t point = points ? points[i] : i;
        of[point] = MAX_ATTRACTORS;
        if (!whirl_table_done(table, point)) continue;
        told->done += !whirl_table_from_neighbour(table, point);
        status = attractors_join(table, point, told, &of[point]);
    }
    take_shares(told);
    return status;
}

void attractors_free(told_apart *told) {
    for (size_t k = 0; k < told->count; k++) free(told->motions[k]);
    told->count = 0;
}

/// Weighs points of a refined table by the grid points that each represents.
static whirl_status attractors_weigh(const whirl_table *table, const size_t *of, told_apart *told) {
    const size_t grid = whirl_table_grid(table);
    size_t *cover = calloc(grid + 1, sizeof *cover);
    if (!cover) return whirl_fail(WHIRL_NO_MEMORY, "no memory to count %zu points", grid);
    whirl_table_cover(table, cover);
    told->done = 0;
    for (size_t k = 0; k < told->count; k++) told->found[k].points = 0;
    for (size_t i = 0; i < grid; i++) {
        if (cover[i] == table->count) continue;
        told->done++;
        if (of[cover[i]] < MAX_ATTRACTORS) told->found[of[cover[i]]].points++;
    }
    take_shares(told);
    free(cover);
    return whirl_ok();
}

whirl_status whirl_table_attractors(const whirl_table *table, size_t *labels, whirl_attractor *attractors, size_t most,
                                    size_t *count) {
    told_apart told;
    size_t *of = malloc((table->count + 1) * sizeof *of), number[MAX_ATTRACTORS + 1] = {0};
    *count = 0;
    if (!of) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the attractors of %zu points", table->count);
    whirl_status status = attractors_tell(table, NULL, table->count, of, &told);
    if (status.code == WHIRL_OK && table->refine > 0) status = attractors_weigh(table, of, &told);
    if (status.code == WHIRL_OK) {
        *count = told.count;
        qsort(told.found, told.count, sizeof *told.found, by_points);
        for (size_t k = 0; k < told.count; k++) number[of[told.found[k].first]] = k + 1;
        for (size_t i = 0; labels && i < table->count; i++) labels[i] = number[of[i]];
        for (size_t k = 0; k < told.count && k < most; k++) attractors[k] = told.found[k];
    }
    attractors_free(&told);
    free(of);
    return status;
}
