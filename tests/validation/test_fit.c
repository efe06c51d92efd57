// Fits: a rotor that rubs, against digits of an independent program; parameters that the data do not determine;
// coverage of intervals.
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
#include "support_flow.h"
#include "whirl/engine.h"

enum { MAX_TEXT = 8192, SAMPLES = 64 };

static const double two_pi = 6.283185307179586476925;

// ---------------------------------------------------------------- the rotor of jeffcott-rub.yaml, by five numbers

#define RUBBING                                                                                                        \
    "whirl: 1\n"                                                                                                       \
    "parameters: {omega: 1 rad/s, e: 0.9, g: 1 m, k_r: 10 N/m, mu: 0.05, c: 0.2 N s/m}\n"                              \
    "rotor:\n"                                                                                                         \
    "  speed: = omega\n"                                                                                               \
    "  length_scale: 1 m\n"                                                                                            \
    "  stations: {disc: {mass: 1 kg, damping: = c, eccentricity: = e}}\n"                                              \
    "  elements:\n"                                                                                                    \
    "    - shaft: {between: [disc, ground], k1: 1 N/m}\n"                                                              \
    "    - rub: {at: disc, gap: = g, stiffness: = k_r, friction: = mu}\n"                                              \
    "    - gravity: 0.5\n"

/// Writes 64 samples of the orbit at a speed, plus disturbances of known form.
static void write_samples(const char *name, double omega) {
    char path[256];
    whirl_case *object;
    whirl_study study;
    whirl_machine machine;
    static const char text[] = RUBBING "study:\n  sweep: {parameter: omega, from: 0.8, to: 1.2, points: 3}\n";
    double x[4] = {0.7, 0.0, 0.0, 0.7};
    require_ok(whirl_case_parse(text, sizeof text - 1, "rubbing", NULL, &object));
    require_ok(whirl_case_study(object, &study));
    require_ok(study.machine(study.family, &study.batches[0], omega, &machine));
    whirl_integrator *integrator = make_integrator(machine.system, "dop853", SAMPLES);
    revolve(integrator, x, 100);
    whirl_integrator_free(integrator);
    whirl_orbit *orbit;
    const whirl_orbit_options options = whirl_orbit_default();
    require_ok(whirl_orbit_find(machine.system, x, 1, &options, &orbit));
    // Without derivatives by parameters the states at instants come from the machine extended by one that is unused.
    whirl_sensitivity *by;
    whirl_extended *extended;
    whirl_orbit_sensitivity *samples;
    whirl_batch batch = study.batches[0];
    const whirl_given speed = {"omega", omega};
    snprintf(batch.parameter, sizeof batch.parameter, "mu");
    batch.given = &speed;
    batch.given_count = 1;
    require_ok(whirl_sensitivity_new(&study, &batch, 0.05, 0.0, &by));
    require_ok(whirl_extended_new(1, &by, &extended));
    require_ok(whirl_orbit_sensitivity_new(extended, orbit, &options, SAMPLES, &samples));
    fit_path(name, path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "angle [deg], disc x [m], disc y [m]\n");
    for (int k = 0; k < SAMPLES; k++)
        fprintf(file, "%.17g, %.17g, %.17g\n", 360.0 * k / SAMPLES,
                samples->states[4 * (size_t)k] + 0.002 * sin(7.0 * k + 1.0 + 3.0 * omega),
                samples->states[4 * (size_t)k + 1] + 0.002 * cos(11.0 * k + 2.0 + 5.0 * omega));
    fclose(file);
    whirl_orbit_sensitivity_free(samples);
    whirl_extended_free(extended);
    whirl_sensitivity_free(by);
    whirl_orbit_free(orbit);
    machine.release(machine.owner);
    whirl_case_free(object);
}

static const char fitted[] = RUBBING "study:\n"
                                     "  fit:\n"
                                     "    unknown:\n"
                                     "      e: {start: 0.92}\n"
                                     "      g: {start: 0.99 m}\n"
                                     "      k_r: {start: 10.5 N/m}\n"
                                     "      mu: {start: 0.06}\n"
                                     "      c: {start: 0.21 N s/m}\n"
                                     "    data:\n"
                                     "      - {file: orbit-1.csv, at: {omega: 0.85 rad/s}}\n"
                                     "      - {file: orbit-2.csv, at: {omega: 1 rad/s}}\n"
                                     "      - {file: orbit-3.csv, at: {omega: 1.15 rad/s}}\n"
                                     "    tolerance: 1e-11\n"
                                     "    rtol: 1e-13\n";

