// The Rosenbrock-Wanner method Rodas5P: its numbers against the conditions of their order, its stability, its
// interpolant, and problems that explicit methods crawl at, against closed forms.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "rodas5p_tableau.h"
#include "whirl/engine/integrate.h"

enum { S = RODAS5P_STAGES };

static void expect_near(double a, double b, double tolerance) {
    if (!(fabs(a - b) <= tolerance)) fail_msg("%.17g is not within %g of %.17g", a, tolerance, b);
}

// ---------------------------------------------------------------- the numbers

/// The method in the form of the literature: k_i = h f(x + sum alpha k) + h J sum gamma k, x1 = x + sum b k. With the
/// lower triangle g and the diagonal 1/gamma, Gamma = (diag(1/gamma) - g)^-1, alpha = a Gamma, b = (a_8, 1) Gamma.
typedef struct tableau {
    double alpha[S][S], beta[S][S], b[S], dense[3][S], gamma_sum[S];
} tableau;

/// Multiplies a row of weights of the increments by Gamma.
static void through_gamma(double gamma[S][S], const double *row, int count, double *out) {
    for (int j = 0; j < S; j++) {
        out[j] = 0.0;
        for (int i = j; i < count; i++) out[j] += row[i] * gamma[i][j];
    }
}

static tableau tableau_of_method(void) {
    tableau t = {0};
    double gamma[S][S] = {{0}}, last[S];
    for (int j = 0; j < S; j++)
        for (int i = j; i < S; i++) { // columns of the inverse
            double sum = i == j ? 1.0 : 0.0;
            for (int k = j; k < i; k++) sum += rodas5p_g[i][k] * gamma[k][j];
            gamma[i][j] = sum * rodas5p_gamma;
        }
    for (int i = 0; i < S; i++) {
        through_gamma(gamma, rodas5p_a[i], i, t.alpha[i]);
        for (int j = 0; j < S; j++) {
            t.beta[i][j] = t.alpha[i][j] + gamma[i][j];
            t.gamma_sum[i] += gamma[i][j];
        }
    }
    memcpy(last, rodas5p_a[S - 1], sizeof rodas5p_a[S - 1]);
    last[S - 1] = 1.0;
    through_gamma(gamma, last, S, t.b);
    for (int p = 0; p < 3; p++) through_gamma(gamma, rodas5p_h[p], S, t.dense[p]);
    return t;
}

/// A rooted tree by the trees that grow from its root: indices of earlier ones, ended by -1.
typedef struct tree {
    int order, density, branches[5];
} tree;

/// All trees of up to five nodes (Hairer, Norsett, Wanner 1993, II.2).
static const tree trees[] = {
    {1, 1, {-1}},        {2, 2, {0, -1}},     {3, 3, {0, 0, -1}},  {3, 6, {1, -1}},          {4, 4, {0, 0, 0, -1}},
    {4, 8, {0, 1, -1}},  {4, 12, {2, -1}},    {4, 24, {3, -1}},    {5, 5, {0, 0, 0, 0, -1}}, {5, 10, {0, 0, 1, -1}},
    {5, 15, {0, 2, -1}}, {5, 30, {0, 3, -1}}, {5, 20, {1, 1, -1}}, {5, 20, {4, -1}},         {5, 40, {5, -1}},
    {5, 60, {6, -1}},    {5, 120, {7, -1}}};
enum { TREES = sizeof trees / sizeof *trees };

/// Computes the elementary weights of all stages: a node with one branch is reached by beta, with several by alpha
/// (Hairer, Wanner 1996, IV.7).
static void weigh(const tableau *t, double phi[TREES][S]) {
    for (int n = 0; n < TREES; n++)
        for (int i = 0; i < S; i++) {
            const bool alone = trees[n].branches[0] >= 0 && trees[n].branches[1] < 0;
            phi[n][i] = 1.0;
            for (int k = 0; trees[n].branches[k] >= 0; k++) {
                double sum = 0.0;
                for (int j = 0; j < S; j++) sum += (alone ? t->beta : t->alpha)[i][j] * phi[trees[n].branches[k]][j];
                phi[n][i] *= sum;
            }
        }
}

static double weighted(const double *b, const double *phi) {
    double sum = 0.0;
    for (int i = 0; i < S; i++) sum += b[i] * phi[i];
    return sum;
}

