// Where motions of shafts of finite elements begin: what lies between stations follows these, reduced or not.
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
#include "support_flow.h"
#include "whirl/engine.h"

static const double pi = 3.14159265358979323846;

/// Makes the machine of a case at its first point, from start `which`.
static whirl_machine machine_of(const char *rotor, const char *study, size_t which) {
    char text[8192];
    whirl_case *object;
    whirl_study content;
    whirl_machine machine;
    const int length = snprintf(text, sizeof text, "whirl: 1\nrotor:\n%s\nstudy:\n%s\n", rotor, study);
    assert_true(length > 0 && (size_t)length < sizeof text);
    require_ok(whirl_case_parse(text, (size_t)length, "text", NULL, &object));
    require_ok(whirl_case_study(object, &content));
    content.batches[0].start = which;
    require_ok(content.machine(content.family, &content.batches[0], (double)NAN, &machine));
    whirl_case_free(object);
    return machine;
}

static void assert_near(double expected, double obtained, double tolerance) {
    if (!(fabs(obtained - expected) <= tolerance)) fail_msg("expected %.6g, obtained %.6g", expected, obtained);
}

/// Computes displacements along y of the first `count` stations after a revolution.
static void displacements_after(const whirl_machine *machine, size_t count, double *y) {
    const whirl_system *system = machine->system;
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    double *x = malloc(system->dimension * sizeof *x);
    memcpy(x, machine->start, system->dimension * sizeof *x);
    strcpy(options.method, "rodas5p");
    options.rtol = 3e-6;
    options.atol = 3e-8;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    revolve(integrator, x, 1);
    for (size_t s = 0; s < count; s++) y[s] = x[system->probes[s].y];
    whirl_integrator_free(integrator);
    free(x);
}

// ---------------------------------------------------------------- a straight shaft let go

/// The shaft of steel, 1.2 m long and 60 mm thick, on two springs of 1e5 N/m.
static const char *const straight = "  speed: 3000 rpm\n  length_scale: 0.1 mm\n  shafts: {main: {%s}}\n"
                                    "  stations:\n    left: {position: 0 m}\n    mid: {position: 0.6 m}\n"
                                    "    right: {position: 1.2 m}\n  elements:\n"
                                    "    - segment: {length: 1.2 m, outer: 60 mm, elements: 6}\n"
                                    "    - bearing: {at: left, kxx: 1e5 N/m}\n    - bearing: {at: right, kxx: 1e5 N/m}";

/// Displacements of its middle and its ends at t, let go at -0.3 at rest, by its rigid motion and the first symmetric
/// mode of a free Euler beam: w^2 = 4.73004^4 EI/(m L^3), as heavy as the shaft where its ends move by 2 and its middle
/// by -1.2157. Further modes and shear change them by less than 1e-3.
static void bounce(double t, double *middle, double *end) {
    const double area = pi / 4.0 * 0.06 * 0.06, mass = 7810.0 * area * 1.2, ei = 2.11e11 * area * 0.06 * 0.06 / 16.0;
    const double soft = 2e5 / mass, bent = pow(4.73004, 4.0) * ei / (mass * 1.2 * 1.2 * 1.2);
    const double turn = 0.5 * atan2(4.0 * soft, soft - (bent + 4.0 * soft)), c = cos(turn), s = sin(turn);
    const double mean = 0.5 * (bent + 5.0 * soft), half = hypot(0.5 * (bent + 3.0 * soft), 2.0 * soft);
    const double one = -0.3 * c * cos(sqrt(mean + half) * t), other = -0.3 * s * cos(sqrt(mean - half) * t);
    const double rigid = one * c + other * s, bend = one * s - other * c;
    *middle = rigid - 1.2157 * bend;
    *end = rigid + 2.0 * bend;
}

static void reduced_shaft_start(void **state) {
    static const char *const kinds[] = {"", "modes: 1", "reduce: no"};
    double y[3], middle, end;
    (void)state;
    bounce(60.0 / 3000.0, &middle, &end);
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        char rotor[2048];
        snprintf(rotor, sizeof rotor, straight, kinds[k]);
        whirl_machine machine =
            machine_of(rotor, "  response: {}\n  initial: {left: {y: -0.3}, mid: {y: -0.3}, right: {y: -0.3}}", 0);
        displacements_after(&machine, 3, y);
        assert_near(end, y[0], 1e-3);
        assert_near(middle, y[1], 1e-3);
        assert_near(end, y[2], 1e-3);
        machine.release(machine.owner);
    }
}

/// Returns the largest rate of a velocity where a motion begins.
static double largest_acceleration(const whirl_machine *machine) {
    const size_t n = machine->system->dimension;
    double *slope = calloc(n, sizeof *slope), largest = 0.0;
    evaluate_rhs(machine->system, 0.0, machine->start, slope);
    for (size_t i = n / 2; i < n; i++) largest = fmax(largest, fabs(slope[i]));
    free(slope);
    return largest;
}

