// The pair of order 8(5,3): its numbers, its interpolant, and motions that switch, slide and graze, against closed
// forms, by Rodas5P as well; those that slide also by CVODE, which fixes the sides of switches in the same way.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "adaptive_lanes.h"
#include "crossing.h"
#include "stepper.h"

static const double pi = 3.14159265358979323846;

static whirl_integrator *integrator_by(const char *by, const whirl_system *system, double rtol, double atol) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    strcpy(options.method, by);
    options.rtol = rtol;
    options.atol = atol;
    options.steps_per_revolution = 100;
    assert_int_equal(whirl_integrator_new(system, &options, &integrator).code, WHIRL_OK);
    return integrator;
}

static whirl_motion carry_by(const char *by, const whirl_system *system, double rtol, double atol, int revolutions,
                             double *x) {
    whirl_integrator *integrator = integrator_by(by, system, rtol, atol);
    whirl_motion motion = WHIRL_BOUNDED;
    for (int i = 0; i < revolutions && motion == WHIRL_BOUNDED; i++)
        motion = whirl_integrator_revolve(integrator, x, NULL, NULL);
    whirl_integrator_free(integrator);
    return motion;
}

/// Methods whose steps a stepper takes.
static const char *const stepped[] = {"dop853", "rodas5p"};
enum { STEPPED = sizeof stepped / sizeof *stepped };

// ---------------------------------------------------------------- the numbers

static void expect_near(double a, double b, double tolerance) {
    if (!(fabs(a - b) <= tolerance)) fail_msg("%.17g is not within %g of %.17g", a, tolerance, b);
}

/// Returns the sum of weight[j] c[j]^power over the stages.
static double moment(const double *weight, int power) {
    double sum = 0.0;
    for (int j = 0; j < DOP853_STAGES; j++) sum += weight[j] * pow(dop853_c[j], power);
    return sum;
}

static void test_numbers_meet_their_conditions(void **state) {
    (void)state;
    const double *b = dop853_a[DOP853_STAGES];
    for (int i = 0; i < DOP853_SLOPES; i++) {
        double sum[3] = {0};
        for (int j = 0; j < i; j++)
            for (int p = 0; p < 3; p++) sum[p] += dop853_a[i][j] * pow(dop853_c[j], p);
        expect_near(sum[0], dop853_c[i], 1e-13);
        if (i != 1) expect_near(sum[1], pow(dop853_c[i], 2) / 2, 1e-13);           // C(2)
        if (i != 1 && i != 2) expect_near(sum[2], pow(dop853_c[i], 3) / 3, 1e-13); // C(3)
    }
    for (int p = 0; p < 8; p++) expect_near(moment(b, p), 1.0 / (p + 1), 1e-14);
    // The embedded formulas integrate polynomials as their orders 5 and 3 promise, and no further.
    for (int p = 0; p < 5; p++) expect_near(moment(dop853_e5, p), 0.0, 1e-13);
    for (int p = 0; p < 3; p++) expect_near(moment(dop853_e3, p), 0.0, 1e-13);
    assert_true(fabs(moment(dop853_e5, 5)) > 1e-4 && fabs(moment(dop853_e3, 3)) > 1e-4);
    for (int j = 0; j < DOP853_STAGES; j++) { // D(1)
        double sum = 0.0;
        for (int i = j + 1; i < DOP853_STAGES; i++) sum += b[i] * dop853_a[i][j];
        expect_near(sum, b[j] * (1.0 - dop853_c[j]), 1e-13);
    }
}

/// Returns the sum of weights times c^power of one of the sums.
static double sum_moment(const slope_sums *sums, size_t which, int power) {
    double total = 0.0;
    for (size_t j = 0; j < sums->count; j++) total += sums->weight[j][which] * pow(dop853_c[sums->place[j]], power);
    return total;
}