static void test_numbers_meet_their_conditions(void **state) {
    (void)state;
    const tableau t = tableau_of_method();
    double phi[TREES][S], embedded[S];
    bool some_fail = false;
    weigh(&t, phi);
    for (int i = 0; i < S; i++) {
        double sum = 0.0;
        for (int j = 0; j < i; j++) sum += t.alpha[i][j];
        expect_near(sum, rodas5p_c[i], 1e-13);
        expect_near(t.gamma_sum[i], rodas5p_d[i], 1e-13);
        embedded[i] = t.beta[S - 2][i]; // the result without the last increment
    }
    for (int n = 0; n < TREES; n++) {
        expect_near(weighted(t.b, phi[n]), 1.0 / trees[n].density, 2e-14);
        if (trees[n].order < 5) expect_near(weighted(embedded, phi[n]), 1.0 / trees[n].density, 2e-14);
        some_fail = some_fail || fabs(weighted(embedded, phi[n]) - 1.0 / trees[n].density) > 1e-4;
    }
    assert_true(some_fail); // so that the difference is an error of order 4
}

static void test_interpolant_has_order_four(void **state) {
    (void)state;
    const tableau t = tableau_of_method();
    double phi[TREES][S], b[S];
    weigh(&t, phi);
    for (double theta = 0.125; theta < 1.0; theta += 0.125) {
        const double rest = 1.0 - theta;
        for (int i = 0; i < S; i++)
            b[i] = theta * (t.b[i] + rest * (t.dense[0][i] + theta * (t.dense[1][i] + theta * t.dense[2][i])));
        for (int n = 0; n < TREES && trees[n].order < 5; n++)
            expect_near(weighted(b, phi[n]), pow(theta, trees[n].order) / trees[n].density, 1e-13);
    }
}

/// Returns R(z), from the increments on x' = z x from x = 1.
static double complex amplification(double complex z) {
    double complex u[S], x = 1.0;
    for (int i = 0; i < S; i++) {
        double complex sum = 0.0;
        x = 1.0;
        for (int j = 0; j < i; j++) {
            x += rodas5p_a[i][j] * u[j];
            sum += rodas5p_g[i][j] * u[j];
        }
        u[i] = (z * x + sum) / (1.0 / rodas5p_gamma - z);
    }
    return x + u[S - 1];
}

static void test_stiff_modes_are_damped(void **state) {
    (void)state;
    // On the imaginary axis, so in the whole left half plane by the maximum principle: the only pole is 1/gamma.
    for (double y = 1e-3; y < 1e9; y *= 1.07) assert_true(cabs(amplification(I * y)) <= 1.0 + 1e-14);
    assert_true(cabs(amplification(-1e10)) < 1e-7);
    expect_near(cabs(amplification(-0.01) - cexp(-0.01)), 0.0, 1e-14);
}

// ---------------------------------------------------------------- motions

static whirl_integrator *integrator_of(const whirl_system *system, const char *by, double rtol) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    strcpy(options.method, by);
    options.rtol = rtol;
    options.atol = 1e-3 * rtol;
    options.steps_per_revolution = 40;
    assert_int_equal(whirl_integrator_new(system, &options, &integrator).code, WHIRL_OK);
    return integrator;
}

/// A stiff equation that counts the calls of its right-hand side.
typedef struct stiff_model {
    double rate;
    long *asked;
} stiff_model;

/// x' = -rate (x - cos t) - sin t (Prothero and Robinson 1974): the solution is x = cos t, and deviations from it decay
/// at once.
static void stiff_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const stiff_model *own = model;
    (void)forcing;
    if (own->asked) ++*own->asked;
    dxdt[0] = -own->rate * (x[0] - cos(t)) - sin(t);
}

static void compare_with_cosine(void *observer, double t, const double *x) {
    double *worst = observer;
    *worst = fmax(*worst, fabs(x[0] - cos(t)));
}

static void test_stiff_problem(void **state) {
    (void)state;
    static const double tolerances[] = {1e-5, 1e-7, 1e-9};
    for (double rate = 1e2; rate < 1e9; rate *= 100.0)
        for (int i = 0; i < 3; i++) {
            long asked = 0;
            double x = 1.0, worst = 0.0;
            const stiff_model model = {rate, &asked};
            const whirl_system system = {.dimension = 1, .period = 4.0, .rhs = stiff_rhs, .model = &model};
            whirl_integrator *integrator = integrator_of(&system, "rodas5p", tolerances[i]);
            assert_int_equal(whirl_integrator_revolve(integrator, &x, compare_with_cosine, &worst), WHIRL_BOUNDED);
            expect_near(x, cos(4.0), 10.0 * tolerances[i]);
            expect_near(worst, 0.0, 10.0 * tolerances[i]); // within steps as well
            assert_in_range(asked, 1, 15000);              // an explicit method would need 1e9
            whirl_integrator_free(integrator);
        }
}

