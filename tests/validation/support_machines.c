#include "support_machines.h"

#include <ctype.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

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

#define TWISTING                                                                                                       \
    "spring: {between: [rotor, ground], along: twist, stiffness: 30000, damping: 9}\n"                                 \
    "    - spring: {between: [stator, ground], along: twist, stiffness: 20000, damping: 9}\n    - "

#define AXIAL                                                                                                          \
    "spring: {between: [rotor, ground], along: axial, stiffness: 2 MN/m, damping: 300 N.s/m}\n"                        \
    "    - spring: {between: [stator, ground], along: axial, stiffness: 3 MN/m, damping: 300 N.s/m}\n    - "

const element_machine element_machines[] = {
    {"unbalance", "unbalance: {at: rotor, moment: 2 g.m, angle: @70}", 0},
    {"unbalance", "unbalance: {at: rotor, moment: 2 g.m, angle: @70, ratio: 2}", 0},
    {"force", "force: {at: rotor, amplitude: 90 N, angle: @70, ratio: 2, phase: 20 deg}", 0},
    {"force", "force: {at: rotor, law: backward, amplitude: 90 N, angle: @70, phase: 20 deg}", 0},
    {"gravity", "gravity: {direction: @-70}", 0},
    {"disc", TILTING "disc: {at: rotor, outer: 300 mm, width: 20 mm, density: 7850 kg/m3}", 0},
    {"beam", TILTING "beam: {between: [rotor, stator], length: 400 mm, diameter: 30 mm, modulus: 2e11 Pa}", 0},
    {"coupling",
     TILTING "coupling: {between: [rotor, stator], radial: 0.1 MN/m, tilt: 900 N.m/rad, radial_damping: 100 N.s/m, "
             "face_kink: 0.001 rad, face_angle: @70, bore_offset: 10 um, bore_angle: @50}",
     0},
    {"bearing",
     "bearing: {at: rotor, from: stator, kxx: 2 MN/m, kxy: ~0.5 MN/m, kyy: 3 MN/m, kyx: ~-0.6 MN/m, cxx: 900 N.s/m, "
     "cyy: 700 N.s/m, cxy: ~-90 N.s/m, cyx: ~-60 N.s/m, mxx: 0.1 kg, mxy: ~0.05 kg, myy: 0.2 kg, elevation: 10 um, "
     "sideways: ~20 um}",
     0},
    {"bearing",
     "bearing: {at: rotor, from: stator, speeds: [0 rad/s, 700 rad/s, 9000 rad/s], kxx: [2 MN/m, 3 MN/m, 4 MN/m], "
     "kxy: [~0.5 MN/m, ~0.6 MN/m, ~0.7 MN/m], kyx: ~-0.3 MN/m, cxx: [900 N.s/m, 800 N.s/m, 700 N.s/m]}",
     0},
    {"shaft", "shaft: {between: [rotor, stator], k1: 1 MN/m, k2: 1.3 MN/m}", MACHINE_TURNS},
    {"film", "film: {" FILM ", law: capone}", 0},
    {"film", "film: {" FILM ", law: short}", 0},
    {"film", "film: {" FILM ", law: finite}", 0},
    {"film", "film: {at: rotor, clearance: 0.2 mm, viscosity: 10 mPa.s, radius: 25 mm, length: 20 mm}", 0},
    {"rub", "rub: {at: rotor, gap: 20 um, stiffness: 20 MN/m, friction: 0.1, damping: 900 N.s/m}", MACHINE_SHARP},
    {"rub",
     "rub: {at: rotor, gap: 20 um, stiffness: 20 MN/m, friction: 0.1, law: slip, radius: 40 mm, "
     "slip_speed: 50 mm/s}",
     MACHINE_SHARP},
    {"spring", "spring: {between: [rotor, stator], stiffness: 1 MN/m, damping: 300 N.s/m}", 0},
    {"crack", "crack: {between: [rotor, stator], stiffness: 1 MN/m, loss: 0.3, angle: @70}", MACHINE_TURNS},
    {"seal",
     "seal: {at: rotor, clearance: 0.3 mm, stiffness: 1 MN/m, damping: 1000 N.s/m, mass: 2 kg, ratio: 0.48, "
     "growth: 2, slowing: 0.5}",
     0},
    {"seal",
     "seal: {law: black, at: rotor, radius: 50 mm, length: 40 mm, clearance: 0.3 mm, density: 1000 kg/m3, "
     "viscosity: 1 mPa.s, pressure: 1 MPa}",
     0},
    {"looseness",
     "looseness: {between: [stator, ground], along: y, stiffness: 2 MN/m, loose_stiffness: 1 MN/m, "
     "held_stiffness: 3 MN/m, gap: 50 um, damping: 900 N.s/m}",
     MACHINE_SHARP},
    {"mount", "mount: {between: [rotor, stator], stiffness: 1 MN/m, branch: 2 MN/m, damping: 900 N.s/m}", 0},
    {"ball_bearing",
     "ball_bearing: {at: rotor, from: stator, balls: 8, stiffness: 1e9, clearance: 0 mm, angle: @70, "
     "inner: 40 mm, outer: 60 mm, damping: 500 N.s/m, outer_dent: 2 um, outer_dent_width: 20 deg, "
     "outer_dent_angle: @-60}",
     MACHINE_SHARP},
    {"roller_bearing",
     "roller_bearing: {at: rotor, from: stator, rollers: 8, stiffness: 3e8, clearance: -0.005 mm, angle: @70, "
     "inner: 40 mm, outer: 60 mm, damping: 500 N.s/m}",
     MACHINE_SHARP},
    {"squeeze", "squeeze: {" FILM "}", 0},
    {"pad_bearing", "pad_bearing: {" FILM ", shape: elliptical, preload: 0.5}", 0},
    {"pad_bearing", "pad_bearing: {" FILM ", shape: offset-half, preload: 0.5}", 0},
    {"tilting_pad", "tilting_pad: {" FILM ", pivots: [@20, @110, @200, @290], arc: 80 deg, preload: 0.5}", 0},
    {"tilting_pad",
     "tilting_pad: {" FILM ", pivots: [@20, @110, @200, @290], arc: 80 deg, preload: 0.5, "
     "inertia: 1e-4 kg.m2}",
     0},
    {"tilting_pad",
     "tilting_pad: {" FILM ", pivots: [@20, @110, @200, @290], arc: 80 deg, preload: 0.5, "
     "inertia: 1e-4 kg.m2, pivot_stiffness: 500 MN/m, pivot_damping: 10 kN.s/m, pad_mass: 0.2 kg}",
     0},
    {"contact",
     "contact: {" STATOR ", stiffness: 3e9, law: hunt_crossley, loss: 0.5 s/m, friction_law: stribeck, "
     "static_friction: 0.2, stribeck_speed: 100 mm/s, slip_speed: 50 mm/s, arc: 200 deg, arc_middle: @-60}",
     MACHINE_SHARP},
    {"contact",
     "contact: {" STATOR ", stiffness: 3e9, friction_law: lugre, static_friction: 0.2, stribeck_speed: 100 mm/s, "
     "bristle_stiffness: 100 1/m, bristle_damping: 0.01 s/m}",
     MACHINE_SHARP},
    {"magnetic",
     "magnetic: {at: rotor, from: stator, angle: @30, gap: 0.5 mm, bias: 3 A, turns: 120, area: 400 mm2, "
     "max_current: 5 A, proportional: 20000 A/m, integral: 100000 A/(m.s), derivative: 40 A.s/m, "
     "derivative_filter: 0.2 ms}",
     MACHINE_SLOW},
    {"magnetic",
     "magnetic: {at: rotor, from: stator, angle: @30, law: linear, current_stiffness: 200 N/A, displacement_stiffness: "
     "2 MN/m, "
     "proportional: 20000 A/m, derivative: 40 A.s/m, derivative_filter: 0.2 ms, amplifier_bandwidth: 2 kHz}",
     0},
    {"magnetic",
     "magnetic: {at: rotor, from: stator, angle: @30, gap: 0.5 mm, bias: 3 A, turns: 120, area: 400 mm2, "
     "max_current: 5 A, proportional: 20000 A/m, derivative: 40 A.s/m, derivative_filter: 0.2 ms, fails_after: 1000}",
     0},
    {"blade_rub",
     "blade_rub: {at: rotor, from: stator, blades: 4, radius: 300 mm, gap: 20 um, stiffness: [2e7, 1.8e7, 2e7, "
     "1.8e7], friction: 0.1, angle: @70}",
     MACHINE_SHARP},
    {"floating_ring",
     "floating_ring: {at: rotor, ring: stator, inertia: 1e-4 kg.m2, clearance: 0.1 mm, radius: 20 mm, length: 20 mm, "
     "viscosity: 10 mPa.s, outer_clearance: 0.2 mm, outer_radius: 25 mm, outer_length: 20 mm}",
     0},
    {"joint", TILTING "joint: {between: [rotor, stator], bend: 10 deg, torque: 500 N.m, direction: @70, yoke: @20}",
     MACHINE_TURNS},
    {"coupling_load",
     TILTING "coupling_load: {between: [rotor, stator], distance: 50 mm, x1: ~0.2 mm, y1: 0.1 mm, x2: ~-0.1 mm, "
             "y2: 0.3 mm, torque: 100 N.m, bending_stiffness: 150 N.m/rad, orders: [1, 0.5, 0.25], phase: 20 deg}",
     0},
    {"cubic_spring",
     "cubic_spring: {between: [rotor, stator], stiffness: 1 MN/m, cubic: 1e15 N/m3, damping: 300 N.s/m}", 0},
    {"friction", "friction: {between: [rotor, stator], force: 60 N, slip_speed: 50 mm/s}", 0},
    {"unbalance_grade",
     "unbalance_grade: {planes: [rotor, stator], grade: 40 mm/s, service_speed: 900 rad/s, mass: 12 kg, "
     "to_first: 200 mm, to_second: 500 mm, angle: @70, second_angle: @40}",
     0},
    {"gear",
     TWISTING "gear: {between: [rotor, stator], base_radii: [80 mm, 200 mm], pressure_angle: ~20 deg, direction: @40, "
              "helix: 10 deg, stiffness: 3 MN/m, damping: 200 N.s/m}",
     MACHINE_TWISTS},
    {"gear",
     TWISTING "force: {at: rotor, steady_torque: 30 N.m, torque: 20 N.m, ratio: 2, phase: 20 deg}\n"
              "    - gear: {between: [rotor, stator], base_radii: [80 mm, 200 mm], pressure_angle: ~20 deg, "
              "direction: @40, stiffness: 3 MN/m, damping: 200 N.s/m, teeth: 2, error: 20 um, "
              "error_angle: 50 deg}",
     MACHINE_TWISTS},
    {"gear",
     TILTING TWISTING "gear: {between: [rotor, stator], base_radii: [80 mm, 200 mm], pressure_angle: ~20 deg, "
                      "direction: @40, helix: ~25 deg, stiffness: 3 MN/m, damping: 200 N.s/m, teeth: 2, error: 20 um, "
                      "error_angle: 50 deg}",
     MACHINE_TWISTS},
    {"gear",
     TILTING TWISTING AXIAL
     "force: {at: rotor, steady_torque: 30 N.m}\n    - force: {at: stator, axial: 80 N, steady_axial: 50 N, ratio: 2}\n"
     "    - gear: {between: [rotor, stator], base_radii: [80 mm, 200 mm], pressure_angle: ~20 deg, direction: @40, "
     "helix: ~25 deg, stiffness: 3 MN/m, damping: 200 N.s/m, backlash: 10 um}",
     MACHINE_AXIAL | MACHINE_SHARP},
    {"coupling",
     TWISTING AXIAL "coupling: {between: [rotor, stator], axial: 1 MN/m, axial_damping: 200 N.s/m, twist: 900 N.m/rad}",
     MACHINE_AXIAL},
    {"cubic_spring",
     TWISTING AXIAL "force: {at: rotor, axial: 400 N}\n    - cubic_spring: {between: [rotor, stator], along: axial, "
                    "stiffness: 1 MN/m, cubic: 1e15 N/m3, damping: 300 N.s/m}",
     MACHINE_AXIAL},
    {"gear", TWISTING "gear: {between: [rotor, stator], base_radii: [80 mm, 200 mm]}", MACHINE_TWISTS},
    {"coupling", TWISTING "coupling: {between: [rotor, stator], twist: 900 N.m/rad, twist_damping: 2 N.m.s/rad}",
     MACHINE_TWISTS},
    {"drive", "drive: {inertia: 2 kg.m2, torque: 10 N.m, no_load_speed: 900 rad/s}", 0},
    {"induction_motor",
     "induction_motor: {voltage: 220 V, frequency: 60 Hz, poles: 4, stator_resistance: 0.4 ohm, stator_reactance: 0.7 "
     "ohm, magnetizing_reactance: 26 ohm, rotor_reactance: 0.7 ohm, rotor_resistance: 0.8 ohm}",
     0},
    {"synchronous_start", "synchronous_start: {frequency: 50 Hz, poles: 4, mean: 40 N.m, pulsating: 20 N.m}", 0},
    {"short_circuit", "short_circuit: {torque: 40 N.m, frequency: 50 Hz, first: 7, decay: 80 ms}", 0},
    {"pulsation", TWISTING "pulsation: {at: rotor, orders: [1, 2], amplitudes: [20 N.m, 5 N.m], steady: 9 N.m}",
     MACHINE_TWISTS},
    {"fatigue",
     TWISTING "coupling: {between: [rotor, stator], twist: 900 N.m/rad, twist_damping: 2 N.m.s/rad}\n"
              "    - fatigue: {between: [rotor, stator], torque_ranges: 100 N.m, cycles: 1e6, slope: 5}",
     MACHINE_TWISTS},
    {"timed_torque", "timed_torque: {times: [0, 1 s], torques: [0, 5 N.m]}", 0},
    {"runout", "runout: {at: rotor, amplitude: 10 um, angle: @70}", 0},
    {"segment",
     "disc: {at: rotor, outer: 200 mm, width: 10 mm}\n    - disc: {at: stator, outer: 100 mm, width: 10 mm}\n"
     "    - segment: {from: rotor, to: stator, length: 400 mm, outer: 30 mm, material: steel, mass_damping: 200 1/s, "
     "flats: 28 mm, flats_angle: @25}",
     MACHINE_TURNS},
    {"segment",
     "disc: {at: rotor, outer: 200 mm, width: 10 mm}\n    - disc: {at: stator, outer: 100 mm, width: 10 mm}\n"
     "    - segment: {from: rotor, to: stator, length: 400 mm, outer: 30 mm, inner: 5 mm, outer_end: 25 mm, "
     "mass_damping: 200 1/s}",
     0},
    {"stage", "stage: {at: rotor, power: 4 kW, diameter: 400 mm, width: 20 mm}", MACHINE_NO_REST},
    {NULL, NULL, 0}};

