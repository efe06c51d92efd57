// Branches of periodic orbits: where and how they change, against closed forms and printed digits.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_branch.h"
#include "support_check.h"
#include "whirl/engine/stable_orbits.h"

static const double pi = 3.14159265358979323846;

static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    *forcing = cos(t);
}

/// Linear and cubic parts of one oscillator in tau = W t: W^2 x'' + c W x' + k x + b x^3 = F cos tau; p: these, and the
/// stiffness and the place of its stop.
enum { SPEED, DAMPING, STIFFNESS, CUBIC, FORCE, STOP, GAP };

static void oscillator(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double *p = model, W = p[SPEED];
    (void)t;
    dxdt[0] = x[1];
    dxdt[1] = (p[FORCE] * *f - p[DAMPING] * W * x[1] - (p[STIFFNESS] + p[CUBIC] * x[0] * x[0]) * x[0]) / (W * W);
}

static void oscillator_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                               size_t count, const double *u, double *out) {
    const double *p = model, W = p[SPEED];
    (void)t, (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, u += 2, out += 2) {
        out[0] = u[1];
        out[1] = -(p[DAMPING] * W * u[1] + (p[STIFFNESS] + 3.0 * p[CUBIC] * x[0] * x[0]) * u[0]) / (W * W);
    }
}

static double oscillator_divergence(const void *model, double t, const double *f, const double *x,
                                    const double *sides) {
    const double *p = model;
    (void)t, (void)f, (void)x, (void)sides;
    return -p[DAMPING] / p[SPEED];
}

static test_family oscillator_family(double W, double c, double k, double b, double F) {
    return (test_family){.system = {.dimension = 2,
                                    .period = 2.0 * pi,
                                    .forcing_count = 1,
                                    .forcing = cosine,
                                    .rhs = oscillator,
                                    .tangent = oscillator_tangent,
                                    .divergence = oscillator_divergence},
                         .p = {W, c, k, b, F}};
}

// ---------------------------------------------------------------- folds

/// NLvib's first example: both folds, by an independent program in extended precision.
static void folds_of_nlvib(void **state) {
    static const struct {
        const char *W, *x, *v, *trace;
    } rows[] = {{"1.269601955546", "-0.140434285344", "2.688580646031", "1.7807915585"},
                {"1.115700251771", "-1.020826011254", "0.370992550122", "1.7545902833"}};
    (void)state;
    test_family family = oscillator_family(0.8, 0.05, 1.0, 0.1, 0.18);
    const whirl_branch_options options = whirl_branch_default(0.8, 1.5);
    whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &options);
    assert_int_equal(2, count_special(branch, WHIRL_FOLD));
    assert_int_equal(0, count_special(branch, WHIRL_BRANCHING) + count_special(branch, WHIRL_DOUBLING) +
                            count_special(branch, WHIRL_NEIMARK_SACKER));
    assert_int_equal(WHIRL_END_OF_RANGE, branch->end);
    for (size_t i = 0; i < 2; i++) {
        const whirl_branch_point *fold = special_point(branch, WHIRL_FOLD, i);
        const whirl_orbit *orbit = fold->orbit;
        check_digits("branches", "NLvib 01, fold: W", rows[i].W, fold->value);
        check_within("branches", "NLvib 01, x(0) there", strtod(rows[i].x, NULL), orbit->nodes[0], 1e-10);
        check_within("branches", "NLvib 01, dx/dtau(0) there", strtod(rows[i].v, NULL), orbit->nodes[1], 1e-10);
        check_digits("branches", "NLvib 01, trace there", rows[i].trace,
                     orbit->multipliers[0].real + orbit->multipliers[1].real);
    }
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

