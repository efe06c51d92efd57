// Elastomer mounts, which have states of their own, against their complex stiffness.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/whirl.h"

static const double speed = 200.0, scale = 1e-3, mass = 3.0, eccentricity = 2e-5;
static const double stiffness = 2e5, branch = 3e5, damping = 900.0;

static whirl_rotor *make_mounted(void) {
    const whirl_setting disc[] = {{"mass", mass, NULL}, {"eccentricity", eccentricity, NULL}};
    const whirl_setting mount[] = {{"between", 0, "disc, ground"},
                                   {"stiffness", stiffness, NULL},
                                   {"branch", branch, NULL},
                                   {"damping", damping, NULL}};
    whirl_design *design;
    whirl_rotor *rotor;
    require_ok(whirl_design_new(speed, scale, &design));
    require_ok(whirl_design_station(design, "disc", disc, 2));
    require_ok(whirl_design_element(design, "mount", mount, 4));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// z = m e w^2/(K - m w^2), K = k + k_m i w c/(k_m + i w c).
static double complex mounted_response(void) {
    const double complex dashpot = I * speed * damping;
    return mass * eccentricity * speed * speed /
           (stiffness + branch * dashpot / (branch + dashpot) - mass * speed * speed);
}

static void the_mount_s_response(void **unused) {
    (void)unused;
    static const char *const methods[] = {"dop853", "rk4", "cvode-bdf"};
    whirl_rotor *rotor = make_mounted();
    const whirl_system *system = whirl_rotor_system(rotor);
    const double complex expected = mounted_response() / scale;
    assert_int_equal(system->dimension, 6);
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
        whirl_integrator *integrator = make_integrator(system, methods[m], 4096);
        double x[6] = {0};
        revolve(integrator, x, 200);
        check_within("Mount", words("unbalance response by %s, part of its size", methods[m]), 0.0,
                     cabs(x[0] + I * x[1] - expected) / cabs(expected), m == 2 ? 1e-8 : 1e-9);
        whirl_integrator_free(integrator);
    }
    whirl_rotor_free(rotor);
}

/// The characteristic equation (m s^2 + k)(c s + k_m) + k_m c s = 0 in each plane.
static void the_mount_s_eigenvalues(void **unused) {
    (void)unused;
    whirl_rotor *rotor = make_mounted();
    double rest[6] = {0}, matrix[36], worst = 0.0;
    double complex values[6];
    exact_jacobian(whirl_rotor_system(rotor), 0.3, rest, matrix);
    eigenvalues(6, matrix, values);
    for (int i = 0; i < 6; i++) {
        const double complex s = values[i] * speed;
        const double complex left = (mass * s * s + stiffness) * (damping * s + branch) + branch * damping * s;
        const double size = (mass * cabs(s) * cabs(s) + stiffness) * (damping * cabs(s) + branch);
        worst = fmax(worst, cabs(left) / size);
    }
    check_within("Mount", "characteristic equation at the six eigenvalues, largest part", 0.0, worst, 1e-13);
    whirl_rotor_free(rotor);
}

/// States of their own go in lanes: there and alone the same, whatever the width and the place.
static void mounts_in_lanes(void **unused) {
    (void)unused;
    enum { LANES = 9, DIMENSION = 6 };
    static const char *const sets[] = {"fma", "avx2", "avx512"};
    whirl_rotor *rotor = make_mounted();
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_integrate_options options = whirl_integrate_default();
    double alone[DIMENSION] = {0}, first[DIMENSION], lane[DIMENSION], numbers[512];
    whirl_integrator *integrator = make_integrator(system, "rk4", options.steps_per_revolution);
    bool found = false;
    revolve(integrator, alone, 7);
    for (size_t s = 0; s < sizeof sets / sizeof *sets; s++) {
        whirl_ensemble *ensemble;
        setenv("WHIRL_ISA", sets[s], 1);
        const whirl_status status = whirl_ensemble_new(system, &options, LANES, &ensemble);
        unsetenv("WHIRL_ISA");
        if (status.code != WHIRL_OK) continue; // this processor has it not
        for (size_t l = 0; l < LANES; l++) require_ok(whirl_ensemble_load(ensemble, l, system, (double[DIMENSION]){0}));
        for (int i = 0; i < 3; i++) whirl_ensemble_revolve(ensemble, LANES, NULL);
        // Saved and taken up in another lane.
        assert_true(whirl_ensemble_numbers(ensemble) <= sizeof numbers / sizeof *numbers);
        whirl_ensemble_save(ensemble, 2, numbers);
        whirl_ensemble_load(ensemble, 5, system, (double[DIMENSION]){0});
        whirl_ensemble_restore(ensemble, 5, numbers);
        for (int i = 3; i < 7; i++) whirl_ensemble_revolve(ensemble, LANES, NULL);
        for (size_t l = 0; l < LANES; l++) {
            whirl_ensemble_state(ensemble, l, lane);
            if (!found) memcpy(first, lane, sizeof first);
            found = true;
            assert_memory_equal(lane, first, sizeof first);
        }
        whirl_ensemble_free(ensemble);
    }
    double worst = 0.0;
    for (int i = 0; i < DIMENSION && found; i++) worst = fmax(worst, fabs(alone[i] - first[i]));
    check_within("Mount", "in lanes and alone after seven revolutions, in length scales", 0.0, worst, 1e-14);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_mount_s_response),
                                       cmocka_unit_test(the_mount_s_eigenvalues), cmocka_unit_test(mounts_in_lanes)};
    return cmocka_run_group_tests_name("mounts", tests, NULL, NULL);
}
