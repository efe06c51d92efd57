// Steps a second of whirl's scalar engine beside straightforward C, in one run on one core.
//
// The rotor is that of the 2015 paper with film coefficient 0.0045 and G = 0.115976, from rest at y = -0.1, 1024 steps a
// revolution. Rounds alternate, so that a noisy machine is noisy for all; the best round of each counts.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "straightforward.h"
#include "whirl/whirl.h"

enum { STEPS = 1024, REVOLUTIONS = 400, ROUNDS = 7 };

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void must(whirl_status status) {
    if (status.code == WHIRL_OK) return;
    fprintf(stderr, "bench: %s\n", status.message);
    exit(1);
}

static const straightforward_rotor paper = {.r_k = 0.6,
                                            .r_m = 8.4,
                                            .w = 0.2,
                                            .xi1 = 0.0157509,
                                            .xi2 = 0.286154,
                                            .rho = 0.08,
                                            .r_delta = 1.2,
                                            .r_ck = 10,
                                            .f = 0.1,
                                            .S_f = 0.0045,
                                            .G = 0.115976};

/// The same rotor from elements, in SI with omega = 1, c = 1 and m2 = 1.
static whirl_rotor *build(void) {
    const straightforward_rotor *p = &paper;
    const double k2 = 1.0 / (p->w * p->w);
    const whirl_setting disc[] = {{"mass", p->r_m, 0}, {"damping", p->xi1 * p->r_m, 0}, {"eccentricity", p->rho, 0}};
    const whirl_setting journal[] = {{"mass", 2, 0}, {"damping", p->xi2, 0}};
    const whirl_setting shaft[] = {
        {"between", 0, "disc, journal"}, {"k1", p->r_k * k2, 0}, {"k2", k2, 0}, {"signs", 0, "paper"}};
    const whirl_setting film[] = {{"at", 0, "journal"}, {"count", 2, 0}, {"clearance", 1, 0}, {"load", p->S_f, 0}};
    const whirl_setting rub[] = {
        {"at", 0, "disc"}, {"gap", p->r_delta, 0}, {"stiffness", p->r_ck * k2, 0}, {"friction", p->f, 0}};
    const whirl_setting gravity[] = {{"acceleration", p->G, 0}};
    whirl_design *design;
    whirl_rotor *rotor;
    must(whirl_design_new(1.0, 1.0, &design));
    must(whirl_design_station(design, "disc", disc, 3));
    must(whirl_design_station(design, "journal", journal, 2));
    must(whirl_design_element(design, "shaft", shaft, 4));
    must(whirl_design_element(design, "film", film, 4));
    must(whirl_design_element(design, "rub", rub, 4));
    must(whirl_design_element(design, "gravity", gravity, 1));
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

typedef struct runner {
    const char *name;
    double (*run)(
        const whirl_rotor *rotor); ///< a number that depends on the end state, so that nothing is optimised away
    double best, end;
} runner;

static double run_straightforward(const whirl_rotor *rotor) {
    double z[8] = {0, -0.1, 0, -0.1};
    (void)rotor;
    for (int i = 0; i < REVOLUTIONS; i++) straightforward_revolve(&paper, STEPS, z);
    return z[0];
}

static double run_bare(const whirl_rotor *rotor) {
    const whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    double z[8] = {0, -0.1, 0, -0.1};
    must(whirl_integrator_new(whirl_rotor_system(rotor), &options, &integrator));
    for (int i = 0; i < REVOLUTIONS; i++) whirl_integrator_revolve(integrator, z, NULL, NULL);
    whirl_integrator_free(integrator);
    return z[0];
}

static double run_recorded(const whirl_rotor *rotor) {
    const whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    const double start[8] = {0, -0.1, 0, -0.1};
    whirl_record *record;
    options.transient = 0;
    options.record = REVOLUTIONS;
    options.growth = false;
    must(whirl_record_motion(whirl_rotor_system(rotor), &integrate, &options, start, NULL, &record));
    const double end = record->end[0];
    whirl_record_free(record);
    return end;
}

int main(void) {
    runner runners[] = {{"straightforward C, -O3", run_straightforward, 0, 0},
                        {"whirl, rotor from elements", run_bare, 0, 0},
                        {"whirl, every revolution recorded", run_recorded, 0, 0}};
    const size_t count = sizeof runners / sizeof *runners;
    whirl_rotor *rotor = build();
    for (int round = 0; round < ROUNDS; round++)
        for (size_t i = 0; i < count; i++) {
            const double start = seconds();
            runners[i].end = runners[i].run(rotor);
            const double rate = (double)STEPS * REVOLUTIONS / (seconds() - start);
            runners[i].best = rate > runners[i].best ? rate : runners[i].best;
        }
    whirl_rotor_free(rotor);
    printf("%-36s %12s %8s\n", "RK4, 1024 steps a revolution", "steps/s", "ratio");
    for (size_t i = 0; i < count; i++)
        printf("%-36s %12.3g %8.2f\n", runners[i].name, runners[i].best, runners[i].best / runners[0].best);
    const double apart = fabs(runners[0].end - runners[1].end);
    printf("end states after %d revolutions differ by %.1e\n", REVOLUTIONS, apart);
    return apart < 1e-6 ? 0 : 1;
}