/// Digits: exact tangents by DOP853 in an independent program, Richardson differences of extended orbits.
static void rubbing_orbits(void **unused) {
    (void)unused;
    static const char *const names[] = {"e", "g", "k_r", "mu", "c"};
    static const double found[5] = {0.9000638546263, 0.9998612866208, 9.995958362655, 0.0500193183249, 0.2000210795785};
    static const double errors[5] = {2.1629438439e-4, 1.4021933810e-4, 5.1766307485e-3, 9.1949642145e-5,
                                     8.2024842637e-5};
    static const struct {
        int a, b;
        double value;
    } correlations[] = {{1, 2, 0.695845557}, {0, 1, -0.530518886}, {2, 3, -0.404106748}, {3, 4, -0.372240224}};
    write_samples("orbit-1.csv", 0.85);
    write_samples("orbit-2.csv", 1.0);
    write_samples("orbit-3.csv", 1.15);
    whirl_result *one = fit_of_text(fitted, 1), *result = fit_of_text(fitted, 2);
    const whirl_table *table = &result->tables[0];
    // Threads change no bit.
    assert_memory_equal(whirl_table_block(table, 0), whirl_table_block(&one->tables[0], 0),
                        table->layout.size * sizeof(double));
    const double *outcome = whirl_table_field(table, 0, WHIRL_FIELD_FIT_OUTCOME, 0);
    const double *unknown = whirl_table_field(table, 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
    const double *correlation = whirl_table_field(table, 0, WHIRL_FIELD_FIT_CORRELATION, 0);
    assert_int_equal((int)outcome[0], WHIRL_FIT_FOUND);
    for (int u = 0; u < 5; u++) {
        check_within("Fit", words("rubbing orbits: %s", names[u]), found[u], unknown[8 * u + 2], 1e-11 * found[u]);
        check_within("Fit", words("rubbing orbits: standard error of %s", names[u]), errors[u], unknown[8 * u + 3],
                     1e-8 * errors[u]);
        assert_int_equal((int)unknown[8 * u + 7], WHIRL_FIT_DETERMINED);
    }
    check_within("Fit", "rubbing orbits: sum of squares", 7.7247398014e-4, outcome[3], 1e-13);
    check_within("Fit", "rubbing orbits: standard deviation of residuals", 1.4276518908e-3, outcome[4], 1e-12);
    assert_int_equal((int)outcome[5], 384 - 5);
    for (size_t i = 0; i < sizeof correlations / sizeof *correlations; i++)
        check_within(
            "Fit", words("rubbing orbits: correlation %s, %s", names[correlations[i].a], names[correlations[i].b]),
            correlations[i].value, correlation[WHIRL_MAX_UNKNOWNS * correlations[i].a + correlations[i].b], 1e-8);
    whirl_result_free(one);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- closed forms

#define DISC                                                                                                           \
    "whirl: 1\n"                                                                                                       \
    "parameters: {n: 100 rad/s, m: 3 kg, k: 30 kN/m, c: 40 N s/m, e: 50 um, mu: 0.1}\n"                                \
    "rotor:\n"                                                                                                         \
    "  speed: = n\n"                                                                                                   \
    "  length_scale: %s\n"                                                                                             \
    "  rotation: %s\n"                                                                                                 \
    "  stations: {disc: {mass: = m, damping: = c, eccentricity: = e}}\n"                                               \
    "  elements:\n"                                                                                                    \
    "    - shaft: {between: [disc, ground], k1: = k}\n"                                                                \
    "    - rub: {at: disc, gap: 5 mm, stiffness: 1 MN/m, friction: = mu}\n"                                            \
    "study:\n"                                                                                                         \
    "  fit:\n"                                                                                                         \
    "    unknown: %s\n"                                                                                                \
    "    data: %s\n"                                                                                                   \
    "    tolerance: 1e-10\n"

/// Writes amplitudes and lags of a disc on a spring by their closed form, e w^2/(k/m - w^2 + i c w/m), at 9 speeds.
/// Clockwise, y leads x.
static void write_bode(double m, double k, double c, double e, bool clockwise) {
    char path[256];
    fit_path("bode.csv", path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "speed [rad/s], disc x [um], disc x lag [rad], disc y [um], disc y lag [rad]\n");
    for (int i = 0; i < 9; i++) {
        const double w = 60.0 + 10.0 * i, real = k / m - w * w, imaginary = c * w / m;
        const double amplitude = 1e6 * e * w * w / hypot(real, imaginary), lag = atan2(imaginary, real);
        fprintf(file, "%.17g, %.17g, %.17g, %.17g, %.17g\n", w, amplitude, lag, amplitude,
                lag + (clockwise ? -0.25 : 0.25) * two_pi);
    }
    fclose(file);
}

static whirl_result *run_disc_with(const char *scale, const char *rotation, const char *unknown, const char *data) {
    char text[MAX_TEXT];
    snprintf(text, sizeof text, DISC, scale, rotation, unknown, data);
    return fit_of_text(text, 2);
}

static whirl_result *run_disc(const char *scale, const char *rotation, const char *unknown) {
    return run_disc_with(scale, rotation, unknown, "bode.csv");
}

/// Fits find the parameters of closed forms, for any unit of the state, and clockwise, too.
static void closed_forms(void **unused) {
    (void)unused;
    static const struct {
        const char *scale, *rotation;
    } forms[] = {{"1 mm", "counter-clockwise"}, {"1 um", "counter-clockwise"}, {"1 mm", "clockwise"}};
    static const double truth[3] = {33e3, 52.0, 38e-6};
    static const char *const names[3] = {"k", "c", "e"};
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        write_bode(3.0, truth[0], truth[1], truth[2], strcmp(forms[i].rotation, "clockwise") == 0);
        whirl_result *result = run_disc(forms[i].scale, forms[i].rotation, "{k: , c: , e: }");
        const double *unknown = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
        for (int u = 0; u < 3; u++)
            check_within("Fit", words("disc on a spring, %s, %s: %s", forms[i].scale, forms[i].rotation, names[u]),
                         truth[u], unknown[8 * u + 2], 1e-9 * truth[u]);
        whirl_result_free(result);
    }
}

/// Computes the response of the disc without its eccentricity, w^2/(k/m - w^2 + i c w/m): cosine and sine part.
static void disc_gain(double w, double k, double gain[2]) {
    const double real = k / 3.0 - w * w, imaginary = 52.0 * w / 3.0, square = real * real + imaginary * imaginary;
    gain[0] = w * w * real / square;
    gain[1] = w * w * imaginary / square;
}

/// A waveform at times that are no fractions of a revolution is fitted.
static void waveforms(void **unused) {
    (void)unused;
    static const double truth[3] = {33e3, 52.0, 38e-6}, w = 100.0;
    static const char *const names[3] = {"k", "c", "e"};
    char path[256];
    double gain[2];
    disc_gain(w, truth[0], gain);
    fit_path("waveform.csv", path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "time [ms], disc x [um], disc y [um]\n");
    for (int i = 0; i < 100; i++) {
        const double t = 0.00317 * i, size = 1e6 * truth[2];
        fprintf(file, "%.17g, %.17g, %.17g\n", 1e3 * t, size * (gain[0] * cos(w * t) + gain[1] * sin(w * t)),
                size * (gain[0] * sin(w * t) - gain[1] * cos(w * t)));
    }
    fclose(file);
    // One speed determines two numbers: the stiffness and the eccentricity, with the damping known.
    whirl_result *result = run_disc_with("1 mm", "counter-clockwise", "{k: , e: }",
                                         "[{file: waveform.csv, at: {n: 100 rad/s, c: 52 N s/m}}]");
    const double *unknown = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
    for (int u = 0; u < 2; u++)
        check_within("Fit", words("disc on a spring, waveform: %s", names[2 * u]), truth[2 * u], unknown[8 * u + 2],
                     1e-7 * truth[2 * u]);
    whirl_result_free(result);
}

/// Writes the Bode plot of the disc as complex numbers over the speed in rpm, in a universal file (dataset 58).
static void write_universal(const double truth[3]) {
    enum { SPEEDS = 9 };
    char path[256];
    fit_path("bode.uff", path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "    -1\n    58\nNONE\nNONE\nNONE\nNONE\nNONE\n");
    fprintf(file, "%5d%10d%5d%10d %-10s%10d%4d %-10s%10d%4d\n", 12, 0, 0, 0, "disc", 1, 1, "NONE", 0, 0);
    fprintf(file, "%10d%10d%10d%13.5E%13.5E%13.5E\n", 6, SPEEDS, 1, 600.0, 100.0, 0.0);
    fprintf(file, "%10d%5d%5d%5d %-20s %-20s\n", 19, 0, 0, 0, "Speed", "RPM");
    fprintf(file, "%10d%5d%5d%5d %-20s %-20s\n", 8, 0, 0, 0, "Displacement", "UM");
    for (int i = 0; i < 2; i++) fprintf(file, "%10d%5d%5d%5d %-20s %-20s\n", 0, 0, 0, 0, "NONE", "NONE");
    for (int i = 0; i < SPEEDS; i++) {
        double gain[2];
        disc_gain((600.0 + 100.0 * i) * two_pi / 60.0, truth[0], gain);
        fprintf(file, "%20.12E%20.12E%s", 1e6 * truth[2] * gain[0], -1e6 * truth[2] * gain[1], i % 2 ? "\n" : "");
    }
    fprintf(file, "\n    -1\n");
    fclose(file);
}

/// Writes a row of numbers as a variable of a MAT file of level 4, whose bytes begin with the smallest or, `big`, the
/// largest place.
static void write_variable(FILE *file, const char *name, const double *numbers, size_t count, bool big) {
    const uint32_t head[] = {big ? 1000 : 0, 1, (uint32_t)count, 0, (uint32_t)strlen(name) + 1};
    for (size_t i = 0; i < 5; i++)
        for (unsigned k = 0; k < 4; k++) fputc((int)(head[i] >> 8 * (big ? 3 - k : k) & 255U), file);
    fwrite(name, 1, strlen(name) + 1, file);
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        for (unsigned k = 0; k < 8; k++) fputc((int)(bits >> 8 * (big ? 7 - k : k) & 255U), file);
    }
}

