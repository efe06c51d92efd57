// Parts of a machine (whirl/internal/model.h), compared with cones and sums in closed form.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "whirl/internal/model.h"

#define SETTINGS(...) (whirl_setting[]){__VA_ARGS__}, sizeof(whirl_setting[]){__VA_ARGS__} / sizeof(whirl_setting)

static void must(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

/// Makes a cylinder of two equal segments, a bore, a cone; a wheel in the middle and a mass at the end.
static whirl_design *machine(void) {
    whirl_design *design;
    must(whirl_design_new(100.0, 1e-3, &design));
    must(whirl_design_station(design, "left", SETTINGS({"position", 0.0, 0})));
    must(whirl_design_station(
        design, "disc", SETTINGS({"position", 0.5, 0}, {"mass", 10, 0}, {"polar", 0.2, 0}, {"diametral", 0.1, 0})));
    must(whirl_design_station(design, "end", SETTINGS({"position", 1.5, 0}, {"mass", 3.0, 0})));
    for (int i = 0; i < 2; i++)
        must(whirl_design_element(design, "segment", SETTINGS({"length", 0.25, 0}, {"outer", 0.1, 0})));
    must(whirl_design_element(design, "segment", SETTINGS({"length", 0.5, 0}, {"outer", 0.1, 0}, {"inner", 0.05, 0})));
    must(whirl_design_element(
        design, "segment",
        SETTINGS({"length", 0.5, 0}, {"outer", 0.1, 0}, {"outer_end", 0.05, 0}, {"elements", 1, 0})));
    return design;
}

static void test_sums(void **state) {
    const double pi = 3.14159265358979323846, plain = 7810.0 * pi * 0.0025 * 0.5;
    const double bored = plain - 7810.0 * pi * 0.000625 * 0.5;
    // A cone of radii R and r: pi h (R^2 + R r + r^2)/3, its centre at h (R^2 + 2 R r + 3 r^2)/(4 (R^2 + R r + r^2)).
    const double cone = 7810.0 * pi * 0.5 / 3.0 * (0.0025 + 0.00125 + 0.000625);
    const double at = 1.0 + 0.5 * (0.0025 + 0.0025 + 0.001875) / (4.0 * (0.0025 + 0.00125 + 0.000625));
    const double mass = plain + bored + cone + 13.0;
    whirl_design *design = machine();
    whirl_model model;
    (void)state;
    must(whirl_design_model(design, &model));
    assert_int_equal(model.section_count, 3);
    assert_int_equal(model.station_count, 3);
    assert_int_equal(model.shaft_count, 1);
    assert_true(fabs(model.sections[0].to - 0.5) < 1e-12 && fabs(model.sections[0].mass - plain) < 1e-9);
    assert_true(model.sections[1].inner[0] == 0.05 && fabs(model.sections[1].mass - bored) < 1e-9);
    assert_true(model.sections[2].outer[1] == 0.05 && fabs(model.sections[2].mass - cone) < 1e-9);
    assert_true(model.stations[0].mass == 0.0 && fabs(model.stations[1].mass - 10.0) < 1e-9);
    assert_true(model.stations[1].polar == 0.2 && fabs(model.stations[1].diametral - 0.1) < 1e-9);
    assert_true(fabs(model.stations[2].mass - 3.0) < 1e-9);
    assert_true(fabs(model.shafts[0].mass - mass) < 1e-9);
    const double moment = 0.25 * plain + 0.75 * bored + at * cone + 5.0 + 4.5;
    assert_true(fabs(model.shafts[0].centre - moment / mass) < 1e-12);
    whirl_model_free(&model);
    whirl_model_free(&model);
    whirl_design_free(design);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sums)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
