// Torques on each shaft of a machine with several within a turn of a run-up: shafts with speeds of their own, and
// shafts that gears join, with and without twist.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/result.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 4096, SAMPLES = 512, ORBITS = 24, PARTS = 7, MOST = 4 };

/// Columns of torques.
enum { MOTOR, LOAD, FRICTION, ROTOR, DRAG, GEARS, INERTIA };

/// Torques and speeds of the shafts of a run.
typedef struct seen {
    const double *instants, *torques, *speeds, *speed;
} seen;

static seen see(const whirl_result *result) {
    const whirl_table *table = &result->tables[0];
    const seen made = {whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT_INSTANT, 0),
                       whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT_SHAFT_TORQUE, 0),
                       whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT_SHAFT_SPEED, 0),
                       whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT_SPEED, 0)};
    assert_non_null(made.torques);
    assert_non_null(made.speeds);
    return made;
}

/// Returns the torques on a shaft at an instant of an orbit.
static const double *torques_at(const seen *of, size_t shaft, size_t orbit, size_t k) {
    return of->torques + PARTS * ((shaft * ORBITS + orbit) * SAMPLES + k);
}

static double speed_at(const seen *of, size_t shaft, size_t orbit, size_t k) {
    return of->speeds[(shaft * ORBITS + orbit) * SAMPLES + k];
}

/// Returns the derivative of numbers at equal distances of 1, of the order 4.
static double slope_of(const double *at, size_t k) {
    return (8.0 * (at[k + 1] - at[k - 1]) - (at[k + 2] - at[k - 2])) / 12.0;
}

/// Compares at all instants, of which differences next to the kinks of a contact are less exact, the inertia of each
/// shaft times its acceleration, by differences of its speed, with the sum of the torques
/// and with what is reported as such. within: of the largest torque.
static void check_balance(const char *name, const whirl_result *result, size_t shafts, const double *inertia,
                          double within) {
    const seen of = see(result);
    double miss[MOST][2] = {{0.0}}, largest[MOST] = {0.0};
    size_t turns = 0;
    for (size_t orbit = 0; orbit < ORBITS; orbit++) {
        const double *instants = of.instants + orbit * SAMPLES;
        if (isnan(instants[0]) || of.speed[orbit] < 30.0) continue;
        turns++;
        for (size_t shaft = 0; shaft < shafts; shaft++)
            for (size_t k = 2; k + 2 < SAMPLES; k++) {
                const double *own = torques_at(&of, shaft, orbit, k);
                const double rate = slope_of(of.speeds + (shaft * ORBITS + orbit) * SAMPLES, k) / slope_of(instants, k);
                double sum = 0.0;
                for (size_t i = 0; i < INERTIA; i++) {
                    sum += own[i];
                    largest[shaft] = fmax(largest[shaft], fabs(own[i]));
                }
                miss[shaft][0] = fmax(miss[shaft][0], fabs(sum - inertia[shaft] * rate));
                miss[shaft][1] = fmax(miss[shaft][1], fabs(sum - own[INERTIA]));
            }
    }
    check_holds("Shafts of a run", words("%s: turns", name), turns > 4);
    for (size_t shaft = 0; shaft < shafts; shaft++) {
        check_within("Shafts of a run", words("%s: torques on shaft %zu, off inertia times acceleration", name, shaft),
                     0.0, miss[shaft][0] / largest[shaft], within);
        check_within("Shafts of a run", words("%s: torques on shaft %zu, off that reported", name, shaft), 0.0,
                     miss[shaft][1] / largest[shaft], 1e-12);
    }
}

static whirl_result *run(const char *rotor, const char *study) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n%sstudy:\n  runup: {rtol: 1e-12, rows: 20, samples: %d, orbits: %d, %s}\n", rotor,
             SAMPLES, ORBITS, study);
    return result_of_text(text);
}

// ---------------------------------------------------------------- shafts with a speed of their own