// ---------------------------------------------------------------- units

#define LBF 4.4482216152605
#define LBM 0.45359237
#define INCH 0.0254

/// Inches, pounds of force and of mass, revolutions per minute.
const unit_pair units_inch[] = {{"mm", "in", 1.0 / 25.4},
                                {"um", "thou", 1.0 / 25.4},
                                {"mm2", "in2", 1.0 / (25.4 * 25.4)},
                                {"kg", "lbm", 1.0 / LBM},
                                {"kg/m3", "lbm/in3", INCH *INCH *INCH / LBM},
                                {"kg.m2", "lbm.in2", 1.0 / (LBM * INCH * INCH)},
                                {"g.m", "oz.in", 16e-3 / (LBM * INCH)},
                                {"N", "lbf", 1.0 / LBF},
                                {"N/m", "lbf/in", INCH / LBF},
                                {"MN/m", "lbf/in", 1e6 * INCH / LBF},
                                {"N.s/m", "lbf.s/in", INCH / LBF},
                                {"N/m3", "lbf/in3", INCH *INCH *INCH / LBF},
                                {"N.m", "lbf.in", 1.0 / (LBF * INCH)},
                                {"N.m/rad", "lbf.in/rad", 1.0 / (LBF * INCH)},
                                {"N.m.s/rad", "lbf.in.s/rad", 1.0 / (LBF * INCH)},
                                {"Pa", "psi", INCH *INCH / LBF},
                                {"MPa", "psi", 1e6 * INCH *INCH / LBF},
                                {"mPa.s", "reyn", 1e-3 * INCH *INCH / LBF},
                                {"kW", "lbf.in/s", 1e3 / (LBF * INCH)},
                                {"s/m", "s/in", INCH},
                                {"1/m", "1/in", INCH},
                                {"mm/s", "in/s", 1.0 / 25.4},
                                {"A/m", "A/in", INCH},
                                {"A/(m.s)", "A/(in.s)", INCH},
                                {"A.s/m", "A.s/in", INCH},
                                {"rad/s", "rpm", 60.0 / 6.283185307179586476925},
                                {NULL, NULL, 0.0}};

