// Elements at stations that move along one axis and are fixed along the other: they are the limit of machines whose
// stations a stiff spring holds there. Rates of change at the same state are the same, except for the motion of the
// fixed coordinate; eigenvalues by the exact Jacobian differ by the order of the element's stiffness over the spring's.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "support_study.h"
#include "whirl/engine/rotor.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
static const char *const id = "lone housings";

typedef struct lone {
    const char *what, *element;
    bool inertial; ///< it couples accelerations, so that a held station moves others even at the same state
} lone;

#define FILM "viscosity: 0.01, radius: 0.02, length: 0.02"
#define PADS "pivots: [0.785, 2.356, 3.927, 5.498], arc: 1.2, preload: 0.3, clearance: 1e-4, " FILM
static const lone elements[] = {
    {"bearing in it", "bearing: {at: disc, from: ped, kxx: 3e6, kxy: 4e5, kyx: -2e5, kyy: 2e6, cxx: 900, cyx: 50}",
     false},
    {"bearing in it with inertia", "bearing: {at: disc, from: ped, kxx: 3e6, cxx: 900, mxx: 2, mxy: 0.1}", true},
    {"bearing in it of the frequency",
     "bearing: {at: disc, from: ped, frequencies: [0, 100, 200, 300], poles: 2, fit_error: 0.5, "
     "kxx: [3e6, 3.2e6, 3.5e6, 3.6e6], cxx: [900, 700, 500, 450]}",
     false},
    {"ball bearing in it", "ball_bearing: {at: disc, from: ped, balls: 8, stiffness: 1e9, cage: 0.4, damping: 200}",
     false},
    {"ball bearing in it with a dent",
     "ball_bearing: {at: disc, from: ped, balls: 8, stiffness: 1e9, damping: 200, "
     "inner: 0.04, outer: 0.064, outer_dent: 2e-6, outer_dent_width: 0.1}",
     false},
    {"film of finite length in it", "film: {at: disc, from: ped, law: finite, clearance: 1e-4, " FILM "}", false},
    {"short film in it", "film: {at: disc, from: ped, clearance: 1e-4, " FILM "}", false},
    {"pads in it", "pad_bearing: {at: disc, from: ped, " PADS "}", false},
    {"tilting pads in it", "tilting_pad: {at: disc, from: ped, inertia: 1e-4, " PADS "}", false},
    {"floating ring in it",
     "floating_ring: {at: disc, ring: ring, from: ped, inertia: 1e-5, clearance: 1e-4, " FILM
     ", outer_clearance: 1.5e-4, outer_radius: 0.03, outer_length: 0.02}",
     false},
    {"squeeze film in it", "squeeze: {at: disc, from: ped, clearance: 1e-4, " FILM "}", false},
    {"seal in it", "seal: {at: disc, from: ped, clearance: 1e-4, stiffness: 1e6, damping: 600, ratio: 0.45, growth: 2}",
     false},
    {"seal in it with mass",
     "seal: {at: disc, from: ped, clearance: 1e-4, stiffness: 1e6, damping: 600, mass: 1, ratio: 0.45}", true},
    {"stator of contact",
     "contact: {at: disc, from: ped, gap: 1e-5, stiffness: 1e9, radius: 0.1, friction: 0.1, slip_speed: 0.1}", false},
    {"casing of blades",
     "blade_rub: {at: disc, from: ped, blades: 5, radius: 0.3, gap: 1e-5, stiffness: 2e6, friction: 0.1}", false},
    {"magnetic bearing in it",
     "magnetic: {at: disc, from: ped, law: linear, current_stiffness: 200, "
     "displacement_stiffness: 2e5, proportional: 2e4, derivative: 20, derivative_filter: 1e4}",
     false},
    {"spring to it", "spring: {between: [disc, ped], stiffness: 1e6, damping: 500}", false},
    {"spring from it", "spring: {between: [ped, disc], stiffness: 1e6, damping: 500}", false},
    {"spring to it with play", "spring: {between: [disc, ped], along: y, stiffness: 1e6, gap: 1e-6}", false},
    {"cubic spring to it", "cubic_spring: {between: [disc, ped], stiffness: 1e6, cubic: 1e14, damping: 100}", false},
    {"friction at it", "friction: {between: [disc, ped], force: 20, slip_speed: 0.01}", false},
    {"mount under it", "mount: {between: [disc, ped], stiffness: 1e6, branch: 2e6, damping: 500}", false},
    {"crack to it", "crack: {between: [disc, ped], stiffness: 1e6, loss: 0.2}", false},
    {"coupling to it", "coupling: {between: [disc, ped], radial: 1e6, radial_damping: 100}", false},
    {"bearing of it", "bearing: {at: ped, kxx: 3e6, kxy: 4e5, kyx: -2e5, kyy: 2e6, cxx: 900}", false},
    {"squeeze film of it", "squeeze: {at: ped, clearance: 1e-4, " FILM "}", false},
    {"seal of it", "seal: {at: ped, clearance: 1e-4, stiffness: 1e6, damping: 600, ratio: 0.45}", false},
    {"contact of it", "contact: {at: ped, gap: 1e-5, stiffness: 1e9}", false},
    {"spring of it along xy", "spring: {between: [ped, ground], stiffness: 1e6, damping: 500}", false},
};

