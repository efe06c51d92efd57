#include "sensitivity_lanes.h"

#include <stdlib.h>
#include <string.h>

#include "isa.h"
#include "lanes.h"

struct sensitivity_lanes {
    const whirl_system *system; ///< the first machine
    lanes_flow *flow;
    size_t width, stride; ///< lanes of a row, and vectors
    size_t degrees, rates;
    size_t *places;                                      ///< [part_count] start of each part's numbers
    double *numbers, *forcing, *sides, *state, *changes; ///< rows of lanes
};

/// Returns true for rotors of one structure and period, whose kernels differ only in their numbers.
static bool lanes_take(size_t count, const whirl_system *const *machines) {
    const whirl_system *first = machines[0];
    for (size_t i = 0; i < count; i++) {
        const whirl_system *own = machines[i];
        if (!own->lanes || own->forcing != first->forcing || own->period != first->period) return false;
        if (!first->lanes->alike(first->model, own->model)) return false;
    }
    return true;
}

/// Fills a row with one number.
static void lanes_fill(const sensitivity_lanes *l, double *row, double number) {
    for (size_t i = 0; i < l->width; i++) row[i] = number;
}

/// Writes the machines' numbers, machine by machine; lanes beyond the last repeat the first one.
static bool lanes_number(sensitivity_lanes *l, size_t count, const whirl_system *const *machines) {
    const whirl_lanes *first = l->system->lanes;
    double *own = malloc((first->number_count + 1) * sizeof *own);
    l->places = calloc(first->part_count + 1, sizeof *l->places);
    if (own && l->places) {
        memcpy(l->places, first->places, first->part_count * sizeof *l->places);
        for (size_t lane = 0; lane < l->width; lane++) {
            const whirl_system *machine = machines[lane < count ? lane : 0];
            machine->lanes->numbers(machine->model, own);
            machine->lanes->part(machine->model, l->places);
            for (size_t k = 0; k < first->number_count; k++) l->numbers[k * l->width + lane] = own[k];
        }
    }
    const bool good = own && l->places;
    free(own);
    return good;
}

bool sensitivity_lanes_new(size_t count, const whirl_system *const *machines, sensitivity_lanes **out) {
    const isa *set;
    *out = NULL;
    if (!lanes_take(count, machines) || isa_choose(&set).code != WHIRL_OK) return true;
    // Lay out rows of lanes in one block of whole vectors.
    const whirl_system *system = machines[0];
    const whirl_lanes *own = system->lanes;
    sensitivity_lanes *l = calloc(1, sizeof *l);
    if (!l) return false;
    l->system = system;
    l->flow = own->flow[set->number];
    l->stride = (count + set->lanes - 1) / set->lanes;
    l->width = l->stride * set->lanes;
    l->degrees = own->degrees;
    l->rates = system->dimension - own->degrees;
    const size_t rows = own->number_count + system->forcing_count + own->switch_count + system->dimension + l->rates;
    l->numbers = aligned_alloc(64, (rows * l->width * sizeof(double) + 127) / 64 * 64);
    if (!l->numbers || !lanes_number(l, count, machines)) {
        sensitivity_lanes_free(l);
        return false;
    }
    l->forcing = l->numbers + own->number_count * l->width;
    l->sides = l->forcing + system->forcing_count * l->width;
    l->state = l->sides + own->switch_count * l->width;
    l->changes = l->state + system->dimension * l->width;
    *out = l;
    return true;
}

void sensitivity_lanes_free(sensitivity_lanes *l) {
    if (!l) return;
    free(l->places);
    free(l->numbers);
    free(l);
}

void sensitivity_lanes_take(sensitivity_lanes *l, const double *forcing, const double *x, const double *sides) {
    const whirl_system *system = l->system;
    for (size_t i = 0; i < system->forcing_count; i++) lanes_fill(l, l->forcing + i * l->width, forcing[i]);
    for (size_t i = 0; sides && i < system->switch_count; i++) lanes_fill(l, l->sides + i * l->width, sides[i]);
    for (size_t i = 0; i < system->dimension; i++) lanes_fill(l, l->state + i * l->width, x[i]);
    const lanes_view view = {.model = system->model,
                             .stride = l->stride,
                             .vectors = l->stride,
                             .numbers = l->numbers,
                             .places = l->places,
                             .forcing = l->forcing,
                             .sides = sides ? l->sides : NULL,
                             .q = l->state,
                             .v = l->state + l->degrees * l->width,
                             .a = l->changes};
    l->flow(&view);
}

void sensitivity_lanes_rates(const sensitivity_lanes *l, size_t index, double *rates) {
    for (size_t i = 0; i < l->rates; i++) rates[i] = l->changes[i * l->width + index];
}
