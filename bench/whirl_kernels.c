// whirl's own kernels, through the public library: the ensemble of the instruction set that WHIRL_ISA names, bare and
// watched, for rotors of two stations (the paper's), of ten and of fifty; and the integrator of single machines.
//
//   bench_whirl_kernels SECONDS [KIND...]      kinds: integrator bare watched ten fifty films; all without
//
// films: ten journals without films, in short films, in films of finite length, and in films whose length differs from
// lane to lane.
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crowd.h"
#include "machines.h"
#include "peer.h"
#include "rotor.h"

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

static whirl_rotor *rotor_of(size_t stations, int lane, int lanes) {
    const double r_k = rotor_r_k(lane, lanes);
    return stations == 2 ? paper_rotor(r_k) : chain_rotor(stations, r_k);
}

/// Starts all stations from rest at y = -0.1.
static void start_of(size_t stations, double *x) {
    for (size_t i = 0; i < stations; i++) x[2 * i + 1] = -0.1;
}

static crowd_kind kind_of(size_t stations) {
    return (crowd_kind){stations, whirl_integrate_default(), rotor_of, start_of};
}

static single single_new(size_t stations) {
    const whirl_integrate_options options = whirl_integrate_default();
    single s = {.rotor = rotor_of(stations, 0, 1), .x = room(4 * stations, sizeof *s.x)};
    start_of(stations, s.x);
    must(whirl_integrator_new(whirl_rotor_system(s.rotor), &options, &s.integrator));
    return s;
}

static void single_free(single *s) {
    whirl_integrator_free(s->integrator);
    whirl_rotor_free(s->rotor);
    free(s->x);
}

/// Checks that all lanes of a chain stay bounded, and that the first agrees with the integrator of single machines: no
/// peer computes chains.
static void check_chain(size_t stations) {
    const crowd_kind kind = kind_of(stations);
    crowd *c = crowd_new(&kind, false);
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
    const crowd_kind of = kind_of(stations);
    crowd *c = crowd_new(&of, watched);
    snprintf(name, sizeof name, "whirl %s %s", whirl_ensemble_isa(c->ensemble), kind);
    peer_measure(&(peer){name, c->lanes, crowd_revolve, crowd_x1, c}, seconds);
    crowd_free(c);
}

static void measure_integrator(double seconds) {
    single s = single_new(2);
    peer_measure(&(peer){"whirl integrator", 1, single_revolve, single_x1, &s}, seconds);
    single_free(&s);
}

static whirl_rotor *unsupported(size_t stations, int lane, int lanes) {
    (void)stations, (void)lane, (void)lanes;
    return films_rotor(NULL, 0.025);
}

static whirl_rotor *in_short_films(size_t stations, int lane, int lanes) {
    (void)stations, (void)lane, (void)lanes;
    return films_rotor("short", 0.025);
}

static whirl_rotor *in_finite_films(size_t stations, int lane, int lanes) {
    (void)stations, (void)lane, (void)lanes;
    return films_rotor("finite", 0.025);
}

static whirl_rotor *in_different_films(size_t stations, int lane, int lanes) {
    (void)stations;
    return films_rotor("finite", 0.025 + 0.01 * lane / lanes);
}

static void measure_films(double seconds) {
    enum { FILMS = 10 };
    static const struct {
        const char *name;
        whirl_rotor *(*rotor)(size_t stations, int lane, int lanes);
    } kinds[] = {{"none", unsupported},
                 {"short", in_short_films},
                 {"finite", in_finite_films},
                 {"finite, of all lengths", in_different_films}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        char name[64];
        const crowd_kind kind = {FILMS, whirl_integrate_default(), kinds[i].rotor, start_of};
        crowd *c = crowd_new(&kind, false);
        snprintf(name, sizeof name, "whirl %s films: %s", whirl_ensemble_isa(c->ensemble), kinds[i].name);
        peer_measure(&(peer){name, c->lanes, crowd_revolve, crowd_x1, c}, seconds);
        crowd_free(c);
    }
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
    if (wanted(argc, argv, "films")) measure_films(seconds);
    return 0;
}
