// Data sets: what must not change in their signals, and the lines of bearings with dents.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/case.h"
#include "whirl/engine/study.h"

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 4096 };

static const double two_pi = 6.283185307179586476925;

static whirl_result *run(const char *text) {
    char problems[SIZE];
    whirl_case *object = NULL;
    whirl_study study;
    whirl_result *result = NULL;
    if (whirl_case_check(text, strlen(text), "records.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
        fail_msg("%s", problems);
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    const whirl_status status = whirl_study_run(&study, &(whirl_run_options){.threads = 2}, &result);
    assert_string_equal(status.message, "");
    whirl_case_free(object);
    return result;
}

/// Returns the signal of a channel in a record.
static const float *signal_of(const whirl_result *result, size_t record, size_t channel, size_t *samples) {
    const whirl_table *table = &result->tables[0];
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_DATASET_SIGNALS);
    assert_non_null(field);
    *samples = field->singles;
    const double *block = whirl_table_block(table, record);
    return (const float *)(block + field->offset) + channel * field->singles;
}

// ---------------------------------------------------------------- invariances

/// Runs a rotor that rubs, with a length scale, a rotation, a place of the unbalance, and a method.
static whirl_result *rubbing(const char *scale, const char *rotation, const char *angle, const char *integrate) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {omega: 1 rad/s, e: 0.3 m, gap: 9 m}\nrotor:\n  speed: = omega\n"
             "  length_scale: %s\n  rotation: %s\n  stations:\n"
             "    disc: {mass: 1 kg, damping: 0.2 N s/m, eccentricity: = e, eccentricity_angle: %s}\n  elements:\n"
             "    - shaft: {between: [disc, ground], k1: 1 N/m}\n"
             "    - rub: {at: disc, gap: = gap, stiffness: 10 N/m, friction: 0.05}\n    - gravity: 0.1 m/s2\n"
             "study:\n  dataset:\n    machines: 3\n    samples_per_revolution: 32\n    revolutions: 20\n"
             "    conditions: {omega: {from: 0.7, to: 1.1}}\n"
             "    labels: {healthy: , rub: {grade: {gap: {from: 0.8 m, to: 0.4 m}}}}\n    channels:\n"
             "      - {sensor: proximity, at: disc}\n      - {sensor: proximity, at: disc, angle: 90 deg}\n"
             "      - {sensor: velocity, at: disc}\n      - {sensor: accelerometer, at: disc, angle: 90 deg}\n"
             "      - {sensor: keyphasor}\n  integrate: {%s, transient: 200}\n  analyze: [orbit, rub, regime]\n",
             scale, rotation, angle, integrate);
    return run(text);
}

/// Returns the largest difference of all signals over their largest size; `signs`: of each channel in the other data
/// set.
static double difference(const whirl_result *one, const whirl_result *other, const double signs[5]) {
    double worst = 0.0;
    for (size_t record = 0; record < 6; record++)
        for (size_t channel = 0; channel < 5; channel++) {
            size_t samples;
            const float *a = signal_of(one, record, channel, &samples),
                        *b = signal_of(other, record, channel, &samples);
            double most = 0.0, largest = 0.0;
            for (size_t k = 0; k < samples; k++) {
                most = fmax(most, fabs((double)a[k] - signs[channel] * (double)b[k]));
                largest = fmax(largest, fabs((double)a[k]));
            }
            worst = fmax(worst, most / fmax(largest, 1e-300));
        }
    return worst;
}

