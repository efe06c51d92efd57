// Branches of custom systems, compared with closed forms: places of bifurcations, their kinds, and numbers along the
// branches.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "near.h"
#include "whirl/engine.h"

static const double two_pi = 6.283185307179586476925;

/// Sets short transients, long steps, and orbits that close to 1e-10.
static void quicken(whirl_user_system *system) {
    good(whirl_user_system_set(system, "method", "dop853"));
    good(whirl_user_system_set(system, "transient", "20"));
    good(whirl_user_system_set(system, "record", "16"));
    good(whirl_user_system_set(system, "trace_rtol", "1e-11"));
    good(whirl_user_system_set(system, "trace_step", "0.15"));
}

/// Makes a system with the parameter r, whose branches go from `from` to `to`.
static whirl_user_system *system_of(size_t dimension, whirl_user_rates_fn rates, double from, double to) {
    whirl_user_system *system;
    good(whirl_user_system_new("Branches", dimension, &system));
    good(whirl_user_system_parameter(system, "r", from, "1", ""));
    good(whirl_user_system_rates(system, rates, NULL));
    good(whirl_user_system_branch(system, "r", from, to, NULL, 0));
    quicken(system);
    return system;
}

static double number(const whirl_table *table, size_t point, const char *quantity) {
    char name[64];
    snprintf(name, sizeof name, "trace/%s", quantity);
    return whirl_table_number(table, point, name, 0);
}

/// Returns the only point of that kind.
static size_t special(const whirl_table *table, whirl_special kind) {
    size_t found = table->count, count = 0;
    for (size_t i = 0; i < table->count; i++)
        if (number(table, i, "special") == (double)kind) {
            found = i;
            count++;
        }
    if (count != 1) fail_msg("%zu points of kind %d, expected 1", count, (int)kind);
    return found;
}

static size_t count_special(const whirl_table *table) {
    size_t count = 0;
    for (size_t i = 0; i < table->count; i++) count += number(table, i, "special") > 0.0;
    return count;
}

// ---------------------------------------------------------------- where branches begin

/// x'' = -.02 x' + r x + cos t about a maximum of its potential: its orbit x = a cos t + b sin t is unstable, with
/// the multipliers exp(2 pi (-.01 +- sqrt(r + .0001))), and every motion leaves it.
static int hilltop(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = -0.02 * x[1] + p[0] * x[0] + cos(t);
    return 0;
}

static void branches_begin_with_unstable_orbits(void **state) {
    (void)state;
    static const char *const ways[] = {"start", "linear"};
    for (size_t k = 0; k < 2; k++) {
        whirl_user_system *system = system_of(2, hilltop, 1.0, 4.0);
        good(whirl_user_system_period(system, two_pi));
        good(whirl_user_system_set(system, "trace_segments", "4"));
        good(whirl_user_system_set(system, "trace_begin", ways[k]));
        whirl_result *result = run(system, 2);
        const whirl_table *table = whirl_result_table(result, "branch");
        assert_true(table->count > 4 && table->values[table->count - 1] == 4.0);
        for (size_t i = 0; i < table->count; i++) {
            const double r = table->values[i], c = 0.02, below = (r + 1.0) * (r + 1.0) + c * c;
            near(whirl_table_field(table, i, "trace/nodes", 0)[0], -(r + 1.0) / below, 1e-8);
            near(number(table, i, "largest") / exp(two_pi * (sqrt(r + 0.25 * c * c) - 0.5 * c)), 1.0, 1e-7);
            assert_true(number(table, i, "unstable") == 1.0);
        }
        whirl_result_free(result);
        whirl_user_system_free(system);
    }
}

// ---------------------------------------------------------------- equilibria

static int fold(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)t, (void)context;
    dxdt[0] = p[0] + x[0] * x[0];
    return 0;
}

