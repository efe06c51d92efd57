// What must not change a reported number: standing still against the slowest turning, the length scale, the units of a
// case, the side from which a machine is looked at, how a sweep is split, the method. One small machine of every
// element of the registry, all fields of its tables.
#include <ctype.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"
#include "whirl/engine/rotor.h"

enum { TEXT = 8192 };

#define FILM                                                                                                           \
    "at: rotor, from: stator, clearance: 0.2 mm, viscosity: 10 mPa.s, density: 850 kg/m3, radius: 25 mm, length: 20 "  \
    "mm"
#define STATOR "at: rotor, from: stator, gap: 20 um, radius: 40 mm, friction: 0.1"
#define TILTING                                                                                                        \
    "disc: {at: rotor, outer: 200 mm, width: 10 mm}\n    - disc: {at: stator, outer: 100 mm, width: 10 mm}\n"          \
    "    - spring: {between: [rotor, ground], along: tilts, stiffness: 30000, damping: 90}\n"                          \
    "    - spring: {between: [stator, ground], along: tilts, stiffness: 20000, damping: 90}\n"                         \
    "    - spring: {between: [rotor, ground], along: tilt_x, stiffness: 5000}\n"                                       \
    "    - spring: {between: [stator, ground], along: tilt_x, stiffness: 3000}\n    - "

/// A machine of one element, between a rotor and a stator on springs. Its angles are those of machines that are their
/// own mirror image by x -> -x, unless the element is written for the mirrored one, too.
typedef struct machine {
    const char *name, *element, *mirrored;
    bool turns; ///< its stiffness turns with the shaft
} machine;

