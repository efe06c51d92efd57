// Orbits of the paper's rotor without its stator along r_k, with multipliers and special points, by the public library:
// about a hundred from 0.6 to 0.37, in processor time, at a tolerance as tight as doubles allow and at looser ones.
//
//   bench_whirl_branch SECONDS CASE          measures
//   bench_whirl_branch --points RTOL CASE    prints the points, as tests/peers/auto/follow.py does
//   bench_whirl_branch --errors CASE         reads such points, and prints their largest errors: of a coordinate at
//                                            tau = 0, and of a multiplier
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machines.h"
#include "peer.h"

enum { DIMENSION = 8, SEGMENTS = 8 }; ///< segments fill the lanes of the widest vectors

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

static whirl_branch_options options_of(double rtol) {
    whirl_branch_options options = whirl_branch_default(last_ratio, first_ratio);
    options.most_step = 0.0105;
    options.orbit.segments = SEGMENTS;
    options.orbit.integrate.rtol = rtol;
    options.orbit.integrate.atol = 1e-3 * rtol;
    options.orbit.tolerance = fmax(rtol, 1e-12);
    return options;
}

/// Finds the orbit at the first value in one segment, then divides it into segments.
static whirl_orbit *find_first(const whirl_case *object, const whirl_branch_options *options) {
    const double start[DIMENSION] = {0.0, -0.9, 0.0, -0.8};
    whirl_orbit_options whole = options->orbit;
    whirl_machine machine;
    whirl_orbit *one, *cut;
    whole.segments = 1;
    must(make_machine(object, first_ratio, &machine));
    must(whirl_orbit_find(machine.system, start, 1, &whole, &one));
    must(whirl_orbit_find(machine.system, one->nodes, 1, &options->orbit, &cut));
    whirl_orbit_free(one);
    release(machine.owner);
    return cut;
}

static whirl_branch *follow(const whirl_case *object, const whirl_orbit *start, const whirl_branch_options *options) {
    const whirl_family family = {make_machine, object};
    whirl_branch *branch;
    must(whirl_branch_follow(&family, start, first_ratio, -1, options, &branch));
    return branch;
}

/// Follows the branch, and prints name, points a second, r_k of the last Neimark-Sacker point.
static void measure(const whirl_case *object, double rtol, double seconds) {
    const whirl_branch_options options = options_of(rtol);
    whirl_orbit *start = find_first(object, &options);
    double torus = 0.0, points = 0.0, spent = 0.0;
    const double begun = peer_clock();
    while (spent < seconds) {
        whirl_branch *branch = follow(object, start, &options);
        spent = peer_clock() - begun;
        points += (double)branch->count;
        for (size_t i = 0; i < branch->count; i++)
            if (branch->points[i].special == WHIRL_NEIMARK_SACKER) torus = branch->points[i].value;
        whirl_branch_free(branch);
    }
    printf("whirl, rtol %.0e\t%.6g\t%.13f\n", rtol, points / spent, torus);
    whirl_orbit_free(start);
}

static void print_points(const whirl_case *object, double rtol) {
    const whirl_branch_options options = options_of(rtol);
    whirl_orbit *start = find_first(object, &options);
    whirl_branch *branch = follow(object, start, &options);
    for (size_t p = 0; p < branch->count; p++) {
        const whirl_orbit *orbit = branch->points[p].orbit;
        printf("-\t%.15g", branch->points[p].value);
        for (int i = 0; i < DIMENSION; i++) printf("\t%.15g", orbit->nodes[i]);
        for (int i = 0; i < DIMENSION; i++)
            printf("\t%.15g\t%.15g", orbit->multipliers[i].real, orbit->multipliers[i].imaginary);
        putchar('\n');
    }
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

/// Returns the largest distance of a multiplier [real, imaginary] from the nearest of the orbit's.
static double multipliers_apart(const whirl_orbit *orbit, const double *multipliers) {
    double largest = 0.0;
    for (int i = 0; i < DIMENSION; i++) {
        double nearest = INFINITY;
        for (int k = 0; k < DIMENSION; k++)
            nearest = fmin(nearest, hypot(orbit->multipliers[k].real - multipliers[2 * i],
                                          orbit->multipliers[k].imaginary - multipliers[2 * i + 1]));
        largest = fmax(largest, nearest);
    }
    return largest;
}

/// Compares points with orbits found at tolerances as tight as doubles allow.
static void print_errors(const whirl_case *object) {
    const whirl_orbit_options exact = whirl_orbit_default();
    double numbers[1 + 3 * DIMENSION], start[DIMENSION], state = 0.0, multipliers = 0.0;
    while (scanf("%*s%lf", &numbers[0]) == 1) {
        whirl_machine machine;
        whirl_orbit *orbit;
        for (int i = 1; i <= 3 * DIMENSION; i++)
            if (scanf("%lf", &numbers[i]) != 1) exit(1);
        must(make_machine(object, numbers[0], &machine));
        for (int i = 0; i < DIMENSION; i++) start[i] = numbers[1 + i] + 1e-6; // off the orbit, so that it must be found
        must(whirl_orbit_find(machine.system, start, 1, &exact, &orbit));
        for (int i = 0; i < DIMENSION; i++) state = fmax(state, fabs(orbit->nodes[i] - numbers[1 + i]));
        multipliers = fmax(multipliers, multipliers_apart(orbit, numbers + 1 + DIMENSION));
        whirl_orbit_free(orbit);
        release(machine.owner);
    }
    printf("%.2g\t%.2g\n", state, multipliers);
}

int main(int argc, char **argv) {
    const bool points = argc == 4 && strcmp(argv[1], "--points") == 0;
    const bool errors = argc == 3 && strcmp(argv[1], "--errors") == 0;
    static const double tolerances[] = {1e-13, 1e-10, 1e-8, 1e-7};
    whirl_case *object;
    if (argc != 3 && !points) {
        fprintf(stderr, "usage: bench_whirl_branch SECONDS CASE | --points RTOL CASE | --errors CASE\n");
        return 2;
    }
    must(whirl_case_load(argv[argc - 1], NULL, &object));
    for (size_t i = 0; i < sizeof tolerances / sizeof *tolerances && !points && !errors; i++)
        measure(object, tolerances[i], peer_seconds(argc, argv));
    if (points) print_points(object, strtod(argv[2], NULL));
    if (errors) print_errors(object);
    whirl_case_free(object);
    return 0;
}