/// A shaft that floats and is displaced or tilted as a rigid body feels nothing, whatever is kept of it, with stations
/// anywhere on it and a disc on one: by `initial`, with velocities, by a further start (a half, a third and a fifth
/// into its ranges). Bent by a tenth in the middle it feels much.
static void a_straight_shaft_feels_nothing(void **state) {
    static const char *const kinds[] = {"", "modes: 2", "reduce: no"};
    static const char *const studies[] = {
        "  response: {}\n  initial: {a: {x: 0.2, y: -0.3}, b: {x: 0.3, y: -0.1}, c: {x: 0.45, y: 0.2}}",
        "  response: {}\n  initial: {a: {vx: 0.2}, b: {vx: 0.2}, c: {vx: 0.2}}",
        "  response: {}\n  starts: {count: 2, within: {a: {y: [0, 0.6]}, b: {y: [0, 0.9]}, c: {y: [0, 1.5]}}}",
        "  response: {}\n  initial: {b: {x: 0.1}}"};
    (void)state;
    for (size_t k = 0; k < 3; k++)
        for (size_t s = 0; s < 4; s++) {
            char rotor[2048];
            snprintf(rotor, sizeof rotor,
                     "  speed: 100 rad/s\n  length_scale: 0.1 mm\n  shafts: {main: {%s}}\n  stations:\n"
                     "    a: {position: 0.1 m}\n    b: {position: 0.3 m}\n    c: {position: 0.6 m}\n  elements:\n"
                     "    - segment: {length: 0.7 m, outer: 40 mm, elements: 9}\n"
                     "    - disc: {at: c, outer: 200 mm, inner: 40 mm, width: 20 mm}",
                     kinds[k]);
            whirl_machine machine = machine_of(rotor, studies[s], s == 2);
            const double felt = largest_acceleration(&machine);
            assert_true(s == 3 ? felt > 1.0 : felt < 1e-4);
            machine.release(machine.owner);
        }
}

/// A single station on a shaft carries all of it along; so do two shafts their own nodes, on one case.
static void every_shaft_follows_its_own_stations(void **state) {
    static const char *const rotor =
        "  speed: 100 rad/s\n  length_scale: 0.1 mm\n  shafts: {one: {}, two: {ratio: 1.5, reduce: no}}\n"
        "  stations:\n    a: {shaft: one, position: 0.1 m}\n    b: {shaft: two, position: 0 m}\n"
        "    c: {shaft: two, position: 0.4 m}\n  elements:\n"
        "    - segment: {shaft: one, length: 0.7 m, outer: 40 mm, elements: 5}\n"
        "    - segment: {shaft: two, length: 0.5 m, outer: 80 mm, inner: 60 mm, elements: 5}";
    (void)state;
    whirl_machine machine = machine_of(rotor, "  response: {}\n  initial: {a: {x: 0.2}, b: {y: -0.4}, c: {y: 0.4}}", 0);
    assert_true(largest_acceleration(&machine) < 1e-4);
    machine.release(machine.owner);
}

/// A shaft that starts bent and moving goes the same way with all of its nodes and with all of its modes, which say the
/// same; with the lowest ones nearly so.
static void reduced_and_full_shafts_go_the_same_way(void **state) {
    static const char *const kinds[] = {"reduce: no", "modes: 40", ""};
    double y[3][3];
    (void)state;
    for (size_t k = 0; k < 3; k++) {
        char rotor[2048];
        snprintf(rotor, sizeof rotor,
                 "  speed: 3000 rpm\n  length_scale: 0.1 mm\n  shafts: {main: {%s}}\n  stations:\n"
                 "    left: {position: 0 m}\n    disc: {position: 0.5 m}\n    right: {position: 1.2 m}\n  elements:\n"
                 "    - segment: {length: 1.2 m, outer: 60 mm, elements: 6}\n"
                 "    - disc: {at: disc, outer: 300 mm, inner: 60 mm, width: 30 mm}\n"
                 "    - bearing: {at: left, kxx: 1e6 N/m}\n    - bearing: {at: right, kxx: 2e6 N/m}",
                 kinds[k]);
        whirl_machine machine =
            machine_of(rotor, "  response: {}\n  initial: {left: {y: 0.5}, disc: {y: -1, vx: 0.3}}", 0);
        displacements_after(&machine, 3, y[k]);
        machine.release(machine.owner);
    }
    for (size_t s = 0; s < 3; s++) {
        assert_near(y[0][s], y[1][s], 1e-4);
        assert_near(y[0][s], y[2][s], 3e-3);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(reduced_shaft_start),
                                       cmocka_unit_test(a_straight_shaft_feels_nothing),
                                       cmocka_unit_test(every_shaft_follows_its_own_stations),
                                       cmocka_unit_test(reduced_and_full_shafts_go_the_same_way)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
