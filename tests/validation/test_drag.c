// Drag of films and seals on a shaft that no motor turns, or whose torque is known: closed forms, and independent
// integrations of the written-out equations.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/result.h"
#include "whirl/internal/bearing.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 2048, ROWS = 4 };

static const double two_pi = 6.283185307179586476925;

/// Runs a journal of 10 kg in a bearing, on a shaft that no drive turns.
static whirl_result *coast(const char *bearing, const char *more, double inertia, double from, double duration) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\n"
             "rotor:\n"
             "  speed: 500 rad/s\n"
             "  length_scale: 1e-4 m\n"
             "%s"
             "  elements:\n"
             "    - %s\n"
             "    - drive: {inertia: %.17g kg.m2, torque: 0 N.m, no_load_speed: 500 rad/s}\n"
             "study:\n"
             "  runup: {speed_from: %g rad/s, duration: %g s, rtol: 1e-11, rows: 4, samples: 64, stationary: 0}\n",
             more, bearing, inertia, from, duration);
    return result_of_text(text);
}

static double end_speed(const whirl_result *result) {
    return first_number(result, WHIRL_FIELD_RUNUP_END_SPEED, 0, 0);
}

/// Returns drag of the last row.
static double last_drag(const whirl_result *result) {
    return first_number(result, WHIRL_FIELD_RUNUP_TORQUE, 0, 5 * (ROWS - 1) + 4);
}

/// Returns x (0) or y (1) at the end of the run, m.
static double place_of(const whirl_result *result, size_t axis) {
    return 1e-4 * first_number(result, WHIRL_FIELD_RUNUP_PLACE, 0, axis);
}

#define UPRIGHT "  stations:\n    j: {mass: 10 kg, damping: 1000 N.s/m}\n"
#define LYING(...) "  stations:\n    j: {mass: 10 kg" __VA_ARGS__ "}\n"
#define OIL "clearance: 4e-5 m, viscosity: 0.02 Pa.s, radius: 0.02 m, length: 0.02 m"

/// 2 pi mu R^3 L/c, N m s.
static const double petroff = 6.283185307179586476925 * 0.02 * 8e-6 * 0.02 / 4e-5;

/// Centred journals have Petroff's torque, by which the speed falls as exp(-t petroff/J).
static void centred(void **state) {
    static const struct {
        const char *bearing;
        double times;
    } known[] = {
        {"film: {at: j, law: short, " OIL "}", 1.0},
        {"film: {at: j, law: capone, count: 3, " OIL "}", 3.0},
        {"film: {at: j, law: finite, " OIL "}", 1.0},
        {"pad_bearing: {at: j, shape: two-groove, " OIL "}", 320.0 / 360.0},
        {"tilting_pad: {at: j, pivots: [45 deg, 135 deg, 225 deg, 315 deg], arc: 0.001 rad, inertia: 1e-6 kg.m2, "
         "tilt_stiffness: 1 N.m/rad, " OIL "}",
         0.004 / 6.283185307179586476925},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        whirl_result *result = coast(known[i].bearing, UPRIGHT, 0.002, 500.0, 1.0);
        check_within("Drag", words("centred, %.40s: speed after 1 s", known[i].bearing),
                     500.0 * exp(-petroff * known[i].times / 0.002), end_speed(result), 1e-7);
        whirl_result_free(result);
    }
}

/// A journal at rest under its weight has the torque 2 pi mu w R^3 L/(c sqrt(1 - e^2)), and half of the moment of its
/// load (Ocvirk; Sommerfeld). The shaft is heavy, so that its speed stays.
static void loaded(void **state) {
    static const char *const films[] = {"film: {at: j, law: short, " OIL "}", "film: {at: j, law: finite, " OIL "}"};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(films); i++)
        for (int clockwise = 0; clockwise < 2; clockwise++) {
            char bearing[SIZE];
            snprintf(bearing, sizeof bearing, "%s\n    - gravity: 200 m/s2", films[i]);
            whirl_result *result =
                coast(bearing, clockwise ? "  rotation: clockwise\n" LYING() : LYING(), 1e9, 500.0, 0.2);
            const double x = place_of(result, 0);
            const double y = place_of(result, 1);
            const double e = hypot(x, y) / 4e-5, couple = 0.5 * fabs(x) * 2000.0;
            check_holds("Drag", words("eccentricity ratio %.3g of film %zu is that of a loaded journal", e, i),
                        e > 0.4 && e < 0.95);
            check_within("Drag", words("loaded, film %zu, %s", i, clockwise ? "clockwise" : "counter-clockwise"),
                         -(petroff * 500.0 / sqrt(1.0 - e * e) + couple), last_drag(result), 1e-9);
            whirl_result_free(result);
        }
}

