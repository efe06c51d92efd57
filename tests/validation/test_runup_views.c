// Run-ups as the analyst sees them: spectra from the last turns, against closed forms, and their figures.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/result.h"

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum { SIZE = 4096 };

/// Runs a disc of 1 kg on a spring of 1 N/m, with an eccentricity of 0.1 m.
static whirl_result *run_disc(const char *rotor, double damping, const char *elements, const char *study) {
    char text[SIZE];
    snprintf(text, sizeof text,
             "whirl: 1\n"
             "rotor:\n"
             "  speed: 2 rad/s\n"
             "%s"
             "  stations:\n"
             "    disc: {mass: 1 kg, damping: %g N.s/m, eccentricity: 0.1 m}\n"
             "  elements:\n"
             "    - spring: {between: [disc, ground], stiffness: 1 N/m}\n"
             "%s"
             "study:\n"
             "  runup: {%s, rtol: 1e-12}\n",
             rotor, damping, elements, study);
    return result_of_text(text);
}

static const double *numbers(const whirl_result *result, const char *field) {
    const double *own = whirl_table_field(&result->tables[0], 0, field, 0);
    assert_non_null(own);
    return own;
}

static size_t rows(const whirl_result *result, const char *field) {
    return whirl_layout_field(&result->tables[0].layout, field)->rows;
}

/// Returns the amplitude of a bin in a spectrum; way: 0 forward, 1 backward.
static double bin_of(const whirl_result *result, size_t spectrum, size_t bin, size_t way) {
    return numbers(
        result,
        WHIRL_FIELD_RUNUP_SPECTRUM)[2 * (spectrum * rows(result, WHIRL_FIELD_RUNUP_SPECTRUM_ORDER) + bin) + way];
}

/// Returns amplitude of the disc under a turning force.
static double response(double damping, double frequency, double force) {
    return force / cabs(1.0 - frequency * frequency + I * damping * frequency);
}

static whirl_figure *figure_of(const whirl_result *result, const char *name) {
    whirl_figure *figure = NULL;
    require_ok(whirl_figure_new(result, name, NULL, &figure));
    return figure;
}

// ---------------------------------------------------------------- spectra

static const char steady[] = "rate: 1e-14 rad/s2, speed_from: 2 rad/s, begin: steady, settle: 200, duration: 200 s, "
                             "rows: 4, spectra: 3";

/// Unbalance, and forces at half the speed and at 1.5 times against it, are lines on bins with the amplitudes of their
/// closed forms, and nothing is elsewhere; in both senses of rotation and all length scales.
static void lines_of_forces(void **state) {
    static const char forces[] = "    - force: {at: disc, amplitude: 0.3 N, ratio: 0.5, law: forward}\n"
                                 "    - force: {at: disc, amplitude: 0.2 N, ratio: 1.5, law: backward}\n";
    static const struct {
        const char *rotor;
        double length;
    } same[] = {{"  length_scale: 1 m\n", 1.0},
                {"  length_scale: 3.7 m\n", 3.7},
                {"  length_scale: 1 m\n  rotation: clockwise\n", 1.0}};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(same); i++) {
        whirl_result *result = run_disc(same[i].rotor, 0.5, forces, steady);
        const struct {
            size_t bin, way;
            double amplitude;
        } lines[] = {
            {8, 0, response(0.5, 1.0, 0.3)}, {16, 0, response(0.5, 2.0, 0.4)}, {24, 1, response(0.5, 3.0, 0.2)}};
        for (size_t k = 0; k < COUNT_OF(lines); k++)
            check_within("Run-up", words("spectrum, case %zu, order %g", i, (double)lines[k].bin / 16.0),
                         lines[k].amplitude, same[i].length * bin_of(result, 2, lines[k].bin, lines[k].way), 1e-9);
        double rest = 0.0;
        for (size_t bin = 0; bin < rows(result, WHIRL_FIELD_RUNUP_SPECTRUM_ORDER); bin++)
            for (size_t way = 0; way < 2; way++) {
                bool line = false; // a line of a Hann window has half its height next to it
                for (size_t k = 0; k < COUNT_OF(lines); k++)
                    line = line || (way == lines[k].way && bin + 1 >= lines[k].bin && bin <= lines[k].bin + 1);
                if (!line) rest = fmax(rest, bin_of(result, 2, bin, way));
            }
        check_within("Run-up", words("spectrum, case %zu, elsewhere", i), 0.0, rest, 1e-9);
        whirl_result_free(result);
    }
}

