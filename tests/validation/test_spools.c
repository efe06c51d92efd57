// Shafts with speeds of their own in one machine: engines with two spools, against digits of independent computations.
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
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 4096 };

/// Runs two discs, each on a shaft of its own, with a spring between both. sense: "" or "-" for a second shaft that
/// turns with or against the first. more: further elements, each a line.
static whirl_result *run_spools(const char *sense, const char *run, const char *rotor, const char *more,
                                const char *length) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\n"
             "rotor:\n"
             "  speed: 300 rad/s\n"
             "  length_scale: %s\n"
             "%s"
             "  shafts:\n"
             "    lp: {}\n"
             "    hp: {speed: %s420 rad/s}\n"
             "  stations:\n"
             "    a: {shaft: lp, mass: 10 kg, damping: 150 N.s/m, eccentricity: 0.3 mm, eccentricity_angle: %s20 deg}\n"
             "    b: {shaft: hp, mass: 6 kg, damping: 90 N.s/m}\n"
             "  elements:\n"
             "    - shaft: {between: [a, ground], k1: 4e5 N/m}\n"
             "    - shaft: {between: [b, ground], k1: 3e5 N/m}\n"
             "    - spring: {between: [a, b], stiffness: 2e5 N/m, damping: 40 N.s/m}\n"
             "    - unbalance: {at: b, moment: 1.2e-3 kg.m, angle: %s50 deg}\n"
             "    - drive: {inertia: 0.05 kg.m2, torque: 6 N.m, no_load_speed: 300 rad/s, load_quadratic: 1e-5 "
             "N.m.s2}\n"
             "    - drive: {shaft: hp, inertia: 0.02 kg.m2, torque: 4 N.m, no_load_speed: 450 rad/s, load_linear: 1e-3 "
             "N.m.s}\n"
             "%s"
             "study:\n"
             "  runup: {rtol: 1e-13, rows: 20, %s}\n",
             length, rotor, sense, *rotor ? "-" : "", *rotor ? "" : "-", more, run);
    return result_of_text(text);
}

static const char weight[] = "    - gravity: 9.81 m/s2\n";

/// Digits of a run: turns and speeds of both shafts, and places in mm.
typedef struct spool_digits {
    const char *name, *sense, *run, *more, *turns[2], *speed[2], *place[4];
} spool_digits;

static void check_spools(const spool_digits *known) {
    whirl_result *result = run_spools(known->sense, known->run, "", known->more, "1 mm");
    const double turns[] = {first_number(result, WHIRL_FIELD_RUNUP_END_TURNS, 0, 0),
                            first_number(result, WHIRL_FIELD_RUNUP_SHAFT_END, 0, 1)};
    const double speed[] = {first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                            first_number(result, WHIRL_FIELD_RUNUP_SHAFT_END, 0, 0)};
    for (size_t k = 0; k < 2; k++) {
        check_digits("Spools", words("%s: turns of shaft %zu", known->name, k + 1), known->turns[k], turns[k]);
        check_digits("Spools", words("%s: speed of shaft %zu", known->name, k + 1), known->speed[k], speed[k]);
    }
    for (size_t k = 0; k < 4; k++)
        check_digits("Spools", words("%s: %s%zu", known->name, k % 2 ? "y" : "x", k / 2 + 1), known->place[k],
                     first_number(result, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2));
    whirl_result_free(result);
}