static void invariances(void **unused) {
    static const char fine[] = "method: dop853, rtol: 1e-11, atol: 1e-12";
    static const double same[] = {1.0, 1.0, 1.0, 1.0, 1.0}, mirrored[] = {-1.0, 1.0, -1.0, 1.0, 1.0};
    (void)unused;
    whirl_result *base = rubbing("1 m", "counter-clockwise", "0 deg", fine);
    whirl_result *scaled = rubbing("37 cm", "counter-clockwise", "0 deg", fine);
    whirl_result *clockwise = rubbing("1 m", "clockwise", "180 deg", fine);
    whirl_result *other = rubbing("1 m", "counter-clockwise", "0 deg", "method: rodas5p, rtol: 1e-11, atol: 1e-12");
    check_within("data sets", "signals in another length scale, largest difference", 0.0,
                 difference(base, scaled, same), 1e-6);
    check_within("data sets", "signals of the machine in the mirror", 0.0, difference(base, clockwise, mirrored), 1e-6);
    check_within("data sets", "signals by another method", 0.0, difference(base, other, same), 1e-6);
    whirl_result_free(base);
    whirl_result_free(scaled);
    whirl_result_free(clockwise);
    whirl_result_free(other);
}

// ---------------------------------------------------------------- a bearing with dents

enum { TURNS = 60, PER_TURN = 64, DENT_OUTER = 0, DENT_INNER, DENT_BALL };

/// Returns the order of the strongest line of a record's first channel within `reach` of an order, to 1e-3.
static double strongest(const whirl_result *result, size_t record, double order, double reach) {
    size_t samples;
    const float *x = signal_of(result, record, 0, &samples);
    double most = 0.0, at = NAN, mean = 0.0;
    for (size_t k = 0; k < samples; k++) mean += x[k] / (double)samples;
    for (int i = 0; i <= (int)(2000.0 * reach); i++) {
        const double own = order - reach + 1e-3 * i;
        const double complex step = cexp(-I * two_pi * own / PER_TURN);
        double complex sum = 0.0, turn = 1.0;
        for (size_t k = 0; k < samples; k++, turn *= step)
            sum += (x[k] - mean) * (1.0 - cos(two_pi * ((double)k + 0.5) / (double)samples)) * turn;
        if (cabs(sum) > most) most = cabs(sum), at = own;
    }
    return at;
}

/// A rolling bearing and the digits of its kinematics without slip, over the speed of the shaft.
typedef struct known_bearing {
    const char *name;
    int balls;
    double ball, circle;             ///< in, diameters of a ball and of the circle of their centres
    double cage, outer, inner, spin; ///< FTF, BPFO, BPFI, BSF
} known_bearing;

static whirl_result *dented(const known_bearing *own, double slip) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\nparameters: {outer: 0 um, inner: 0 um, ball: 0 um}\nrotor:\n  speed: 1797 rpm\n"
             "  length_scale: 1 um\n  stations:\n    rotor: {mass: 15 kg}\n  elements:\n    - ball_bearing:\n"
             "        at: rotor\n        balls: %d\n        stiffness: 8.5e9\n        clearance: 2 um\n"
             "        inner: %.9f mm\n        outer: %.9f mm\n        slip: %.9f\n        damping: 400 N.s/m\n"
             "        outer_dent: = outer\n        outer_dent_width: 6 deg\n        outer_dent_angle: -90 deg\n"
             "        inner_dent: = inner\n        inner_dent_width: 6 deg\n        ball_dent: = ball\n"
             "        ball_dent_width: 12 deg\n    - gravity: 9.80665 m/s2\nstudy:\n  dataset:\n    machines: 1\n"
             "    samples_per_revolution: %d\n    revolutions: %d\n    labels:\n"
             "      outer: {grade: {outer: {from: 4 um, to: 4.1 um}}}\n"
             "      inner: {grade: {inner: {from: 4 um, to: 4.1 um}}}\n"
             "      ball: {grade: {ball: {from: 4 um, to: 4.1 um}}}\n"
             "    channels: [{sensor: accelerometer, at: rotor, angle: 90 deg}]\n  initial: {rotor: {y: -6}}\n"
             "  integrate: {method: rk4, steps_per_revolution: 2048, transient: 30}\n  analyze: [orbit, regime]\n",
             own->balls, 12.7 * (own->circle - own->ball), 12.7 * (own->circle + own->ball), slip, PER_TURN, TURNS);
    return run(text);
}

