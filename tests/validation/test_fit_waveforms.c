// Fits of displacements over the time in run-ups: a rotor on a spring, against an independent integration of its
// equations by the time, and records of data sets.
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
#include "support_fit.h"
#include "whirl/engine.h"

enum { SAMPLES = 900, PARAMETERS = 6 };

static const double two_pi = 6.283185307179586476925;

// ---------------------------------------------------------------- the independent rotor

/// A disc of 30 kg on a spring: m x'' + c x' + k x = m e (w^2 cos + w' sin), and likewise y. Beyond a gap a stator
/// presses it back, with friction against the rotation. The angle of the shaft is phase + from t + rate t^2 / 2.
typedef struct spun {
    double k, c, e, rate, phase;     ///< N/m, N s/m, m, rad/s2, rad
    double delay;                    ///< s, time of the table at which the run begins
    double from;                     ///< rad/s
    double gap, stiffness, friction; ///< m, N/m (0: no stator), and a coefficient
} spun;

/// Derives the state x, vx, y, vy by the time.
static void spun_slope(const spun *s, double time, const double x[4], double out[4]) {
    const double m = 30.0, w = s->from + s->rate * time, angle = s->phase + time * (s->from + 0.5 * s->rate * time);
    const double square = s->e * w * w, tangent = s->e * s->rate;
    const double radius = hypot(x[0], x[2]), normal = s->stiffness * fmax(radius - s->gap, 0.0);
    const double push = normal > 0.0 ? normal / radius / m : 0.0, pull = s->friction * push;
    out[0] = x[1];
    out[1] = (-s->c * x[1] - s->k * x[0]) / m + square * cos(angle) + tangent * sin(angle) - push * x[0] + pull * x[2];
    out[2] = x[3];
    out[3] = (-s->c * x[3] - s->k * x[2]) / m + square * sin(angle) - tangent * cos(angle) - push * x[2] - pull * x[0];
}

/// Carries the state over a step by the classical method of Runge and Kutta.
static void spun_step(const spun *s, double time, double h, double x[4]) {
    double a[4], b[4], c[4], d[4], y[4];
    spun_slope(s, time, x, a);
    for (int i = 0; i < 4; i++) y[i] = x[i] + 0.5 * h * a[i];
    spun_slope(s, time + 0.5 * h, y, b);
    for (int i = 0; i < 4; i++) y[i] = x[i] + 0.5 * h * b[i];
    spun_slope(s, time + 0.5 * h, y, c);
    for (int i = 0; i < 4; i++) y[i] = x[i] + h * c[i];
    spun_slope(s, time + h, y, d);
    for (int i = 0; i < 4; i++) x[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
}

/// Returns the time of a sample in the table: uneven times over 2.4 s.
static double sample_time(size_t n) {
    return 0.03 + 2.4 * ((double)n + 0.3 * sin(3.7 * (double)n)) / SAMPLES;
}

/// Runs the rotor from its centre; displacements [SAMPLES] x and y at the times of the table.
static void spun_run(const spun *s, double displacements[][2]) {
    static const double longest = 1e-4;
    double x[4] = {0.0}, time = 0.0;
    for (size_t n = 0; n < SAMPLES; n++) {
        const double end = sample_time(n) - s->delay;
        const int steps = (int)ceil((end - time) / longest);
        const double h = (end - time) / steps;
        for (int k = 0; k < steps; k++) spun_step(s, time + k * h, h, x);
        time = end;
        displacements[n][0] = x[0];
        displacements[n][1] = x[2];
    }
}

/// Returns a number of the standard normal distribution: Box and Muller's method with the generator SplitMix64.
static double normal(uint64_t *seed) {
    double u[2];
    for (int i = 0; i < 2; i++) {
        uint64_t z = *seed += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        u[i] = ((double)((z ^ (z >> 31)) >> 11) + 0.5) / 9007199254740992.0;
    }
    return sqrt(-2.0 * log(u[0])) * cos(two_pi * u[1]);
}

/// Writes the table of displacements along x and along 120 degrees, with noise, m.
static void write_samples(const char *name, double displacements[][2], double noise, uint64_t seed) {
    char path[256];
    fit_path(name, path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "time [s], disc x [m], disc 120 [m]\n");
    for (size_t n = 0; n < SAMPLES; n++) {
        const double own[2] = {displacements[n][0],
                               cos(two_pi / 3.0) * displacements[n][0] + sin(two_pi / 3.0) * displacements[n][1]};
        fprintf(file, "%.17g", sample_time(n));
        for (size_t axis = 0; axis < 2; axis++)
            fprintf(file, ", %.17g", own[axis] + (noise > 0.0 ? noise * normal(&seed) : 0.0));
        fprintf(file, "\n");
    }
    fclose(file);
}

// ---------------------------------------------------------------- fits

#define FAN                                                                                                            \
    "whirl: 1\n"                                                                                                       \
    "parameters: {k: 1.19 MN/m, c: 830 N s/m, e: 28 um, rate: 79.9 rad/s2, phase: 0.95, begins: 12 ms}\n"              \
    "rotor:\n"                                                                                                         \
    "  speed: 100 rad/s\n"                                                                                             \
    "  length_scale: %s\n"                                                                                             \
    "  stations: {disc: {mass: 30 kg, damping: = c, eccentricity: = e}}\n"                                             \
    "  elements:\n"                                                                                                    \
    "    - shaft: {between: [disc, ground], k1: = k}\n"                                                                \
    "study:\n"                                                                                                         \
    "  fit:\n"                                                                                                         \
    "    unknown: {k: , c: , e: %s}\n"                                                                                 \
    "    data:\n"                                                                                                      \
    "      file: %s\n"                                                                                                 \
    "      noise: 2 um\n"                                                                                              \
    "      compare: waveform\n"                                                                                        \
    "      delay: = begins\n"                                                                                          \
    "      runup: {speed_from: 100 rad/s, rate: = rate, duration: 2.5 s, begin: centre, angle: = phase}\n"             \
    "%s"

static const spun truth = {
    .k = 1.2e6, .c = 800.0, .e = 30e-6, .rate = 80.0, .phase = 1.0, .delay = 10e-3, .from = 100.0};

/// Returns a row of the field of unknowns: parameter, start, found, error, half, ...
static const double *unknown_of(const whirl_result *result, size_t u) {
    return whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0) + 8 * u;
}

