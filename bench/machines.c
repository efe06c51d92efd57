#include "machines.h"

#include <stdio.h>
#include <stdlib.h>

#include "overhung.h"
#include "rotor.h"

void must(whirl_status status) {
    if (status.code == WHIRL_OK) return;
    fprintf(stderr, "bench: %s\n", status.message);
    exit(1);
}

static whirl_rotor *built(whirl_design *design) {
    whirl_rotor *rotor;
    must(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Makes the paper's rotor; with `more` it has another shaft, from disc to ground, without stiffness.
static whirl_rotor *paper_rotor_as(bool journal_first, bool more, double r_k) {
    const double k2 = 1.0 / (rotor_w * rotor_w);
    const whirl_setting disc[] = {
        {"mass", rotor_r_m, 0}, {"damping", rotor_xi1 * rotor_r_m, 0}, {"eccentricity", rotor_rho, 0}};
    const whirl_setting journal[] = {{"mass", 2, 0}, {"damping", rotor_xi2, 0}};
    const whirl_setting shaft[] = {{"between", 0, journal_first ? "journal, disc" : "disc, journal"},
                                   {"k1", r_k * k2, 0},
                                   {"k2", k2, 0},
                                   {"signs", 0, "paper"}};
    const whirl_setting film[] = {{"at", 0, "journal"}, {"count", 2, 0}, {"clearance", 1, 0}, {"load", rotor_S_f, 0}};
    const whirl_setting rub[] = {
        {"at", 0, "disc"}, {"gap", rotor_r_delta, 0}, {"stiffness", rotor_r_ck * k2, 0}, {"friction", rotor_f, 0}};
    const whirl_setting gravity[] = {{"acceleration", rotor_G, 0}};
    whirl_design *design;
    must(whirl_design_new(1.0, 1.0, &design));
    if (journal_first) must(whirl_design_station(design, "journal", journal, 2));
    must(whirl_design_station(design, "disc", disc, 3));
    if (!journal_first) must(whirl_design_station(design, "journal", journal, 2));
    must(whirl_design_element(design, "shaft", shaft, 4));
    must(whirl_design_element(design, "film", film, 4));
    must(whirl_design_element(design, "rub", rub, 4));
    must(whirl_design_element(design, "gravity", gravity, 1));
    if (more)
        must(whirl_design_element(design, "shaft", (whirl_setting[]){{"between", 0, "disc, ground"}, {"k1", 0, 0}}, 2));
    return built(design);
}

whirl_rotor *paper_rotor(double r_k) {
    return paper_rotor_as(false, false, r_k);
}

whirl_rotor *paper_rotor_journal_first(double r_k) {
    return paper_rotor_as(true, false, r_k);
}

whirl_rotor *paper_rotor_listed(double r_k) {
    return paper_rotor_as(false, true, r_k);
}

static void add_film(whirl_design *design, const char *station) {
    const whirl_setting film[] = {{"at", 0, station}, {"clearance", 1, 0}, {"load", 0.5, 0}};
    must(whirl_design_element(design, "film", film, 3));
}

whirl_rotor *chain_rotor(size_t stations, double r_k) {
    enum { NAME = 24 };
    const double k2 = 25.0 * (double)stations;
    char name[NAME], before[NAME], pair[2 * NAME + 2];
    whirl_design *design;
    must(whirl_design_new(1.0, 1.0, &design));
    for (size_t s = 0; s < stations; s++) {
        const whirl_setting disc[] = {
            {"mass", 1, 0}, {"damping", 0.2, 0}, {"eccentricity", s == stations / 2 ? rotor_rho : 0.0, 0}};
        snprintf(name, sizeof name, "s%zu", s);
        must(whirl_design_station(design, name, disc, 3));
        if (s > 0) {
            const whirl_setting shaft[] = {{"between", 0, pair}, {"k1", r_k * k2, 0}, {"k2", k2, 0}};
            snprintf(before, sizeof before, "s%zu", s - 1);
            snprintf(pair, sizeof pair, "%s, %s", before, name);
            must(whirl_design_element(design, "shaft", shaft, 3));
        }
    }
    add_film(design, "s0");
    add_film(design, name);
    snprintf(before, sizeof before, "s%zu", stations / 2);
    const whirl_setting rub[] = {{"at", 0, before}, {"gap", 0.9, 0}, {"stiffness", 250, 0}, {"friction", 0.1, 0}};
    const whirl_setting gravity[] = {{"acceleration", 0.02, 0}};
    must(whirl_design_element(design, "rub", rub, 4));
    must(whirl_design_element(design, "gravity", gravity, 1));
    return built(design);
}

whirl_rotor *films_rotor(const char *law, double length) {
    enum { FILMS = 10 };
    const whirl_setting mass = {"mass", 20, 0}, gravity = {"acceleration", 9.81, 0};
    whirl_design *design;
    must(whirl_design_new(100.0, 1e-4, &design));
    for (size_t s = 0; s < FILMS; s++) {
        char name[24];
        snprintf(name, sizeof name, "s%zu", s);
        const whirl_setting film[] = {{"at", 0, name},        {"law", 0, law},      {"clearance", 1e-4, 0},
                                      {"viscosity", 0.02, 0}, {"radius", 0.025, 0}, {"length", length, 0}};
        must(whirl_design_station(design, name, &mass, 1));
        if (law) must(whirl_design_element(design, "film", film, 6));
    }
    must(whirl_design_element(design, "gravity", &gravity, 1));
    return built(design);
}

/// Makes the shaft of overhung.h with its unbalanced disc and three stations: left, right, disc.
static whirl_design *overhung_shaft(double speed) {
    static const struct piece {
        double length, outer, elements;
    } pieces[] = {{0.1, 0.04, 3}, {0.4, 0.05, 10}, {0.25, 0.045, 7}};
    static const struct place {
        const char *name;
        double position;
    } places[] = {{"left", 0.1}, {"right", 0.5}, {"disc", 0.75}};
    const whirl_setting disc[] = {{"at", 0, "disc"},
                                  {"outer", 0.3, 0},
                                  {"inner", 0.045, 0},
                                  {"width", 0.025, 0},
                                  {"eccentricity", OVERHUNG_ECCENTRICITY, 0}};
    whirl_design *design;
    must(whirl_design_new(speed, OVERHUNG_CLEARANCE, &design));
    must(whirl_design_shaft(design, "main", (whirl_setting[]){{"modes", OVERHUNG_MODES / 2, 0}}, 1));
    for (int i = 0; i < OVERHUNG_PORTS / 2; i++) {
        const whirl_setting position = {"position", places[i].position, 0};
        must(whirl_design_station(design, places[i].name, &position, 1));
    }
    for (int i = 0; i < 3; i++) {
        const whirl_setting segment[] = {
            {"length", pieces[i].length, 0}, {"outer", pieces[i].outer, 0}, {"elements", pieces[i].elements, 0}};
        must(whirl_design_element(design, "segment", segment, 3));
    }
    must(whirl_design_element(design, "disc", disc, 5));
    must(whirl_design_element(design, "gravity", NULL, 0));
    return design;
}

whirl_rotor *overhung_free_rotor(double speed, const char *station, double stiffness) {
    whirl_design *design = overhung_shaft(speed);
    const whirl_setting bearing[] = {{"at", 0, station}, {"kxx", stiffness, 0}, {"kyy", stiffness, 0}};
    if (station) must(whirl_design_element(design, "bearing", bearing, 3));
    return built(design);
}

whirl_rotor *overhung_rotor(double speed) {
    whirl_design *design = overhung_shaft(speed);
    for (int i = 0; i < 2; i++) {
        const whirl_setting film[] = {{"at", 0, i == 0 ? "left" : "right"},
                                      {"clearance", OVERHUNG_CLEARANCE, 0},
                                      {"viscosity", OVERHUNG_VISCOSITY, 0},
                                      {"radius", overhung_radius[i], 0},
                                      {"length", overhung_length[i], 0}};
        must(whirl_design_element(design, "film", film, 5));
    }
    const whirl_setting rub[] = {{"at", 0, "disc"},
                                 {"gap", OVERHUNG_GAP, 0},
                                 {"stiffness", OVERHUNG_STIFFNESS, 0},
                                 {"damping", OVERHUNG_DAMPING, 0},
                                 {"friction", OVERHUNG_FRICTION, 0}};
    must(whirl_design_element(design, "rub", rub, 5));
    return built(design);
}
