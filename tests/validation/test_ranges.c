// Ranges of laws, and the power of friction: motions and equilibria whose numbers are known.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"

/// p of 1 N, Pa: of a ball of 10 mm on a race of 15 mm with a groove of 5.2 mm, by the elliptic integrals themselves.
static const double hertz_of_1_n = 2.25656085e8;

/// Prefix of the name of each comparison.
static char whose[80];

/// Checks agreement to within a relative tolerance.
static void check_relative(const char *what, double obtained, double expected, double tolerance) {
    check_within("RA", words("%s%s", whose, what), expected, obtained, tolerance * fabs(expected));
}

// ---------------------------------------------------------------- friction

/// A rotor moves in a circle of radius r, pressed to its stator all around: T = f N R, P = f N omega (R + r).
static void annular_rub_takes_its_power(void **state) {
    static const char *const stators[] = {"rub: {at: disc, gap: 0.2 mm, stiffness: 2 MN/m, friction: 0.02, law: slip",
                                          "rub: {at: disc, gap: 0.2 mm, stiffness: 2 MN/m, friction: 0.02, damping: 9",
                                          "contact: {at: disc, gap: 0.2 mm, stiffness: 2e6, power: 1, friction: 0.02"};
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    static const char *const rotations[] = {"counter-clockwise", "clockwise"};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        char text[2048];
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 200 rad/s\n  rotation: %s\n  length_scale: 1 mm\n  stations:\n"
                 "    disc: {mass: 10 kg, damping: 600 N.s/m, eccentricity: 0.4 mm}\n  elements:\n"
                 "    - spring: {between: [disc, ground], stiffness: 400 kN/m}\n    - %s, radius: 50 mm}\n"
                 "study:\n  response: {}\n  integrate: {method: %s, steps_per_revolution: 256, transient: 400, "
                 "record: 20}\n  analyze: [orbit, rub]\n",
                 rotations[i % 2], stators[i], methods[i]);
        whirl_result *result = result_of_text(text);
        const whirl_table *table = &result->tables[0];
        const double force = table_number(table, 0, WHIRL_FIELD_RUB_MAX_FORCE, 0);
        snprintf(whose, sizeof whose, "%.*s, %s: ", (int)strcspn(stators[i], ":"), stators[i], methods[i]);
        const double radius = 1e-3 * table_number(table, 0, WHIRL_FIELD_ORBIT_MAX_RADIUS, 0), f = 0.02, R = 0.05;
        check_relative("share of the time in contact", table_number(table, 0, WHIRL_FIELD_RUB_SHARE, 0), 1.0, 1e-9);
        check_relative("normal force", force, 2e6 * (radius - 0.2e-3), 1e-6);
        check_relative("mean torque", table_number(table, 0, WHIRL_FIELD_RUB_TORQUE, 0), f * force * R, 1e-7);
        check_relative("largest torque", table_number(table, 0, WHIRL_FIELD_RUB_MAX_TORQUE, 0), f * force * R, 1e-7);
        check_relative("mean power", table_number(table, 0, WHIRL_FIELD_RUB_POWER, 0), f * force * 200.0 * (R + radius),
                       1e-7);
        assert_true(table_number(table, 0, WHIRL_FIELD_RANGES_LEFT, 0) == 0.0);
        check_relative("depth over radius", table_number(table, 0, WHIRL_FIELD_RANGES_REACHED, 0),
                       (radius - 0.2e-3) / R, 1e-9);
        whirl_result_free(result);
    }
}

