/// Many of whirl's machines in lanes: bare, or watched as the command's recorder watches them.
#ifndef BENCH_CROWD_H
#define BENCH_CROWD_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine.h"

typedef struct crowd_kind {
    size_t stations;
    whirl_integrate_options options;
    whirl_rotor *(*rotor)(size_t stations, int lane, int lanes);
    void (*start)(size_t stations, double *x); ///< fills a state of zeros
} crowd_kind;

typedef struct crowd {
    whirl_rotor **rotors;
    whirl_ensemble *ensemble;
    size_t lanes, stations, sample_count;
    whirl_ensemble_observe watch;
    double *samples;  ///< samples of a revolution, [CROWD_SAMPLES][stations][2][lanes]
    double *waveform; ///< the same samples as records have them, [lanes][stations][2][CROWD_SAMPLES]
} crowd;

/// Allocates zeros; ends the program if there is no memory.
void *room(size_t count, size_t size);

crowd *crowd_new(const crowd_kind *kind, bool watched);
void crowd_free(crowd *c);

/// Carries all machines of a crowd over a revolution; a peer's function, whose context is the crowd.
void crowd_revolve(void *context);

/// Returns the first coordinate of the first machine.
double crowd_x1(void *context);

#endif
