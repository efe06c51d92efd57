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

#include "support_check.h"
#include "support_flow.h"
#include "support_peer.h"
#include "whirl/whirl.h"

enum { N = 4, STATE = 1, CONTACTS = STATE + N, MULTIPLIERS };

/// The case at that speed over a revolution, and the derivatives of its end by its start [N][N], transposed.
static void carry_chain(const whirl_case *chain, double W, double *x, double *matrix) {
    whirl_disturbances disturbances = {.count = N, .vectors = matrix};
    whirl_rotor *rotor;
    require_ok(whirl_case_rotor(chain, "W", W, &rotor));
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 1024);
    require_ok(whirl_integrator_follow(integrator, N));
    for (int i = 0; i < N * N; i++) matrix[i] = i % (N + 1) == 0 ? 1.0 : 0.0;
    assert_int_equal(whirl_integrator_carry(integrator, x, &disturbances, NULL, NULL), WHIRL_BOUNDED);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

/// Radius of the first mass while it does not touch: |q1| of (K - W^2 + i W D) q = (0, 0.1).
static double free_amplitude(double W) {
    const double complex spring = 1.0 + 0.03 * I * W, first = spring - W * W, second = 2.0 * spring - W * W;
    return cabs(0.1 * spring / (first * second - spring * spring));
}

static void orbits_are_the_same(void **unused) {
    (void)unused;
    static peer_point points[32];
    static const char *const kinds[] = {"fold", "doubling", "Neimark-Sacker", "touch"};
    size_t count, found[4] = {0};
    whirl_case *chain;
    require_ok(whirl_case_load(REFERENCES "/unilateral_chain.yaml", NULL, &chain));
    assert_true(run_peer(REFERENCE, points, 32, &count));
    for (size_t p = 0; p < count; p++) {
        const peer_point *point = &points[p];
        const double W = point->numbers[0], *state = point->numbers + STATE;
        const char *name = words("%s at W = %.10g, q1 = %.3f", point->kind, W, state[0]);
        double x[N], matrix[N * N], apart = 0.0;
        double complex multipliers[N];
        for (int k = 0; k < 4; k++) found[k] += strcmp(point->kind, kinds[k]) == 0;
        memcpy(x, state, sizeof x);
        carry_chain(chain, W, x, matrix);
        for (int i = 0; i < N; i++) apart = fmax(apart, fabs(x[i] - state[i]));
        check_within("NLvib-03", words("%s: return after a revolution", name), 0.0, apart, 1e-13);
        if (point->count > MULTIPLIERS) {
            eigenvalues(N, matrix, multipliers);
            check_within("NLvib-03", words("%s: multipliers", name), 0.0,
                         multipliers_apart(N, point->numbers + MULTIPLIERS, multipliers), 1e-9);
        } else {
            check_within("NLvib-03", words("%s: amplitude of the linear motion", name), 1.0, free_amplitude(W), 1e-13);
        }
    }
    for (int k = 0; k < 4; k++) assert_int_equal(found[k], 2);
    whirl_case_free(chain);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(orbits_are_the_same)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
