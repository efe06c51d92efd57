// Shafts that twist while torques change their speed: starts of motors and short circuits against digits of independent
// computations and closed forms, and what must not change them.
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

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 4096 };

static const double pi = 3.14159265358979323846;

/// Returns the damping of the ratio .01 of the mode of two inertias on a spring.
static double damping(double one, double other, double stiffness) {
    return 2.0 * 0.01 * sqrt(stiffness * one * other / (one + other));
}

static whirl_result *start(const char *rotor, const char *study) {
    char text[SIZE];
    snprintf(text, sizeof text, "whirl: 1\nrotor:\n  speed: 150 rad/s\n%sstudy:\n  runup: {%s}\n", rotor, study);
    return result_of_text(text);
}

static double number(const whirl_result *result, const char *field, size_t index) {
    return first_number(result, field, 0, index);
}

/// Returns the largest torque `which` (least: the smallest), and writes its time.
static double extreme(const whirl_result *result, size_t which, bool least, bool when) {
    return number(result, WHIRL_FIELD_RUNUP_TORQUE_EXTREME, 4 * which + 2 * least + when);
}

// ---------------------------------------------------------------- digits

static const char line_motor[] = "induction_motor: {at: motor, voltage: 220 V, frequency: 60 Hz, poles: 4, "
                                 "stator_resistance: 0.435 ohm, stator_reactance: 0.754 ohm, magnetizing_reactance: "
                                 "26.13 ohm, rotor_reactance: 0.754 ohm, rotor_resistance: 0.816 ohm}";

static whirl_result *motor(const char *scale, const char *more, const char *study) {
    char rotor[SIZE];
    snprintf(rotor, sizeof rotor,
             "  length_scale: %s\n%s"
             "  stations:\n"
             "    motor: {polar: 0.089 kg.m2, moves: twist}\n"
             "    load: {polar: 0.4 kg.m2, moves: twist}\n"
             "  elements:\n"
             "    - coupling: {between: [motor, load], twist: 1500 N.m/rad, twist_damping: %.17g N.m.s/rad}\n"
             "    - %s\n"
             "    - drive: {at: load, load_quadratic: %.17g N.m.s2}\n",
             scale, more, damping(0.089, 0.4, 1500.0), line_motor, 11.9 / (180.0 * 180.0));
    return start(rotor, study);
}

/// Krause's motor (220 V, 4 poles, 60 Hz) on a shaft: DOP853 at 1e-13 against extrapolation in 64-bit mantissas. The
/// time of the largest shaft torque is printed as .02056341466; the root of its slope by DOP853 at 2.3e-14 of SciPy is
/// .0205634146464, from an interpolant and from runs that end there alike.
static void motor_is_switched_on(void **state) {
    (void)state;
    whirl_result *result = motor("1 m", "", "duration: 2 s, rtol: 1e-13, rows: 200");
    check_digits("Motor starts", "induction motor: largest torque", "132.2422808977", extreme(result, 0, false, false));
    check_digits("Motor starts", "induction motor: when", ".01049715209", extreme(result, 0, false, true));
    check_digits("Motor starts", "induction motor: least torque", "-23.0369311", extreme(result, 0, true, false));
    check_digits("Motor starts", "induction motor: largest shaft torque", "111.0526004946",
                 extreme(result, 1, false, false));
    check_digits("Motor starts", "induction motor: when", ".0205634146464", extreme(result, 1, false, true));
    const double *speed = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_STATION_SPEED, 0);
    check_digits("Motor starts", "induction motor: its speed at 2 s", "175.6821925", speed[199]);
    whirl_result_free(result);
    char study[128];
    snprintf(study, sizeof study, "duration: 2 s, speed_to: %.17g rad/s, rtol: 1e-13, rows: 20", 54.0 * pi);
    result = motor("1 m", "", study);
    check_digits("Motor starts", "induction motor: at 90 % of 60 pi rad/s", "1.734948786",
                 number(result, WHIRL_FIELD_RUNUP_END_TIME, 0));
    whirl_result_free(result);
}