/// Fits the fan to a table.
static whirl_result *fit_fan(const char *length, const char *more, const char *file, const char *options, int threads) {
    char text[2048];
    snprintf(text, sizeof text, FAN, length, more, file, options);
    return fit_of_text(text, threads);
}

static double displacements[SAMPLES][2], sides[PARAMETERS][2][SAMPLES][2];

static void parameters_are_found(void **unused) {
    (void)unused;
    static const char *const lengths[] = {"1 mm", "10 um", "1 m"};
    const double values[] = {truth.k, truth.c, truth.e, truth.rate, truth.phase, truth.delay};
    spun_run(&truth, displacements);
    write_samples("samples.csv", displacements, 0.0, 1);
    for (size_t l = 0; l < 3; l++) {
        whirl_result *result = fit_fan(lengths[l], ", rate: , phase: , begins: ", "samples.csv", "", 1);
        double worst = 0.0;
        for (size_t u = 0; u < PARAMETERS; u++) worst = fmax(worst, fabs(unknown_of(result, u)[2] / values[u] - 1.0));
        check_within("Fit to waveforms of run-ups",
                     words("a rotor run through its resonance: error of six parameters, length scale %s", lengths[l]),
                     0.0, worst, 1e-7);
        // Threads change no bit.
        if (l == 0) {
            whirl_result *other = fit_fan(lengths[l], ", rate: , phase: , begins: ", "samples.csv", "", 2);
            assert_memory_equal(whirl_table_block(&result->tables[0], 0), whirl_table_block(&other->tables[0], 0),
                                result->tables[0].layout.size * sizeof(double));
            whirl_result_free(other);
        }
        whirl_result_free(result);
    }
}