/// Writes the Bode plot of the disc as variables of a MAT file.
static void write_matlab(const double truth[3], bool big) {
    enum { SPEEDS = 9 };
    char path[256];
    double speed[SPEEDS], size[SPEEDS], lag[SPEEDS];
    for (int i = 0; i < SPEEDS; i++) {
        double gain[2];
        speed[i] = 60.0 + 10.0 * i;
        disc_gain(speed[i], truth[0], gain);
        size[i] = truth[2] * hypot(gain[0], gain[1]);
        lag[i] = atan2(gain[1], gain[0]);
    }
    fit_path("bode.mat", path);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    write_variable(file, "w", speed, SPEEDS, big);
    write_variable(file, "a", size, SPEEDS, big);
    write_variable(file, "phi", lag, SPEEDS, big);
    fclose(file);
}

/// The Bode plot of a disc is fitted from files of instruments and of MATLAB.
static void measured_files(void **unused) {
    (void)unused;
    static const double truth[3] = {33e3, 52.0, 38e-6};
    static const char *const names[3] = {"k", "c", "e"};
    static const char variables[] =
        "{file: bode.mat, columns: {'speed [rad/s]': w, 'disc x [m]': a, 'disc x lag [rad]': phi}}";
    static const struct {
        const char *name, *data;
    } files[] = {{"universal file", "bode.uff"},
                 {"MAT file, smallest byte first", variables},
                 {"MAT file, largest byte first", variables}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        if (i == 0)
            write_universal(truth);
        else
            write_matlab(truth, i == 2);
        whirl_result *result = run_disc_with("1 mm", "counter-clockwise", "{k: , c: , e: }", files[i].data);
        const double *unknown = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
        for (int u = 0; u < 3; u++)
            check_within("Fit", words("disc on a spring, %s: %s", files[i].name, names[u]), truth[u],
                         unknown[8 * u + 2], 1e-9 * truth[u]);
        whirl_result_free(result);
    }
}