/// Within a turn the torque of a shaft without damping is its stiffness times its twist, and that of the motor on the
/// shaft as a whole is that of its station. Torques are linear between computed instants.
static void torques_within_a_turn(void **state) {
    enum { SAMPLES = 512, ORBITS = 12 };
    (void)state;
    char rotor[SIZE], study[128];
    snprintf(rotor, sizeof rotor,
             "  length_scale: 1 mm\n"
             "  stations:\n"
             "    motor: {polar: 0.089 kg.m2, moves: twist}\n"
             "    load: {polar: 0.4 kg.m2, moves: twist}\n"
             "  elements:\n"
             "    - coupling: {between: [motor, load], twist: 1500 N.m/rad}\n"
             "    - %s\n"
             "    - drive: {at: load, load_quadratic: %.17g N.m.s2}\n",
             line_motor, 11.9 / (180.0 * 180.0));
    snprintf(study, sizeof study, "duration: 0.8 s, rtol: 1e-10, samples: %d, orbits: %d", SAMPLES, ORBITS);
    whirl_result *result = start(rotor, study);
    const whirl_table *table = &result->tables[0];
    const double *course = whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT_TORQUE_COURSE, 0);
    const double *torque = whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT_TORQUE, 0);
    const double *ends[] = {whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT, 0),
                            whirl_table_field(table, 0, WHIRL_FIELD_RUNUP_ORBIT, 1)};
    double miss[2] = {0.0}, largest = 0.0;
    size_t compared = 0;
    for (size_t k = 0; k < (size_t)ORBITS * SAMPLES; k++) {
        const double twist = 1e-3 * (ends[0][2 * k] - ends[1][2 * k]), shaft = course[(size_t)ORBITS * SAMPLES + k];
        if (isnan(shaft)) continue;
        compared++;
        largest = fmax(largest, fabs(shaft));
        miss[0] = fmax(miss[0], fabs(shaft - 1500.0 * twist));
        miss[1] = fmax(miss[1], fabs(torque[5 * k] - course[k]));
    }
    check_holds("Motor starts", "torques within turns are compared", compared > 5 * SAMPLES && largest > 50.0);
    check_within("Motor starts", "torque of the shaft within a turn, off its twist, N m", 0.0, miss[0], 1e-2);
    check_within("Motor starts", "torque of the motor within a turn, on the shaft and at the station, N m", 0.0,
                 miss[1], 1e-12);
    whirl_result_free(result);
}

/// A motor on a shaft with a million turns behind it starts as one that begins, by time.
static void a_million_turns_behind(void **state) {
    char study[SIZE];
    (void)state;
    snprintf(study, sizeof study, "duration: 1 s, rtol: 1e-12, rows: 20, angle: %.17g rad", 2e6 * 3.14159265358979324);
    whirl_result *own = motor("1 m", "", "duration: 1 s, rtol: 1e-12, rows: 20"), *later = motor("1 m", "", study);
    check_within("Motor starts", "speed after a million turns", number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0),
                 number(later, WHIRL_FIELD_RUNUP_END_SPEED, 0), 1e-8);
    for (size_t which = 0; which < 2; which++)
        check_within("Motor starts", words("largest torque %zu after a million turns", which),
                     extreme(own, which, false, false), extreme(later, which, false, false), 1e-6);
    whirl_result_free(own);
    whirl_result_free(later);
}

/// J 120, 260; two pairs of poles at 50 Hz, mean 4000, pulsating 2500: DOP853 at 1e-12, and in remarks to it.
static void synchronous_motor_starts(void **state) {
    char rotor[SIZE], study[128];
    (void)state;
    snprintf(rotor, sizeof rotor,
             "  length_scale: 1 m\n"
             "  stations:\n"
             "    motor: {polar: 120 kg.m2, moves: twist}\n"
             "    load: {polar: 260 kg.m2, moves: twist}\n"
             "  elements:\n"
             "    - coupling: {between: [motor, load], twist: 1.1e6 N.m/rad, twist_damping: %.17g N.m.s/rad}\n"
             "    - synchronous_start: {at: motor, frequency: 50 Hz, poles: 4, mean: 4000 N.m, pulsating: 2500 N.m}\n",
             damping(120.0, 260.0, 1.1e6));
    snprintf(study, sizeof study, "duration: 20 s, speed_to: %.17g rad/s, rtol: 1e-12, rows: 40", 0.97 * 50.0 * pi);
    whirl_result *result = start(rotor, study);
    check_digits("Motor starts", "synchronous start: largest shaft torque", "36072.421665",
                 extreme(result, 1, false, false));
    check_digits("Motor starts", "synchronous start: when", "12.437877797", extreme(result, 1, false, true));
    check_digits("Motor starts", "synchronous start: at 97 % of its speed", "14.47085694",
                 number(result, WHIRL_FIELD_RUNUP_END_TIME, 0));
    whirl_result_free(result);
}

