// Tori of the paper's rotor without its stator, past its Neimark-Sacker points (case E3): compared with long motions of
// independently written equations, and with the normal form.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../peers/auto/rotor_equations.h"
#include "support_branch.h"
#include "support_check.h"
#include "support_torus.h"

static const double pi = 3.14159265358979323846;

/// The rotor over r_k with the branch of its orbits, and that of its tori from the upper Neimark-Sacker point on.
typedef struct followed {
    whirl_case *object;
    case_family family;
    whirl_branch *orbits;
    const whirl_branch_point *upper, *lower;
    whirl_torus_branch_options options;
    whirl_torus_branch *tori;
} followed;

static int follow(void **state) {
    static followed all;
    const double aside[ROTOR_STATES] = {0.0, -0.9, 0.0, -0.8};
    whirl_branch_options options = whirl_branch_default(0.38, 0.6);
    whirl_machine machine;
    whirl_orbit *start;
    whirl_torus *first;
    double value;
    require_ok(whirl_case_load(WHIRL_CASES "/../tests/peers/auto/rotor.yaml", NULL, &all.object));
    all.family = (case_family){all.object, "r_k"};
    const whirl_family machines = family_of_case(&all.family);
    require_ok(machines.machine(machines.context, options.to, &machine));
    require_ok(whirl_orbit_find(machine.system, aside, 1, &options.orbit, &start));
    machine.release(machine.owner);
    require_ok(whirl_branch_follow(&machines, start, options.to, -1, &options, &all.orbits));
    whirl_orbit_free(start);
    all.upper = special_point(all.orbits, WHIRL_NEIMARK_SACKER, 0);
    all.lower = special_point(all.orbits, WHIRL_NEIMARK_SACKER, 1);
    assert_non_null(all.lower);
    all.options = whirl_torus_branch_default(0.38, 0.5);
    require_ok(whirl_torus_begin(&machines, all.upper, 0.02, &all.options, &first, &value));
    require_ok(whirl_torus_follow(&machines, first, value, -1, &all.options, &all.tori));
    whirl_torus_free(first);
    *state = &all;
    return 0;
}

static int forget(void **state) {
    followed *all = *state;
    whirl_torus_branch_free(all->tori);
    whirl_branch_free(all->orbits);
    whirl_case_free(all->object);
    return 0;
}

/// Both losses of the orbit are gentle, and the tori that begin at one end at the other.
static void tori_join_two_points(void **state) {
    const followed *all = *state;
    const whirl_torus_branch *tori = all->tori;
    size_t most = 0, unstable = 0;
    double error = 0.0;
    for (size_t i = 0; i < tori->count; i++) {
        const whirl_torus *torus = tori->points[i].torus;
        most = torus->node_count > most ? torus->node_count : most;
        unstable += torus->unstable;
        error = fmax(error, torus->error);
    }
    print_message("%zu tori of up to %zu nodes: %s\n", tori->count, most, tori->why);
    assert_true(all->upper->criticality < 0.0 && all->lower->criticality < 0.0);
    check_holds("tori", words("rotor: all %zu tori between are stable", tori->count), unstable == 0);
    check_within("tori", "largest error of their curves between nodes", 0.0, error, all->options.torus.accuracy);
    assert_int_equal(WHIRL_TORUS_SHRANK, tori->end);
    const whirl_torus_point *last = &tori->points[tori->count - 1];
    check_within("tori", "r_k of the last one, small", all->lower->value, last->value, 2e-3);
    check_within("tori", "its rotation number", all->lower->angle / (2.0 * pi), last->torus->rotation, 2e-4);
}

/// Returns the modulus of the multipliers that leave the circle.
static double modulus_at(const followed *all, const whirl_branch_point *point, double value) {
    const whirl_family machines = family_of_case(&all->family);
    const whirl_orbit_options options = whirl_orbit_default();
    whirl_machine machine;
    whirl_orbit *orbit;
    require_ok(machines.machine(machines.context, value, &machine));
    require_ok(whirl_orbit_find(machine.system, point->orbit->nodes, 1, &options, &orbit));
    machine.release(machine.owner);
    const double modulus = hypot(orbit->multipliers[0].real, orbit->multipliers[0].imaginary);
    whirl_orbit_free(orbit);
    return modulus;
}