/// Blades longer than the gap in the middle of their casing are compressed by the difference.
static void blades_take_their_power(void **state) {
    (void)state;
    whirl_result *result = result_of_text(
        "whirl: 1\nrotor:\n  speed: 300 rad/s\n  length_scale: 1 mm\n  stations:\n    disc: {mass: 10 kg}\n"
        "  elements:\n    - spring: {between: [disc, ground], stiffness: 4 MN/m, damping: 2000 N.s/m}\n"
        "    - blade_rub: {at: disc, blades: 5, radius: 200 mm, gap: 0.5 mm, extension: 0.6 mm, stiffness: 1e6, "
        "friction: 0.2}\nstudy:\n  response: {}\n  integrate: {method: dop853, transient: 3, record: 5}\n"
        "  analyze: [orbit, rub]\n");
    snprintf(whose, sizeof whose, "blades in the middle: ");
    const double torque = 5 * 0.2 * 1e6 * 0.1e-3 * 0.2006;
    check_relative("torque", table_number(&result->tables[0], 0, WHIRL_FIELD_RUB_TORQUE, 0), torque, 1e-9);
    check_relative("power", table_number(&result->tables[0], 0, WHIRL_FIELD_RUB_POWER, 0), torque * 300.0, 1e-9);
    whirl_result_free(result);
}

/// The torque of friction is missing if its radius is not known, and 0 without friction.
static void unknown_friction_is_missing(void **state) {
    (void)state;
    for (int frictions = 0; frictions < 2; frictions++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 200 rad/s\n  length_scale: 1 mm\n  stations:\n"
                 "    disc: {mass: 10 kg, damping: 600 N.s/m, eccentricity: 0.4 mm}\n  elements:\n"
                 "    - spring: {between: [disc, ground], stiffness: 400 kN/m}\n"
                 "    - rub: {at: disc, gap: 0.2 mm, stiffness: 2 MN/m, friction: %g}\nstudy:\n  response: {}\n"
                 "  integrate: {method: rk4, transient: 10, record: 5}\n  analyze: [rub]\n",
                 0.02 * frictions);
        whirl_result *result = result_of_text(text);
        const double *torque = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUB_MAX_TORQUE, 0);
        const double *power = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUB_POWER, 0);
        assert_true(frictions ? isnan(*torque) && isnan(*power) : *torque == 0.0 && *power == 0.0);
        whirl_result_free(result);
    }
}