/// Closed form by complex exponentials, DOP853; it happens at an instant of the run.
static void terminals_are_short_circuited(void **state) {
    static const double times[] = {0.0, 0.137};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(times); i++) {
        char rotor[SIZE];
        snprintf(rotor, sizeof rotor,
                 "  length_scale: 1 m\n"
                 "  stations:\n"
                 "    one: {polar: 211.4 kg.m2, moves: twist}\n"
                 "    two: {polar: 35 kg.m2, moves: twist}\n"
                 "  elements:\n"
                 "    - coupling: {between: [one, two], twist: 9.775e5 N.m/rad, twist_damping: %.17g N.m.s/rad}\n"
                 "    - short_circuit: {at: one, torque: 1.2e4 N.m, frequency: 50 Hz, first: 7.5, second: -3.8, decay: "
                 "80 ms, time: %g s}\n",
                 damping(211.4, 35.0, 9.775e5), times[i]);
        whirl_result *result =
            start(rotor, "duration: 0.5 s, speed_from: 314 rad/s, speed_to: 400 rad/s, rtol: 3e-14, rows: 20");
        check_digits("Motor starts", words("short circuit at %g s: largest shaft torque", times[i]), "13119.280271408",
                     -extreme(result, 1, true, false));
        check_digits("Motor starts", words("short circuit at %g s: when", times[i]), ".025869411",
                     extreme(result, 1, true, true) - times[i]);
        whirl_result_free(result);
    }
}

/// A constant torque T on one of two inertias: the shaft carries T J2/(J1 + J2) (1 - cos w t).
static void torque_is_put_on(void **state) {
    (void)state;
    const double one = 0.3, other = 0.5, stiffness = 2000.0, torque = 40.0;
    const double frequency = sqrt(stiffness * (one + other) / (one * other));
    whirl_result *result = start("  length_scale: 1 mm\n"
                                 "  stations:\n"
                                 "    one: {polar: 0.3 kg.m2, moves: twist}\n"
                                 "    two: {polar: 0.5 kg.m2, moves: twist}\n"
                                 "  elements:\n"
                                 "    - coupling: {between: [one, two], twist: 2000 N.m/rad}\n"
                                 "    - drive: {at: one, torque: 40 N.m}\n",
                                 "duration: 0.05 s, speed_to: 100 rad/s, rtol: 1e-13, rows: 10");
    check_within("Motor starts", "a torque is put on: largest shaft torque", 2.0 * torque * other / (one + other),
                 extreme(result, 0, false, false), 1e-10);
    check_within("Motor starts", "a torque is put on: when", pi / frequency, extreme(result, 0, false, true), 1e-10);
    // The first swing, from 0 to its top, is half a cycle of the largest range.
    const double *cycles = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_CYCLES, 0);
    assert_non_null(cycles);
    check_within("Motor starts", "a torque is put on: range of its cycles", 2.0 * torque * other / (one + other),
                 cycles[2 * 31], 1e-3);
    check_within("Motor starts", "a torque is put on: cycles", 0.5, cycles[2 * 31 + 1], 0.0);
    check_within("Motor starts", "a torque is put on: speed at the end", torque * 0.05 / (one + other),
                 number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0), 1e-11);
    whirl_result_free(result);
}

