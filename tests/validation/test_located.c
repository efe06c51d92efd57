// Blades that touch and let go, coils that come to their limits: located where they switch. Derivatives of the
// switches, the order of the method across them, and the monodromy matrix from differences of motions.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine/case.h"
#include "whirl/engine/rotor.h"

enum { MAX_SIZE = 24, MAX_SWITCHES = 16 };

typedef struct machine {
    const char *name, *text;
    int revolutions;
} machine;

static const machine machines[] = {
    {"blades",
     "whirl: 1\nrotor:\n  speed: 300 rad/s\n  length_scale: 0.1 mm\n  stations:\n"
     "    disc: {mass: 10 kg, damping: 400 N.s/m, eccentricity: 0.05 mm}\n"
     "    casing: {mass: 30 kg, damping: 300 N.s/m}\n  elements:\n"
     "    - spring: {between: [disc, ground], stiffness: 1 MN/m}\n"
     "    - spring: {between: [casing, ground], stiffness: 20 MN/m}\n"
     "    - blade_rub: {at: disc, from: casing, blades: 3, radius: 20 mm, gap: 0.08 mm, extension: [0.01 mm, 0.02 mm, "
     "0 "
     "mm], stiffness: 1e6, friction: 0.1}\n    - gravity: 9.81 m/s2\nstudy:\n  response: {}\n",
     2},
    {"magnets",
     "whirl: 1\nrotor:\n  speed: 300 rad/s\n  length_scale: 0.1 mm\n  stations:\n"
     "    disc: {mass: 10 kg, eccentricity: 0.12 mm}\n  elements:\n"
     "    - magnetic: {at: disc, gap: 0.5 mm, bias: 2 A, max_current: 2.25 A, constant: 1e-5, proportional: 20000, "
     "derivative: 40, derivative_filter: 1e-4, amplifier_bandwidth: 2000 Hz}\n    - gravity: 9.81 m/s2\n"
     "study:\n  response: {}\n",
     2}};

enum { MACHINES = sizeof machines / sizeof *machines };

static whirl_rotor *rotor_of(const machine *m) {
    whirl_case *object;
    whirl_rotor *rotor;
    require_ok(whirl_case_parse(m->text, strlen(m->text), "case", NULL, &object));
    require_ok(whirl_case_rotor(object, NULL, 0.0, &rotor));
    whirl_case_free(object);
    assert_true(whirl_rotor_system(rotor)->dimension <= MAX_SIZE);
    assert_true(whirl_rotor_system(rotor)->switch_count <= MAX_SWITCHES);
    return rotor;
}

/// Returns largest difference of gradient and curvature of a switch from differences, over the gradient's largest
/// entry.
static double compare(const whirl_system *system, const double *x, size_t which) {
    double largest;
    const double apart = switch_apart(system, x, which, 1e-4, &largest);
    return apart / largest;
}

static void switches_have_their_derivatives(void **state) {
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        whirl_rotor *rotor = rotor_of(&machines[k]);
        const whirl_system *system = whirl_rotor_system(rotor);
        double worst = 0.0, x[MAX_SIZE];
        for (int trial = 0; trial < 50; trial++) {
            for (size_t i = 0; i < system->dimension; i++) x[i] = sin(1.7 * trial + 2.3 * (double)i);
            for (size_t s = 0; s < system->switch_count; s++) worst = fmax(worst, compare(system, x, s));
        }
        check_within("located", words("%s: derivatives of switches from differences", machines[k].name), 0.0, worst,
                     1e-6);
        whirl_rotor_free(rotor);
    }
}

/// Computes the state after some revolutions by dop853, from a state off the equilibrium.
static void end_of(const whirl_system *system, double rtol, int revolutions, double *x) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    strcpy(options.method, "dop853");
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    memset(x, 0, system->dimension * sizeof *x);
    x[0] = 0.7;
    x[1] = -0.4;
    require_ok(whirl_integrator_new(system, &options, &integrator));
    revolve(integrator, x, revolutions);
    whirl_integrator_free(integrator);
}

/// Errors of motions with switches decrease with the tolerance, as those of smooth ones do: by at least 1e4 from 1e-6
/// to 1e-11.
static void errors_fall_with_the_tolerance(void **state) {
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        whirl_rotor *rotor = rotor_of(&machines[k]);
        const whirl_system *system = whirl_rotor_system(rotor);
        double exact[MAX_SIZE], x[MAX_SIZE], errors[2] = {0.0, 0.0};
        end_of(system, 1e-14, 4, exact);
        for (int e = 0; e < 2; e++) {
            end_of(system, e ? 1e-11 : 1e-6, 4, x);
            for (size_t i = 0; i < system->dimension; i++) errors[e] = fmax(errors[e], fabs(x[i] - exact[i]));
        }
        check_within("located", words("%s: error at rtol 1e-6", machines[k].name), 0.0, errors[0], 1e-5);
        check_within("located", words("%s: error at rtol 1e-11, over that at 1e-6", machines[k].name), 0.0,
                     errors[1] / errors[0], 1e-4);
        whirl_rotor_free(rotor);
    }
}

static void monodromies_are_those_of_differences(void **state) {
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        whirl_rotor *rotor = rotor_of(&machines[k]);
        const whirl_system *system = whirl_rotor_system(rotor);
        const size_t n = system->dimension;
        whirl_integrator *integrator = make_integrator(system, "dop853", 64),
                         *along = make_integrator(system, "dop853", 64);
        double start[MAX_SIZE], x[MAX_SIZE], vectors[MAX_SIZE * MAX_SIZE] = {0.0}, differences[MAX_SIZE * MAX_SIZE],
                                                                worst = 0.0, size = 0.0;
        whirl_perturbations columns = {.count = n, .vectors = vectors};
        end_of(system, 1e-12, 2, start);
        // Angles that turn come back at the end of a revolution: away from where that shows in differences.
        for (size_t i = 0; system->turns && i < n; i++)
            if (system->turns[i] > 0.0) start[i] = 1.0;
        memcpy(x, start, sizeof x);
        for (size_t i = 0; i < n; i++) vectors[i * n + i] = 1.0;
        require_ok(whirl_integrator_follow(along, n));
        for (int r = 0; r < machines[k].revolutions; r++)
            assert_int_equal(whirl_integrator_carry(along, x, &columns, NULL, NULL), WHIRL_BOUNDED);
        flow_jacobian(integrator, n, start, machines[k].revolutions, 1e-5, differences);
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++) {
                size = fmax(size, fabs(vectors[j * n + i]));
                worst = fmax(worst, fabs(vectors[j * n + i] - differences[i * n + j]));
            }
        check_within("located",
                     words("%s: monodromy matrix from differences, over its largest entry", machines[k].name), 0.0,
                     worst / size, 1e-6);
        whirl_integrator_free(integrator);
        whirl_integrator_free(along);
        whirl_rotor_free(rotor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(switches_have_their_derivatives),
                                       cmocka_unit_test(errors_fall_with_the_tolerance),
                                       cmocka_unit_test(monodromies_are_those_of_differences)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
