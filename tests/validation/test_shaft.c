// Cases B1 to B4: a mass on an asymmetric shaft. The equations are linear: a revolution is an affine map, found exactly
// from the unit vectors.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_cases.h"
#include "support_check.h"
#include "support_flow.h"
#include "support_rotor.h"

enum { STEPS = 8192 };

static void b1_stiffness_matrix(void **unused) {
    (void)unused;
    const double k1 = 0.8, k2 = 1.2, speed = 1.3, kbar = 0.5 * (k1 + k2), dk = 0.5 * (k1 - k2);
    const shaft_case derived = {.speed = speed, .k1 = k1, .k2 = k2};
    whirl_rotor *rotor = make_shaft_rotor(&derived);
    double worst[3] = {0.0, 0.0, 0.0};
    for (double tau = 0.0; tau < 6.2; tau += 0.1) {
        double columns[2][4];
        for (int j = 0; j < 2; j++) {
            const double state[4] = {j == 0, j == 1, 0.0, 0.0};
            evaluate_rhs(whirl_rotor_system(rotor), tau, state, columns[j]);
        }
        const double scale = -speed * speed;
        worst[0] = fmax(worst[0], fabs(scale * columns[0][2] - (kbar + dk * cos(2.0 * tau))));
        worst[1] = fmax(worst[1], fabs(scale * columns[1][3] - (kbar - dk * cos(2.0 * tau))));
        worst[2] = fmax(worst[2], fmax(fabs(scale * columns[0][3] - dk * sin(2.0 * tau)),
                                       fabs(scale * columns[1][2] - dk * sin(2.0 * tau))));
    }
    check_within("B1", "Kxx, largest difference over a revolution", 0.0, worst[0], 1e-14);
    check_within("B1", "Kyy", 0.0, worst[1], 1e-14);
    check_within("B1", "Kxy and Kyx", 0.0, worst[2], 1e-14);
    whirl_rotor_free(rotor);
}

/// Computes the map of one revolution in `steps` steps, x -> matrix x + shift.
static void find_map(const shaft_case *parameters, int steps, double matrix[16], double shift[4]) {
    whirl_rotor *rotor = make_shaft_rotor(parameters);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "rk4", steps);
    memset(shift, 0, 4 * sizeof *shift);
    revolve(integrator, shift, 1);
    for (int j = 0; j < 4; j++) {
        double state[4] = {j == 0, j == 1, j == 2, j == 3};
        revolve(integrator, state, 1);
        for (int i = 0; i < 4; i++) matrix[4 * i + j] = state[i] - shift[i];
    }
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

static double growth(double damping, double speed, bool printed_signs) {
    const shaft_case p = {.speed = speed, .damping = damping, .k1 = 0.8, .k2 = 1.2, .printed_signs = printed_signs};
    double coarse[16], fine[16], shift[4];
    // Twelve digits ask for more than rounding leaves at any one step: the error of fourth order is taken away.
    find_map(&p, STEPS / 2, coarse, shift);
    find_map(&p, STEPS, fine, shift);
    return (16.0 * largest_modulus(4, fine) - largest_modulus(4, coarse)) / 15.0;
}

static void b2_multipliers(void **unused) {
    (void)unused;
    for (size_t i = 0; i < CASE_B2_ROWS; i++) {
        check_digits("B2", words("largest multiplier modulus at w = %g", case_b2[i].speed), case_b2[i].derived,
                     growth(0.0, case_b2[i].speed, false));
        check_digits("B2", words("the same with printed signs"), case_b2[i].printed,
                     growth(0.0, case_b2[i].speed, true));
    }
}

/// Returns det(map - 1), which changes its sign where a real pair of multipliers leaves 1.
static double distance_from_one(double damping, double speed) {
    const shaft_case p = {.speed = speed, .damping = damping, .k1 = 0.8, .k2 = 1.2};
    double matrix[16], shift[4];
    find_map(&p, STEPS, matrix, shift);
    for (int i = 0; i < 4; i++) matrix[5 * i] -= 1.0;
    return determinant(4, matrix);
}

/// Returns the speed between `outside` (stable) and `inside` (unstable) at which stability is lost.
static double find_edge(double damping, double outside, double inside) {
    for (int i = 0; i < 45; i++) {
        const double middle = 0.5 * (outside + inside);
        *(distance_from_one(damping, middle) > 0.0 ? &outside : &inside) = middle;
    }
    return 0.5 * (outside + inside);
}