/// x' = r + x^2: x = -+sqrt(-r) with the eigenvalue 2x, which fold at 0.
static void equilibria_fold(void **state) {
    (void)state;
    whirl_user_system *system = system_of(1, fold, -1.0, 0.5);
    good(whirl_user_system_start(system, 0, -1.2));
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    assert_int_equal(1, count_special(table));
    const size_t at = special(table, WHIRL_FOLD);
    near(table->values[at], 0.0, 1e-10);
    size_t stable = 0, unstable = 0;
    for (size_t i = 0; i < table->count; i++) {
        const double x = whirl_table_field(table, i, "trace/nodes", 0)[0];
        near(x * x, -table->values[i], 1e-9);
        near(whirl_table_field(table, i, "trace/multipliers", 0)[0], 2.0 * x, 1e-8);
        assert_true(number(table, i, "period") == 0.0 && number(table, i, "number") == 1.0);
        stable += i < at && number(table, i, "unstable") == 0.0 && x < 0.0;
        unstable += i > at && number(table, i, "unstable") == 1.0 && x > 0.0;
    }
    assert_true(stable == at && unstable == table->count - at - 1 && stable > 5 && unstable > 5);
    assert_true(number(table, table->count - 1, "end") == WHIRL_END_OF_RANGE);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

static int pitchfork(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)t, (void)context;
    dxdt[0] = p[0] * x[0] - x[0] * x[0] * x[0];
    return 0;
}

/// x' = r x - x^3: 0, which is crossed at r = 0 by x^2 = r with the eigenvalue -2 r.
static void equilibria_cross(void **state) {
    (void)state;
    whirl_user_system *system = system_of(1, pitchfork, -1.0, 1.0);
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    near(table->values[special(table, WHIRL_BRANCHING)], 0.0, 1e-10);
    double last = 0.0;
    for (size_t i = 0; i < table->count; i++) {
        const double x = whirl_table_field(table, i, "trace/nodes", 0)[0], r = table->values[i];
        const bool straight = number(table, i, "number") == 1.0;
        near(x * x, straight ? 0.0 : r, 1e-9);
        near(number(table, i, "largest"), straight ? r : -2.0 * r, 1e-7);
        if (number(table, i, "special") == 0.0) assert_true(number(table, i, "unstable") == (straight && r > 0.0));
        last = fmax(last, number(table, i, "number"));
        assert_true(number(table, i, "parent") == !straight);
    }
    assert_true(last == 3.0); // one to each side
    whirl_result_free(result);
    whirl_user_system_free(system);
}

/// Checks a result whose first branch goes along one side of a pitchfork at r = 0: it ends there, and the symmetric
/// branch and the other side are followed.
static void check_pitchfork(const whirl_table *table, double located) {
    size_t ends = 0, points = 0;
    for (size_t i = 0; i < table->count; i++) {
        ends += number(table, i, "end") == WHIRL_END_MIRRORED;
        if (number(table, i, "special") == 0.0) continue;
        assert_true(number(table, i, "special") == WHIRL_BRANCHING);
        near(table->values[i], 0.0, located);
        points++;
    }
    assert_int_equal(1, ends);
    assert_int_equal(2, points); // where the side branch ends, and along the symmetric branch
    assert_true(number(table, table->count - 1, "number") == 5.0); // both ways, symmetric both ways, the other side
}

/// The same pitchfork is found from its side x = sqrt(r).
static void equilibria_end_at_pitchforks(void **state) {
    (void)state;
    const double at = 0.49;
    whirl_user_system *system = system_of(1, pitchfork, -1.0, 1.0);
    good(whirl_user_system_branch(system, "r", -1.0, 1.0, &at, 1));
    good(whirl_user_system_start(system, 0, 0.6));
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    check_pitchfork(table, 1e-10);
    bool both[2] = {false, false};
    for (size_t i = 0; i < table->count; i++) {
        const double x = whirl_table_field(table, i, "trace/nodes", 0)[0], r = table->values[i];
        const bool side = fabs(x) > 1e-6;
        if (side) both[x < 0.0] = true;
        near(x * x, side ? r : 0.0, 1e-9);
        near(number(table, i, "largest"), side ? -2.0 * r : r, 1e-7);
    }
    assert_true(both[0] && both[1]);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

/// x' = (r + cos t) y - y^3 - sin t with y = x - cos t, a Bernoulli equation: x = cos t has the multiplier exp(2 pi r),
/// and at r > 0 one orbit on each side of it has exp(-4 pi r).
static int driven_pitchfork(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    const double y = x[0] - cos(t);
    dxdt[0] = (p[0] + cos(t)) * y - y * y * y - sin(t);
    return 0;
}

static void orbits_end_at_pitchforks(void **state) {
    (void)state;
    const double at = 0.1;
    whirl_user_system *system = system_of(1, driven_pitchfork, -0.3, 0.3);
    good(whirl_user_system_branch(system, "r", -0.3, 0.3, &at, 1));
    good(whirl_user_system_period(system, two_pi));
    good(whirl_user_system_start(system, 0, 1.6));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    check_pitchfork(table, 1e-9);
    for (size_t i = 0; i < table->count; i++) {
        const double x = whirl_table_field(table, i, "trace/nodes", 0)[0], r = table->values[i];
        near(number(table, i, "largest"), exp(two_pi * (fabs(x - 1.0) > 1e-6 ? -2.0 * r : r)), 1e-7);
    }
    whirl_result_free(result);
    whirl_user_system_free(system);
}

/// x' = x (r - x^2 + x^3/2): the branch r = x^2 - x^3/2 turns back at a crossing with x = 0, too.
static int lopsided(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)t, (void)context;
    dxdt[0] = x[0] * (p[0] - x[0] * x[0] * (1.0 - 0.5 * x[0]));
    return 0;
}