/// A coast-down with unbalance and weight in a short film. Independent: the film's pressure and the shear of the wall
/// by quadrature, the mass matrix solved at every instant, DOP853 of SciPy at 1e-12; there the energy that is lost
/// equals the integral of both kinds of dissipation, shear and flow, to 4e-14.
static void coast_down(void **state) {
    static const struct {
        double duration;
        const char *angle, *speed, *x, *y;
    } known[] = {
        {0.05, "24.8422750832", "493.704179102", "4.66668962", "-1.33039761"},
        {0.5, "234.798435518", "440.430010541", "5.72648245", "-.491506745"},
        {2.0, "783.886332921", "300.362470208", "7.05009845", "-2.00524287"},
    };
    (void)state;
    for (size_t i = 0; i < COUNT_OF(known); i++) {
        whirl_result *result = coast("film: {at: j, law: short, " OIL "}\n    - gravity: 9.81 m/s2",
                                     LYING(", eccentricity: 5e-6 m"), 0.002, 500.0, known[i].duration);
        check_digits("Drag", words("coast-down, %g s: angle", known[i].duration), known[i].angle,
                     two_pi * first_number(result, WHIRL_FIELD_RUNUP_END_TURNS, 0, 0));
        check_digits("Drag", words("coast-down, %g s: speed", known[i].duration), known[i].speed, end_speed(result));
        check_digits("Drag", words("coast-down, %g s: x (um)", known[i].duration), known[i].x,
                     1e6 * place_of(result, 0));
        check_digits("Drag", words("coast-down, %g s: y (um)", known[i].duration), known[i].y,
                     1e6 * place_of(result, 1));
        whirl_result_free(result);
    }
}

/// Returns the drag of pads by the bearing's own finite volumes: the integral of 1/h over the pads, and half of the
/// moments of their forces about the centres of their curvature, over mu w R^3 L/c.
static double drag_of_pads(const whirl_pads *of, const whirl_pads_state *rest) {
    enum { PARTS = 20000 };
    double sum = 0.0;
    for (size_t p = 0; p < of->count; p++) {
        const whirl_pad *pad = &of->pads[p];
        const double n[2] = {cos(pad->pivot), sin(pad->pivot)}, t[2] = {-n[1], n[0]};
        double d[2], force[2];
        for (int i = 0; i < 2; i++) {
            d[i] = rest->at[i] + pad->preload * n[i] - rest->tilt[p] * t[i];
            force[i] = rest->moment[p] * t[i] - rest->thrust[p] * n[i];
        }
        sum += 0.5 * (d[0] * force[1] - d[1] * force[0]);
        for (int i = 0; i < PARTS; i++) {
            const double angle = pad->pivot + pad->arc * ((i + 0.5) / PARTS - pad->offset);
            sum += pad->arc / PARTS / (1.0 - d[0] * cos(angle) - d[1] * sin(angle));
        }
    }
    return sum;
}

