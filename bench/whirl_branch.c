// Orbits of the paper's rotor without its stator along r_k, with multipliers and special points, by the public library:
// about a hundred from 0.6 to 0.37, in processor time, at a tolerance as tight as doubles allow and at looser ones.
//
//   bench_whirl_branch SECONDS CASE
#include <stdio.h>
#include <stdlib.h>

#include "machines.h"
#include "peer.h"

static const double first_ratio = 0.6, last_ratio = 0.37;

static void release(void *rotor) {
    whirl_rotor_free(rotor);
}

static whirl_status make_machine(const void *object, double r_k, whirl_machine *machine) {
    whirl_rotor *rotor;
    const whirl_status status = whirl_case_rotor(object, "r_k", r_k, &rotor);
    if (status.code != WHIRL_OK) return status;
    *machine = (whirl_machine){.system = whirl_rotor_system(rotor), .owner = rotor, .release = release};
    return whirl_ok();
}

/// Follows the branch, and prints name, points a second, r_k of the last Neimark-Sacker point.
static void measure(const whirl_case *object, double rtol, double seconds) {
    const double start[] = {0.0, -0.9, 0.0, -0.8, 0.0, 0.0, 0.0, 0.0};
    const whirl_family family = {make_machine, object};
    whirl_branch_options options = whirl_branch_default(last_ratio, first_ratio);
    whirl_machine machine;
    whirl_orbit *one, *orbit;
    whirl_branch *branch;
    double torus = 0.0, points = 0.0, spent = 0.0;
    options.most_step = 0.0105;
    options.orbit.integrate.rtol = rtol;
    options.orbit.integrate.atol = 1e-3 * rtol;
    options.orbit.tolerance = 10.0 * rtol;
    must(make_machine(object, first_ratio, &machine));
    options.orbit.segments = 1;
    must(whirl_orbit_find(machine.system, start, 1, &options.orbit, &one));
    options.orbit.segments = 8;
    must(whirl_orbit_find(machine.system, one->nodes, 1, &options.orbit, &orbit));
    whirl_orbit_free(one);
    machine.release(machine.owner);
    const double begun = peer_clock();
    while (spent < seconds) {
        must(whirl_branch_follow(&family, orbit, first_ratio, -1, &options, &branch));
        spent = peer_clock() - begun;
        points += (double)branch->count;
        for (size_t i = 0; i < branch->count; i++)
            if (branch->points[i].special == WHIRL_NEIMARK_SACKER) torus = branch->points[i].value;
        whirl_branch_free(branch);
    }
    printf("whirl, rtol %.0e\t%.6g\t%.13f\n", rtol, points / spent, torus);
    whirl_orbit_free(orbit);
}

int main(int argc, char **argv) {
    whirl_case *object;
    if (argc != 3) {
        fprintf(stderr, "usage: bench_whirl_branch SECONDS CASE\n");
        return 2;
    }
    must(whirl_case_load(argv[2], NULL, &object));
    measure(object, 1e-13, peer_seconds(argc, argv));
    measure(object, 1e-10, peer_seconds(argc, argv));
    measure(object, 1e-8, peer_seconds(argc, argv));
    whirl_case_free(object);
    return 0;
}
