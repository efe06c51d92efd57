// The viscosity of films and dampers, dynamic or kinematic with the density, and what the density tells of the flow.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/rotor.h"
#include "whirl/engine/system.h"

enum { MOST = 8 };

static const char *const kinds[] = {"film", "squeeze"};

static whirl_design *new_design(double speed) {
    const whirl_setting mass = {.key = "mass", .number = 20.0};
    whirl_design *design;
    assert_int_equal(whirl_design_new(speed, 1e-4, &design).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "journal", &mass, 1).code, WHIRL_OK);
    return design;
}

/// An element with a clearance of 0.1 mm, radius of 50 mm and length of 25 mm, and more settings.
static whirl_status add(whirl_design *design, const char *kind, const whirl_setting *more, size_t count) {
    whirl_setting all[MOST] = {
        {"at", 0.0, "journal"}, {"clearance", 1e-4, NULL}, {"radius", 0.05, NULL}, {"length", 0.025, NULL}};
    memcpy(all + 4, more, count * sizeof *more);
    return whirl_design_element(design, kind, all, 4 + count);
}

static whirl_status build(const char *kind, const whirl_setting *more, size_t count, whirl_rotor **rotor) {
    whirl_design *design = new_design(300.0);
    assert_int_equal(add(design, kind, more, count).code, WHIRL_OK);
    const whirl_status status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

/// ISO VG 32 as its data sheet has it.
static void kinematic_viscosity_times_density_is_the_dynamic_one(void **unused) {
    (void)unused;
    const whirl_setting dynamic[] = {{"viscosity", 32e-6 * 870.0, NULL}};
    const whirl_setting kinematic[] = {{"kinematic_viscosity", 32e-6, NULL}, {"density", 870.0, NULL}};
    const double x[4] = {3e-5, -4e-5, 1e-2, -2e-2};
    for (size_t i = 0; i < 2; i++) {
        double slopes[2][4];
        whirl_rotor *rotors[2];
        assert_int_equal(build(kinds[i], dynamic, 1, &rotors[0]).code, WHIRL_OK);
        assert_int_equal(build(kinds[i], kinematic, 2, &rotors[1]).code, WHIRL_OK);
        for (size_t k = 0; k < 2; k++) {
            assert_int_equal(whirl_rotor_rates(rotors[k], 0.0, x, slopes[k]).code, WHIRL_OK);
            whirl_rotor_free(rotors[k]);
        }
        assert_true(fabs(slopes[0][2]) > 1.0);
        assert_memory_equal(slopes[0], slopes[1], sizeof slopes[0]);
    }
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
    const double x[4] = {3e-5, -4e-5, 1e-2, -2e-2};
    for (size_t i = 0; i < 2; i++)
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
            const whirl_setting dynamic = {"viscosity", rows[k].expected, NULL};
            double slopes[2][4];
            whirl_rotor *rotors[2];
            assert_int_equal(build(kinds[i], &dynamic, 1, &rotors[0]).code, WHIRL_OK);
            const whirl_status status = build(kinds[i], rows[k].more, rows[k].count, &rotors[1]);
            if (status.code != WHIRL_OK) fail_msg("%s: %s", kinds[i], status.message);
            for (size_t n = 0; n < 2; n++) {
                assert_int_equal(whirl_rotor_rates(rotors[n], 0.0, x, slopes[n]).code, WHIRL_OK);
                whirl_rotor_free(rotors[n]);
            }
            assert_true(fabs(slopes[1][2] / slopes[0][2] - 1.0) < rows[k].error);
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
    for (size_t i = 0; i < 2; i++)
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
            whirl_rotor *rotor;
            const whirl_status status = build(kinds[i], rows[k].more, rows[k].count, &rotor);
            assert_int_equal(status.code, WHIRL_BAD_INPUT);
            if (!strstr(status.message, rows[k].says)) fail_msg("%s: %s", kinds[i], status.message);
        }
}

static void note(void *context, size_t element, const char *key, const char *sentence) {
    char *const said = context;
    (void)element;
    snprintf(said, 256, "%s %s", key, sentence);
}

/// Taylor vortices at rho omega R c/mu = 41.2 sqrt(R/c) = 921.3; a damper's inertia at rho omega c^2/mu = 1.
static void flow_beyond_the_law_is_doubted(void **unused) {
    (void)unused;
    const double density = 870.0, viscosity = 0.005,
                 limits[] = {921.25 * viscosity / (density * 0.05 * 1e-4), viscosity / (density * 1e-8)};
    const whirl_setting more[] = {{"viscosity", viscosity, NULL}, {"density", density, NULL}};
    for (size_t i = 0; i < 2; i++)
        for (int above = 0; above < 2; above++) {
            char said[256] = "";
            whirl_design *design = new_design(limits[i] * (above ? 1.001 : 0.999));
            assert_int_equal(add(design, kinds[i], more, 2).code, WHIRL_OK);
            whirl_design_doubts(design, note, said);
            assert_int_equal(strncmp(said, "density is so high", 18) == 0, above);
            if (!above) assert_string_equal(said, "");
            whirl_design_free(design);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(kinematic_viscosity_times_density_is_the_dynamic_one),
                                       cmocka_unit_test(viscosity_follows_from_the_temperature),
                                       cmocka_unit_test(one_way_to_give_it_is_asked_for),
                                       cmocka_unit_test(flow_beyond_the_law_is_doubted)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
