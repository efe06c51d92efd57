// Case E3: the paper's rotor without its stator beside AUTO-07p: the same equations, the same orbits.
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
#include "support_check.h"
#include "support_flow.h"
#include "support_peer.h"
#include "whirl/whirl.h"

static whirl_rotor *rotor_at(double r_k) {
    whirl_case *object;
    whirl_rotor *rotor;
    require_ok(whirl_case_load(PEERS_AUTO "/rotor.yaml", NULL, &object));
    require_ok(whirl_case_rotor(object, "r_k", r_k, &rotor));
    whirl_case_free(object);
    return rotor;
}

/// The same numbers between -1 and 1 in every run.
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

/// AUTO's orbit carried by whirl's integrator, and its multipliers by differences of the flow.
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
        check_within("E3", "modulus of the largest where AUTO says Neimark-Sacker", 1.0,
                     largest_modulus(ROTOR_STATES, matrix), 1e-8);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

static void orbits_are_the_same(void **unused) {
    (void)unused;
    static peer_point points[16];
    size_t count, torus = 0;
    if (!run_peer("python3 " PEERS_AUTO "/follow.py --ntst 50 --to 0.37 --values 0.55,0.5,0.45,0.4", points, 16,
                  &count))
        skip();
    for (size_t i = 0; i < count; i++) {
        compare_point(&points[i]);
        torus += strcmp(points[i].kind, "NS") == 0;
    }
    assert_int_equal(count, 7);
    assert_int_equal(torus, 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(equations_are_the_same), cmocka_unit_test(orbits_are_the_same)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