/// Returns |c|^2 of the first harmonic c exp(i theta) + conj.
static double first_harmonic(const whirl_torus *torus) {
    double square = 0.0;
    for (size_t i = 0; i < torus->dimension; i++) {
        double complex c = 0.0;
        for (size_t j = 0; j < torus->node_count; j++)
            c += torus->nodes[j * torus->dimension + i] * cexp(-2.0 * pi * I * (double)j / (double)torus->node_count);
        c /= (double)torus->node_count;
        square += creal(c * conj(c));
    }
    return square;
}

/// Returns |c|^2 over the distance from the point; its limit there is the growth of the modulus over the cubic
/// coefficient.
static double square_over_distance(const followed *all, const whirl_branch_point *point, double step) {
    const whirl_family machines = family_of_case(&all->family);
    whirl_torus *torus;
    double value;
    require_ok(whirl_torus_begin(&machines, point, step, &all->options, &torus, &value));
    const double ratio = first_harmonic(torus) / (value - point->value);
    whirl_torus_free(torus);
    return ratio;
}

static void radius_grows_as_the_normal_form_says(void **state) {
    const followed *all = *state;
    const whirl_branch_point *points[] = {all->upper, all->lower};
    const double h = 1e-4;
    for (size_t i = 0; i < 2; i++) {
        const whirl_branch_point *point = points[i];
        const double growth =
            (modulus_at(all, point, point->value + h) - modulus_at(all, point, point->value - h)) / (2.0 * h);
        // Its error goes with the square of the step.
        const double near = square_over_distance(all, point, 0.003), far = square_over_distance(all, point, 0.006);
        const double expected = -growth / point->criticality, found = (4.0 * near - far) / 3.0;
        check_within("tori", words("rotor, r_k = %.8f: square of the radius over the distance", point->value), 1.0,
                     found / expected, 1e-3);
    }
}

static void rotor_slope_at(const void *model, double t, const double *x, double *slope) {
    double u[ROTOR_ALL], all[ROTOR_ALL];
    memcpy(u, x, ROTOR_STATES * sizeof *u);
    u[8] = cos(t);
    u[9] = sin(t);
    rotor_slope(*(const double *)model, u, all);
    memcpy(slope, all, ROTOR_STATES * sizeof *slope);
}

/// The torus from a long motion's sections is that of the branch from the Neimark-Sacker point.
static void a_long_motion_runs_on_it(void **state) {
    enum { STEPS = 768, SETTLING = 700, COUNT = 1200, CHECKED = 400 };
    const followed *all = *state;
    const whirl_family machines = family_of_case(&all->family);
    const double r_k = 0.43, start[ROTOR_STATES] = {0.0, -0.9, 0.0, -0.8};
    double *points = long_motion(rotor_slope_at, &r_k, ROTOR_STATES, 2.0 * pi, STEPS, start, SETTLING, COUNT);
    const double *last = points + (size_t)(COUNT - CHECKED) * ROTOR_STATES;
    whirl_torus *torus;
    whirl_machine machine;
    require_ok(machines.machine(machines.context, r_k, &machine));
    require_ok(whirl_torus_find(machine.system, last, CHECKED, 1, NAN, &all->options.torus, &torus));
    machine.release(machine.owner);
    check_within("tori", words("rotor, r_k = %g: rotation number", r_k), mean_turn(points, ROTOR_STATES, COUNT),
                 torus->rotation, 1e-8);
    check_within("tori", words("largest distance of %d of its sections from the curve", CHECKED), 0.0,
                 distance_from(torus, last, CHECKED), 1e-7);
    // From the nearest point of the branch up to there.
    whirl_torus_branch_options options = all->options;
    const whirl_torus_point *from = &all->tori->points[0];
    for (size_t i = 0; i < all->tori->count && all->tori->points[i].value > r_k; i++) from = &all->tori->points[i];
    whirl_torus_branch *to;
    options.from = r_k;
    require_ok(whirl_torus_follow(&machines, from->torus, from->value, -1, &options, &to));
    assert_int_equal(WHIRL_TORUS_END_OF_RANGE, to->end);
    const whirl_torus *same = to->points[to->count - 1].torus;
    check_within("tori", "rotation number there of the branch from the upper point", torus->rotation, same->rotation,
                 1e-9);
    check_within("tori", "its largest exponent", torus->exponents[0], same->exponents[0], 1e-6);
    check_within("tori", "largest distance of its nodes from the curve", 0.0,
                 distance_from(torus, same->nodes, same->node_count), 1e-7);
    whirl_torus_branch_free(to);
    whirl_torus_free(torus);
    free(points);
}

