// Steps that are too long, against RK4's known region (Hairer, Wanner: Solving Ordinary Differential Equations II,
// IV.2), and the eigenvalues that tell them, against closed forms.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "eigenvalues.h"
#include "method.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- eigenvalues

enum { MOST = 100 };

typedef struct spectrum {
    double real[MOST], imaginary[MOST];
} spectrum;

static spectrum spectrum_of(size_t n, const double *matrix) {
    static double copy[MOST * MOST];
    spectrum s;
    memcpy(copy, matrix, n * n * sizeof *copy);
    matrix_balance(n, copy);
    assert_true(matrix_eigenvalues(n, copy, s.real, s.imaginary));
    return s;
}

/// Whether each wanted value is there, to `tolerance`, as often as it is wanted.
static void expect_spectrum(size_t n, spectrum found, const spectrum *wanted, double tolerance) {
    for (size_t i = 0; i < n; i++) {
        size_t nearest = i;
        double least = INFINITY;
        for (size_t k = i; k < n; k++) {
            const double distance = hypot(found.real[k] - wanted->real[i], found.imaginary[k] - wanted->imaginary[i]);
            if (distance < least) least = distance, nearest = k;
        }
        if (!(least <= tolerance)) fail_msg("%g + %gi is off by %g", wanted->real[i], wanted->imaginary[i], least);
        found.real[nearest] = found.real[i];
        found.imaginary[nearest] = found.imaginary[i];
    }
}

/// Rows (0, 1, 0, ...), ..., last row c: x^n = c[0] + c[1] x + ...
static void test_companion_matrices(void **state) {
    // (x - 1)(x - 2)(x^2 - 2x + 5): 1, 2, 1 +- 2i. x^4 = -10 + 19 x - 13 x^2 + 5 x^3
    const double matrix[16] = {0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -10, 19, -13, 5};
    const spectrum wanted = {{1, 2, 1, 1}, {0, 0, 2, -2}};
    (void)state;
    expect_spectrum(4, spectrum_of(4, matrix), &wanted, 1e-12);
}

/// Cyclic shifts have the roots of unity: all moduli alike, where shifts of the QR algorithm can go round in circles.
static void test_cyclic_shifts(void **state) {
    static double matrix[MOST * MOST];
    (void)state;
    for (size_t n = 1; n <= MOST; n = 2 * n + 1) {
        spectrum wanted;
        memset(matrix, 0, sizeof matrix);
        for (size_t i = 0; i < n; i++) {
            matrix[i * n + (i + 1) % n] = 1.0;
            wanted.real[i] = cos(2 * pi * (double)i / (double)n);
            wanted.imaginary[i] = sin(2 * pi * (double)i / (double)n);
        }
        expect_spectrum(n, spectrum_of(n, matrix), &wanted, 1e-12);
    }
}

/// A chain of 50 unit masses and springs k between walls, x'' = -k (2 x - neighbours): +- i 2 sqrt k sin(j pi / 102).
/// Positions and velocities are scales apart, which balancing evens out; the norm then bounds the largest within
/// sqrt 2.
static void test_a_chain_of_masses(void **state) {
    enum { MASSES = 50, N = 2 * MASSES };
    static double matrix[N * N];
    const double k = 1e8;
    spectrum wanted = {{0}, {0}};
    (void)state;
    for (size_t i = 0; i < MASSES; i++) {
        double *row = matrix + (MASSES + i) * N;
        matrix[i * N + MASSES + i] = 1.0;
        row[i] = -2 * k;
        if (i > 0) row[i - 1] = k;
        if (i + 1 < MASSES) row[i + 1] = k;
        wanted.imaginary[2 * i] = 2 * sqrt(k) * sin((double)(i + 1) * pi / (2 * (MASSES + 1)));
        wanted.imaginary[2 * i + 1] = -wanted.imaginary[2 * i];
    }
    expect_spectrum(N, spectrum_of(N, matrix), &wanted, 1e-9 * sqrt(k));
    assert_true(matrix_norm(N, matrix) >= 4 * k);
    matrix_balance(N, matrix);
    const double norm = matrix_norm(N, matrix);
    assert_true(norm >= 2 * sqrt(k) && norm <= 3 * sqrt(k));
}

