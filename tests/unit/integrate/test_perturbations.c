// Perturbations carried along motions, against finite differences of the flow: smooth, through impacts with contact
// damping, through reversals of dry friction, and along them.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "orthonormal.h"
#include "saltation.h"
#include "whirl/engine/integrate.h"

static double uniform(uint64_t *seed) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0 - 0.5;
}

// ---------------------------------------------------------------- an oscillator between a stop and a moving belt

/// x'' + 2 zeta x' + x + cubic x^3 = force cos(t + phase) - [x > gap and N > 0] N - friction sgn(x' - belt), N =
/// stiffness (x - gap) + damping x'.
typedef struct oscillator {
    double zeta, cubic, force, phase;
    double gap, stiffness, damping;
    double friction, belt, slope; ///< friction falls by `slope` for a unit of sliding
} oscillator;

enum { GAP, NORMAL, SLIP, SWITCHES };

static void oscillator_switches(const void *model, double t, const double *x, double *values) {
    const oscillator *o = model;
    (void)t;
    values[GAP] = x[0] - o->gap;
    values[NORMAL] = o->stiffness * (x[0] - o->gap) + o->damping * x[1];
    values[SLIP] = x[1] - o->belt;
}

static void oscillator_on_sides(const void *model, double t, const double *forcing, const double *x,
                                const double *sides, double *dxdt) {
    const oscillator *o = model;
    (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = o->force * cos(t + o->phase) - 2.0 * o->zeta * x[1] - x[0] - o->cubic * x[0] * x[0] * x[0];
    if (sides[GAP] > 0.0 && sides[NORMAL] > 0.0) dxdt[1] -= o->stiffness * (x[0] - o->gap) + o->damping * x[1];
    dxdt[1] -= sides[SLIP] * o->friction * (1.0 - o->slope * sides[SLIP] * (x[1] - o->belt));
}

static void sides_at(const void *model, const double *x, double *sides) {
    oscillator_switches(model, 0.0, x, sides);
    for (int i = 0; i < SWITCHES; i++) sides[i] = sides[i] > 0.0 ? 1.0 : -1.0;
}

static void oscillator_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    double sides[SWITCHES];
    sides_at(model, x, sides);
    oscillator_on_sides(model, t, forcing, x, sides, dxdt);
}

static void oscillator_tangent(const void *model, double t, const double *forcing, const double *x, const double *sides,
                               size_t count, const double *dx, double *ddxdt) {
    const oscillator *o = model;
    double own[SWITCHES];
    (void)t, (void)forcing;
    if (!sides) {
        sides_at(model, x, own);
        sides = own;
    }
    double stiff = 1.0 + 3.0 * o->cubic * x[0] * x[0], damp = 2.0 * o->zeta - o->friction * o->slope;
    if (sides[GAP] > 0.0 && sides[NORMAL] > 0.0) {
        stiff += o->stiffness;
        damp += o->damping;
    }
    for (size_t k = 0; k < count; k++) {
        ddxdt[2 * k] = dx[2 * k + 1];
        ddxdt[2 * k + 1] = -stiff * dx[2 * k] - damp * dx[2 * k + 1];
    }
}

static double oscillator_divergence(const void *model, double t, const double *forcing, const double *x,
                                    const double *sides) {
    const double unit[2] = {0.0, 1.0};
    double column[2];
    oscillator_tangent(model, t, forcing, x, sides, 1, unit, column);
    return column[1];
}

static void oscillator_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                                double *by_time) {
    const oscillator *o = model;
    (void)t, (void)x;
    gradient[0] = index == GAP ? 1.0 : index == NORMAL ? o->stiffness : 0.0;
    gradient[1] = index == GAP ? 0.0 : index == NORMAL ? o->damping : 1.0;
    *by_time = 0.0;
}

static void no_curvature(const void *model, double t, const double *x, size_t index, const double *u, double *out) {
    (void)model, (void)t, (void)x, (void)index, (void)u;
    out[0] = out[1] = 0.0;
}

static whirl_system make_system(const oscillator *o) {
    return (whirl_system){.dimension = 2,
                          .period = 6.283185307179586477,
                          .rhs = oscillator_rhs,
                          .rhs_on_sides = oscillator_on_sides,
                          .tangent = oscillator_tangent,
                          .divergence = oscillator_divergence,
                          .switch_count = SWITCHES,
                          .switches = oscillator_switches,
                          .switch_gradient = oscillator_gradient,
                          .switch_curvature = no_curvature,
                          .model = o};
}