// ---------------------------------------------------------------- with its stator, the calibrated reading

/// Follows the orbits of five revolutions up from r_k = 0.493, where the rotor settles on one; returns where they end.
static double fold_of_five(const whirl_family *machines) {
    const whirl_branch_options options = whirl_branch_default(0.49, 0.498);
    const whirl_integrate_options steps = whirl_integrate_default();
    double x[ROTOR_STATES] = {0.0, -0.6, 0.0, -0.6};
    whirl_machine machine;
    whirl_integrator *integrator;
    whirl_orbit *orbit;
    whirl_branch *branch;
    require_ok(machines->machine(machines->context, 0.493, &machine));
    require_ok(whirl_integrator_new(machine.system, &steps, &integrator));
    for (int k = 0; k < 800; k++) whirl_integrator_revolve(integrator, x, NULL, NULL);
    require_ok(whirl_orbit_find(machine.system, x, 5, &options.orbit, &orbit));
    whirl_integrator_free(integrator);
    machine.release(machine.owner);
    whirl_branch_options short_way = options;
    short_way.most_points = 16;
    require_ok(whirl_branch_follow(machines, orbit, 0.493, 1, &short_way, &branch));
    const whirl_branch_point *fold = special_point(branch, WHIRL_FOLD, 0);
    assert_non_null(fold);
    const double value = fold->value;
    whirl_branch_free(branch);
    whirl_orbit_free(orbit);
    return value;
}

/// Returns mean square of x1 exp(-i f t) over a long motion, with the weights of Das et al.
static double line_at(const double *samples, size_t count, double step, double frequency) {
    double complex sum = 0.0;
    double weights = 0.0;
    for (size_t m = 0; m < count; m++) {
        const double part = (double)(m + 1) / (double)(count + 1), weight = exp(-1.0 / (part * (1.0 - part)));
        sum += weight * samples[m] * cexp(-I * frequency * step * (double)m);
        weights += weight;
    }
    return creal(sum * conj(sum)) / (weights * weights);
}

typedef struct waveform {
    double *next;
} waveform;

static void keep_first(void *context, double t, const double *x) {
    waveform *w = context;
    (void)t;
    *w->next++ = x[0];
}