/// The digits are those of SciPy's DOP853 at 1e-13 on equations written for it: a mass matrix of 6 x 6 (four
/// displacements, two angles), solved at every instant.
static void two_spools_against_another_program(void **state) {
    static const char rub[] = "    - gravity: 9.81 m/s2\n"
                              "    - contact: {at: a, from: b, gap: 1 mm, stiffness: 3e6, power: 1, friction: 0.2, "
                              "radius: 60 mm, slip_speed: 0.5 m/s}\n";
    static const spool_digits known[] = {
        {"two drives",
         "",
         "duration: 5 s, shafts: {hp: {speed_from: 0 rpm}}",
         weight,
         {"128.9936982694", "200.704666711"},
         {"237.8757654545", "365.0465150077"},
         {"-.7505947595", "-.804520824", "-.337952591", "-.260813632"}},
        {"two drives against each other",
         "-",
         "duration: 5 s, shafts: {hp: {speed_from: 0 rpm}}",
         weight,
         {"128.9937155397", "200.7184348055"},
         {"237.8686910664", "365.0191525433"},
         {"-.480325923", "-.597101206", "-1.340453943", "-1.030863253"}},
        {"a formula of time and speed",
         "",
         "duration: 5 s, shafts: {hp: {speed_law: \"= 1.3*speed + 20*sin(2*time)\", speed_to: 450 rad/s}}",
         weight,
         {"128.9935366365", "170.6185708729"},
         {"237.8317826622", "298.3008952431"},
         {"-.123880091", "-.999621408", "-1.463652677", ".0008674"}},
        {"a table over the first speed",
         "",
         "duration: 5 s, shafts: {hp: {speed_law: [[0 rad/s, 0 rad/s], [60 rad/s, 180 rad/s], [150 rad/s, 300 rad/s], "
         "[320 rad/s, 440 rad/s]]}}",
         weight,
         {"128.9936891915", "239.4490247"},
         {"237.869197486", "384.18795643"},
         {"-.70819572", "-.59072397", "-.5727455", "-1.07862561"}},
        {"a rate",
         "",
         "duration: 5 s, shafts: {hp: {speed_from: 10 rad/s, rate: 60 rad/s2, speed_to: 400 rad/s}}",
         weight,
         {"128.963037736", "127.3239544735"},
         {"237.8425268159", "310"},
         {"-1.375935662", "-.7627049096", ".3154407062", "-.4106236976"}},
        {"a blade lost by the second shaft",
         "-",
         "duration: 4 s, shafts: {hp: {speed_from: 0 rpm}}, loss_at: b, loss_moment: 8e-4 kg.m, loss_angle: 100 deg, "
         "loss_time: 2 s",
         weight,
         {"92.3188564376", "144.9543275157"},
         {"221.888289331", "346.6935111"},
         {"1.622236065", "-.818946592", ".938575167", "-.693837754"}},
        {"a rub between shafts that turn against each other",
         "-",
         "duration: 1 s, speed_from: 150 rad/s, shafts: {hp: {speed_from: 200 rad/s}}",
         rub,
         {"27.66289373121", "38.65201169871"},
         {"194.00091531555", "279.23649488936"},
         {"-.82127663807", "-1.48666550925", "-.65764361463", "-.4886771808"}},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) check_spools(&known[i]);
}

/// Compares speeds, turns and places of two runs. sign: of y of the other; factor: of its unit of length.
static void check_alike(const char *name, whirl_result *own, whirl_result *other, double sign, double factor,
                        double within) {
    check_within("Spools", words("%s: first speed", name), first_number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 first_number(other, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), within);
    check_within("Spools", words("%s: second speed", name), first_number(own, WHIRL_FIELD_RUNUP_SHAFT_END, 0, 0),
                 first_number(other, WHIRL_FIELD_RUNUP_SHAFT_END, 0, 0), within);
    for (size_t k = 0; k < 4; k++)
        check_within(
            "Spools", words("%s: place %zu", name, k), first_number(own, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2),
            factor * (k % 2 ? sign : 1.0) * first_number(other, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2), within);
    whirl_result_free(own);
    whirl_result_free(other);
}

/// Mirrored rotation of both shafts, another unit of length, and another method change nothing.
static void two_spools_otherwise(void **state) {
    static const char run[] = "duration: 3 s, shafts: {hp: {speed_from: 0 rpm}}";
    (void)state;
    check_alike("mirrored", run_spools("-", run, "", "", "1 mm"),
                run_spools("-", run, "  rotation: clockwise\n", "", "1 mm"), -1.0, 1.0, 1e-9);
    check_alike("length", run_spools("", run, "", weight, "1 mm"), run_spools("", run, "", weight, "20 um"), 1.0, 0.02,
                1e-8);
}

