// All disturbances of many machines side by side: the memory, and what goes in and out.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "isa.h"
#include "method.h"
#include "variational_lanes.h"
#include "vector.h"
#include "whirl/ensemble.h"

variational_lanes_revolve *const variational_lanes_revolves[VECTOR_ISAS] = EVERY_ISA(, variational_lanes);

struct whirl_variational {
    const whirl_system *system; ///< of the first machine: the structure
    const isa *isa;
    variational_lanes lanes;
    double *forcing, *block; ///< block: all arrays of lanes, aligned to 64 bytes
};

/// Beyond this their memory is out of all proportion: it grows with the square of the dimension, and with the lanes.
enum { MOST_DISTURBANCES = 256 };

bool whirl_variational_takes(const whirl_system *system, const whirl_integrate_options *options) {
    return system->lanes && strcmp(options->method, "rk4") == 0 && !options->located && !system->lanes->jumps &&
           !system->lanes->slides && system->dimension <= MOST_DISTURBANCES;
}

/// Rows of the block, and where each array begins.
static size_t lay_out(whirl_variational *f, double *block) {
    variational_lanes *l = &f->lanes;
    const size_t sets = 1 + l->disturbances, places = sets * l->degrees, rates = sets * l->rates;
    size_t row = 0;
    const struct {
        double **array;
        size_t rows;
    } parts[] = {{&l->q, places},
                 {&l->v, rates},
                 {&l->stage_q, places},
                 {&l->stage_v, rates},
                 {&l->k[0], rates},
                 {&l->k[1], rates},
                 {&l->k[2], rates},
                 {&l->numbers, f->system->lanes->number_count},
                 {&l->now, l->forcing_count},
                 {&l->divergence[0], 1},
                 {&l->divergence[1], 1},
                 {&l->divergence[2], 1},
                 {&l->divergence[3], 1},
                 {&l->volume, 1},
                 {&l->lengths, l->disturbances},
                 {&l->growth, l->disturbances}};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        *parts[i].array = block ? block + row * f->lanes.lane_count : NULL;
        row += parts[i].rows;
    }
    return row;
}

/// The logarithms of all products of lengths, which begin afresh.
static void note_lengths(variational_lanes *lanes) {
    for (size_t i = 0; i < lanes->disturbances * lanes->lane_count; i++) {
        lanes->growth[i] += log(lanes->lengths[i]);
        lanes->lengths[i] = 1.0;
    }
}

static bool allocate(whirl_variational *f) {
    const whirl_system *system = f->system;
    const size_t instants = 2 * (size_t)f->lanes.steps + 1;
    const size_t bytes = lay_out(f, NULL) * f->lanes.lane_count * sizeof(double);
    f->block = aligned_alloc(64, (bytes + 63) / 64 * 64);
    f->forcing = malloc((instants * system->forcing_count + 1) * sizeof *f->forcing);
    if (!f->block || !f->forcing) return false;
    memset(f->block, 0, bytes);
    lay_out(f, f->block);
    for (size_t i = 0; i < instants && system->forcing_count > 0; i++)
        system->forcing(system->model, system->period * ((double)i / (2.0 * f->lanes.steps)),
                        f->forcing + i * system->forcing_count);
    f->lanes.forcing = f->forcing;
    return true;
}

whirl_status whirl_variational_new(const whirl_system *system, const whirl_integrate_options *options,
                                   whirl_variational **out) {
    enum { ORTHONORMAL = 64 };                              // times in a revolution, as rk4.c
    const size_t vectors = system->dimension <= 16 ? 2 : 1; // what fits into the first cache
    *out = NULL;
    if (!whirl_variational_takes(system, options))
        return whirl_fail(WHIRL_BAD_INPUT, "disturbances of this system do not go in lanes, expected a rotor without "
                                           "jumps of its forces, and rk4 that walks over contacts");
    whirl_status status = check_options(system, options);
    if (status.code != WHIRL_OK) return status;
    whirl_variational *f = calloc(1, sizeof *f);
    if (!f) return whirl_fail(WHIRL_NO_MEMORY, "no memory to follow disturbances");
    f->system = system;
    status = isa_choose(&f->isa);
    if (status.code == WHIRL_OK) {
        f->lanes = (variational_lanes){.model = system->model,
                                       .flow = system->lanes->flow[f->isa->number],
                                       .stride = vectors,
                                       .lane_count = vectors * f->isa->lanes,
                                       .degrees = system->lanes->degrees,
                                       .rates = system->lanes->degrees + system->lanes->states,
                                       .disturbances = system->dimension,
                                       .forcing_count = system->forcing_count,
                                       .steps = options->steps_per_revolution,
                                       .often = (options->steps_per_revolution + ORTHONORMAL - 1) / ORTHONORMAL,
                                       .step = system->period / options->steps_per_revolution,
                                       .note = note_lengths};
        if (!allocate(f)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory to follow disturbances");
    }
    if (status.code == WHIRL_OK)
        *out = f;
    else
        whirl_variational_free(f);
    return status;
}

void whirl_variational_free(whirl_variational *f) {
    if (!f) return;
    free(f->block);
    free(f->forcing);
    free(f);
}

size_t whirl_variational_lanes(const whirl_variational *f) {
    return f->lanes.lane_count;
}

/// Puts a state (which = 0) or a disturbance [dimension] into a lane.
static void place(whirl_variational *f, size_t lane, size_t which, const double *x) {
    const size_t degrees = f->lanes.degrees, rates = f->lanes.rates, count = f->lanes.lane_count;
    for (size_t d = 0; d < degrees; d++) f->lanes.q[(which * degrees + d) * count + lane] = x[d];
    for (size_t d = 0; d < rates; d++) f->lanes.v[(which * rates + d) * count + lane] = x[degrees + d];
}

whirl_status whirl_variational_load(whirl_variational *f, size_t lane, const whirl_system *system, const double *x,
                                    const double *vectors) {
    const size_t numbers = f->system->lanes->number_count;
    double *own = malloc(numbers * sizeof *own);
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    system->lanes->numbers(system->model, own);
    for (size_t i = 0; i < numbers; i++) f->lanes.numbers[i * f->lanes.lane_count + lane] = own[i];
    free(own);
    place(f, lane, 0, x);
    for (size_t k = 0; k < f->lanes.disturbances; k++) {
        place(f, lane, k + 1, vectors + k * system->dimension);
        f->lanes.lengths[k * f->lanes.lane_count + lane] = 1.0;
        f->lanes.growth[k * f->lanes.lane_count + lane] = 0.0;
    }
    f->lanes.volume[lane] = 0.0;
    return whirl_ok();
}

void whirl_variational_revolve(whirl_variational *f) {
    variational_lanes_revolves[f->isa->number](&f->lanes);
}

void whirl_variational_read(const whirl_variational *f, size_t lane, double *vectors, double *growth, double *volume) {
    const size_t degrees = f->lanes.degrees, rates = f->lanes.rates, count = f->lanes.lane_count;
    for (size_t k = 0; k < f->lanes.disturbances; k++) {
        for (size_t d = 0; d < degrees; d++) *vectors++ = f->lanes.q[((k + 1) * degrees + d) * count + lane];
        for (size_t d = 0; d < rates; d++) *vectors++ = f->lanes.v[((k + 1) * rates + d) * count + lane];
        growth[k] = f->lanes.growth[k * count + lane];
    }
    *volume = f->lanes.volume[lane];
}