/// Between the folds three orbits exist at one speed. The stable ones are the two to which motions from many starts
/// lead.
static void two_of_three_are_stable(void **state) {
    static const double low[2] = {-6.0, -6.0}, high[2] = {6.0, 6.0};
    (void)state;
    test_family family = oscillator_family(0.8, 0.05, 1.0, 0.1, 0.18);
    const whirl_branch_options options = whirl_branch_default(0.8, 1.2);
    const whirl_branch_options beyond = whirl_branch_default(1.2, 1.5);
    whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &options);
    family.p[SPEED] = 1.2;
    whirl_branch *back = follow_branch(&family, branch->points[branch->count - 1].orbit, 1, &beyond);
    const whirl_system system = system_of(&family);
    whirl_collect_options every = whirl_collect_default(low, high);
    whirl_collection *collection;
    every.starts = 32;
    require_ok(whirl_orbit_collect(&system, &every, &collection));
    assert_int_equal(2, collection->count);
    assert_int_equal(32, collection->reached[0] + collection->reached[1]);
    // The upper orbit is the branch's first here, the one between is its second, the lower is found by neither part.
    const whirl_orbit *upper = branch->points[branch->count - 1].orbit;
    const whirl_orbit *between = back->points[back->count - 1].orbit;
    assert_int_equal(0, upper->unstable);
    assert_int_equal(1, between->unstable);
    double nearest = INFINITY, aside = INFINITY;
    for (size_t k = 0; k < 2; k++) {
        const double *x = collection->orbits[k]->nodes;
        nearest = fmin(nearest, hypot(x[0] - upper->nodes[0], x[1] - upper->nodes[1]));
        aside = fmin(aside, hypot(x[0] - between->nodes[0], x[1] - between->nodes[1]));
    }
    check_within("branches", "NLvib 01, W = 1.2: the upper orbit from many starts", 0.0, nearest, 1e-10);
    assert_true(aside > 0.1);
    whirl_collection_free(collection);
    whirl_branch_free(back);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

/// Of the orbits in two wells one is the other's mirror image, half a revolution later.
static void both_wells_are_found(void **state) {
    static const double low[2] = {-1.5, -0.5}, high[2] = {1.5, 0.5};
    (void)state;
    const test_family family = oscillator_family(1.2, 0.3, -1.0, 1.0, 0.2);
    const whirl_system system = system_of(&family);
    whirl_collect_options every = whirl_collect_default(low, high);
    whirl_collection *collection;
    every.starts = 32;
    require_ok(whirl_orbit_collect(&system, &every, &collection));
    assert_int_equal(2, collection->count);
    const whirl_orbit *left = collection->orbits[0], *right = collection->orbits[1];
    check_within("branches", "D2, F = .20: both wells, lowest and highest x", -left->low[0], right->high[0], 1e-6);
    check_within("branches", "D2, F = .20: highest and lowest", -left->high[0], right->low[0], 1e-6);
    every.longest = WHIRL_MAX_ORBIT + 1;
    whirl_collection_free(collection);
    assert_int_equal(WHIRL_BAD_INPUT, whirl_orbit_collect(&system, &every, &collection).code);
    assert_null(collection);
}

// ---------------------------------------------------------------- tori and neutral saddles

/// A pair of coordinates in its normal form, z' = (p + i w) z - |z|^2 z, and a driven one, x' = cos t - x. On
/// the orbit z = 0 the multipliers are exp(2 pi (p +- i w)): a torus begins at p = 0, and w is 2 pi times its rotation.
enum { GROWTH, ANGULAR, LEFT, RIGHT };

static void normal_form(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double *p = model, square = x[0] * x[0] + x[1] * x[1];
    (void)t;
    dxdt[0] = p[GROWTH] * x[0] - p[ANGULAR] * x[1] - square * x[0];
    dxdt[1] = p[ANGULAR] * x[0] + p[GROWTH] * x[1] - square * x[1];
    dxdt[2] = *f - x[2];
}

static void normal_form_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                                size_t count, const double *u, double *out) {
    const double *p = model, a = x[0] * x[0], b = x[1] * x[1], c = 2.0 * x[0] * x[1];
    (void)t, (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, u += 3, out += 3) {
        out[0] = (p[GROWTH] - 3.0 * a - b) * u[0] - (p[ANGULAR] + c) * u[1];
        out[1] = (p[ANGULAR] - c) * u[0] + (p[GROWTH] - a - 3.0 * b) * u[1];
        out[2] = -u[2];
    }
}

