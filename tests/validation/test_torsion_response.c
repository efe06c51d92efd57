// Response of trains to harmonic torques, against closed forms and a dense complex system of its own.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_dense.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/result.h"

enum { SIZE = 4096, MAX_DEGREES = 8 };

static const double two_pi = 6.283185307179586476925, pi = 3.14159265358979323846;

/// Computes the response of a machine: `parts` is the text after its length scale.
static whirl_result *response_of(const char *speed, const char *scale, const char *parts, const char *study) {
    char text[SIZE + 512];
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {n: %s}\nrotor:\n  speed: = n\n  length_scale: %s\n%sstudy:\n  torsion: {%s}\n",
             speed, scale, parts, study);
    return result_of_text(text);
}

static double number_of(const whirl_result *result, const char *field, size_t which, size_t i) {
    return whirl_table_field(&result->tables[0], 0, field, which)[i];
}

/// Checks an amplitude and the lag behind phase 0 of its excitation.
static void check_amplitude(const char *what, double complex known, double size, double lag) {
    check_within("Torsion", what, cabs(known), size, 1e-10 * cabs(known));
    const double apart = remainder(lag + carg(known) * 360.0 / two_pi, 360.0);
    check_within("Torsion", words("%s: lag, degrees", what), 0.0, apart, 1e-8);
}

/// Joins two of the angles by stiffness and damping.
static void join(double complex a[MAX_DEGREES][MAX_DEGREES], size_t i, size_t j, double complex by) {
    a[i][i] += by;
    a[j][j] += by;
    a[i][j] -= by;
    a[j][i] -= by;
}

// ---------------------------------------------------------------- closed forms

static const char *const discs =
    "  stations:\n"
    "    one: {polar: 3 kg.m2, moves: twist}\n"
    "    two: {polar: 5 kg.m2, moves: twist}\n"
    "  elements:\n"
    "    - coupling: {between: [one, two], twist: 2e5 N.m/rad, twist_damping: 40 N.m.s/rad, diameter: 60 mm, "
    "inner: 20 mm}\n"
    "    - pulsation: {at: one, orders: 2, amplitudes: 100 N.m, phases: 30 deg, steady: 500 N.m}\n"
    "    - pulsation: {at: two, frequencies: [50 Hz], shares: [0.02], rated: 1000 N.m, steady: -500 N.m}\n";

/// Two discs: the twist of the shaft is T/J1/(w0^2 - w^2 + i w c/m), m = J1 J2/(J1 + J2), its torque k + i w c times
/// that.
static void two_discs(void **state) {
    const double k = 2e5, c = 40.0, one = 3.0, two = 5.0, m = one * two / (one + two);
    const double wp = pi / 16.0 * (pow(0.06, 4) - pow(0.02, 4)) / 0.06;
    static const char *const speeds[] = {"900 rpm", "2500 rpm", "2606 rpm"};
    (void)state;
    for (size_t s = 0; s < 3; s++) {
        whirl_result *result = response_of(speeds[s], "1 mm", discs, "");
        const double n = strtod(speeds[s], NULL) * two_pi / 60.0, w[2] = {2.0 * n, 100.0 * pi};
        const double complex drive[2] = {100.0 / one * cexp(I * pi / 6.0), -20.0 / two};
        double sum = 0.0, power = 0.0;
        for (size_t i = 0; i < 2; i++) {
            const double complex twist = drive[i] / (k / m - w[i] * w[i] + I * w[i] * c / m);
            check_amplitude(words("two discs at %s, torque by excitation %zu", speeds[s], i),
                            (k + I * w[i] * c) * twist, number_of(result, WHIRL_FIELD_TORSION_TORQUE, 0, i),
                            number_of(result, WHIRL_FIELD_TORSION_TORQUE_LAG, 0, i));
            sum += cabs((k + I * w[i] * c) * twist);
            power += 0.5 * c * pow(w[i] * cabs(twist), 2.0);
            check_within("Torsion", "frequency of an excitation, rad/s", w[i],
                         number_of(result, WHIRL_FIELD_TORSION_FREQUENCY, 0, i), 1e-12 * w[i]);
        }
        check_within("Torsion", "sum over all excitations, N m", sum,
                     number_of(result, WHIRL_FIELD_TORSION_TORQUE_SUM, 0, 0), 1e-10 * sum);
        check_within("Torsion", "shear stress, Pa", sum / wp, number_of(result, WHIRL_FIELD_TORSION_STRESS, 0, 0),
                     1e-10 * sum / wp);
        check_within("Torsion", "power of the damping, W", power, number_of(result, WHIRL_FIELD_TORSION_POWER, 0, 0),
                     1e-9 * power);
        check_within("Torsion", "steady torque, N m", 500.0, number_of(result, WHIRL_FIELD_TORSION_STEADY, 0, 0), 1e-8);
        whirl_result_free(result);
    }
}

