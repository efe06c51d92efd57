// The chain with a unilateral spring, example 03 of NLvib: the orbits of an independent program in extended precision.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_branch.h"
#include "support_check.h"
#include "support_flow.h"
#include "support_peer.h"
#include "whirl/engine.h"

enum { N = 4, STATE = 1, CONTACTS = STATE + N, MULTIPLIERS };

/// Results of the program in extended precision, and the case of the same chain.
typedef struct reference {
    peer_point points[32];
    size_t count;
    whirl_case *chain;
} reference;

static int read_reference(void **state) {
    reference *known = calloc(1, sizeof *known);
    assert_non_null(known);
    *state = known;
    require_ok(whirl_case_load(REFERENCES "/unilateral_chain.yaml", NULL, &known->chain));
    assert_true(run_peer(REFERENCE, known->points, 32, &known->count));
    assert_int_equal(known->count, 19);
    return 0;
}

static int forget_reference(void **state) {
    reference *known = *state;
    whirl_case_free(known->chain);
    free(known);
    return 0;
}

/// Carries the case at that speed over a revolution, with the derivatives of its end by its start [N][N], transposed.
static void carry_chain(const whirl_case *chain, double W, double *x, double *matrix) {
    whirl_perturbations perturbations = {.count = N, .vectors = matrix};
    whirl_rotor *rotor;
    require_ok(whirl_case_rotor(chain, "W", W, &rotor));
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 1024);
    require_ok(whirl_integrator_follow(integrator, N));
    for (int i = 0; i < N * N; i++) matrix[i] = i % (N + 1) == 0 ? 1.0 : 0.0;
    assert_int_equal(whirl_integrator_carry(integrator, x, &perturbations, NULL, NULL), WHIRL_BOUNDED);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

/// Returns the radius of the first mass while it does not touch: |q1| of (K - W^2 + i W D) q = (0, 0.1).
static double free_amplitude(double W) {
    const double complex spring = 1.0 + 0.03 * I * W, first = spring - W * W, second = 2.0 * spring - W * W;
    return cabs(0.1 * spring / (first * second - spring * spring));
}

/// The program's points close after a revolution of the library's integrator, with the exact derivative.
static void orbits_are_the_same(void **state) {
    const reference *known = *state;
    for (size_t p = 0; p < known->count; p++) {
        const peer_point *point = &known->points[p];
        const double W = point->numbers[0], *start = point->numbers + STATE;
        const char *name = words("%s at W = %.10g, q1 = %.3f", point->kind, W, start[0]);
        double x[N], matrix[N * N], apart = 0.0;
        double complex multipliers[N];
        memcpy(x, start, sizeof x);
        carry_chain(known->chain, W, x, matrix);
        for (int i = 0; i < N; i++) apart = fmax(apart, fabs(x[i] - start[i]));
        check_within("NLvib-03", words("%s: return after a revolution", name), 0.0, apart, 1e-13);
        if (point->count > MULTIPLIERS) {
            eigenvalues(N, matrix, multipliers);
            check_within("NLvib-03", words("%s: multipliers", name), 0.0,
                         multipliers_apart(N, point->numbers + MULTIPLIERS, multipliers), 1e-9);
        } else {
            check_within("NLvib-03", words("%s: amplitude of the linear motion", name), 1.0, free_amplitude(W), 1e-13);
        }
    }
}

/// The library follows the branch independently, and finds the same special points in the same order.
static void special_points_are_the_same(void **state) {
    const reference *known = *state;
    const case_family family = {known->chain, "W"};
    const whirl_family machines = family_of_case(&family);
    whirl_branch_options options = whirl_branch_default(0.5, 0.8);
    const double aside[N] = {-0.2, -0.1, 0.0, 0.0};
    whirl_machine machine;
    whirl_orbit *start;
    whirl_branch *branch;
    size_t p = 0;
    options.most_step = 0.1;
    require_ok(machines.machine(machines.context, options.to, &machine));
    require_ok(whirl_orbit_find(machine.system, aside, 1, &options.orbit, &start));
    machine.release(machine.owner);
    require_ok(whirl_branch_follow(&machines, start, options.to, -1, &options, &branch));
    assert_int_equal(branch->end, WHIRL_END_OF_RANGE);
    for (size_t i = 0; i < branch->count; i++) {
        const whirl_branch_point *found = &branch->points[i];
        if (found->special == WHIRL_REGULAR) continue;
        while (p < known->count && strcmp(known->points[p].kind, "value") == 0) p++;
        assert_true(p < known->count);
        const double *numbers = known->points[p].numbers;
        double apart = 0.0;
        check_text("NLvib-03", words("special point of the branch near %.3f", numbers[0]), known->points[p].kind,
                   special_word(found->special));
        for (int k = 0; k < N; k++) apart = fmax(apart, fabs(found->orbit->nodes[k] - numbers[STATE + k]));
        check_within("NLvib-03", words("%s: W", known->points[p].kind), numbers[0], found->value, 1e-11);
        check_within("NLvib-03", "largest difference of the state there", 0.0, apart, 1e-10);
        p++;
    }
    while (p < known->count && strcmp(known->points[p].kind, "value") == 0) p++;
    assert_int_equal(p, known->count);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(orbits_are_the_same),
                                       cmocka_unit_test(special_points_are_the_same)};
    return cmocka_run_group_tests(tests, read_reference, forget_reference);
}
