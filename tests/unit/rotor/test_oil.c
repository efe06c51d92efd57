// The viscosity of films and dampers, dynamic or kinematic with the density, and doubts about the flow that need the
// density.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/rotor.h"
#include "whirl/engine/system.h"

enum { MAX_SETTINGS = 16, FORCED_BY_OIL_ALONE = 2, OF_OIL = 3, KINDS = 4, STATES = 9 };

/// Elements with a liquid, and what they need beside its keys and those of `add`.
static const struct {
    const char *name;
    whirl_setting more[5];
    size_t count;
} kinds[KINDS] = {{"film", {{0}}, 0},
                  {"squeeze", {{0}}, 0},
                  {"floating_ring",
                   {{"ring", 0.0, "ring"},
                    {"inertia", 4e-4, NULL},
                    {"outer_clearance", 1e-4, NULL},
                    {"outer_radius", 0.06, NULL},
                    {"outer_length", 0.025, NULL}},
                   5},
                  {"seal", {{"law", 0.0, "black"}, {"pressure", 1e6, NULL}}, 2}};

static whirl_design *new_design(double speed) {
    const whirl_setting mass = {.key = "mass", .number = 20.0};
    whirl_design *design;
    assert_int_equal(whirl_design_new(speed, 1e-4, &design).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "journal", &mass, 1).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "ring", &mass, 1).code, WHIRL_OK);
    return design;
}

/// Adds an element with a clearance of 0.1 mm, radius of 50 mm and length of 25 mm, and more settings.
static whirl_status add(whirl_design *design, size_t kind, const whirl_setting *more, size_t count) {
    whirl_setting all[MAX_SETTINGS] = {
        {"at", 0.0, "journal"}, {"clearance", 1e-4, NULL}, {"radius", 0.05, NULL}, {"length", 0.025, NULL}};
    memcpy(all + 4, kinds[kind].more, kinds[kind].count * sizeof *more);
    memcpy(all + 4 + kinds[kind].count, more, count * sizeof *more);
    return whirl_design_element(design, kinds[kind].name, all, 4 + kinds[kind].count + count);
}

static whirl_status build(size_t kind, const whirl_setting *more, size_t count, whirl_rotor **rotor) {
    whirl_design *design = new_design(300.0);
    assert_int_equal(add(design, kind, more, count).code, WHIRL_OK);
    const whirl_status status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

/// Computes the slopes at a place off the middle, in clearances and by tau; the fifth is the journal's acceleration
/// along x.
static void find_slopes(size_t kind, const whirl_setting *more, size_t count, double slopes[STATES]) {
    const double x[STATES] = {0.3, -0.4, 0.1, 0.2, 0.3, -0.6, 0.9, 0.3, 0.5};
    double forcing[WHIRL_MAX_FORCING] = {0.0};
    whirl_rotor *rotor;
    const whirl_status status = build(kind, more, count, &rotor);
    if (status.code != WHIRL_OK) fail_msg("%s: %s", kinds[kind].name, status.message);
    const whirl_system *system = whirl_rotor_system(rotor);
    memset(slopes, 0, STATES * sizeof *slopes);
    assert_true(system->dimension <= STATES);
    system->rhs(system->model, 0.0, forcing, x, slopes);
    assert_true(fabs(slopes[4]) > 1e-3);
    whirl_rotor_free(rotor);
}

/// ISO VG 32 has the viscosities of its data sheet.
static void kinematic_viscosity_times_density_is_the_dynamic_one(void **unused) {
    (void)unused;
    const whirl_setting dynamic[] = {{"viscosity", 32e-6 * 870.0, NULL}, {"density", 870.0, NULL}};
    const whirl_setting kinematic[] = {{"kinematic_viscosity", 32e-6, NULL}, {"density", 870.0, NULL}};
    for (size_t i = 0; i < KINDS; i++) {
        double slopes[2][STATES];
        find_slopes(i, dynamic, 2, slopes[0]);
        find_slopes(i, kinematic, 2, slopes[1]);
        assert_memory_equal(slopes[0], slopes[1], sizeof slopes[0]);
    }
}

/// A floating ring may have another oil outside, of the same density.
static void kinematic_viscosity_around_a_ring(void **unused) {
    (void)unused;
    const whirl_setting dynamic[] = {
        {"viscosity", 0.03, NULL}, {"density", 870.0, NULL}, {"outer_viscosity", 32e-6 * 870.0, NULL}};
    const whirl_setting kinematic[] = {
        {"viscosity", 0.03, NULL}, {"density", 870.0, NULL}, {"outer_kinematic_viscosity", 32e-6, NULL}};
    const whirl_setting both[] = {{"viscosity", 0.03, NULL},
                                  {"density", 870.0, NULL},
                                  {"outer_viscosity", 0.03, NULL},
                                  {"outer_kinematic_viscosity", 32e-6, NULL}};
    double slopes[3][STATES];
    whirl_rotor *rotor;
    find_slopes(OF_OIL - 1, dynamic, 3, slopes[0]);
    find_slopes(OF_OIL - 1, kinematic, 3, slopes[1]);
    find_slopes(OF_OIL - 1, dynamic, 2, slopes[2]);
    assert_memory_equal(slopes[0], slopes[1], sizeof slopes[0]);
    assert_true(slopes[0][6] != slopes[2][6]);
    assert_non_null(strstr(build(OF_OIL - 1, both, 4, &rotor).message, "both outer_viscosity"));
    const whirl_setting alone[] = {both[0], both[3]};
    assert_non_null(strstr(build(OF_OIL - 1, alone, 2, &rotor).message, "without a density"));
}

/// A grade, or the rows of a table, and the temperature: Walther's law through 46 mm2/s at 40 and 6.6 at 100 degC. By
/// D2270's example an oil of 69.48 mm2/s at 40 degC has 8.86 at 100 where its viscosity index is 100.
static void viscosity_follows_from_the_temperature(void **unused) {
    (void)unused;
    const double z40 = log10(log10(46.7)), z100 = log10(log10(7.3)), warm = 343.15;
    const double share = log10(warm / 313.15) / log10(373.15 / 313.15);
    const double own = (pow(10.0, pow(10.0, z40 + share * (z100 - z40))) - 0.7) * 1e-6 * 870.0;
    const whirl_setting density = {"density", 870.0, NULL}, temperature = {"temperature", warm, NULL};
    const struct {
        whirl_setting more[5];
        size_t count;
        double expected, error;
    } rows[] = {
        {{{"grade", 46.0, NULL}, {"kinematic_100", 6.6e-6, NULL}, temperature, density}, 4, own, 1e-12},
        {{{"temperatures", 0.0, "313.15, 373.15"}, {"viscosities", 0.0, "0.04002, 0.005742"}, temperature, density},
         4,
         own,
         1e-12},
        {{{"grade", 46.0, NULL}, {"temperature", 313.15, NULL}, density}, 3, 46e-6 * 870.0, 1e-12},
        {{{"grade", 69.48, NULL}, {"temperature", 373.15, NULL}, density}, 3, 8.86e-6 * 870.0, 2e-3}};
    for (size_t i = 0; i < FORCED_BY_OIL_ALONE; i++)
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
            const whirl_setting dynamic = {"viscosity", rows[k].expected, NULL};
            double slopes[2][STATES];
            find_slopes(i, &dynamic, 1, slopes[0]);
            find_slopes(i, rows[k].more, rows[k].count, slopes[1]);
            assert_true(fabs(slopes[1][4] / slopes[0][4] - 1.0) < rows[k].error);
        }
}