/// The motor trips and half of the second inertia leaves at one instant: angles and speeds of both stations stay, and
/// the rest swings freely. By the speed instead of the time, too.
static void inertia_leaves(void **state) {
    static const char *const when[] = {"trip_time: 0.01 s, change_time: 0.01 s",
                                       "trip_speed: %.17g rad/s, change_speed: %.17g rad/s"};
    const double one = 0.3, other = 0.5, less = 0.2, stiffness = 2000.0, torque = 40.0, t = 0.01;
    const double frequency = sqrt(stiffness * (one + other) / (one * other));
    const double bend = torque * other / (one + other) / stiffness * (1.0 - cos(frequency * t));
    const double rate = torque * other / (one + other) / stiffness * frequency * sin(frequency * t);
    const double mean = torque * t / (one + other);
    const double speeds[] = {mean + other / (one + other) * rate, mean - one / (one + other) * rate};
    const double later = sqrt(stiffness * (one + less) / (one * less));
    (void)state;
    for (size_t i = 0; i < COUNT_OF(when); i++) {
        char study[SIZE / 4], instant[SIZE / 8], rotor[SIZE];
        snprintf(instant, sizeof instant, when[i], speeds[0], speeds[0]);
        snprintf(study, sizeof study,
                 "duration: 0.08 s, speed_to: 100 rad/s, rtol: 1e-13, rows: 10, change: {J: 0.2 kg.m2}, %s", instant);
        snprintf(rotor, sizeof rotor,
                 "  length_scale: 1 mm\n"
                 "  stations:\n"
                 "    one: {polar: 0.3 kg.m2, moves: twist}\n"
                 "    two: {polar: = J, moves: twist}\n"
                 "  elements:\n"
                 "    - coupling: {between: [one, two], twist: 2000 N.m/rad}\n"
                 "    - drive: {at: one, torque: 40 N.m}\n"
                 "parameters: {J: 0.5 kg.m2}\n");
        whirl_result *result = start(rotor, study);
        check_within("Motor starts", words("inertia leaves, %zu: speed at the end", i),
                     (one * speeds[0] + less * speeds[1]) / (one + less),
                     number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0), 1e-9);
        check_within("Motor starts", words("inertia leaves, %zu: largest shaft torque", i),
                     stiffness * hypot(bend, rate / later), extreme(result, 0, false, false), 1e-8);
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- what changes nothing

static void motor_otherwise(void **state) {
    static const struct {
        const char *name, *scale, *more, *study;
    } other[] = {{"clockwise", "1 m", "  rotation: clockwise\n", ""},
                 {"length scale 0.3 mm", "0.3 mm", "", ""},
                 {"16 samples", "1 m", "", ", samples: 16"},
                 {"rodas5p", "1 m", "", ", method: rodas5p"}};
    (void)state;
    whirl_result *own = motor("1 m", "", "duration: 0.3 s, rtol: 1e-10, rows: 20");
    for (size_t i = 0; i < COUNT_OF(other); i++) {
        char study[128];
        snprintf(study, sizeof study, "duration: 0.3 s, rtol: 1e-10, rows: 20%s", other[i].study);
        whirl_result *same = motor(other[i].scale, other[i].more, study);
        for (size_t k = 0; k < 8; k++)
            check_within("Motor starts", words("motor, %s: extreme %zu", other[i].name, k),
                         number(own, WHIRL_FIELD_RUNUP_TORQUE_EXTREME, k),
                         number(same, WHIRL_FIELD_RUNUP_TORQUE_EXTREME, k), 2e-6);
        check_within("Motor starts", words("motor, %s: speed at the end", other[i].name),
                     number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0), number(same, WHIRL_FIELD_RUNUP_END_SPEED, 0), 1e-7);
        whirl_result_free(same);
    }
    whirl_result_free(own);
}

