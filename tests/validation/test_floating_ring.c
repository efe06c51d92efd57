// A floating ring: where it rests and how fast it turns, its derivatives, and a motion by two methods.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"

/// A journal at 8000 rad/s, with 5 N or none, in a ring without weight: speeds and places by Brent's method on the
/// closed forms of both short films and of Petroff's drag.
static const double speed = 8000.0, load = 5.0, mass[2] = {0.5, 0.01}, inertia = 4e-7;
static const double clearance[2] = {20e-6, 45e-6}, radius[2] = {0.005, 0.008}, length[2] = {0.006, 0.010},
                    viscosity[2] = {0.012, 0.016};

enum { POSITIONS = 4, RING_STATE = 8, DIMENSION = 9 };

static whirl_rotor *make_light(double turning, double ring_mass, double gravity) {
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(turning, clearance[0], &design));
    require_ok(whirl_design_station(design, "journal", (whirl_setting[]){{"mass", mass[0], NULL}}, 1));
    require_ok(whirl_design_station(design, "ring", (whirl_setting[]){{"mass", ring_mass, NULL}}, 1));
    const whirl_setting ring[] = {{"at", 0.0, "journal"},
                                  {"ring", 0.0, "ring"},
                                  {"inertia", inertia, NULL},
                                  {"clearance", clearance[0], NULL},
                                  {"radius", radius[0], NULL},
                                  {"length", length[0], NULL},
                                  {"viscosity", viscosity[0], NULL},
                                  {"outer_clearance", clearance[1], NULL},
                                  {"outer_radius", radius[1], NULL},
                                  {"outer_length", length[1], NULL},
                                  {"outer_viscosity", viscosity[1], NULL}};
    require_ok(whirl_design_element(design, "floating_ring", ring, sizeof ring / sizeof *ring));
    const whirl_setting weight[] = {{"acceleration", gravity, NULL}};
    if (gravity > 0.0) require_ok(whirl_design_element(design, "gravity", weight, 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

static whirl_rotor *make_ring(double turning) {
    return make_light(turning, mass[1], 0.0);
}

/// Returns the ring's speed with ring and journal in the middle; *fading: decay rate of deviations from it, per radian.
static double concentric(double *fading) {
    double drag[2];
    for (int i = 0; i < 2; i++)
        drag[i] = 6.28318530717958647692 * viscosity[i] * pow(radius[i], 3.0) * length[i] / clearance[i];
    *fading = (drag[0] + drag[1]) / (inertia * speed);
    return drag[0] / (drag[0] + drag[1]);
}

/// Finds the places and the ring's speed at which both films carry `weight` along y, by Newton's method from x.
static void settle(const whirl_system *system, double weight, double x[DIMENSION]) {
    static const size_t row[5] = {4, 5, 6, 7, 8}, column[5] = {0, 1, 2, 3, RING_STATE};
    for (int n = 0; n < 30; n++) {
        double slope[DIMENSION], full[DIMENSION * DIMENSION], matrix[25], step[5];
        evaluate_rhs(system, 0.0, x, slope);
        exact_jacobian(system, 0.0, x, full);
        slope[5] -= weight / (mass[0] * clearance[0] * speed * speed);
        for (int i = 0; i < 5; i++) {
            step[i] = slope[row[i]];
            for (int j = 0; j < 5; j++) matrix[5 * i + j] = full[DIMENSION * row[i] + column[j]];
        }
        solve_linear(5, matrix, step);
        for (int i = 0; i < 5; i++) x[column[i]] -= step[i];
    }
}

static void rest(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_ring(speed);
    const whirl_system *system = whirl_rotor_system(rotor);
    double fading, x[DIMENSION] = {0.0, -0.15, 0.0, -0.1}, slope[DIMENSION];
    const double middle = concentric(&fading);
    check_digits("floating-ring", "speed of the ring over the shaft's, concentric", ".1981990799647646", middle);
    evaluate_rhs(system, 0.0, (double[DIMENSION]){0.0}, slope);
    check_within("floating-ring", "its acceleration then", 0.0, slope[RING_STATE], 1e-15);
    settle(system, load, x);
    const double outside = clearance[1] / clearance[0];
    check_within("floating-ring", "under 5 N: speed of the ring over the shaft's", .1979163017328195,
                 middle + x[RING_STATE], 1e-13);
    check_within("floating-ring", "eccentricity ratio of the journal in the ring", .020483188693214,
                 hypot(x[0] - x[2], x[1] - x[3]), 3e-13);
    check_within("floating-ring", "eccentricity ratio of the ring", .063027655823096, hypot(x[2], x[3]) / outside,
                 3e-13);
    whirl_rotor_free(rotor);
}

/// The equilibrium does not depend on the mass of a ring without weight, and is found for any mass. Accelerations of
/// the lightest ring, and their rounding errors, are 1e12 times those of the journal.
static void light_rings(void **unused) {
    (void)unused;
    static const double light[] = {1e-6, 1e-8, 1e-9, 1e-10, 1e-12};
    for (size_t i = 0; i < sizeof light / sizeof *light; i++) {
        whirl_rotor *rotor = make_light(speed, light[i], load / mass[0]);
        double x[DIMENSION] = {0.0};
        require_ok(whirl_equilibrium(whirl_rotor_system(rotor), x));
        // The ring weighs 2e-6 of the load where it has 1 mg.
        check_within("floating-ring", words("ring of %g kg: eccentricity ratio of the journal in it", light[i]),
                     .020483188693214, hypot(x[0] - x[2], x[1] - x[3]), 1e-10 + 2.0 * light[i]);
        check_within("floating-ring", words("ring of %g kg: eccentricity ratio of the ring", light[i]),
                     .063027655823096, hypot(x[2], x[3]) * clearance[0] / clearance[1], 1e-10 + 2.0 * light[i]);
        whirl_rotor_free(rotor);
    }
}

static void spin(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_ring(speed);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 512);
    double fading, x[DIMENSION] = {0.0};
    concentric(&fading);
    x[RING_STATE] = -0.15;
    revolve(integrator, x, 2);
    check_within("floating-ring", "two revolutions after the ring was too slow by .15: remaining difference",
                 -0.15 * exp(-fading * 12.566370614359172), x[RING_STATE], 1e-13);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

static void derivatives(void **unused) {
    (void)unused;
    static const double turning[] = {8000.0, -8000.0};
    uint64_t seed = 5u;
    for (int way = 0; way < 2; way++) {
        whirl_rotor *rotor = make_ring(turning[way]);
        const whirl_system *system = whirl_rotor_system(rotor);
        double worst = 0.0;
        for (int trial = 0; trial < 50; trial++) {
            double x[DIMENSION], exact[DIMENSION * DIMENSION], differences[DIMENSION * DIMENSION], trace = 0.0;
            for (int i = 0; i < DIMENSION; i++) {
                seed = seed * 6364136223846793005u + 1442695040888963407u;
                x[i] = 0.7 * ((double)(seed >> 11) / 4503599627370496.0 - 1.0);
            }
            x[0] = x[2] + 0.8 * x[0];
            exact_jacobian(system, 0.0, x, exact);
            rhs_jacobian(system, 0.0, x, 5e-4, differences);
            for (int i = POSITIONS; i < DIMENSION; i++) {
                double largest = 0.0;
                for (int j = 0; j < DIMENSION; j++) largest = fmax(largest, fabs(exact[DIMENSION * i + j]));
                for (int j = 0; j < DIMENSION; j++)
                    worst = fmax(worst, fabs(exact[DIMENSION * i + j] - differences[DIMENSION * i + j]) / largest);
            }
            for (int i = 0; i < DIMENSION; i++) trace += exact[(DIMENSION + 1) * i];
            const double sum = system->divergence(system->model, 0.0, (double[16]){1.0}, x, NULL);
            worst = fmax(worst, fabs(sum - trace) / fabs(trace));
        }
        check_within("floating-ring",
                     words("turning %s: exact Jacobian and divergence from differences",
                           way ? "clockwise" : "counter-clockwise"),
                     0.0, worst, 1e-8);
        whirl_rotor_free(rotor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rest), cmocka_unit_test(light_rings), cmocka_unit_test(spin),
                                       cmocka_unit_test(derivatives)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