/// Steady torques without balance are reported, and those of shafts are missing; a drive balances them.
static void steady_torques(void **state) {
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text, "%s    - pulsation: {at: two, steady: 120 N.m}\n", discs);
    whirl_result *result = response_of("900 rpm", "1 mm", text, "");
    check_within("Torsion", "steady torque that nothing takes up, N m", 120.0,
                 number_of(result, WHIRL_FIELD_TORSION_UNBALANCED, 0, 0), 1e-9);
    check_holds("Torsion", "steady torques of shafts are missing then",
                isnan(number_of(result, WHIRL_FIELD_TORSION_STEADY, 0, 0)));
    whirl_result_free(result);
    snprintf(text, sizeof text, "%s    - pulsation: {at: two, steady: 120 N.m}\n    - drive: {at: one}\n", discs);
    result = response_of("900 rpm", "1 mm", text, "");
    check_within("Torsion", "steady torque with a drive, N m", 380.0,
                 number_of(result, WHIRL_FIELD_TORSION_STEADY, 0, 0), 1e-8);
    whirl_result_free(result);
}

/// A uniform shaft of finite elements between equal and opposite steady torques: the torque and the stress of each
/// piece.
static void stress_of_a_shaft(void **state) {
    (void)state;
    whirl_result *result =
        response_of("900 rpm", "1 mm",
                    "  shafts: {s: {twist: yes, reduce: no}}\n"
                    "  stations: {left: {moves: all}, right: {moves: all}}\n"
                    "  elements:\n"
                    "    - segment: {from: left, to: right, length: 900 mm, outer: 60 mm, inner: 20 mm, elements: 3}\n"
                    "    - spring: {between: [left, ground], stiffness: 1e7}\n"
                    "    - spring: {between: [right, ground], stiffness: 1e7}\n"
                    "    - pulsation: {at: left, frequencies: 1 mHz, amplitudes: 40 N.m, steady: 40 N.m}\n"
                    "    - pulsation: {at: right, frequencies: 1 mHz, amplitudes: -40 N.m, steady: -40 N.m}\n",
                    "");
    const double stress = 40.0 * 16.0 / (pi * pow(0.06, 3) * (1.0 - pow(1.0 / 3.0, 4)));
    for (size_t k = 0; k < 3; k++) {
        check_within("Torsion", words("shaft, piece %zu: steady torque, N m", k), 40.0,
                     number_of(result, WHIRL_FIELD_TORSION_STEADY, 0, k), 1e-6);
        check_within("Torsion", words("shaft, piece %zu: stress, Pa", k), stress,
                     number_of(result, WHIRL_FIELD_TORSION_STRESS, 0, k), 1e-6 * stress);
    }
    whirl_result_free(result);
}

// ---------------------------------------------------------------- trains