/// Checks that of all lines |i +- rho| up to 4 the spectrum of the disc in a long motion on the torus has the largest
/// at the frequency of the torus.
static void check_line(const whirl_family *machines, const whirl_torus_point *point) {
    enum { REVOLUTIONS = 600, INSTANTS = 32 };
    const whirl_torus_options options = whirl_torus_default();
    whirl_integrate_options steps = options.integrate;
    double *samples = calloc((size_t)REVOLUTIONS * INSTANTS, sizeof *samples), x[ROTOR_STATES], line, amplitude,
           largest = -1.0, at = 0.0;
    waveform w = {samples};
    whirl_machine machine;
    whirl_integrator *integrator;
    assert_non_null(samples);
    steps.steps_per_revolution = INSTANTS;
    require_ok(machines->machine(machines->context, point->value, &machine));
    require_ok(whirl_torus_line(machine.system, point->torus, &options, 0, &line, &amplitude));
    require_ok(whirl_integrator_new(machine.system, &steps, &integrator));
    memcpy(x, point->torus->nodes, sizeof x);
    for (int k = 0; k < REVOLUTIONS; k++) whirl_integrator_revolve(integrator, x, keep_first, &w);
    for (int i = -4; i <= 4; i++) {
        const double frequency = fabs(i + point->torus->rotation);
        const double square = line_at(samples, (size_t)REVOLUTIONS * INSTANTS, 2.0 * pi / INSTANTS, frequency);
        if (square > largest) at = frequency;
        largest = fmax(largest, square);
    }
    check_within("tori", "paper's rotor: second frequency, and where the disc's spectrum is largest", at, line, 1e-12);
    check_within("tori", "its amplitude", 2.0 * sqrt(largest), amplitude, 1e-6);
    whirl_integrator_free(integrator);
    machine.release(machine.owner);
    free(samples);
}

/// The torus that begins at r_k = 0.4978 locks: its rotation number comes to 2/5 as the root of the distance from where
/// two orbits of five revolutions appear on it.
static void the_paper_rotor_locks_to_five_revolutions(void **state) {
    (void)state;
    whirl_case *object;
    require_ok(whirl_case_load(WHIRL_CASES "/paper.yaml", NULL, &object));
    const case_family family = {object, "r_k"};
    const whirl_family machines = family_of_case(&family);
    const whirl_branch_options orbits = whirl_branch_default(0.48, 0.51);
    whirl_torus_branch_options options = whirl_torus_branch_default(0.48, 0.51);
    const double aside[ROTOR_STATES] = {0.0, -0.6, 0.0, -0.6};
    whirl_machine machine;
    whirl_orbit *orbit;
    whirl_branch *branch;
    whirl_torus *first;
    whirl_torus_branch *tori;
    double value;
    require_ok(machines.machine(machines.context, 0.51, &machine));
    require_ok(whirl_orbit_find(machine.system, aside, 1, &orbits.orbit, &orbit));
    machine.release(machine.owner);
    require_ok(whirl_branch_follow(&machines, orbit, 0.51, -1, &orbits, &branch));
    options.torus.accuracy = 1e-5;
    options.torus.most_nodes = 63;
    const whirl_branch_point *point = special_point(branch, WHIRL_NEIMARK_SACKER, 0);
    assert_non_null(point);
    require_ok(whirl_torus_begin(&machines, point, 0.02, &options, &first, &value));
    require_ok(whirl_torus_follow(&machines, first, value, -1, &options, &tori));
    const whirl_torus_point *last = &tori->points[tori->count - 1];
    print_message("%zu tori to r_k = %.6f: %s\n", tori->count, last->value, tori->why);
    assert_int_equal(WHIRL_TORUS_ROUGH, tori->end);
    assert_int_equal(5, last->torus->resonance);
    check_line(&machines, &tori->points[2]);
    const double one = pow(0.4 - last->torus->rotation, 2.0), two = pow(0.4 - last[-1].torus->rotation, 2.0);
    const double locks = last->value - one * (last[-1].value - last->value) / (two - one);
    check_within("tori", "paper's rotor: r_k where the torus locks, and of the fold of P-5", fold_of_five(&machines),
                 locks, 1e-4);
    whirl_torus_branch_free(tori);
    whirl_torus_free(first);
    whirl_branch_free(branch);
    whirl_orbit_free(orbit);
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tori_join_two_points), cmocka_unit_test(radius_grows_as_the_normal_form_says),
        cmocka_unit_test(a_long_motion_runs_on_it), cmocka_unit_test(the_paper_rotor_locks_to_five_revolutions)};
    return cmocka_run_group_tests(tests, follow, forget);
}
