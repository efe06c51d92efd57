// Numbers of a seal that follow from its geometry, and geometries that are refused.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "black.h"
#include "whirl/engine/rotor.h"

#define GEOMETRY                                                                                                       \
    {"radius", 0.05, NULL}, {"length", 0.05, NULL}, {"density", 1000.0, NULL}, {"viscosity", 1e-3, NULL}, {            \
        "pressure", 1e6, NULL                                                                                          \
    }

/// Digits by an independent computation: the mean velocity, and friction by the velocity's own equation rho V^2/2 (1.5
/// + 2 sigma) = 1 MPa.
static void velocity_and_friction(void **unused) {
    (void)unused;
    const black_seal seal = {0.05, 0.05, 2e-4, 1000.0, 1e-3, 1e6, 0.5, 0.5};
    const black_coefficients found = black_find(&seal, 314.159265358979323846);
    const double sigma = 0.5 * (2e3 / (found.velocity * found.velocity) - 1.5);
    assert_true(found.velocity > 18.27389674615 && found.velocity < 18.27389674625);
    assert_true(sigma > 2.244592045655 && sigma < 2.244592045665);
    assert_true(sigma * 2e-4 / 0.05 > 0.008978368182625 && sigma * 2e-4 / 0.05 < 0.008978368182635);
    assert_true(found.ratio == 0.5);
}

static whirl_status build(const whirl_setting *seal, size_t count, whirl_rotor **rotor) {
    const whirl_setting disc[] = {{"mass", 10.0, NULL}};
    whirl_design *design;
    assert_int_equal(whirl_design_new(314.159265358979323846, 1e-4, &design).code, WHIRL_OK);
    assert_int_equal(whirl_design_station(design, "disc", disc, 1).code, WHIRL_OK);
    assert_int_equal(whirl_design_element(design, "seal", seal, count).code, WHIRL_OK);
    const whirl_status status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

static void notes(void **unused) {
    (void)unused;
    const whirl_setting black[] = {{"at", 0, "disc"}, {"law", 0, "black"}, {"clearance", 2e-4, NULL}, GEOMETRY};
    const whirl_setting given[] = {{"at", 0, "disc"}, {"clearance", 2e-4, NULL}, {"ratio", 0.4, NULL}};
    char text[WHIRL_MESSAGE_SIZE];
    whirl_rotor *rotor;
    assert_int_equal(build(black, 8, &rotor).code, WHIRL_OK);
    assert_true(whirl_rotor_note(rotor, 0, text));
    assert_string_equal(
        text, "seal at disc: in the fluid K 3.686e+06 N/m, C 26318 N s/m, M 8.437 kg, which turns at 0.5 "
              "of the shaft's speed: kxx 3.4778e+06 N/m, kxy 4.134e+06 N/m, cxx 26318 N s/m, cxy 2650.7 N s/m");
    assert_false(whirl_rotor_note(rotor, 1, text));
    whirl_rotor_free(rotor);
    assert_int_equal(build(given, 3, &rotor).code, WHIRL_OK);
    assert_false(whirl_rotor_note(rotor, 0, text));
    whirl_rotor_free(rotor);
}

static void refused(void **unused) {
    (void)unused;
    static const struct {
        whirl_setting seal[9];
        const char *words;
    } rows[] = {
        {{{"law", 0, "black"}, GEOMETRY, {"ratio", 0.4, NULL}}, "has law black and ratio, which follows from it"},
        {{{"law", 0, "black"}, {"radius", 0.05, NULL}}, "has no length, expected one with law black"},
        {{{"ratio", 0.4, NULL}, {"pressure", 1e6, NULL}}, "has pressure, which law muszynska does not know"},
        {{{"stiffness", 1e6, NULL}}, "has no ratio, expected one"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        whirl_setting seal[12] = {{"at", 0, "disc"}, {"clearance", 2e-4, NULL}};
        size_t count = 2;
        whirl_rotor *rotor;
        for (const whirl_setting *s = rows[i].seal; s->key; s++) seal[count++] = *s;
        const whirl_status status = build(seal, count, &rotor);
        assert_int_equal(status.code, WHIRL_BAD_INPUT);
        if (!strstr(status.message, rows[i].words)) fail_msg("row %zu: %s", i, status.message);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(velocity_and_friction), cmocka_unit_test(notes),
                                       cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