/// Without a symmetry the branch continues beyond a pitchfork along another branch.
static void branches_go_on_where_nothing_is_mirrored(void **state) {
    (void)state;
    const double at = 0.3;
    whirl_user_system *system = system_of(1, lopsided, -0.5, 0.35);
    good(whirl_user_system_branch(system, "r", -0.5, 0.35, &at, 1));
    good(whirl_user_system_start(system, 0, 0.6));
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    good(whirl_user_system_set(system, "trace_switches", "0"));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    near(table->values[special(table, WHIRL_BRANCHING)], 0.0, 1e-9);
    assert_int_equal(1, count_special(table));
    double least = 1.0;
    for (size_t i = 0; i < table->count; i++) {
        const double x = whirl_table_field(table, i, "trace/nodes", 0)[0];
        near(table->values[i], x * x * (1.0 - 0.5 * x), 1e-9);
        assert_true(number(table, i, "end") != WHIRL_END_MIRRORED);
        least = fmin(least, x);
    }
    assert_true(least < -0.4);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

/// Lorenz' equations, sigma = 10 and b = 8/3.
static int lorenz(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)t, (void)context;
    dxdt[0] = 10.0 * (x[1] - x[0]);
    dxdt[1] = x[0] * (p[0] - x[2]) - x[1];
    dxdt[2] = x[0] * x[1] - 8.0 / 3.0 * x[2];
    return 0;
}

/// Rest at 0 is crossed at r = 1, where the search comes to just that number, at which the Jacobian is singular to the
/// last bit. The others, z = r - 1, lose their stability at r = 470/19, at the rate of the root of b (r + sigma), and
/// suddenly (Sparrow 1982, 1.3).
static void equilibria_cross_just_where_they_are_looked_for(void **state) {
    (void)state;
    whirl_user_system *system = system_of(3, lorenz, 0.5, 28.0);
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    good(whirl_user_system_set(system, "trace_switches", "1"));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    const double r = 470.0 / 19.0;
    near(table->values[special(table, WHIRL_BRANCHING)], 1.0, 1e-10 * 27.5);
    size_t hopf_points = 0;
    for (size_t i = 0; i < table->count; i++) {
        if (number(table, i, "number") > 1.0)
            near(whirl_table_field(table, i, "trace/nodes", 0)[2], table->values[i] - 1.0, 1e-8);
        if (number(table, i, "special") != WHIRL_HOPF) continue;
        hopf_points++;
        near(table->values[i], r, 1e-8);
        near(number(table, i, "angle"), sqrt(8.0 / 3.0 * (r + 10.0)), 1e-8);
        assert_true(number(table, i, "criticality") > 0.0);
    }
    assert_int_equal(2, hopf_points);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

// ---------------------------------------------------------------- Hopf

static const double omega = 1.7;

/// z' = (r + i omega) z - |z|^2 z, z = x + i y - 1 about the equilibrium (1, 0).
static int hopf(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)t, (void)context;
    const double u = x[0] - 1.0, v = x[1], square = u * u + v * v;
    dxdt[0] = p[0] * u - omega * v - square * u;
    dxdt[1] = omega * u + p[0] * v - square * v;
    return 0;
}