static const machine machines[] = {
    {"unbalance", "unbalance: {at: rotor, moment: 2 g.m, angle: 90 deg}", NULL, false},
    {"unbalance", "unbalance: {at: rotor, moment: 2 g.m, angle: 90 deg, ratio: 2}", NULL, false},
    {"force", "force: {at: rotor, amplitude: 90 N, angle: 90 deg, ratio: 2}", NULL, false},
    {"gravity", "gravity: {}", NULL, false},
    {"disc", TILTING "disc: {at: rotor, outer: 300 mm, width: 20 mm, density: 7850 kg/m3}", NULL, false},
    {"beam", TILTING "beam: {between: [rotor, stator], length: 400 mm, diameter: 30 mm, modulus: 2e11 Pa}", NULL,
     false},
    {"coupling",
     TILTING "coupling: {between: [rotor, stator], radial: 0.1 MN/m, tilt: 900 N.m/rad, radial_damping: 100 N.s/m, "
             "face_kink: 0.001, face_angle: 90 deg, bore_offset: 10 um, bore_angle: 90 deg}",
     NULL, false},
    {"bearing",
     "bearing: {at: rotor, from: stator, kxx: 2 MN/m, kxy: 0.5 MN/m, kyy: 3 MN/m, kyx: -0.6 MN/m, cxx: 900 N.s/m, "
     "cyy: 700 N.s/m, cxy: -90 N.s/m, cyx: -60 N.s/m}",
     "bearing: {at: rotor, from: stator, kxx: 2 MN/m, kxy: -0.5 MN/m, kyy: 3 MN/m, kyx: 0.6 MN/m, cxx: 900 N.s/m, "
     "cyy: 700 N.s/m, cxy: 90 N.s/m, cyx: 60 N.s/m}",
     false},
    {"shaft", "shaft: {between: [rotor, stator], k1: 1 MN/m, k2: 1.3 MN/m}", NULL, true},
    {"film", "film: {" FILM ", law: capone}", NULL, false},
    {"film", "film: {" FILM ", law: short}", NULL, false},
    {"film", "film: {" FILM ", law: finite}", NULL, false},
    {"film", "film: {at: rotor, clearance: 0.2 mm, viscosity: 10 mPa.s, radius: 25 mm, length: 20 mm}", NULL, false},
    {"rub", "rub: {at: rotor, gap: 20 um, stiffness: 20 MN/m, friction: 0.1, damping: 900 N.s/m}", NULL, false},
    {"rub",
     "rub: {at: rotor, gap: 20 um, stiffness: 20 MN/m, friction: 0.1, law: slip, radius: 40 mm, "
     "slip_speed: 50 mm/s}",
     NULL, false},
    {"spring", "spring: {between: [rotor, stator], stiffness: 1 MN/m, damping: 300 N.s/m}", NULL, false},
    {"crack", "crack: {between: [rotor, stator], stiffness: 1 MN/m, loss: 0.3, angle: 90 deg}", NULL, true},
    {"seal",
     "seal: {at: rotor, clearance: 0.3 mm, stiffness: 1 MN/m, damping: 1000 N.s/m, mass: 2 kg, ratio: 0.48, "
     "growth: 2, slowing: 0.5}",
     NULL, false},
    {"seal",
     "seal: {law: black, at: rotor, radius: 50 mm, length: 40 mm, clearance: 0.3 mm, density: 1000 kg/m3, "
     "viscosity: 1 mPa.s, pressure: 1 MPa}",
     NULL, false},
    {"looseness",
     "looseness: {between: [stator, ground], along: y, stiffness: 2 MN/m, loose_stiffness: 1 MN/m, "
     "held_stiffness: 3 MN/m, gap: 50 um, damping: 900 N.s/m}",
     NULL, false},
    {"mount", "mount: {between: [rotor, stator], stiffness: 1 MN/m, branch: 2 MN/m, damping: 900 N.s/m}", NULL, false},
    {"ball_bearing",
     "ball_bearing: {at: rotor, from: stator, balls: 8, stiffness: 1e9, clearance: 0 mm, angle: 90 deg, "
     "inner: 40 mm, outer: 60 mm, damping: 500 N.s/m}",
     NULL, false},
    {"roller_bearing",
     "roller_bearing: {at: rotor, from: stator, rollers: 8, stiffness: 3e8, clearance: -0.005 mm, angle: 90 deg, "
     "inner: 40 mm, outer: 60 mm, damping: 500 N.s/m}",
     NULL, false},
    {"squeeze", "squeeze: {" FILM "}", NULL, false},
    {"pad_bearing", "pad_bearing: {" FILM ", shape: elliptical, preload: 0.5}", NULL, false},
    {"tilting_pad", "tilting_pad: {" FILM ", shape: tilting-4, preload: 0.5}", NULL, false},
    {"tilting_pad", "tilting_pad: {" FILM ", shape: tilting-4, preload: 0.5, inertia: 1e-4 kg.m2}", NULL, false},
    {"contact",
     "contact: {" STATOR ", stiffness: 3e9, law: hunt_crossley, loss: 0.5 s/m, friction_law: stribeck, "
     "static_friction: 0.2, stribeck_speed: 100 mm/s, slip_speed: 50 mm/s}",
     NULL, false},
    {"magnetic",
     "magnetic: {at: rotor, from: stator, gap: 0.5 mm, bias: 3 A, turns: 120, area: 400 mm2, max_current: 5 A, "
     "proportional: 20000 A/m, integral: 100000 A/(m.s), derivative: 40 A.s/m, derivative_filter: 0.2 ms}",
     NULL, false},
    {"blade_rub",
     "blade_rub: {at: rotor, from: stator, blades: 4, radius: 300 mm, gap: 20 um, stiffness: 2e7, friction: 0.1, "
     "angle: 90 deg}",
     NULL, false},
    {"floating_ring",
     "floating_ring: {at: rotor, ring: stator, inertia: 1e-4 kg.m2, clearance: 0.1 mm, radius: 20 mm, length: 20 mm, "
     "viscosity: 10 mPa.s, outer_clearance: 0.2 mm, outer_radius: 25 mm, outer_length: 20 mm}",
     NULL, false},
    {"joint",
     TILTING "joint: {between: [rotor, stator], bend: 10 deg, torque: 500 N.m, direction: 90 deg, yoke: 90 deg}", NULL,
     true},
    {"coupling_load",
     TILTING "coupling_load: {between: [rotor, stator], distance: 50 mm, y1: 0.1 mm, y2: 0.3 mm, torque: 0 N.m, "
             "bending_stiffness: 150 N.m/rad, orders: [1, 0, 0.25], phase: 0 deg}",
     NULL, false},
    {"cubic_spring",
     "cubic_spring: {between: [rotor, stator], stiffness: 1 MN/m, cubic: 1e15 N/m3, damping: 300 N.s/m}", NULL, false},
    {"friction", "friction: {between: [rotor, stator], force: 60 N, slip_speed: 50 mm/s}", NULL, false},
    {"unbalance_grade",
     "unbalance_grade: {planes: [rotor, stator], grade: 40, service_speed: 900 rad/s, mass: 12 kg, "
     "to_first: 200 mm, to_second: 500 mm, angle: 90 deg, second_angle: 90 deg}",
     NULL, false},
    {"runout", "runout: {at: rotor, amplitude: 10 um, angle: 90 deg}", NULL, false},
};
enum { MACHINES = sizeof machines / sizeof *machines };

