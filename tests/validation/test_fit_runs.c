// Fits of run-ups: a rotor on a spring that is run through its resonance, against an independent integration of its
// equations by the angle of the shaft, with orders by integrals over single turns.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_fit.h"
#include "whirl/engine.h"

enum { MAX_TURNS = 128, STEPS = 1024, PARAMETERS = 4 };

static const double two_pi = 6.283185307179586476925;

// ---------------------------------------------------------------- the independent rotor

/// A disc of 30 kg on a spring: m x'' + c x' + k x = m e (w^2 cos + w' sin), and likewise y. Beyond a gap a stator
/// presses it back, with friction against the rotation.
typedef struct spun {
    double k, c, e, rate;            ///< N/m, N s/m, m, rad/s2
    double from;                     ///< rad/s
    double gap, stiffness, friction; ///< m, N/m (0: no stator), and a coefficient
} spun;

/// Parts of x and y over a turn, with its middle and its mean speed.
typedef struct turn {
    double time, speed, cosine[2], sine[2];
} turn;

static double spun_speed(const spun *s, double angle) {
    return sqrt(s->from * s->from + 2.0 * s->rate * angle);
}

/// Derives the state x, vx, y, vy by the angle.
static void spun_slope(const spun *s, double angle, const double x[4], double out[4]) {
    const double m = 30.0, w = spun_speed(s, angle);
    const double square = s->e * w * w, tangent = s->e * s->rate;
    const double radius = hypot(x[0], x[2]), normal = s->stiffness * fmax(radius - s->gap, 0.0);
    const double push = normal > 0.0 ? normal / radius / m : 0.0, pull = s->friction * push;
    out[0] = x[1] / w;
    out[1] =
        ((-s->c * x[1] - s->k * x[0]) / m + square * cos(angle) + tangent * sin(angle) - push * x[0] + pull * x[2]) / w;
    out[2] = x[3] / w;
    out[3] =
        ((-s->c * x[3] - s->k * x[2]) / m + square * sin(angle) - tangent * cos(angle) - push * x[2] - pull * x[0]) / w;
}

/// Carries the state over a step by the classical method of Runge and Kutta.
static void spun_step(const spun *s, double angle, double h, double x[4]) {
    double a[4], b[4], c[4], d[4], y[4];
    spun_slope(s, angle, x, a);
    for (int i = 0; i < 4; i++) y[i] = x[i] + 0.5 * h * a[i];
    spun_slope(s, angle + 0.5 * h, y, b);
    for (int i = 0; i < 4; i++) y[i] = x[i] + 0.5 * h * b[i];
    spun_slope(s, angle + 0.5 * h, y, c);
    for (int i = 0; i < 4; i++) y[i] = x[i] + h * c[i];
    spun_slope(s, angle + h, y, d);
    for (int i = 0; i < 4; i++) x[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
}

/// Runs the rotor from its centre for some turns; orders are integrals over turns by Simpson's rule.
static void spun_run(const spun *s, size_t count, turn *turns) {
    const double h = two_pi / STEPS;
    double x[4] = {0.0};
    for (size_t n = 0; n < count; n++) {
        const double begin = two_pi * (double)n, end = begin + two_pi;
        const double low = (spun_speed(s, begin) - s->from) / s->rate, high = (spun_speed(s, end) - s->from) / s->rate;
        turns[n] = (turn){.time = 0.5 * (low + high), .speed = two_pi / (high - low)};
        for (int k = 0; k <= STEPS; k++) {
            const double angle = h * k, weight = (k % STEPS == 0 ? 1.0 : k % 2 ? 4.0 : 2.0) / (3.0 * STEPS) * 2.0;
            for (size_t axis = 0; axis < 2; axis++) {
                turns[n].cosine[axis] += weight * cos(angle) * x[2 * axis];
                turns[n].sine[axis] += weight * sin(angle) * x[2 * axis];
            }
            if (k < STEPS) spun_step(s, begin + angle, h, x);
        }
    }
}

/// Chooses every fourth turn from the eighth on.
static bool is_measured(size_t n) {
    return n >= 8 && n % 4 == 0;
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

/// Writes the table of some turns over the speed or the time, with noise on both parts, m.
static void write_turns(const char *name, bool by_time, size_t count, const turn *turns, double noise, uint64_t seed) {
    char path[256];
    fit_path(name, path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "%s, disc x [m], disc x lag [rad], disc y [m], disc y lag [rad]\n",
            by_time ? "time [s]" : "speed [rad/s]");
    for (size_t n = 0; n < count; n++) {
        if (!is_measured(n)) continue;
        fprintf(file, "%.17g", by_time ? turns[n].time : turns[n].speed);
        for (size_t axis = 0; axis < 2; axis++) {
            const double cosine = turns[n].cosine[axis] + (noise > 0.0 ? noise * normal(&seed) : 0.0);
            const double sine = turns[n].sine[axis] + (noise > 0.0 ? noise * normal(&seed) : 0.0);
            fprintf(file, ", %.17g, %.17g", hypot(cosine, sine), atan2(sine, cosine));
        }
        fprintf(file, "\n");
    }
    fclose(file);
}

// ---------------------------------------------------------------- fits

#define FAN                                                                                                            \
    "whirl: 1\n"                                                                                                       \
    "parameters: {k: 1.15 MN/m, c: 1 kN s/m, e: 25 um, rate: 82 rad/s2}\n"                                             \
    "rotor:\n"                                                                                                         \
    "  speed: 100 rad/s\n"                                                                                             \
    "  length_scale: 1 mm\n"                                                                                           \
    "  stations: {disc: {mass: 30 kg, damping: = c, eccentricity: = e}}\n"                                             \
    "  elements:\n"                                                                                                    \
    "    - shaft: {between: [disc, ground], k1: = k}\n"                                                                \
    "study:\n"                                                                                                         \
    "  fit:\n"
#define RUN "runup: {speed_from: 100 rad/s, speed_to: 300 rad/s, rate: = rate, begin: centre}"

static const spun truth = {.k = 1.2e6, .c = 800.0, .e = 30e-6, .rate = 80.0, .from = 100.0};
enum { TURNS = 78 }; // up to 297 rad/s

/// Returns a row of the field of unknowns: parameter, start, found, error, half, ...
static const double *unknown_of(const whirl_result *result, size_t u) {
    return whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0) + 8 * u;
}

static double deviation_of(const whirl_result *result) {
    return whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_OUTCOME, 0)[4];
}