static void a_torus_begins(void **state) {
    static const double angulars[] = {0.3, 0.05, 0.47, 1.3};
    (void)state;
    for (size_t i = 0; i < sizeof angulars / sizeof *angulars; i++) {
        test_family family = {.system = {.dimension = 3,
                                         .period = 2.0 * pi,
                                         .forcing_count = 1,
                                         .forcing = cosine,
                                         .rhs = normal_form,
                                         .tangent = normal_form_tangent},
                              .p = {-0.1, angulars[i]},
                              .start = {0.01, 0.0, 0.5}};
        const whirl_branch_options options = whirl_branch_default(-0.2, 0.1);
        whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
        whirl_branch *branch = follow_branch(&family, start, 1, &options);
        const double turn = 2.0 * pi * angulars[i], angle = acos(cos(turn));
        assert_int_equal(1, count_special(branch, WHIRL_NEIMARK_SACKER));
        const whirl_branch_point *point = special_point(branch, WHIRL_NEIMARK_SACKER, 0);
        check_within("branches", words("normal form, w = %g: torus at", angulars[i]), 0.0, point->value, 1e-10);
        check_within("branches", "normal form, its angle", angle, point->angle, 1e-10);
        // Over a period r -> r (1 - 2 pi r^2); in the coordinate of a vector of length 1, r^2 is twice its modulus'.
        check_within("branches", "normal form, its criticality", -4.0 * pi, point->criticality, 1e-5);
        assert_int_equal(0, count_special(branch, WHIRL_FOLD) + count_special(branch, WHIRL_BRANCHING) +
                                count_special(branch, WHIRL_DOUBLING));
        assert_int_equal(0, branch->points[0].orbit->unstable);
        assert_int_equal(2, branch->points[branch->count - 1].orbit->unstable);
        whirl_branch_free(branch);
        whirl_orbit_free(start);
    }
}

/// u' = p u - a u^3 - b u |u| and v' = -v/2 in axes that turn by half a turn in a period, so that an odd law is one of
/// the period; and a driven coordinate. On u = v = 0 orbits of twice the period begin at p = 0. Where b is 0 the map
/// is u ->
/// -(u - 2 pi a u^3), whose coefficient is -2 pi a; else u |u| outgrows the cube, and there is none.
enum { CUBE = 1, KINK };

static void half_turns(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double *p = model, c = cos(0.5 * t), s = sin(0.5 * t), u = c * x[0] + s * x[1], v = c * x[1] - s * x[0];
    const double du = p[GROWTH] * u - p[CUBE] * u * u * u - p[KINK] * u * fabs(u), dv = -0.5 * v;
    dxdt[0] = c * du - s * dv - 0.5 * x[1];
    dxdt[1] = s * du + c * dv + 0.5 * x[0];
    dxdt[2] = *f - x[2];
}

static void half_turns_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                               size_t count, const double *u, double *out) {
    const double *p = model, c = cos(0.5 * t), s = sin(0.5 * t), at = c * x[0] + s * x[1];
    const double slope = p[GROWTH] - 3.0 * p[CUBE] * at * at - 2.0 * p[KINK] * fabs(at);
    (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, u += 3, out += 3) {
        const double along = slope * (c * u[0] + s * u[1]), across = -0.5 * (c * u[1] - s * u[0]);
        out[0] = c * along - s * across - 0.5 * u[1];
        out[1] = s * along + c * across + 0.5 * u[0];
        out[2] = -u[2];
    }
}