/// Exchanging the names of both shafts changes nothing: the first is then the one with a speed of its own.
static void two_spools_exchanged(void **state) {
    static const char form[] = "whirl: 1\n"
                               "rotor:\n"
                               "  speed: 300 rad/s\n"
                               "  length_scale: 1 mm\n"
                               "  shafts: {lp: {%s}, hp: {%s}}\n"
                               "  stations:\n"
                               "    a: {shaft: lp, mass: 10 kg, damping: 150 N.s/m, diametral: 0.03 kg.m2, polar: 0.05 "
                               "kg.m2}\n"
                               "    b: {shaft: hp, mass: 6 kg, damping: 90 N.s/m, diametral: 0.02 kg.m2, polar: 0.03 "
                               "kg.m2}\n"
                               "  elements:\n"
                               "    - bearing: {at: a, kxx: 4e5 N/m, kyy: 5e5 N/m}\n"
                               "    - bearing: {at: b, kxx: 3e5 N/m, kyy: 3e5 N/m}\n"
                               "    - bearing: {at: a, from: b, kxx: 2e5 N/m, kyy: 2e5 N/m, cxx: 40 N.s/m, cyy: 40 "
                               "N.s/m}\n"
                               "    - spring: {between: [a, ground], stiffness: 500, along: tilts}\n"
                               "    - spring: {between: [b, a], stiffness: 300, along: tilts}\n"
                               "    - unbalance: {at: a, moment: 3e-3 kg.m}\n"
                               "    - unbalance: {at: b, moment: 1.2e-3 kg.m, angle: 1}\n"
                               "    - gravity: 9.81 m/s2\n"
                               "    - drive: {%sinertia: 0.05 kg.m2, torque: 6 N.m, no_load_speed: 300 rad/s}\n"
                               "    - drive: {%sinertia: 0.02 kg.m2, torque: 4 N.m, no_load_speed: 450 rad/s}\n"
                               "study:\n"
                               "  runup: {rtol: 1e-12, duration: 3 s, shafts: {%s: {speed_from: 0 rpm}}}\n";
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text, form, "", "speed: 420 rad/s", "", "shaft: hp, ", "hp");
    whirl_result *own = result_of_text(text);
    snprintf(text, sizeof text, form, "speed: 300 rad/s", "", "shaft: lp, ", "", "lp");
    whirl_result *other = result_of_text(text);
    check_within("Spools", "exchanged: first speed", first_number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                 first_number(other, WHIRL_FIELD_RUNUP_SHAFT_END, 0, 0), 1e-9);
    check_within("Spools", "exchanged: second speed", first_number(own, WHIRL_FIELD_RUNUP_SHAFT_END, 0, 0),
                 first_number(other, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0), 1e-9);
    for (size_t k = 0; k < 4; k++)
        check_within("Spools", words("exchanged: place %zu", k),
                     first_number(own, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2),
                     first_number(other, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2), 1e-8);
    whirl_result_free(own);
    whirl_result_free(other);
}

