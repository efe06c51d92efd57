// Equilibria that begin to whirl: where, how fast, and the orbits that begin there, against closed forms, the
// thresholds of journal bearings, and the motions that settle.
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
#include "support_flow.h"
#include "support_rotor.h"

static const double pi = 3.14159265358979323846;

// ---------------------------------------------------------------- a normal form

/// z' = (p + i w) z + a |z|^2 z - |z|^4 z in x = z + 1 of one coordinate, so that the equilibrium is not at 0. Orbits
/// are circles of radius r with p + a r^2 - r^4 = 0 and period 2 pi / w; p: p, w, a.
enum { GROWTH, ANGULAR, CUBIC };

static void circles(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const double *p = model, u = x[0] - 1.0, v = x[1], r2 = u * u + v * v;
    const double growth = p[GROWTH] + p[CUBIC] * r2 - r2 * r2;
    (void)t, (void)f;
    dxdt[0] = growth * u - p[ANGULAR] * v;
    dxdt[1] = growth * v + p[ANGULAR] * u;
}

static void circles_tangent(const void *model, double t, const double *f, const double *x, const double *sides,
                            size_t count, const double *d, double *out) {
    const double *p = model, u = x[0] - 1.0, v = x[1], r2 = u * u + v * v;
    const double growth = p[GROWTH] + p[CUBIC] * r2 - r2 * r2, slope = 2.0 * (p[CUBIC] - 2.0 * r2);
    (void)t, (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, d += 2, out += 2) {
        const double along = slope * (u * d[0] + v * d[1]);
        out[0] = growth * d[0] + along * u - p[ANGULAR] * d[1];
        out[1] = growth * d[1] + along * v + p[ANGULAR] * d[0];
    }
}

static test_family circles_family(double p, double w, double a) {
    return (test_family){.system = {.dimension = 2, .period = 1.0, .rhs = circles, .tangent = circles_tangent},
                         .p = {p, w, a},
                         .start = {1.1, 0.2}};
}

static whirl_branch *follow_rest(const test_family *family, const whirl_branch_options *options) {
    const whirl_system system = system_of(family);
    whirl_orbit *rest = NULL;
    require_ok(whirl_orbit_rest(&system, family->start, &options->orbit, &rest));
    whirl_branch *branch = follow_branch(family, rest, 1, options);
    whirl_orbit_free(rest);
    return branch;
}

static void circles_begin_at_the_hopf_point(void **state) {
    (void)state;
    const test_family family = circles_family(-0.5, 1.7, -1.0);
    const whirl_family machines = family_of(&family);
    whirl_branch_options options = whirl_branch_default(-0.5, 0.5);
    options.most_step = 0.1;
    whirl_branch *branch = follow_rest(&family, &options);
    assert_int_equal(1, count_special(branch, WHIRL_HOPF));
    const whirl_branch_point *point = special_point(branch, WHIRL_HOPF, 0);
    check_within("Hopf", "circles, Hopf point at", 0.0, point->value, 1e-10);
    check_within("Hopf", "circles, its frequency", 1.7, point->angle, 1e-10);
    // In coordinates u + i v = sqrt 2 w of a vector of length 1: 2 a over twice the frequency, twice.
    check_within("Hopf", "circles, its criticality", -1.0 * 2.0 / 1.7, point->criticality, 1e-7);
    check_within("Hopf", "circles, the equilibrium", 1.0, point->orbit->nodes[0], 1e-12);
    whirl_orbit *orbit;
    double value;
    require_ok(whirl_branch_switch(&machines, point, 0.1, &options, &orbit, &value));
    double radius = hypot(orbit->nodes[0] - 1.0, orbit->nodes[1]);
    check_within("Hopf", "circles, parameter of the first orbit", pow(radius, 2.0) + pow(radius, 4.0), value, 1e-9);
    test_family at = family;
    at.p[GROWTH] = value;
    whirl_branch *whirling = follow_branch(&at, orbit, 1, &options);
    const whirl_branch_point *last = &whirling->points[whirling->count - 1];
    radius = hypot(last->orbit->nodes[0] - 1.0, last->orbit->nodes[1]);
    const double square = (sqrt(3.0) - 1.0) / 2.0;
    check_within("Hopf", "circles, at p = .5: square of the radius", square, radius * radius, 1e-10);
    check_within("Hopf", "circles, its period", 2.0 * pi / 1.7, last->orbit->period, 1e-10);
    // Perturbations of the radius follow (r^2)' = 2 r^2 (p - r^2 - r^4).
    check_within("Hopf", "circles, its multiplier", exp(-2.0 * square * (1.0 + 2.0 * square) * 2.0 * pi / 1.7),
                 last->orbit->multipliers[1].real, 1e-10);
    whirl_branch_free(whirling);
    whirl_orbit_free(orbit);
    whirl_branch_free(branch);
}