/// The spring of the other machine, along the axis that `moves` excludes.
static const double stiff = 1e13;

static whirl_rotor *make(const char *element, const char *moves, bool spring) {
    static char text[2048];
    const char *const held = strcmp(moves, "y") == 0 ? "x" : "y";
    const int used = snprintf(
        text, sizeof text,
        "whirl: 1\nrotor:\n  speed: 200\n  length_scale: 1e-4\n  stations:\n    disc: {mass: 10, eccentricity: 1e-5}\n"
        "    ring: {mass: 0.4}\n    ped: {mass: 60, moves: %s}\n  elements:\n"
        "    - spring: {between: [disc, ground], stiffness: 1e6, damping: 100}\n"
        "    - spring: {between: [ring, ground], stiffness: 2e6, damping: 50}\n"
        "    - spring: {between: [ped, ground], along: %s, stiffness: %g, damping: 300}\n    - %s\n"
        "study: {response: {}, integrate: {method: rk4}}\n",
        spring ? "xy" : moves, spring ? held : moves, spring ? stiff : 3e6, element);
    assert_true(used > 0 && (size_t)used < sizeof text);
    if (spring) { // the other axis, too
        char more[160], *end = strstr(text, "study:");
        snprintf(more, sizeof more, "    - spring: {between: [ped, ground], along: %s, stiffness: 3e6, damping: 300}\n",
                 moves);
        const size_t room = strlen(more);
        memmove(end + room, end, strlen(end) + 1);
        memcpy(end, more, room);
    }
    whirl_case *object = case_of_text(text);
    whirl_rotor *rotor;
    require_ok(whirl_case_rotor(object, "", 0.0, &rotor));
    whirl_case_free(object);
    return rotor;
}

/// Finds the coordinates of one machine in the other: displacements, velocities, then states of elements.
static size_t match(const whirl_system *one, const whirl_system *other, const char *moves, size_t *at) {
    size_t count = 0;
    const bool along_y = strcmp(moves, "y") == 0;
    const size_t degrees = 5;
    for (size_t s = 0; s < 3; s++) {
        const whirl_probe *a = &one->probes[s], *b = &other->probes[s];
        const bool ped = s == 2;
        if (!ped || !along_y) at[a->x] = b->x, at[a->vx] = b->vx, count += 2;
        if (!ped || along_y) at[a->y] = b->y, at[a->vy] = b->vy, count += 2;
    }
    for (size_t i = 2 * degrees; i < one->dimension; i++, count++) at[i] = i + 2;
    return count;
}

/// Returns the distance of `to` from the nearest of the eigenvalues, over 1 + |to|.
static double nearest(const double complex *values, size_t count, double complex to) {
    double least = INFINITY;
    for (size_t i = 0; i < count; i++) least = fmin(least, cabs(values[i] - to) / (1.0 + cabs(to)));
    return least;
}