static const oscillator smooth = {.zeta = 0.1, .cubic = 0.5, .force = 1.2, .gap = 1e3, .stiffness = 1.0, .belt = 1e3};
static const oscillator impacts = {
    .zeta = 0.05, .force = 1.5, .gap = 0.3, .stiffness = 30.0, .damping = 2.0, .belt = 1e3};
static const oscillator reversals = {
    .zeta = 0.02, .force = 2.0, .gap = 1e3, .stiffness = 1.0, .friction = 0.2, .belt = 0.1, .slope = 0.1};
/// Sticks to the belt for a part of every revolution.
static const oscillator sticks = {.zeta = 0.02,
                                  .force = 0.5,
                                  .phase = 2.5,
                                  .gap = 1e3,
                                  .stiffness = 1.0,
                                  .friction = 0.8,
                                  .belt = 0.25,
                                  .slope = 0.2};

// ---------------------------------------------------------------- flows

static whirl_integrator *make_integrator(const whirl_system *system, const char *method, int steps) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    options.located = strcmp(method, "rk4, located") == 0;
    strcpy(options.method, options.located ? "rk4" : method);
    options.steps_per_revolution = steps;
    options.rtol = 1e-12;
    options.atol = 1e-14;
    assert_int_equal(whirl_integrator_new(system, &options, &integrator).code, WHIRL_OK);
    const size_t most = strncmp(method, "cvode", 5) == 0 ? 1 : 2;
    assert_int_equal(whirl_integrator_follow(integrator, most).code, WHIRL_OK);
    return integrator;
}

static void revolve(whirl_integrator *integrator, double *x) {
    assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
}

/// Computes d(flow)/dx by central differences of order four, column after column.
static void difference_flow(whirl_integrator *integrator, const double *x, double step, double *columns) {
    static const double offsets[4] = {-2.0, -1.0, 1.0, 2.0}, weights[4] = {1.0, -8.0, 8.0, -1.0};
    memset(columns, 0, 4 * sizeof *columns);
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < 4; k++) {
            double z[2] = {x[0], x[1]};
            z[j] += offsets[k] * step;
            revolve(integrator, z);
            for (int i = 0; i < 2; i++) columns[2 * j + i] += weights[k] * z[i] / (12.0 * step);
        }
}

/// Computes the monodromy over a revolution from x, which is carried on. Returns the growth of the volume.
static double carry_columns(whirl_integrator *integrator, double *x, double *columns) {
    whirl_perturbations set = {.count = 2, .vectors = columns};
    const double unit[4] = {1.0, 0.0, 0.0, 1.0};
    memcpy(columns, unit, sizeof unit);
    assert_int_equal(whirl_integrator_carry(integrator, x, &set, NULL, NULL), WHIRL_BOUNDED);
    return set.volume;
}

static double worst_difference(const double *a, const double *b) {
    double worst = 0.0, size = 0.0;
    for (int i = 0; i < 4; i++) {
        worst = fmax(worst, fabs(a[i] - b[i]));
        size = fmax(size, fabs(b[i]));
    }
    return worst / size;
}

/// Compares over `revolutions` after a few that let the motion find its way; gives the largest difference.
static double compare_flow(const oscillator *o, const char *method, int steps, double step, double *volume_error) {
    enum { BEFORE = 5, COMPARED = 6 };
    const whirl_system system = make_system(o);
    whirl_integrator *integrator = make_integrator(&system, method, steps);
    double x[2] = {0.1, 0.2}, worst = 0.0;
    *volume_error = 0.0;
    for (int i = 0; i < BEFORE; i++) revolve(integrator, x);
    for (int i = 0; i < COMPARED; i++) {
        double theirs[4], ours[4], alone[2] = {x[0], x[1]};
        const bool on_belt = fabs(x[1] - o->belt) < 1e-9;
        difference_flow(integrator, x, step, theirs);
        const double volume = carry_columns(integrator, x, ours);
        revolve(integrator, alone);
        if (strncmp(method, "rk4", 3) == 0)
            assert_memory_equal(alone, x, sizeof alone);
        else // the perturbations may shorten its steps
            assert_true(fabs(alone[0] - x[0]) < 1e-10 && fabs(alone[1] - x[1]) < 1e-10);
        // Off the belt a start is drawn back to it at once, to the second order of how far it was off.
        if (on_belt) {
            assert_true(fabs(ours[2]) < 1e-12 && fabs(ours[3]) < 1e-12);
            assert_true(fabs(theirs[2]) < step && fabs(theirs[3]) < 10.0 * step);
            theirs[2] = theirs[3] = 0.0;
        }
        worst = fmax(worst, worst_difference(ours, theirs));
        const double error = fabs(volume - log(fabs(ours[0] * ours[3] - ours[1] * ours[2])));
        if (!(error <= *volume_error)) *volume_error = error; // not a number stays
    }
    whirl_integrator_free(integrator);
    printf("%s: %g from the flow's differences, volume %g\n", method, worst, *volume_error);
    return worst;
}

