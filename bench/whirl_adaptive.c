// whirl's methods that locate contacts, through the public library: dop853 in lanes of the instruction set that
// WHIRL_ISA names, at the peers' tolerance and tighter, RK4 with located contacts and plain RK4, and dop853 for a
// single machine.
//
//   bench_whirl_adaptive SECONDS [alone]
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "adaptive.h"
#include "machines.h"
#include "peer.h"

enum { MAX_LANES = 1024 };

typedef struct lanes {
    whirl_rotor *rotors[MAX_LANES];
    whirl_ensemble *ensemble;
    size_t count;
} lanes;

static void revolve_lanes(void *context) {
    const lanes *own = context;
    whirl_ensemble_revolve(own->ensemble, own->count, NULL);
}
static void state_of_lane(void *context, double z[ROTOR_DIMENSION]) {
    whirl_ensemble_state(((lanes *)context)->ensemble, 0, z);
}

/// Measures machines in lanes. The first one is that of the peers, the others are its neighbours: r_k from 0.55 to
/// 0.65.
static void measure_lanes(const char *method, double rtol, bool located, double seconds) {
    const double start[ROTOR_DIMENSION] = ROTOR_START;
    whirl_integrate_options options = whirl_integrate_default();
    lanes own;
    char name[96];
    snprintf(options.method, sizeof options.method, "%s", method);
    options.rtol = rtol;
    options.atol = rtol * (ADAPTIVE_ATOL / ADAPTIVE_RTOL);
    options.located = located;
    own.rotors[0] = paper_rotor(ROTOR_R_K);
    must(whirl_ensemble_new(whirl_rotor_system(own.rotors[0]), &options, 0, &own.ensemble));
    own.count = whirl_ensemble_lanes(own.ensemble);
    if (own.count > MAX_LANES) own.count = MAX_LANES;
    for (size_t i = 0; i < own.count; i++) {
        if (i > 0) own.rotors[i] = paper_rotor(0.55 + 0.1 * (double)i / (double)(own.count - 1));
        must(whirl_ensemble_load(own.ensemble, i, whirl_rotor_system(own.rotors[i]), start));
    }
    if (strcmp(method, "rk4") == 0)
        snprintf(name, sizeof name, "whirl %s rk4, 1024 steps%s", whirl_ensemble_isa(own.ensemble),
                 located ? ", contacts located" : "");
    else
        snprintf(name, sizeof name, "whirl %s dop853, rtol %.0e", whirl_ensemble_isa(own.ensemble), rtol);
    adaptive_measure(&(adaptive_peer){name, own.count, revolve_lanes, state_of_lane, &own}, seconds);
    whirl_ensemble_free(own.ensemble);
    for (size_t i = 0; i < own.count; i++) whirl_rotor_free(own.rotors[i]);
}

typedef struct single {
    whirl_integrator *integrator;
    double z[ROTOR_DIMENSION];
} single;

static void revolve_single(void *context) {
    single *s = context;
    if (whirl_integrator_revolve(s->integrator, s->z, NULL, NULL) != WHIRL_BOUNDED) abort();
}
static void state_of_single(void *context, double z[ROTOR_DIMENSION]) {
    memcpy(z, ((single *)context)->z, ROTOR_DIMENSION * sizeof *z);
}

static void measure_single(double seconds) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_rotor *rotor = paper_rotor(ROTOR_R_K);
    single s = {.z = ROTOR_START};
    snprintf(options.method, sizeof options.method, "dop853");
    options.rtol = ADAPTIVE_RTOL;
    options.atol = ADAPTIVE_ATOL;
    must(whirl_integrator_new(whirl_rotor_system(rotor), &options, &s.integrator));
    adaptive_measure(&(adaptive_peer){"whirl integrator dop853", 1, revolve_single, state_of_single, &s}, seconds);
    whirl_integrator_free(s.integrator);
    whirl_rotor_free(rotor);
}

int main(int argc, char **argv) {
    const double seconds = peer_seconds(argc, argv);
    if (argc > 2 && strcmp(argv[2], "alone") == 0) {
        measure_single(seconds);
        return 0;
    }
    measure_lanes("dop853", ADAPTIVE_RTOL, true, seconds);
    measure_lanes("dop853", 4e-11, true, seconds);
    measure_lanes("rk4", ADAPTIVE_RTOL, true, seconds);
    measure_lanes("rk4", ADAPTIVE_RTOL, false, seconds);
    return 0;
}
