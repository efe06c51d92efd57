// The critical speeds of a machine without damping, all at once: a point of a critical speed map.
#include <math.h>

#include "analysis.h"

enum { SPEED, DIRECTION, RIGID_BODY, SHAPE, FIELD_COUNT };

static size_t kept(const block_shape *shape) {
    return (size_t)shape->options->modes;
}

static const field_plan fields[FIELD_COUNT] = {
    [SPEED] = {WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, "rad/s",
               "speed of the shaft at which a mode goes round with it, rising", WHIRL_PER_POINT, 1, kept},
    [DIRECTION] = {WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, "1",
                   "1: circles with the rotation, -1: against it, 0: neither", WHIRL_PER_POINT, 1, kept},
    [RIGID_BODY] = {WHIRL_FIELD_CRITICAL_SPEEDS_RIGID_BODY, "1",
                    "number of rigid-body modes, which nothing holds: they are left out", WHIRL_PER_POINT, 1, NULL},
    [SHAPE] = {WHIRL_FIELD_CRITICAL_SPEEDS_SHAPE, "1", "x_cos, x_sin, y_cos, y_sin", WHIRL_PER_STATION, 4, kept},
};

static whirl_status compute(const whirl_resting *point, const whirl_record_options *options, const block_view *view) {
    const whirl_machine own = {
        .system = point->system, .start = point->start, .clock = point->clock, .speed = point->speed};
    whirl_machine faster;
    whirl_critical_speeds *found = NULL;
    whirl_status status = point->at_speed(point->context, 2.0 * point->speed, &faster);
    if (status.code != WHIRL_OK) return status;
    status = whirl_critical_speeds_new(&own, &faster, &found);
    if (faster.release) faster.release(faster.owner);
    if (status.code != WHIRL_OK) return status;
    *view_numbers(view, RIGID_BODY, 0) = (double)found->free;
    for (size_t i = 0; i < found->count && i < (size_t)options->modes; i++) {
        view_numbers(view, SPEED, 0)[i] = found->speeds[i];
        view_numbers(view, DIRECTION, 0)[i] = found->directions[i];
        fill_shape(point->system, found->vectors + 2 * i * found->dimension, i, SHAPE, view);
    }
    whirl_critical_speeds_free(found);
    return status;
}

const analysis_plan critical_speeds_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .compute_resting = compute};
