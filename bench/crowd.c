#include "crowd.h"

#include <stdlib.h>
#include <string.h>

#include "machines.h"

enum { SAMPLES = 64 }; ///< samples of a waveform in a revolution, the command's default

static void crowd_sample(void *context) {
    crowd *c = context;
    double *to = c->samples + c->sample_count++ * 2 * c->stations * c->lanes;
    for (size_t i = 0; i < 2 * c->stations; i++, to += c->lanes)
        memcpy(to, whirl_ensemble_coordinate(c->ensemble, i), c->lanes * sizeof *to);
}

/// Copies the samples of a revolution to the waveform of every machine, as the command's recorder does.
static void crowd_keep(crowd *c) {
    enum { NEIGHBOURS = 8 };
    const size_t rows = 2 * c->stations;
    for (size_t first = 0; first < c->lanes; first += NEIGHBOURS)
        for (size_t row = 0; row < rows; row++)
            for (size_t n = 0; n < c->sample_count; n++) {
                const double *from = c->samples + (n * rows + row) * c->lanes + first;
                for (size_t i = 0; i < NEIGHBOURS && first + i < c->lanes; i++)
                    c->waveform[((first + i) * rows + row) * SAMPLES + n] = from[i];
            }
}

void crowd_revolve(void *context) {
    crowd *c = context;
    c->sample_count = 0;
    whirl_ensemble_revolve(c->ensemble, c->lanes, c->watch.extremes ? &c->watch : NULL);
    if (c->watch.extremes) crowd_keep(c);
}

double crowd_x1(void *context) {
    return whirl_ensemble_coordinate(((crowd *)context)->ensemble, 0)[0];
}

void *room(size_t count, size_t size) {
    void *block = calloc(count, size);
    if (block) return block;
    must((whirl_status){.code = WHIRL_NO_MEMORY, .message = "no memory"});
    abort();
}

crowd *crowd_new(const crowd_kind *kind, bool watched) {
    crowd *c = room(1, sizeof *c);
    whirl_rotor *first = kind->rotor(kind->stations, 0, 1);
    const whirl_system *system = whirl_rotor_system(first);
    must(whirl_ensemble_new(system, &kind->options, 0, &c->ensemble));
    c->lanes = whirl_ensemble_lanes(c->ensemble);
    c->stations = kind->stations;
    c->rotors = room(c->lanes, sizeof *c->rotors);
    c->samples = room(SAMPLES * c->lanes * c->stations * 2, sizeof *c->samples);
    c->waveform = room(SAMPLES * c->lanes * c->stations * 2, sizeof *c->waveform);
    c->watch = (whirl_ensemble_observe){.extremes = watched,
                                        .stride = (size_t)kind->options.steps_per_revolution / SAMPLES,
                                        .sample = crowd_sample,
                                        .context = c};
    double *start = room(system->dimension, sizeof *start);
    kind->start(kind->stations, start);
    for (size_t lane = 0; lane < c->lanes; lane++) {
        c->rotors[lane] = lane == 0 ? first : kind->rotor(kind->stations, (int)lane, (int)c->lanes);
        must(whirl_ensemble_load(c->ensemble, lane, whirl_rotor_system(c->rotors[lane]), start));
    }
    free(start);
    return c;
}

void crowd_free(crowd *c) {
    whirl_ensemble_free(c->ensemble);
    for (size_t lane = 0; lane < c->lanes; lane++) whirl_rotor_free(c->rotors[lane]);
    free(c->rotors);
    free(c->samples);
    free(c->waveform);
    free(c);
}