/// A motor whose torque begins at 0 starts against dry friction; one that is too weak does not. Lists of one number are
/// read as numbers.
static void loads_yield_at_standstill(void **state) {
    static const char machine[] = "  length_scale: 1 m\n"
                                  "  stations:\n"
                                  "    motor: {polar: 0.2 kg.m2, moves: twist}\n"
                                  "    load: {polar: 0.3 kg.m2, moves: twist}\n"
                                  "  elements:\n"
                                  "    - coupling: {between: [motor, load], twist: 1500 N.m/rad}\n"
                                  "    - %s\n"
                                  "    - drive: {at: load, load: %g N.m}\n";
    static const char *const means[] = {"40 N.m", "[40 N.m]"};
    char rotor[SIZE], element[SIZE / 8];
    (void)state;
    snprintf(rotor, sizeof rotor, machine, line_motor, 10.0);
    whirl_result *result = start(rotor, "duration: 0.5 s, rows: 10");
    check_holds("Motor starts", "a motor starts against dry friction",
                number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0) > 40.0 &&
                    number(result, WHIRL_FIELD_RUNUP_END, 0) == 0.0);
    whirl_result_free(result);
    // The load stands until the shaft carries 10 N m: friction is that of the shaft so far, 40 (1 - cos w t), then 10.
    // The closed form leaves out the first speeds, at which friction is not yet all there.
    const double wound = sqrt(1500.0 / 0.2), loose = acos(0.75) / wound;
    const double speed = (40.0 - 40.0 * (loose - sin(wound * loose) / wound) - 10.0 * (1.0 - loose)) / 0.5;
    for (size_t i = 0; i < COUNT_OF(means); i++) {
        snprintf(element, sizeof element, "synchronous_start: {at: motor, frequency: 50 Hz, poles: 4, mean: %s}",
                 means[i]);
        snprintf(rotor, sizeof rotor, machine, element, 10.0);
        result = start(rotor, "duration: 1 s, rows: 10, rtol: 1e-10");
        check_within("Motor starts", words("mean: %s, less dry friction: speed", means[i]), speed,
                     number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0), 0.02);
        whirl_result_free(result);
    }
    snprintf(rotor, sizeof rotor, machine, element, 60.0);
    result = start(rotor, "duration: 1 s, rows: 10");
    check_within("Motor starts", "a weak motor: the shaft stands", 1.0, number(result, WHIRL_FIELD_RUNUP_END, 0), 0.0);
    whirl_result_free(result);
}

/// A train with a gear, rigid or a stiff mesh, is the train with everything referred to one shaft.
static void gears_refer(void **state) {
    static const char one_shaft[] = "  length_scale: 1 m\n"
                                    "  stations:\n"
                                    "    motor: {polar: 0.089 kg.m2, moves: twist}\n"
                                    "    wheel: {polar: 0.13 kg.m2, moves: twist}\n"
                                    "    fan: {polar: 0.4 kg.m2, moves: twist}\n"
                                    "  elements:\n"
                                    "    - coupling: {between: [motor, wheel], twist: 1500 N.m/rad}\n"
                                    "    - coupling: {between: [wheel, fan], twist: 3600 N.m/rad}\n"
                                    "    - %s\n"
                                    "    - drive: {at: fan, load_quadratic: 8e-4 N.m.s2, load_linear: 0.04 N.m.s}\n";
    static const char geared[] = "  length_scale: 1 m\n"
                                 "  stations:\n"
                                 "    fan: {polar: 0.1 kg.m2, moves: twist}\n"
                                 "    motor: {polar: 0.089 kg.m2, moves: twist}\n"
                                 "    wheel: {polar: 0.05 kg.m2, moves: twist}\n"
                                 "    pinion: {polar: 0.02 kg.m2, moves: twist}\n"
                                 "  elements:\n"
                                 "    - coupling: {between: [motor, wheel], twist: 1500 N.m/rad}\n"
                                 "    - coupling: {between: [pinion, fan], twist: 900 N.m/rad}\n"
                                 "    - gear: {between: [wheel, pinion], base_radii: [100 mm, 50 mm]%s}\n"
                                 "    - %s\n"
                                 "    - drive: {at: fan, load_quadratic: 1e-4 N.m.s2, load_linear: 0.01 N.m.s}\n";
    static const struct {
        const char *mesh, *name;
        double within;
    } meshes[] = {{"", "rigid gear", 1e-9}, {", stiffness: 4e8 N/m, damping: 2e4 N.s/m", "stiff mesh", 0.05}};
    static const char study[] = "duration: 0.5 s, rtol: 1e-12, rows: 20";
    char rotor[SIZE];
    (void)state;
    snprintf(rotor, sizeof rotor, one_shaft, line_motor);
    whirl_result *own = start(rotor, study);
    for (size_t i = 0; i < COUNT_OF(meshes); i++) {
        snprintf(rotor, sizeof rotor, geared, meshes[i].mesh, line_motor);
        whirl_result *same = start(rotor, study);
        for (size_t which = 0; which < 3; which++)
            for (size_t least = 0; least < 2; least++)
                check_within("Motor starts",
                             words("%s: torque %zu, %s", meshes[i].name, which, least ? "least" : "largest"),
                             extreme(own, which, least, false) * (which == 2 ? 0.5 : 1.0),
                             extreme(same, which, least, false), meshes[i].within);
        const double *fan = whirl_table_field(&own->tables[0], 0, WHIRL_FIELD_RUNUP_STATION_SPEED, 2);
        const double *faster = whirl_table_field(&same->tables[0], 0, WHIRL_FIELD_RUNUP_STATION_SPEED, 0);
        check_within("Motor starts", words("%s: speed of the fan", meshes[i].name), 2.0 * fan[19], faster[19],
                     meshes[i].within);
        whirl_result_free(same);
    }
    whirl_result_free(own);
}