static void check(const lone *of, const char *moves) {
    whirl_rotor *one = make(of->element, moves, false), *two = make(of->element, moves, true);
    const whirl_system *a = whirl_rotor_system(one), *b = whirl_rotor_system(two);
    double x[MAX_DIMENSION], y[MAX_DIMENSION] = {0.0}, dx[MAX_DIMENSION], dy[MAX_DIMENSION];
    double matrix[MAX_DIMENSION * MAX_DIMENSION], other[MAX_DIMENSION * MAX_DIMENSION];
    double complex values[MAX_DIMENSION], others[MAX_DIMENSION];
    size_t at[MAX_DIMENSION];
    const size_t n = a->dimension;
    assert_int_equal(n + 2, b->dimension);
    assert_int_equal(match(a, b, moves, at), n);
    for (size_t i = 0; i < n; i++) y[at[i]] = x[i] = 0.3 * sin(1.0 + 2.7 * (double)i);
    const double t = 0.4;
    double largest = 0.0, apart = 0.0, away = 0.0;
    evaluate_rhs(a, t, x, dx);
    evaluate_rhs(b, t, y, dy);
    for (size_t i = 0; i < n; i++) {
        largest = fmax(largest, fabs(dx[i]));
        apart = fmax(apart, fabs(dx[i] - dy[at[i]]));
    }
    if (!of->inertial)
        check_within(id, words("%s, moves: %s, rates of change", of->what, moves), 0.0, apart / largest, 1e-13);
    exact_jacobian(a, t, x, matrix);
    exact_jacobian(b, t, y, other);
    eigenvalues(n, matrix, values);
    eigenvalues(n + 2, other, others);
    for (size_t i = 0; i < n; i++) away = fmax(away, nearest(others, n + 2, values[i]));
    check_within(id, words("%s, moves: %s, eigenvalues", of->what, moves), 0.0, away, 1e-5);
    whirl_rotor_free(one);
    whirl_rotor_free(two);
}

static void elements_act_along_one_axis(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT_OF(elements); i++)
        for (int along = 0; along < 2; along++) {
            if (strstr(elements[i].element, "along: y") && !along) continue;
            check(&elements[i], along ? "y" : "x");
        }
}

/// A clearance around the origin is reported only if the housing is fixed along both axes.
static void housings_that_stand(void **state) {
    static const char *const moving[] = {"film: {at: disc, from: ped, law: finite, clearance: 1e-4, " FILM "}",
                                         "squeeze: {at: disc, from: ped, clearance: 1e-4, " FILM "}",
                                         "pad_bearing: {at: disc, from: ped, " PADS "}",
                                         "seal: {at: disc, from: ped, clearance: 1e-4, stiffness: 1e6, ratio: 0.45}"};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(moving); i++)
        for (int along = 0; along < 2; along++) {
            whirl_rotor *rotor = make(moving[i], along ? "y" : "x", false);
            check_within(id, words("%.11s in a housing that moves along %s: clearance", moving[i], along ? "y" : "x"),
                         0.0, whirl_rotor_system(rotor)->probes[0].clearance, 0.0);
            whirl_rotor_free(rotor);
        }
}

static void elements_that_need_a_plane(void **state) {
    static const struct {
        const char *element, *sentence;
    } wrong[] = {
        {"film: {at: ped, clearance: 1e-4, " FILM "}", "needs a station that moves along x, and 'ped' does not"},
        {"shaft: {between: [disc, ped], k1: 1e6}", "needs a station that moves along x, and 'ped' does not"},
        {"stage: {at: ped, power: 1e5, diameter: 0.3, width: 0.02}",
         "needs a station that moves along x, and 'ped' does not"},
        {"rub: {at: ped, gap: 1e-4, stiffness: 1e6}", "needs a station that moves along x, and 'ped' does not"},
        {"spring: {between: [ped, ground], along: x, stiffness: 1e6}",
         "needs a station that moves along x, and 'ped' does not"}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(wrong); i++) {
        char text[1024], problems[2048];
        whirl_case *object = NULL;
        snprintf(text, sizeof text,
                 "whirl: 1\nrotor:\n  speed: 200\n  length_scale: 1e-4\n  stations: {disc: {mass: 10}, ped: {mass: 60, "
                 "moves: y}}\n  elements:\n    - %s\nstudy: {response: {}}\n",
                 wrong[i].element);
        const whirl_status status = whirl_case_check(text, strlen(text), "t", problems, sizeof problems, &object);
        check_holds(id, words("%.30s is refused", wrong[i].element),
                    status.code == WHIRL_BAD_INPUT && strstr(problems, wrong[i].sentence) != NULL);
        whirl_case_free(object);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(elements_act_along_one_axis),
                                       cmocka_unit_test(housings_that_stand),
                                       cmocka_unit_test(elements_that_need_a_plane)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
