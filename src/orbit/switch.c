// Orbits on the branch that begins at a point of another one.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "follower.h"

/// The same orbit as one of twice as many revolutions.
static whirl_orbit *go_round_twice(const whirl_orbit *orbit, double **nodes) {
    const size_t size = orbit->segment_count * orbit->dimension;
    whirl_orbit *twice = calloc(1, sizeof *twice);
    *nodes = calloc(2 * size + 1, sizeof **nodes);
    if (!twice || !*nodes) {
        free(twice);
        return NULL;
    }
    *twice = *orbit;
    twice->revolutions = 2 * orbit->revolutions;
    twice->period = 2.0 * orbit->period;
    twice->segment_count = 2 * orbit->segment_count;
    memcpy(*nodes, orbit->nodes, size * sizeof **nodes);
    memcpy(*nodes + size, orbit->nodes, size * sizeof **nodes);
    twice->nodes = *nodes;
    return twice;
}

/// Finds the point of the branch again, as the equations of the other branch have it, then an orbit aside from it.
static whirl_status step_aside(follower *f, double value, double step, waypoint *at, double *trial, double *direction) {
    const size_t all = f->curve.count + 1;
    equations_take(&f->equations, f->equations.nodes, trial);
    if (f->equations.s->revolutions == 0) trial[all - 2] = f->equations.s->period;
    trial[all - 1] = value;
    follower_parameter_direction(f, direction);
    whirl_status status = follower_find(f, trial, direction, direction, at);
    if (status.code != WHIRL_OK) return status;
    if (!at->orbit || !curve_other(&f->curve, at->tangent, direction))
        return whirl_fail(WHIRL_BAD_INPUT, "the point at which a branch begins was not found again");
    whirl_orbit_free(at->orbit);
    at->orbit = NULL;
    for (size_t i = 0; i < all; i++) trial[i] = at->u[i] + step * direction[i];
    status = follower_find(f, trial, direction, direction, at);
    if (status.code == WHIRL_OK && !at->orbit)
        status = whirl_fail(WHIRL_BAD_INPUT, "no orbit was found on the branch that begins at %.10g", value);
    return status;
}

whirl_status whirl_branch_switch(const whirl_family *family, const whirl_branch_point *point, double step,
                                 const whirl_branch_options *options, whirl_orbit **orbit, double *value) {
    const bool doubles = point->special == WHIRL_DOUBLING;
    follower f;
    waypoint at = {.u = NULL};
    double *nodes = NULL;
    *orbit = NULL;
    if (!doubles && point->special != WHIRL_BRANCHING)
        return whirl_fail(WHIRL_BAD_INPUT, "no branch begins at this point, expected a doubling or a branching point");
    if (doubles && point->orbit->revolutions == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "doubled orbits with a time of their own are not looked for");
    whirl_orbit *start = doubles ? go_round_twice(point->orbit, &nodes) : point->orbit;
    if (!start) {
        free(nodes);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    }
    whirl_status status = follower_begin(&f, family, start, point->value, options);
    if (status.code == WHIRL_OK) status = waypoint_new(&f, &at);
    double *room = status.code == WHIRL_OK ? calloc(2 * (f.curve.count + 1), sizeof *room) : NULL;
    if (status.code == WHIRL_OK && !room) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    if (status.code == WHIRL_OK) status = step_aside(&f, point->value, step, &at, room, room + f.curve.count + 1);
    if (status.code == WHIRL_OK) {
        *value = follower_value(&f, at.u);
        *orbit = at.orbit;
        at.orbit = NULL;
    }
    free(room);
    waypoint_free(&at);
    follower_end(&f);
    if (doubles) free(start);
    free(nodes);
    return status;
}