static void kinked_doublings(void **state) {
    static const double laws[][2] = {{1.0, 0.0}, {-0.3, 0.0}, {0.0, 1.0}, {0.0, -1.0}, {1.0, 0.1}, {1.0, 1e-4}};
    (void)state;
    for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) {
        test_family family = {.system = {.dimension = 3,
                                         .period = 2.0 * pi,
                                         .forcing_count = 1,
                                         .forcing = cosine,
                                         .rhs = half_turns,
                                         .tangent = half_turns_tangent},
                              .p = {-0.1, laws[i][0], laws[i][1]},
                              .start = {0.0, 0.0, 0.5}};
        const whirl_branch_options options = whirl_branch_default(-0.2, 0.1);
        char text[128];
        whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
        whirl_branch *branch = follow_branch(&family, start, 1, &options);
        const whirl_branch_point *point = special_point(branch, WHIRL_DOUBLING, 0);
        const char *const law = words("doubling, cube %g and kink %g", laws[i][0], laws[i][1]);
        assert_non_null(point);
        check_within("branches", words("%s: at", law), 0.0, point->value, 1e-8);
        whirl_special_text(point, text, sizeof text);
        if (laws[i][1] == 0.0)
            check_within("branches", words("%s: criticality", law), -2.0 * pi * laws[i][0], point->criticality, 1e-4);
        else
            check_text("branches", words("%s", law), "orbits of twice the period begin, criticality not known", text);
        whirl_branch_free(branch);
        whirl_orbit_free(start);
    }
}

/// x' = (p - .1) x, y' = .1 y: two real multipliers whose product is 1 at p = 0, where nothing happens; at p = .1 a
/// multiplier is 1 for all x at once. A driven coordinate is added.
static void saddles_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                            size_t count, const double *u, double *out) {
    const double *p = model;
    (void)t, (void)f, (void)x, (void)sides;
    for (size_t k = 0; k < count; k++, u += 3, out += 3) {
        out[0] = (p[0] - 0.1) * u[0];
        out[1] = 0.1 * u[1];
        out[2] = -u[2];
    }
}

static void saddles(const void *model, double t, const double *f, const double *x, double *dxdt) {
    saddles_tangent(model, t, f, x, NULL, 1, x, dxdt);
    dxdt[2] += *f;
}

static void neutral_saddles_are_no_tori(void **state) {
    (void)state;
    test_family family = {.system = {.dimension = 3,
                                     .period = 2.0 * pi,
                                     .forcing_count = 1,
                                     .forcing = cosine,
                                     .rhs = saddles,
                                     .tangent = saddles_tangent},
                          .p = {-0.05}};
    const whirl_branch_options options = whirl_branch_default(-0.05, 0.05);
    whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &options);
    for (size_t i = 0; i < branch->count; i++) assert_int_equal(WHIRL_REGULAR, branch->points[i].special);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

// ---------------------------------------------------------------- symmetry and doubling

/// Checks the orbits of x'' + .3 x' - x + x^3 = F cos 1.2 t, which double their periods on the way to chaos. Of two
/// equal wells each orbit in one has its mirror image in the other. The orbit that begins a revolution later is the
/// same one, and no other is.
static void expect_one_from_any_revolution(const test_family *family, const whirl_orbit *orbit,
                                           const whirl_orbit_options *options) {
    test_family later = *family;
    const whirl_system system = system_of(family);
    memcpy(later.start, orbit->nodes + orbit->dimension, orbit->dimension * sizeof *orbit->nodes);
    whirl_orbit *again = find_orbit(&later, orbit->revolutions, options), *copy = whirl_orbit_copy(orbit);
    assert_true(fabs(again->nodes[0] - orbit->nodes[0]) > 1e-4);
    assert_true(whirl_orbit_distance(&system, orbit, again->nodes) < 1e-9);
    assert_true(whirl_orbit_distance(&system, copy, orbit->nodes) == 0.0);
    const double size = fmax(fabs(later.start[0]), fabs(later.start[1]));
    again->nodes[0] += 1e-4;
    check_within("branches", "a state near an orbit", 1e-4 / size, whirl_orbit_distance(&system, orbit, again->nodes),
                 1e-9);
    whirl_orbit_free(again);
    whirl_orbit_free(copy);
}