static void test_sums_of_accelerations(void **state) {
    (void)state;
    dop853_sums sums;
    dop853_sums_fill(&sums, 1);
    for (int i = 1; i < DOP853_SLOPES; i++) {
        const slope_sums *stage = &sums.stage[i];
        assert_in_range(stage->count, 1, i);
        assert_true(stage->weight[stage->count - 1][POSITION] == 0.0); // as the kernels take it
        expect_near(sum_moment(stage, VELOCITY, 0), dop853_c[i], 1e-13);
        if (i > 1) expect_near(sum_moment(stage, POSITION, 0), pow(dop853_c[i], 2) / 2.0, 1e-13);
    }
    // A position under the acceleration t^p moves by 1/((p + 1)(p + 2)).
    for (int p = 0; p < 7; p++)
        expect_near(sum_moment(&sums.stage[DOP853_STAGES], POSITION, p), 1.0 / ((p + 1.0) * (p + 2.0)), 1e-14);
    // Errors vanish for the polynomials that the formulas of order 5 and 3 integrate; of positions for one power less.
    for (int p = 0; p < 5; p++) {
        if (p < 4) expect_near(sum_moment(&sums.error, 0, p), 0.0, 1e-13);
        expect_near(sum_moment(&sums.error, 1, p), 0.0, 1e-13);
        if (p < 2) expect_near(sum_moment(&sums.error, 2, p), 0.0, 1e-13);
        if (p < 3) expect_near(sum_moment(&sums.error, 3, p), 0.0, 1e-13);
    }
}

/// x' = t^p/p!: x = t^(p+1)/(p+1)!
static void power_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const int p = *(const int *)model;
    (void)forcing, (void)x;
    dxdt[0] = pow(t, p) / tgamma(p + 1.0);
}

static void test_interpolant_has_order_seven(void **state) {
    (void)state;
    for (int p = 0; p <= 6; p++) {
        const whirl_system system = {.dimension = 1, .period = 1.0, .rhs = power_rhs, .model = &p};
        const whirl_integrate_options options = {.rtol = 1e9, .atol = 1.0, .limit = 1e6};
        stepper *c = stepper_new(&dop853_in_lanes, &system, &options);
        const double start = 0.0;
        c->observed = true;
        assert_int_equal(stepper_begin(c, &system, &start), WHIRL_BOUNDED);
        *c->slot->h = 1.0;
        assert_int_equal(stepper_step(c, 1.0), WHIRL_BOUNDED);
        assert_true(c->t == 1.0);
        stepper_interpolate(c);
        for (double theta = 0.125; theta <= 1.0; theta += 0.125) {
            double x;
            stepper_between(c, theta, &x);
            expect_near(x, pow(theta, p + 1) / tgamma(p + 2.0), 1e-15);
        }
        stepper_free(c);
    }
}

// ---------------------------------------------------------------- first zeros

typedef struct polynomial {
    double at, height; ///< (theta - at)^2 - height
} polynomial;

static void parabola(void *context, double theta, double *values) {
    const polynomial *p = context;
    values[0] = (theta - p->at) * (theta - p->at) - p->height;
}

static void test_dips_are_found(void **state) {
    (void)state;
    const int held[2] = {0, 0};
    double work[CROSSING_ROWS];
    for (double depth = 1e-2; depth > 1e-13; depth *= 0.1)
        for (double at = 0.2; at < 0.9; at += 0.0717) {
            polynomial dip = {at, depth};
            const crossing_search search = {parabola, &dip, 1, held, work};
            double theta = NAN;
            size_t which = 7;
            assert_true(crossing_first(&search, &theta, &which));
            assert_int_equal(which, 0);
            // The value there is zero to rounding: near a double zero that leaves its root in theta.
            expect_near((theta - at) * (theta - at), depth, 1e-15);
            assert_true(theta <= at);
            dip.height = -depth;
            assert_false(crossing_first(&search, &theta, &which));
        }
}

static void sine(void *context, double theta, double *values) {
    values[0] = sin(*(const double *)context * theta);
}