/// Each probe has its own noise: the eccentricity is the mean of the values of the probes, weighted by the inverse
/// squares of their noise.
static void noise_by_probe(void **unused) {
    (void)unused;
    static const double said[2] = {36e-6, 40e-6}, noise[2] = {1e-6, 3e-6};
    char path[256];
    double top = 0.0, bottom = 0.0;
    fit_path("bode.csv", path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "speed [rad/s], disc x [m], disc x lag [rad], disc y [m], disc y lag [rad]\n");
    for (int i = 0; i < 9; i++) {
        const double w = 60.0 + 10.0 * i;
        double gain[2];
        disc_gain(w, 33e3, gain);
        const double size = hypot(gain[0], gain[1]), lag = atan2(gain[1], gain[0]);
        fprintf(file, "%.17g, %.17g, %.17g, %.17g, %.17g\n", w, said[0] * size, lag, said[1] * size,
                lag + 0.25 * two_pi);
        for (int p = 0; p < 2; p++) {
            top += size * size * said[p] / (noise[p] * noise[p]);
            bottom += size * size / (noise[p] * noise[p]);
        }
    }
    fclose(file);
    whirl_result *result =
        run_disc_with("1 mm", "counter-clockwise", "{e: }",
                      "{file: bode.csv, at: {c: 52 N s/m, k: 33 kN/m}, noise: {disc x: 1 um, disc y: 3 um}}");
    const double *unknown = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
    check_within("Fit", "noise by probe: e", top / bottom, unknown[2], 1e-9 * unknown[2]);
    check_within("Fit", "noise by probe: standard error of e", 1.0 / sqrt(bottom), unknown[3], 1e-8 * unknown[3]);
    whirl_result_free(result);
}