/// Dents show at the frequencies with which they are passed, less the slip of the cage and of the balls' spin. A dent
/// of a ball meets a race twice in a turn of the ball, and more deeply where the bearing carries its load: lines stand
/// at multiples of twice its spin, with neighbours at the distance of the cage's speed.
static void dents(void **unused) {
    static const known_bearing bearings[] = {
        {"6205", 9, 0.3126, 1.537, 0.3983083930, 3.5847755368, 5.4152244632, 2.3567217007},
        {"6203", 8, 0.2656, 1.122, 0.3816399287, 3.0531194296, 4.9468805704, 1.9938387239}};
    const double slip = 0.015, rolls = 1.0 - slip;
    (void)unused;
    for (size_t b = 0; b < sizeof bearings / sizeof *bearings; b++) {
        const known_bearing *own = &bearings[b];
        whirl_result *result = dented(own, slip);
        check_within("data sets", words("%s: BPFO and BPFI make up the passing balls", own->name), own->balls,
                     own->outer + own->inner, 1e-9);
        for (int k = 1; k <= 4; k++) {
            const double order = k * rolls * own->outer;
            check_within("data sets", words("%s, dent of the outer race: line at %d BPFO, order", own->name, k), order,
                         strongest(result, DENT_OUTER, order, 0.3), 2e-3);
        }
        for (int k = 1; k <= 3; k++) {
            const double order = k * (own->balls - rolls * own->outer);
            check_within("data sets", words("%s, dent of the inner race: line at %d BPFI, order", own->name, k), order,
                         strongest(result, DENT_INNER, order, 0.3), 2e-3);
        }
        for (int k = 1; k <= 3; k++)
            for (int side = -1; side <= 1; side++) {
                const double order = rolls * (2 * k * own->spin + side * own->cage);
                check_within("data sets",
                             words("%s, dent of a ball: line at %d BSF %+d FTF, order", own->name, 2 * k, side), order,
                             strongest(result, DENT_BALL, order, 0.15), 2e-3);
            }
        whirl_result_free(result);
    }
}

// ---------------------------------------------------------------- runs

/// Returns the number of a field of a record.
static double number_of(const whirl_result *result, size_t record, const char *name) {
    const whirl_table *table = &result->tables[0];
    const whirl_field *field = whirl_layout_field(&table->layout, name);
    assert_non_null(field);
    return whirl_table_block(table, record)[field->offset];
}

/// Runs a light rotor at a constant rate from 20 to 90 rad/s, or down.
static whirl_result *at_rate(const char *from, const char *to) {
    char text[SIZE];
    snprintf(
        text, sizeof text,
        "whirl: 1\nparameters: {rate: 8 rad/s2}\nrotor:\n  speed: 50 rad/s\n  length_scale: 1 mm\n  stations:\n"
        "    disc: {mass: 1 kg, damping: 20 N s/m, eccentricity: 0.1 mm}\n  elements:\n"
        "    - spring: {between: [disc, ground], stiffness: 2500 N/m}\nstudy:\n  dataset:\n    machines: 3\n"
        "    rate: 1 kHz\n    samples: 6000\n    conditions: {rate: {from: 6, to: 10}}\n"
        "    runup: {speed_from: %s, speed_to: %s, rate: = rate, settle: 20, rtol: 1e-11}\n    labels: {healthy: }\n"
        "    channels:\n      - {sensor: proximity, at: disc}\n      - {sensor: keyphasor, width: 60 deg}\n",
        from, to);
    return run(text);
}