static void doublings_of_duffing(void **state) {
    (void)state;
    test_family family = oscillator_family(1.2, 0.3, -1.0, 1.0, 0.2);
    family.varied = FORCE;
    family.start[0] = 0.56838897;
    family.start[1] = 0.41272660 / 1.2;
    whirl_branch_options options = whirl_branch_default(0.2, 0.32);
    const whirl_family machines = family_of(&family);
    double at[4], aside = 0.01;
    size_t revolutions = 1;
    whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
    check_digits("branches", "D2, F = .20: x", ".56838897", start->nodes[0]);
    for (size_t k = 0; k < 4; k++, aside *= 0.4) {
        whirl_branch *branch = follow_branch(&family, start, 1, &options);
        const whirl_branch_point *point = special_point(branch, WHIRL_DOUBLING, 0);
        assert_non_null(point);
        at[k] = point->value;
        assert_true(point->criticality < 0.0);
        // Up to there it is stable, and gives it to the orbit of twice the period.
        for (size_t i = 0; &branch->points[i] != point; i++) assert_int_equal(0, branch->points[i].orbit->unstable);
        check_within("branches", words("doubling, P-%zu: the multiplier at F = %.10f", revolutions, at[k]), -1.0,
                     point->orbit->multipliers[0].real, 1e-8);
        whirl_orbit_free(start);
        require_ok(whirl_branch_switch(&machines, point, aside, &options, &start, &family.p[FORCE]));
        revolutions *= 2;
        assert_int_equal(revolutions, start->revolutions);
        assert_int_equal(0, start->unstable);
        assert_true(family.p[FORCE] > at[k]);
        expect_one_from_any_revolution(&family, start, &options.orbit);
        whirl_branch_free(branch);
        options.step = 1e-3;
    }
    whirl_orbit_free(start);
    // Feigenbaum (1978): the ratios of successive distances tend to 4.669; he gives no bound for the first ones.
    const double ratio = (at[2] - at[1]) / (at[3] - at[2]);
    check_within("branches", "doubling, Feigenbaum's ratio", 4.669201609, ratio, 0.05);
}

// ---------------------------------------------------------------- grazes

/// x'' + .1 x' + x + s (x - 1) [x > 1] = F cos W t: nothing touches up to F^2 = (1 - W^2)^2 + (.1 W)^2 of amplitude 1.
static double gap_of(const double *p, const double *x) {
    return x[0] - p[GAP];
}

static void stop_on_sides(const void *model, double t, const double *f, const double *x, const double *sides,
                          double *dxdt) {
    const double *p = model;
    oscillator(model, t, f, x, dxdt);
    if (sides[0] > 0.0) dxdt[1] -= p[STOP] * gap_of(p, x) / (p[SPEED] * p[SPEED]);
}

static void stop(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double side = gap_of(model, x) > 0.0 ? 1.0 : -1.0;
    stop_on_sides(model, t, f, x, &side, dxdt);
}

static void stop_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                         size_t count, const double *u, double *out) {
    const double *p = model;
    const bool closed = sides ? sides[0] > 0.0 : gap_of(p, x) > 0.0;
    oscillator_tangent(model, t, f, x, sides, count, u, out);
    for (size_t k = 0; k < count; k++)
        if (closed) out[2 * k + 1] -= p[STOP] * u[2 * k] / (p[SPEED] * p[SPEED]);
}

static void stop_switch(const void *model, double t, const double *x, double *values) {
    (void)t;
    values[0] = gap_of(model, x);
}

static void stop_gradient(const void *model, double t, const double *x, size_t index, double *gradient,
                          double *by_time) {
    (void)model, (void)t, (void)x, (void)index;
    gradient[0] = 1.0;
    gradient[1] = *by_time = 0.0;
}

/// Gives an oscillator the stop.
static void add_stop(test_family *of, double stiffness, double gap) {
    of->system.switch_count = 1;
    of->system.rhs = stop;
    of->system.rhs_on_sides = stop_on_sides;
    of->system.tangent = stop_tangent;
    of->system.switches = stop_switch;
    of->system.switch_gradient = stop_gradient;
    of->p[STOP] = stiffness;
    of->p[GAP] = gap;
}

