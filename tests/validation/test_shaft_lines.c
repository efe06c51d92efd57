// Lines of shafts between their stations (whirl/internal/line.h), against closed forms of uniform beams: modes of a
// beam on two stiff bearings, its sag, and a Timoshenko beam bent by a force at its end.
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
#include "whirl/engine/case.h"
#include "whirl/engine/linear.h"
#include "whirl/internal/line.h"

enum { TEXT_SIZE = 2048 };
static const double pi = 3.14159265358979323846;
static const double modulus = 2.1e11, density = 7800.0, poisson = 0.3;

/// Makes a slender beam, 50 times as long as thick, of a length from 0 on, on bearings of 1 TN/m at both ends, with one
/// more station off its middle; `shaft`: keys of the shaft, `elements` of its mesh.
static whirl_case *beam(double length, const char *shaft, int elements, const char *more, const char *study) {
    char text[TEXT_SIZE];
    whirl_case *object;
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 1e-3 rad/s\n  length_scale: 1 mm\n"
             "  materials: {steel: {modulus: %.17g Pa, poisson: %g, density: %g kg/m3}}\n"
             "  shafts: {main: {material: steel, rotary_inertia: no, gyroscopic: no, %s}}\n"
             "  stations:\n    left: {position: 0 m}\n    beside: {position: %.17g m}\n    right: {position: %.17g m}\n"
             "  elements:\n    - segment: {length: %.17g m, outer: %g m, elements: %d}\n"
             "    - bearing: {at: left, kxx: 1e12 N/m}\n    - bearing: {at: right, kxx: 1e12 N/m}\n%s"
             "study:\n  %s\n",
             modulus, poisson, density, shaft, 0.3 * length, length, length, 0.02 * length, elements, more, study);
    require_ok(whirl_case_parse(text, strlen(text), "beam", NULL, &object));
    return object;
}

/// Checks the line of a mode, over its displacement at `beside`, against sin(n pi z/L). The tolerance is the error of
/// cubics between nodes h apart, (n pi h/L)^4/384, and a tenth more, since the nodes are not exact either.
static void expect_sines(const char *what, double length, const char *shaft, int elements) {
    whirl_case *object = beam(length, shaft, elements, "", "modes: {count: 8}");
    whirl_study study;
    whirl_machine machine;
    whirl_modes *modes;
    whirl_shaft_line line;
    require_ok(whirl_case_study(object, &study));
    require_ok(study.machine(study.family, &study.batches[0], 0.0, &machine));
    require_ok(whirl_case_line(object, &study.batches[0], 0.0, &line));
    require_ok(whirl_modes_new(machine.system, machine.start, &modes));
    assert_true(line.count > 90 && line.position[0] == 0.0);
    for (int n = 1; n <= 3; n++) {
        // Of the pair along x and y, the mixture that the solver returns: each plane is scaled by its own station.
        const double *mode = modes->vectors + 2 * (size_t)(2 * (n - 1)) * modes->dimension;
        const whirl_probe *beside = &machine.system->probes[1];
        const int axis =
            hypot(mode[2 * beside->x], mode[2 * beside->x + 1]) < hypot(mode[2 * beside->y], mode[2 * beside->y + 1]);
        const double *own = mode + 2 * (axis == 0 ? beside->x : beside->y);
        const int part = fabs(own[1]) > fabs(own[0]);
        double worst = 0.0;
        for (size_t i = 0; i < line.count; i++) {
            const double shape = whirl_shaft_line_at(&line, i, axis, mode + part, 2) / machine.length / own[part];
            const double sine = sin(n * pi * line.position[i] / length) / sin(0.3 * n * pi);
            worst = fmax(worst, fabs(shape - sine));
        }
        const double cubics = pow(n * pi / elements, 4.0) / 384.0 / fabs(sin(0.3 * n * pi));
        check_within("B14", words("%s: line of mode %d from the sine, over that at 0.3 L", what, n), 0.0, worst,
                     1.1 * cubics);
    }
    whirl_modes_free(modes);
    whirl_shaft_line_free(&line);
    machine.release(machine.owner);
    whirl_case_free(object);
}

static void modes_are_sines(void **unused) {
    (void)unused;
    expect_sines("8 elements", 1.0, "shear: none, reduce: no", 8);
    expect_sines("32 elements", 1.0, "shear: none, reduce: no", 32);
    expect_sines("32 elements, reduced", 1.0, "shear: none, modes: 40", 32);
    expect_sines("32 elements, of a tenth of the length", 0.1, "shear: none, reduce: no", 32);
}

/// w = q z (L^3 - 2 L z^2 + z^3)/(24 EI), between nodes less the bubble q h^4/(384 EI) that cubic shapes have not.
static void sag_is_that_of_a_beam(void **unused) {
    const double length = 1.0, diameter = 0.02, second = pi * pow(diameter, 4.0) / 64.0;
    const double q = 9.80665 * density * pi * diameter * diameter / 4.0, bending = modulus * second;
    whirl_case *object = beam(length, "shear: none", 20, "    - gravity: {}\n", "statics: {}");
    whirl_study study;
    whirl_shaft_line line;
    double worst = 0.0;
    (void)unused;
    require_ok(whirl_case_study(object, &study));
    study.batches[0].variant = WHIRL_WITH_STATICS;
    require_ok(whirl_case_line(object, &study.batches[0], 0.0, &line));
    assert_non_null(line.sag);
    for (size_t i = 0; i < line.count; i++) {
        const double z = line.position[i];
        const double sag = q * z * (pow(length, 3.0) - 2.0 * length * z * z + z * z * z) / (24.0 * bending);
        worst = fmax(worst, fabs(line.sag[i] + sag));
    }
    const double middle = 5.0 * q * pow(length, 4.0) / (384.0 * bending);
    check_within("B14", "sag of a uniform beam along its line, over that of its middle", 0.0, worst / middle, 3e-6);
    whirl_shaft_line_free(&line);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(modes_are_sines), cmocka_unit_test(sag_is_that_of_a_beam)};
    return cmocka_run_group_tests_name("shaft lines", tests, NULL, NULL);
}