/// The pulses of a keyphasor at a constant rate a begin where the angle v t + a t^2/2 + b is a whole number of
/// revolutions less half a width: their edges divide the angles of samples at the closed form's instants.
static void pulses(const char *from, const char *to, double sign) {
    whirl_result *result = at_rate(from, to);
    double worst = 0.0;
    size_t edges = 0, samples;
    for (size_t record = 0; record < 3; record++) {
        const float *x = signal_of(result, record, 1, &samples);
        const double v = number_of(result, record, WHIRL_FIELD_DATASET_SPEED), h = 1e-3;
        const double a = number_of(result, record, WHIRL_FIELD_DATASET_RATE);
        const double b = number_of(result, record, WHIRL_FIELD_DATASET_BEGIN);
        assert_true(a * sign > 0.0);
        for (double turn = 1.0;; turn += 1.0) {
            const double angle = two_pi * (turn - b - 1.0 / 12.0), root = v * v + 2.0 * a * angle;
            const double at = root > 0.0 ? 2.0 * angle / (v + sqrt(root)) : INFINITY;
            const double place = at / h + 0.5;
            if (!(place < (double)samples - 1.0)) break;
            // The sample with the edge has the share of its angle that lies behind the edge.
            const size_t k = (size_t)place;
            const double low = ((double)k - 0.5) * h, high = low + h;
            const double share = 1.0 - ((v + 0.5 * a * at) * at - (v + 0.5 * a * low) * low) /
                                           ((v + 0.5 * a * high) * high - (v + 0.5 * a * low) * low);
            worst = fmax(worst, fabs(share - (double)x[k]));
            edges++;
        }
    }
    assert_true(edges > 100);
    check_within(
        "data sets",
        words("keyphasor, %s at constant rates: edges of pulses, largest difference", sign > 0.0 ? "up" : "down"), 0.0,
        worst, 1e-6);
    whirl_result_free(result);
}

static void pulses_of_runs(void **unused) {
    (void)unused;
    pulses("20 rad/s", "90 rad/s", 1.0);
    pulses("90 rad/s", "20 rad/s", -1.0);
}

/// A linear rotor at a constant rate: Duhamel's integral of its unbalance, by Simpson's rule, from a beginning so long
/// before the first sample that all else has decayed.
static void displacements_of_runs(void **unused) {
    enum { PER_SAMPLE = 8, BEFORE = 1500 };
    const double h = 1e-3 / PER_SAMPLE, decay = 10.0, natural = sqrt(2500.0 - decay * decay), e = 1e-4;
    double worst = 0.0, largest = 0.0;
    size_t samples;
    (void)unused;
    whirl_result *result = at_rate("20 rad/s", "90 rad/s");
    const float *x = signal_of(result, 0, 0, &samples);
    const double v = number_of(result, 0, WHIRL_FIELD_DATASET_SPEED),
                 a = number_of(result, 0, WHIRL_FIELD_DATASET_RATE);
    const double b = two_pi * number_of(result, 0, WHIRL_FIELD_DATASET_BEGIN);
    // q = integral of exp(-p (t - s)) f(s) ds with p = decay - i natural, from step to step; x = Im q / natural.
    const double complex p = decay - I * natural, step = cexp(-p * h), half = cexp(-0.5 * p * h);
    double complex q = 0.0;
    for (long k = -(long)BEFORE * PER_SAMPLE; k < (long)(samples - 1) * PER_SAMPLE; k++) {
        double f[3];
        for (int i = 0; i < 3; i++) {
            const double t = ((double)k + 0.5 * i) * h, rate = t < 0.0 || (t == 0.0 && i == 2) ? 0.0 : a;
            const double angle = b + v * t + 0.5 * rate * t * t, speed = v + rate * t;
            f[i] = e * (speed * speed * cos(angle) + rate * sin(angle));
        }
        q = step * q + h / 6.0 * (step * f[0] + 4.0 * half * f[1] + f[2]);
        if (k + 1 < 0 || (k + 1) % PER_SAMPLE != 0) continue;
        const double exact = cimag(q) / natural;
        largest = fmax(largest, fabs(exact));
        worst = fmax(worst, fabs(exact - (double)x[(k + 1) / PER_SAMPLE]));
    }
    // The antialias filter is flat to 1e-4.
    check_within("data sets", "linear rotor through its critical speed: displacement, largest difference", 0.0,
                 worst / largest, 1e-4);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(invariances), cmocka_unit_test(dents),
                                       cmocka_unit_test(pulses_of_runs), cmocka_unit_test(displacements_of_runs)};
    return cmocka_run_group_tests_name("data sets", tests, NULL, NULL);
}