static void test_the_zero_at_the_beginning_is_not_counted(void **state) {
    (void)state;
    const int held[1] = {1};
    double work[CROSSING_ROWS];
    double theta = NAN, frequency = 3.0;
    size_t which;
    const crossing_search search = {sine, &frequency, 1, held, work};
    assert_false(crossing_first(&search, &theta, &which));
    frequency = 4.0;
    assert_true(crossing_first(&search, &theta, &which));
    expect_near(theta, pi / 4.0, 1e-14);
    frequency = -1.0; // it leaves to the wrong side at once
    assert_true(crossing_first(&search, &theta, &which));
    assert_true(theta == 0.0);
}

/// Size of a function that is constant, and how often it was evaluated.
typedef struct still {
    double size;
    int calls;
} still;

static void constant(void *context, double theta, double *values) {
    still *own = context;
    (void)theta;
    own->calls++;
    values[0] = own->size;
}

static void test_a_function_that_stays_zero_is_not_crossed(void **state) {
    (void)state;
    const double sizes[] = {0.0, 5e-324, -5e-324, 1e-310, -1e-310};
    double work[CROSSING_ROWS];
    for (int kept = 0; kept <= 2; kept++)
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            still own = {sizes[i], 0};
            double theta = NAN;
            size_t which;
            assert_false(crossing_first(&(crossing_search){constant, &own, 1, &kept, work}, &theta, &which));
            assert_in_range(own.calls, 1, CROSSING_ROWS); // samples alone
        }
}

// ---------------------------------------------------------------- contacts

/// x'' = -x - stiffness (x - gap) [x > gap].
static const double gap = 0.5, stiffness = 99.0;

static void spring_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                            double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -x[0] - (sides[0] > 0.0 ? stiffness * (x[0] - gap) : 0.0);
}
static void spring(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double side = x[0] - gap;
    spring_on_sides(model, t, forcing, x, &side, dxdt);
}
static void spring_switch(const void *model, double t, const double *x, double *values) {
    (void)model, (void)t;
    values[0] = x[0] - gap;
}

/// Returns the duration of one oscillation from x = -1: outside the stop x follows cos; in it, a vibration of frequency
/// w about gap stiffness/w^2.
static double spring_period(void) {
    const double w = sqrt(1.0 + stiffness), v = sqrt(1.0 - gap * gap), shift = gap - gap * stiffness / (w * w);
    return 2.0 * (pi - acos(gap)) + 2.0 * (pi / 2.0 - atan2(shift * w, v)) / w;
}

static const double tolerances[] = {1e-6, 1e-9, 1e-12};

static void test_contacts_are_located(void **state) {
    (void)state;
    whirl_system system = {
        .dimension = 2, .period = spring_period(), .rhs = spring, .switch_count = 1, .switches = spring_switch};
    for (int way = 0; way < 2 * STEPPED; way++)
        for (int i = 0; i < 3; i++) {
            double x[2] = {-1.0, 0.0};
            const char *by = stepped[way / 2];
            system.rhs_on_sides = way % 2 ? spring_on_sides : NULL;
            assert_int_equal(carry_by(by, &system, tolerances[i], 1e-2 * tolerances[i], 10, x), WHIRL_BOUNDED);
            expect_near(x[0], -1.0, 30.0 * tolerances[i]);
            expect_near(x[1], 0.0, 30.0 * tolerances[i]);
        }
}

/// Computes the slope of a stone over a floor at x = 0; z counts the time below it. x = height + (t - 1)^2/2.
static void stone_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                           double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = 1.0;
    dxdt[2] = sides[0] > 0.0 ? 1.0 : 0.0;
}
static void stone(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const double side = -x[0];
    stone_on_sides(model, t, forcing, x, &side, dxdt);
}
static void stone_switch(const void *model, double t, const double *x, double *values) {
    (void)model, (void)t;
    values[0] = -x[0];
}

