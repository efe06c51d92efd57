// Elements with states and laws of their own have the same bits in all instruction sets that fuse, and in all that do
// not.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/case.h"
#include "whirl/engine/ensemble.h"

static const char frame[] = "whirl: 1\n"
                            "rotor:\n"
                            "  speed: 9000 rpm\n"
                            "  length_scale: 0.1 mm\n"
                            "  stations:\n"
                            "    rotor:  {mass: 10 kg, damping: 500 N.s/m, eccentricity: 40 um}\n"
                            "    stator: {mass: 2 kg, damping: 3 kN.s/m}\n"
                            "  elements:\n"
                            "    - spring: {between: [stator, ground], stiffness: 8 MN/m}\n"
                            "    - spring: {between: [rotor, ground], stiffness: 4 MN/m}\n"
                            "    - gravity\n"
                            "    - %s\n"
                            "study: {response: {}}\n";

#define STATOR "at: rotor, from: stator, gap: 60 um, stiffness: 3e9, radius: 40 mm, friction: 0.1"
#define TILTING                                                                                                        \
    "disc: {at: rotor, outer: 0.2 m, width: 10 mm}\n    - disc: {at: stator, outer: 0.1 m, width: 10 mm}\n"            \
    "    - spring: {between: [rotor, ground], along: tilts, stiffness: 3e4, damping: 9}\n"                             \
    "    - spring: {between: [stator, ground], along: tilts, stiffness: 3e4, damping: 9}\n    - "
static const char *const elements[] = {
    "magnetic: {at: rotor, from: stator, gap: 0.5 mm, bias: 3 A, turns: 120, area: 4 cm2, max_current: 5 A, "
    "proportional: 2e4, integral: 1e5, derivative: 40, derivative_filter: 0.2 ms, numerator: [1, 60, 4e6], "
    "denominator: [1, 900, 4e6], sensor_bandwidth: 4 kHz, amplifier_bandwidth: 2 kHz, fails_after: 2}",
    "contact: {" STATOR ", law: hunt_crossley, loss: 0.5, friction_law: stribeck, static_friction: 0.2, "
    "stribeck_speed: 0.1 m/s, arc: 200 deg, arc_middle: -1 rad}",
    "contact: {" STATOR ", friction_law: lugre, static_friction: 0.2, stribeck_speed: 0.1 m/s, bristle_stiffness: 100, "
    "bristle_damping: 0.01}",
    "pad_bearing: {at: rotor, from: stator, shape: offset-half, preload: 0.5, clearance: 0.2 mm, viscosity: 10 mPa.s, "
    "radius: 25 mm, length: 25 mm}",
    "tilting_pad: {at: rotor, from: stator, shape: tilting-5, preload: 0.5, clearance: 0.2 mm, viscosity: 10 mPa.s, "
    "radius: 25 mm, length: 25 mm, inertia: 1e-4 kg m2}",
    "tilting_pad: {at: rotor, from: stator, shape: tilting-5, preload: 0.5, clearance: 0.2 mm, viscosity: 10 mPa.s, "
    "radius: 25 mm, length: 25 mm, tilt_stiffness: 10 N.m/rad}",
    "tilting_pad: {at: rotor, from: stator, shape: tilting-5, preload: 0.5, clearance: 0.2 mm, viscosity: 10 mPa.s, "
    "radius: 25 mm, length: 25 mm, tilt_stiffness: 10 N.m/rad, pivot_stiffness: 1e7, pad_mass: 0.2}",
    TILTING "coupling: {between: [rotor, stator], radial: 1e5, tilt: 900, face_kink: 1 mrad, bore_offset: 10 um}\n"
            "    - coupling_load: {between: [rotor, stator], distance: 50 mm, x1: 0.1 mm, y2: 0.3 mm, torque: 200, "
            "bending_stiffness: 150, orders: [1, 0.5, 0.25, 0.2, 0.1], phase: 0.4}\n"
            "    - joint: {between: [rotor, stator], bend: 10 deg, torque: 500, direction: 0.3, yoke: 0.2}\n"
            "    - unbalance_grade: {planes: [rotor, stator], grade: 40, service_speed: 900 rad/s, mass: 12 kg, "
            "to_first: 0.2 m, to_second: 0.5 m, second_angle: 1}",
    TILTING "spring: {between: [rotor, stator], along: tilts, stiffness: 2e4, damping: 3, gap_angle: 0.1 mrad}\n"
            "    - cubic_spring: {between: [rotor, stator], stiffness: 1 MN/m, cubic: 1e15, damping: 300}\n"
            "    - cubic_spring: {between: [rotor, stator], along: tilt_x, cubic: 1e9}\n"
            "    - friction: {between: [rotor, stator], force: 60, slip_speed: 5 mm/s}\n"
            "    - friction: {between: [rotor, stator], along: tilt_y, moment: 0.2}",
    "blade_rub: {at: rotor, from: stator, blades: 5, radius: 0.3 m, gap: 60 um, stiffness: 2e7, friction: 0.1, "
    "extension: [20 um, 0 m, 0 m, 5 um, 0 m]}",
    "bearing: {at: rotor, from: stator, elevation: 20 um, frequencies: [0, 200, 400, 600, 800, 1000, 1200, 1400], "
    "kxx: [4e6, 4.2e6, 4.7e6, 5.3e6, 5.8e6, 6.2e6, 6.5e6, 6.7e6], kxy: [1e6, 9e5, 7e5, 5e5, 4e5, 3e5, 2e5, 1e5], "
    "cxx: [4e3, 3.6e3, 3e3, 2.2e3, 1.6e3, 1.2e3, 9e2, 7e2], cyx: -300, poles: 6, fit_error: 20 %}"};
