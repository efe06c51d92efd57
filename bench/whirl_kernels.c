// whirl's own kernels, through the public library: the ensemble of the instruction set that WHIRL_ISA names, bare and
// watched, of the paper's two stations, of ten and of fifty; and the integrator of single machines.
//
//   bench_whirl_kernels SECONDS [KIND...]      kinds: integrator bare watched ten fifty; all without
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machines.h"
#include "peer.h"
#include "rotor.h"

enum { SAMPLES = 64 }; ///< of a waveform a revolution, the command's default

/// A single machine with its integrator.
typedef struct single {
    whirl_rotor *rotor;
    whirl_integrator *integrator;
    double *x;
} single;

static void single_revolve(void *context) {
    single *s = context;
    whirl_integrator_revolve(s->integrator, s->x, NULL, NULL);
}

static double single_x1(void *context) {
    return ((single *)context)->x[0];
}

/// Many machines in lanes.
typedef struct crowd {
    whirl_rotor **rotors;
    whirl_ensemble *ensemble;
    size_t lanes, stations, sample_count;
    whirl_ensemble_observe watch;
    double *samples;  ///< [SAMPLES][stations][2][lanes] of a revolution
    double *waveform; ///< [lanes][stations][2][SAMPLES], as records have them
} crowd;

static void crowd_sample(void *context) {
    crowd *c = context;
    double *to = c->samples + c->sample_count++ * 2 * c->stations * c->lanes;
    for (size_t i = 0; i < 2 * c->stations; i++, to += c->lanes)
        memcpy(to, whirl_ensemble_coordinate(c->ensemble, i), c->lanes * sizeof *to);
}

/// The samples of a revolution go to the waveform of every machine, as the command's recorder does it.
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

static void crowd_revolve(void *context) {
    crowd *c = context;
    c->sample_count = 0;
    whirl_ensemble_revolve(c->ensemble, c->lanes, c->watch.extremes ? &c->watch : NULL);
    if (c->watch.extremes) crowd_keep(c);
}

static double crowd_x1(void *context) {
    return whirl_ensemble_coordinate(((crowd *)context)->ensemble, 0)[0];
}

static void *room(size_t count, size_t size) {
    void *block = calloc(count, size);
    if (block) return block;
    must((whirl_status){.code = WHIRL_NO_MEMORY, .message = "no memory"});
    abort();
}

static whirl_rotor *rotor_of(size_t stations, double r_k) {
    return stations == 2 ? paper_rotor(r_k) : chain_rotor(stations, r_k);
}

/// From rest at y = -0.1 everywhere.
static double *start_of(size_t stations) {
    double *x = room(4 * stations, sizeof *x);
    for (size_t s = 0; s < stations; s++) x[2 * s + 1] = -0.1;
    return x;
}

static single single_new(size_t stations) {
    const whirl_integrate_options options = whirl_integrate_default();
    single s = {.rotor = rotor_of(stations, ROTOR_R_K), .x = start_of(stations)};
    must(whirl_integrator_new(whirl_rotor_system(s.rotor), &options, &s.integrator));
    return s;
}

static void single_free(single *s) {
    whirl_integrator_free(s->integrator);
    whirl_rotor_free(s->rotor);
    free(s->x);
}

static crowd *crowd_new(size_t stations, bool watched) {
    const whirl_integrate_options options = whirl_integrate_default();
    crowd *c = room(1, sizeof *c);
    whirl_rotor *first = rotor_of(stations, ROTOR_R_K);
    must(whirl_ensemble_new(whirl_rotor_system(first), &options, 0, &c->ensemble));
    c->lanes = whirl_ensemble_lanes(c->ensemble);
    c->stations = stations;
    c->rotors = room(c->lanes, sizeof *c->rotors);
    c->samples = room(SAMPLES * c->lanes * stations * 2, sizeof *c->samples);
    c->waveform = room(SAMPLES * c->lanes * stations * 2, sizeof *c->waveform);
    c->watch = (whirl_ensemble_observe){watched, ROTOR_STEPS / SAMPLES, crowd_sample, c};
    double *start = start_of(stations);
    for (size_t lane = 0; lane < c->lanes; lane++) {
        c->rotors[lane] = lane == 0 ? first : rotor_of(stations, rotor_r_k((int)lane, (int)c->lanes));
        must(whirl_ensemble_load(c->ensemble, lane, whirl_rotor_system(c->rotors[lane]), start));
    }
    free(start);
    return c;
}

static void crowd_free(crowd *c) {
    whirl_ensemble_free(c->ensemble);
    for (size_t lane = 0; lane < c->lanes; lane++) whirl_rotor_free(c->rotors[lane]);
    free(c->rotors);
    free(c->samples);
    free(c->waveform);
    free(c);
}

/// Chains have no peer elsewhere: their lanes must agree with the integrator of single machines, and stay bounded.
static void check_chain(size_t stations) {
    crowd *c = crowd_new(stations, false);
    single s = single_new(stations);
    for (int i = 0; i < 20; i++) {
        crowd_revolve(c);
        single_revolve(&s);
    }
    const double apart = fabs(crowd_x1(c) - single_x1(&s));
    bool bounded = true;
    for (size_t lane = 0; lane < c->lanes; lane++)
        bounded = bounded && whirl_ensemble_motion(c->ensemble, lane) == WHIRL_BOUNDED;
    if (!(apart < 1e-9) || !bounded) {
        fprintf(stderr, "bench: %zu stations: lane and integrator are %.1e apart%s\n", stations, apart,
                bounded ? "" : ", and a lane diverged");
        exit(1);
    }
    single_free(&s);
    crowd_free(c);
}

static void measure_crowd(const char *kind, size_t stations, bool watched, double seconds) {
    if (stations > 2) check_chain(stations);
    char name[64];
    crowd *c = crowd_new(stations, watched);
    snprintf(name, sizeof name, "whirl %s %s", whirl_ensemble_isa(c->ensemble), kind);
    peer_measure(&(peer){name, c->lanes, crowd_revolve, crowd_x1, c}, seconds);
    crowd_free(c);
}

static void measure_integrator(double seconds) {
    single s = single_new(2);
    peer_measure(&(peer){"whirl integrator", 1, single_revolve, single_x1, &s}, seconds);
    single_free(&s);
}

static bool wanted(int argc, char **argv, const char *kind) {
    for (int i = 2; i < argc; i++)
        if (strcmp(argv[i], kind) == 0) return true;
    return argc <= 2;
}

int main(int argc, char **argv) {
    const double seconds = peer_seconds(argc, argv);
    if (wanted(argc, argv, "integrator")) measure_integrator(seconds);
    if (wanted(argc, argv, "bare")) measure_crowd("bare", 2, false, seconds);
    if (wanted(argc, argv, "watched")) measure_crowd("watched", 2, true, seconds);
    if (wanted(argc, argv, "ten")) measure_crowd("ten", 10, false, seconds);
    if (wanted(argc, argv, "fifty")) measure_crowd("fifty", 50, false, seconds);
    return 0;
}