/// A turn that an event divides is completed: a blade of no weight changes no spectrum.
static void parted_turns(void **state) {
    char study[SIZE / 4];
    (void)state;
    whirl_result *whole = run_disc("  length_scale: 1 m\n", 0.5, "", steady);
    snprintf(study, sizeof study, "%s, loss_at: disc, loss_moment: 1e-15 kg.m, loss_time: 190.3 s", steady);
    whirl_result *parted = run_disc("  length_scale: 1 m\n", 0.5, "", study);
    const size_t all = 2 * 3 * rows(whole, WHIRL_FIELD_RUNUP_SPECTRUM_ORDER);
    double difference = 0.0;
    for (size_t k = 0; k < all; k++)
        difference = fmax(difference, fabs(numbers(whole, WHIRL_FIELD_RUNUP_SPECTRUM)[k] -
                                           numbers(parted, WHIRL_FIELD_RUNUP_SPECTRUM)[k]));
    check_within("Run-up", "an event in a turn, change of spectra", 0.0, difference, 1e-9);
    whirl_result_free(whole);
    whirl_result_free(parted);
}

/// A slow run meets the response at constant speed at every spectrum, nearer at a slower rate; a spectrum changes no
/// other number.
static void slow_run_meets_the_response(void **state) {
    static const double rates[] = {4e-3, 1e-3};
    double misses[COUNT_OF(rates)] = {0.0};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(rates); i++) {
        char study[SIZE / 4];
        snprintf(study, sizeof study,
                 "rate: %g rad/s2, speed_from: 1.5 rad/s, speed_to: 3 rad/s, begin: steady, rows: 30, samples: 32, "
                 "spectra: 10, spectrum_turns: 4",
                 rates[i]);
        whirl_result *result = run_disc("  length_scale: 1 m\n", 0.5, "", study);
        for (size_t k = 0; k < 10; k++) {
            const double speed = numbers(result, WHIRL_FIELD_RUNUP_SPECTRUM_SPEED)[k];
            misses[i] =
                fmax(misses[i], fabs(bin_of(result, k, 4, 0) / response(0.5, speed, 0.1 * speed * speed) - 1.0));
        }
        check_within("Run-up", words("spectra at %g rad/s2, off the response at constant speed", rates[i]), 0.0,
                     misses[i], 2.0 * rates[i]);
        if (i == 0) {
            *strstr(study, ", spectra") = '\0';
            whirl_result *without = run_disc("  length_scale: 1 m\n", 0.5, "", study);
            static const char *const fields[] = {WHIRL_FIELD_RUNUP_AMPLITUDE, WHIRL_FIELD_RUNUP_LAG};
            for (size_t f = 0; f < COUNT_OF(fields); f++)
                check_holds("Run-up", words("the same bits without spectra, %s", fields[f]),
                            memcmp(numbers(result, fields[f]), numbers(without, fields[f]), 30 * 8 * sizeof(double)) ==
                                0);
            assert_null(whirl_table_field(&without->tables[0], 0, WHIRL_FIELD_RUNUP_SPECTRUM, 0));
            whirl_result_free(without);
        }
        whirl_result_free(result);
    }
    check_holds("Run-up", "spectra of a slower run are nearer", misses[1] < 0.5 * misses[0]);
}

/// Spectra before there were as many turns are missing; from rest, too.
static void too_few_turns(void **state) {
    (void)state;
    whirl_result *result = run_disc("  length_scale: 1 m\n", 0.5, "",
                                    "rate: 0.02 rad/s2, duration: 100 s, rows: 10, spectra: 10, spectrum_turns: 8");
    const double *times = numbers(result, WHIRL_FIELD_RUNUP_SPECTRUM_TIME);
    size_t missing = 0;
    while (missing < 10 && isnan(times[missing])) missing++;
    // The angle is 0.01 t^2: 8 turns are complete at 70.9 s.
    check_within("Run-up", "spectra that are missing", 7.0, (double)missing, 0.0);
    check_holds("Run-up", "the others are there", isfinite(times[7]) && isfinite(times[9]));
    whirl_result_free(result);
}