/// A stiff coupling makes the machine whose shaft does not twist; one that tilts and moves, too, turns alike.
static void stiff_shafts_are_rigid(void **state) {
    static const char rigid[] = "  length_scale: 1 m\n"
                                "  stations:\n"
                                "    disc: {mass: 3 kg, damping: 10 N.s/m, eccentricity: 1 mm}\n"
                                "  elements:\n"
                                "    - spring: {between: [disc, ground], stiffness: 9e4 N/m}\n"
                                "    - %s\n"
                                "    - drive: {inertia: 0.489 kg.m2, load_quadratic: 1e-4 N.m.s2}\n";
    static const char twists[] = "  length_scale: 1 m\n"
                                 "  stations:\n"
                                 "    motor: {polar: 0.089 kg.m2, moves: twist}\n"
                                 "    disc: {mass: 3 kg, damping: 10 N.s/m, eccentricity: 1 mm, polar: 0.4 kg.m2, "
                                 "moves: all}\n"
                                 "  elements:\n"
                                 "    - spring: {between: [disc, ground], stiffness: 9e4 N/m}\n"
                                 "    - coupling: {between: [motor, disc], twist: 1e7 N.m/rad, twist_damping: 600 "
                                 "N.m.s/rad}\n"
                                 "    - %s\n"
                                 "    - drive: {at: disc, load_quadratic: 1e-4 N.m.s2}\n";
    static const char study[] = "duration: 1 s, rtol: 1e-9, rows: 20";
    char rotor[SIZE], whole[SIZE / 8];
    (void)state;
    snprintf(whole, sizeof whole, "%.18s%s", line_motor, line_motor + 29); // without its station
    snprintf(rotor, sizeof rotor, rigid, whole);
    whirl_result *own = start(rotor, study);
    snprintf(rotor, sizeof rotor, twists, line_motor);
    whirl_result *same = start(rotor, study);
    check_within("Motor starts", "stiff shaft: speed at the end", number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0),
                 number(same, WHIRL_FIELD_RUNUP_END_SPEED, 0), 1e-3);
    check_within("Motor starts", "stiff shaft: largest motor torque", extreme(own, 0, false, false),
                 extreme(same, 0, false, false), 1e-2);
    const double *peak = whirl_table_field(&own->tables[0], 0, WHIRL_FIELD_RUNUP_PEAK, 0);
    const double *twisted = whirl_table_field(&same->tables[0], 0, WHIRL_FIELD_RUNUP_PEAK, 1);
    check_within("Motor starts", "stiff shaft: largest motion, mm", 1e3 * *peak, 1e3 * *twisted, 1e-4);
    whirl_result_free(own);
    whirl_result_free(same);
}