static whirl_result *run_spools(const char *sense, const char *law) {
    char rotor[SIZE / 2], study[SIZE / 8];
    snprintf(rotor, sizeof rotor,
             "  speed: 300 rad/s\n"
             "  length_scale: 1 mm\n"
             "  shafts: {lp: {}, hp: {speed: %s420 rad/s}}\n"
             "  stations:\n"
             "    a: {shaft: lp, mass: 10 kg, damping: 150 N.s/m, eccentricity: 0.3 mm}\n"
             "    b: {shaft: hp, mass: 6 kg, damping: 90 N.s/m}\n"
             "  elements:\n"
             "    - shaft: {between: [a, ground], k1: 4e5 N/m}\n"
             "    - shaft: {between: [b, ground], k1: 3e5 N/m}\n"
             "    - spring: {between: [a, b], stiffness: 2e5 N/m, damping: 40 N.s/m}\n"
             "    - unbalance: {at: b, moment: 1.2e-3 kg.m, angle: 50 deg}\n"
             "    - film: {at: a, from: b, clearance: 5 mm, viscosity: 20 mPa.s, radius: 30 mm, length: 15 mm}\n"
             "    - contact: {at: a, from: b, gap: 50 um, stiffness: 3e6, power: 1, friction: 0.2, radius: 60 mm, "
             "slip_speed: 0.5 m/s}\n"
             "    - gravity: 9.81 m/s2\n"
             "    - drive: {inertia: 0.05 kg.m2, torque: 6 N.m, no_load_speed: 300 rad/s, load_quadratic: 1e-5 "
             "N.m.s2}\n"
             "    - drive: {shaft: hp, inertia: 0.02 kg.m2, torque: 4 N.m, no_load_speed: 450 rad/s, load_linear: 1e-3 "
             "N.m.s}\n",
             sense);
    snprintf(study, sizeof study, "duration: 1.2 s, shafts: {hp: {%s}}", law);
    return run(rotor, study);
}

/// Motor and load follow their laws at the speed of each shaft; friction and drag act on both; torques of the first
/// shaft are those of the machine with one shaft.
static void two_spools(void **state) {
    static const double inertia[] = {0.05, 0.02};
    static const char *const senses[] = {"", "-"};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(senses); i++) {
        whirl_result *result = run_spools(senses[i], "speed_from: 0 rpm");
        const seen of = see(result);
        const double *single = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_ORBIT_TORQUE, 0);
        double miss[5] = {0.0}, friction = 0.0;
        check_balance(i == 0 ? "two spools" : "two spools against each other", result, 2, inertia, 5e-3);
        for (size_t orbit = 0; orbit < ORBITS; orbit++)
            for (size_t k = 0; k < SAMPLES && !isnan(of.instants[orbit * SAMPLES]); k++) {
                const double *own[] = {torques_at(&of, 0, orbit, k), torques_at(&of, 1, orbit, k)};
                const double speed = speed_at(&of, 1, orbit, k), *alone = single + 5 * (orbit * SAMPLES + k);
                const double sense = i == 0 ? 1.0 : -1.0;
                miss[0] = fmax(miss[0], fabs(own[1][MOTOR] - 4.0 * (1.0 - speed / 450.0)));
                miss[1] = fmax(miss[1], fabs(own[1][LOAD] + 1e-3 * speed));
                // The same friction acts on both shafts, in opposite senses about one axis.
                miss[2] = fmax(miss[2], fabs(own[0][FRICTION] + sense * own[1][FRICTION]));
                friction = fmax(friction, fabs(own[0][FRICTION]));
                for (size_t part = 0; part < 5; part++)
                    if (part != ROTOR) miss[3] = fmax(miss[3], fabs(own[0][part] - alone[part]));
                miss[4] = fmax(miss[4], fabs(own[0][GEARS]) + fabs(own[1][GEARS]));
            }
        check_holds("Shafts of a run", words("two spools (%s): they rub", senses[i]), friction > 0.1);
        check_within("Shafts of a run", words("two spools (%s): motor", senses[i]), 0.0, miss[0], 1e-6);
        check_within("Shafts of a run", words("two spools (%s): load", senses[i]), 0.0, miss[1], 1e-9);
        check_within("Shafts of a run", words("two spools (%s): friction", senses[i]), 0.0, miss[2], 1e-12);
        check_within("Shafts of a run", words("two spools (%s): the first alone", senses[i]), 0.0, miss[3], 1e-12);
        check_within("Shafts of a run", words("two spools (%s): no gears", senses[i]), 0.0, miss[4], 0.0);
        whirl_figure *figure = NULL;
        require_ok(whirl_figure_new(result, "runup-turn-a@1 s", NULL, &figure));
        size_t panels = 0;
        for (size_t k = 0; k < figure->count; k++) panels += strcmp(figure->panels[k]->name, "shaft-torque") == 0;
        check_within("Shafts of a run", "panels of torques on shafts", 2.0, (double)panels, 0.0);
        whirl_figure_free(figure);
        check_within("Shafts of a run", "shaft of a station", 1.0,
                     first_number(result, WHIRL_FIELD_RUNUP_ORBIT_SHAFT, 1, 0), 0.0);
        whirl_result_free(result);
    }
    // A shaft that follows a law has no torques.
    whirl_result *result = run_spools("", "speed_from: 10 rad/s, rate: 60 rad/s2, speed_to: 400 rad/s");
    const seen of = see(result);
    const size_t orbit = ORBITS - 2;
    check_holds("Shafts of a run", "a law: torques are missing", isnan(torques_at(&of, 1, orbit, 5)[INERTIA]));
    const double time = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_ORBIT_TIME, 0)[orbit];
    check_within("Shafts of a run", "a law: speed of its shaft", 10.0 + 60.0 * time,
                 speed_at(&of, 1, orbit, SAMPLES / 2), 0.1);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- shafts with ratios