/// Returns the highest point of a line, and writes its place.
static double top_of(const whirl_series *line, double *x) {
    double top = -INFINITY;
    for (size_t k = 0; k < line->count; k++)
        if (line->y[k] > top) top = line->y[k], *x = line->x[k];
    return top;
}

/// Figures have the lines of the closed form at their places: orders over the time, frequencies over the speed,
/// colours.
static void figures_of_spectra(void **state) {
    double at = 0.0;
    (void)state;
    whirl_result *result = run_disc("  length_scale: 1 m\n", 0.5,
                                    "    - force: {at: disc, amplitude: 0.3 N, ratio: 0.5, law: backward}\n", steady);
    whirl_figure *figure = figure_of(result, "runup-waterfall-disc");
    assert_int_equal(figure->panels[0]->count, 3);
    top_of(figure->panels[0]->series[2], &at);
    check_within("Run-up", "waterfall: order of the tallest peak", -0.5, at, 1e-12);
    check_within("Run-up", "waterfall: time of a line", numbers(result, WHIRL_FIELD_RUNUP_SPECTRUM_TIME)[2],
                 figure->panels[0]->series[2]->y[0], 1e-9);
    whirl_figure_free(figure);
    figure = figure_of(result, "runup-cascade-disc");
    top_of(figure->panels[0]->series[2], &at);
    check_within("Run-up", "cascade: frequency of the tallest peak", -1.0 / 6.283185307179586, at, 1e-9);
    whirl_figure_free(figure);
    figure = figure_of(result, "runup-spectrogram-disc");
    const whirl_series *boxes = figure->panels[0]->series[0];
    size_t largest = 0;
    for (size_t k = 0; k < boxes->count; k++)
        if (boxes->values[k] > boxes->values[largest]) largest = k;
    check_within("Run-up", "spectrogram: the largest", response(0.5, 1.0, 0.3), boxes->values[largest], 1e-9);
    check_within("Run-up", "spectrogram: its frequency", -1.0 / 6.283185307179586,
                 0.5 * (boxes->y[largest] + boxes->y_to[largest]), 1e-9);
    whirl_figure_free(figure);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- vectors and mean positions

/// Returns response to the unbalance at a speed, as a vector.
static double complex unbalance_at(double damping, double speed) {
    return 0.1 * speed * speed / (1.0 - speed * speed + I * damping * speed);
}

static const whirl_series *lines_of(const whirl_panel *panel, bool dashed) {
    for (size_t i = 0; i < panel->count; i++)
        if (panel->series[i]->shape == WHIRL_LINE && panel->series[i]->count > 2 && panel->series[i]->dashed == dashed)
            return panel->series[i];
    fail();
    return NULL;
}

/// The vector of a slow run is the response at constant speed, that of y a quarter turn ahead; without slow roll it is
/// less by its vector at that speed, for both senses of rotation.
static void vectors(void **state) {
    static const char *const rotors[] = {"  length_scale: 0.5 m\n", "  length_scale: 1 m\n  rotation: clockwise\n"};
    (void)state;
    for (size_t i = 0; i < COUNT_OF(rotors); i++) {
        whirl_result *result = run_disc(
            rotors[i], 0.5, "",
            "rate: 4e-4 rad/s2, speed_from: 0.3 rad/s, speed_to: 2 rad/s, begin: steady, samples: 32, rows: 60, "
            "slow_roll: 0.4 rad/s");
        whirl_figure *figure = figure_of(result, "runup-polar-disc");
        const double *speeds = numbers(result, WHIRL_FIELD_RUNUP_SPEED);
        const double complex roll = unbalance_at(0.5, 0.4);
        double misses[3] = {0.0};
        for (size_t axis = 0; axis < 2; axis++)
            for (int raw = 0; raw < 2; raw++) {
                const whirl_series *line = lines_of(figure->panels[axis], raw);
                assert_int_equal(line->count, 60);
                for (size_t row = 0; row < 60; row++) {
                    const double complex expected = unbalance_at(0.5, speeds[row]) - (raw ? 0.0 : roll);
                    // A rotor that turns from y to x has y behind x.
                    const double complex turned = axis == 0 || i == 0 ? 1.0 : -1.0;
                    misses[raw] = fmax(misses[raw], cabs(line->x[row] + I * line->y[row] - turned * expected));
                }
            }
        check_within("Run-up", words("vectors, case %zu, off the response", i), 0.0, misses[1], 2e-3);
        check_within("Run-up", words("vectors less slow roll, case %zu", i), 0.0, misses[0], 2e-3);
        whirl_figure_free(figure);
        whirl_result_free(result);
    }
}

/// A speed next to the critical one is no slow roll: nothing is subtracted, and a statement says so.
static void no_slow_roll(void **state) {
    (void)state;
    whirl_result *result = run_disc("  length_scale: 1 m\n", 0.2, "",
                                    "rate: 1e-3 rad/s2, speed_from: 0.3 rad/s, speed_to: 2 rad/s, begin: steady, "
                                    "samples: 32, rows: 100, slow_roll: 0.95 rad/s");
    const double complex low = unbalance_at(0.2, 0.855), roll = unbalance_at(0.2, 0.95),
                         high = unbalance_at(0.2, 1.045);
    double largest = 0.0;
    for (double w = 0.9; w < 1.1; w += 1e-4) largest = fmax(largest, cabs(unbalance_at(0.2, w)));
    check_within("Run-up", "change of what is no slow roll", fmax(cabs(low - roll), cabs(high - roll)) / largest,
                 *numbers(result, WHIRL_FIELD_RUNUP_SLOW_ROLL_CHANGE), 0.05);
    check_holds("Run-up", "nothing is subtracted", isnan(numbers(result, WHIRL_FIELD_RUNUP_COMPENSATED)[100]));
    whirl_result_free(result);
}

/// The mean position is the weight over the stiffness; a journal lies within the wall of its clearance.
static void mean_positions(void **state) {
    (void)state;
    whirl_result *result =
        run_disc("  length_scale: 0.2 m\n", 0.5, "    - gravity: 0.3 m/s2\n",
                 "rate: 1e-3 rad/s2, speed_from: 1 rad/s, speed_to: 1.1 rad/s, begin: steady, rows: 5");
    whirl_figure *figure = figure_of(result, "runup-centreline-disc");
    const whirl_series *line = lines_of(figure->panels[0], false);
    assert_int_equal(line->count, 5);
    for (size_t row = 0; row < 5; row++)
        check_within("Run-up", words("mean position, row %zu", row), 0.3, -line->y[row], 1e-3);
    whirl_figure_free(figure);
    whirl_result_free(result);
    result = result_of_text("whirl: 1\n"
                            "rotor:\n"
                            "  speed: 3000 rpm\n"
                            "  length_scale: 0.1 mm\n"
                            "  stations:\n"
                            "    disc: {mass: 4 kg, eccentricity: 1 um}\n"
                            "  elements:\n"
                            "    - film: {at: disc, law: short, clearance: 0.1 mm, radius: 30 mm, length: 15 mm, "
                            "viscosity: 20 mPa.s}\n"
                            "    - gravity: 9.81 m/s2\n"
                            "study:\n"
                            "  runup: {rate: 100 rad/s2, speed_from: 300 rad/s, duration: 0.5 s, rows: 5}\n");
    figure = figure_of(result, "runup-centreline-disc");
    const whirl_series *wall = lines_of(figure->panels[0], false);
    check_within("Run-up", "wall of the journal, mm", 0.1, hypot(wall->x[3], wall->y[3]), 1e-9);
    whirl_figure_free(figure);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- orbits and waveforms

/// Orbits and waveforms of a steady motion are Re(U e^(i theta)), from the mark on; the event lies in its waveform.
static void motions_in_time(void **state) {
    enum { SAMPLES = 64, TURNS = 6 };
    (void)state;
    char study[SIZE / 4];
    snprintf(study, sizeof study,
             "%s, samples: %d, orbits: 4, waveform: %d, loss_at: disc, loss_moment: 1e-15 kg.m, loss_time: "
             "100.3 s",
             steady, SAMPLES, TURNS);
    whirl_result *result = run_disc("  length_scale: 0.5 m\n", 0.5, "", study);
    const double complex response_at = unbalance_at(0.5, 2.0);
    const double *orbit = numbers(result, WHIRL_FIELD_RUNUP_ORBIT) + 2 * 3 * SAMPLES;
    const double *times = numbers(result, WHIRL_FIELD_RUNUP_WAVEFORM_TIME) + TURNS * SAMPLES;
    const double *motion = numbers(result, WHIRL_FIELD_RUNUP_WAVEFORM) + 2 * TURNS * SAMPLES;
    double misses[2] = {0.0};
    for (size_t k = 0; k < SAMPLES; k++) {
        const double complex z = response_at * cexp(I * 6.283185307179586 * (double)k / SAMPLES);
        misses[0] = fmax(misses[0], cabs(0.5 * (orbit[2 * k] + I * orbit[2 * k + 1]) - z));
    }
    for (size_t k = 0; k < TURNS * SAMPLES; k++) {
        const double complex z = response_at * cexp(I * 2.0 * times[k]);
        misses[1] = fmax(misses[1], cabs(0.5 * (motion[2 * k] + I * motion[2 * k + 1]) - z));
    }
    check_within("Run-up", "orbit, off the closed form", 0.0, misses[0], 1e-9);
    check_within("Run-up", "waveform around an event, off the closed form", 0.0, misses[1], 1e-7);
    check_holds("Run-up", "the event is in the middle of its waveform",
                times[2 * SAMPLES] < 100.3 && times[4 * SAMPLES] > 100.3);
    check_holds("Run-up", "there is one event", isnan(times[TURNS * SAMPLES]));
    whirl_figure *figure = figure_of(result, "runup-orbit-disc");
    assert_int_equal(figure->count, 5);
    const whirl_series *line = lines_of(figure->panels[3], false);
    check_within("Run-up", "figure: radius of the orbit", cabs(response_at), hypot(line->x[7], line->y[7]), 1e-9);
    whirl_figure_free(figure);
    figure = figure_of(result, "runup-waveform-disc");
    assert_int_equal(figure->count, 2);
    assert_string_equal(figure->panels[1]->title, "around event 1");
    check_within("Run-up", "figure: time of an instant", times[100], figure->panels[1]->series[0]->x[100], 1e-12);
    whirl_figure_free(figure);
    whirl_result_free(result);
}

/// The waveform of a rub has the force of its law at every gap, and the largest force and motion of the run within it.
static void forces_and_gaps(void **state) {
    enum { INSTANTS = 8 * 128 };
    (void)state;
    whirl_result *result = run_disc("  length_scale: 1 m\n", 0.1,
                                    "    - rub: {at: disc, gap: 0.4 m, stiffness: 3 N/m, friction: 0.05, law: paper}\n",
                                    "rate: 0.003 rad/s2, duration: 600 s, orbits: 1, waveform: 8");
    const double *times = numbers(result, WHIRL_FIELD_RUNUP_CONTACT_TIME);
    const double *forces = numbers(result, WHIRL_FIELD_RUNUP_CONTACT_FORCE);
    const double *gaps = numbers(result, WHIRL_FIELD_RUNUP_CONTACT_GAP);
    const double *rows_of_force = numbers(result, WHIRL_FIELD_RUNUP_FORCE);
    const double *peak = numbers(result, WHIRL_FIELD_RUNUP_PEAK_ORBIT);
    double miss = 0.0, largest[2] = {0.0}, radius = 0.0;
    for (size_t k = 0; k < INSTANTS; k++) {
        assert_true(isfinite(times[k]) && (k == 0 || times[k] > times[k - 1]));
        miss = fmax(miss, fabs(forces[k] - 3.0 * fmax(0.0, -gaps[k])));
        largest[0] = fmax(largest[0], forces[k]);
    }
    for (size_t row = 0; row < 400; row++) largest[1] = fmax(largest[1], rows_of_force[row]);
    for (size_t k = 0; k < 128; k++) radius = fmax(radius, hypot(peak[2 * k], peak[2 * k + 1]));
    check_within("Run-up", "force of a rub, off its law", 0.0, miss, 1e-12);
    check_within("Run-up", "largest force of the run in its waveform", largest[1], largest[0], 0.0);
    check_within("Run-up", "largest motion of the run in its orbit", *numbers(result, WHIRL_FIELD_RUNUP_PEAK), radius,
                 1e-3);
    whirl_figure *figure = figure_of(result, "runup-contact-rub-at-disc");
    assert_int_equal(figure->count, 2);
    check_within("Run-up", "figure: force", forces[300], figure->panels[0]->series[0]->y[300], 1e-12);
    check_within("Run-up", "figure: gap", gaps[300], figure->panels[1]->series[0]->y[300], 1e-12);
    whirl_figure_free(figure);
    whirl_result_free(result);
}

/// Returns the derivative of numbers at equal distances, of the order 4, at index k with two neighbours on either side.
static double slope_of(const double *at, size_t k, double step) {
    return (8.0 * (at[k + 1] - at[k - 1]) - (at[k + 2] - at[k - 2])) / (12.0 * step);
}

/// Within a turn of a rub that a motor drives: torques of motor and load are those of their laws at the speed of the
/// instant, friction is the radius times its share of the force, and all torques together accelerate the inertia.
static void torques_within_a_turn(void **state) {
    enum { SAMPLES = 256, ORBITS = 40 };
    static const double turn = 6.283185307179586, inertia = 3.0, radius = 0.7, friction = 0.05;
    (void)state;
    char study[SIZE / 4];
    snprintf(study, sizeof study, "duration: 100 s, samples: %d, orbits: %d", SAMPLES, ORBITS);
    whirl_result *result = run_disc("  length_scale: 0.5 m\n", 0.1,
                                    "    - rub: {at: disc, gap: 0.12 m, stiffness: 3 N/m, friction: 0.05, law: paper, "
                                    "radius: 0.7 m}\n"
                                    "    - gravity: 0.2 m/s2\n"
                                    "    - drive: {inertia: 3 kg.m2, torque: 0.2 N.m, no_load_speed: 2 rad/s, "
                                    "load_quadratic: 0.01 N.m.s2}\n",
                                    study);
    const double *instants = numbers(result, WHIRL_FIELD_RUNUP_ORBIT_INSTANT);
    const double *torques = numbers(result, WHIRL_FIELD_RUNUP_ORBIT_TORQUE);
    const double *forces = numbers(result, WHIRL_FIELD_RUNUP_ORBIT_FORCE);
    const double *gaps = numbers(result, WHIRL_FIELD_RUNUP_ORBIT_GAP);
    const double *orbits = numbers(result, WHIRL_FIELD_RUNUP_ORBIT);
    double miss[5] = {0.0}, largest = 0.0, varies = 0.0;
    size_t turns = 0, closed = 0;
    for (size_t orbit = 0; orbit < ORBITS; orbit++) {
        const size_t first = orbit * SAMPLES;
        double speed[SAMPLES], least = INFINITY, most = -INFINITY;
        // The first turn, from standstill, has samples too far apart for differences.
        if (isnan(instants[first]) || numbers(result, WHIRL_FIELD_RUNUP_ORBIT_SPEED)[orbit] < 0.5) continue;
        turns++;
        for (size_t k = 2; k + 2 < SAMPLES; k++) speed[k] = 1.0 / slope_of(instants + first, k, turn / SAMPLES);
        for (size_t k = 4; k + 4 < SAMPLES; k++) {
            const double *own = torques + 5 * (first + k), force = forces[first + k];
            const double *at = orbits + 2 * (first + k);
            const double acceleration = speed[k] * slope_of(speed, k, turn / SAMPLES);
            const bool smooth = (gaps[first + k - 4] > 0.0) == (gaps[first + k + 4] > 0.0);
            closed += force > 0.0;
            largest = fmax(largest, fabs(own[2]));
            least = fmin(least, own[3]), most = fmax(most, own[3]);
            miss[0] = fmax(miss[0], fabs(own[0] - 0.2 * (1.0 - speed[k] / 2.0)));
            miss[1] = fmax(miss[1], fabs(own[1] + 0.01 * speed[k] * speed[k]));
            miss[2] = fmax(miss[2], fabs(own[2] + radius * friction * force));
            miss[3] = fmax(miss[3], fabs(0.5 * hypot(at[0], at[1]) + 0.5 * gaps[first + k] - 0.12));
            if (smooth)
                miss[4] = fmax(miss[4], fabs(own[0] + own[1] + own[2] + own[3] + own[4] - inertia * acceleration));
        }
        varies = fmax(varies, most - least);
    }
    check_holds("Run-up", "turns within which torques are compared", turns > 10 && closed > SAMPLES);
    check_holds("Run-up", "torques change within a turn", varies > 0.01 && largest > 1e-3);
    check_within("Run-up", "torque of the motor within a turn, off its law", 0.0, miss[0], 1e-7);
    check_within("Run-up", "torque of the load within a turn, off its law", 0.0, miss[1], 1e-7);
    check_within("Run-up", "torque of friction within a turn, off its force", 0.0, miss[2], 1e-12);
    check_within("Run-up", "gap within a turn, off the orbit", 0.0, miss[3], 1e-12);
    check_within("Run-up", "torques within a turn, off inertia times acceleration", 0.0, miss[4], 1e-6);
    // The figure shows the numbers of the turn nearest to a time.
    size_t nearest = 0;
    const double *times = numbers(result, WHIRL_FIELD_RUNUP_ORBIT_TIME);
    for (size_t k = 0; k < ORBITS; k++)
        if (isfinite(times[k]) && !(fabs(times[nearest] - 60.0) <= fabs(times[k] - 60.0))) nearest = k;
    whirl_figure *figure = figure_of(result, "runup-turn-disc@60 s");
    assert_int_equal(figure->count, 5);
    assert_string_equal(figure->panels[4]->name, "torque");
    check_within("Run-up", "figure of a turn: motion, m", 0.5 * orbits[2 * (nearest * SAMPLES + 100)],
                 figure->panels[1]->series[0]->y[100], 1e-12);
    check_within("Run-up", "figure of a turn: torque of the motor", torques[5 * (nearest * SAMPLES + 100)],
                 figure->panels[4]->series[0]->y[100], 1e-12);
    whirl_figure_free(figure);
    require_ok(whirl_figure_new(result, "runup-turn-disc", NULL, &figure));
    whirl_figure_free(figure);
    assert_int_equal(whirl_figure_new(result, "runup-turn-disc@101 s", NULL, &figure).code, WHIRL_BAD_INPUT);
    assert_int_equal(whirl_figure_new(result, "runup-turn-fan@60 s", NULL, &figure).code, WHIRL_BAD_INPUT);
    assert_int_equal(whirl_figure_new(result, "runup-turn-disc@60 m", NULL, &figure).code, WHIRL_BAD_INPUT);
    whirl_result_free(result);
}

/// A run-up over the time shows the same orbits, waveforms and spectra as one over the angle.
static void by_time_and_by_angle(void **state) {
    static const char drive[] = "    - drive: {inertia: 2000 kg.m2, torque: 40 N.m, no_load_speed: 2 rad/s}\n";
    static const char *const fields[] = {WHIRL_FIELD_RUNUP_SPECTRUM, WHIRL_FIELD_RUNUP_ORBIT,
                                         WHIRL_FIELD_RUNUP_SPECTRUM_TIME, WHIRL_FIELD_RUNUP_ORBIT_INSTANT};
    char elements[SIZE / 4];
    (void)state;
    snprintf(elements, sizeof elements, "%s    - timed_torque: {times: [0 s, 500 s], torques: [0 N.m, 0 N.m]}\n",
             drive);
    const char *const study = "duration: 200 s, spectra: 4, spectrum_turns: 4, orbits: 4";
    whirl_result *angle = run_disc("  length_scale: 1 m\n", 0.1, drive, study);
    whirl_result *time = run_disc("  length_scale: 1 m\n", 0.1, elements, study);
    for (size_t f = 0; f < COUNT_OF(fields); f++) {
        const whirl_field *field = whirl_layout_field(&angle->tables[0].layout, fields[f]);
        double difference = 0.0;
        size_t compared = 0;
        for (size_t k = 0; k < field->rows * field->columns; k++) {
            const double one = numbers(angle, fields[f])[k], other = numbers(time, fields[f])[k];
            if (isnan(one)) continue;
            difference = fmax(difference, isnan(other) ? INFINITY : fabs(one - other));
            compared++;
        }
        assert_true(compared > 1);
        check_within("Run-up", words("by time and by angle: %s", fields[f]), 0.0, difference, 1e-6);
    }
    whirl_result_free(angle);
    whirl_result_free(time);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(lines_of_forces),
                                       cmocka_unit_test(parted_turns),
                                       cmocka_unit_test(slow_run_meets_the_response),
                                       cmocka_unit_test(too_few_turns),
                                       cmocka_unit_test(figures_of_spectra),
                                       cmocka_unit_test(vectors),
                                       cmocka_unit_test(no_slow_roll),
                                       cmocka_unit_test(mean_positions),
                                       cmocka_unit_test(motions_in_time),
                                       cmocka_unit_test(forces_and_gaps),
                                       cmocka_unit_test(torques_within_a_turn),
                                       cmocka_unit_test(by_time_and_by_angle)};
    return cmocka_run_group_tests_name("views of run-ups", tests, NULL, NULL);
}