/// x'' = -x^3 - 0.3 x' + 2 cos t - x/2 cos 2t, and its Jacobian.
static void duffing_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -x[0] * x[0] * x[0] - 0.3 * x[1] + 2.0 * cos(t) - 0.5 * x[0] * cos(2.0 * t);
}
static void duffing_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                            size_t count, const double *dx, double *ddxdt) {
    (void)model, (void)forcing, (void)sides;
    for (size_t i = 0; i < count; i++, dx += 2, ddxdt += 2) {
        ddxdt[0] = dx[1];
        ddxdt[1] = (-3.0 * x[0] * x[0] - 0.5 * cos(2.0 * t)) * dx[0] - 0.3 * dx[1];
    }
}
static double duffing_divergence(const void *model, double t, const double *forcing, const double *x,
                                 const double *sides) {
    (void)model, (void)t, (void)forcing, (void)x, (void)sides;
    return -0.3;
}

static const whirl_system duffing = {.dimension = 2, .period = 6.283185307179586, .rhs = duffing_rhs};

static void test_with_the_jacobian_and_without(void **state) {
    (void)state;
    whirl_system with_tangent = duffing;
    with_tangent.tangent = duffing_tangent;
    const whirl_system *systems[] = {&duffing, &with_tangent};
    double exact[2] = {1.0, 0.0};
    whirl_integrator *reference = integrator_of(&duffing, "dop853", 1e-14);
    whirl_integrator_revolve(reference, exact, NULL, NULL);
    whirl_integrator_free(reference);
    for (int i = 0; i < 2; i++)
        for (double rtol = 1e-6; rtol > 1e-13; rtol *= 1e-3) {
            double x[2] = {1.0, 0.0};
            whirl_integrator *integrator = integrator_of(systems[i], "rodas5p", rtol);
            assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
            for (int d = 0; d < 2; d++) expect_near(x[d], exact[d], 10.0 * rtol);
            whirl_integrator_free(integrator);
        }
}

/// The monodromy matrix agrees with differences of motions, its determinant with exp(-0.3 period) and with the volume.
static void test_perturbations(void **state) {
    (void)state;
    whirl_system system = duffing;
    system.tangent = duffing_tangent;
    system.divergence = duffing_divergence;
    whirl_integrator *integrator = integrator_of(&system, "rodas5p", 1e-10);
    whirl_integrator *reference = integrator_of(&system, "dop853", 1e-13);
    double unit[4] = {1.0, 0.0, 0.0, 1.0}, exact[4] = {1.0, 0.0, 0.0, 1.0}, x[2] = {1.0, 0.0}, y[2] = {1.0, 0.0};
    whirl_perturbations own = {.count = 2, .vectors = unit}, theirs = {.count = 2, .vectors = exact};
    assert_int_equal(whirl_integrator_follow(integrator, 2).code, WHIRL_OK);
    assert_int_equal(whirl_integrator_follow(reference, 2).code, WHIRL_OK);
    assert_int_equal(whirl_integrator_carry(integrator, x, &own, NULL, NULL), WHIRL_BOUNDED);
    assert_int_equal(whirl_integrator_carry(reference, y, &theirs, NULL, NULL), WHIRL_BOUNDED);
    for (int i = 0; i < 4; i++) expect_near(unit[i], exact[i], 2e-9);
    expect_near(log(unit[0] * unit[3] - unit[1] * unit[2]), -0.3 * system.period, 1e-8);
    expect_near(own.volume, -0.3 * system.period, 1e-12);
    whirl_integrator_free(integrator);
    whirl_integrator_free(reference);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers_meet_their_conditions), cmocka_unit_test(test_interpolant_has_order_four),
        cmocka_unit_test(test_stiff_modes_are_damped),        cmocka_unit_test(test_stiff_problem),
        cmocka_unit_test(test_with_the_jacobian_and_without), cmocka_unit_test(test_perturbations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