static const char *const train =
    "  stations:\n"
    "    motor: {polar: 211 kg.m2, moves: twist}\n"
    "    wheel: {polar: 8.3 kg.m2, moves: twist}\n"
    "    pinion: {polar: 0.35 kg.m2, moves: twist}\n"
    "    load: {polar: 2.6 kg.m2, moves: twist}\n"
    "  elements:\n"
    "    - coupling: {between: [motor, wheel], twist: 9.8e6 N.m/rad, twist_damping: 2e3 N.m.s/rad}\n"
    "%s"
    "    - spring: {between: [pinion, load], along: twist, stiffness: 4.1e5, damping: 80}\n"
    "    - spring: {between: [load, ground], along: twist, damping: 3}\n"
    "    - pulsation: {at: motor, orders: [3, 1], amplitudes: [90 N.m, 40 N.m], phases: [0.4, 0]}\n"
    "    - pulsation: {at: load, orders: 1, amplitudes: 50 N.m, phases: -1.1}\n"
    "    - pulsation: {at: pinion, speeds: [10 rad/s, 4500 rpm, 700 rad/s], orders: [2, 9], "
    "amplitudes: [[1 N.m, 2 N.m, 3 N.m], [4 N.m, 7 N.m, 9 N.m]]}\n";

/// Writes the torques about z of excitation i (3X, 1X, 6X, 27X) on the four stations at 1500 rpm; gears turn against
/// each other.
static void train_torques(size_t i, double complex out[4]) {
    static const double complex none = 0.0;
    const double complex all[4][4] = {{90.0 * cexp(0.4 * I), none, none, -50.0 * cexp(-1.1 * I)},
                                      {40.0, none, none, none},
                                      {none, none, -2.0, none},
                                      {none, none, -7.0, none}};
    memcpy(out, all[i], sizeof all[i]);
}

/// Two equal excitations at two stations add up with their phases; the gear is a constraint with a multiplier here.
static void geared_train(void **state) {
    static const double orders[4] = {3.0, 1.0, 6.0, 27.0}, inertia[4] = {211.0, 8.3, 0.35, 2.6};
    const double n = 1500.0 * two_pi / 60.0;
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text, train, "    - gear: {between: [wheel, pinion], base_radii: [300 mm, 100 mm]}\n");
    whirl_result *result = response_of("1500 rpm", "1 mm", text, "");
    for (size_t i = 0; i < 4; i++) {
        const double w = orders[i] * n;
        double complex a[MAX_DEGREES][MAX_DEGREES] = {{0}}, x[MAX_DEGREES] = {0};
        check_within("Torsion", "order of an excitation", orders[i], number_of(result, WHIRL_FIELD_TORSION_ORDER, 0, i),
                     1e-12);
        for (size_t s = 0; s < 4; s++) a[s][s] = -w * w * inertia[s];
        join(a, 0, 1, 9.8e6 + 2e3 * I * w);
        join(a, 2, 3, 4.1e5 + 80.0 * I * w);
        a[3][3] += 3.0 * I * w;
        a[1][4] = a[4][1] = 0.3;
        a[2][4] = a[4][2] = 0.1;
        train_torques(i, x);
        solve_dense(5, MAX_DEGREES, &a[0][0], x);
        check_amplitude(words("train, %gX: motor to wheel", orders[i]), (9.8e6 + 2e3 * I * w) * (x[0] - x[1]),
                        number_of(result, WHIRL_FIELD_TORSION_TORQUE, 0, i),
                        number_of(result, WHIRL_FIELD_TORSION_TORQUE_LAG, 0, i));
        check_amplitude(words("train, %gX: pinion to load", orders[i]), -(4.1e5 + 80.0 * I * w) * (x[2] - x[3]),
                        number_of(result, WHIRL_FIELD_TORSION_TORQUE, 0, 4 + i),
                        number_of(result, WHIRL_FIELD_TORSION_TORQUE_LAG, 0, 4 + i));
        check_amplitude(words("train, %gX: gear, on the wheel", orders[i]), 0.3 * x[4],
                        number_of(result, WHIRL_FIELD_TORSION_TORQUE, 0, 8 + i),
                        number_of(result, WHIRL_FIELD_TORSION_TORQUE_LAG, 0, 8 + i));
        for (size_t s = 0; s < 4; s++)
            check_within("Torsion", words("train, %gX: twist of station %zu", orders[i], s), cabs(x[s]),
                         number_of(result, WHIRL_FIELD_TORSION_ANGLE, s, i), 1e-10 * cabs(x[s]));
    }
    whirl_result_free(result);
}