/// With a > 0 circles lead back to smaller p, unstable, and turn at p = -a^2/4 where r^2 = a/2.
static void circles_turn_back_at_the_fold(void **state) {
    (void)state;
    const test_family family = circles_family(-0.5, 1.0, 1.2);
    const whirl_family machines = family_of(&family);
    whirl_branch_options options = whirl_branch_default(-0.5, 0.5);
    options.most_step = 0.1;
    options.orbit.segments = 4;
    whirl_branch *branch = follow_rest(&family, &options);
    whirl_orbit *orbit;
    double value;
    require_ok(whirl_branch_switch(&machines, special_point(branch, WHIRL_HOPF, 0), 0.1, &options, &orbit, &value));
    assert_true(value < 0.0);
    assert_int_equal(1, orbit->unstable);
    test_family at = family;
    at.p[GROWTH] = value;
    whirl_branch *whirling = follow_branch(&at, orbit, -1, &options);
    assert_int_equal(1, count_special(whirling, WHIRL_FOLD));
    const whirl_branch_point *fold = special_point(whirling, WHIRL_FOLD, 0);
    check_within("Hopf", "circles, fold at", -0.36, fold->value, 1e-10);
    check_within("Hopf", "circles, square of the radius there", 0.6,
                 pow(fold->orbit->nodes[0] - 1.0, 2.0) + pow(fold->orbit->nodes[1], 2.0), 1e-5);
    assert_int_equal(0, whirling->points[whirling->count - 1].orbit->unstable);
    whirl_branch_free(whirling);
    whirl_orbit_free(orbit);
    whirl_branch_free(branch);
}

// ---------------------------------------------------------------- oil whirl

/// Rotors in the short film over the speed s, with a load that holds the journal at eccentricity ratio e at any speed.
typedef struct oil_family {
    double e, journal; ///< journal mass over the disc's on a flexible shaft; 0: a rigid rotor
} oil_family;

/// Returns sigma = F0/W, and writes where the journal is.
static double place_journal(double e, double position[2]) {
    const double phi = atan2(pi * sqrt(1.0 - e * e), 4.0 * e);
    double force[2];
    position[0] = e * sin(phi);
    position[1] = -e * cos(phi);
    whirl_film_force(position[0], position[1], 0.0, 0.0, force);
    return 1.0 / hypot(force[0], force[1]);
}

static void release_rotor(void *rotor) {
    whirl_rotor_free(rotor);
}

static whirl_status make_oil(const void *context, double s, whirl_machine *machine) {
    const oil_family *own = context;
    double position[2];
    const double sigma = place_journal(own->e, position), weight = 1.0 + own->journal;
    whirl_rotor *rotor = own->journal > 0.0 ? make_flexible_film_rotor(s, own->journal, 2.0 * weight, sigma * weight)
                                            : make_film_rotor(sigma / (s * s), 1.0 / (s * s), 0.0);
    *machine = (whirl_machine){.system = whirl_rotor_system(rotor), .owner = rotor, .release = release_rotor};
    return whirl_ok();
}

static whirl_branch *follow_oil(const oil_family *own, double from, double to, whirl_branch_options *options) {
    const whirl_family family = {make_oil, own};
    whirl_machine machine;
    whirl_branch *branch;
    whirl_orbit *rest;
    double x[MAX_DIMENSION] = {0.0};
    *options = whirl_branch_default(from, to);
    options->most_step = 0.1;
    require_ok(make_oil(own, from, &machine));
    x[machine.system->dimension / 2 - 2] = 0.1;
    x[machine.system->dimension / 2 - 1] = -0.1;
    require_ok(whirl_orbit_rest(machine.system, x, &options->orbit, &rest));
    require_ok(whirl_branch_follow(&family, rest, from, 1, options, &branch));
    whirl_orbit_free(rest);
    machine.release(machine.owner);
    return branch;
}

static void thresholds_of_oil_whirl(void **state) {
    static const struct {
        double e, journal;
        const char *speed, *ratio;
    } rows[] = {{0.1, 0.0, "2.741278636", ".50293839"},
                {0.3, 0.0, "2.605785828", ".51941739"},
                {0.5, 0.0, "2.541730858", ".51464014"},
                {0.5, 0.1, "1.9285152416", NULL}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const oil_family own = {rows[i].e, rows[i].journal};
        whirl_branch_options options;
        whirl_branch *branch = follow_oil(&own, 1.5, 3.0, &options);
        const char *id = own.journal > 0.0 ? "A6" : "A5";
        assert_int_equal(1, count_special(branch, WHIRL_HOPF));
        const whirl_branch_point *point = special_point(branch, WHIRL_HOPF, 0);
        check_digits("Hopf", words("%s, e = %g: Hopf point at s =", id, own.e), rows[i].speed, point->value);
        if (rows[i].ratio) check_digits("Hopf", words("%s, whirl ratio", id), rows[i].ratio, point->angle);
        whirl_branch_free(branch);
    }
}

static whirl_status make_oil_in_plane(const void *context, double s, double e, whirl_machine *machine) {
    const oil_family own = {e, 0.0};
    (void)context;
    return make_oil(&own, s, machine);
}