static void test_grazes_are_found(void **state) {
    (void)state;
    const whirl_system system = {.dimension = 3,
                                 .period = 2.3,
                                 .rhs = stone,
                                 .switch_count = 1,
                                 .switches = stone_switch,
                                 .rhs_on_sides = stone_on_sides};
    for (double depth = 1e-2; depth > 1e-12; depth *= 0.1)
        for (int way = 0; way < 2 * STEPPED; way++) {
            const bool below = way % 2 == 1;
            double x[3] = {0.5 + (below ? -depth : depth), -1.0, 0.0};
            assert_int_equal(carry_by(stepped[way / 2], &system, 1e-6, 1e-9, 1, x), WHIRL_BOUNDED);
            // A step's rounding in x shifts the ends of the dip by its size over their speed.
            expect_near(x[2], below ? 2.0 * sqrt(2.0 * depth) : 0.0, below ? 1e-14 / sqrt(depth) : 0.0);
        }
}

// ---------------------------------------------------------------- sharp friction

/// x'' = -x - damping x' - friction sgn(x' - belt).
typedef struct block {
    double damping, friction, belt;
} block;

static void block_on_sides(const void *model, double t, const double *forcing, const double *x, const double *sides,
                           double *dxdt) {
    const block *b = model;
    (void)t, (void)forcing;
    dxdt[0] = x[1];
    dxdt[1] = -x[0] - b->damping * x[1] - b->friction * sides[0];
}
static void block_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const block *b = model;
    const double side = x[1] > b->belt ? 1.0 : -1.0;
    block_on_sides(model, t, forcing, x, &side, dxdt);
}
static void block_switch(const void *model, double t, const double *x, double *values) {
    (void)t;
    values[0] = x[1] - ((const block *)model)->belt;
}
static void block_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                           double *by_time) {
    (void)model, (void)t, (void)x, (void)index;
    gradient[0] = 0.0;
    gradient[1] = 1.0;
    *by_time = 0.0;
}

static whirl_system block_system(const block *model, double period) {
    return (whirl_system){.dimension = 2,
                          .period = period,
                          .rhs = block_rhs,
                          .rhs_on_sides = block_on_sides,
                          .switch_count = 1,
                          .switches = block_switch,
                          .switch_gradient = block_gradient,
                          .model = model};
}

/// Methods that follow sliding, and their allowed error in tolerances after a few revolutions.
static const struct sliding_method {
    const char *name;
    double errors;
} sliding_methods[] = {{"dop853", 10.0}, {"rodas5p", 10.0}, {"cvode-adams", 1000.0}, {"cvode-bdf", 1000.0}};
enum { SLIDING_METHODS = sizeof sliding_methods / sizeof *sliding_methods };

static void bring_to_rest(const struct sliding_method *own) {
    // Every half swing takes 2 friction off the amplitude: 1, -0.7, 0.4, -0.1, where friction holds the block.
    const block model = {0.0, 0.15, 0.0};
    const whirl_system system = block_system(&model, 0.75 * pi);
    for (int i = 0; i < 3; i++) {
        const double rtol = tolerances[i], atol = 1e-2 * rtol;
        double x[2] = {1.0, 0.0};
        assert_int_equal(carry_by(own->name, &system, rtol, atol, 5, x), WHIRL_BOUNDED);
        expect_near(x[0], -0.1, own->errors * rtol);
        expect_near(x[1], 0.0, 1e-15);
        const double rest = x[0];
        assert_int_equal(carry_by(own->name, &system, rtol, atol, 40, x), WHIRL_BOUNDED);
        expect_near(x[0], rest, 1e-14);
    }
}

static void test_friction_brings_to_rest(void **state) {
    (void)state;
    for (int i = 0; i < SLIDING_METHODS; i++) bring_to_rest(&sliding_methods[i]);
}

static void slide_until_let_go(const struct sliding_method *own) {
    // The belt carries the block from 0 to friction - damping belt; then it swings freely about x = friction.
    const block model = {0.2, 0.5, 0.1};
    const double stuck = (model.friction - model.damping * model.belt) / model.belt, free = 6.0;
    const whirl_system system = block_system(&model, (stuck + free) / 3.0);
    const double a = 0.5 * model.damping, w = sqrt(1.0 - a * a), y0 = -model.damping * model.belt;
    const double y = exp(-a * free) * (y0 * cos(w * free) + (model.belt + a * y0) / w * sin(w * free));
    for (int i = 0; i < 3; i++) {
        double x[2] = {0.0, model.belt};
        assert_int_equal(carry_by(own->name, &system, tolerances[i], 1e-2 * tolerances[i], 3, x), WHIRL_BOUNDED);
        expect_near(x[0], model.friction + y, own->errors * tolerances[i]);
    }
}