/// At r = 0 orbits begin whose radius is sqrt(r) and whose time is 2 pi/omega, with the multiplier exp(-2 r 2
/// pi/omega). Eigenvalues and periods are by the angle of a revolution: a period of the system of 5 units of time is 2
/// pi. The cubic coefficient of w, z = sqrt(2) w, is -2, and the criticality -2/omega.
static void orbits_begin_at_hopf_points(void **state) {
    (void)state;
    const double angle = two_pi / 5.0;
    whirl_user_system *system = system_of(2, hopf, -0.5, 0.5);
    good(whirl_user_system_period(system, 5.0));
    good(whirl_user_system_start(system, 0, 1.1));
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    const size_t at = special(table, WHIRL_HOPF);
    near(table->values[at], 0.0, 1e-9);
    near(number(table, at, "angle"), omega / angle, 1e-8);
    near(number(table, at, "criticality"), -2.0 / omega, 0.02 * 2.0 / omega);
    size_t moving = 0;
    for (size_t i = 0; i < table->count; i++) {
        const double r = table->values[i], *multipliers = whirl_table_field(table, i, "trace/multipliers", 0);
        if (number(table, i, "number") == 1.0) {
            near(multipliers[0], r / angle, 1e-8);
            near(fabs(multipliers[1]), omega / angle, 1e-8);
            near(number(table, i, "volume"), 2.0 * r / angle, 1e-8);
            continue;
        }
        moving++;
        assert_true(number(table, i, "revolutions") == 0.0 && number(table, i, "parent") == 1.0);
        near(whirl_table_field(table, i, "trace/high", 0)[0], 1.0 + sqrt(r), 2e-5); // looked at 512 times
        near(number(table, i, "period"), two_pi / omega * angle, 1e-8);
        near(number(table, i, "largest"), exp(-2.0 * r * two_pi / omega), 1e-7);
        assert_true(number(table, i, "unstable") == 0.0);
    }
    assert_true(moving > 5);
    near(whirl_table_clock(result, table, 0), angle, 1e-15);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

// ---------------------------------------------------------------- forced orbits

/// x = u + cos t, u' = r + u^2.
static int forced_fold(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    const double u = x[0] - cos(t);
    dxdt[0] = p[0] + u * u - sin(t);
    return 0;
}

/// Orbits u = -+sqrt(-r), multiplier exp(2 u 2 pi), which fold at 0. Begun between the bounds, they are followed both
/// ways.
static void orbits_fold(void **state) {
    (void)state;
    const double begin = -0.3;
    whirl_user_system *system = system_of(1, forced_fold, -0.5, 0.2);
    good(whirl_user_system_branch(system, "r", -0.5, 0.2, &begin, 1));
    good(whirl_user_system_start(system, 0, 0.4));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    near(table->values[special(table, WHIRL_FOLD)], 0.0, 1e-10);
    double lowest = 0.0;
    for (size_t i = 0; i < table->count; i++) {
        const double u = whirl_table_field(table, i, "trace/nodes", 0)[0] - 1.0;
        near(u * u, -table->values[i], 1e-9);
        near(log(number(table, i, "largest")), 2.0 * u * two_pi, 1e-7);
        assert_true(number(table, i, "revolutions") == 1.0);
        near(number(table, i, "period"), two_pi, 1e-14);
        lowest = fmin(lowest, table->values[i]);
    }
    assert_true(lowest == -0.5 && number(table, table->count - 1, "number") == 2.0);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

/// u' = r u - u^3, v' = -0.4 v, seen from a frame that turns by half a turn in a revolution.
static int half_turn(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    const double c = cos(0.5 * t), s = sin(0.5 * t), u = c * x[0] + s * x[1], v = c * x[1] - s * x[0];
    const double du = p[0] * u - u * u * u, dv = -0.4 * v;
    dxdt[0] = c * du - s * dv - 0.5 * x[1];
    dxdt[1] = s * du + c * dv + 0.5 * x[0];
    return 0;
}

/// Rest has the multipliers -exp(2 pi r) and -exp(-0.4 2 pi): at r = 0, where a revolution leads from u to -u + 2 pi
/// u^3, orbits of two revolutions begin, u^2 = r with exp(-2 r 4 pi).
static void orbits_double(void **state) {
    (void)state;
    whirl_user_system *system = system_of(2, half_turn, -0.2, 0.2);
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch");
    const size_t at = special(table, WHIRL_DOUBLING);
    near(table->values[at], 0.0, 1e-9);
    near(number(table, at, "criticality"), -two_pi, 0.01 * two_pi);
    size_t doubled = 0;
    for (size_t i = 0; i < table->count; i++) {
        const double r = table->values[i], *multipliers = whirl_table_field(table, i, "trace/multipliers", 0);
        if (number(table, i, "revolutions") == 1.0) {
            near(multipliers[0], -exp(r * two_pi), 1e-7);
            near(multipliers[2], -exp(-0.4 * two_pi), 1e-7);
            continue;
        }
        doubled++;
        assert_true(number(table, i, "revolutions") == 2.0 && number(table, i, "parent") == 1.0);
        const double *u = whirl_table_field(table, i, "trace/nodes", 0);
        near(u[0] * u[0], r, 1e-9);
        near(multipliers[0], exp(-4.0 * r * two_pi), 1e-7);
        near(number(table, i, "period"), 2.0 * two_pi, 1e-13);
    }
    assert_true(doubled > 3);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

/// Z = z + e^{i t}, z' = (r + i 0.3) z - |z|^2 z.
static int forced_hopf(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    const double u = x[0] - cos(t), v = x[1] - sin(t), square = u * u + v * v;
    dxdt[0] = p[0] * u - 0.3 * v - square * u - sin(t);
    dxdt[1] = 0.3 * u + p[0] * v - square * v + cos(t);
    return 0;
}

/// The orbit e^{i t} has the multipliers exp(2 pi (r -+ 0.3 i)). At r = 0 tori begin: circles of radius sqrt(r) round
/// it, that turn 0.3 times in a revolution and draw near at -2 r a unit of time.
static void tori_begin_at_neimark_sacker_points(void **state) {
    (void)state;
    whirl_user_system *system = system_of(2, forced_hopf, -0.1, 0.1);
    good(whirl_user_system_start(system, 0, 1.0));
    good(whirl_user_system_set(system, "trace_tori", "yes"));
    good(whirl_user_system_set(system, "trace_torus_step", "0.2"));
    good(whirl_user_system_set(system, "trace_torus_accuracy", "1e-4"));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch"), *tori = whirl_result_table(result, "tori");
    const size_t at = special(table, WHIRL_NEIMARK_SACKER);
    near(table->values[at], 0.0, 1e-9);
    near(number(table, at, "angle"), 0.3 * two_pi, 1e-8);
    for (size_t i = 0; i < table->count; i++) near(number(table, i, "largest"), exp(table->values[i] * two_pi), 1e-7);
    assert_true(tori->count > 3);
    for (size_t i = 0; i < tori->count; i++) {
        const double r = tori->values[i];
        near(whirl_table_number(tori, i, "torus/rotation", 0), 0.3, 1e-7);
        near(whirl_table_number(tori, i, "torus/radius", 0), sqrt(r), 1e-3 * sqrt(r));
        near(whirl_table_number(tori, i, "torus/exponent", 0), -2.0 * r * two_pi, 1e-3 * r + 1e-6);
    }
    whirl_result_free(result);
    whirl_user_system_free(system);
}

// ---------------------------------------------------------------- a speed that varies

/// x'' + 2 zeta x' + x = cos(omega t)
static int oscillator(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)context;
    dxdt[0] = x[1];
    dxdt[1] = cos(p[0] * t) - 2.0 * zeta * x[1] - x[0];
    return 0;
}

/// Whatever the common time of a study is, sections and states are the user's own: alone and in lanes, by differences
/// and by the derivative.
static void orbits_of_every_speed_are_their_closed_form(void **state) {
    (void)state;
    for (int form = 0; form < 4; form++) {
        whirl_user_system *system;
        good(whirl_user_system_new("Linear oscillator", 2, &system));
        good(whirl_user_system_parameter(system, "omega", 1.3, "rad/s", "1.3 rad/s"));
        good(whirl_user_system_speed(system, "omega"));
        good(whirl_user_system_oscillates(system, form & 1));
        good(whirl_user_system_rates(system, oscillator, NULL));
        if (form & 2) good(whirl_user_system_tangent(system, derivative, NULL));
        good(whirl_user_system_branch(system, "omega", 0.5, 2.5, NULL, 0));
        quicken(system);
        whirl_result *result = run(system, 2);
        const whirl_table *table = whirl_result_table(result, "branch");
        assert_true(count_special(table) == 0 && table->count > 20);
        for (size_t i = 0; i < table->count; i++) {
            const double w = table->values[i], size = 1.0 / hypot(1.0 - w * w, 2.0 * zeta * w);
            const double angle = atan2(2.0 * zeta * w, 1.0 - w * w), x = size * cos(angle), v = size * w * sin(angle);
            const double *nodes = whirl_table_field(table, i, "trace/nodes", 0);
            near(nodes[0], x, 1e-9 * size);
            near(nodes[1], v, 1e-9 * size);
            near(whirl_table_field(table, i, "trace/section", 0)[form & 1 ? 2 : 1], v, 1e-9 * size);
            near(log(number(table, i, "largest")), -zeta * two_pi / w, 1e-7);
            near(number(table, i, "period"), two_pi, 1e-14);
            near(whirl_table_clock(result, table, i), w, 1e-14);
        }
        whirl_result_free(result);
        whirl_user_system_free(system);
    }
}

// ---------------------------------------------------------------- curves

static int cusp(double t, const double *x, const double *p, double *dxdt, void *context) {
    (void)t, (void)context;
    dxdt[0] = p[0] + p[1] * x[0] - x[0] * x[0] * x[0];
    return 0;
}

/// The folds of r + h x - x^3 = 0 are 27 r^2 = 4 h^3.
static void curves_follow_folds(void **state) {
    (void)state;
    whirl_user_system *system = system_of(1, cusp, -2.0, 2.0);
    good(whirl_user_system_parameter(system, "h", 1.0, "1", "1"));
    good(whirl_user_system_start(system, 0, -1.5));
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    good(whirl_user_system_curves(system, "h", 0.25, 2.0));
    whirl_result *result = run(system, 2);
    const whirl_table *table = whirl_result_table(result, "branch"), *curves = whirl_result_table(result, "curves");
    assert_int_equal(2, count_special(table));
    for (size_t i = 0; i < table->count; i++)
        if (number(table, i, "special") > 0.0) near(fabs(table->values[i]), sqrt(4.0 / 27.0), 1e-9);
    assert_true(curves->count > 20);
    double low = 1.0, high = 1.0;
    for (size_t i = 0; i < curves->count; i++) {
        const double h = whirl_table_second(curves, i);
        near(27.0 * curves->values[i] * curves->values[i], 4.0 * h * h * h, 1e-7);
        low = fmin(low, h);
        high = fmax(high, h);
    }
    near(low, 0.25, 1e-9);
    near(high, 2.0, 1e-9);
    whirl_result_free(result);
    whirl_user_system_free(system);
}

// ---------------------------------------------------------------- what results say, and what goes wrong

static void results_are_described(void **state) {
    const double at[] = {-0.4, 0.1};
    whirl_result *outline;
    char text[64];
    (void)state;
    whirl_user_system *system = system_of(1, forced_fold, -0.5, 0.2);
    good(whirl_user_system_branch(system, "r", -0.5, 0.2, at, 2));
    good(whirl_user_system_parameter(system, "h", 1.0, "1", "1"));
    good(whirl_user_system_curves(system, "h", 0.25, 2.0));
    good(whirl_user_system_set(system, "trace_step", "0.02"));
    good(whirl_user_system_identity(system, "forced fold 1"));
    good(whirl_user_system_outline(system, &outline));
    assert_string_equal("over r from -0.5 to 0.2, begun at -0.4, 0.1; curves over h from 0.25 to 2",
                        whirl_result_fact(outline, "equations: branches"));
    assert_int_equal(2, outline->table_count);
    const whirl_table *table = whirl_result_table(outline, "branch");
    assert_string_equal("r", whirl_table_parameter(table));
    assert_string_equal("h", whirl_table_varied(whirl_result_table(outline, "curves")));
    bool found = false;
    for (size_t i = 0; !found && whirl_table_option(table, i, text, sizeof text); i++)
        found = strcmp(whirl_table_option(table, i, text, sizeof text), "trace_step") == 0;
    assert_true(found && strcmp(text, "0.02") == 0);
    // A single row of what stands in rows is an array.
    const size_t multipliers = whirl_table_field_index(table, "trace/multipliers");
    size_t shape[3], stride;
    whirl_table_column(table, multipliers, shape, &stride);
    assert_true(shape[1] == 1 && whirl_field_has_rows("trace/multipliers") && whirl_field_has_rows("poincare/section"));
    assert_false(whirl_field_has_rows("trace/period") || whirl_field_has_rows("trace") || whirl_field_has_rows(""));
    whirl_result_free(outline);
    whirl_user_system_free(system);
}

static void wrong_arguments_are_refused(void **state) {
    const double beyond = 0.3, values[] = {1.0, 2.0};
    whirl_result *result;
    (void)state;
    whirl_user_system *system = system_of(1, forced_fold, -0.5, 0.2);
    good(whirl_user_system_parameter(system, "h", 1.0, "1", "1"));
    refused(whirl_user_system_branch(system, "R", 0.0, 1.0, NULL, 0), "no parameter R, did you mean r?");
    refused(whirl_user_system_branch(system, "r", 1.0, 1.0, NULL, 0), "over r from 1 to 1, expected two different");
    refused(whirl_user_system_branch(system, "r", 1.0, (double)NAN, NULL, 0), "expected two different finite numbers");
    refused(whirl_user_system_branch(system, "r", -0.5, 0.2, &beyond, 1), "r = 0.3, expected a value from -0.5 to 0.2");
    refused(whirl_user_system_curves(system, "h", 2.0, 3.0), "expected two bounds around its value, 1");
    refused(whirl_user_system_set(system, "trace_steps", "1"), "no option trace_steps, did you mean trace_step?");
    good(whirl_user_system_set(system, "trace_rest", "yes"));
    refused(attempt(system, 2, &result), "slope 0 changes with t at r = -0.5, expected a system that nothing drives");
    good(whirl_user_system_set(system, "trace_tori", "yes"));
    refused(attempt(system, 2, &result), "expected none with equilibria");
    good(whirl_user_system_set(system, "trace_tori", "no"));
    good(whirl_user_system_set(system, "trace_rest", "no"));
    // Above 0 all motions leave.
    good(whirl_user_system_branch(system, "r", 0.1, 0.2, NULL, 0));
    refused(attempt(system, 2, &result), "no branch begins at r = 0.1: the motion leaves its bounds");
    whirl_user_system_free(system);

    system = system_of(1, forced_fold, -0.5, 0.2);
    good(whirl_user_system_curves(system, "r", -1.0, 0.2));
    refused(attempt(system, 2, &result), "curves go over r, as the branches do");
    good(whirl_user_system_set(system, "confirm", "yes"));
    refused(attempt(system, 2, &result), "a branch has neither analyses nor verdicts of motions");
    good(whirl_user_system_vary(system, "r", values, 2));
    refused(attempt(system, 2, &result), "r varies, and branches are followed");
    whirl_user_system_free(system);
}

static int fails_later(double t, const double *x, const double *p, double *dxdt, void *context) {
    forced_fold(t, x, p, dxdt, context);
    return p[0] > -0.1 ? 7 : 0;
}

static void a_function_that_fails_ends_the_run(void **state) {
    (void)state;
    whirl_user_system *system = system_of(1, fails_later, -0.5, 0.2);
    whirl_result *result;
    const whirl_status status = attempt(system, 2, &result);
    assert_int_equal(WHIRL_NUMERICAL_FAILURE, status.code);
    assert_non_null(strstr(status.message, "a function of the system gave 7 at t = "));
    assert_null(result);
    whirl_user_system_free(system);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(branches_begin_with_unstable_orbits),
        cmocka_unit_test(equilibria_fold),
        cmocka_unit_test(equilibria_cross),
        cmocka_unit_test(equilibria_end_at_pitchforks),
        cmocka_unit_test(orbits_end_at_pitchforks),
        cmocka_unit_test(branches_go_on_where_nothing_is_mirrored),
        cmocka_unit_test(equilibria_cross_just_where_they_are_looked_for),
        cmocka_unit_test(orbits_begin_at_hopf_points),
        cmocka_unit_test(orbits_fold),
        cmocka_unit_test(orbits_double),
        cmocka_unit_test(tori_begin_at_neimark_sacker_points),
        cmocka_unit_test(orbits_of_every_speed_are_their_closed_form),
        cmocka_unit_test(curves_follow_folds),
        cmocka_unit_test(results_are_described),
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(a_function_that_fails_ends_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
