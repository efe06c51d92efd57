// Facts of a rotor's stations: gaps to stators, and clearances of bearings.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "settings.h"
#include "whirl/engine/rotor.h"

static void add_rub(whirl_design *design, const char *station, double gap) {
    const whirl_setting rub[] = {{"at", 0, station}, {"gap", gap, NULL}, {"stiffness", 1e6, NULL}};
    check(whirl_design_element(design, "rub", rub, 3));
}

static void add_film(whirl_design *design, const char *station, double clearance) {
    const whirl_setting film[] = {{"at", 0, station}, {"clearance", clearance, NULL}, {"load", 100, NULL}};
    check(whirl_design_element(design, "film", film, 3));
}

static void near(double found, double expected) {
    if (fabs(found - expected) > 1e-14 * expected) fail_msg("%.17g, expected %.17g", found, expected);
}

/// The narrowest of several stators and bearings counts, in units of the length scale, whatever their order.
static void the_narrowest_counts(void **state) {
    (void)state;
    const char *const names[] = {"free", "disc", "journal"};
    const whirl_setting mass = {"mass", 2, NULL};
    whirl_design *design;
    whirl_rotor *rotor;
    check(whirl_design_new(650, 2e-4, &design));
    for (int i = 0; i < 3; i++) check(whirl_design_station(design, names[i], &mass, 1));
    add_rub(design, "disc", 3e-4);
    add_rub(design, "disc", 2.4e-4);
    add_rub(design, "disc", 5e-4);
    add_film(design, "journal", 4e-4);
    add_film(design, "journal", 1e-4);
    add_rub(design, "journal", 1.8e-4);
    check(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    const whirl_probe *probes = whirl_rotor_system(rotor)->probes;
    assert_true(probes[0].gap == 0.0 && probes[0].clearance == 0.0);
    near(probes[1].gap, 1.2);
    assert_true(probes[1].clearance == 0.0);
    near(probes[2].gap, 0.9);
    near(probes[2].clearance, 0.5);
    whirl_rotor_free(rotor);
}

/// The radius that a probe names is where the normal force begins.
static void the_gap_is_where_contact_begins(void **state) {
    (void)state;
    const whirl_setting mass = {"mass", 2, NULL};
    whirl_design *design;
    whirl_rotor *rotor;
    check(whirl_design_new(650, 2e-4, &design));
    check(whirl_design_station(design, "disc", &mass, 1));
    add_rub(design, "disc", 2.4e-4);
    check(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    const whirl_system *system = whirl_rotor_system(rotor);
    const double gap = system->probes[0].gap;
    for (int i = -1; i <= 1; i += 2) {
        const double r = gap * (1.0 + 1e-9 * i), z[4] = {0.6 * r, -0.8 * r, 0.0, 0.0};
        double force = -1.0;
        system->contacts(system->model, z, &force);
        assert_true(i < 0 ? force == 0.0 : force > 0.0);
    }
    whirl_rotor_free(rotor);
}

/// Stations of shafts of finite elements have positions, others have none.
static void stations_of_shafts_have_positions(void **state) {
    (void)state;
    const whirl_setting mass = {"mass", 2, NULL};
    const whirl_setting ends[] = {{"shaft", 0, "inner"}, {"position", 0.2, NULL}};
    const whirl_setting middle[] = {{"shaft", 0, "outer"}, {"position", 0.25, NULL}};
    const char *const shafts[] = {"outer", "inner"};
    whirl_design *design;
    whirl_rotor *rotor;
    check(whirl_design_new(650, 2e-4, &design));
    for (int i = 0; i < 2; i++) {
        const whirl_setting segment[] = {{"shaft", 0, shafts[i]}, {"length", 0.5, NULL}, {"outer", 0.05, NULL}};
        check(whirl_design_shaft(design, shafts[i], NULL, 0));
        if (i == 0) check(whirl_design_station(design, "foot", &mass, 1));
        check(whirl_design_station(design, i == 0 ? "middle" : "end", i == 0 ? middle : ends, 2));
        check(whirl_design_element(design, "segment", segment, 3));
    }
    check(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    const whirl_probe *probes = whirl_rotor_system(rotor)->probes;
    assert_int_equal(probes[0].shaft, 0);
    assert_int_equal(probes[1].shaft, 1);
    near(probes[1].position, 0.25);
    assert_int_equal(probes[2].shaft, 2);
    near(probes[2].position, 0.2);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_narrowest_counts),
                                       cmocka_unit_test(the_gap_is_where_contact_begins),
                                       cmocka_unit_test(stations_of_shafts_have_positions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
