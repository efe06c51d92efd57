// whirl's kernels on the overhung rotor, through the public library, in the instruction set that WHIRL_ISA names: RK4
// bare and watched, and rodas5p with its contacts located.
//
//   bench_whirl_overhung SECONDS
#include <stdio.h>
#include <string.h>

#include "crowd.h"
#include "machines.h"
#include "overhung.h"
#include "peer.h"

static whirl_rotor *rotor_of(size_t stations, int lane, int lanes) {
    (void)stations;
    return overhung_rotor(overhung_speed(lane, lanes));
}

static void start_of(size_t stations, double *x) {
    (void)stations;
    for (size_t i = 0; i < OVERHUNG_PORTS / 2; i++) x[2 * i + 1] = overhung_start[i];
}

static double left_y(void *context) {
    return whirl_ensemble_coordinate(((crowd *)context)->ensemble, 1)[0];
}

static void measure(const char *title, const char *method, bool watched, double seconds) {
    crowd_kind kind = {OVERHUNG_PORTS / 2, whirl_integrate_default(), rotor_of, start_of};
    char name[64];
    snprintf(kind.options.method, sizeof kind.options.method, "%s", method);
    kind.options.steps_per_revolution = OVERHUNG_STEPS;
    kind.options.rtol = OVERHUNG_RTOL;
    kind.options.atol = OVERHUNG_ATOL;
    crowd *c = crowd_new(&kind, watched);
    snprintf(name, sizeof name, "whirl %s %s", whirl_ensemble_isa(c->ensemble), title);
    peer_measure_steps(&(peer){name, c->lanes, crowd_revolve, left_y, c}, OVERHUNG_STEPS, seconds);
    crowd_free(c);
}

int main(int argc, char **argv) {
    const double seconds = peer_seconds(argc, argv);
    measure("bare", "rk4", false, seconds);
    measure("watched", "rk4", true, seconds);
    measure("rodas5p", "rodas5p", false, seconds);
    return 0;
}