/// Returns the least sum of squares over the eccentricity, on which the response depends linearly, for a stiffness.
static double disc_profile(double (*measured)[2], double noise, double k) {
    double squares = 0.0, product = 0.0, gains = 0.0, gain[2];
    for (int i = 0; i < 9; i++) {
        disc_gain(60.0 + 10.0 * i, k, gain);
        for (int part = 0; part < 2; part++) {
            squares += measured[i][part] * measured[i][part];
            product += measured[i][part] * gain[part];
            gains += gain[part] * gain[part];
        }
    }
    return (squares - product * product / gains) / (noise * noise);
}

/// With much noise the interval of the stiffness is not symmetric.
static void profiles(void **unused) {
    (void)unused;
    static const double noise = 60e-6, e = 38e-6, wide = 1.959963984540054;
    double measured[9][2];
    char path[256];
    fit_path("bode.csv", path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "speed [rad/s], disc x [m], disc x lag [rad]\n");
    for (int i = 0; i < 9; i++) {
        double gain[2];
        disc_gain(60.0 + 10.0 * i, 33e3, gain);
        measured[i][0] = e * gain[0] + noise * sin(5.0 * i + 1.0);
        measured[i][1] = e * gain[1] + noise * cos(7.0 * i);
        fprintf(file, "%.17g, %.17g, %.17g\n", 60.0 + 10.0 * i, hypot(measured[i][0], measured[i][1]),
                atan2(measured[i][1], measured[i][0]));
    }
    fclose(file);
    whirl_result *result = run_disc_with("1 mm", "counter-clockwise", "{k: {start: 33 kN/m}, e: }",
                                         "{file: bode.csv, at: {c: 52 N s/m}, noise: 60 um}\n    profile: yes");
    const whirl_table *table = &result->tables[0];
    const double *unknown = whirl_table_field(table, 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
    const double *profile = whirl_table_field(table, 0, WHIRL_FIELD_FIT_PROFILE, 0);
    // The minimum, and the ends at which the profile is 1.96^2 above it, by bisection.
    const double found = unknown[2], half = unknown[4], least = disc_profile(measured, noise, found);
    for (int side = 0; side < 2; side++) {
        double inside = found, outside = found + (side ? 3.0 : -3.0) * half;
        assert_true(disc_profile(measured, noise, outside) - least > wide * wide);
        for (int i = 0; i < 60; i++) {
            const double middle = 0.5 * (inside + outside);
            *(disc_profile(measured, noise, middle) - least < wide * wide ? &inside : &outside) = middle;
        }
        check_within("Fit", words("profile interval of k, %s end", side ? "upper" : "lower"), inside, profile[side],
                     3e-4 * half);
    }
    check_holds("Fit", "profile interval of k: not symmetric",
                fabs(profile[0] + profile[1] - 2.0 * found) > 0.01 * half);
    whirl_result_free(result);
}

/// Mass, damping and stiffness have a common factor that no unbalance response determines; the friction of a stator
/// that is not touched has no effect.
static void not_determined(void **unused) {
    (void)unused;
    static const int known[5] = {WHIRL_FIT_UNKNOWN, WHIRL_FIT_UNKNOWN, WHIRL_FIT_UNKNOWN, WHIRL_FIT_DETERMINED,
                                 WHIRL_FIT_UNKNOWN};
    write_bode(3.0, 33e3, 52.0, 38e-6, false);
    whirl_result *result = run_disc("1 mm", "counter-clockwise", "{m: , k: , c: , e: , mu: }");
    const double *unknown = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
    const double *outcome = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_OUTCOME, 0);
    for (int u = 0; u < 5; u++) assert_int_equal((int)unknown[8 * u + 7], known[u]);
    assert_int_equal((int)outcome[6], 3);
    check_within("Fit", "no common factor known: e", 38e-6, unknown[8 * 3 + 2], 1e-9 * 38e-6);
    check_within("Fit", "no common factor known: k/m", 11e3, unknown[8 + 2] / unknown[2], 1e-5);
    assert_true(isnan(unknown[3]) && isfinite(unknown[8 * 3 + 3]));
    whirl_result_free(result);
}