static void parameters_are_found(void **unused) {
    (void)unused;
    static turn turns[MAX_TURNS];
    static const char *const names[] = {"over the speed", "over the time, with its rate"};
    spun_run(&truth, TURNS, turns);
    write_turns("speed.csv", false, TURNS, turns, 0.0, 1);
    write_turns("time.csv", true, TURNS, turns, 0.0, 1);
    // Over the speed the rate is the case's, over the time it is found, too.
    static const char over_speed[] = FAN "    unknown: {k: , c: , e: }\n"
                                         "    data: {file: speed.csv, at: {rate: 80 rad/s2}, noise: 1 um, " RUN "}\n";
    static const char over_time[] = FAN "    unknown: {k: , c: , e: , rate: }\n"
                                        "    data: {file: time.csv, noise: 1 um, " RUN "}\n";
    for (int by_time = 0; by_time < 2; by_time++) {
        const double values[] = {truth.k, truth.c, truth.e, truth.rate};
        whirl_result *result = fit_of_text(by_time ? over_time : over_speed, 1);
        double worst = 0.0;
        for (size_t u = 0; u < 3 + (size_t)by_time; u++)
            worst = fmax(worst, fabs(unknown_of(result, u)[2] / values[u] - 1.0));
        check_within("Fit to run-ups",
                     words("a rotor run through its resonance: error of parameters found %s", names[by_time]), 0.0,
                     worst, 1e-8);
        // Rows have the times and speeds of the turns.
        const double *motion = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_MOTION, 0);
        for (size_t n = 0, row = 0; n < TURNS; n++) {
            if (!is_measured(n)) continue;
            assert_true(fabs(motion[4 * row] - turns[n].speed) <= 1e-6 * turns[n].speed);
            assert_true(fabs(motion[4 * row + 3] - turns[n].time) <= 1e-6 * turns[TURNS - 1].time);
            row++;
        }
        // Threads change no bit.
        whirl_result *other = fit_of_text(by_time ? over_time : over_speed, 2);
        assert_memory_equal(whirl_table_block(&result->tables[0], 0), whirl_table_block(&other->tables[0], 0),
                            result->tables[0].layout.size * sizeof(double));
        whirl_result_free(other);
        whirl_result_free(result);
    }
}

/// The steady motions of no machine agree with a run, and give other parameters.
static void steady_motions_differ(void **unused) {
    (void)unused;
    static turn turns[MAX_TURNS];
    spun_run(&truth, TURNS, turns);
    write_turns("speed.csv", false, TURNS, turns, 0.0, 1);
    whirl_result *result =
        fit_of_text(FAN "    unknown: {k: , c: , e: }\n    data: {file: speed.csv, noise: 1 um}\n", 1);
    assert_true(deviation_of(result) > 5.0);
    assert_true(fabs(unknown_of(result, 0)[2] / truth.k - 1.0) > 0.02);
    whirl_result_free(result);
}