static void b2_interval(void **unused) {
    (void)unused;
    check_digits("B2", "lower end of the unstable speeds, c = 0", ".894427191", find_edge(0.0, 0.85, 1.0));
    check_digits("B2", "upper end, c = 0", "1.095445115", find_edge(0.0, 1.15, 1.0));
    // (w^2 - w1^2)(w2^2 - w^2) = (g w)^2 is quadratic in w^2.
    const double g = 0.1, a = 0.8, b = 1.2, half = 0.5 * (a + b - g * g), root = sqrt(half * half - a * b);
    check_within("B2", "lower end, c = .1", sqrt(half - root), find_edge(g, 0.85, 1.0), 1e-10);
    check_within("B2", "upper end, c = .1", sqrt(half + root), find_edge(g, 1.15, 1.0), 1e-10);
    // It vanishes at c/m = w2 - w1 = .2010179, at w^2 = w1 w2.
    const double middle = sqrt(sqrt(a * b)), vanishing = sqrt(b) - sqrt(a);
    check_holds("B2", "unstable between the criticals with c/m = .999 (w2 - w1)",
                growth(0.999 * vanishing, middle, false) > 1.0);
    bool stable = true;
    for (double w = 0.85; w < 1.15; w += 0.01) stable = stable && growth(1.001 * vanishing, w, false) < 1.0;
    check_holds("B2", "stable at all speeds with c/m = 1.001 (w2 - w1)", stable);
}

/// Sums x + iy against e^(-i order tau) over a revolution.
typedef struct harmonics {
    double complex first, second, backward; ///< of order 1, 2 and -2
} harmonics;

static void add_harmonics(void *observer, double tau, const double *x) {
    harmonics *h = observer;
    const double complex z = (x[0] + I * x[1]) / STEPS;
    h->first += z * cexp(-I * tau);
    h->second += z * cexp(-2.0 * I * tau);
    h->backward += z * cexp(2.0 * I * tau);
}

/// Returns harmonics of the steady motion, whose start solves (1 - matrix) x = shift.
static harmonics steady_harmonics(const shaft_case *parameters) {
    harmonics h = {0.0, 0.0, 0.0};
    double matrix[16], state[4];
    find_map(parameters, STEPS, matrix, state);
    for (int i = 0; i < 16; i++) matrix[i] = (i % 5 == 0 ? 1.0 : 0.0) - matrix[i];
    solve_linear(4, matrix, state);
    whirl_rotor *rotor = make_shaft_rotor(parameters);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "rk4", STEPS);
    assert_int_equal(WHIRL_BOUNDED, whirl_integrator_revolve(integrator, state, add_harmonics, &h));
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
    return h;
}

static double gravity_response(double speed) {
    const shaft_case p = {.speed = speed, .damping = 0.1, .k1 = 0.8, .k2 = 1.2, .gravity = 0.05};
    return cabs(steady_harmonics(&p).second);
}

static void b3_gravity_at_twice_the_speed(void **unused) {
    (void)unused;
    check_digits("B3", "|Q| at w = .45", ".057166195048", gravity_response(0.45));
    check_digits("B3", "|Q| at w = .489898", ".102062061898", gravity_response(0.489898));

    const shaft_case p = {.speed = 0.45, .damping = 0.1, .k1 = 0.8, .k2 = 1.2, .gravity = 0.05};
    const harmonics h = steady_harmonics(&p);
    const double del = -0.2, w0 = 1.0;
    const double complex q = -I * del * 0.05 / (w0 * (w0 - del * del / w0 - 4.0 * 0.45 * 0.45 + 2.0 * I * 0.45 * 0.1));
    check_within("B3", "Re Q at w = .45", creal(q), creal(h.second), 5e-13);
    check_within("B3", "Im Q at w = .45", cimag(q), cimag(h.second), 5e-13);
    check_within("B3", "backward part at twice the speed", 0.0, cabs(h.backward), 1e-13);
}

static void b3_peak(void **unused) {
    (void)unused;
    // |Q| with w: damping grows with w too, so the peak lies below w = .5 sqrt(2 k1 k2/((k1 + k2) m)) by O(c^2).
    // With c -> 0 the real part of Q's denominator vanishes there: the phase of Q is a quarter turn from rest's.
    const double peak = 0.5 * sqrt(2.0 * 0.8 * 1.2 / 2.0);
    const shaft_case p = {.speed = peak, .damping = 0.1, .k1 = 0.8, .k2 = 1.2, .gravity = 0.05};
    const double complex q = steady_harmonics(&p).second;
    check_within("B3", "phase of Q at w = .5 sqrt(2 k1 k2/((k1 + k2) m)), rad", 0.0, carg(q), 1e-11);
}

static void b4_unbalance(void **unused) {
    (void)unused;
    const shaft_case p = {.speed = 0.8, .damping = 0.1, .k1 = 0.8, .k2 = 1.2, .eccentricity = 0.1, .angle = 0.7};
    const harmonics h = steady_harmonics(&p);
    check_digits("B4", "Re R", ".3198993599", creal(h.first));
    check_digits("B4", "Im R", ".0279249700", cimag(h.first));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(b1_stiffness_matrix),
        cmocka_unit_test(b2_multipliers),
        cmocka_unit_test(b2_interval),
        cmocka_unit_test(b3_gravity_at_twice_the_speed),
        cmocka_unit_test(b3_peak),
        cmocka_unit_test(b4_unbalance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