// ---------------------------------------------------------------- recovery

/// A kind of machine with three unknowns, and the friction of a stator that nothing touches.
typedef struct recovered {
    const char *name, *machine, *station;
    const char *unknown[3];
    int revolutions;
    double speeds[2]; ///< rad/s
} recovered;

static const recovered kinds[] = {
    {.name = "rub",
     .machine = "parameters: {omega: 1 rad/s, e: 0.9, g: 1 m, k_r: 10 N/m, mu: 0.1}\n"
                "rotor:\n"
                "  speed: = omega\n"
                "  length_scale: 1 m\n"
                "  stations: {disc: {mass: 1 kg, damping: 0.2 N s/m, eccentricity: = e}, far: {mass: 1 kg, damping: 1 "
                "N s/m}}\n"
                "  elements:\n"
                "    - shaft: {between: [disc, ground], k1: 1 N/m}\n"
                "    - shaft: {between: [far, ground], k1: 9 N/m}\n"
                "    - rub: {at: disc, gap: = g, stiffness: = k_r, friction: 0.05}\n"
                "    - rub: {at: far, gap: 1 m, stiffness: 1 N/m, friction: = mu}\n"
                "    - gravity: 0.5\n",
     .station = "disc",
     .unknown = {"e", "g", "k_r"},
     .revolutions = 1,
     .speeds = {0.85, 1.15}},
    {.name = "film",
     .machine = "parameters: {omega: 200 rad/s, c: 0.2 mm, eta: 20 mPa s, e: 20 um, mu: 0.1}\n"
                "rotor:\n"
                "  speed: = omega\n"
                "  length_scale: = c\n"
                "  stations: {disc: {mass: 40 kg, eccentricity: = e, damping: 100 N s/m}}\n"
                "  elements:\n"
                "    - film: {at: disc, clearance: = c, viscosity: = eta, radius: 40 mm, length: 40 mm}\n"
                "    - rub: {at: disc, gap: 1 m, stiffness: 1 N/m, friction: = mu}\n"
                "    - gravity: 9.81 m/s2\n",
     .station = "disc",
     .unknown = {"c", "eta", "e"},
     .revolutions = 1,
     .speeds = {150.0, 250.0}},
    {.name = "ball bearing",
     .machine = "parameters: {omega: 300 rad/s, g: 4 um, k_b: 1.3e10, e: 8 um, mu: 0.1}\n"
                "rotor:\n"
                "  speed: = omega\n"
                "  length_scale: 10 um\n"
                "  stations: {disc: {mass: 20 kg, eccentricity: = e}}\n"
                "  elements:\n"
                "    - ball_bearing: {at: disc, balls: 8, stiffness: = k_b, clearance: = g, damping: 2000 N s/m, cage: "
                "0.5}\n"
                "    - rub: {at: disc, gap: 1 m, stiffness: 1 N/m, friction: = mu}\n"
                "    - gravity: 9.81 m/s2\n",
     .station = "disc",
     .unknown = {"g", "k_b", "e"},
     .revolutions = 2,
     .speeds = {300.0, 500.0}},
    {.name = "finite elements",
     .machine = "parameters: {omega: 300 rad/s, k: 8 MN/m, c: 3 kN s/m, e: 30 um, mu: 0.1}\n"
                "rotor:\n"
                "  speed: = omega\n"
                "  length_scale: 0.1 mm\n"
                "  stations:\n"
                "    left:  {position: 0 m}\n"
                "    disc:  {position: 0.4 m, mass: 20 kg, eccentricity: = e}\n"
                "    right: {position: 1 m}\n"
                "  elements:\n"
                "    - segment: {length: 1 m, outer: 60 mm}\n"
                "    - bearing: {at: left, kxx: = k, kyy: = 1.2*k, cxx: = c}\n"
                "    - bearing: {at: right, kxx: 9 MN/m, cxx: 4 kN s/m}\n"
                "    - rub: {at: disc, gap: 1 m, stiffness: 1 N/m, friction: = mu}\n",
     .station = "disc",
     .unknown = {"k", "c", "e"},
     .revolutions = 1,
     .speeds = {200.0, 330.0}},
};
enum { KINDS = sizeof kinds / sizeof *kinds, NUMBERS = 32 };

