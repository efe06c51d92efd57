// Masses that couple stations: accelerations, traces and motions against closed forms.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "machine.h"
#include "settings.h"
#include "whirl/engine/rotor.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

/// In SI: a rotor in a housing on springs, a linear seal between them whose fluid has a mass.
static const double omega = 130.0, length = 2e-4, rotor_mass = 7.0, housing_mass = 23.0, fluid = 3.5;
static const double rotor_k = 4e5, housing_k = 9e5, seal_k = 2e5, seal_c = 310.0, ratio = 0.46, rotor_c = 55.0;

static whirl_design *design_of(bool with_film) {
    whirl_design *design;
    check(whirl_design_new(omega, length, &design));
    check(whirl_design_station(design, "rotor", (whirl_setting[]){value("mass", rotor_mass), value("damping", rotor_c)},
                               2));
    check(whirl_design_station(design, "housing", (whirl_setting[]){value("mass", housing_mass)}, 1));
    check(whirl_design_element(design, "shaft",
                               (whirl_setting[]){word("between", "rotor, ground"), value("k1", rotor_k)}, 2));
    check(whirl_design_element(
        design, "spring", (whirl_setting[]){word("between", "housing, ground"), value("stiffness", housing_k)}, 2));
    check(whirl_design_element(design, "seal",
                               (whirl_setting[]){word("at", "rotor"), word("from", "housing"), value("clearance", 1.0),
                                                 value("stiffness", seal_k), value("damping", seal_c),
                                                 value("mass", fluid), value("ratio", ratio)},
                               7));
    if (!with_film) return design;
    check(whirl_design_element(
        design, "film", (whirl_setting[]){word("at", "rotor"), value("clearance", 2.0 * length), value("load", 300.0)},
        3));
    check(whirl_design_element(
        design, "bearing",
        (whirl_setting[]){word("at", "housing"), value("cxx", 77.0), value("cxy", 31.0), value("cyx", -12.0)}, 4));
    return design;
}

static whirl_rotor *rotor_of(bool with_film) {
    whirl_design *design = design_of(with_film);
    whirl_rotor *rotor;
    check(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Computes the accelerations in SI of z = x + i y by Cramer's rule; the mass matrix is [[m + f, -f], [-f, M + f]].
static void accelerate(const double complex z[2], const double complex v[2], double complex a[2]) {
    const double complex d = z[0] - z[1], w = v[0] - v[1], turn = I * ratio * omega;
    const double complex seal = -(seal_k * d + seal_c * (w - turn * d) + fluid * (turn * turn * d - 2.0 * turn * w));
    const double complex on_rotor = seal - rotor_k * z[0] - rotor_c * v[0], on_housing = -seal - housing_k * z[1];
    const double first = rotor_mass + fluid, second = housing_mass + fluid;
    const double determinant = first * second - fluid * fluid;
    a[0] = (second * on_rotor + fluid * on_housing) / determinant;
    a[1] = (fluid * on_rotor + first * on_housing) / determinant;
}

static void accelerations_are_those_of_the_mass_matrix(void **state) {
    whirl_rotor *rotor = rotor_of(false);
    const whirl_system *system = whirl_rotor_system(rotor);
    uint64_t seed = 7;
    (void)state;
    for (int trial = 0; trial < 50; trial++) {
        double x[8], slope[8], forcing[FORCING_COUNT];
        double complex z[2], v[2], a[2];
        for (int i = 0; i < 8; i++) x[i] = uniform(&seed, -1.0, 1.0);
        for (int s = 0; s < 2; s++) {
            z[s] = length * (x[2 * s] + I * x[2 * s + 1]);
            v[s] = omega * length * (x[4 + 2 * s] + I * x[5 + 2 * s]);
        }
        system->forcing(system->model, 0.3, forcing);
        system->rhs(system->model, 0.3, forcing, x, slope);
        accelerate(z, v, a);
        for (int s = 0; s < 2; s++) {
            const double complex mine = omega * omega * length * (slope[4 + 2 * s] + I * slope[5 + 2 * s]);
            assert_true(cabs(mine - a[s]) < 1e-13 * (1.0 + cabs(a[s])));
        }
    }
    whirl_rotor_free(rotor);
}

/// The divergence is the trace of the Jacobian, with a film and a bearing with cross-coupled stiffness.
static void the_trace_is_that_of_the_jacobian(void **state) {
    (void)state;
    for (int with_film = 0; with_film < 2; with_film++) {
        whirl_rotor *rotor = rotor_of(with_film);
        const whirl_system *system = whirl_rotor_system(rotor);
        const double x[8] = {0.4, -0.7, 0.2, 0.1, 0.3, 0.2, -0.1, 0.05};
        double forcing[FORCING_COUNT], columns[64], image[64], trace = 0.0;
        memset(columns, 0, sizeof columns);
        for (int i = 0; i < 8; i++) columns[8 * i + i] = 1.0;
        system->forcing(system->model, 0.9, forcing);
        system->tangent(system->model, 0.9, forcing, x, NULL, 8, columns, image);
        for (int i = 0; i < 8; i++) trace += image[8 * i + i];
        const double divergence = system->divergence(system->model, 0.9, forcing, x, NULL);
        assert_true(fabs(divergence - trace) < 1e-13 * fabs(trace));
        const double determinant = (rotor_mass + fluid) * (housing_mass + fluid) - fluid * fluid;
        // Of the mass matrix's inverse times the dampings, in x and in y.
        const double sum = rotor_c * (housing_mass + fluid) + seal_c * (rotor_mass + housing_mass);
        if (!with_film) assert_true(fabs(divergence + 2.0 * sum / determinant / omega) < 1e-13 * fabs(divergence));
        whirl_rotor_free(rotor);
    }
}

/// Rotors whose masses couple in the same way can share an ensemble, others cannot.
static void lanes_share_a_coupling(void **state) {
    whirl_rotor *one = rotor_of(false), *same = rotor_of(false);
    whirl_design *design;
    whirl_rotor *lone;
    (void)state;
    assert_true(one->lanes.alike(one, same));
    assert_int_equal(one->coupled.count, 4);
    check(whirl_design_new(omega, length, &design));
    check(whirl_design_station(design, "rotor", (whirl_setting[]){value("mass", rotor_mass)}, 1));
    check(whirl_rotor_new(design, &lone));
    assert_int_equal(lone->coupled.count, 0);
    whirl_design_free(design);
    same->coupled.share[0] *= 2.0;
    assert_false(one->lanes.alike(one, same));
    whirl_rotor_free(one);
    whirl_rotor_free(same);
    whirl_rotor_free(lone);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(accelerations_are_those_of_the_mass_matrix),
                                       cmocka_unit_test(the_trace_is_that_of_the_jacobian),
                                       cmocka_unit_test(lanes_share_a_coupling)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
