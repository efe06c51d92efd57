// The course of a run-up: events of a list, tables and formulas of speed and torque, a ground that moves, against
// closed forms.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"

#include <math.h>
#include <stdio.h>

enum { SIZE = 4096 };

static const double two_pi = 6.283185307179586476925;

/// Returns a number of event `index`, by the columns of the field.
static double happened(const whirl_result *result, size_t index) {
    return first_number(result, WHIRL_FIELD_RUNUP_HAPPENED, 0, 8 * index);
}

/// Runs a disc of 1 kg on a spring, with the elements and the study of a run.
static whirl_result *run_disc(const char *station, const char *elements, const char *study) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\n"
             "parameters: {k: 1, push: 5}\n"
             "rotor:\n"
             "  speed: 1 rad/s\n"
             "  length_scale: 0.1 m\n"
             "  stations:\n"
             "    disc: {mass: 1 kg%s}\n"
             "  elements:\n"
             "    - spring: {between: [disc, ground], stiffness: = k}\n"
             "%s"
             "study:\n"
             "  runup:\n"
             "    rtol: 1e-12\n"
             "    rows: 20\n"
             "    samples: 32\n"
             "%s",
             station, elements, study);
    return result_of_text(text);
}

static void speeds_of_a_table(void **state) {
    (void)state;
    whirl_result *result = run_disc("", "",
                                    "    speeds: [[0 s, 1 rad/s], [10 s, 3 rad/s], [14 s, 3 rad/s], [20 s, 2 rad/s]]\n"
                                    "    events:\n"
                                    "      - {name: up, speed: 2.5 rad/s}\n"
                                    "      - {name: down, speed: 2.5 rad/s, passing: falling}\n"
                                    "      - {name: later, after: up, time: 3 s}\n"
                                    "      - {name: never, speed: 1.5 rad/s, passing: falling}\n");
    check_within("Courses", "table: speed at the end", 2.0, first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 1e-12);
    check_within("Courses", "table: turns", 47.0 / two_pi, first_number(result, WHIRL_FIELD_RUNUP_END_TURNS, 0, 0),
                 1e-10);
    check_within("Courses", "table: time at the end", 20.0, first_number(result, WHIRL_FIELD_RUNUP_END_TIME, 0, 0),
                 1e-10);
    check_within("Courses", "table: passed up", 7.5, happened(result, 0), 1e-10);
    check_within("Courses", "table: passed down", 17.0, happened(result, 1), 1e-10);
    check_within("Courses", "table: three seconds later", 10.5, happened(result, 2), 1e-10);
    assert_true(isnan(happened(result, 3)));
    whirl_result_free(result);
}

static void rate_of_a_formula(void **state) {
    const double t = 25.0, speed = 2.0 + 0.3 * sin(t) + 0.05 * t,
                 angle = 2.0 * t + 0.3 * (1.0 - cos(t)) + 0.025 * t * t;
    (void)state;
    whirl_result *result = run_disc("", "",
                                    "    rate_law: = 0.3*cos(time) + 0.05\n"
                                    "    speed_from: 2 rad/s\n"
                                    "    speed_to: 5 rad/s\n"
                                    "    duration: 25 s\n");
    check_within("Courses", "rate: speed", speed, first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-10);
    check_within("Courses", "rate: turns", angle / two_pi, first_number(result, WHIRL_FIELD_RUNUP_END_TURNS, 0, 0),
                 1e-9);
    whirl_result_free(result);
}

/// 10 w' = 5 t - 2 w, from rest: the torque begins at 0.
static void torque_of_a_formula(void **state) {
    const double t = 30.0, a = 0.2, b = 0.5, speed = b / a * t - b / (a * a) * (1.0 - exp(-a * t));
    (void)state;
    whirl_result *result = run_disc("", "    - drive: {inertia: 10 kg.m2, torque: 1 N.m}\n",
                                    "    torque_law: = push*time\n"
                                    "    load_law: = 2*speed\n"
                                    "    speed_to: 100 rad/s\n"
                                    "    duration: 30 s\n");
    check_within("Courses", "torque: speed", speed, first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-9);
    whirl_result_free(result);
}