/// The same train on one shaft: inertias, stiffnesses and torques of the fast shaft referred by the square of the ratio
/// and the ratio.
static void referred_train(void **state) {
    char text[SIZE];
    (void)state;
    snprintf(text, sizeof text, train, "    - gear: {between: [wheel, pinion], base_radii: [300 mm, 100 mm]}\n");
    whirl_result *geared = response_of("1500 rpm", "1 mm", text, "");
    whirl_result *referred =
        response_of("1500 rpm", "1 mm",
                    "  stations:\n"
                    "    motor: {polar: 211 kg.m2, moves: twist}\n"
                    "    gears: {polar: 11.45 kg.m2, moves: twist}\n"
                    "    load: {polar: 23.4 kg.m2, moves: twist}\n"
                    "  elements:\n"
                    "    - coupling: {between: [motor, gears], twist: 9.8e6 N.m/rad, twist_damping: 2e3 N.m.s/rad}\n"
                    "    - coupling: {between: [gears, load], twist: 3.69e6 N.m/rad, twist_damping: 720 N.m.s/rad}\n"
                    "    - spring: {between: [load, ground], along: twist, damping: 27}\n"
                    "    - pulsation: {at: motor, orders: [3, 1], amplitudes: [90 N.m, 40 N.m], phases: [0.4, 0]}\n"
                    "    - pulsation: {at: load, orders: 3, amplitudes: 150 N.m, phases: -1.1}\n",
                    "");
    for (size_t i = 0; i < 2; i++) {
        const double slow = number_of(referred, WHIRL_FIELD_TORSION_TORQUE, 0, i);
        const double fast = number_of(referred, WHIRL_FIELD_TORSION_TORQUE, 0, 2 + i);
        check_within("Torsion", "referred train: slow shaft, N m", slow,
                     number_of(geared, WHIRL_FIELD_TORSION_TORQUE, 0, i), 1e-10 * slow);
        check_within("Torsion", "referred train: fast shaft, N m", fast / 3.0,
                     number_of(geared, WHIRL_FIELD_TORSION_TORQUE, 0, 4 + i), 1e-10 * fast);
        check_within("Torsion", "referred train: twist of the load",
                     3.0 * number_of(referred, WHIRL_FIELD_TORSION_ANGLE, 2, i),
                     number_of(geared, WHIRL_FIELD_TORSION_ANGLE, 3, i), 1e-12);
    }
    whirl_result_free(geared);
    whirl_result_free(referred);
}

/// A mesh with stiffness, damping and an error, which excites at the order of its teeth, against two angles and the
/// sum k (r1 th1 + r2 th2 - e).
static void mesh_with_error(void **state) {
    const double n = 40.0, w = 23.0 * n, r[2] = {0.08, 0.2}, e = 5e-6, phi = 0.6;
    const double complex k = 2.5e8 + 300.0 * I * w, shaft = 2e4 + 5.0 * I * w, error = e * cexp(I * phi);
    double complex a[MAX_DEGREES][MAX_DEGREES] = {{0}}, x[MAX_DEGREES] = {0};
    (void)state;
    whirl_result *result = response_of(
        "40 rad/s", "1 mm",
        "  stations:\n"
        "    drive: {polar: 0.8 kg.m2, moves: twist}\n"
        "    one: {polar: 0.05 kg.m2, moves: twist}\n"
        "    two: {polar: 0.4 kg.m2, moves: twist}\n"
        "  elements:\n"
        "    - coupling: {between: [drive, one], twist: 2e4 N.m/rad, twist_damping: 5 N.m.s/rad}\n"
        "    - gear: {between: [one, two], base_radii: [80 mm, 200 mm], stiffness: 2.5e8 N/m, damping: 300 N.s/m, "
        "teeth: 23, error: 5 um, error_angle: 0.6}\n",
        "");
    a[0][0] = -w * w * 0.8;
    a[1][1] = -w * w * 0.05 + k * r[0] * r[0];
    a[2][2] = -w * w * 0.4 + k * r[1] * r[1];
    a[1][2] = a[2][1] = k * r[0] * r[1];
    join(a, 0, 1, shaft);
    x[1] = k * r[0] * error;
    x[2] = k * r[1] * error;
    solve_dense(3, MAX_DEGREES, &a[0][0], x);
    check_within("Torsion", "order of the mesh", 23.0, number_of(result, WHIRL_FIELD_TORSION_ORDER, 0, 0), 1e-12);
    check_amplitude("mesh with an error: shaft", shaft * (x[0] - x[1]),
                    number_of(result, WHIRL_FIELD_TORSION_TORQUE, 0, 0),
                    number_of(result, WHIRL_FIELD_TORSION_TORQUE_LAG, 0, 0));
    check_amplitude("mesh with an error: torque on the first gear", k * r[0] * (r[0] * x[1] + r[1] * x[2] - error),
                    number_of(result, WHIRL_FIELD_TORSION_TORQUE, 0, 1),
                    number_of(result, WHIRL_FIELD_TORSION_TORQUE_LAG, 0, 1));
    whirl_result_free(result);
}