/// A run-up that touches a stator for a while gives its clearance, stiffness and friction.
static void a_stator_is_found(void **unused) {
    (void)unused;
    static turn turns[MAX_TURNS];
    static const char *const names[] = {"clearance", "stiffness", "friction"};
    spun touching = truth;
    touching.c = 600.0;
    touching.gap = 0.2e-3;
    touching.stiffness = 0.6e6;
    touching.friction = 0.05;
    spun_run(&touching, TURNS, turns);
    write_turns("rub.csv", false, TURNS, turns, 0.0, 1);
    whirl_result *result =
        fit_of_text("whirl: 1\n"
                    "parameters: {gap: 0.22 mm, push: 0.5 MN/m, mu: 0.03}\n"
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
                    "      runup: {speed_from: 100 rad/s, speed_to: 300 rad/s, rate: 80 rad/s2, begin: centre}\n",
                    1);
    const double values[] = {touching.gap, touching.stiffness, touching.friction};
    for (size_t u = 0; u < 3; u++)
        check_within("Fit to run-ups", words("a rotor that touches its stator in a run-up: error of its %s", names[u]),
                     0.0, fabs(unknown_of(result, u)[2] / values[u] - 1.0), 1e-5);
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
    static turn turns[MAX_TURNS], sides[PARAMETERS][2][MAX_TURNS];
    const size_t count = 3;
    const double noise = 1e-6, values[] = {truth.k, truth.c, truth.e};
    double normal_equations[PARAMETERS][PARAMETERS] = {{0.0}};
    spun_run(&truth, TURNS, turns);
    write_turns("speed.csv", false, TURNS, turns, 0.0, 1);
    for (size_t p = 0; p < count; p++)
        for (size_t side = 0; side < 2; side++) {
            spun other = truth;
            double *const own[] = {&other.k, &other.c, &other.e};
            *own[p] = values[p] * (side ? 1.0 + 1e-4 : 1.0 - 1e-4);
            spun_run(&other, TURNS, sides[p][side]);
        }
    for (size_t n = 0; n < TURNS; n++)
        for (size_t part = 0; part < 4 && is_measured(n); part++) {
            double slope[PARAMETERS];
            for (size_t p = 0; p < count; p++) {
                const turn *a = &sides[p][0][n], *b = &sides[p][1][n];
                slope[p] = (part < 2 ? b->cosine[part] - a->cosine[part] : b->sine[part - 2] - a->sine[part - 2]) /
                           (2e-4 * noise); // by the relative change
            }
            for (size_t i = 0; i < count; i++)
                for (size_t j = 0; j < count; j++) normal_equations[i][j] += slope[i] * slope[j];
        }
    invert(count, normal_equations);
    whirl_result *result = fit_of_text(FAN "    unknown: {k: , c: , e: }\n"
                                           "    data: {file: speed.csv, at: {rate: 80 rad/s2}, noise: 1 um, " RUN "}\n",
                                       1);
    double worst = 0.0;
    for (size_t p = 0; p < count; p++) {
        const double error = sqrt(normal_equations[p][p]) * values[p];
        worst = fmax(worst, fabs(unknown_of(result, p)[3] / error - 1.0));
    }
    check_within("Fit to run-ups", "a rotor run through its resonance: error of the standard errors", 0.0, worst, 1e-6);
    whirl_result_free(result);
}

/// Most 95 % intervals contain the true values.
static void intervals_cover(void **unused) {
    (void)unused;
    enum { MACHINES = 50 };
    static turn turns[MAX_TURNS];
    const double values[] = {truth.k, truth.c, truth.e};
    size_t within = 0, all = 0;
    spun_run(&truth, TURNS, turns);
    for (uint64_t i = 0; i < MACHINES; i++) {
        write_turns("noisy.csv", false, TURNS, turns, 2e-6, i);
        whirl_result *result =
            fit_of_text(FAN "    unknown: {k: , c: , e: }\n"
                            "    data: {file: noisy.csv, at: {rate: 80 rad/s2}, noise: 2 um, " RUN "}\n"
                            "    tolerance: 1e-5\n",
                        2);
        for (size_t u = 0; u < 3; u++, all++)
            within += fabs(unknown_of(result, u)[2] - values[u]) <= unknown_of(result, u)[4];
        whirl_result_free(result);
    }
    check_within("Fit to run-ups", words("%d noisy run-ups: 95 %% intervals that contain the true value, %%", MACHINES),
                 94.5, 100.0 * (double)within / (double)all, 4.5);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(parameters_are_found), cmocka_unit_test(steady_motions_differ),
                                       cmocka_unit_test(errors_are_those_of_the_derivatives),
                                       cmocka_unit_test(a_stator_is_found), cmocka_unit_test(intervals_cover)};
    return cmocka_run_group_tests_name("fit of run-ups", tests, fit_make_folder, fit_remove_folder);
}
