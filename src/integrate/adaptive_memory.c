// The workspace of adaptive methods over lanes.
#include <stdlib.h>
#include <string.h>

#include "adaptive_lanes.h"

typedef struct part {
    double **array;
    size_t rows;
} part;

/// Lays out the arrays in a block of rows. Returns the number of rows.
static size_t adaptive_lay_out(adaptive_lanes *lanes, double *block) {
    const size_t degrees = lanes->degrees, rates = lanes->rates, probes = lanes->observe.probe_count,
                 switches = lanes->switch_count;
    const size_t contacts = lanes->observe.contact_count, sets = 1 + lanes->followed;
    size_t row = 0;
#define PART(array, extent, columns, ...)                                                                              \
    {&lanes->observe.array, WHIRL_WATCHED_SIZE(extent, columns, probes, contacts)},
    const part parts[] = {
        {&lanes->q, sets * degrees},
        {&lanes->v, sets * rates},
        {&lanes->stage_q, sets * degrees},
        {&lanes->stage_v, sets * rates},
        {&lanes->end_q, sets * degrees},
        {&lanes->end_v, sets * rates},
        {&lanes->numbers, lanes->number_count},
        {&lanes->forcing, lanes->forcing_count},
        {&lanes->ended, 1},
        {&lanes->from, 1},
        {&lanes->until, 1},
        {&lanes->volume, 1},
        {&lanes->gained, 1},
        {&lanes->starting, 1},
        {&lanes->attempts, 1},
        {&lanes->t, 1},
        {&lanes->h, 1},
        {&lanes->running, 1},
        {&lanes->before, 1},
        {&lanes->rejected, 1},
        {&lanes->sides, switches},
        {&lanes->held, switches},
        {&lanes->sliding, switches},
        {&lanes->alone, 1},
        {&lanes->switchings, 1},
        {&lanes->landing, 1},
        {&lanes->whole, 1},
        {&lanes->tries, 1},
        {&lanes->value, switches},
        {&lanes->rate, switches},
        {&lanes->length, 1},
        {&lanes->lengths, degrees},
        {&lanes->error, 1},
        {&lanes->size, 1},
        {&lanes->special, 1},
        {&lanes->fresh, 1},
        {&lanes->end_value, switches},
        {&lanes->end_rate, switches},
        {&lanes->time, 1},
        {&lanes->watched, 1},
        {&lanes->begin, 1},
        {&lanes->taken, 1},
        {&lanes->instant, 1},
        {&lanes->seen, 1},
        {&lanes->theta, 1},
        {&lanes->observe.low, lanes->dimension},
        {&lanes->observe.high, lanes->dimension},
        {&lanes->observe.gap, contacts},
        {&lanes->observe.touching, contacts},
        {&lanes->observe.force, lanes->observe.contacts ? contacts : 0},
        {&lanes->observe.friction, lanes->observe.contacts ? 2 * contacts : 0},
        // clang-format off
        WHIRL_WATCHED(PART)
        // clang-format on
    };
#undef PART
    row += lanes->method->lay_out(lanes, block);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++, row += parts[i - 1].rows)
        *parts[i].array = lanes_row(lanes, block, row);
    for (int i = 0; i <= lanes->method->dense; i++, row += lanes->dimension)
        lanes->dense[i] = lanes_row(lanes, block, row);
    return row;
}

adaptive_lanes *adaptive_lanes_make(const adaptive_lanes *shape) {
    adaptive_lanes *lanes = malloc(sizeof *lanes);
    if (!lanes) return NULL;
    *lanes = *shape;
    // Find the sparsity of the Jacobian, for an implicit method.
    if (lanes->method->implicit)
        lanes->rodas5p.sparsity =
            sparsity_new(lanes->degrees, lanes->rates, lanes->depends, lanes->model, lanes->slots == 1);
    if (lanes->method->implicit && !lanes->rodas5p.sparsity) {
        adaptive_lanes_free(lanes);
        return NULL;
    }
    // Allocate one aligned block for all arrays.
    const size_t bytes = (adaptive_lay_out(lanes, NULL) * lanes->slots * sizeof(double) + 63) / 64 * 64;
    lanes->block = aligned_alloc(64, bytes);
    lanes->queue = calloc(1, sizeof *lanes->queue);
    if (!lanes->block || !lanes->queue) {
        adaptive_lanes_free(lanes);
        return NULL;
    }
    memset(lanes->block, 0, bytes);
    adaptive_lay_out(lanes, lanes->block);
    lanes->method->prepare(lanes);
    for (size_t i = 0; i < MAX_SLOTS; i++) lanes->queue->slot_lane[i] = NO_LANE;
    return lanes;
}

adaptive_lanes *adaptive_lanes_new(const lanes_method *own, const whirl_system *system,
                                   const whirl_integrate_options *options, const isa *set, size_t lane_count,
                                   size_t followed) {
    const whirl_lanes *form = system->lanes;
    adaptive_lanes shape = {.method = own,
                            .stop = system->stop,
                            .model = system->model,
                            .flow = form->flow[set->number],
                            .switches = form->switches[set->number],
                            .forcing_at = form->forcing[set->number],
                            .depends = form->depends,
                            .stride = own->group(form->degrees + form->states),
                            .degrees = form->degrees,
                            .rates = form->degrees + form->states,
                            .dimension = system->dimension,
                            .number_count = form->number_count,
                            .forcing_count = system->forcing_count,
                            .switch_count = form->switch_count,
                            .modulated = form->modulated,
                            .slides = form->slides,
                            .followed = followed,
                            .period = system->period,
                            .rtol = options->rtol,
                            .atol = options->atol,
                            .limit = options->limit,
                            .instants = options->steps_per_revolution,
                            .group_count = form->group_count,
                            .groups = form->groups,
                            .observe = {.probe_count = whirl_watched_probes(system),
                                        .probes = system->probes,
                                        .contact_count = form->contact_count,
                                        .by_force = form->damped,
                                        .rubs = form->rubs}};
    if (form->damped || form->rubs) shape.observe.contacts = form->contacts[set->number];
    shape.pair_laws = shape.stride == PAIR_STRIDE && followed == 0 ? form->pair_laws : NULL;
    // Pairs need a whole group of vectors; other structures use fewer vectors for few lanes.
    while (!shape.pair_laws && lane_count > 0 && (shape.stride - 1) * set->lanes >= lane_count) shape.stride--;
    shape.slots = shape.stride * set->lanes;
    return adaptive_lanes_make(&shape);
}

bool adaptive_lanes_make_room(adaptive_lanes *lanes, size_t samples, size_t lane_count) {
    if (samples <= lanes->sample_capacity) return true;
    free(lanes->samples);
    lanes->samples = malloc(samples * lanes->dimension * lane_count * sizeof(double));
    lanes->sample_capacity = lanes->samples ? samples : 0;
    return lanes->samples != NULL;
}

void adaptive_lanes_free(adaptive_lanes *lanes) {
    if (!lanes) return;
    free(lanes->block);
    free(lanes->queue);
    free(lanes->samples);
    free(lanes->rodas5p.sparsity);
    free(lanes);
}