/// A second shaft of finite elements whose law is a ratio of the first speed moves as one of that fixed ratio, with
/// gyroscopic moments and internal damping, a film to the ground, and a film and a bearing between both shafts.
static void a_law_that_is_a_ratio(void **state) {
    static const char form[] =
        "whirl: 1\n"
        "rotor:\n"
        "  speed: 3000 rpm\n"
        "  length_scale: 0.1 mm\n"
        "  shafts:\n"
        "    lp: {modes: 2}\n"
        "    hp: {%s, modes: 2, viscous_damping: 1e-4 s}\n"
        "  stations:\n"
        "    l1: {shaft: lp, position: 0 m}\n"
        "    l2: {shaft: lp, position: 0.25 m}\n"
        "    l3: {shaft: lp, position: 0.45 m}\n"
        "    l4: {shaft: lp, position: 0.6 m}\n"
        "    h1: {shaft: hp, position: 0 m}\n"
        "    h2: {shaft: hp, position: 0.15 m}\n"
        "    h3: {shaft: hp, position: 0.3 m}\n"
        "  elements:\n"
        "    - segment: {shaft: lp, length: 0.6 m, outer: 30 mm}\n"
        "    - segment: {shaft: hp, length: 0.3 m, outer: 60 mm, inner: 40 mm}\n"
        "    - disc: {at: l2, outer: 300 mm, inner: 30 mm, width: 20 mm, eccentricity: 5 um}\n"
        "    - disc: {at: h2, outer: 250 mm, inner: 60 mm, width: 20 mm}\n"
        "    - unbalance: {at: h2, moment: 3e-5 kg.m, angle: 40 deg}\n"
        "    - bearing: {at: l1, kxx: 2e7 N/m, kyy: 2e7 N/m, cxx: 2000 N.s/m, cyy: 2000 N.s/m}\n"
        "    - film: {at: l4, clearance: 0.1 mm, viscosity: 20 mPa.s, radius: 30 mm, length: 15 mm}\n"
        "    - bearing: {at: h1, kxx: 1e7 N/m, kyy: 1e7 N/m, cxx: 2000 N.s/m, cyy: 2000 N.s/m}\n"
        "    - film: {at: h1, clearance: 0.2 mm, viscosity: 20 mPa.s, radius: 30 mm, length: 15 mm}\n"
        "    - bearing: {at: l3, from: h3, kxx: 8e6 N/m, kyy: 8e6 N/m, cxx: 500 N.s/m, cyy: 500 N.s/m}\n"
        "    - film: {at: l2, from: h1, clearance: 0.3 mm, viscosity: 20 mPa.s, radius: 20 mm, length: 8 mm}\n"
        "    - gravity: 9.81 m/s2\n"
        "study:\n"
        "  runup: {speed_from: 500 rpm, speed_to: 1000 rpm, rate: 1000 rpm/s, rtol: 1e-11, rows: 10, begin: "
        "centre%s}\n";
    static const char *const ways[][2] = {{"ratio: 1.5", "\"= 1.5*speed\""}, {"ratio: -1.3", "\"= 1.3*speed\""}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(ways); i++) {
        char text[SIZE], law[128];
        snprintf(text, sizeof text, form, ways[i][0], "");
        whirl_result *own = result_of_text(text);
        snprintf(law, sizeof law, ", shafts: {hp: {speed_law: %s, speed_to: 1600 rpm}}", ways[i][1]);
        snprintf(text, sizeof text, form, i == 0 ? "speed: 4500 rpm" : "speed: -4500 rpm", law);
        whirl_result *other = result_of_text(text);
        for (size_t station = 0; station < 7; station++)
            for (size_t axis = 0; axis < 2; axis++)
                check_within("Spools", words("a law of %s: station %zu, %zu", ways[i][0], station, axis),
                             first_number(own, WHIRL_FIELD_RUNUP_PLACE, station, axis),
                             first_number(other, WHIRL_FIELD_RUNUP_PLACE, station, axis), 1e-11);
        check_within("Spools", words("a law of %s: error of numbers", ways[i][0]), 0.0,
                     first_number(other, WHIRL_FIELD_RUNUP_ERROR, 0, 0), 1e-15);
        whirl_result_free(own);
        whirl_result_free(other);
    }
}

/// Three shafts, with a film between the second and the third, which turn against each other: their laws are ratios of
/// the first speed, and the machine moves as one of these fixed ratios.
static void three_shafts(void **state) {
    static const char form[] =
        "whirl: 1\n"
        "rotor:\n"
        "  speed: 300 rad/s\n"
        "  length_scale: 1 mm\n"
        "  shafts: {lp: {}, ip: {%s}, hp: {%s}}\n"
        "  stations:\n"
        "    a: {shaft: lp, mass: 10 kg, damping: 150 N.s/m, eccentricity: 0.3 mm}\n"
        "    b: {shaft: ip, mass: 6 kg, damping: 90 N.s/m}\n"
        "    c: {shaft: hp, mass: 6 kg, damping: 90 N.s/m}\n"
        "  elements:\n"
        "    - shaft: {between: [a, ground], k1: 4e5 N/m}\n"
        "    - shaft: {between: [b, ground], k1: 3e5 N/m}\n"
        "    - shaft: {between: [c, ground], k1: 3.5e5 N/m}\n"
        "    - spring: {between: [a, b], stiffness: 2e5 N/m, damping: 40 N.s/m}\n"
        "    - film: {at: b, from: c, clearance: 3 mm, viscosity: 50 mPa.s, radius: 30 mm, length: 15 mm}\n"
        "    - unbalance: {at: b, moment: 1.2e-3 kg.m, angle: -50 deg}\n"
        "    - unbalance: {at: c, moment: 1e-3 kg.m}\n"
        "    - gravity: 9.81 m/s2\n"
        "study:\n"
        "  runup: {speed_from: 30 rad/s, speed_to: 80 rad/s, rate: 25 rad/s2, rtol: 1e-12, rows: 20%s}\n";
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text, form, "ratio: -1.2", "ratio: 1.7", "");
    whirl_result *own = result_of_text(text);
    snprintf(text, sizeof text, form, "speed: -350 rad/s", "speed: 420 rad/s",
             ", shafts: {ip: {speed_law: \"= 1.2*speed\", speed_to: 350 rad/s}, hp: {speed_law: \"= 1.7*speed\", "
             "speed_to: 420 rad/s}}");
    whirl_result *other = result_of_text(text);
    for (size_t k = 0; k < 6; k++)
        check_within("Spools", words("three shafts: place %zu", k),
                     first_number(own, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2),
                     first_number(other, WHIRL_FIELD_RUNUP_PLACE, k / 2, k % 2), 1e-11);
    check_within("Spools", "three shafts: error of numbers", 0.0, first_number(other, WHIRL_FIELD_RUNUP_ERROR, 0, 0),
                 1e-15);
    whirl_result_free(own);
    whirl_result_free(other);
}