/// A formula with the law of the element changes nothing.
static void formulas_are_elements(void **state) {
    static const char *const studies[] = {"    duration: 40 s\n", "    duration: 40 s\n"
                                                                  "    speed_to: 4 rad/s\n"
                                                                  "    torque_law: = 20*(1 - speed/4)\n"
                                                                  "    load_law: = 0.5*speed^2\n"};
    double speed[2], largest[2];
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        whirl_result *result = run_disc(
            ", damping: 0.1 N.s/m, eccentricity: 0.3 m",
            "    - gravity: 2 m/s2\n"
            "    - drive: {inertia: 50 kg.m2, torque: 20 N.m, no_load_speed: 4 rad/s, load_quadratic: 0.5 N.m.s2}\n",
            studies[i]);
        speed[i] = first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0);
        largest[i] = first_number(result, WHIRL_FIELD_RUNUP_PEAK, 0, 0);
        whirl_result_free(result);
    }
    check_within("Courses", "formulas: speed", speed[0], speed[1], 1e-10);
    check_within("Courses", "formulas: largest motion", largest[0], largest[1], 1e-9);
}

/// x'' + .2 x' + x = -.3 sin 2 t from rest, at constant speed; along y nothing moves. In units of .1 m.
static void ground_that_shakes(void **state) {
    const double t = 17.0, c = 0.2, w = 2.0, a = 3.0, d = 1.0 - w * w, size = d * d + c * w * c * w;
    // x = P sin wt + Q cos wt + exp(-c t/2) (A cos vt + B sin vt)
    const double p = -a * d / size, q = a * c * w / size, v = sqrt(1.0 - 0.25 * c * c);
    const double free_cos = -q, free_sin = (-p * w - 0.5 * c * q) / v;
    const double x =
        p * sin(w * t) + q * cos(w * t) + exp(-0.5 * c * t) * (free_cos * cos(v * t) + free_sin * sin(v * t));
    (void)state;
    whirl_result *result = run_disc(", damping: 0.2 N.s/m", "",
                                    "    rate: 1e-14 rad/s2\n"
                                    "    speed_from: 3 rad/s\n"
                                    "    duration: 17 s\n"
                                    "    ground_x: = 0.3*sin(2*time)\n");
    check_within("Courses", "ground: x", x, first_number(result, WHIRL_FIELD_RUNUP_PLACE, 0, 0), 1e-9);
    check_within("Courses", "ground: y", 0.0, first_number(result, WHIRL_FIELD_RUNUP_PLACE, 0, 1), 1e-12);
    whirl_result_free(result);
}

/// The balance of torques at constant speeds ignores the motion of the ground.
static void ground_leaves_stationary_speeds(void **state) {
    static const char *const grounds[] = {"", "    ground_y: = 3*cos(2*time)\n    ground_x: = 2*sin(2*time)\n"};
    double speed[2], fold[2];
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        char study[SIZE / 4];
        snprintf(study, sizeof study, "    duration: 3 s\n%s", grounds[i]);
        whirl_result *result =
            run_disc(", damping: 0.04 N.s/m, eccentricity: 1 m",
                     "    - drive: {inertia: 2000 kg.m2, torque: 20 N.m, no_load_speed: 2 rad/s}\n", study);
        speed[i] = first_number(result, WHIRL_FIELD_RUNUP_STATIONARY, 0, 0);
        fold[i] = first_number(result, WHIRL_FIELD_RUNUP_FOLD, 0, 1);
        whirl_result_free(result);
    }
    check_within("Courses", "ground that shakes: stationary speed", speed[0], speed[1], 0.0);
    check_within("Courses", "ground that shakes: factor of the fold", fold[0], fold[1], 0.0);
}

/// A ground that accelerates upwards at g acts as gravity: on a shaft of elements with discs, and for the torque of
/// unbalances.
static void ground_is_gravity(void **state) {
    static const char machine[] = "whirl: 1\n"
                                  "rotor:\n"
                                  "  speed: 1 rad/s\n"
                                  "  length_scale: 1 mm\n"
                                  "%s"
                                  "  stations:\n"
                                  "    a: {position: 0 m}\n"
                                  "    b: {position: 0.6 m}\n"
                                  "    c: {position: 1 m}\n"
                                  "  elements:\n"
                                  "    - segment: {length: 1 m, outer: 50 mm}\n"
                                  "    - disc: {at: b, outer: 0.4 m, inner: 50 mm, width: 60 mm, eccentricity: 3 mm}\n"
                                  "    - bearing: {at: a, kxx: 2e6 N/m, kyy: 2e6 N/m, cxx: 2e4 N.s/m, cyy: 2e4 N.s/m}\n"
                                  "    - bearing: {at: c, kxx: 2e6 N/m, kyy: 3e6 N/m, cxx: 2e4 N.s/m, cyy: 2e4 N.s/m}\n"
                                  "    - drive: {inertia: 2 kg.m2, torque: 400 N.m, no_load_speed: 300 rad/s}\n"
                                  "%s"
                                  "study:\n"
                                  "  runup: {duration: 0.8 s, rtol: 1e-12, begin: centre, rows: 20, samples: 32%s}\n";
    static const struct {
        const char *rotor, *gravity, *study;
    } runs[] = {{"", "    - gravity: 9.81 m/s2\n", ""},
                {"", "", ", ground_y: = 9.81"},
                {"  rotation: clockwise\n", "    - gravity: 9.81 m/s2\n", ""},
                {"  rotation: clockwise\n", "", ", ground_y: = 9.81"}};
    double speed[4], largest[4], y[4];
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        char text[SIZE];
        snprintf(text, sizeof text, machine, runs[i].rotor, runs[i].gravity, runs[i].study);
        whirl_result *result = result_of_text(text);
        speed[i] = first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0);
        largest[i] = first_number(result, WHIRL_FIELD_RUNUP_PEAK, 1, 0);
        y[i] = first_number(result, WHIRL_FIELD_RUNUP_PLACE, 1, 1);
        whirl_result_free(result);
    }
    for (size_t i = 0; i < 4; i += 2) {
        check_within("Courses", words("gravity %zu: speed", i), speed[i], speed[i + 1], 1e-9);
        check_within("Courses", words("gravity %zu: largest motion", i), largest[i], largest[i + 1], 1e-8);
        check_within("Courses", words("gravity %zu: y", i), y[i], y[i + 1], 1e-8);
    }
}