/// Two discs on shafts whose speeds have a fixed ratio: the torque of the gears on the second one, times the ratio, is
/// that on the first one, and all other torques together are those of the machine as a whole.
static void fixed_ratio(void **state) {
    static const double ratios[] = {2.5, -1.6};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(ratios); i++) {
        const double ratio = ratios[i], size = fabs(ratio);
        const double inertia[] = {0.3 - 0.02 * ratio * ratio, 0.02};
        char rotor[SIZE / 2];
        snprintf(rotor, sizeof rotor,
                 "  speed: 300 rad/s\n"
                 "  length_scale: 1 mm\n"
                 "  shafts: {slow: {}, fast: {ratio: %g}}\n"
                 "  stations:\n"
                 "    a: {shaft: slow, mass: 10 kg, damping: 150 N.s/m, eccentricity: 0.3 mm}\n"
                 "    b: {shaft: fast, mass: 6 kg, damping: 90 N.s/m, diametral: 0.03 kg.m2, polar: 0.02 kg.m2}\n"
                 "  elements:\n"
                 "    - shaft: {between: [a, ground], k1: 4e5 N/m}\n"
                 "    - shaft: {between: [b, ground], k1: 3e5 N/m}\n"
                 "    - spring: {between: [a, b], stiffness: 2e5 N/m}\n"
                 "    - spring: {between: [b, ground], stiffness: 500, along: tilts}\n"
                 "    - unbalance: {at: b, moment: 1.2e-3 kg.m, angle: 50 deg}\n"
                 "    - film: {at: b, clearance: 9 mm, viscosity: 60 mPa.s, radius: 30 mm, length: 15 mm}\n"
                 "    - gravity: 9.81 m/s2\n"
                 "    - drive: {inertia: 0.3 kg.m2, torque: 30 N.m, no_load_speed: 300 rad/s}\n",
                 ratio);
        whirl_result *result = run(rotor, "duration: 1.2 s");
        const seen of = see(result);
        const double *single = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_ORBIT_TORQUE, 0);
        double miss[3] = {0.0}, gears = 0.0, drag = 0.0;
        check_balance(i == 0 ? "a ratio" : "a ratio below 0", result, 2, inertia, 1e-9);
        for (size_t orbit = 0; orbit < ORBITS; orbit++)
            for (size_t k = 0; k < SAMPLES && !isnan(of.instants[orbit * SAMPLES]); k++) {
                const double *own[] = {torques_at(&of, 0, orbit, k), torques_at(&of, 1, orbit, k)};
                const double *alone = single + 5 * (orbit * SAMPLES + k);
                miss[0] = fmax(miss[0], fabs(own[0][GEARS] + size * own[1][GEARS]));
                miss[1] = fmax(miss[1], fabs(size * own[1][DRAG] - alone[DRAG]));
                miss[2] = fmax(miss[2], fabs(own[0][MOTOR] - alone[MOTOR]));
                gears = fmax(gears, fabs(own[0][GEARS]));
                drag = fmax(drag, fabs(alone[DRAG]));
            }
        check_holds("Shafts of a run", words("ratio %g: torques", ratio), gears > 1.0 && drag > 1e-3);
        check_within("Shafts of a run", words("ratio %g: gears on both shafts", ratio), 0.0, miss[0] / gears, 1e-12);
        check_within("Shafts of a run", words("ratio %g: drag", ratio), 0.0, miss[1] / drag, 1e-12);
        check_within("Shafts of a run", words("ratio %g: motor", ratio), 0.0, miss[2], 1e-12);
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- trains

