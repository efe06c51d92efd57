#include <stdlib.h>

#include "branch_points.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/orbit.h"

whirl_status branch_add(whirl_branch *b, const whirl_branch_options *options, const whirl_branch_point *point) {
    if (whirl_stop_is_set(options->stop)) { // what was found since a stop is discarded
        whirl_orbit_free(point->orbit);
        b->end = WHIRL_END_STOPPED;
        return whirl_ok();
    }
    if ((b->count & (b->count - 1)) == 0) { // capacity is the next power of two
        const size_t capacity = b->count > 0 ? 2 * b->count : 1;
        whirl_branch_point *points = realloc(b->points, capacity * sizeof *points);
        if (!points) return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points of a branch", capacity);
        b->points = points;
    }
    b->points[b->count++] = *point;
    if (options->found && !options->found(options->context, point)) b->end = WHIRL_END_STOPPED;
    return whirl_ok();
}

whirl_status branch_finish(whirl_branch *b, const whirl_branch_options *options, whirl_status status) {
    if (!whirl_stop_is_set(options->stop)) return status;
    b->end = WHIRL_END_STOPPED;
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

void whirl_branch_free(whirl_branch *branch) {
    if (!branch) return;
    for (size_t i = 0; i < branch->count; i++) whirl_orbit_free(branch->points[i].orbit);
    free(branch->points);
    free(branch);
}