static void test_smooth_motion(void **state) {
    double volume;
    (void)state;
    assert_true(compare_flow(&smooth, "rk4", 256, 1e-3, &volume) < 1e-9); // the exact derivative of the steps
    assert_true(volume < 1e-6);
    assert_true(compare_flow(&smooth, "dop853", 64, 1e-3, &volume) < 1e-9);
    assert_true(volume < 1e-9);
    assert_true(compare_flow(&smooth, "rodas5p", 64, 1e-3, &volume) < 1e-9);
    assert_true(volume < 1e-9);
}

static void test_impacts_with_contact_damping(void **state) {
    double volume;
    (void)state;
    assert_true(compare_flow(&impacts, "dop853", 64, 1e-4, &volume) < 1e-8);
    assert_true(volume < 1e-9);
    assert_true(compare_flow(&impacts, "rodas5p", 64, 1e-4, &volume) < 1e-8);
    assert_true(volume < 1e-9);
}

/// Steps of order four that are split at the switches.
static void test_located_switches_of_fixed_steps(void **state) {
    double volume;
    (void)state;
    assert_true(compare_flow(&impacts, "rk4, located", 1024, 1e-4, &volume) < 1e-7);
    assert_true(volume < 1e-6);
    assert_true(compare_flow(&reversals, "rk4, located", 1024, 1e-4, &volume) < 1e-7);
    assert_true(compare_flow(&sticks, "rk4, located", 1024, 1e-4, &volume) < 1e-7);
}

/// Steps that walk over the impacts know them to the first order of their length.
static void test_impacts_that_are_not_located(void **state) {
    const whirl_system system = make_system(&impacts);
    double worst[2] = {0.0, 0.0};
    (void)state;
    for (int k = 0; k < 2; k++) {
        whirl_integrator *exact = make_integrator(&system, "dop853", 64);
        whirl_integrator *unlocated = make_integrator(&system, "rk4", k ? 65536 : 4096);
        double x[2] = {0.1, 0.2}, theirs[4], ours[4];
        for (int i = 0; i < 10; i++) {
            double z[2] = {x[0], x[1]};
            const double volume = carry_columns(unlocated, z, ours);
            assert_true(fabs(volume - carry_columns(exact, x, theirs)) < (k ? 2e-4 : 3e-3));
            worst[k] = fmax(worst[k], worst_difference(ours, theirs));
        }
        whirl_integrator_free(exact);
        whirl_integrator_free(unlocated);
    }
    printf("not located: %g with 4096 steps, %g with 65536\n", worst[0], worst[1]);
    assert_true(worst[0] < 3e-2 && worst[1] < 2e-3);
}

static void test_reversals_of_friction(void **state) {
    double volume;
    (void)state;
    assert_true(compare_flow(&reversals, "dop853", 64, 1e-4, &volume) < 1e-8);
    assert_true(volume < 1e-9);
    assert_true(compare_flow(&reversals, "rodas5p", 64, 1e-4, &volume) < 1e-8);
    assert_true(volume < 1e-9);
}

static void test_sticking(void **state) {
    double volume;
    (void)state;
    assert_true(compare_flow(&sticks, "dop853", 64, 1e-4, &volume) < 1e-8);
    assert_false(volume == volume); // the area is lost: there is no logarithm of it
    assert_true(compare_flow(&sticks, "rodas5p", 64, 1e-4, &volume) < 1e-8);
    assert_false(volume == volume); // the area is lost: there is no logarithm of it
}