/// Similar matrices have the same eigenvalues, whatever the similarity: diag(1, ..., n) in other coordinates.
static void test_full_matrices(void **state) {
    enum { N = 24 };
    double matrix[N * N] = {0};
    spectrum wanted = {{0}, {0}};
    unsigned seed = 1;
    (void)state;
    for (size_t i = 0; i < N; i++) matrix[i * N + i] = wanted.real[i] = (double)i + 1;
    for (int times = 0; times < 40; times++) { // I + f e_i e_k' and its inverse, by turns
        seed = seed * 1664525u + 1013904223u;
        const size_t i = (seed >> 8) % N, k = (i + 1 + (seed >> 20) % (N - 1)) % N;
        for (size_t c = 0; c < N; c++) matrix[i * N + c] += 0.5 * matrix[k * N + c];
        for (size_t r = 0; r < N; r++) matrix[r * N + k] -= 0.5 * matrix[r * N + i];
    }
    expect_spectrum(N, spectrum_of(N, matrix), &wanted, 1e-9);
}

// ---------------------------------------------------------------- steps

/// x'' + 2 d x' + w^2 x = cos t, about whose forcing nothing is hidden: lambda = -d +- sqrt(d^2 - w^2).
typedef struct spring {
    double damping, square;
} spring;

static void spring_slope(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const spring *own = model;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = cos(t) - 2 * own->damping * x[1] - own->square * x[0];
}

static void spring_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                           size_t count, const double *dx, double *ddxdt) {
    const spring *own = model;
    (void)t, (void)forcing, (void)x, (void)sides;
    for (size_t i = 0; i < count; i++, dx += 2, ddxdt += 2) {
        ddxdt[0] = dx[1];
        ddxdt[1] = -2 * own->damping * dx[1] - own->square * dx[0];
    }
}

static whirl_step_check check_spring(double damping, double square, int steps, bool jacobian) {
    const spring model = {damping, square};
    const whirl_system system = {.dimension = 2,
                                 .period = 2 * pi,
                                 .rhs = spring_slope,
                                 .tangent = jacobian ? spring_tangent : NULL,
                                 .model = &model};
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    whirl_step_check check;
    const double start[2] = {0.1, 0.0};
    double end[2] = {0.1, 0.0};
    strcpy(options.method, "rk4");
    options.steps_per_revolution = steps;
    assert_int_equal(whirl_integrator_new(&system, &options, &integrator).code, WHIRL_OK);
    whirl_integrator_revolve(integrator, end, NULL, NULL);
    whirl_integrator_free(integrator);
    assert_int_equal(whirl_step_check_revolution(&system, &options, start, end, 1e-10, &check).code, WHIRL_OK);
    return check;
}

/// Real eigenvalues -r, -1/r (r = 1000): stable up to h r = 2.785293563. The Jacobian by the system or by differences.
static void test_the_limit_of_decay(void **state) {
    const double r = 1000, damping = 0.5 * (r + 1 / r), least = 2 * pi * r / 2.785293563405282;
    (void)state;
    for (int jacobian = 0; jacobian < 2; jacobian++) {
        const whirl_step_check good = check_spring(damping, 1, (int)ceil(least), jacobian);
        const whirl_step_check bad = check_spring(damping, 1, (int)(0.99 * least), jacobian);
        assert_false(whirl_step_is_unstable(&good));
        assert_true(good.steps == ceil(least));
        assert_true(whirl_step_is_unstable(&bad));
        assert_true(bad.steps >= least && bad.steps <= 1.1 * least);
        assert_true(isnan(bad.error)); // what the machine does is not looked at
        const double z = -2 * pi * r / (0.5 * least);
        const double growth = 1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4)));
        const whirl_step_check half = check_spring(damping, 1, (int)(0.5 * least), jacobian);
        assert_true(fabs(half.growth / growth - 1) < 1e-2);
    }
}

/// Without damping: stable up to h w = 2 sqrt 2.
static void test_the_limit_of_oscillation(void **state) {
    const double w = 200, least = 2 * pi * w / (2 * sqrt(2.0));
    (void)state;
    const whirl_step_check good = check_spring(0, w * w, (int)ceil(1.001 * least), true);
    const whirl_step_check bad = check_spring(0, w * w, (int)(0.98 * least), true);
    assert_false(whirl_step_is_unstable(&good));
    assert_true(good.error > 0.05); // stable, and yet all wrong: the mode is damped away that is not damped
    assert_true(whirl_step_is_unstable(&bad));
}

