// Undamped critical speeds of a machine, all at once: a point of a critical speed map.
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "critical_speeds.h"

enum { SPEED, DIRECTION, RIGID_BODY, SHAPE, BEARINGS, FIELD_COUNT };

/// Number of critical speeds, the lowest ones, at which the bearings' stiffness is evaluated.
enum { LOOKED_UP = 6 };

static size_t critical_speeds_kept(const block_shape *shape) {
    return (size_t)shape->options->modes;
}

static size_t looked_up(const block_shape *shape) {
    return shape->options->bearings ? LOOKED_UP : 0;
}

static const field_plan fields[FIELD_COUNT] = {
    [SPEED] = {WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, "rad/s",
               "speed of the shaft at which a lateral mode goes round with it, in rising order", WHIRL_PER_POINT, 1,
               critical_speeds_kept},
    [DIRECTION] = {WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, "1",
                   "1: circles with the rotation, -1: against it, 0: neither", WHIRL_PER_POINT, 1,
                   critical_speeds_kept},
    [RIGID_BODY] = {WHIRL_FIELD_CRITICAL_SPEEDS_RIGID_BODY, "1", "number of rigid-body modes, which are left out",
                    WHIRL_PER_POINT, 1, NULL},
    [BEARINGS] =
        {WHIRL_FIELD_CRITICAL_SPEEDS_BEARINGS, "N/m",
         "kxx, kyy (of the machine's own bearings there, at each of the lowest critical speeds; with bearings: yes)",
         WHIRL_PER_STATION, 2, looked_up},
    [SHAPE] =
        {WHIRL_FIELD_CRITICAL_SPEEDS_SHAPE, "1",
         "x_cos, x_sin, y_cos, y_sin (relative: the largest amplitude is 1; missing where the mode moves no station)",
         WHIRL_PER_STATION, 4, critical_speeds_kept},
};

void bearings_place(const whirl_system *alone, double *x, const whirl_system *machine, const double *rest) {
    for (size_t p = 0; p < machine->probe_count; p++) {
        x[alone->probes[p].x] = whirl_probe_value(&machine->probes[p], rest, 0);
        x[alone->probes[p].y] = whirl_probe_value(&machine->probes[p], rest, 1);
    }
    if (alone->adopt) alone->adopt(alone->model, x, machine, rest);
}

/// Sets the state x of `alone`, the bearings without their machine, from the equilibrium of the complete machine at a
/// speed.
static whirl_status find_rest(const whirl_resting *point, double speed, const whirl_system *alone, double *x) {
    whirl_machine given;
    whirl_status status = point->at_speed(point->context, speed, WHIRL_AS_GIVEN, 0.0, &given);
    if (status.code != WHIRL_OK) return status;
    double *rest = calloc(given.system->dimension + 1, sizeof *rest);
    if (!rest) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine at rest");
    if (rest) memcpy(rest, given.start, given.system->dimension * sizeof *rest);
    if (rest) status = whirl_equilibrium(given.system, rest);
    if (status.code == WHIRL_OK) bearings_place(alone, x, given.system, rest);
    free(rest);
    if (given.release) given.release(given.owner);
    return status;
}

/// Sets rounding errors to 0, bearing by bearing.
static void drop_rounding(double *numbers, size_t probes) {
    static const double rounding = 1e-30; // N/m, N s/m
    for (size_t p = 0; p < probes; p++) {
        double largest = 0.0;
        for (size_t i = 0; i < 8; i++) largest = fmax(largest, fabs(numbers[8 * p + i]));
        if (largest <= rounding) memset(numbers + 8 * p, 0, 8 * sizeof *numbers);
    }
}

// The equilibrium matters only if coefficients differ between the centre and a place off it.
whirl_status whirl_bearings_at(const whirl_resting *point, double speed, double *numbers) {
    const size_t probes = point->system->probe_count;
    whirl_machine alone;
    whirl_status status = point->at_speed(point->context, speed, WHIRL_BEARINGS_OF_IT, 0.0, &alone);
    if (status.code != WHIRL_OK) return status;
    status = whirl_synchronous_check(alone.system, speed);
    double *x = calloc(alone.system->dimension + 8 * probes + 1, sizeof *x);
    double *other = x ? x + alone.system->dimension : NULL;
    if (!x) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the coefficients of bearings");
    if (x && status.code == WHIRL_OK) status = whirl_bearing_coefficients(&alone, x, numbers);
    for (size_t p = 0; p < probes && x; p++) x[alone.system->probes[p].x] = 1e-3;
    if (status.code == WHIRL_OK) status = whirl_bearing_coefficients(&alone, x, other);
    if (status.code == WHIRL_OK && memcmp(numbers, other, 8 * probes * sizeof *other) != 0) {
        status = find_rest(point, speed, alone.system, x);
        if (status.code == WHIRL_OK) status = whirl_bearing_coefficients(&alone, x, numbers);
    }
    if (status.code == WHIRL_OK) drop_rounding(numbers, probes);
    free(x);
    if (alone.release) alone.release(alone.owner);
    return status;
}

/// Fills in the coefficients of the bearings at the lowest critical speeds. They stay missing at speeds beyond the
/// table of a bearing, and where the machine has no equilibrium.
static whirl_status fill_bearings(const whirl_resting *point, const whirl_critical_speeds *found,
                                  const block_view *view) {
    const size_t probes = point->system->probe_count;
    if (!view_numbers(view, BEARINGS, 0)) return whirl_ok();
    double *numbers = malloc((8 * probes + 1) * sizeof *numbers);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the coefficients of bearings");
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < found->count && i < LOOKED_UP && status.code != WHIRL_NO_MEMORY; i++) {
        status = whirl_bearings_at(point, found->speeds[i], numbers);
        for (size_t p = 0; p < probes && status.code == WHIRL_OK; p++) {
            double *out = view_numbers(view, BEARINGS, p) + 2 * i;
            const double stiffness[] = {numbers[8 * p], numbers[8 * p + 3]};
            for (size_t c = 0; c < 2; c++) out[c] = stiffness[c] != 0.0 ? stiffness[c] : NAN;
        }
    }
    free(numbers);
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

static whirl_status critical_speeds_compute(const whirl_resting *point, const whirl_record_options *options,
                                            const block_view *view) {
    const whirl_machine own = {
        .system = point->system, .start = point->start, .clock = point->clock, .speed = point->speed};
    whirl_machine faster;
    whirl_critical_speeds *found = NULL;
    whirl_status status = point->at_speed(point->context, 2.0 * point->speed, WHIRL_AS_STUDIED, 0.0, &faster);
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
    status = fill_bearings(point, found, view);
    whirl_critical_speeds_free(found);
    return status;
}

const analysis_plan critical_speeds_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .compute_resting = critical_speeds_compute};