static test_family stop_family(double W, double F) {
    test_family family = oscillator_family(W, 0.1, 1.0, 0.0, F);
    add_stop(&family, 20.0, 1.0);
    family.varied = FORCE;
    return family;
}

static void grazes_are_located(void **state) {
    static const double speeds[] = {0.7, 0.95, 1.4};
    (void)state;
    for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++) {
        const double W = speeds[i], expected = hypot(1.0 - W * W, 0.1 * W);
        const test_family family = stop_family(W, 0.5 * expected);
        const whirl_branch_options options = whirl_branch_default(0.4 * expected, 1.1 * expected);
        whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
        whirl_branch *branch = follow_branch(&family, start, 1, &options);
        const whirl_branch_point *graze = special_point(branch, WHIRL_GRAZE, 0);
        assert_non_null(graze);
        check_within("branches", words("graze, W = %g: first touch at F =", W), expected, graze->value, 1e-9);
        for (size_t k = 0; k < branch->count; k++) {
            const whirl_touch *touch = &branch->points[k].orbit->touches[0];
            if (&branch->points[k] < graze) assert_int_equal(0, touch->intervals);
            if (&branch->points[k] > graze) assert_true(touch->intervals >= 1 && touch->share > 0.0);
        }
        whirl_branch_free(branch);
        whirl_orbit_free(start);
    }
}

/// Returns true for an orbit that ignores the stop: it is beyond it without a contact, or deeper in it than its speed
/// can drive it, v/sqrt(s).
static bool passes_through(const whirl_orbit *orbit, double stiffness, double W) {
    const double speed = fmax(orbit->high[1], -orbit->low[1]) * W, depth = orbit->high[0] - 1.0;
    return (depth > 1e-9 && orbit->touches[0].intervals == 0) || depth > speed / sqrt(stiffness);
}

/// The branch passes first touches and ends at the end of the range. Programs that do not look for the stop follow the
/// free orbit through it; all orbits here stay outside.
static void no_orbit_goes_through_the_stop(void **state) {
    static const double stiffnesses[] = {20.0, 1e3, 1e4};
    (void)state;
    for (size_t i = 0; i < sizeof stiffnesses / sizeof *stiffnesses; i++) {
        const double W = 0.7, free = hypot(1.0 - W * W, 0.1 * W);
        test_family family = stop_family(W, 0.8 * free);
        whirl_branch_options options = whirl_branch_default(0.7 * free, 2.0 * free);
        size_t within = 0, through = 0;
        double deepest = 0.0;
        family.p[STOP] = stiffnesses[i];
        options.most_points = 2000;
        options.orbit.tolerance = 1e-10; // in a contact as stiff as that no state is better
        whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
        whirl_branch *branch = follow_branch(&family, start, 1, &options);
        for (size_t k = 0; k < branch->count; k++) {
            const whirl_orbit *orbit = branch->points[k].orbit;
            within += orbit->touches[0].intervals > 0;
            through += branch->points[k].special != WHIRL_GRAZE && passes_through(orbit, stiffnesses[i], W);
            deepest = fmax(deepest, orbit->high[0] - 1.0);
        }
        print_message("stop of %g: %zu points, %zu touch, deepest %g, end %d\n", stiffnesses[i], branch->count, within,
                      deepest, (int)branch->end);
        assert_non_null(special_point(branch, WHIRL_GRAZE, 0));
        assert_int_equal(WHIRL_END_OF_RANGE, branch->end);
        check_within("branches", words("stop of stiffness %g: orbits that go through it", stiffnesses[i]), 0.0,
                     (double)through, 0.0);
        assert_true(within > 0);
        whirl_branch_free(branch);
        whirl_orbit_free(start);
    }
}

/// Follows a driven two-well oscillator over its force, and returns the first doubling of the branch, a copy.
static whirl_branch_point first_doubling(const test_family *family, whirl_branch **branch) {
    whirl_branch_options options = whirl_branch_default(0.2, 0.32);
    whirl_orbit *start = find_orbit(family, 1, &options.orbit);
    *branch = follow_branch(family, start, 1, &options);
    const whirl_branch_point *point = special_point(*branch, WHIRL_DOUBLING, 0);
    whirl_orbit_free(start);
    assert_non_null(point);
    return *point;
}