/// At an equilibrium only the perturbations limit the steps: x'' + 2 zeta x' + x = 0 at rest has a monodromy in closed
/// form.
static void test_perturbations_of_an_equilibrium(void **state) {
    const oscillator linear = {.zeta = 0.1, .gap = 1e3, .stiffness = 1.0, .belt = 1e3};
    const whirl_system system = make_system(&linear);
    const double w = sqrt(1.0 - linear.zeta * linear.zeta), T = system.period, shrunk = exp(-linear.zeta * T);
    const double c = cos(w * T), s = sin(w * T) / w;
    const double expected[4] = {shrunk * (c + linear.zeta * s), -shrunk * s, shrunk * s,
                                shrunk * (c - linear.zeta * s)};
    const char *const methods[] = {"dop853", "rodas5p"};
    (void)state;
    for (int m = 0; m < 2; m++) {
        whirl_integrator *integrator = make_integrator(&system, methods[m], 64);
        double x[2] = {0.0, 0.0}, columns[4];
        const double volume = carry_columns(integrator, x, columns);
        assert_true(worst_difference(columns, expected) < 1e-11);
        assert_true(fabs(volume + 2.0 * linear.zeta * T) < 1e-11);
        whirl_integrator_free(integrator);
    }
}

// ---------------------------------------------------------------- parts

static void test_saltation_of_a_broken_line(void **state) {
    // Slope f- before and f+ behind the moving line n . x = c t: all is in closed form.
    const double before[2] = {1.0, 0.5}, after[2] = {-0.3, 2.0}, normal[2] = {0.8, -0.6}, by_time = 0.7;
    double vectors[4] = {1.0, 0.0, 0.0, 1.0};
    (void)state;
    const double ln = saltate(2, before, after, normal, by_time, 2, vectors);
    const double rate = normal[0] * before[0] + normal[1] * before[1] + by_time;
    for (int k = 0; k < 2; k++) {
        // A start shifted by u meets the line earlier by n . u/rate and has f+ in place of f- for that long.
        const double earlier = normal[k] / rate;
        for (int i = 0; i < 2; i++)
            assert_true(fabs(vectors[2 * k + i] - ((i == k ? 1.0 : 0.0) + earlier * (after[i] - before[i]))) < 1e-15);
    }
    assert_true(fabs(ln - log(fabs(vectors[0] * vectors[3] - vectors[1] * vectors[2]))) < 1e-14);
    const double along[2] = {0.6, 0.8}; // touches a line at rest
    double kept[2] = {0.3, 0.4};
    assert_true(saltate(2, along, after, normal, 0.0, 1, kept) == 0.0 && kept[0] == 0.3 && kept[1] == 0.4);
}

static void test_orthonormal_vectors(void **state) {
    enum { N = 7 };
    double vectors[N * N], before[N * N], growth[N] = {0.0};
    uint64_t seed = 3;
    (void)state;
    for (int i = 0; i < N * N; i++) vectors[i] = uniform(&seed);
    for (int i = 0; i < N; i++) vectors[N + i] = vectors[i] * 3.0 + 1e-11 * vectors[N + i]; // almost along the first
    for (int i = 0; i < N; i++) vectors[5 * N + i] = 0.0;                                   // nothing at all
    memcpy(before, vectors, sizeof vectors);
    make_orthonormal(N, N, vectors, growth);
    for (int j = 0; j < N; j++)
        for (int k = 0; k < N; k++) {
            double product = 0.0, along = 0.0;
            for (int i = 0; i < N; i++) {
                product += vectors[j * N + i] * vectors[k * N + i];
                along += vectors[j * N + i] * before[k * N + i];
            }
            assert_true(fabs(product - (j == k ? 1.0 : 0.0)) < 4e-16 * N);
            if (j > k) assert_true(fabs(along) < 1e-15); // within the span of those before
            if (j == k && k != 5) assert_true(fabs(log(fabs(along)) - growth[k]) < 1e-4);
        }
    assert_true(growth[5] < -700.0);
}

/// CVODE's equations of one perturbation against the derivative of dop853's steps, column after column, through
/// impacts, reversals and sticking; revolutions with and without a perturbation by turns.
static void test_one_perturbation_by_cvode(void **state) {
    static const oscillator *const machines[] = {&smooth, &impacts, &reversals, &sticks};
    static const char *const methods[] = {"cvode-bdf", "cvode-adams"};
    (void)state;
    for (size_t m = 0; m < 2 * sizeof machines / sizeof *machines; m++) {
        const whirl_system system = make_system(machines[m / 2]);
        whirl_integrator *exact = make_integrator(&system, "dop853", 64);
        whirl_integrator *integrator = make_integrator(&system, methods[m % 2], 64);
        double x[2] = {0.1, 0.2}, theirs[4], ours[4], worst = 0.0;
        for (int i = 0; i < 8; i++) {
            for (int k = 0; k < 2; k++) {
                double z[2] = {x[0], x[1]}, *column = ours + 2 * k;
                whirl_perturbations set = {.count = 1, .vectors = column};
                column[0] = k == 0;
                column[1] = k == 1;
                assert_int_equal(whirl_integrator_carry(integrator, z, &set, NULL, NULL), WHIRL_BOUNDED);
                double alone[2] = {x[0], x[1]};
                revolve(integrator, alone);
                assert_true(fabs(alone[0] - z[0]) < 1e-8 && fabs(alone[1] - z[1]) < 1e-8);
            }
            carry_columns(exact, x, theirs);
            worst = fmax(worst, worst_difference(ours, theirs));
        }
        printf("%s, machine %zu: %g from dop853\n", methods[m % 2], m / 2, worst);
        assert_true(worst < 1e-5);
        whirl_integrator_free(exact);
        whirl_integrator_free(integrator);
    }
}