static double drawn(uint64_t *seed) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return ((double)(*seed >> 11) + 0.5) / 9007199254740992.0;
}

static double drawn_normal(uint64_t *seed) {
    const double u = drawn(seed), v = drawn(seed);
    return sqrt(-2.0 * log(u)) * cos(two_pi * v);
}

/// States at the instants of an orbit.
typedef struct sampled {
    const whirl_probe *probe;
    double x[2 * NUMBERS][2];
    size_t count;
} sampled;

static void take_sample(void *observer, double t, const double *x) {
    sampled *own = observer;
    (void)t;
    for (size_t i = 0; i < 2; i++) own->x[own->count][i] = whirl_probe_value(own->probe, x, i);
    own->count++;
}

/// Writes what a machine with these parameters does at a speed, in m, with noise of a hundredth of its largest
/// displacement, which is returned.
static double write_motion(const recovered *kind, const whirl_given *given, const char *name, uint64_t *seed) {
    char text[MAX_TEXT], path[256];
    whirl_case *object;
    whirl_study study;
    whirl_machine machine;
    whirl_orbit *orbit;
    double x[MAX_DIMENSION], largest = 0.0;
    const int length = snprintf(text, sizeof text, "whirl: 1\n%sstudy: {response: {}}\n", kind->machine);
    require_ok(whirl_case_parse(text, (size_t)length, kind->name, NULL, &object));
    require_ok(whirl_case_study(object, &study));
    whirl_batch batch = study.batches[0];
    batch.given = given;
    batch.given_count = 4;
    require_ok(study.machine(study.family, &batch, NAN, &machine));
    assert_true(machine.system->dimension <= MAX_DIMENSION);
    memcpy(x, machine.start, machine.system->dimension * sizeof *x);
    whirl_integrate_options integrate = whirl_orbit_default().integrate;
    integrate.rtol = 1e-9;
    whirl_integrator *integrator;
    require_ok(whirl_integrator_new(machine.system, &integrate, &integrator));
    revolve(integrator, x, 200);
    whirl_integrator_free(integrator);
    const whirl_orbit_options options = whirl_orbit_default();
    require_ok(whirl_orbit_find(machine.system, x, (size_t)kind->revolutions, &options, &orbit));
    size_t probe = 0;
    while (strcmp(machine.system->probes[probe].name, kind->station) != 0) probe++;
    sampled samples = {.probe = &machine.system->probes[probe]};
    require_ok(whirl_orbit_observe(machine.system, orbit, &options, NUMBERS, take_sample, &samples));
    for (size_t i = 0; i < samples.count; i++)
        for (size_t k = 0; k < 2; k++) largest = fmax(largest, fabs(samples.x[i][k]));
    fit_path(name, path);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "turns, %s x [m], %s y [m]\n", kind->station, kind->station);
    for (size_t i = 0; i < samples.count; i++) {
        // The last sample is at the end of the period, which is its beginning.
        const double *at = samples.x[(i + samples.count - 1) % samples.count];
        const double u = drawn_normal(seed), v = drawn_normal(seed);
        fprintf(file, "%.17g, %.17g, %.17g\n", (double)i / NUMBERS, machine.length * (at[0] + 0.01 * largest * u),
                machine.length * (at[1] + 0.01 * largest * v));
    }
    fclose(file);
    largest *= machine.length;
    whirl_orbit_free(orbit);
    machine.release(machine.owner);
    whirl_case_free(object);
    return 0.01 * largest;
}

