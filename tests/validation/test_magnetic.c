// Magnetic bearings: forces within limits, closed loops, any transfer function, a bearing that fails.
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
#include "whirl/engine/linear.h"
#include "whirl/engine/rotor.h"

enum { MAX_SETTINGS = 24 };
static const double two_pi = 6.283185307179586476925;

/// Makes a mass in a bearing, in a case of that speed and length.
static whirl_rotor *make(double speed, double length, double mass, const whirl_setting *settings) {
    whirl_design *design;
    whirl_rotor *rotor;
    size_t count = 0;
    while (settings[count].key) count++;
    require_ok(whirl_design_new(speed, length, &design));
    require_ok(whirl_design_station(design, "mass", (whirl_setting[]){{"mass", mass, NULL}}, 1));
    require_ok(whirl_design_element(design, "magnetic", settings, count));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

// ---------------------------------------------------------------- the force

static const double turns = 120.0, area = 4e-4, gap = 5e-4, bias = 3.0;

/// Returns the force in N at displacement u of the first axis and a current i, which a proportional law makes.
static double force_at(double u, double i, double most, double angle, double other[1]) {
    const whirl_setting settings[MAX_SETTINGS] = {
        {"at", 0.0, "mass"},  {"turns", turns, NULL},         {"area", area, NULL},   {"gap", gap, NULL},
        {"bias", bias, NULL}, {"proportional", -i / u, NULL}, {"angle", angle, NULL}, {"max_current", most, NULL}};
    whirl_rotor *rotor = make(1.0, 1e-3, 1.0, settings);
    double slope[4];
    evaluate_rhs(whirl_rotor_system(rotor), 0.0, (double[]){u * cos(angle) / 1e-3, u * sin(angle) / 1e-3, 0.0, 0.0},
                 slope);
    whirl_rotor_free(rotor);
    *other = (slope[3] * cos(angle) - slope[2] * sin(angle)) * 1e-3;
    return (slope[2] * cos(angle) + slope[3] * sin(angle)) * 1e-3;
}

static void forces(void **unused) {
    (void)unused;
    const double mu = 2e-7 * two_pi, k = 0.25 * mu * turns * turns * area, a = two_pi / 16.0;
    double other;
    check_within("magnetic-force", "k by 120 turns and 4 cm2, N m2/A2", 1.809557368468e-6, k, 5e-19);
    for (int n = 0; n < 4; n++) {
        const double angle = n == 0 ? two_pi / 8.0 : 0.4 * n;
        check_digits("magnetic-force", words("u = .1 mm, i = .5 A, first axis at %.3g rad: force, N", angle),
                     "98.973652488", force_at(1e-4, 0.5, 10.0, angle, &other));
        check_within("magnetic-force", words("the same, first axis at %.3g rad: force across it, N", angle), 0.0, other,
                     1e-12);
    }
    // With an integral alone the current is a state, which the place does not change at once.
    const whirl_setting integral[MAX_SETTINGS] = {
        {"at", 0.0, "mass"},  {"turns", turns, NULL},  {"area", area, NULL}, {"gap", gap, NULL},
        {"bias", bias, NULL}, {"integral", 1.0, NULL}, {"angle", 0.0, NULL}, {"max_current", 6.0, NULL}};
    whirl_rotor *rotor = make(1.0, 1e-3, 1.0, integral);
    double jacobian[36];
    exact_jacobian(whirl_rotor_system(rotor), 0.0, (double[6]){0.0}, jacobian);
    // The state counts the current in bias by gap and length scale.
    check_digits("magnetic-force", "k_i, N/A", "80.24702475", -jacobian[2 * 6 + 4] * 1e-3 / (bias / gap * 1e-3));
    check_digits("magnetic-force", "k_s, N/m", "481482.148502", jacobian[2 * 6]);
    whirl_rotor_free(rotor);
    // Beyond the bias one coil is off; beyond i_max - bias the other gives no more.
    check_within("magnetic-force", "i = 5 A of at most 6 A a coil: force, N", k * cos(a) * pow(6.0 / (gap - 1e-4), 2.0),
                 force_at(1e-4, 5.0, 6.0, 0.3, &other), 1e-9);
    check_within("magnetic-force", "i = 4 A: one coil off, force, N", k * cos(a) * pow(7.0 / (gap + 1e-4), 2.0),
                 force_at(-1e-4, 4.0, 10.0, 0.3, &other), 1e-9);
}

// ---------------------------------------------------------------- closed loops

/// m 10, k_s 2e6, k_i 200 and a PID by one law or the other.
static const whirl_setting linear[MAX_SETTINGS] = {{"at", 0.0, "mass"},
                                                   {"law", 0.0, "linear"},
                                                   {"current_stiffness", 200.0, NULL},
                                                   {"displacement_stiffness", 2e6, NULL},
                                                   {"proportional", 2e4, NULL},
                                                   {"integral", 1e5, NULL},
                                                   {"derivative", 40.0, NULL},
                                                   {"derivative_filter", 2e-4, NULL}};
static const whirl_setting quadratic[MAX_SETTINGS] = {
    {"at", 0.0, "mass"},     {"constant", 2.5e-6, NULL}, {"pole_angle", 0.0, NULL},
    {"gap", 5e-4, NULL},     {"bias", 5.0, NULL},        {"proportional", 2e4, NULL},
    {"integral", 1e5, NULL}, {"derivative", 40.0, NULL}, {"derivative_filter", 2e-4, NULL}};

static void poles(void **unused) {
    (void)unused;
    for (int k = 0; k < 2; k++) {
        const char *name = k ? "quadratic law" : "linear law";
        whirl_rotor *rotor = make(300.0, 1e-4, 10.0, k ? quadratic : linear);
        const whirl_system *system = whirl_rotor_system(rotor);
        const double start[8] = {0.0};
        whirl_modes *modes;
        assert_int_equal(system->dimension, 8);
        require_ok(whirl_modes_new(system, start, &modes));
        assert_int_equal(modes->count, 2);
        assert_int_equal(modes->real_count, 4);
        check_digits("magnetic-loop", words("%s: real pole, 1/s", name), "-10.43040969", 300.0 * modes->reals[0]);
        check_digits("magnetic-loop", words("%s: real pole of the filter, 1/s", name), "-4016.20231373",
                     300.0 * modes->reals[3]);
        check_digits("magnetic-loop", words("%s: pair, real part, 1/s", name), "-486.683638292",
                     300.0 * modes->modes[0].real);
        check_digits("magnetic-loop", words("%s: pair, imaginary part, rad/s", name), "43.0798432236",
                     300.0 * modes->modes[0].imaginary);
        whirl_sensitivity_peak sensitivity;
        require_ok(whirl_loops_peak(system, modes, &sensitivity));
        check_digits("magnetic-loop", words("%s: peak sensitivity", name), "1.201274", sensitivity.peak);
        check_digits("magnetic-loop", words("%s: at, Hz", name), "210.633", 300.0 * sensitivity.frequency / two_pi);
        whirl_modes_free(modes);
        whirl_rotor_free(rotor);
    }
}

/// Returns the transfer function of a loop of sensor, PID, filter and amplifier at s.
static double complex loop_at(double complex s) {
    const double complex sensor = 1.0 / (1.0 + 1.4 * s / 9e3 + s * s / 81e6);
    const double complex pid = 2e4 + 1e5 / s + 40.0 * s / (1.0 + 2e-4 * s);
    const double complex notch = (s * s + 60.0 * s + 4e6) / (s * s + 900.0 * s + 4e6) * (1e9 / ((s + 3e4) * (s + 4e4)));
    return sensor * pid * notch / (1.0 + s / 6e3);
}

/// Every eigenvalue is a root of (m s^2 - k_s + k_i G(s)) = 0, with all blocks of the controller.
static void transfer_functions(void **unused) {
    (void)unused;
    // (s^2 + 60 s + 4e6) 1e9 over (s^2 + 900 s + 4e6)(s^2 + 7e4 s + 1.2e9)
    const double a1 = 900.0, a0 = 4e6, b1 = 7e4, b0 = 1.2e9;
    whirl_setting settings[MAX_SETTINGS];
    char below[256];
    size_t count = 8;
    snprintf(below, sizeof below, "1, %.17g, %.17g, %.17g, %.17g", a1 + b1, a0 + a1 * b1 + b0, a0 * b1 + a1 * b0,
             a0 * b0);
    memcpy(settings, linear, sizeof linear);
    settings[count++] = (whirl_setting){"sensor_bandwidth", 9e3 / two_pi, NULL};
    settings[count++] = (whirl_setting){"sensor_damping", 0.7, NULL};
    settings[count++] = (whirl_setting){"amplifier_bandwidth", 6e3 / two_pi, NULL};
    settings[count++] = (whirl_setting){"numerator", 0.0, "1e9, 6e10, 4e15"};
    settings[count++] = (whirl_setting){"denominator", 0.0, below};
    whirl_rotor *rotor = make(500.0, 1e-4, 10.0, settings);
    const whirl_system *system = whirl_rotor_system(rotor);
    const double start[22] = {0.0};
    double worst = 0.0;
    size_t found = 0;
    assert_int_equal(system->dimension, 4 + 2 * 9);
    whirl_modes *modes;
    require_ok(whirl_modes_new(system, start, &modes));
    for (size_t i = 0; i < modes->count + modes->real_count; i++) {
        const bool wave = i < modes->count;
        const double complex s =
            500.0 * (wave ? modes->modes[i].real + I * modes->modes[i].imaginary : modes->reals[i - modes->count]);
        const double complex left = 10.0 * s * s - 2e6, right = 200.0 * loop_at(s);
        worst = fmax(worst, cabs(left + right) / (cabs(10.0 * s * s) + 2e6 + cabs(right)));
        found += wave ? 2 : 1;
    }
    assert_int_equal(found, 22);
    // S is 1/(1 + L), L the loop's gain over the mass on its negative spring: its largest value, by a fine search.
    double peak = 0.0;
    for (int k = 0; k <= 2000000; k++) {
        const double complex at = I * pow(10.0, 1.0 + 4.0 * k / 2e6);
        peak = fmax(peak, cabs(1.0 / (1.0 + 200.0 * loop_at(at) / (10.0 * at * at - 2e6))));
    }
    whirl_sensitivity_peak sensitivity;
    require_ok(whirl_loops_peak(system, modes, &sensitivity));
    check_within("magnetic-loop", "the same loop: peak sensitivity, from 1/(1 + L)", peak, sensitivity.peak, 1e-8);
    check_within("magnetic-loop",
                 "sensor and notch of order 2, PID, amplifier: m s^2 - k_s + k_i G(s) at all 22 poles, over its terms",
                 0.0, worst, 1e-9);
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
}

/// Masses that couple both axes: S of the first is 1 + X, (M s^2 + k_i G - k_s) (X, Y) = -(k_i G, 0).
static void coupled_masses(void **unused) {
    (void)unused;
    const double own = 12.0, cross = 4.0, start[8] = {0.0};
    whirl_setting settings[MAX_SETTINGS];
    whirl_design *design;
    whirl_rotor *rotor;
    memcpy(settings, linear, sizeof linear);
    settings[8] = (whirl_setting){"angle", 0.0, NULL};
    require_ok(whirl_design_new(400.0, 1e-4, &design));
    require_ok(whirl_design_station(design, "mass", (whirl_setting[]){{"mass", 10.0, NULL}}, 1));
    require_ok(whirl_design_element(design, "magnetic", settings, 9));
    const whirl_setting fluid[] = {{"at", 0.0, "mass"}, {"mxx", own - 10.0, NULL}, {"mxy", cross, NULL}};
    require_ok(whirl_design_element(design, "bearing", fluid, 3));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    whirl_modes *modes;
    whirl_sensitivity_peak found;
    require_ok(whirl_modes_new(whirl_rotor_system(rotor), start, &modes));
    require_ok(whirl_loops_peak(whirl_rotor_system(rotor), modes, &found));
    double peak = 0.0;
    for (int k = 0; k <= 1000000; k++) {
        const double complex p = I * pow(10.0, 1.0 + 4.0 * k / 1e6);
        const double complex push = 200.0 * (2e4 + 1e5 / p + 40.0 * p / (1.0 + 2e-4 * p));
        const double complex straight = own * p * p + push - 2e6, across = cross * p * p;
        peak = fmax(peak, cabs(1.0 - push * straight / (straight * straight - across * across)));
    }
    check_within("magnetic-loop", "masses that couple both axes: peak sensitivity", peak, found.peak, 1e-7);
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
}

static double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

static void derivatives(void **unused) {
    (void)unused;
    whirl_setting settings[MAX_SETTINGS];
    memcpy(settings, quadratic, sizeof quadratic);
    settings[9] = (whirl_setting){"max_current", 11.0, NULL};
    settings[10] = (whirl_setting){"sensor_bandwidth", 1e3, NULL};
    settings[11] = (whirl_setting){"fails_after", 2.0, NULL};
    settings[12] = (whirl_setting){"fails_within", 20e-3, NULL};
    whirl_rotor *rotor = make(800.0, 1e-4, 10.0, settings);
    const whirl_system *system = whirl_rotor_system(rotor);
    const size_t n = system->dimension;
    uint64_t seed = 9;
    double worst = 0.0;
    assert_int_equal(n, 4 + 6 + 1);
    for (int trial = 0; trial < 100; trial++) {
        double x[11], exact[121], differences[121], size = 0.0, error = 0.0;
        for (size_t i = 0; i < n; i++) x[i] = uniform(&seed, -0.1, 0.1);
        x[10] = uniform(&seed, 0.7, 0.8);
        exact_jacobian(system, 0.0, x, exact);
        rhs_jacobian(system, 0.0, x, 1e-3, differences);
        for (size_t i = 0; i < n * n; i++) {
            size = fmax(size, fabs(exact[i]));
            error = fmax(error, fabs(exact[i] - differences[i]));
        }
        worst = fmax(worst, error / size);
    }
    check_within("magnetic-loop", "largest difference of the derivative from differences, over its largest entry", 0.0,
                 worst, 1e-6);
    whirl_rotor_free(rotor);
}

// ---------------------------------------------------------------- failing

/// Without currents no force acts: the mass continues at its velocity.
static void failing(void **unused) {
    (void)unused;
    whirl_setting settings[MAX_SETTINGS];
    memcpy(settings, quadratic, sizeof quadratic);
    settings[9] = (whirl_setting){"fails_after", 3.0, NULL};
    settings[10] = (whirl_setting){"fails_within", 1e-4, NULL};
    whirl_rotor *rotors[2] = {make(800.0, 1e-4, 10.0, settings), make(800.0, 1e-4, 10.0, quadratic)};
    whirl_integrator *integrators[2];
    double state[2][9] = {{0.2, -0.1, 0.3, 0.1}, {0.2, -0.1, 0.3, 0.1}}, before = 0.0, last[4];
    for (int i = 0; i < 2; i++) integrators[i] = make_integrator(whirl_rotor_system(rotors[i]), "dop853", 64);
    for (int turn = 0; turn < 3; turn++) {
        for (int i = 0; i < 2; i++) revolve(integrators[i], state[i], 1);
        for (int i = 0; i < 8; i++) before = fmax(before, fabs(state[0][i] - state[1][i]));
    }
    check_within("magnetic-failure", "before: largest difference from a bearing that does not fail", 0.0, before,
                 1e-10);
    revolve(integrators[0], state[0], 1);
    memcpy(last, state[0], sizeof last);
    revolve(integrators[0], state[0], 1);
    for (int i = 0; i < 2; i++) {
        check_within("magnetic-failure", words("after: velocity along %c a revolution later", i ? 'y' : 'x'),
                     last[2 + i], state[0][2 + i], 1e-12);
        check_within("magnetic-failure", words("after: way along %c in that revolution", i ? 'y' : 'x'),
                     two_pi * last[2 + i], state[0][i] - last[i], 1e-11);
    }
    for (int i = 0; i < 2; i++) {
        whirl_integrator_free(integrators[i]);
        whirl_rotor_free(rotors[i]);
    }
}

// ---------------------------------------------------------------- a drop onto a retainer

/// A rotor of 10 kg at 300 rad/s under its weight that falls into a retainer, rough and lossy; SI.
static const struct {
    double mass, speed, eccentricity, gap, stiffness, loss, friction, slip, radius, g;
} drop = {10.0, 300.0, 10e-6, 2e-4, 3e9, 0.3, 0.15, 0.05, 0.04, 9.80665};

static void fall(double t, const double x[4], double out[4]) {
    const double r = hypot(x[0], x[1]), depth = r - drop.gap, m = drop.mass;
    const double push = drop.mass * drop.eccentricity * drop.speed * drop.speed;
    double force[2] = {push * cos(drop.speed * t), push * sin(drop.speed * t) - m * drop.g};
    if (depth > 0.0) {
        const double n[2] = {x[0] / r, x[1] / r}, in = n[0] * x[2] + n[1] * x[3];
        const double normal = drop.stiffness * pow(depth, 1.5) * fmax(0.0, 1.0 + drop.loss * in);
        const double slip = drop.radius * drop.speed + n[0] * x[3] - n[1] * x[2];
        const double f = drop.friction * slip / hypot(slip, drop.slip);
        force[0] -= normal * (n[0] - f * n[1]);
        force[1] -= normal * (n[1] + f * n[0]);
    }
    memcpy(out, (double[]){x[2], x[3], force[0] / m, force[1] / m}, 4 * sizeof *out);
}

/// Carries the state over `time` by Runge and Kutta's method in many steps.
static void fall_for(double time, double x[4]) {
    enum { STEPS = 2000000 };
    const double h = time / STEPS;
    for (int k = 0; k < STEPS; k++) {
        static const double shares[4] = {0.0, 0.5, 0.5, 1.0}, weights[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
        double slope[4] = {0.0}, sum[4] = {0.0}, at[4];
        for (int stage = 0; stage < 4; stage++) {
            for (int i = 0; i < 4; i++) at[i] = x[i] + shares[stage] * h * slope[i];
            fall((k + shares[stage]) * h, at, slope);
            for (int i = 0; i < 4; i++) sum[i] += weights[stage] * slope[i];
        }
        for (int i = 0; i < 4; i++) x[i] += h * sum[i];
    }
}

static void dropping(void **unused) {
    (void)unused;
    const double length = 1e-4;
    whirl_setting bearing[MAX_SETTINGS];
    whirl_design *design;
    whirl_rotor *rotor;
    memcpy(bearing, quadratic, sizeof quadratic);
    bearing[9] = (whirl_setting){"fails_after", 20.0, NULL};
    bearing[10] = (whirl_setting){"fails_within", 1e-3, NULL};
    require_ok(whirl_design_new(drop.speed, length, &design));
    const whirl_setting mass[] = {{"mass", drop.mass, NULL}, {"eccentricity", drop.eccentricity, NULL}};
    require_ok(whirl_design_station(design, "mass", mass, 2));
    require_ok(whirl_design_element(design, "magnetic", bearing, 11));
    const whirl_setting retainer[] = {{"at", 0.0, "mass"},
                                      {"gap", drop.gap, NULL},
                                      {"stiffness", drop.stiffness, NULL},
                                      {"law", 0.0, "hunt_crossley"},
                                      {"loss", drop.loss, NULL},
                                      {"friction", drop.friction, NULL},
                                      {"slip_speed", drop.slip, NULL},
                                      {"radius", drop.radius, NULL}};
    require_ok(whirl_design_element(design, "contact", retainer, 8));
    require_ok(whirl_design_element(design, "gravity", (whirl_setting[]){{"acceleration", drop.g, NULL}}, 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    whirl_integrator *integrator = make_integrator(whirl_rotor_system(rotor), "dop853", 64);
    double state[9] = {0.0}, theirs[4], worst = 0.0, deepest = 0.0;
    revolve(integrator, state, 20);
    check_within("magnetic-failure", "before the drop: largest displacement over the retainer's gap", 0.0,
                 hypot(state[0], state[1]) * length / drop.gap, 0.5);
    revolve(integrator, state, 1);
    for (int i = 0; i < 4; i++) theirs[i] = state[i] * length * (i < 2 ? 1.0 : drop.speed);
    for (int turn = 0; turn < 4; turn++) {
        revolve(integrator, state, 1);
        fall_for(two_pi / drop.speed, theirs);
        for (int i = 0; i < 2; i++) worst = fmax(worst, fabs(state[i] * length - theirs[i]) / drop.gap);
        deepest = fmax(deepest, hypot(theirs[0], theirs[1]) / drop.gap);
    }
    check_within("magnetic-failure", "the drop, four revolutions with bounces, from Runge-Kutta, over the gap", 0.0,
                 worst, 1e-6);
    check_holds("magnetic-failure", "it has come to the retainer", deepest > 0.9);
    whirl_integrator_free(integrator);
    whirl_rotor_free(rotor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces),         cmocka_unit_test(poles),       cmocka_unit_test(transfer_functions),
        cmocka_unit_test(coupled_masses), cmocka_unit_test(derivatives), cmocka_unit_test(failing),
        cmocka_unit_test(dropping)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