/// A coast-down that touches a stator for a while gives its clearance, stiffness and friction.
static void a_stator_is_found(void **unused) {
    (void)unused;
    static const char *const names[] = {"clearance", "stiffness", "friction"};
    spun touching = truth;
    touching.from = 290.0;
    touching.rate = -80.0;
    touching.c = 600.0;
    touching.gap = 0.2e-3;
    touching.stiffness = 0.6e6;
    touching.friction = 0.05;
    spun_run(&touching, displacements);
    write_samples("rub.csv", displacements, 0.0, 1);
    whirl_result *result = fit_of_text(
        "whirl: 1\n"
        "parameters: {gap: 0.21 mm, push: 0.55 MN/m, mu: 0.04}\n"
        "rotor:\n"
        "  speed: 100 rad/s\n"
        "  length_scale: 1 mm\n"
        "  stations: {disc: {mass: 30 kg, damping: 600 N s/m, eccentricity: 30 um}}\n"
        "  elements:\n"
        "    - shaft: {between: [disc, ground], k1: 1.2 MN/m}\n"
        "    - rub: {at: disc, gap: = gap, stiffness: = push, friction: = mu}\n"
        "study:\n"
        "  fit:\n"
        "    unknown: {gap: , push: , mu: }\n"
        "    data:\n"
        "      file: rub.csv\n"
        "      noise: 1 um\n"
        "      compare: waveform\n"
        "      delay: 10 ms\n"
        "      runup: {speed_from: 290 rad/s, speed_to: 40 rad/s, rate: 80 rad/s2, begin: centre, angle: 1 rad}\n",
        1);
    const double values[] = {touching.gap, touching.stiffness, touching.friction};
    for (size_t u = 0; u < 3; u++)
        check_within("Fit to waveforms of run-ups",
                     words("a rotor that touches its stator in a coast-down: error of its %s", names[u]), 0.0,
                     fabs(unknown_of(result, u)[2] / values[u] - 1.0), 1e-5);
    whirl_result_free(result);
}

/// Solves the normal equations' inverse by Gauss and Jordan's method: a [n][n] becomes its inverse.
static void invert(size_t n, double a[PARAMETERS][PARAMETERS]) {
    for (size_t p = 0; p < n; p++) {
        const double pivot = a[p][p];
        a[p][p] = 1.0;
        for (size_t j = 0; j < n; j++) a[p][j] /= pivot;
        for (size_t i = 0; i < n; i++) {
            if (i == p) continue;
            const double factor = a[i][p];
            a[i][p] = 0.0;
            for (size_t j = 0; j < n; j++) a[i][j] -= factor * a[p][j];
        }
    }
}

/// Standard errors are those of derivatives of the independent rotor.
static void errors_are_those_of_the_derivatives(void **unused) {
    (void)unused;
    const double noise = 2e-6, part = 1e-5;
    const double values[] = {truth.k, truth.c, truth.e, truth.rate, truth.phase, truth.delay};
    double normal_equations[PARAMETERS][PARAMETERS] = {{0.0}};
    spun_run(&truth, displacements);
    write_samples("samples.csv", displacements, 0.0, 1);
    for (size_t p = 0; p < PARAMETERS; p++)
        for (size_t side = 0; side < 2; side++) {
            spun other = truth;
            double *const own[] = {&other.k, &other.c, &other.e, &other.rate, &other.phase, &other.delay};
            *own[p] = values[p] * (side ? 1.0 + part : 1.0 - part);
            spun_run(&other, sides[p][side]);
        }
    for (size_t n = 0; n < SAMPLES; n++)
        for (size_t probe = 0; probe < 2; probe++) {
            double slope[PARAMETERS];
            for (size_t p = 0; p < PARAMETERS; p++) {
                const double x = sides[p][1][n][0] - sides[p][0][n][0], y = sides[p][1][n][1] - sides[p][0][n][1];
                const double along = probe == 0 ? x : cos(two_pi / 3.0) * x + sin(two_pi / 3.0) * y;
                slope[p] = along / (2.0 * part * noise); // by the relative change
            }
            for (size_t i = 0; i < PARAMETERS; i++)
                for (size_t j = 0; j < PARAMETERS; j++) normal_equations[i][j] += slope[i] * slope[j];
        }
    invert(PARAMETERS, normal_equations);
    whirl_result *result = fit_fan("1 mm", ", rate: , phase: , begins: ", "samples.csv", "", 1);
    double worst = 0.0;
    for (size_t p = 0; p < PARAMETERS; p++) {
        const double error = sqrt(normal_equations[p][p]) * values[p];
        worst = fmax(worst, fabs(unknown_of(result, p)[3] / error - 1.0));
    }
    check_within("Fit to waveforms of run-ups", "a rotor run through its resonance: error of the standard errors", 0.0,
                 worst, 1e-5);
    whirl_result_free(result);
}

