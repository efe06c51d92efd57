// Follows the orbit of the paper's case over the stiffness ratio r_k of its shaft, stable or not, and prints its
// special points: folds, doublings, tori, first touches. The first torus that begins there is followed to its end, and
// the second frequency of the disc's motion is printed.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "whirl/engine.h"

static void release_rotor(void *rotor) {
    whirl_rotor_free(rotor);
}

/// The case's rotor at a value of r_k.
static whirl_status make_machine(const void *context, double r_k, whirl_machine *machine) {
    whirl_rotor *rotor;
    const whirl_status status = whirl_case_rotor(context, "r_k", r_k, &rotor);
    if (status.code == WHIRL_OK)
        *machine = (whirl_machine){.system = whirl_rotor_system(rotor), .owner = rotor, .release = release_rotor};
    return status;
}

/// Finds the orbit to begin with: lets the rotor settle at r_k, and applies Newton's method from the state that it
/// reaches.
static whirl_status settle(const whirl_family *family, double r_k, const whirl_branch_options *options,
                           whirl_orbit **orbit) {
    double x[8] = {0.0, -0.6, 0.0, -0.6}; // lengths in clearances
    whirl_integrator *integrator = NULL;
    whirl_machine machine;
    whirl_status status = family->machine(family->context, r_k, &machine);
    if (status.code != WHIRL_OK) return status;
    const whirl_integrate_options steps = whirl_integrate_default();
    status = whirl_integrator_new(machine.system, &steps, &integrator);
    for (int k = 0; k < 500 && status.code == WHIRL_OK; k++) whirl_integrator_revolve(integrator, x, NULL, NULL);
    if (status.code == WHIRL_OK) status = whirl_orbit_find(machine.system, x, 1, &options->orbit, orbit);
    whirl_integrator_free(integrator);
    machine.release(machine.owner);
    return status;
}

static void tell(const whirl_branch *branch) {
    static const char *const names[] = {
        "", "fold", "another branch crosses", "period doubling", "a torus", "whirl begins", "touch"};
    for (size_t i = 0; i < branch->count; i++) {
        const whirl_branch_point *point = &branch->points[i];
        const whirl_orbit *orbit = point->orbit;
        if (point->special != WHIRL_REGULAR)
            printf("r_k = %.8f  %s%s\n", point->value, names[point->special],
                   point->criticality > 0.0 ? " (subcritical)" : "");
        else if (i == 0 || i + 1 == branch->count)
            printf("r_k = %.8f  P-%zu, %s, largest multiplier %.4f\n", point->value, orbit->revolutions,
                   orbit->unstable == 0 ? "stable" : "unstable",
                   hypot(orbit->multipliers[0].real, orbit->multipliers[0].imaginary));
    }
}

static whirl_status tell_tori(const whirl_family *family, const whirl_torus_branch *tori,
                              const whirl_torus_options *options) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < tori->count && status.code == WHIRL_OK; i++) {
        const whirl_torus *torus = tori->points[i].torus;
        whirl_machine machine;
        double frequency = NAN, amplitude;
        status = family->machine(family->context, tori->points[i].value, &machine);
        if (status.code != WHIRL_OK) break;
        status = whirl_torus_line(machine.system, torus, options, 0, &frequency, &amplitude);
        machine.release(machine.owner);
        printf("r_k = %.8f    torus, second frequency %.6f of the speed, %s, %zu nodes\n", tori->points[i].value,
               frequency, torus->unstable == 0 ? "stable" : "unstable", torus->node_count);
    }
    printf("%s\n", tori->why);
    return status;
}

/// Follows the first torus that begins on the branch, to lower r_k.
static whirl_status follow_torus(const whirl_family *family, const whirl_branch *branch, double from, double to) {
    const whirl_branch_point *point = NULL;
    whirl_torus_branch_options options = whirl_torus_branch_default(to, from);
    whirl_torus *first = NULL;
    whirl_torus_branch *tori = NULL;
    double r_k;
    for (size_t i = 0; i < branch->count && !point; i++)
        if (branch->points[i].special == WHIRL_NEIMARK_SACKER) point = &branch->points[i];
    if (!point) return whirl_ok();
    options.torus.accuracy = 1e-5;
    options.torus.most_nodes = 63;
    whirl_status status = whirl_torus_begin(family, point, 0.02, &options, &first, &r_k);
    if (status.code == WHIRL_OK) status = whirl_torus_follow(family, first, r_k, -1, &options, &tori);
    if (status.code == WHIRL_OK) status = tell_tori(family, tori, &options.torus);
    whirl_torus_branch_free(tori);
    whirl_torus_free(first);
    return status;
}

int main(void) {
    const double from = 0.8, to = 0.3;
    whirl_case *rotor = NULL;
    whirl_orbit *start = NULL;
    whirl_branch *branch = NULL;
    whirl_status status = whirl_case_load("cases/paper.yaml", NULL, &rotor);
    const whirl_family family = {make_machine, rotor};
    const whirl_branch_options options = whirl_branch_default(to, from);
    if (status.code == WHIRL_OK) status = settle(&family, from, &options, &start);
    if (status.code == WHIRL_OK) status = whirl_branch_follow(&family, start, from, -1, &options, &branch);
    if (status.code == WHIRL_OK) tell(branch);
    if (status.code == WHIRL_OK) status = follow_torus(&family, branch, from, to);
    if (status.code != WHIRL_OK) fprintf(stderr, "%s\n", status.message);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
    whirl_case_free(rotor);
    return status.code == WHIRL_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