/// Elements whose machines are others: pieces of shafts of finite elements, and what has no torque at rest.
static const char *const aside[] = {"segment", "stage"};

static void make_text(const machine *of, bool mirrored, const char *length, const char *study, char text[TEXT]) {
    snprintf(
        text, TEXT,
        "whirl: 1\nparameters: {n: 0 rad/s}\nrotor:\n  speed: = n\n  rotation: %s\n  length_scale: %s\n"
        "  stations:\n    rotor: {mass: 10 kg, damping: 900 N.s/m, eccentricity: 20 um, eccentricity_angle: 90 deg}\n"
        "    stator: {mass: 2 kg, damping: 3000 N.s/m}\n  elements:\n"
        "    - spring: {between: [stator, ground], stiffness: 8 MN/m}\n"
        "    - spring: {between: [rotor, ground], stiffness: 4 MN/m}\n"
        "    - spring: {between: [rotor, ground], along: y, stiffness: 0.7 MN/m}\n"
        "    - spring: {between: [stator, ground], along: y, stiffness: 1.9 MN/m}\n%s    - %s\nstudy:\n%s",
        mirrored ? "clockwise" : "counter-clockwise", length,
        strcmp(of->name, "gravity") == 0 ? "" : "    - gravity: {}\n",
        mirrored && of->mirrored ? of->mirrored : of->element, study);
}

static void every_element_has_a_machine(void **state) {
    (void)state;
    for (const whirl_group *const *group = whirl_element_groups(); *group; group++) {
        bool known = false;
        for (size_t i = 0; i < MACHINES; i++) known = known || strcmp(machines[i].name, (*group)->name) == 0;
        for (size_t i = 0; i < sizeof aside / sizeof *aside; i++)
            known = known || strcmp(aside[i], (*group)->name) == 0;
        if (!known) fail_msg("%s has no machine", (*group)->name);
    }
}

// ---------------------------------------------------------------- comparing

/// The sign by which a column of a field is another one in the mirror, 0: nothing is asked of it.
typedef double sign_of(const whirl_field *field, size_t column);

static double as_it_is(const whirl_field *field, size_t column) {
    (void)field, (void)column;
    return 1.0;
}

/// Fields that say where a point is, or what lies before it in its sweep.
static bool is_place(const char *field) {
    static const char *const places[] = {WHIRL_FIELD_MODES_SPEED, WHIRL_FIELD_MODES_BEFORE};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        if (strcmp(places[i], field) == 0) return true;
    return false;
}

static double largest_of(const double *numbers, size_t count) {
    double largest = 0.0;
    for (size_t i = 0; i < count; i++)
        if (isfinite(numbers[i])) largest = fmax(largest, fabs(numbers[i]));
    return largest;
}

static bool is_rate(const whirl_field *field) {
    return strcmp(field->unit, "rad/s") == 0 || strcmp(field->unit, "1/s") == 0;
}

/// The fastest rate of a point: that of a pad without inertia goes with the speed and is 0 in its limit, beside it.
static double fastest(const whirl_table *table, size_t point) {
    double largest = 0.0;
    for (size_t f = 0; f < table->layout.field_count; f++) {
        const whirl_field *field = &table->layout.fields[f];
        const double *numbers = whirl_table_field(table, point, field->name, 0);
        if (is_rate(field)) largest = fmax(largest, largest_of(numbers, field->repeat * field->rows * field->columns));
    }
    return largest;
}

