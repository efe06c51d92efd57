// The loops of the most frequent structure (rotor/pair_kernel.h) and the general ones agree: a rotor with an added
// force of amplitude 0 uses the general ones.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "whirl/engine/case.h"
#include "whirl/engine/ensemble.h"

static const char text[] = "whirl: 1\n"
                           "rotor:\n"
                           "  speed: 650 rad/s\n"
                           "  length_scale: 0.2 mm\n"
                           "  stations:\n"
                           "    disc:    {mass: 420 kg, damping: 4300 N.s/m, eccentricity: 16 um}\n"
                           "    journal: {mass: 100 kg, damping: 9300 N.s/m}\n"
                           "  elements:\n"
                           "    - shaft:   {between: [disc, journal], k1: 300 MN/m, k2: 528 MN/m}\n"
                           "    - film:    {at: journal, count: 2, clearance: 0.2 mm, load: 1900 N}\n"
                           "    - rub:     {at: disc, gap: 0.24 mm, stiffness: 5 GN/m, friction: 0.1}\n"
                           "    - gravity\n"
                           "%s"
                           "study: {response: {}}\n";

enum { DIMENSION = 8, LANES = 5, REVOLUTIONS = 20 };

static void must(whirl_status status) {
    if (status.code != WHIRL_OK) fail_msg("%s", status.message);
}

static void carry(const char *method, const char *more, double *x) {
    char whole[sizeof text + 64];
    whirl_integrate_options options = whirl_integrate_default();
    whirl_case *object;
    whirl_rotor *rotor;
    whirl_ensemble *lanes;
    snprintf(options.method, sizeof options.method, "%s", method);
    snprintf(whole, sizeof whole, text, more);
    must(whirl_case_parse(whole, strlen(whole), "structure", NULL, &object));
    must(whirl_case_rotor(object, NULL, NAN, &rotor));
    must(whirl_ensemble_new(whirl_rotor_system(rotor), &options, LANES, &lanes));
    for (size_t i = 0; i < LANES; i++) {
        const double start[DIMENSION] = {0.1, -0.1 * (double)i, 0.0, -0.1};
        must(whirl_ensemble_load(lanes, i, whirl_rotor_system(rotor), start));
    }
    for (int n = 0; n < REVOLUTIONS; n++) whirl_ensemble_revolve(lanes, LANES, NULL);
    for (size_t i = 0; i < LANES; i++) whirl_ensemble_state(lanes, i, x + i * DIMENSION);
    whirl_ensemble_free(lanes);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
}

/// Returns the largest difference of the states by both loops.
static double apart(const char *method) {
    double own[LANES * DIMENSION], general[LANES * DIMENSION], most = 0.0;
    carry(method, "", own);
    carry(method, "    - force: {at: disc, amplitude: 0 N, ratio: 2}\n", general);
    for (size_t i = 0; i < LANES * DIMENSION; i++) most = fmax(most, fabs(own[i] - general[i]));
    return most;
}

static void rk4_has_the_same_bits(void **state) {
    (void)state;
    assert_true(apart("rk4") == 0.0);
}

/// The paper's structure has its own loop, which advances the forcing from stage to stage by sums of angles and so
/// rounds differently.
static void dop853_is_the_same_within_its_tolerance(void **state) {
    (void)state;
    const double difference = apart("dop853");
    print_message("dop853: %.1e apart after %d revolutions\n", difference, REVOLUTIONS);
    assert_true(difference < 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rk4_has_the_same_bits),
        cmocka_unit_test(dop853_is_the_same_within_its_tolerance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