static void one_way_to_give_it_is_asked_for(void **unused) {
    (void)unused;
    static const struct {
        whirl_setting more[4];
        size_t count;
        const char *says;
    } rows[] = {
        {{{"kinematic_viscosity", 32e-6, NULL}}, 1, "without a density"},
        {{{"kinematic_viscosity", 32e-6, NULL}, {"viscosity", 0.03, NULL}, {"density", 870.0, NULL}}, 3, "both"},
        {{{"density", 870.0, NULL}}, 1, "expected"},
        {{{"grade", 46.0, NULL}, {"density", 870.0, NULL}}, 2, "has grade without a temperature"},
        {{{"grade", 46.0, NULL}, {"temperature", 330.0, NULL}}, 2, "has grade without a density"},
        {{{"viscosity", 0.03, NULL}, {"temperature", 330.0, NULL}}, 2, "has a temperature and viscosity"},
        {{{"viscosity", 0.03, NULL}, {"kinematic_100", 6e-6, NULL}}, 2, "without a grade"},
        {{{"viscosity", 0.03, NULL}, {"viscosities", 0.0, "0.03, 0.02"}}, 2, "alone, expected both"},
        {{{"grade", 46.0, NULL}, {"temperature", 330.0, NULL}, {"density", 870.0, NULL}, {"kinematic_100", 5e-5, NULL}},
         4,
         "expected less than at 40 degC, 46"},
        {{{"temperatures", 0.0, "313.15, 373.15"},
          {"viscosities", 0.0, "0.005, 0.04"},
          {"temperature", 330.0, NULL},
          {"density", 870.0, NULL}},
         4,
         "expected one that falls"}};
    for (size_t i = 0; i < OF_OIL; i++)
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
            whirl_rotor *rotor;
            const whirl_status status = build(i, rows[k].more, rows[k].count, &rotor);
            assert_int_equal(status.code, WHIRL_BAD_INPUT);
            if (!strstr(status.message, rows[k].says)) fail_msg("%s: %s", kinds[i].name, status.message);
        }
}

static void note(void *context, size_t element, const char *key, const char *sentence) {
    char *const said = context;
    (void)element;
    snprintf(said, 256, "%s %s", key, sentence);
}

/// Taylor vortices at rho omega R c/mu = 41.2 sqrt(R/c) = 921.3, of a ring by its share of the speed, R_o^3 over the
/// sum of R_o^3 and R_i^3; a damper's inertia at rho omega c^2/mu = 1.
static void flow_beyond_the_law_is_doubted(void **unused) {
    (void)unused;
    const double density = 870.0, viscosity = 0.005, vortices = 921.25 * viscosity / (density * 0.05 * 1e-4);
    const double limits[] = {vortices, viscosity / (density * 1e-8), vortices * (216.0 + 125.0) / 216.0};
    const whirl_setting more[] = {{"viscosity", viscosity, NULL}, {"density", density, NULL}};
    for (size_t i = 0; i < OF_OIL; i++)
        for (int above = 0; above < 2; above++) {
            char said[256] = "";
            whirl_design *design = new_design(limits[i] * (above ? 1.001 : 0.999));
            assert_int_equal(add(design, i, more, 2).code, WHIRL_OK);
            whirl_design_doubts(design, note, said);
            assert_int_equal(strncmp(said, "density is so high", 18) == 0, above);
            if (!above) assert_string_equal(said, "");
            whirl_design_free(design);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kinematic_viscosity_times_density_is_the_dynamic_one),
        cmocka_unit_test(kinematic_viscosity_around_a_ring), cmocka_unit_test(viscosity_follows_from_the_temperature),
        cmocka_unit_test(one_way_to_give_it_is_asked_for), cmocka_unit_test(flow_beyond_the_law_is_doubted)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