/// Feet and slugs.
const unit_pair units_feet[] = {{"mm", "ft", 1.0 / 304.8},
                                {"um", "ft", 1e-3 / 304.8},
                                {"mm2", "ft2", 1.0 / (304.8 * 304.8)},
                                {"kg", "slug", 0.3048 / LBF},
                                {"kg/m3", "slug/ft3", 0.3048 * 0.3048 * 0.3048 * 0.3048 / LBF},
                                {"kg.m2", "slug.ft2", 1.0 / (0.3048 * LBF)},
                                {"g.m", "slug.ft", 1e-3 / LBF},
                                {"N", "lbf", 1.0 / LBF},
                                {"N/m", "lbf/ft", 0.3048 / LBF},
                                {"MN/m", "lbf/ft", 1e6 * 0.3048 / LBF},
                                {"N.s/m", "lbf.s/ft", 0.3048 / LBF},
                                {"N.m", "lbf.ft", 1.0 / (LBF * 0.3048)},
                                {"MPa", "lbf/ft2", 1e6 * 0.3048 * 0.3048 / LBF},
                                {"mPa.s", "lbf.s/ft2", 1e-3 * 0.3048 * 0.3048 / LBF},
                                {"kW", "lbf.ft/s", 1e3 / (LBF * 0.3048)},
                                {"mm/s", "ft/s", 1.0 / 304.8},
                                {"deg", "rad", 6.283185307179586476925 / 360.0},
                                {NULL, NULL, 0.0}};