/// A shaft of finite elements without mass is a coupling of stiffness G pi d^4/32 l.
static void shafts_of_elements(void **state) {
    static const char elements[] = "  length_scale: 1 mm\n"
                                   "  materials: {light: {modulus: 210 GPa, density: 1 kg/m3, shear_modulus: 80 GPa}}\n"
                                   "  shafts: {main: {twist: yes}}\n"
                                   "  stations:\n"
                                   "    motor: {position: 0 m, shaft: main, mass: 5 kg, polar: 0.089 kg.m2, diametral: "
                                   "0.05 kg.m2}\n"
                                   "    load: {position: 0.6 m, shaft: main, mass: 9 kg, polar: 0.4 kg.m2, diametral: "
                                   "0.3 kg.m2}\n"
                                   "  elements:\n"
                                   "    - segment: {shaft: main, length: 0.6 m, outer: 20 mm, material: light}\n"
                                   "    - bearing: {at: motor, kxx: 1e7 N/m, kyy: 1e7 N/m, cxx: 1e4 N.s/m, cyy: 1e4 "
                                   "N.s/m}\n"
                                   "    - bearing: {at: load, kxx: 1e7 N/m, kyy: 1e7 N/m, cxx: 1e4 N.s/m, cyy: 1e4 "
                                   "N.s/m}\n"
                                   "    - drive: {at: motor, torque: 40 N.m, no_load_speed: 300 rad/s}\n";
    static const char study[] = "duration: 0.2 s, rtol: 1e-9, rows: 20";
    const double stiffness = 80e9 * pi * pow(0.02, 4) / 32.0 / 0.6;
    char rotor[SIZE];
    (void)state;
    snprintf(rotor, sizeof rotor,
             "  length_scale: 1 mm\n"
             "  stations:\n"
             "    motor: {polar: 0.089 kg.m2, moves: twist}\n"
             "    load: {polar: 0.4 kg.m2, moves: twist}\n"
             "  elements:\n"
             "    - coupling: {between: [motor, load], twist: %.17g N.m/rad}\n"
             "    - drive: {at: motor, torque: 40 N.m, no_load_speed: 300 rad/s}\n",
             stiffness);
    whirl_result *own = start(rotor, study);
    whirl_result *same = start(elements, study);
    const whirl_field *rows = whirl_layout_field(&same->tables[0].layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
    assert_non_null(rows);
    for (size_t i = 0; i < rows->rows; i++)
        check_within("Motor starts", words("element %zu of %zu: largest torque", i + 1, rows->rows),
                     extreme(own, 0, false, false), extreme(same, i, false, false), 1e-3);
    check_within("Motor starts", "shaft of elements: speed at the end", number(own, WHIRL_FIELD_RUNUP_END_SPEED, 0),
                 number(same, WHIRL_FIELD_RUNUP_END_SPEED, 0), 1e-5);
    whirl_result_free(own);
    whirl_result_free(same);
}

/// The same torque again: cycles of the range 2 T J2/(J1 + J2), ten in ten periods, whose damage by an S-N curve is
/// known; of torques, and of shear stresses at a notch. A range above a curve of points has no damage.
static void damage_of_a_start(void **state) {
    static const double k = 8000.0, one = 2.0, two = 3.0, torque = 100.0, slope = 5.0;
    const double period = 2.0 * pi / sqrt(k * (1.0 / one + 1.0 / two)), range = 2.0 * torque * two / (one + two);
    const double section = pi * 0.03 * 0.03 * 0.03 / 16.0;
    const struct {
        const char *keys;
        double damage; ///< NaN: the range is above the curve
    } curves[] = {
        {"torque_ranges: 60 N.m, cycles: 2e6, slope: 5", 10.0 * pow(range / 60.0, slope) / 2e6},
        {"torque_ranges: 60 N.m, cycles: 2e6, slope: 5, endurance_torque: 130 N.m", 0.0},
        {"stress_ranges: 20 MPa, cycles: 2e6, slope: 5, stress_concentration: 1.7",
         10.0 * pow(1.7 * range / section / 20e6, slope) / 2e6},
        {"stress_ranges: 20 MPa, cycles: 2e6, slope: 5, diameter: 60 mm",
         10.0 * pow(range / (8.0 * section) / 20e6, slope) / 2e6},
        {"torque_ranges: [240 N.m, 60 N.m], cycles: [1e3, 1e5]",
         10.0 / (1e3 * pow(100.0, log(240.0 / range) / log(4.0)))},
        {"torque_ranges: [110 N.m, 60 N.m], cycles: [1e3, 1e5]", NAN},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(curves); i++) {
        char rotor[SIZE], study[128];
        snprintf(rotor, sizeof rotor,
                 "  length_scale: 1 m\n"
                 "  stations:\n"
                 "    one: {polar: %g kg.m2, moves: twist}\n"
                 "    two: {polar: %g kg.m2, moves: twist}\n"
                 "  elements:\n"
                 "    - coupling: {between: [one, two], twist: %g N.m/rad, diameter: 30 mm}\n"
                 "    - timed_torque: {at: one, times: [0 s, 1 s], torques: [%g N.m, %g N.m]}\n"
                 "    - fatigue: {between: [two, one], %s}\n",
                 one, two, k, torque, torque, curves[i].keys);
        snprintf(study, sizeof study,
                 "duration: %.17g s, speed_from: 100 rad/s, speed_to: 400 rad/s, rtol: 1e-10, rows: 20", 10.0 * period);
        whirl_result *result = start(rotor, study);
        const double *damage = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_DAMAGE, 0) + 2;
        check_within("Motor starts", words("curve %zu: ranges above it", i), isnan(curves[i].damage) ? 1.0 : 0.0,
                     damage[1], 0.0);
        if (isnan(curves[i].damage))
            check_holds("Motor starts", "there is no damage by a curve that says nothing", isnan(damage[0]));
        else
            check_within("Motor starts", words("curve %zu: damage of a run", i), curves[i].damage, damage[0],
                         1e-3 * curves[i].damage);
        whirl_result_free(result);
    }
}