/// A machine that is unstable itself is no fault of the step.
static void test_what_grows_by_itself(void **state) {
    (void)state;
    const whirl_step_check slow = check_spring(-0.1, 4, 64, true), fast = check_spring(-3, 1, 64, true);
    assert_false(whirl_step_is_unstable(&slow));
    assert_false(whirl_step_is_unstable(&fast));
}

/// The error of a revolution by RK4 is the known one: of order 4, to the tolerance of what it is compared with.
static void test_the_error_of_a_revolution(void **state) {
    (void)state;
    const double coarse = check_spring(0.05, 4, 32, true).error, fine = check_spring(0.05, 4, 64, true).error;
    assert_true(fabs(log2(coarse / fine) - 4) < 0.2);
    assert_true(check_spring(0.05, 4, 4096, true).error < 1e-9);
}

static void test_methods_with_a_tolerance_are_left_alone(void **state) {
    const spring model = {1e6, 1};
    const whirl_system system = {.dimension = 2, .period = 2 * pi, .rhs = spring_slope, .model = &model};
    whirl_integrate_options options = whirl_integrate_default();
    const double start[2] = {0, 0};
    whirl_step_check check;
    (void)state;
    strcpy(options.method, "dop853");
    assert_int_equal(whirl_step_check_revolution(&system, &options, start, NULL, 1e-6, &check).code, WHIRL_OK);
    assert_true(check.growth == 1 && isnan(check.error));
    strcpy(options.method, "rk5");
    assert_int_equal(whirl_step_check_revolution(&system, &options, start, NULL, 1e-6, &check).code, WHIRL_BAD_INPUT);
}

/// dop853 crawls in proportion to the decay rate, with its own limit on the real axis; rodas5p does not.
static void test_what_stiffness_costs(void **state) {
    double steps[2];
    (void)state;
    for (int i = 0; i < 3; i++) {
        const double rates[] = {50, 1e4, 1e5}, r = rates[i];
        const spring model = {0.5 * (r + 1 / r), 1};
        const whirl_system system = {
            .dimension = 2, .period = 2 * pi, .rhs = spring_slope, .tangent = spring_tangent, .model = &model};
        const whirl_integrate_options options = whirl_integrate_default();
        const double from[2] = {0.1, 0.0};
        whirl_method_cost cost;
        assert_int_equal(whirl_method_probe(&system, &options, from, &cost).code, WHIRL_OK);
        if (i == 0) {
            assert_true(cost.dop853 == 0 && isnan(cost.rodas5p));
            continue;
        }
        steps[i - 1] = cost.dop853 / 12;
        // dop853 is stable on the negative axis where |R| <= 1, tried here in steps of a thousandth.
        double limit = 0;
        while (dop853_amplification(-limit - 1e-3, 0) <= 1) limit += 1e-3;
        const double least = 2 * pi * r / limit;
        assert_true(steps[i - 1] >= 0.999 * least && steps[i - 1] <= 1.06 * least);
        assert_true(cost.rodas5p > 100 && cost.rodas5p < 5e3);
    }
}

/// Stability functions are exp to the order of their method.
static void test_amplification(void **state) {
    (void)state;
    for (int i = 0; i < 8; i++) {
        const double angle = 0.25 * pi * i, z = 0.1, x = z * cos(angle), y = z * sin(angle);
        assert_true(fabs(rk4_amplification(x, y) - exp(x)) < 2 * pow(z, 5) / 120);
        assert_true(fabs(dop853_amplification(x, y) - exp(x)) < 1e-14);
        const double bx = 0.5 * cos(angle), by = 0.5 * sin(angle);
        assert_true(fabs(dop853_amplification(bx, by) - exp(bx)) < 1e-8);
    }
    assert_true(fabs(rk4_amplification(-2.785293563405282, 0) - 1) < 1e-12);
    assert_true(fabs(rk4_amplification(0, 2 * sqrt(2.0)) - 1) < 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_companion_matrices),
        cmocka_unit_test(test_cyclic_shifts),
        cmocka_unit_test(test_a_chain_of_masses),
        cmocka_unit_test(test_full_matrices),
        cmocka_unit_test(test_the_limit_of_decay),
        cmocka_unit_test(test_the_limit_of_oscillation),
        cmocka_unit_test(test_what_grows_by_itself),
        cmocka_unit_test(test_the_error_of_a_revolution),
        cmocka_unit_test(test_methods_with_a_tolerance_are_left_alone),
        cmocka_unit_test(test_amplification),
        cmocka_unit_test(test_what_stiffness_costs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