/// Millimetres, newtons and milliseconds: masses are N ms2/mm.
const unit_pair units_millimetre[] = {
    {"um", "mm", 1e-3},      {"kg", "N.ms2/mm", 1e3}, {"kg/m3", "N.ms2/mm4", 1e-6}, {"kg.m2", "N.ms2.mm", 1e9},
    {"g.m", "N.ms2", 1e3},   {"N/m", "N/mm", 1e-3},   {"MN/m", "N/mm", 1e3},        {"N.s/m", "N.ms/mm", 1.0},
    {"N/m3", "N/mm3", 1e-9}, {"N.m", "N.mm", 1e3},    {"N.m/rad", "N.mm/rad", 1e3}, {"N.m.s/rad", "N.mm.ms/rad", 1e6},
    {"Pa", "N/mm2", 1e-6},   {"MPa", "N/mm2", 1.0},   {"mPa.s", "N.ms/mm2", 1e-6},  {"kW", "N.mm/ms", 1e3},
    {"s/m", "ms/mm", 1.0},   {"mm/s", "mm/ms", 1e-3}, {"rad/s", "rad/ms", 1e-3},    {NULL, NULL, 0.0}};

/// Numbers without a unit, in SI.
const unit_pair units_si[] = {
    {"mm", "", 1e-3},     {"um", "", 1e-6},     {"mm2", "", 1e-6},      {"kg", "", 1.0},
    {"kg/m3", "", 1.0},   {"kg.m2", "", 1.0},   {"g.m", "", 1e-3},      {"N", "", 1.0},
    {"N/m", "", 1.0},     {"MN/m", "", 1e6},    {"N.s/m", "", 1.0},     {"N/m3", "", 1.0},
    {"N.m", "", 1.0},     {"N.m/rad", "", 1.0}, {"N.m.s/rad", "", 1.0}, {"Pa", "", 1.0},
    {"MPa", "", 1e6},     {"mPa.s", "", 1e-3},  {"kW", "", 1e3},        {"s/m", "", 1.0},
    {"1/m", "", 1.0},     {"1/s", "", 1.0},     {"A", "", 1.0},         {"A/m", "", 1.0},
    {"A/(m.s)", "", 1.0}, {"A.s/m", "", 1.0},   {"ms", "", 1e-3},       {"deg", "", 6.283185307179586476925 / 360.0},
    {NULL, NULL, 0.0}};

