// Designs refuse impossible machines, each with a sentence that names the value found.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "element.h"
#include "whirl/engine/rotor.h"

static void refused(whirl_status status, const char *words) {
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    if (!strstr(status.message, words)) fail_msg("'%s' does not say '%s'", status.message, words);
}

static whirl_design *design_with_disc(void) {
    whirl_design *design;
    assert_int_equal(whirl_design_new(100, 1e-3, &design).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", 2, NULL}}, 1).code, WHIRL_OK);
    return design;
}

static whirl_status build_nothing(const key_value *values, assembly *to, element *out) {
    (void)values, (void)to, (void)out;
    return whirl_ok();
}

static void test_frame(void **state) {
    whirl_design *design;
    (void)state;
    refused(whirl_design_new(INFINITY, 1, &design), "speed");
    refused(whirl_design_new(NAN, 1, &design), "speed");
    refused(whirl_design_new(1, -1, &design), "length_scale");
    assert_null(design);
}

static void test_stations(void **state) {
    whirl_design *design = design_with_disc();
    (void)state;
    refused(whirl_design_station(design, "disc", (whirl_setting[]){{"mass", 2, NULL}}, 1), "twice");
    refused(whirl_design_station(design, "ground", (whirl_setting[]){{"mass", 2, NULL}}, 1), "ground");
    refused(whirl_design_station(design, "a b", (whirl_setting[]){{"mass", 2, NULL}}, 1), "no name");
    refused(whirl_design_station(design, "", (whirl_setting[]){{"mass", 2, NULL}}, 1), "name");
    refused(whirl_design_station(design, "b", (whirl_setting[]){{"mass", -3, NULL}}, 1), "mass");
    refused(whirl_design_station(design, "b", (whirl_setting[]){{"mass", INFINITY, NULL}}, 1), "mass");
    refused(whirl_design_station(design, "b", (whirl_setting[]){{"mas", 2, NULL}}, 1), "did you mean 'mass'");
    refused(whirl_design_station(design, "b", (whirl_setting[]){{"mass", 2, NULL}, {"mass", 3, NULL}}, 2), "twice");
    refused(whirl_design_station(design, "b", (whirl_setting[]){{"mass", 0, "two"}}, 1), "number");
    whirl_design_free(design);
}

/// A crack or a shaft between two places of one shaft of finite elements would only add to its stiffness: it is
/// refused.
static void test_shaft_parallel_to_segments(void **state) {
    static const char *const elements[] = {"crack", "shaft"};
    (void)state;
    for (int i = 0; i < 4; i++) {
        whirl_design *design = design_with_disc();
        whirl_rotor *rotor;
        const bool crack = i % 2 == 0, apart = i >= 2;
        const whirl_setting own[] = {
            {"between", 0, apart ? "a, disc" : "a, b"}, {crack ? "stiffness" : "k1", 1e6, NULL}, {"loss", 0.2, NULL}};
        for (int k = 0; k < 2; k++)
            assert_int_equal(
                whirl_design_station(design, k ? "b" : "a", (whirl_setting[]){{"position", k, NULL}}, 1).code,
                WHIRL_OK);
        assert_int_equal(
            whirl_design_element(design, "segment", (whirl_setting[]){{"length", 1, NULL}, {"outer", 0.05, NULL}}, 2)
                .code,
            WHIRL_OK);
        assert_int_equal(whirl_design_element(design, elements[i % 2], own, crack ? 3 : 2).code, WHIRL_OK);
        if (apart)
            assert_int_equal(whirl_rotor_new(design, &rotor).code,
                             WHIRL_OK); // from the shaft to a disc that is not on it
        else
            refused(whirl_rotor_new(design, &rotor), "parallel to the segments that join 'a' and 'b'");
        if (apart) whirl_rotor_free(rotor);
        whirl_design_free(design);
    }
}

/// Elements may have mass, so a missing mass is found when the rotor is built.
static void test_inertia(void **state) {
    const whirl_setting tilts_alone[] = {{"polar", 1, NULL}, {"mass", 1, NULL}},
                        along_y[] = {{"mass", 1, NULL}, {"moves", 0, "y"}};
    const whirl_setting wheel[] = {{"at", 0, "b"}, {"outer", 0.2, NULL}, {"width", 0.02, NULL}};
    const whirl_setting rub[] = {{"at", 0, "b"}, {"gap", 1e-3, NULL}, {"stiffness", 1e6, NULL}};
    const whirl_setting beam[] = {{"between", 0, "disc, ground"}, {"length", 1, NULL}, {"bending", 1, NULL}};
    const struct {
        const whirl_setting *station;
        size_t count;
        const char *element;
        const whirl_setting *settings;
        const char *words; ///< NULL: it is sound
    } cases[] = {{NULL, 0, NULL, NULL, "station 'b' has no mass"},
                 {NULL, 0, "disc", wheel, NULL},
                 {tilts_alone, 2, NULL, NULL, "no diametral one"},
                 {along_y, 2, "rub", rub, "moves along x, and 'b' does not"},
                 {along_y, 2, "beam", beam, "'disc' has no diametral inertia"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        whirl_design *design = design_with_disc();
        whirl_rotor *rotor;
        assert_int_equal(whirl_design_station(design, "b", cases[i].station, cases[i].count).code, WHIRL_OK);
        if (cases[i].element)
            assert_int_equal(whirl_design_element(design, cases[i].element, cases[i].settings, 3).code, WHIRL_OK);
        const whirl_status status = whirl_rotor_new(design, &rotor);
        if (cases[i].words)
            refused(status, cases[i].words);
        else
            assert_int_equal(status.code, WHIRL_OK);
        whirl_rotor_free(rotor);
        whirl_design_free(design);
    }
}

static void test_elements(void **state) {
    whirl_design *design = design_with_disc();
    (void)state;
    refused(whirl_design_element(design, "shaf", NULL, 0), "did you mean 'shaft'");
    refused(whirl_design_element(design, "gearbox", NULL, 0), "no element");
    refused(whirl_design_element(design, "shaft", (whirl_setting[]){{"between", 0, "disc, dics"}, {"k1", 1, NULL}}, 2),
            "did you mean 'disc'");
    refused(whirl_design_element(design, "shaft", (whirl_setting[]){{"between", 0, "disc"}, {"k1", 1, NULL}}, 2),
            "two stations");
    refused(
        whirl_design_element(design, "shaft", (whirl_setting[]){{"between", 0, "ground, ground"}, {"k1", 1, NULL}}, 2),
        "ground with ground");
    refused(whirl_design_element(
                design, "shaft",
                (whirl_setting[]){{"between", 0, "disc, ground"}, {"k1", 1, NULL}, {"signs", 0, "papre"}}, 3),
            "derived|paper");
    refused(whirl_design_element(design, "film",
                                 (whirl_setting[]){{"at", 0, "disc"}, {"clearance", 1, NULL}, {"count", 1.5, NULL}}, 3),
            "count");
    refused(whirl_design_element(design, "rub",
                                 (whirl_setting[]){{"at", 0, "ground"}, {"gap", 1, NULL}, {"stiffness", 1, NULL}}, 3),
            "ground");
    whirl_design_free(design);
}

/// A kind of element without mass and force can be added to one design; other designs do not have it.
static void test_own_types(void **state) {
    static const whirl_key keys[] = {STATION_KEY("at", REQUIRED, "where it is of no use")};
    static const element_type idler = {.group = {"idler", "an element that does nothing", "", keys, 1, NULL, NULL},
                                       .build = build_nothing};
    static const element_type impostor = {.group = {"shaft", "not the shaft that is known", "", keys, 1, NULL, NULL},
                                          .build = build_nothing};
    whirl_design *design = design_with_disc(), *other = design_with_disc();
    const whirl_setting at[] = {{"at", 0, "disc"}};
    whirl_rotor *rotor;
    (void)state;
    assert_int_equal(whirl_design_add_type(design, &idler).code, WHIRL_OK);
    refused(whirl_design_add_type(design, &idler), "already");
    refused(whirl_design_add_type(design, &impostor), "'shaft' already");
    assert_int_equal(whirl_design_element(design, "idler", at, 1).code, WHIRL_OK);
    refused(whirl_design_element(design, "idlr", at, 1), "did you mean 'idler'");
    refused(whirl_design_element(design, "idler", NULL, 0), "no at");
    refused(whirl_design_element(other, "idler", at, 1), "no element");
    assert_int_equal(whirl_rotor_new(design, &rotor).code, WHIRL_OK);
    whirl_rotor_free(rotor);
    whirl_design_free(design);
    whirl_design_free(other);
}

/// Kinds with more keys or states than there is room for are refused.
static void test_own_types_too_large(void **state) {
    static const whirl_key keys[65] = {STATION_KEY("at", REQUIRED, "where it is of no use")};
    static const element_kernels idle = {0};
    static const element_kernels *const kernels[VECTOR_ISAS] = {&idle, &idle, &idle, &idle, &idle};
    static const element_type wordy = {.group = {"wordy", "an element of 65 keys", "", keys, 65, NULL, NULL},
                                       .build = build_nothing};
    static const element_type memory = {.group = {"memory", "an element of 2000 states", "", keys, 1, NULL, NULL},
                                        .state_count = 2000,
                                        .kernels = kernels,
                                        .build = build_nothing};
    whirl_design *design = design_with_disc();
    const whirl_setting at[] = {{"at", 0, "disc"}};
    whirl_rotor *rotor;
    (void)state;
    refused(whirl_design_add_type(design, &wordy), "65 keys, expected at most 64");
    assert_int_equal(whirl_design_add_type(design, &memory).code, WHIRL_OK);
    assert_int_equal(whirl_design_element(design, "memory", at, 1).code, WHIRL_OK);
    assert_int_equal(whirl_design_element(design, "memory", at, 1).code, WHIRL_OK);
    refused(whirl_rotor_new(design, &rotor), "4000 states of their own, expected at most 2048");
    whirl_design_free(design);
}

/// Keys that contradict each other are found when the rotor is built.
static void test_contradictions(void **state) {
    const struct {
        const char *kind;
        whirl_setting settings[4];
        size_t count;
        const char *words;
    } cases[] = {
        {"shaft", {{"between", 0, "disc,disc"}, {"k1", 1, NULL}}, 2, "twice"},
        {"film",
         {{"at", 0, "disc"}, {"clearance", 1e-4, NULL}},
         2,
         "neither load nor all of viscosity, radius and length"},
        {"film", {{"at", 0, "disc"}, {"clearance", 1e-4, NULL}, {"load", 1, NULL}, {"radius", 1, NULL}}, 4, "both"},
        {"rub", {{"at", 0, "disc"}, {"gap", 1, NULL}, {"stiffness", 1, NULL}, {"law", 0, "slip"}}, 4, "radius"},
        {"crack", {{"between", 0, "disc,disc"}, {"stiffness", 1, NULL}, {"loss", 0.1, NULL}}, 3, "twice"},
        {"crack",
         {{"between", 0, "disc,ground"}, {"stiffness", 1, NULL}, {"loss", 0.1, NULL}, {"terms", 3, NULL}},
         4,
         "law square"},
        {"seal",
         {{"at", 0, "disc"}, {"clearance", 1, NULL}, {"ratio", 0.5, NULL}, {"from", 0, "disc"}},
         4,
         "between a station and itself"},
        {"looseness",
         {{"between", 0, "disc, ground"}, {"stiffness", 1, NULL}, {"held_damping", 1, NULL}},
         3,
         "expected the gap"},
        {"looseness", {{"between", 0, "disc, disc"}, {"stiffness", 1, NULL}}, 2, "twice"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        whirl_design *design = design_with_disc();
        whirl_rotor *rotor;
        assert_int_equal(whirl_design_element(design, cases[i].kind, cases[i].settings, cases[i].count).code, WHIRL_OK);
        refused(whirl_rotor_new(design, &rotor), cases[i].words);
        assert_null(rotor);
        whirl_design_free(design);
    }
}

static void test_empty_designs_are_refused(void **state) {
    whirl_design *design;
    whirl_rotor *rotor;
    (void)state;
    assert_int_equal(whirl_design_new(1, 1, &design).code, WHIRL_OK);
    refused(whirl_rotor_new(design, &rotor), "no station");
    whirl_design_free(design);
}

/// Every key of every element describes itself: a meaning, a sound range, a default that its own check accepts.
static void test_descriptors_are_sound(void **state) {
    const whirl_group *groups[128] = {whirl_station_keys()};
    size_t count = 1;
    (void)state;
    for (const whirl_group *const *group = whirl_element_groups(); *group && count < 128; group++)
        groups[count++] = *group;
    assert_true(count > 5);
    for (size_t g = 0; g < count; g++) {
        assert_true(strlen(groups[g]->meaning) > 10);
        for (size_t k = 0; k < groups[g]->key_count; k++) {
            const whirl_key *key = &groups[g]->keys[k];
            assert_true(strlen(key->meaning) > 5);
            assert_ptr_equal(whirl_group_key(groups[g], key->name), key);
            assert_false(key->required && key->fallback[0]);
            if (!key->fallback[0]) continue;
            if (key->kind == WHIRL_KEY_CHOICE)
                assert_true(whirl_key_choice(key, key->fallback) >= 0);
            else
                assert_int_equal(whirl_key_check_number(key, atof(key->fallback)).code, WHIRL_OK);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_frame),
        cmocka_unit_test(test_stations),
        cmocka_unit_test(test_inertia),
        cmocka_unit_test(test_shaft_parallel_to_segments),
        cmocka_unit_test(test_elements),
        cmocka_unit_test(test_contradictions),
        cmocka_unit_test(test_own_types),
        cmocka_unit_test(test_own_types_too_large),
        cmocka_unit_test(test_empty_designs_are_refused),
        cmocka_unit_test(test_descriptors_are_sound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