enum { ELEMENTS = sizeof elements / sizeof *elements, LANES = 5, REVOLUTIONS = 3, MAX_DIMENSION = 64 };

static void must(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

/// Computes the states of all lanes by one instruction set; returns false if the processor lacks it.
static bool carry(const char *isa, const char *method, const char *element, double *x) {
    char text[2048];
    whirl_integrate_options options = whirl_integrate_default();
    whirl_case *object;
    whirl_rotor *rotor;
    whirl_ensemble *lanes;
    snprintf(options.method, sizeof options.method, "%s", method);
    options.rtol = 1e-6; // fewer steps, of which each does the same
    snprintf(text, sizeof text, frame, element);
    must(whirl_case_parse(text, strlen(text), "element", NULL, &object));
    must(whirl_case_rotor(object, NULL, NAN, &rotor));
    const whirl_system *system = whirl_rotor_system(rotor);
    assert_true(system->dimension <= MAX_DIMENSION);
    setenv("WHIRL_ISA", isa, 1);
    const bool present = whirl_ensemble_new(system, &options, LANES, &lanes).code == WHIRL_OK;
    for (size_t i = 0; i < LANES && present; i++) {
        const double start[MAX_DIMENSION] = {0.1, -0.1 * (double)i, 0.0, -0.1};
        must(whirl_ensemble_load(lanes, i, system, start));
    }
    for (int n = 0; n < REVOLUTIONS && present; n++) whirl_ensemble_revolve(lanes, LANES, NULL);
    for (size_t i = 0; i < LANES && present; i++) whirl_ensemble_state(lanes, i, x + i * MAX_DIMENSION);
    if (present) whirl_ensemble_free(lanes);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
    return present;
}

static void the_same_bits(void **state) {
    static const char *const sets[2][3] = {{"fma", "avx2", "avx512"}, {"scalar", "simd128", NULL}};
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    (void)state;
    for (int e = 0; e < ELEMENTS; e++)
        for (int m = 0; m < 3; m++)
            for (int s = 0; s < 2; s++) {
                static double first[LANES * MAX_DIMENSION], x[LANES * MAX_DIMENSION];
                bool any = false;
                for (int i = 0; i < 3 && sets[s][i]; i++) {
                    if (!carry(sets[s][i], methods[m], elements[e], x)) continue;
                    if (any && memcmp(first, x, sizeof x) != 0)
                        fail_msg("%.12s by %s differs by %s", elements[e], methods[m], sets[s][i]);
                    memcpy(first, x, sizeof x);
                    any = true;
                }
            }
    unsetenv("WHIRL_ISA");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_same_bits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