// ---------------------------------------------------------------- texts

/// A text that grows in a buffer of MACHINE_TEXT characters.
typedef struct text_end {
    char *at;
    size_t room;
} text_end;

static void text_add(text_end *to, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(to->at, to->room, format, arguments);
    va_end(arguments);
    if (length < 0 || (size_t)length >= to->room) fail_msg("a machine's text is too long");
    to->at += length;
    to->room -= (size_t)length;
}

/// Adds lines, the last one first where `reversed`.
static void text_add_lines(text_end *to, const char *lines, bool reversed) {
    const char *starts[64];
    size_t count = 0;
    for (const char *line = lines; *line; line = strchr(line, '\n') + 1) {
        assert_true(count < sizeof starts / sizeof *starts);
        starts[count++] = line;
    }
    for (size_t i = 0; i < count; i++) {
        const char *line = starts[reversed ? count - 1 - i : i];
        text_add(to, "%.*s", (int)(strchr(line, '\n') + 1 - line), line);
    }
}

/// Returns the number at the beginning of a text, and its length in characters; length 0 if there is none.
static double number_at(const char *text, size_t *length) {
    char *end;
    const double number = strtod(text, &end);
    *length = (size_t)(end - text);
    return number;
}

/// Writes `@40` as an angle and `~3` as a number, of the machine or of its mirror image.
static void text_resolve(const char *from, bool mirrored, text_end *to) {
    for (; *from; from++) {
        size_t length = 0;
        const double number = *from == '@' || *from == '~' ? number_at(from + 1, &length) : 0.0;
        if (*from == '@')
            text_add(to, "%.17g deg", mirrored ? 180.0 - number : number);
        else if (*from == '~')
            text_add(to, "%.17g", mirrored ? -number : number);
        else
            text_add(to, "%c", *from);
        from += length;
    }
}