/// Growth in every revolution sums to the volume, and its mean to the exponents -zeta +- i of a linear oscillator.
static void test_growth_of_all_perturbations(void **state) {
    const oscillator linear = {.zeta = 0.1, .force = 0.3, .gap = 1e3, .stiffness = 1.0, .belt = 1e3};
    const whirl_system system = make_system(&linear);
    const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    (void)state;
    for (int m = 0; m < 3; m++) {
        whirl_integrator *integrator = make_integrator(&system, methods[m], 512);
        double x[2] = {0.0, 0.0}, vectors[4] = {1.0, 0.0, 0.0, 1.0}, growth[2], sum[2] = {0.0, 0.0};
        double total = 0.0;
        whirl_perturbations set = {.count = 2, .vectors = vectors, .growth = growth};
        for (int i = 0; i < 400; i++) {
            assert_int_equal(whirl_integrator_carry(integrator, x, &set, NULL, NULL), WHIRL_BOUNDED);
            total += set.volume;
            assert_true(fabs(growth[0] + growth[1] - set.volume) < (m ? 1e-11 : 1e-8));
            for (int k = 0; k < 2; k++) sum[k] += growth[k];
        }
        // Either exponent is -zeta; the sums differ by what the ellipse of perturbations turns, which stays bounded.
        const double each = -0.1 * system.period * 400.0;
        assert_true(fabs(sum[0] - each) < 0.2 && fabs(sum[1] - each) < 0.2);
        assert_true(fabs(sum[0] + sum[1] - 2.0 * each) < (m ? 1e-9 : 1e-6) && fabs(total - 2.0 * each) < 1e-9);
        whirl_integrator_free(integrator);
    }
}

static void test_what_cannot_be_followed(void **state) {
    whirl_system system = make_system(&smooth);
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    (void)state;
    assert_int_equal(whirl_integrator_new(&system, &options, &integrator).code, WHIRL_OK);
    assert_non_null(strstr(whirl_integrator_follow(integrator, 3).message, "at most the dimension, 2"));
    double x[2] = {0.0, 0.0}, vectors[2] = {1.0, 0.0};
    whirl_perturbations set = {.count = 1, .vectors = vectors};
    assert_int_equal(whirl_integrator_carry(integrator, x, &set, NULL, NULL), WHIRL_STUCK); // no room was made
    whirl_integrator_free(integrator);
    strcpy(options.method, "cvode-bdf");
    assert_int_equal(whirl_integrator_new(&system, &options, &integrator).code, WHIRL_OK);
    assert_non_null(strstr(whirl_integrator_follow(integrator, 2).message, "no more than one perturbation along"));
    whirl_integrator_free(integrator);
    strcpy(options.method, "rk4");
    system.tangent = NULL;
    assert_int_equal(whirl_integrator_new(&system, &options, &integrator).code, WHIRL_OK);
    assert_non_null(strstr(whirl_integrator_follow(integrator, 1).message, "no Jacobian"));
    whirl_integrator_free(integrator);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_smooth_motion),
        cmocka_unit_test(test_impacts_with_contact_damping),
        cmocka_unit_test(test_located_switches_of_fixed_steps),
        cmocka_unit_test(test_impacts_that_are_not_located),
        cmocka_unit_test(test_reversals_of_friction),
        cmocka_unit_test(test_sticking),
        cmocka_unit_test(test_perturbations_of_an_equilibrium),
        cmocka_unit_test(test_saltation_of_a_broken_line),
        cmocka_unit_test(test_orthonormal_vectors),
        cmocka_unit_test(test_one_perturbation_by_cvode),
        cmocka_unit_test(test_growth_of_all_perturbations),
        cmocka_unit_test(test_what_cannot_be_followed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