/// A stop at the displacement that the orbit reaches at its doubling: the map has a term of the power 3/2 of the depth,
/// and third differences have no limit. A stop farther away has no effect.
static void doublings_at_a_graze(void **state) {
    static const double stiffnesses[] = {0.3, 1.0, 10.0}, apart[] = {0.0, 1e-9, -1e-9};
    (void)state;
    for (size_t i = 0; i < sizeof stiffnesses / sizeof *stiffnesses; i++) {
        test_family family = oscillator_family(1.2, 0.3, -1.0, 1.0, 0.2);
        whirl_branch *branch;
        family.varied = FORCE;
        family.start[0] = 0.56838897;
        family.start[1] = 0.41272660 / 1.2;
        const whirl_branch_point alone = first_doubling(&family, &branch);
        const double far = 1.1 * alone.orbit->high[0];
        assert_true(alone.criticality < 0.0);
        whirl_branch_free(branch);
        add_stop(&family, stiffnesses[i], far);
        const whirl_branch_point beside = first_doubling(&family, &branch);
        const double place = far + beside.orbit->touches[0].nearest;
        check_within("branches", words("doubling, stop of %g next to the orbit: at F =", stiffnesses[i]), alone.value,
                     beside.value, 1e-10);
        check_within("branches", "its criticality", alone.criticality, beside.criticality,
                     1e-6 * fabs(alone.criticality));
        whirl_branch_free(branch);
        for (size_t k = 0; k < sizeof apart / sizeof *apart; k++) {
            char text[128];
            add_stop(&family, stiffnesses[i], place + apart[k]);
            const whirl_branch_point point = first_doubling(&family, &branch);
            const char *const of = words("doubling, stop of %g, %g beyond the orbit", stiffnesses[i], apart[k]);
            whirl_special_text(&point, text, sizeof text);
            // The multiplier changes with the root of the depth, 3e-5.
            check_within("branches", words("%s: at F =", of), alone.value, point.value, 1e-4 * stiffnesses[i]);
            check_text("branches", of, "orbits of twice the period begin, criticality not known", text);
            whirl_branch_free(branch);
        }
    }
}

// ---------------------------------------------------------------- curves over two parameters

static double largest_error(const whirl_branch *curve, double (*expected)(double second)) {
    double error = 0.0;
    for (size_t i = 0; i < curve->count; i++)
        error = fmax(error, fabs(curve->points[i].value - expected(curve->points[i].second)));
    return error;
}

static double amplitude_of_one(double W) {
    return hypot(1.0 - W * W, 0.1 * W);
}

/// First touches in the plane of force and speed, towards the resonance.
static void the_curve_of_first_touches(void **state) {
    (void)state;
    const test_family family = stop_family(0.7, 0.25);
    whirl_branch_options options = whirl_branch_default(0.2, 0.8);
    whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &options);
    const whirl_branch_point *graze = special_point(branch, WHIRL_GRAZE, 0);
    assert_non_null(graze);
    options.from = 0.0;
    options.most_step = 0.2;
    whirl_branch *curve = follow_curve(&family, SPEED, graze, 1, 0.6, 0.85, &options);
    assert_int_equal(WHIRL_END_OF_RANGE, curve->end);
    assert_true(curve->count > 8 && curve->points[curve->count - 1].second > 0.8);
    check_within("branches", words("first touches at %zu speeds: force", curve->count), 0.0,
                 largest_error(curve, amplitude_of_one), 1e-9);
    whirl_branch_free(curve);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