/// Most 95 % intervals contain the true values.
static void intervals_cover(void **unused) {
    (void)unused;
    enum { MACHINES = 50 };
    const double values[] = {truth.k, truth.c, truth.e, truth.rate, truth.phase, truth.delay};
    size_t within = 0, all = 0;
    spun_run(&truth, displacements);
    for (uint64_t i = 0; i < MACHINES; i++) {
        write_samples("noisy.csv", displacements, 2e-6, i);
        whirl_result *result = fit_fan("1 mm", ", rate: , phase: , begins: ", "noisy.csv", "    tolerance: 1e-5\n", 2);
        for (size_t u = 0; u < PARAMETERS; u++, all++)
            within += fabs(unknown_of(result, u)[2] - values[u]) <= unknown_of(result, u)[4];
        whirl_result_free(result);
    }
    check_within("Fit to waveforms of run-ups",
                 words("%d noisy run-ups: 95 %% intervals that contain the true value, %%", MACHINES), 94.5,
                 100.0 * (double)within / (double)all, 4.5);
}

// ---------------------------------------------------------------- records of data sets

#define RECORDED                                                                                                       \
    "whirl: 1\n"                                                                                                       \
    "parameters: {k: 1.2 MN/m, c: 800 N s/m, e: 30 um, first: 100 rad/s, rate: 80 rad/s2}\n"                           \
    "rotor:\n"                                                                                                         \
    "  speed: 100 rad/s\n"                                                                                             \
    "  length_scale: 1 mm\n"                                                                                           \
    "  stations:\n"                                                                                                    \
    "    disc: {mass: 30 kg, damping: = c, eccentricity: = e}\n"                                                       \
    "  elements:\n"                                                                                                    \
    "    - shaft: {between: [disc, ground], k1: = k}\n"                                                                \
    "study:\n"

/// Parameters of the machine of a record of a run-up are found: it has the record's speeds, angle and parameters.
static void records_are_fitted(void **unused) {
    (void)unused;
    char path[256];
    fit_path("records.h5", path);
    whirl_result *records =
        fit_of_text(RECORDED "  dataset:\n"
                             "    machines: 2\n"
                             "    rate: 2 kHz\n"
                             "    samples: 4000\n"
                             "    conditions: {first: +- 10 %, rate: +- 20 %}\n"
                             "    vary: {c: +- 20 %}\n"
                             "    runup: {speed_from: = first, speed_to: 280 rad/s, rate: = rate, settle: 100}\n"
                             "    labels: {unbalance: {grade: {e: {from: 20 um, to: 60 um}}}}\n"
                             "    channels:\n"
                             "      - {sensor: proximity, at: disc, sensitivity: 7.87 V/mm, gap: 1.27 mm}\n"
                             "      - {sensor: proximity, at: disc, angle: 45 deg}\n"
                             "      - {sensor: keyphasor}\n",
                    2);
    require_ok(whirl_result_write(records, path));
    const double *values = whirl_table_field(&records->tables[0], 1, WHIRL_FIELD_DATASET_VALUES, 0);
    // The second record has its own damping, speeds, and eccentricity.
    whirl_result *result =
        fit_of_text(RECORDED "  fit:\n"
                             "    unknown: {k: {start: 1.18 MN/m}, e: {start: 33 um}}\n"
                             "    data:\n"
                             "      file: records.h5\n"
                             "      record: 2\n"
                             "      noise: 1 um\n"
                             "      runup: {speed_from: = first, speed_to: 280 rad/s, rate: = rate, settle: 100}\n",
                    2);
    double e = 0.0;
    for (size_t i = 0; i < 4; i++)
        if (values[i] >= 20e-6 && values[i] <= 60e-6) e = values[i];
    assert_true(e > 0.0);
    check_within("Fit to waveforms of run-ups", "a record of a data set: error of the stiffness", 0.0,
                 fabs(unknown_of(result, 0)[2] / truth.k - 1.0), 1e-6);
    check_within("Fit to waveforms of run-ups", "a record of a data set: error of the eccentricity", 0.0,
                 fabs(unknown_of(result, 1)[2] / e - 1.0), 1e-4);
    whirl_result_free(result);
    whirl_result_free(records);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(parameters_are_found), cmocka_unit_test(a_stator_is_found),
                                       cmocka_unit_test(errors_are_those_of_the_derivatives),
                                       cmocka_unit_test(records_are_fitted), cmocka_unit_test(intervals_cover)};
    return cmocka_run_group_tests_name("fit of waveforms", tests, fit_make_folder, fit_remove_folder);
}
