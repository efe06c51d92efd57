// Four journals by themselves, each in a bearing of five pads (pads.h), in lanes of the instruction set that WHIRL_ISA
// names: pads that tilt with inertia, as the peer has them, pads that tilt without inertia, and fixed pads. For
// comparison also one plain film a journal, short or of finite length, and no bearing: they show the cost of a film.
//
//   bench_whirl_pads SECONDS
#include <stdio.h>

#include "crowd.h"
#include "machines.h"
#include "pads.h"
#include "peer.h"

static const struct kind {
    const char *name, *element, *law;
    bool inert;
} kinds[] = {{"none", NULL, NULL, false},
             {"short film", "film", "short", false},
             {"finite film", "film", "finite", false},
             {"five fixed pads", "pad_bearing", NULL, false},
             {"five tilting pads", "tilting_pad", NULL, true},
             {"five tilting pads without inertia", "tilting_pad", NULL, false}};

/// The kind of bearing that is measured.
static const struct kind *now;

static void add_bearing(whirl_design *design, const char *station) {
    const bool pads = now->element && !now->law;
    whirl_setting settings[12] = {{"at", 0, station},
                                  {"clearance", PADS_CLEARANCE, 0},
                                  {"viscosity", PADS_VISCOSITY, 0},
                                  {"radius", PADS_RADIUS, 0},
                                  {"length", PADS_LENGTH, 0}};
    size_t count = 5;
    char pivots[160];
    snprintf(pivots, sizeof pivots, "%.17g, %.17g, %.17g, %.17g, %.17g", PADS_FIRST_PIVOT,
             PADS_FIRST_PIVOT + PADS_BETWEEN, PADS_FIRST_PIVOT + 2 * PADS_BETWEEN, PADS_FIRST_PIVOT + 3 * PADS_BETWEEN,
             PADS_FIRST_PIVOT + 4 * PADS_BETWEEN);
    if (now->law) settings[count++] = (whirl_setting){"law", 0, now->law};
    if (pads) {
        settings[count++] = (whirl_setting){"pivots", 0, pivots};
        settings[count++] = (whirl_setting){"arc", PADS_ARC, 0};
        settings[count++] = (whirl_setting){"preload", PADS_PRELOAD, 0};
    }
    if (now->inert) settings[count++] = (whirl_setting){"inertia", PADS_INERTIA, 0};
    if (now->element) must(whirl_design_element(design, now->element, settings, count));
}

static whirl_rotor *rotor_of(size_t stations, int lane, int lanes) {
    const whirl_setting mass = {"mass", PADS_MASS, 0}, gravity = {"acceleration", PADS_GRAVITY, 0};
    whirl_design *design;
    whirl_rotor *rotor;
    (void)lane, (void)lanes;
    must(whirl_design_new(PADS_SPEED, PADS_CLEARANCE, &design));
    for (size_t s = 0; s < stations; s++) {
        char name[24];
        snprintf(name, sizeof name, "s%zu", s);
        must(whirl_design_station(design, name, &mass, 1));
        add_bearing(design, name);
    }
    must(whirl_design_element(design, "gravity", &gravity, 1));
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static void start_of(size_t stations, double *x) {
    for (size_t i = 0; i < stations; i++) x[2 * i + 1] = -0.1;
}

int main(int argc, char **argv) {
    for (now = kinds; now < kinds + sizeof kinds / sizeof *kinds; now++) {
        char name[80];
        const crowd_kind kind = {PADS_JOURNALS, whirl_integrate_default(), rotor_of, start_of};
        crowd *c = crowd_new(&kind, false);
        snprintf(name, sizeof name, "pads: whirl %s, %s", whirl_ensemble_isa(c->ensemble), now->name);
        peer_measure(&(peer){name, c->lanes, crowd_revolve, crowd_x1, c}, peer_seconds(argc, argv));
        crowd_free(c);
    }
    return 0;
}