/// Folds of Duffing's oscillator meet in a cusp; there the curve turns in both parameters. Every point of it is a fold:
/// a multiplier is 1, and at another point of it the branch over the speed turns at the same place.
static void the_curve_of_folds_has_a_cusp(void **state) {
    (void)state;
    test_family family = oscillator_family(0.8, 0.05, 1.0, 0.1, 0.18);
    whirl_branch_options options = whirl_branch_default(0.8, 1.5);
    whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &options);
    whirl_branch *curve = follow_curve(&family, FORCE, special_point(branch, WHIRL_FOLD, 0), -1, 0.01, 0.2, &options);
    double least = INFINITY, off = 0.0;
    size_t turns = 0;
    for (size_t i = 0; i < curve->count; i++) {
        const whirl_branch_point *point = &curve->points[i];
        const whirl_multiplier *m = point->orbit->multipliers;
        least = fmin(least, point->second);
        turns += i > 1 && (point->second > point[-1].second) != (point[-1].second > point[-2].second);
        off = fmax(off, fmin(fabs(m[0].real - 1.0), fabs(m[1].real - 1.0)));
    }
    check_within("branches", "folds: the multiplier that is 1", 0.0, off, 1e-8);
    assert_int_equal(1, turns);
    print_message("%zu folds, cusp near F = %.6f\n", curve->count, least);
    // Half way back the other fold of the same branch is met.
    const whirl_branch_point *last = &curve->points[curve->count - 1];
    assert_true(last->second > 0.17);
    test_family at = family;
    at.p[FORCE] = last->second;
    whirl_orbit *again = find_orbit(&at, 1, &options.orbit);
    whirl_branch *over = follow_branch(&at, again, 1, &options);
    check_within("branches", words("fold at F = %.6f", last->second), special_point(over, WHIRL_FOLD, 1)->value,
                 last->value, 1e-9);
    whirl_branch_free(over);
    whirl_orbit_free(again);
    whirl_branch_free(curve);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

/// Follows the onset of period doubling in the plane of force and damping. At the damping of the curve's last point a
/// separate branch doubles at the same force.
static void the_curve_of_doublings(void **state) {
    (void)state;
    test_family family = oscillator_family(1.2, 0.3, -1.0, 1.0, 0.2);
    family.varied = FORCE;
    family.start[0] = 0.56838897;
    family.start[1] = 0.41272660 / 1.2;
    whirl_branch_options options = whirl_branch_default(0.2, 0.32);
    whirl_orbit *start = find_orbit(&family, 1, &options.orbit);
    whirl_branch *branch = follow_branch(&family, start, 1, &options);
    whirl_branch *curve =
        follow_curve(&family, DAMPING, special_point(branch, WHIRL_DOUBLING, 0), 1, 0.29, 0.33, &options);
    const whirl_branch_point *last = &curve->points[curve->count - 1];
    assert_true(curve->count > 3 && last->second > 0.32);
    test_family at = family;
    at.p[DAMPING] = last->second;
    whirl_orbit *again = find_orbit(&at, 1, &options.orbit);
    whirl_branch *over = follow_branch(&at, again, 1, &options);
    check_within("branches", words("doubling at a damping of %.6f", last->second),
                 special_point(over, WHIRL_DOUBLING, 0)->value, last->value, 1e-9);
    whirl_branch_free(over);
    whirl_orbit_free(again);
    whirl_branch_free(curve);
    whirl_branch_free(branch);
    whirl_orbit_free(start);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(folds_of_nlvib),
                                       cmocka_unit_test(two_of_three_are_stable),
                                       cmocka_unit_test(both_wells_are_found),
                                       cmocka_unit_test(a_torus_begins),
                                       cmocka_unit_test(neutral_saddles_are_no_tori),
                                       cmocka_unit_test(kinked_doublings),
                                       cmocka_unit_test(doublings_of_duffing),
                                       cmocka_unit_test(grazes_are_located),
                                       cmocka_unit_test(doublings_at_a_graze),
                                       cmocka_unit_test(no_orbit_goes_through_the_stop),
                                       cmocka_unit_test(the_curve_of_first_touches),
                                       cmocka_unit_test(the_curve_of_folds_has_a_cusp),
                                       cmocka_unit_test(the_curve_of_doublings)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
