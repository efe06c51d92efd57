// Case E3: the paper's rotor without its stator, compared with AUTO-07p: the same equations, the same orbits.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "rotor_equations.h"
#include "support_branch.h"
#include "support_check.h"
#include "support_flow.h"
#include "support_peer.h"
#include "whirl/engine.h"

static whirl_rotor *rotor_at(double r_k) {
    whirl_case *object;
    whirl_rotor *rotor;
    require_ok(whirl_case_load(PEERS_AUTO "/rotor.yaml", NULL, &object));
    require_ok(whirl_case_rotor(object, "r_k", r_k, &rotor));
    whirl_case_free(object);
    return rotor;
}

/// Returns numbers between -1 and 1, the same in every run.
static double next_number(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 4503599627370496.0 - 1.0;
}

static void equations_are_the_same(void **unused) {
    (void)unused;
    double slope_error = 0.0, matrix_error = 0.0;
    uint64_t seed = 1;
    for (int trial = 0; trial < 1000; trial++) {
        const double r_k = 0.55 + 0.45 * next_number(&seed), t = 3.14 * (1.0 + next_number(&seed));
        double u[ROTOR_ALL], f[ROTOR_ALL], g[ROTOR_STATES], matrix[ROTOR_STATES * ROTOR_STATES];
        double by_state[ROTOR_ALL][ROTOR_ALL];
        whirl_rotor *rotor = rotor_at(r_k);
        for (int i = 0; i < ROTOR_STATES; i++) u[i] = 0.6 * next_number(&seed);
        u[8] = cos(t);
        u[9] = sin(t);
        rotor_slope(r_k, u, f);
        rotor_slope_by_state(r_k, u, by_state);
        evaluate_rhs(whirl_rotor_system(rotor), t, u, g);
        exact_jacobian(whirl_rotor_system(rotor), t, u, matrix);
        for (int i = 0; i < ROTOR_STATES; i++) {
            slope_error = fmax(slope_error, fabs(f[i] - g[i]) / (1.0 + fabs(f[i])));
            for (int j = 0; j < ROTOR_STATES; j++)
                matrix_error = fmax(matrix_error,
                                    fabs(by_state[i][j] - matrix[i * ROTOR_STATES + j]) / (1.0 + fabs(by_state[i][j])));
        }
        whirl_rotor_free(rotor);
    }
    check_within("E3", "largest relative difference of the slope at 1000 random states", 0.0, slope_error, 1e-12);
    check_within("E3", "and of its derivatives by the state", 0.0, matrix_error, 1e-12);
}

/// Points that AUTO computed; none if it is not installed.
typedef struct followed {
    peer_point points[16];
    size_t count;
} followed;

static int run_auto(void **state) {
    followed *known = calloc(1, sizeof *known);
    assert_non_null(known);
    *state = known;
    if (!run_peer("python3 " PEERS_AUTO "/follow.py --values 0.55,0.5,0.45,0.4", known->points, 16, &known->count))
        known->count = 0;
    return 0;
}

static int forget_auto(void **state) {
    free(*state);
    return 0;
}

/// Compares AUTO's orbit with the motion by whirl's integrator, and its multipliers with differences of the flow.
static void compare_point(const peer_point *point) {
    const double r_k = point->numbers[0], *state = point->numbers + 1;
    whirl_rotor *rotor = rotor_at(r_k);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 1024);
    double x[ROTOR_STATES], matrix[ROTOR_STATES * ROTOR_STATES], apart = 0.0;
    double complex multipliers[ROTOR_STATES];
    assert_int_equal(point->count, 1 + 3 * ROTOR_STATES);
    memcpy(x, state, sizeof x);
    revolve(integrator, x, 1);
    for (int i = 0; i < ROTOR_STATES; i++) apart = fmax(apart, fabs(x[i] - state[i]));
    flow_jacobian(integrator, ROTOR_STATES, state, 1, 1e-4, matrix);
    eigenvalues(ROTOR_STATES, matrix, multipliers);
    check_within("E3", words("return of AUTO's orbit at r_k = %.9g", r_k), 0.0, apart, 1e-10);
    check_within("E3", "and its multipliers", 0.0, multipliers_apart(ROTOR_STATES, state + ROTOR_STATES, multipliers),
                 1e-7);
    if (strcmp(point->kind, "NS") == 0)
        check_within("E3", "modulus of the largest at AUTO's Neimark-Sacker point", 1.0,
                     largest_modulus(ROTOR_STATES, matrix), 1e-8);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

static void orbits_are_the_same(void **state) {
    const followed *known = *state;
    if (known->count == 0) skip();
    for (size_t i = 0; i < known->count; i++) compare_point(&known->points[i]);
}

static const char *word_of(whirl_special special) {
    switch (special) {
    case WHIRL_FOLD:
        return "LP";
    case WHIRL_BRANCHING:
        return "BP";
    case WHIRL_DOUBLING:
        return "PD";
    case WHIRL_NEIMARK_SACKER:
        return "NS";
    default:
        return "other";
    }
}

/// The library follows the branch independently, and finds the same special points in the same order.
static void branches_are_the_same(void **state) {
    const followed *known = *state;
    whirl_case *object;
    require_ok(whirl_case_load(PEERS_AUTO "/rotor.yaml", NULL, &object));
    const case_family family = {object, "r_k"};
    const whirl_family machines = family_of_case(&family);
    const whirl_branch_options options = whirl_branch_default(0.355, 0.6);
    const double aside[ROTOR_STATES] = {0.0, -0.9, 0.0, -0.8};
    whirl_machine machine;
    whirl_orbit *start;
    whirl_branch *branch;
    size_t p = 0;
    if (known->count == 0) skip();
    require_ok(machines.machine(machines.context, options.to, &machine));
    require_ok(whirl_orbit_find(machine.system, aside, 1, &options.orbit, &start));
    machine.release(machine.owner);
    require_ok(whirl_branch_follow(&machines, start, options.to, -1, &options, &branch));
    for (size_t i = 0; i < branch->count; i++) {
        const whirl_branch_point *found = &branch->points[i];
        if (found->special == WHIRL_REGULAR) continue;
        while (p < known->count && strcmp(known->points[p].kind, "UZ") == 0) p++;
        assert_true(p < known->count);
        const double *numbers = known->points[p].numbers;
        double apart = 0.0;
        check_text("E3", words("special point of the branch at r_k = %.6f", numbers[0]), known->points[p].kind,
                   word_of(found->special));
        for (int k = 0; k < ROTOR_STATES; k++) apart = fmax(apart, fabs(found->orbit->nodes[k] - numbers[1 + k]));
        check_within("E3", words("%s: r_k", known->points[p].kind), numbers[0], found->value, 1e-10);
        check_within("E3", "largest difference of the state there", 0.0, apart, 1e-9);
        p++;
    }
    while (p < known->count && strcmp(known->points[p].kind, "UZ") == 0) p++;
    assert_int_equal(p, known->count);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(equations_are_the_same), cmocka_unit_test(orbits_are_the_same),
                                       cmocka_unit_test(branches_are_the_same)};
    return cmocka_run_group_tests(tests, run_auto, forget_auto);
}
