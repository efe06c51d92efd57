#include "section_map.h"

#include <stdlib.h>
#include <string.h>

#include "turns.h"
#include "whirl/orbit.h"

static whirl_status check(const whirl_system *system, size_t revolutions) {
    const size_t repeats = system->turns ? system->repeats : 1;
    if (revolutions < 1 || revolutions > WHIRL_MAX_ORBIT)
        return whirl_fail(WHIRL_BAD_INPUT, "sections %zu revolutions apart, expected 1 to %d", revolutions,
                          WHIRL_MAX_ORBIT);
    if (repeats == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "forces turn with a phase that fits no number of revolutions: sections meet "
                                           "its tori in no closed curve");
    if (revolutions % repeats != 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "sections %zu revolutions apart, expected a multiple of %zu, after which all that turns "
                          "comes back",
                          revolutions, repeats);
    return whirl_ok();
}

static bool allocate(section_map *map, const whirl_system *system) {
    const size_t d = system->dimension;
    map->kept = calloc(d + 1, sizeof *map->kept);
    map->rest = calloc(2 * d + d * d + 1, sizeof *map->rest);
    if (!map->kept || !map->rest) return false;
    map->state = map->rest + d;
    map->vectors = map->state + d;
    for (size_t i = 0; i < d; i++)
        if (!turns_on(system->turns, i)) map->kept[map->count++] = i;
    return true;
}

whirl_status section_map_new(const whirl_system *system, const whirl_integrate_options *options, size_t revolutions,
                             section_map **out) {
    *out = NULL;
    whirl_status status = check(system, revolutions);
    if (status.code != WHIRL_OK) return status;
    section_map *map = calloc(1, sizeof *map);
    if (!map) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a map of %zu coordinates", system->dimension);
    *map = (section_map){.revolutions = revolutions, .dimension = system->dimension};
    if (!allocate(map, system))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a map of %zu coordinates", system->dimension);
    if (status.code == WHIRL_OK) status = whirl_integrator_new(system, options, &map->integrator);
    if (status.code == WHIRL_OK) status = whirl_integrator_follow(map->integrator, map->count);
    if (status.code == WHIRL_OK)
        *out = map;
    else
        section_map_free(map);
    return status;
}

void section_map_free(section_map *map) {
    if (!map) return;
    whirl_integrator_free(map->integrator);
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

static bool carry_with_derivative(section_map *map, double *derivative, double *volume) {
    const size_t n = map->count, d = map->dimension;
    whirl_disturbances all = {.count = n, .vectors = map->vectors};
    *volume = 0.0;
    memset(map->vectors, 0, n * d * sizeof *map->vectors);
    for (size_t i = 0; i < n; i++) map->vectors[i * d + map->kept[i]] = 1.0;
    for (size_t k = 0; k < map->revolutions; k++) {
        if (whirl_integrator_carry(map->integrator, map->state, &all, NULL, NULL) != WHIRL_BOUNDED) return false;
        *volume += all.volume;
    }
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) derivative[i * n + k] = map->vectors[k * d + map->kept[i]];
    return true;
}

static bool carry_alone(section_map *map) {
    bool bounded = true;
    for (size_t k = 0; k < map->revolutions && bounded; k++)
        bounded = whirl_integrator_revolve(map->integrator, map->state, NULL, NULL) == WHIRL_BOUNDED;
    return bounded;
}

bool section_map_carry(section_map *map, size_t many, const double *points, double *images, double *derivatives,
                       double *volume) {
    const size_t n = map->count;
    double sum = 0.0, part = 0.0;
    for (size_t j = 0; j < many; j++) {
        section_map_put(map, points + j * n, map->state);
        if (!(derivatives ? carry_with_derivative(map, derivatives + j * n * n, &part) : carry_alone(map)))
            return false;
        section_map_take(map, map->state, images + j * n);
        sum += part;
    }
    if (derivatives) *volume = sum / (double)many;
    return true;
}
