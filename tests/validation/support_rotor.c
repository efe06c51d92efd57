#include "support_rotor.h"

#include <complex.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_cases.h"
#include "support_check.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

static whirl_design *start_design(double speed, double length) {
    whirl_design *design;
    require_ok(whirl_design_new(speed, length, &design));
    return design;
}

static whirl_rotor *finish_design(whirl_design *design) {
    whirl_rotor *rotor;
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static void add_gravity(whirl_design *design, double acceleration) {
    const whirl_setting settings[] = {{"acceleration", acceleration, NULL}};
    require_ok(whirl_design_element(design, "gravity", settings, COUNT_OF(settings)));
}

static void add_film(whirl_design *design, double count, double clearance, double load) {
    const whirl_setting settings[] = {
        {"at", 0.0, "journal"}, {"count", count, NULL}, {"clearance", clearance, NULL}, {"load", load, NULL}};
    require_ok(whirl_design_element(design, "film", settings, COUNT_OF(settings)));
}

static void add_shaft(whirl_design *design, const char *between, double k1, double k2, const char *signs) {
    const whirl_setting settings[] = {
        {"between", 0.0, between}, {"k1", k1, NULL}, {"k2", k2, NULL}, {"signs", 0.0, signs}};
    require_ok(whirl_design_element(design, "shaft", settings, COUNT_OF(settings)));
}

whirl_rotor *make_film_rotor(double strength, double weight, double rho) {
    whirl_design *design = start_design(1.0, 1.0);
    const whirl_setting journal[] = {{"mass", 1.0, NULL}, {"eccentricity", rho, NULL}};
    require_ok(whirl_design_station(design, "journal", journal, COUNT_OF(journal)));
    add_film(design, 1.0, 1.0, strength);
    add_gravity(design, weight);
    return finish_design(design);
}

whirl_rotor *make_flexible_film_rotor(double omega, double mj, double k, double load) {
    whirl_design *design = start_design(omega, 1.0);
    const whirl_setting disc[] = {{"mass", 1.0, NULL}};
    const whirl_setting journal[] = {{"mass", mj, NULL}};
    require_ok(whirl_design_station(design, "disc", disc, COUNT_OF(disc)));
    require_ok(whirl_design_station(design, "journal", journal, COUNT_OF(journal)));
    add_shaft(design, "disc, journal", k, k, "derived");
    add_film(design, 1.0, 1.0, load);
    add_gravity(design, 1.0);
    return finish_design(design);
}

whirl_rotor *make_shaft_rotor(const shaft_case *p) {
    whirl_design *design = start_design(p->speed, 1.0);
    const whirl_setting disc[] = {{"mass", 1.0, NULL},
                                  {"damping", p->damping, NULL},
                                  {"eccentricity", p->eccentricity, NULL},
                                  {"eccentricity_angle", p->angle, NULL}};
    require_ok(whirl_design_station(design, "disc", disc, COUNT_OF(disc)));
    add_shaft(design, "disc, ground", p->k1, p->k2, p->printed_signs ? "paper" : "derived");
    add_gravity(design, p->gravity);
    return finish_design(design);
}

whirl_rotor *make_rub_rotor(const rub_case *p) {
    whirl_design *design = start_design(p->speed, 1.0);
    const whirl_setting disc[] = {
        {"mass", 1.0, NULL}, {"damping", 2.0 * p->zeta, NULL}, {"eccentricity", p->eccentricity, NULL}};
    require_ok(whirl_design_station(design, "disc", disc, COUNT_OF(disc)));
    add_shaft(design, "disc, ground", 1.0, 1.0, "derived");
    const whirl_setting rub[] = {{"at", 0.0, "disc"},
                                 {"gap", 1.0, NULL},
                                 {"stiffness", p->kappa, NULL},
                                 {"friction", p->friction, NULL},
                                 {"law", 0.0, p->follows_slip ? "slip" : "paper"},
                                 {"radius", p->surface_radius, NULL},
                                 {"slip_speed", p->slip_speed, NULL}};
    require_ok(whirl_design_element(design, "rub", rub, p->follows_slip ? COUNT_OF(rub) : COUNT_OF(rub) - 2));
    add_gravity(design, p->weight);
    return finish_design(design);
}

whirl_rotor *make_paper_rotor(double r_k) {
    // In the clearance and the mass of one journal; only the ratios below enter.
    const double w = 0.2, r_m = 8.4, k2 = 1.0 / (w * w);
    whirl_design *design = start_design(1.0, 1.0);
    const whirl_setting disc[] = {
        {"mass", r_m, NULL}, {"damping", 0.0157509 * r_m, NULL}, {"eccentricity", 0.08, NULL}};
    const whirl_setting journal[] = {{"mass", 2.0, NULL}, {"damping", 0.286154, NULL}};
    require_ok(whirl_design_station(design, "disc", disc, COUNT_OF(disc)));
    require_ok(whirl_design_station(design, "journal", journal, COUNT_OF(journal)));
    add_shaft(design, "disc, journal", r_k * k2, k2, "paper");
    add_film(design, 2.0, 1.0, 0.0045);
    const whirl_setting rub[] = {{"at", 0.0, "disc"},
                                 {"gap", 1.2, NULL},
                                 {"stiffness", 10.0 * k2, NULL},
                                 {"friction", 0.1, NULL},
                                 {"law", 0.0, "paper"}};
    require_ok(whirl_design_element(design, "rub", rub, COUNT_OF(rub)));
    add_gravity(design, 0.115976);
    return finish_design(design);
}

void start_on_rub_circle(const rub_case *p, double radius, double state[4]) {
    const double complex contact = p->kappa * (1.0 - 1.0 / radius) * (1.0 + I * p->friction);
    const double complex z =
        p->eccentricity * p->speed * p->speed / (1.0 + contact - p->speed * p->speed + 2.0 * I * p->zeta * p->speed);
    state[0] = creal(z);
    state[1] = cimag(z);
    state[2] = -cimag(z);
    state[3] = creal(z);
}

rub_case start_case_c2(size_t row, double state[4]) {
    const rub_case p = {.speed = case_c2[row].speed, .zeta = 0.05, .kappa = 2.0, .eccentricity = 0.2, .friction = 0.1};
    start_on_rub_circle(&p, strtod(case_c2[row].radius, NULL), state);
    return p;
}