/// A mesh whose stiffness varies has one mean in the equations and in the torque that it reports: the second gear,
/// which nothing else holds, turns by it.
static void varying_mesh(void **state) {
    static const char *const laws[] = {"variation: 0.3, contact_share: 0.63", "profile: [1.4, 1.1, 0.6, 0.8]"};
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        char text[SIZE];
        snprintf(
            text, sizeof text,
            "  stations:\n"
            "    one: {polar: 0.5 kg.m2, moves: twist}\n"
            "    two: {polar: 2 kg.m2, moves: twist}\n"
            "  elements:\n"
            "    - gear: {between: [one, two], base_radii: [80 mm, 200 mm], stiffness: 3e7 N/m, damping: 900 N.s/m, "
            "teeth: 23, %s}\n"
            "    - pulsation: {at: one, orders: 1, amplitudes: 90 N.m}\n",
            laws[i]);
        whirl_result *result = response_of("3000 rpm", "1 mm", text, "");
        const double w = number_of(result, WHIRL_FIELD_TORSION_FREQUENCY, 0, 0);
        const double known = 2.0 * w * w * number_of(result, WHIRL_FIELD_TORSION_ANGLE, 1, 0) * 80.0 / 200.0;
        check_within("Torsion", words("%s: torque on the first gear", laws[i]), known,
                     number_of(result, WHIRL_FIELD_TORSION_TORQUE, 0, 0), 1e-10 * known);
        whirl_result_free(result);
    }
}

/// Numbers do not depend on the sense of rotation, the length scale, and the order of stations.
static void invariances(void **state) {
    char text[SIZE], turned[SIZE + 32];
    static const char *const fields[] = {WHIRL_FIELD_TORSION_TORQUE, WHIRL_FIELD_TORSION_TORQUE_LAG};
    (void)state;
    snprintf(text, sizeof text, train,
             "    - gear: {between: [wheel, pinion], base_radii: [300 mm, 100 mm], stiffness: 3e8 N/m, damping: 900 "
             "N.s/m, teeth: 61, error: 4 um, error_angle: 1}\n");
    snprintf(turned, sizeof turned, "  rotation: clockwise\n%s", text);
    whirl_result *results[] = {response_of("1500 rpm", "1 mm", text, ""), response_of("1500 rpm", "1 mm", turned, ""),
                               response_of("1500 rpm", "0.3 m", text, "")};
    for (size_t r = 1; r < 3; r++)
        for (size_t f = 0; f < 2; f++)
            for (size_t i = 0; i < 15; i++) {
                const double known = number_of(results[0], fields[f], 0, i);
                check_within("Torsion", words("invariance %zu, %s %zu", r, fields[f], i), known,
                             number_of(results[r], fields[f], 0, i), 1e-9 * fabs(known) + 1e-12);
            }
    for (size_t r = 0; r < 3; r++) whirl_result_free(results[r]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_discs),         cmocka_unit_test(steady_torques),
                                       cmocka_unit_test(stress_of_a_shaft), cmocka_unit_test(geared_train),
                                       cmocka_unit_test(referred_train),    cmocka_unit_test(mesh_with_error),
                                       cmocka_unit_test(varying_mesh),      cmocka_unit_test(invariances)};
    return cmocka_run_group_tests_name("torsion_response", tests, NULL, NULL);
}