/// At a constant speed of 3 from the centre x = A (cos 3t - cos t), A = 9 e/(1 - 9): when x first is at .05 m.
static void event_of_a_formula(void **state) {
    double low = 0.5, high = 1.5;
    (void)state;
    for (int i = 0; i < 100; i++) {
        const double t = 0.5 * (low + high), x = -9.0 / 8.0 * 0.05 * (cos(3.0 * t) - cos(t));
        *(x < 0.05 ? &low : &high) = t;
    }
    static const char *const conditions[] = {"= disc_x > 0.05", "= disc_x - 0.05", "= 0.05 <= disc_x"};
    for (size_t i = 0; i < 3; i++) {
        char study[SIZE / 4];
        snprintf(study, sizeof study,
                 "    rate: 1e-14 rad/s2\n    speed_from: 3 rad/s\n    duration: 9 s\n    begin: centre\n"
                 "    events: [{when: \"%s\", end: yes}]\n",
                 conditions[i]);
        whirl_result *result = run_disc(", eccentricity: 0.05 m", "", study);
        check_within("Courses", words("formula %zu: when", i), low, happened(result, 0), 1e-9);
        check_within("Courses", words("formula %zu: the end", i), low,
                     first_number(result, WHIRL_FIELD_RUNUP_END_TIME, 0, 0), 1e-9);
        whirl_result_free(result);
    }
}

/// Gravity of 1 on a spring that is four times as stiff from 5 s to 9 s: the disc rests, then swings.
static void changes_one_after_another(void **state) {
    double x = -1.0, v = 0.0;
    const double lengths[] = {5.0, 4.0, 3.0}, stiffness[] = {1.0, 4.0, 1.0};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        const double w = sqrt(stiffness[i]), rest = -1.0 / stiffness[i], away = x - rest, c = cos(w * lengths[i]),
                     s = sin(w * lengths[i]);
        x = rest + away * c + v / w * s;
        v = v * c - away * w * s;
    }
    static const char *const orders[] = {"      - {name: stiff, time: 5 s, change: {k: 4}}\n"
                                         "      - {after: stiff, time: 4 s, change: {k: 1}}\n",
                                         "      - {time: 9 s, change: {k: 1}}\n"
                                         "      - {time: 5 s, change: {k: 4}}\n"};
    for (size_t i = 0; i < 2; i++) {
        char study[SIZE / 4];
        snprintf(study, sizeof study,
                 "    rate: 1e-14 rad/s2\n    speed_from: 3 rad/s\n    duration: 12 s\n    events:\n%s", orders[i]);
        whirl_result *result = run_disc("", "    - gravity: 1 m/s2\n", study);
        check_within("Courses", words("changes %zu: y", i), 10.0 * x,
                     first_number(result, WHIRL_FIELD_RUNUP_PLACE, 0, 1), 1e-8);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(speeds_of_a_table),
        cmocka_unit_test(rate_of_a_formula),
        cmocka_unit_test(torque_of_a_formula),
        cmocka_unit_test(formulas_are_elements),
        cmocka_unit_test(ground_that_shakes),
        cmocka_unit_test(ground_is_gravity),
        cmocka_unit_test(ground_leaves_stationary_speeds),
        cmocka_unit_test(event_of_a_formula),
        cmocka_unit_test(changes_one_after_another),
    };
    return cmocka_run_group_tests_name("courses of runs", tests, NULL, NULL);
}