/// Teeth begin in the middle of their play, a torque T on the first gear closes them after t, they bounce and are free
/// for 2 t: the motion of delta = r1 th1 + r2 th2 is delta'' = T r1/J1, less k (delta - b)/m in contact, 1/m = r1^2/J1
/// + r2^2/J2.
static void teeth_bounce(void **state) {
    static const double one = 0.5, two = 2.0, r1 = 0.1, r2 = 0.25, k = 2e6, b = 1e-4, torque = 40.0;
    static const char *const rotations[] = {"", "  rotation: clockwise\n"};
    const double a = torque * r1 / one, w = sqrt(k * (r1 * r1 / one + r2 * r2 / two));
    const double t = sqrt(2.0 * b / a), v = a * t, closed = 2.0 * (pi - atan(v * w / a)) / w;
    const double most = k * (a / (w * w) + hypot(a / (w * w), v / w));
    (void)state;
    for (size_t i = 0; i < COUNT_OF(rotations); i++) {
        char rotor[SIZE], study[128];
        snprintf(rotor, sizeof rotor,
                 "%s  length_scale: 1 mm\n"
                 "  stations:\n"
                 "    one: {polar: %g kg.m2, moves: twist}\n"
                 "    two: {polar: %g kg.m2, moves: twist}\n"
                 "  elements:\n"
                 "    - gear: {between: [one, two], base_radii: [%g m, %g m], stiffness: %g N/m, backlash: %g m}\n"
                 "    - timed_torque: {at: one, times: [0 s, 1 s], torques: [%g N.m, %g N.m]}\n",
                 rotations[i], one, two, r1, r2, k, 2.0 * b, torque, torque);
        snprintf(study, sizeof study,
                 "duration: %.17g s, speed_from: 10 rad/s, speed_to: 100 rad/s, rtol: 1e-11, rows: 20, begin: centre",
                 3.0 * t + closed);
        whirl_result *result = start(rotor, study);
        const double open = number(result, WHIRL_FIELD_RUNUP_OPEN, 1), known = 3.0 * t / (3.0 * t + closed);
        check_within("Motor starts", "teeth bounce: largest torque on the first gear, N m", r1 * most,
                     extreme(result, 1, false, false), 1e-6 * r1 * most);
        check_within("Motor starts", "teeth bounce: kind of the torque", 5.0,
                     number(result, WHIRL_FIELD_RUNUP_TORQUE_OF, 3), 0.0);
        check_within("Motor starts", "teeth bounce: share of the time without contact", known, open, 5e-3);
        whirl_result_free(result);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(motor_is_switched_on),
                                       cmocka_unit_test(torques_within_a_turn),
                                       cmocka_unit_test(a_million_turns_behind),
                                       cmocka_unit_test(synchronous_motor_starts),
                                       cmocka_unit_test(terminals_are_short_circuited),
                                       cmocka_unit_test(torque_is_put_on),
                                       cmocka_unit_test(inertia_leaves),
                                       cmocka_unit_test(loads_yield_at_standstill),
                                       cmocka_unit_test(motor_otherwise),
                                       cmocka_unit_test(gears_refer),
                                       cmocka_unit_test(stiff_shafts_are_rigid),
                                       cmocka_unit_test(shafts_of_elements),
                                       cmocka_unit_test(damage_of_a_start),
                                       cmocka_unit_test(teeth_bounce)};
    return cmocka_run_group_tests_name("starts", tests, NULL, NULL);
}