static void pads(void **state) {
    static const char *const shapes[] = {"three-lobe", "tilting-4"};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(shapes); i++) {
        char bearing[SIZE];
        whirl_pads own = {.ratio = 0.5, .fineness = 480};
        whirl_pads_state rest;
        assert_true(whirl_pads_named(shapes[i], 0.6, &own));
        const double unit = 0.02 * 500.0 * 0.02 * 0.02 * 250000.0; // mu w R L (R/c)^2
        const double load[2] = {0.0, -300.0 / unit};
        require_ok(whirl_pads_rest(&own, load, &rest));
        snprintf(bearing, sizeof bearing, "%s: {at: j, shape: %s, preload: 0.6, " OIL "}\n    - gravity: 30 m/s2",
                 i ? "tilting_pad" : "pad_bearing", shapes[i]);
        whirl_result *result = coast(bearing, LYING(), 1e9, 500.0, 0.2);
        const double expected = drag_of_pads(&own, &rest);
        check_within("Drag", words("%s: over mu w R^3 L/c", shapes[i]), expected,
                     -last_drag(result) / (petroff * 500.0 / two_pi), 2e-3 * expected);
        check_holds("Drag", words("%s: streamers in cavities would have less drag, by at most a tenth", shapes[i]),
                    rest.drag <= expected * (1.0 + 1e-6) && rest.drag > 0.9 * expected);
        whirl_result_free(result);
    }
}

/// A floating ring: two centred films in a row, J w' = -a (w - r), J' r' = a (w - r) - b r.
static void ring(void **state) {
    const double J = 0.002, own = 1e-5, a = petroff, b = petroff * 0.5 * 1.331;
    const double begin[2] = {500.0, 500.0 * a / (a + b)};
    (void)state;
    whirl_result *result =
        coast("floating_ring: {at: j, ring: r, inertia: 1e-5 kg.m2, " OIL ", outer_clearance: 8e-5 m, "
              "outer_radius: 0.022 m, outer_length: 0.02 m}",
              "  stations:\n    j: {mass: 10 kg, damping: 1000 N.s/m}\n"
              "    r: {mass: 0.1 kg, damping: 1000 N.s/m}\n",
              J, 500.0, 1.0);
    // Eigenvalues and their parts of [[-a/J, a/J], [a/J', -(a + b)/J']].
    const double p = -a / J, q = a / J, s = -(a + b) / own, middle = 0.5 * (p + s);
    const double half = sqrt(0.25 * (p - s) * (p - s) + q * a / own), slow = middle + half, fast = middle - half;
    const double slope = p * begin[0] + q * begin[1];
    const double of_fast = (slope - slow * begin[0]) / (fast - slow);
    check_within("Drag", "floating ring: speed after 1 s", (begin[0] - of_fast) * exp(slow) + of_fast * exp(fast),
                 end_speed(result), 1e-7);
    whirl_result_free(result);
}

/// A centred seal of law black: the shear of the wall is lambda rho V^2/2 times slip over V, and lambda follows from
/// the loss of pressure, rho V^2/2 (1.5 + 2 sigma) = 1 MPa, sigma = lambda L/c, with V = 18.273896746 m/s at 100 pi
/// rad/s (computed in 30 digits). Of the law muszynska nothing is known but the couple.
static void seal(void **state) {
    const double speed = 314.159265358979323846, V = 18.273896746, lambda = 0.00897836818263;
    const double torque = 0.05 * two_pi * 0.05 * 0.05 * 0.5 * lambda * 1000.0 * V * 0.05 * speed * 0.5;
    (void)state;
    whirl_result *result =
        coast("seal: {at: j, law: black, clearance: 2e-4 m, radius: 0.05 m, length: 0.05 m, density: "
              "1000 kg/m3, viscosity: 1e-3 Pa.s, pressure: 1e6 Pa}",
              UPRIGHT, 1e9, speed, 0.2);
    check_within("Drag", "seal of law black", -torque, last_drag(result), 2e-6 * torque);
    whirl_result_free(result);
    result = coast("seal: {at: j, clearance: 2e-4 m, stiffness: 1e6 N/m, damping: 1000 N.s/m, ratio: 0.4}", UPRIGHT,
                   0.002, 500.0, 0.2);
    check_within("Drag", "centred seal of law muszynska: speed", 500.0, end_speed(result), 1e-10);
    check_holds("Drag", "a warning names the seal whose drag is not known",
                strstr(whirl_result_warning(result, 0), "seal of law muszynska: their drag does not follow") != NULL);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(centred),    cmocka_unit_test(loaded),
                                       cmocka_unit_test(coast_down), cmocka_unit_test(pads),
                                       cmocka_unit_test(ring),       cmocka_unit_test(seal)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