/// Intervals of 95 % contain the true values, and friction without effect is named, for machines of four kinds. Without
/// WHIRL_SOAK there is one machine of each kind, whose values are within 4 standard errors.
static void recovery(void **unused) {
    (void)unused;
    const size_t machines = getenv("WHIRL_SOAK") ? 13 : 1;
    size_t within = 0, all = 0, named = 0;
    uint64_t seed = 20261129;
    for (size_t k = 0; k < KINDS; k++)
        for (size_t m = 0; m < machines; m++) {
            const recovered *kind = &kinds[k];
            char text[MAX_TEXT], plain[MAX_TEXT];
            whirl_given given[4];
            double truth[3], noise[2];
            whirl_case *object;
            const int length = snprintf(plain, sizeof plain, "whirl: 1\n%sstudy: {response: {}}\n", kind->machine);
            require_ok(whirl_case_parse(plain, (size_t)length, kind->name, NULL, &object));
            for (size_t u = 0; u < 3; u++) {
                require_ok(whirl_case_parameter(object, kind->unknown[u], &truth[u]));
                truth[u] *= 1.0 + 0.1 * (drawn(&seed) - 0.5);
                given[1 + u] = (whirl_given){kind->unknown[u], truth[u]};
            }
            whirl_case_free(object);
            for (size_t i = 0; i < 2; i++) {
                given[0] = (whirl_given){"omega", kind->speeds[i]};
                noise[i] = write_motion(kind, given, i ? "orbit-2.csv" : "orbit-1.csv", &seed);
            }
            snprintf(text, sizeof text,
                     "whirl: 1\n%sstudy:\n  fit:\n    unknown: {%s: , %s: , %s: , mu: {from: 0.01, to: 0.5}}\n"
                     "    revolutions: %d\n    data:\n"
                     "      - {file: orbit-1.csv, at: {omega: %g rad/s}, noise: %.17g m}\n"
                     "      - {file: orbit-2.csv, at: {omega: %g rad/s}, noise: %.17g m}\n",
                     kind->machine, kind->unknown[0], kind->unknown[1], kind->unknown[2], kind->revolutions,
                     kind->speeds[0], noise[0], kind->speeds[1], noise[1]);
            whirl_result *result = fit_of_text(text, 2);
            const double *unknown = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_UNKNOWN, 0);
            const double *outcome = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_FIT_OUTCOME, 0);
            if ((int)outcome[0] != WHIRL_FIT_FOUND) print_error("%s %zu: end %g\n", kind->name, m, outcome[0]);
            assert_int_equal((int)outcome[0], WHIRL_FIT_FOUND);
            for (size_t u = 0; u < 3; u++, all++) {
                const double error = fabs(unknown[8 * u + 2] - truth[u]);
                within += error <= unknown[8 * u + 4];
                if (machines == 1) assert_true(error <= 4.0 * unknown[8 * u + 3]);
            }
            named += (int)unknown[8 * 3 + 7] == WHIRL_FIT_UNKNOWN;
            whirl_result_free(result);
        }
    if (machines == 1) {
        assert_int_equal(named, KINDS);
        return;
    }
    check_within(
        "Fit",
        words("%zu machines of four kinds: 95 %% intervals that contain the true value, %%", (size_t)KINDS * machines),
        94.5, 100.0 * (double)within / (double)all, 4.5);
    check_within("Fit", "of these, machines whose parameter without effect is named, %", 100.0,
                 100.0 * (double)named / (double)(KINDS * machines), 0.0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rubbing_orbits), cmocka_unit_test(closed_forms),
                                       cmocka_unit_test(not_determined), cmocka_unit_test(recovery),
                                       cmocka_unit_test(waveforms),      cmocka_unit_test(noise_by_probe),
                                       cmocka_unit_test(profiles),       cmocka_unit_test(measured_files)};
    return cmocka_run_group_tests_name("fit", tests, fit_make_folder, fit_remove_folder);
}