/// Elements at station a, which is on the shaft `main`: its own eccentricity, seals of both laws, a stage, and cracks.
/// A black seal's fluid mass depends on the speed.
typedef struct described {
    const char *name, *elements;
    double within;
} described;

static const described described_parts[] = {
    {"eccentricity", "", 1e-9},
    {"seal",
     "    - seal: {at: a, clearance: 5 mm, stiffness: 2e4 N/m, damping: 120 N.s/m, mass: 2 kg, ratio: 0.45, growth: 2, "
     "slowing: 0.4}\n",
     1e-9},
    {"black seal",
     "    - seal: {at: a, law: black, clearance: 2 mm, radius: 60 mm, length: 40 mm, density: 1000 kg/m3, viscosity: 1 "
     "mPa.s, pressure: 0.4 MPa}\n",
     1e-7},
    {"stage", "    - stage: {at: a, power: 2 kW, diameter: 0.4 m, width: 20 mm}\n", 1e-7},
    {"crack", "    - crack: {between: [a, ground], stiffness: 2e5 N/m, loss: 0.5, loss_across: 0.1, angle: 25 deg}\n",
     1e-9},
    {"switching crack",
     "    - crack: {between: [a, ground], stiffness: 2e5 N/m, loss: 0.5, angle: 25 deg, law: square, terms: 5}\n",
     1e-9},
};

/// Runs a machine whose shaft `main` is the rotor's own, follows it by a ratio, or has a speed of its own; another one
/// stands alone. main, run: keys of that shaft and of the run; speed: that of the rotor.
static whirl_result *run_described(const char *rotor, const char *main, const char *speed, const char *elements,
                                   const char *run) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\n"
             "rotor:\n"
             "  speed: %s\n"
             "  length_scale: 1 mm\n"
             "%s"
             "  shafts: {idle: {}, main: {%s}}\n"
             "  stations:\n"
             "    i: {shaft: idle, mass: 5 kg, damping: 90 N.s/m}\n"
             "    a: {shaft: main, mass: 10 kg, damping: 300 N.s/m, eccentricity: 0.1 mm, eccentricity_angle: 40 deg}\n"
             "  elements:\n"
             "    - spring: {between: [i, ground], stiffness: 3e5 N/m}\n"
             "    - spring: {between: [a, ground], stiffness: 4e5 N/m}\n"
             "    - gravity: 9.81 m/s2\n"
             "%s"
             "study:\n"
             "  runup: {rtol: 1e-12, rows: 20, %s}\n",
             speed, rotor, main, elements, run);
    return result_of_text(text);
}

/// Compares places, largest motions and speeds of station a in two runs. field: of the speed of the second run's shaft.
static void check_described(const char *name, whirl_result *own, whirl_result *other, const char *field,
                            double within) {
    for (size_t axis = 0; axis < 2; axis++)
        check_within("Spools", words("%s: %s at the end", name, axis ? "y" : "x"),
                     first_number(own, WHIRL_FIELD_RUNUP_PLACE, 1, axis),
                     first_number(other, WHIRL_FIELD_RUNUP_PLACE, 1, axis), within);
    const double peak = first_number(own, WHIRL_FIELD_RUNUP_PEAK, 1, 0);
    check_holds("Spools", words("%s: it moves", name), peak > 0.02);
    check_within("Spools", words("%s: largest motion", name), peak, first_number(other, WHIRL_FIELD_RUNUP_PEAK, 1, 0),
                 within);
    if (field)
        check_within("Spools", words("%s: speed", name), first_number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0),
                     first_number(other, field, 0, 0), 1e3 * within);
    whirl_result_free(own);
    whirl_result_free(other);
}