static const unit_pair *unit_find(const unit_pair *units, const char *name, size_t length) {
    for (; units->unit; units++)
        if (strlen(units->unit) == length && strncmp(units->unit, name, length) == 0) return units;
    return NULL;
}

/// Writes every number that has a unit of the table in the other unit.
static void text_convert(const char *text, const unit_pair *units, text_end *to) {
    char before = '\n';
    for (const char *from = text; *from;) {
        size_t length = 0, unit = 0;
        const bool begins = (before == ' ' || before == '[') && (isdigit((unsigned char)*from) || *from == '-');
        const double number = begins ? number_at(from, &length) : 0.0;
        const unit_pair *pair = NULL;
        if (length > 0 && from[length] == ' ') {
            unit = strcspn(from + length + 1, ",}]\n");
            pair = unit_find(units, from + length + 1, unit);
        }
        if (pair) {
            text_add(to, "%.17g%s%s", number * pair->factor, *pair->other ? " " : "", pair->other);
            length += 1 + unit;
        } else {
            length = length > 0 ? length : 1;
            text_add(to, "%.*s", (int)length, from);
        }
        from += length;
        before = from[-1];
    }
}

void machine_text(const element_machine *of, machine_view as, const char *study, char text[MACHINE_TEXT]) {
    static const char stations[] =
        "    rotor: {mass: 10 kg, damping: 900 N.s/m, eccentricity: 20 um, eccentricity_angle: @60}\n"
        "    stator: {mass: 2 kg, damping: 3000 N.s/m}\n";
    static const char twisting[] =
        "    rotor: {mass: 10 kg, damping: 900 N.s/m, eccentricity: 20 um, eccentricity_angle: @60, polar: 0.05 kg.m2, "
        "moves: all}\n"
        "    stator: {mass: 2 kg, damping: 3000 N.s/m, polar: 0.02 kg.m2, moves: all}\n";
    static const char axial[] =
        "    rotor: {mass: 10 kg, damping: 900 N.s/m, eccentricity: 20 um, eccentricity_angle: @60, polar: 0.05 kg.m2, "
        "moves: all, axial: yes}\n"
        "    stator: {mass: 2 kg, damping: 3000 N.s/m, polar: 0.02 kg.m2, moves: all, axial: yes}\n";
    char own[MACHINE_TEXT], elements[MACHINE_TEXT], resolved[MACHINE_TEXT];
    text_end e = {elements, sizeof elements}, o = {own, sizeof own}, r = {resolved, sizeof resolved};
    text_add(&e,
             "    - spring: {between: [stator, ground], stiffness: 8 MN/m}\n"
             "    - spring: {between: [rotor, ground], stiffness: 4 MN/m}\n"
             "    - bearing: {at: rotor, kxx: 0.1 MN/m, kxy: ~0.2 MN/m, kyx: ~0.1 MN/m, kyy: 0.7 MN/m}\n"
             "    - spring: {between: [stator, ground], along: y, stiffness: 1.9 MN/m}\n%s    - %s\n",
             strcmp(of->name, "gravity") == 0 ? "" : "    - gravity: {}\n", of->element);
    text_add(&o, "whirl: 1\nparameters: {n: 900 rad/s}\nrotor:\n  speed: = n\n  rotation: %s\n  length_scale: %s\n",
             as.mirrored ? "clockwise" : "counter-clockwise", as.length ? as.length : "0.1 mm");
    text_add(&o, "  stations:\n");
    text_add_lines(&o,
                   of->flags & MACHINE_AXIAL    ? axial
                   : of->flags & MACHINE_TWISTS ? twisting
                                                : stations,
                   as.reversed);
    text_add(&o, "  elements:\n");
    text_add_lines(&o, elements, as.reversed);
    text_add(&o, "study:\n%s", study);
    text_resolve(own, as.mirrored, &r);
    text_end t = {text, MACHINE_TEXT};
    if (as.units)
        text_convert(resolved, as.units, &t);
    else
        text_add(&t, "%s", resolved);
}