static void test_sliding_ends_where_friction_no_longer_holds(void **state) {
    (void)state;
    for (int i = 0; i < SLIDING_METHODS; i++) slide_until_let_go(&sliding_methods[i]);
}

static void test_endless_switching_ends(void **state) {
    (void)state;
    const block model = {0.0, 0.15, 0.0};
    whirl_system system = block_system(&model, 5.0 * pi);
    system.rhs_on_sides = NULL; // no way to know that it slides
    for (int m = 0; m < STEPPED; m++) {
        double x[2] = {1.0, 0.0};
        assert_int_equal(carry_by(stepped[m], &system, 1e-6, 1e-9, 1, x), WHIRL_STUCK);
    }
}

// ---------------------------------------------------------------- the ends of motions

static void wall_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    (void)model, (void)t, (void)forcing;
    dxdt[0] = 1.0 / sqrt(1.0 - x[0]); // not a number beyond x = 1, reached at t = 2/3
}

static void test_a_motion_ends_at_the_edge_of_its_equations(void **state) {
    (void)state;
    whirl_system system = {.dimension = 1, .period = 0.6, .rhs = wall_rhs};
    for (int m = 0; m < STEPPED; m++) {
        double x = 0.0, beyond = 2.0;
        assert_int_equal(carry_by(stepped[m], &system, 1e-9, 1e-12, 1, &x), WHIRL_BOUNDED);
        expect_near(x, 1.0 - pow(1.0 - 1.5 * 0.6, 2.0 / 3.0), 1e-8);
        assert_true(carry_by(stepped[m], &system, 1e-9, 1e-12, 1, &x) != WHIRL_BOUNDED);
        assert_int_equal(carry_by(stepped[m], &system, 1e-9, 1e-12, 1, &beyond), WHIRL_DIVERGED);
    }
}

static void expect_nothing_remembered(const char *by) {
    const block model = {0.05, 0.02, 0.3};
    const whirl_system system = block_system(&model, 2.0);
    whirl_integrator *one = integrator_by(by, &system, 1e-9, 1e-12);
    whirl_integrator *other = integrator_by(by, &system, 1e-9, 1e-12);
    double x[2] = {1.0, 0.0}, y[2], elsewhere[2] = {0.3, -2.0};
    for (int i = 0; i < 20; i++) {
        memcpy(y, x, sizeof x);
        whirl_integrator_revolve(one, x, NULL, NULL);
        memcpy(elsewhere, (double[2]){0.3 * i, -2.0}, sizeof elsewhere);
        whirl_integrator_revolve(other, elsewhere, NULL, NULL);
        whirl_integrator_revolve(other, y, NULL, NULL);
        assert_memory_equal(x, y, sizeof x);
    }
    whirl_integrator_free(one);
    whirl_integrator_free(other);
}

static void test_nothing_is_remembered(void **state) {
    (void)state;
    for (int m = 0; m < STEPPED; m++) expect_nothing_remembered(stepped[m]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers_meet_their_conditions),
        cmocka_unit_test(test_sums_of_accelerations),
        cmocka_unit_test(test_interpolant_has_order_seven),
        cmocka_unit_test(test_dips_are_found),
        cmocka_unit_test(test_the_zero_at_the_beginning_is_not_counted),
        cmocka_unit_test(test_a_function_that_stays_zero_is_not_crossed),
        cmocka_unit_test(test_contacts_are_located),
        cmocka_unit_test(test_grazes_are_found),
        cmocka_unit_test(test_friction_brings_to_rest),
        cmocka_unit_test(test_sliding_ends_where_friction_no_longer_holds),
        cmocka_unit_test(test_endless_switching_ends),
        cmocka_unit_test(test_a_motion_ends_at_the_edge_of_its_equations),
        cmocka_unit_test(test_nothing_is_remembered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