/// A seal, a stage, a crack and an eccentricity turn with the shaft of their station: it makes no difference whether
/// that is the rotor's own, one with a speed of its own, or one with a ratio; in both senses of rotation.
static void described_otherwise(void **state) {
    static const char by_rate[] = "speed_from: 60 rad/s, speed_to: 240 rad/s, rate: 200 rad/s2";
    static const char own_rate[] =
        "speed_from: 90 rad/s, speed_to: 100 rad/s, rate: 5 rad/s2, duration: 0.9 s, shafts: "
        "{main: {speed_from: 60 rad/s, speed_to: 240 rad/s, rate: 200 rad/s2}}";
    static const char by_ratio[] = "speed_from: 40 rad/s, speed_to: 160 rad/s, rate: 133.33333333333333 rad/s2";
    (void)state;
    for (size_t i = 0; i < COUNT_OF(described_parts); i++) {
        const described *part = &described_parts[i];
        char name[64];
        snprintf(name, sizeof name, "%s of a second shaft", part->name);
        check_described(name, run_described("", "", "300 rad/s", part->elements, by_rate),
                        run_described("", "speed: 300 rad/s", "100 rad/s", part->elements, own_rate),
                        WHIRL_FIELD_RUNUP_SHAFT_END, part->within);
        snprintf(name, sizeof name, "%s of a second shaft, clockwise", part->name);
        check_described(name, run_described("  rotation: clockwise\n", "", "300 rad/s", part->elements, by_rate),
                        run_described("", "speed: -300 rad/s", "100 rad/s", part->elements, own_rate),
                        WHIRL_FIELD_RUNUP_SHAFT_END, part->within);
        snprintf(name, sizeof name, "%s of a geared shaft", part->name);
        check_described(name, run_described("", "", "300 rad/s", part->elements, by_rate),
                        run_described("", "ratio: 1.5", "200 rad/s", part->elements, by_ratio), NULL, part->within);
        snprintf(name, sizeof name, "%s of a shaft geared against the rotor", part->name);
        check_described(name, run_described("  rotation: clockwise\n", "", "300 rad/s", part->elements, by_rate),
                        run_described("", "ratio: -1.5", "200 rad/s", part->elements, by_ratio), NULL, part->within);
    }
}

/// Likewise under torques, to which the drag of seals and the weight of the eccentricity belong.
static void described_otherwise_with_drives(void **state) {
    static const char drive[] = "    - drive: {%sinertia: 0.4 kg.m2, torque: 90 N.m, no_load_speed: 320 rad/s}\n";
    static const char idle[] = "    - drive: {inertia: 0.1 kg.m2, torque: 1 N.m}\n";
    (void)state;
    for (size_t i = 0; i < COUNT_OF(described_parts); i++)
        for (int back = 0; back < 2; back++) {
            const described *part = &described_parts[i];
            char own[SIZE / 2], other[SIZE / 2], name[64];
            snprintf(own, sizeof own, "%s", part->elements);
            snprintf(own + strlen(own), sizeof own - strlen(own), drive, "");
            snprintf(other, sizeof other, "%s%s", part->elements, idle);
            snprintf(other + strlen(other), sizeof other - strlen(other), drive, "shaft: main, ");
            snprintf(name, sizeof name, "%s with drives%s", part->name, back ? ", clockwise" : "");
            check_described(
                name,
                run_described(back ? "  rotation: clockwise\n" : "", "", "300 rad/s", own,
                              "duration: 0.8 s, speed_from: 60 rad/s"),
                run_described("", back ? "speed: -300 rad/s" : "speed: 300 rad/s", "100 rad/s", other,
                              "duration: 0.8 s, speed_from: 90 rad/s, shafts: {main: {speed_from: 60 rad/s}}"),
                WHIRL_FIELD_RUNUP_SHAFT_END, 10.0 * part->within);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_spools_against_another_program),
        cmocka_unit_test(two_spools_otherwise),
        cmocka_unit_test(two_spools_exchanged),
        cmocka_unit_test(a_law_that_is_a_ratio),
        cmocka_unit_test(three_shafts),
        cmocka_unit_test(described_otherwise),
        cmocka_unit_test(described_otherwise_with_drives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