/// All fields of point `at` of a table against those of point `there` of another one, times the sign, to within
/// `tolerance` of a field's largest number, of rates of the fastest one. Gives how many numbers differ.
static size_t compare_points(const char *what, const whirl_table *one, size_t at, const whirl_table *other,
                             size_t there, double tolerance, sign_of *sign) {
    size_t wrong = 0;
    assert_int_equal(one->layout.field_count, other->layout.field_count);
    for (size_t f = 0; f < one->layout.field_count; f++) {
        const whirl_field *field = &one->layout.fields[f];
        const size_t count = field->repeat * field->rows * field->columns;
        const double *a = whirl_table_field(one, at, field->name, 0);
        const double *b = whirl_table_field(other, there, field->name, 0);
        const double least = strcmp(field->unit, "1") == 0 ? 1.0 : is_rate(field) ? fastest(one, at) : 0.0;
        const double largest = fmax(largest_of(a, count), least);
        for (size_t i = 0; i < count && !is_place(field->name); i++) {
            const double s = sign(field, i % field->columns);
            if (s == 0.0 || (isnan(a[i]) && isnan(b[i])) || fabs(a[i] - s * b[i]) <= tolerance * largest) continue;
            print_message("%s: %s[%zu] is %.12g and %.12g\n", what, field->name, i, a[i], b[i]);
            wrong++;
        }
    }
    return wrong;
}

// ---------------------------------------------------------------- speed 0

static void at_rest_as_at_the_slowest_turning(void **state) {
    size_t wrong = 0;
    (void)state;
    for (size_t i = 0; i < MACHINES; i++) {
        char text[TEXT];
        if (machines[i].turns) continue; // none has an end of the revolution that it would need at 1e-9 rad/s
        for (int mirrored = 0; mirrored < 2; mirrored++) {
            make_text(&machines[i], mirrored, "0.1 mm", "  modes: {parameter: n, values: [0, 1e-9]}\n", text);
            whirl_result *result = result_of_text(text);
            for (size_t t = 0; t < result->table_count; t++)
                wrong += compare_points(words("%s%s", machines[i].name, mirrored ? ", mirrored" : ""),
                                        &result->tables[t], 0, &result->tables[t], 1, 1e-7, as_it_is);
            whirl_result_free(result);
        }
    }
    assert_int_equal(wrong, 0);
}

/// A mass of 10 kg on a part that turns: its natural frequencies, rad/s, where the shaft stands still.
static void check_standing(const char *name, const char *part, double one, double other) {
    char text[TEXT];
    snprintf(
        text, sizeof text,
        "whirl: 1\nrotor:\n  speed: 0 rad/s\n  length_scale: 1 mm\n  stations: {mass: {mass: 10 kg}}\n  elements:\n"
        "    - %s\nstudy: {modes: {}}\n",
        part);
    whirl_result *result = result_of_text(text);
    const double stiffness[] = {one, other};
    for (size_t i = 0; i < 2; i++)
        check_within("invariance", words("%s: frequency %zu, rad/s", name, i + 1), sqrt(stiffness[i] / 10.0),
                     whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_MODES_FREQUENCY, 0)[i], 1e-9);
    whirl_result_free(result);
}

/// What turns with the shaft stays at its angle of t = 0.
static void what_turns_stands_still(void **state) {
    (void)state;
    check_standing("unequal stiffness", "shaft: {between: [mass, ground], k1: 1 MN/m, k2: 1.3 MN/m}", 1e6, 1.3e6);
    // Across from its load, which points down; along it; beside it.
    check_standing("a crack that is closed",
                   "crack: {between: [mass, ground], stiffness: 1 MN/m, loss: 0.3, angle: 90 deg}", 1e6, 1e6);
    check_standing("an open crack", "crack: {between: [mass, ground], stiffness: 1 MN/m, loss: 0.3, angle: -90 deg}",
                   0.7e6, 1e6);
    check_standing("a crack half open",
                   "crack: {between: [mass, ground], stiffness: 1 MN/m, loss: 0.3, loss_across: 0.1}", 0.85e6, 0.95e6);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_element_has_a_machine),
                                       cmocka_unit_test(at_rest_as_at_the_slowest_turning),
                                       cmocka_unit_test(what_turns_stands_still)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