/// Torques are right in a sweep that begins without friction, and in lanes next to others that touch.
static void friction_is_that_of_every_machine(void **state) {
    static const char *const stators[] = {"rub: {at: disc, gap: 0.2 mm, stiffness: 2 MN/m, friction: = f, radius: 50",
                                          "blade_rub: {at: disc, blades: 4, gap: 0.2 mm, stiffness: 2e6, friction: = f"
                                          ", radius: 50"};
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        char text[2048];
        snprintf(text, sizeof text,
                 "whirl: 1\nparameters: {f: 0.01}\nrotor:\n  speed: 200 rad/s\n  length_scale: 1 mm\n  stations:\n"
                 "    disc: {mass: 10 kg, damping: 600 N.s/m, eccentricity: 0.4 mm}\n"
                 "    free: {mass: 10 kg, damping: 600 N.s/m, eccentricity: = 1e-6+0.04*f}\n  elements:\n"
                 "    - spring: {between: [disc, ground], stiffness: 400 kN/m}\n"
                 "    - spring: {between: [free, ground], stiffness: 400 kN/m}\n"
                 "    - rub: {at: free, gap: 0.2 mm, stiffness: 2 MN/m, friction: 0.02}\n"
                 "    - %s mm}\nstudy:\n  sweep: {parameter: f, from: 0, to: 0.02, points: 8}\n"
                 "  integrate: {method: rk4, transient: 20, record: 5}\n  analyze: [rub]\n",
                 stators[i]);
        whirl_result *result = result_of_text(text);
        const whirl_table *table = &result->tables[0];
        for (size_t point = 0; point < table->count; point++) {
            const double unknown = table_number(table, point, WHIRL_FIELD_RUB_TORQUE, 0);
            const bool touched = table_number(table, point, WHIRL_FIELD_RUB_SHARE, 0) > 0.0;
            assert_true(touched ? isnan(unknown) : unknown == 0.0);
            assert_true((table_number(table, point, WHIRL_FIELD_RUB_TORQUE, 1) > 0.0) == (point > 0));
        }
        assert_true(table_number(table, 0, WHIRL_FIELD_RUB_SHARE, 0) == 0.0);
        assert_true(table_number(table, 7, WHIRL_FIELD_RUB_SHARE, 0) > 0.0);
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- ranges

static void expect_left(const whirl_result *result, size_t table, const char *begin, size_t points, double reached,
                        double tolerance) {
    whirl_left left;
    assert_int_equal(whirl_table_left(&result->tables[table], 0, &left), points);
    assert_true(strncmp(whirl_result_law_range(result, 0), begin, strlen(begin)) == 0);
    check_relative(table ? "eccentricity ratio at rest" : "eccentricity ratio of a motion", left.reached, reached,
                   tolerance);
}

/// A journal under loads to the wall: the very eccentricity of motion and rest.
static void eccentricity_at_the_wall_is_reported(void **state) {
    (void)state;
    whirl_result *result = result_of_text(
        "whirl: 1\nparameters: {load: 10 m/s2}\nrotor:\n  speed: 3000 rpm\n  length_scale: 0.1 mm\n  stations:\n"
        "    journal: {mass: 20 kg, eccentricity: 1 um}\n  elements:\n"
        "    - film: {at: journal, law: finite, clearance: 0.1 mm, viscosity: 18 mPa.s, radius: 25 mm, length: 25 "
        "mm}\n    - gravity: = load\nstudy:\n  sweep: {parameter: load, values: [10, 2000]}\n"
        "  modes: {parameter: load, values: [10, 2000]}\n  integrate: {method: dop853, transient: 30, record: 5}\n"
        "  analyze: [orbit]\n");
    snprintf(whose, sizeof whose, "film: ");
    for (size_t t = 0; t < 2; t++) {
        const whirl_table *table = &result->tables[t];
        assert_true(table_number(table, 0, WHIRL_FIELD_RANGES_LEFT, 0) == 0.0);
        assert_true(table_number(table, 1, WHIRL_FIELD_RANGES_LEFT, 0) == 1.0);
    }
    expect_left(result, 0, "film at journal: eccentricity ratio up to 0.95", 1,
                table_number(&result->tables[0], 1, WHIRL_FIELD_ORBIT_MAX_RADIUS, 0), 1e-15);
    const double *rest = whirl_table_field(&result->tables[1], 1, WHIRL_FIELD_MODES_REST, 0);
    expect_left(result, 1, "film at journal: ", 1, hypot(rest[0], rest[1]), 1e-9);
    whirl_result_free(result);
}

/// The pressure of a ball under the whole load, by Hertz's integrals themselves (to five digits); the fit of the
/// ellipse errs by less than 1 % of the pressure.
static void pressure_of_a_ball_is_reported(void **state) {
    (void)state;
    whirl_result *result = result_of_text(
        "whirl: 1\nrotor:\n  speed: 0.001 rad/s\n  length_scale: 0.1 mm\n  stations:\n    hub: {mass: 1000 kg}\n"
        "  elements:\n    - ball_bearing: {at: hub, balls: 9, stiffness: 1e10, inner: 15 mm, outer: 25 mm, angle: "
        "-90 deg, clearance: -5 um}\n    - gravity: 10 m/s2\nstudy:\n  modes: {}\n");
    const double *rest = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_MODES_REST, 0);
    const double depth = 5e-6 + 1e-4 * hypot(rest[0], rest[1]), load = 1e10 * depth * sqrt(depth);
    snprintf(whose, sizeof whose, "ball: ");
    check_relative("Hertz pressure (Pa)", table_number(&result->tables[0], 0, WHIRL_FIELD_RANGES_REACHED, 0),
                   hertz_of_1_n * cbrt(load), 0.01);
    whirl_result_free(result);
}

