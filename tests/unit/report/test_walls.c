// Walls of bearings in drawings of orbits, by the geometry of the bearing itself, against closed forms.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "machine_at.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

static const double pi = 3.14159265358979323846;

/// Stations with a plain film, an elliptical bearing of preload 0.5 and five pads that tilt, of preload 0.3; pads have
/// a clearance of 100 um, the film one of 80 um. Lengths in 100 um.
static const char text[] =
    "whirl: 1\nrotor:\n  speed: 3000 rpm\n  length_scale: 100 um\n"
    "  stations: {plain: {mass: 50 kg}, lemon: {mass: 50 kg}, pads: {mass: 50 kg}}\n  elements:\n"
    "    - film: {at: plain, clearance: 80 um, viscosity: 20 mPa.s, radius: 45 mm, length: 20 mm}\n"
    "    - pad_bearing: {at: lemon, shape: elliptical, preload: 0.5, clearance: 100 um, viscosity: 20 mPa.s, radius: "
    "45 "
    "mm, length: 45 mm}\n"
    "    - tilting_pad: {at: pads, shape: tilting-5, preload: 0.3, clearance: 100 um, viscosity: 20 mPa.s, radius: 45 "
    "mm, length: 45 mm, inertia: 2e-4 kg.m2}\n"
    "study: {response: {}}\n";

static void near(double expected, double obtained) {
    if (fabs(expected - obtained) <= 1e-9) return;
    print_error("%.15g is not %.15g\n", obtained, expected);
    fail();
}

static machine_wall wall_of(size_t station, double clearance) {
    double none = 0.0;
    whirl_case *machine;
    whirl_table table = {.count = 1, .values = &none};
    machine_wall wall;
    assert_int_equal(whirl_case_parse(text, strlen(text), "walls", NULL, &machine).code, WHIRL_OK);
    strcpy(table.name, "response");
    machine_wall_at(machine, &table, 0, station, clearance, &wall);
    whirl_case_free(machine);
    return wall;
}

static void a_film_has_a_circle(void **state) {
    (void)state;
    const machine_wall wall = wall_of(0, 0.8);
    assert_true(wall.round);
    for (size_t k = 0; k < WALL_ANGLES; k++) near(0.8, wall.radius[k]);
}

/// The middle of the journal stays within the clearance of the pads, 1, of the middle of either, which lie 0.5 above
/// and below: r = -0.5 |sin| + sqrt(1 - 0.25 cos^2).
static void a_lemon_has_two_arcs(void **state) {
    (void)state;
    const machine_wall wall = wall_of(1, 0.5);
    assert_false(wall.round);
    for (size_t k = 0; k < WALL_ANGLES; k++) {
        const double angle = 2.0 * pi * (double)k / WALL_ANGLES, c = cos(angle);
        if (fabs(sin(angle)) < 0.1) continue; // grooves: pads end there
        near(sqrt(1.0 - 0.25 * c * c) - 0.5 * fabs(sin(angle)), wall.radius[k]);
    }
}

/// Tilting pads yield: the wall is a pentagon with an inscribed circle of 0.7, whose corners are 0.7/cos 36 degrees
/// away.
static void pads_that_tilt_have_a_polygon(void **state) {
    (void)state;
    const machine_wall wall = wall_of(2, 0.7);
    double least = INFINITY, most = 0.0;
    for (size_t k = 0; k < WALL_ANGLES; k++) {
        least = fmin(least, wall.radius[k]);
        most = fmax(most, wall.radius[k]);
    }
    assert_false(wall.round);
    near(0.7, least);
    near(0.7 / cos(pi / 5.0), most);
    near(wall.radius[WALL_ANGLES - 1], machine_wall_radius(&wall, -2.0 * pi / WALL_ANGLES));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_film_has_a_circle), cmocka_unit_test(a_lemon_has_two_arcs),
                                       cmocka_unit_test(pads_that_tilt_have_a_polygon)};
    return cmocka_run_group_tests_name("walls", tests, NULL, NULL);
}