/// Returns largest real part of the eigenvalues of the rigid rotor that rests at eccentricity ratio e, by LAPACK.
static double growth_at(double e, double s) {
    const oil_family own = {e, 0.0};
    whirl_machine machine;
    double x[4] = {0.0}, matrix[16];
    place_journal(e, x);
    require_ok(make_oil(&own, s, &machine));
    exact_jacobian(machine.system, 0.0, x, matrix);
    machine.release(machine.owner);
    return largest_real_part(4, matrix, NULL);
}

/// The threshold over the journal's place, from e = .5 down: at each point of the curve the rotor is stable at a speed
/// lower by 1e-8 of it, and unstable at one higher by as much.
static void the_curve_of_thresholds(void **state) {
    (void)state;
    const oil_family own = {0.5, 0.0};
    const whirl_plane plane = {make_oil_in_plane, NULL};
    const double bounds[2] = {0.1, 0.6};
    whirl_branch_options options;
    whirl_branch *branch = follow_oil(&own, 1.5, 3.0, &options), *curve;
    require_ok(whirl_curve_follow(&plane, special_point(branch, WHIRL_HOPF, 0), 0.5, -1, bounds, &options, &curve));
    double least = INFINITY, at = 0.0;
    size_t wrong = 0;
    for (size_t i = 0; i < curve->count; i++) {
        const double s = curve->points[i].value, e = curve->points[i].second;
        if (s < least) at = e;
        least = fmin(least, s);
        wrong += growth_at(e, s * (1.0 - 1e-8)) >= 0.0 || growth_at(e, s * (1.0 + 1e-8)) <= 0.0;
    }
    const double last = curve->points[curve->count - 1].second;
    check_holds("Hopf", words("A5, %zu thresholds from e = .5 to %.3f are such to 1e-8", curve->count, last),
                wrong == 0 && curve->count > 10 && last < 0.15);
    // The smallest one is at e = .45697072, which a point of the curve is near.
    check_within("Hopf", "A5, place of the smallest threshold on the curve", 0.45697072, at, 0.03);
    whirl_branch_free(curve);
    whirl_branch_free(branch);
}

/// A little beyond the threshold the rigid rotor settles on the orbit of the branch. If no orbit begins on that side,
/// the loss of stability is sudden, and the branch leads to lower speeds, unstable.
static void the_rotor_settles_on_the_branch(void **state) {
    static const double places[] = {0.1, 0.3, 0.5};
    (void)state;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        const oil_family own = {places[i], 0.0};
        const whirl_family family = {make_oil, &own};
        whirl_branch_options options;
        whirl_branch *rest = follow_oil(&own, 1.5, 3.0, &options);
        const whirl_branch_point *point = special_point(rest, WHIRL_HOPF, 0);
        whirl_orbit *orbit;
        double value;
        require_ok(whirl_branch_switch(&family, point, 0.3, &options, &orbit, &value));
        assert_true((point->criticality < 0.0) == (value > point->value));
        print_message("e = %g: orbits at s %+g from the threshold\n", own.e, value - point->value);
        assert_int_equal(value > point->value ? 0 : 1, orbit->unstable);
        if (value > point->value) {
            whirl_machine machine;
            require_ok(make_oil(&own, value, &machine));
            double x[MAX_DIMENSION];
            whirl_integrator *integrator = make_integrator(machine.system, "dop853", 256);
            // From an orbit larger by a tenth, as many revolutions as bring it back by the multiplier to 1e-8 of that.
            for (size_t d = 0; d < 4; d++)
                x[d] = point->orbit->nodes[d] + 1.1 * (orbit->nodes[d] - point->orbit->nodes[d]);
            const double decay = -log(hypot(orbit->multipliers[1].real, orbit->multipliers[1].imaginary));
            revolve(integrator, x, (int)ceil(20.0 / decay * orbit->period / (2.0 * pi)) + 10);
            whirl_orbit *same;
            require_ok(whirl_orbit_find_free(machine.system, x, orbit->period, &options.orbit, &same));
            double moved = 0.0;
            for (size_t d = 0; d < 4; d++) moved = fmax(moved, fabs(same->nodes[d] - x[d]));
            check_within("Hopf", "oil whirl, where it settled, off the orbit through there", 0.0, moved, 1e-7);
            check_within("Hopf", words("oil whirl, e = %g: smallest x", own.e), orbit->low[0], same->low[0], 1e-5);
            check_within("Hopf", words("oil whirl, e = %g: largest x", own.e), orbit->high[0], same->high[0], 1e-5);
            whirl_orbit_free(same);
            whirl_integrator_free(integrator);
            machine.release(machine.owner);
        }
        whirl_orbit_free(orbit);
        whirl_branch_free(rest);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circles_begin_at_the_hopf_point), cmocka_unit_test(circles_turn_back_at_the_fold),
        cmocka_unit_test(thresholds_of_oil_whirl), cmocka_unit_test(the_curve_of_thresholds),
        cmocka_unit_test(the_rotor_settles_on_the_branch)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