/// A disc on a spring k that rests by its weight W on a stator of stiffness K, which carries the part beyond the gap:
/// N = (W - k gap) K / (k + K). A second stator is out of reach.
static void contact_forces_at_rest(void **state) {
    static const char *const studies[] = {"modes", "unbalance", "critical_speeds"};
    (void)state;
    for (size_t s = 0; s < sizeof studies / sizeof *studies; s++) {
        char text[2048];
        snprintf(
            text, sizeof text,
            "whirl: 1\nparameters: {load: 10 m/s2}\nrotor:\n  speed: 200 rad/s\n  length_scale: 0.1 mm\n  stations:\n"
            "    disc: {mass: 10 kg, damping: 600 N.s/m, eccentricity: 1 um}\n  elements:\n"
            "    - spring: {between: [disc, ground], stiffness: 400 kN/m}\n"
            "    - rub: {at: disc, gap: 0.2 mm, stiffness: 2 MN/m, friction: 0}\n"
            "    - rub: {at: disc, gap: 9 mm, stiffness: 2 MN/m, friction: 0}\n"
            "    - gravity: = load\nstudy:\n  %s: {parameter: load, values: [1, 10, 20]}\n"
            "  sweep: {parameter: load, values: [1, 10]}\n"
            "  integrate: {method: dop853, transient: 10, record: 5}\n  analyze: [orbit]\n",
            studies[s]);
        whirl_result *result = result_of_text(text);
        const whirl_table *table = whirl_result_table(result, studies[s]);
        whirl_left held;
        snprintf(whose, sizeof whose, "%s: ", studies[s]);
        assert_int_equal(whirl_table_held(table, 0, &held), 2);
        assert_int_equal(held.first, 1);
        check_relative("force of the contact at rest (N)", result->force_scale * held.reached,
                       (200.0 - 80.0) * 2.0 / 2.4, 1e-9);
        check_relative("force of the contact at rest (N)",
                       result->force_scale * table_number(table, 1, WHIRL_FIELD_RANGES_HELD, 0),
                       (100.0 - 80.0) * 2.0 / 2.4, 1e-9);
        assert_int_equal(whirl_table_held(table, 1, &held), 0);
        assert_int_equal(whirl_table_held(whirl_result_table(result, "sweep"), 0, &held), 0);
        assert_null(whirl_layout_field(&whirl_result_table(result, "sweep")->layout, WHIRL_FIELD_RANGES_HELD));
        whirl_result_free(result);
    }
}

/// Forces of a blade on a disc at rest are means over a revolution, for any initial angle. In the direction of the load
/// the mean force is the weight less the spring's force; no mean exceeds that of the normal force.
static void blade_forces_at_rest_are_means(void **state) {
    double first = 0.0;
    (void)state;
    for (int angle = 0; angle < 360; angle += 90) {
        char text[1024];
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 200 rad/s\n  length_scale: 0.1 mm\n  stations:\n"
                 "    disc: {mass: 10 kg, damping: 600 N.s/m}\n  elements:\n"
                 "    - spring: {between: [disc, ground], stiffness: 400 kN/m}\n"
                 "    - blade_rub: {at: disc, blades: 1, radius: 100 mm, gap: 0.2 mm, stiffness: 2e6, angle: %d deg}\n"
                 "    - gravity: 20 m/s2\nstudy:\n  modes: {}\n",
                 angle);
        whirl_result *result = result_of_text(text);
        const whirl_table *table = &result->tables[0];
        const double force = result->force_scale * table_number(table, 0, WHIRL_FIELD_RANGES_HELD, 0);
        const double *rest = whirl_table_field(table, 0, WHIRL_FIELD_MODES_REST, 0);
        const double left = 200.0 - 4e5 * 1e-4 * hypot(rest[0], rest[1]);
        if (angle == 0) first = force;
        snprintf(whose, sizeof whose, "blade at %d deg: ", angle);
        check_relative("mean force at rest (N)", force, first, 1e-9);
        assert_true(left > 20.0 && force >= left * (1.0 - 1e-9) && force < 1.5 * left);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(annular_rub_takes_its_power),
        cmocka_unit_test(blades_take_their_power),
        cmocka_unit_test(unknown_friction_is_missing),
        cmocka_unit_test(friction_is_that_of_every_machine),
        cmocka_unit_test(eccentricity_at_the_wall_is_reported),
        cmocka_unit_test(pressure_of_a_ball_is_reported),
        cmocka_unit_test(contact_forces_at_rest),
        cmocka_unit_test(blade_forces_at_rest_are_means),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
