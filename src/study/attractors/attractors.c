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
static whirl_status attractors_join(const whirl_table *table, size_t point, attractor_groups *groups, size_t *which) {
    *which = MAX_ATTRACTORS;
    const whirl_regime regime = whirl_table_verdict(table, point).regime;
    if (regime == WHIRL_UNDETERMINED || regime == WHIRL_NOT_JUDGED) return whirl_ok();
    motion *own = motion_read(table, point);
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory to distinguish attractors");
    size_t k = 0;
    while (k < groups->count && !motion_is_same(groups->motions[k], own)) k++;
    if (k < groups->count || k == MAX_ATTRACTORS) {
        free(own);
    } else {
        groups->found[k] = (whirl_attractor){.first = point};
        groups->motions[groups->count++] = own;
    }
    if (k < MAX_ATTRACTORS) groups->found[k].points += !whirl_table_from_neighbour(table, point);
    *which = k;
    return whirl_ok();
}

/// Computes the shares of all attractors. Their standard errors assume starts that are drawn at random.
static void take_shares(attractor_groups *groups) {
    for (size_t k = 0; k < groups->count; k++) {
        const double share = groups->done > 0 ? (double)groups->found[k].points / (double)groups->done : 0.0;
        groups->found[k].share = share;
        groups->found[k].error = groups->done > 0 ? sqrt(share * (1.0 - share) / (double)groups->done) : 0.0;
    }
}

whirl_status attractors_group(const whirl_table *table, const size_t *points, size_t count, size_t *of,
                              attractor_groups *groups) {
    whirl_status status = whirl_ok();
    *groups = (attractor_groups){.count = 0};
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        const size_t point = points ? points[i] : i;
        of[point] = MAX_ATTRACTORS;
        if (!whirl_table_done(table, point)) continue;
        groups->done += !whirl_table_from_neighbour(table, point);
        status = attractors_join(table, point, groups, &of[point]);
    }
    take_shares(groups);
    return status;
}

void attractors_free(attractor_groups *groups) {
    for (size_t k = 0; k < groups->count; k++) free(groups->motions[k]);
    groups->count = 0;
}

/// Weighs points of a refined table by the grid points that each represents.
static whirl_status attractors_weigh(const whirl_table *table, const size_t *of, attractor_groups *groups) {
    const size_t grid = whirl_table_grid(table);
    size_t *cover = calloc(grid + 1, sizeof *cover);
    if (!cover) return whirl_fail(WHIRL_NO_MEMORY, "no memory to count %zu points", grid);
    whirl_table_cover(table, cover);
    groups->done = 0;
    for (size_t k = 0; k < groups->count; k++) groups->found[k].points = 0;
    for (size_t i = 0; i < grid; i++) {
        if (cover[i] == table->count) continue;
        groups->done++;
        if (of[cover[i]] < MAX_ATTRACTORS) groups->found[of[cover[i]]].points++;
    }
    take_shares(groups);
    free(cover);
    return whirl_ok();
}

whirl_status whirl_table_attractors(const whirl_table *table, size_t *labels, whirl_attractor *attractors, size_t most,
                                    size_t *count) {
    attractor_groups groups;
    size_t *of = malloc((table->count + 1) * sizeof *of), number[MAX_ATTRACTORS + 1] = {0};
    *count = 0;
    if (!of) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the attractors of %zu points", table->count);
    whirl_status status = attractors_group(table, NULL, table->count, of, &groups);
    if (status.code == WHIRL_OK && table->refine > 0) status = attractors_weigh(table, of, &groups);
    if (status.code == WHIRL_OK) {
        *count = groups.count;
        qsort(groups.found, groups.count, sizeof *groups.found, by_points);
        for (size_t k = 0; k < groups.count; k++) number[of[groups.found[k].first]] = k + 1;
        for (size_t i = 0; labels && i < table->count; i++) labels[i] = number[of[i]];
        for (size_t k = 0; k < groups.count && k < most; k++) attractors[k] = groups.found[k];
    }
    attractors_free(&groups);
    free(of);
    return status;
}
