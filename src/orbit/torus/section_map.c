#include "section_map.h"

#include <stdlib.h>
#include <string.h>

#include "turns.h"
#include "whirl/engine/orbit.h"

static whirl_status section_map_check(const whirl_system *system, size_t revolutions) {
    const size_t repeats = system->turns ? system->repeats : 1;
    if (revolutions < 1 || revolutions > WHIRL_MAX_ORBIT)
        return whirl_fail(WHIRL_BAD_INPUT, "sections %zu revolutions apart, expected 1 to %d", revolutions,
                          WHIRL_MAX_ORBIT);
    if (repeats == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "forces turn with a phase that fits no number of revolutions: sections meet "
                                           "tori in no closed curve");
    if (revolutions % repeats != 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "sections %zu revolutions apart, expected a multiple of %zu, after which all that turns "
                          "comes back",
                          revolutions, repeats);
    return whirl_ok();
}

static bool section_map_allocate(section_map *map, const whirl_system *system) {
    const size_t d = system->dimension, side = map->side_by_side;
    map->kept = calloc(d + 1, sizeof *map->kept);
    map->rest = calloc(d + side * (d + d * d) + 1, sizeof *map->rest);
    map->columns = calloc(side, sizeof *map->columns);
    if (!map->kept || !map->rest || !map->columns) return false;
    map->states = map->rest + d;
    map->vectors = map->states + side * d;
    for (size_t i = 0; i < d; i++)
        if (!turns_on(system->turns, i)) map->kept[map->count++] = i;
    return true;
}

static whirl_status make_lanes(section_map *map, const whirl_system *system, const whirl_integrate_options *options) {
    whirl_status status = whirl_ensemble_flow(system, options, map->side_by_side, map->count, &map->lanes);
    for (size_t j = 0; j < map->side_by_side && status.code == WHIRL_OK; j++)
        status = whirl_ensemble_load(map->lanes, j, system, map->states);
    return status;
}

static whirl_status make_alone(section_map *map, const whirl_system *system, const whirl_integrate_options *options) {
    const whirl_status status = whirl_integrator_new(system, options, &map->integrator);
    return status.code == WHIRL_OK ? whirl_integrator_follow(map->integrator, map->count) : status;
}

whirl_status section_map_new(const whirl_system *system, const whirl_integrate_options *options, size_t revolutions,
                             section_map **out) {
    enum { LANES = 32 };
    *out = NULL;
    whirl_status status = section_map_check(system, revolutions);
    if (status.code != WHIRL_OK) return status;
    const bool flows = whirl_ensemble_flows(system, options);
    section_map *map = calloc(1, sizeof *map);
    if (!map) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a map of %zu coordinates", system->dimension);
    *map = (section_map){.revolutions = revolutions, .dimension = system->dimension, .side_by_side = flows ? LANES : 1};
    if (!section_map_allocate(map, system))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a map of %zu coordinates", system->dimension);
    if (status.code == WHIRL_OK) status = flows ? make_lanes(map, system, options) : make_alone(map, system, options);
    if (status.code == WHIRL_OK)
        *out = map;
    else
        section_map_free(map);
    return status;
}

void section_map_free(section_map *map) {
    if (!map) return;
    whirl_ensemble_free(map->lanes);
    whirl_integrator_free(map->integrator);
    free(map->columns);
    free(map->kept);
    free(map->rest);
    free(map);
}

void section_map_take(const section_map *map, const double *state, double *point) {
    for (size_t i = 0; i < map->count; i++) point[i] = state[map->kept[i]];
}

void section_map_put(const section_map *map, const double *point, double *state) {
    memcpy(state, map->rest, map->dimension * sizeof *state);
    for (size_t i = 0; i < map->count; i++) state[map->kept[i]] = point[i];
}

// ---------------------------------------------------------------- carrying points

/// Sets the unit perturbations of the point at a place among those that run at once.
static void begin_columns(section_map *map, size_t place) {
    const size_t n = map->count, d = map->dimension;
    double *vectors = map->vectors + place * n * d;
    map->columns[place] = (whirl_perturbations){.count = n, .vectors = vectors};
    memset(vectors, 0, n * d * sizeof *vectors);
    for (size_t i = 0; i < n; i++) vectors[i * d + map->kept[i]] = 1.0;
}

static void take_columns(const section_map *map, size_t place, double *derivative) {
    const size_t n = map->count, d = map->dimension;
    const double *vectors = map->vectors + place * n * d;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) derivative[i * n + k] = vectors[k * d + map->kept[i]];
}

/// Carries the state over a revolution in the integrator, with its perturbations unless `columns` is NULL.
static bool revolve_alone(section_map *map, whirl_perturbations *columns) {
    const whirl_motion motion = columns ? whirl_integrator_carry(map->integrator, map->states, columns, NULL, NULL)
                                        : whirl_integrator_revolve(map->integrator, map->states, NULL, NULL);
    return motion == WHIRL_BOUNDED;
}

/// Carries the first `many` states over a revolution in lanes.
static bool revolve_in_lanes(section_map *map, size_t many, whirl_perturbations *columns) {
    bool bounded = true;
    for (size_t j = 0; j < many; j++) {
        whirl_ensemble_place(map->lanes, j, map->states + j * map->dimension);
        if (columns) whirl_ensemble_carry(map->lanes, j, &columns[j]);
    }
    whirl_ensemble_revolve(map->lanes, many, NULL);
    for (size_t j = 0; j < many; j++) {
        whirl_ensemble_state(map->lanes, j, map->states + j * map->dimension);
        bounded = bounded && whirl_ensemble_motion(map->lanes, j) == WHIRL_BOUNDED;
    }
    return bounded;
}

/// Carries the points that run at once.
static bool section_map_carry_block(section_map *map, size_t many, const double *points, double *images,
                                    double *derivatives, double *volume) {
    const size_t n = map->count;
    whirl_perturbations *columns = derivatives ? map->columns : NULL;
    for (size_t j = 0; j < many; j++) {
        section_map_put(map, points + j * n, map->states + j * map->dimension);
        if (columns) begin_columns(map, j);
    }
    for (size_t k = 0; k < map->revolutions; k++) {
        if (!(map->lanes ? revolve_in_lanes(map, many, columns) : revolve_alone(map, columns))) return false;
        for (size_t j = 0; j < many && columns; j++) *volume += columns[j].volume;
    }
    for (size_t j = 0; j < many; j++) {
        section_map_take(map, map->states + j * map->dimension, images + j * n);
        if (columns) take_columns(map, j, derivatives + j * n * n);
    }
    return true;
}

bool section_map_carry(section_map *map, size_t many, const double *points, double *images, double *derivatives,
                       double *volume) {
    const size_t n = map->count;
    double sum = 0.0;
    for (size_t from = 0; from < many; from += map->side_by_side) {
        const size_t now = many - from < map->side_by_side ? many - from : map->side_by_side;
        double *matrices = derivatives ? derivatives + from * n * n : NULL;
        if (!section_map_carry_block(map, now, points + from * n, images + from * n, matrices, &sum)) return false;
    }
    if (derivatives) *volume = sum / (double)many;
    return true;
}