/// A motor drives a load through a gear, rigid or with a stiffness: the torque of the gear on both shafts has the ratio
/// of their speeds. That of a mesh is the one that is observed; that of a rigid gear is the torque of the coupling on
/// the wheel, less the wheel's own inertia.
static void trains(void **state) {
    static const char *const meshes[] = {"", ", stiffness: 5e7 N/m, damping: 4e4 N.s/m"};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(meshes); i++) {
        static const double inertia[] = {0.12, 0.45};
        char rotor[SIZE / 2];
        snprintf(rotor, sizeof rotor,
                 "  speed: 150 rad/s\n"
                 "  length_scale: 1 mm\n"
                 "  stations:\n"
                 "    motor:  {polar: 0.1 kg.m2, moves: twist}\n"
                 "    pinion: {polar: 0.02 kg.m2, moves: twist}\n"
                 "    wheel:  {polar: 0.15 kg.m2, moves: twist}\n"
                 "    load:   {polar: 0.3 kg.m2, moves: twist}\n"
                 "  elements:\n"
                 "    - coupling: {between: [motor, pinion], twist: 2 kN.m/rad, twist_damping: 2 N.m.s/rad}\n"
                 "    - gear: {between: [pinion, wheel], base_radii: [60 mm, 150 mm]%s}\n"
                 "    - coupling: {between: [wheel, load], twist: 3 kN.m/rad, twist_damping: 3 N.m.s/rad}\n"
                 "    - drive: {at: motor, torque: 60 N.m, no_load_speed: 150 rad/s, load_at: load, load_quadratic: "
                 "0.01 N.m.s2}\n",
                 meshes[i]);
        whirl_result *result = run(rotor, "duration: 0.6 s");
        const seen of = see(result);
        const double *course = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_ORBIT_TORQUE_COURSE, 0);
        double miss[3] = {0.0}, gears = 0.0;
        check_balance(i == 0 ? "rigid gear" : "mesh", result, 2, inertia, 1e-3);
        for (size_t orbit = 0; orbit < ORBITS; orbit++)
            for (size_t k = 0; k < SAMPLES && !isnan(of.instants[orbit * SAMPLES]); k++) {
                const double *own[] = {torques_at(&of, 0, orbit, k), torques_at(&of, 1, orbit, k)};
                const double mesh = course[((size_t)2 * ORBITS + orbit) * SAMPLES + k];
                gears = fmax(gears, fabs(own[0][GEARS]));
                miss[0] = fmax(miss[0], fabs(own[0][GEARS] * 150.0 + own[1][GEARS] * 60.0) / 150.0);
                miss[1] = fmax(miss[1], fabs(own[0][MOTOR] - 60.0 * (1.0 - speed_at(&of, 0, orbit, k) / 150.0)));
                miss[2] = fmax(miss[2], i == 0 ? 0.0 : fabs(own[0][GEARS] + mesh));
            }
        check_holds("Shafts of a run", words("train %zu: torque of the gear", i), gears > 10.0);
        check_within("Shafts of a run", words("train %zu: gears on both shafts", i), 0.0, miss[0] / gears, 1e-10);
        check_within("Shafts of a run", words("train %zu: torque of the mesh", i), 0.0, miss[2] / gears, 1e-10);
        check_within("Shafts of a run", words("train %zu: motor, by the mean speed", i), 0.0, miss[1], 3.0);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_spools), cmocka_unit_test(fixed_ratio),
                                       cmocka_unit_test(trains)};
    return cmocka_run_group_tests_name("shafts of a run", tests, NULL, NULL);
}
