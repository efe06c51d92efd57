// The ten points of the 2015 paper's rotor, calibrated reading, that are known from two other programs (fixed and
// adaptive steps): regime, largest exponent, extremes, lines and rub. The study of cases/paper-point.yaml for each.
//
// Numbers of periodic and quasi-periodic motions are compared to the printed digits. Extremes, shares and broad
// lines of a chaotic record differ from record to record: `scatter` is the standard deviation over twelve records of
// 6000 revolutions that another program computed from the same equations, and three of it are allowed.
//
// Some printed amplitudes of lines that fall between bins are low by 6 percent (and one, .011, is rounded the wrong
// way). For these the printed number is only logged; `sharp` is the other program's Fourier sum at the line itself.
// WHIRL_SOAK: twice the steps, too, at this length (test_readings.c confirms the same points in shorter records).
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
#include "support_study.h"
#include "whirl/internal/spectrum.h"

enum { POINTS = 10, DISC = 0, JOURNAL = 1, MAX_KNOWN_LINES = 4 };

/// A line of the disc's x: order and amplitude as printed.
typedef struct known_line {
    const char *order, *amplitude;
    const char *sharp; ///< amplitude by the other program where the printed one is contradicted
    double scatter;    ///< of the amplitude in a chaotic motion
} known_line;

typedef struct known_point {
    double r_k;
    const char *regime;
    double exponent, error; ///< per revolution, standard error
    const char *max_radius, *max_eccentricity;
    double radius_scatter, eccentricity_scatter;
    const char *rub_share; ///< percent of the time; NULL where not stated, "0" where nothing touches
    double rub_scatter;
    known_line lines[MAX_KNOWN_LINES];
    double low_order, high_order; ///< between which the largest line below 0.9X of a broad spectrum lies, else 0
} known_point;

#define LINE(order, amplitude)                                                                                         \
    { order, amplitude, NULL, 0.0 }
#define SHARP_LINE(order, amplitude, sharp)                                                                            \
    { order, amplitude, sharp, 0.0 }
#define BROAD_LINE(order, amplitude, scatter)                                                                          \
    { order, amplitude, NULL, scatter }

static const known_point known[POINTS] = {
    {.r_k = 1.00,
     .regime = "P-1",
     .exponent = -0.1504,
     .error = 0.0004,
     .max_radius = "1.1274",
     .max_eccentricity = ".9573",
     .rub_share = "0",
     .lines = {LINE("1", ".0600"), LINE("2", ".0012")}},
    {.r_k = 0.60,
     .regime = "P-1",
     .exponent = -0.1650,
     .error = 0.0005,
     .max_radius = "1.1535",
     .max_eccentricity = ".9567",
     .rub_share = "0",
     .lines = {LINE("1", ".0587"), LINE("3", ".0064")}},
    {.r_k = 0.48,
     .regime = "quasi-periodic (1 curve)",
     .exponent = 0.0001,
     .error = 0.0007,
     .max_radius = "1.1897",
     .max_eccentricity = ".9589",
     .rub_share = "0",
     .lines = {SHARP_LINE(".412", ".070", ".07426"), LINE("1", ".053"), SHARP_LINE(".588", ".033", ".03483"),
               LINE("3", ".013")}},
    {.r_k = 0.46,
     .regime = "quasi-periodic (1 curve)",
     .exponent = -0.0002,
     .error = 0.0006,
     .max_radius = "1.1915",
     .max_eccentricity = ".9593",
     .rub_share = "0",
     .lines = {SHARP_LINE(".427", ".082", ".08758"), LINE("1", ".051"), SHARP_LINE(".573", ".043", ".04573")}},
    {.r_k = 0.45,
     .regime = "chaotic",
     .exponent = 0.043,
     .error = 0.003,
     .max_radius = "1.1991",
     .max_eccentricity = ".9606",
     .rub_share = "0",
     .radius_scatter = 7e-5,
     .eccentricity_scatter = 1e-5,
     .lines = {BROAD_LINE(".432", ".076", 9e-4), LINE("1", ".051"), BROAD_LINE(".568", ".041", 5e-4)}},
    {.r_k = 0.44,
     .regime = "chaotic",
     .exponent = 0.022,
     .error = 0.002,
     .max_radius = "1.2015",
     .max_eccentricity = ".9616",
     .radius_scatter = 3.6e-4,
     .eccentricity_scatter = 3e-5,
     .lines = {LINE("1", ".050")}},
    {.r_k = 0.40,
     .regime = "P-2",
     .exponent = -0.1173,
     .error = 0.0001,
     .max_radius = "1.1926",
     .max_eccentricity = ".9606",
     .rub_share = "0",
     .lines = {LINE(".5", ".071"), LINE("1", ".049"), LINE("3", ".016"), SHARP_LINE("1.5", ".011", ".010478")}},
    {.r_k = 0.35,
     .regime = "P-4",
     .exponent = -0.0585,
     .error = 0.0001,
     .max_radius = "1.2056",
     .max_eccentricity = ".9616",
     .rub_share = "1.1",
     .lines = {LINE(".5", ".078"), LINE("1", ".045"), LINE(".25", ".033")}},
    {.r_k = 0.25,
     .regime = "chaotic",
     .exponent = 0.464,
     .error = 0.005,
     .max_radius = "1.275",
     .max_eccentricity = ".971",
     .rub_share = "3.9",
     .radius_scatter = 4.1e-3,
     .eccentricity_scatter = 3.1e-4,
     .rub_scatter = 0.092,
     .low_order = 0.38,
     .high_order = 0.46},
    {.r_k = 0.15,
     .regime = "chaotic",
     .exponent = 0.557,
     .error = 0.005,
     .max_radius = "1.289",
     .max_eccentricity = ".974",
     .rub_share = "4.2",
     .radius_scatter = 1.7e-3,
     .eccentricity_scatter = 4.8e-4,
     .rub_scatter = 0.055,
     .low_order = 0.38,
     .high_order = 0.44},
};

static bool soaking(void) {
    return getenv("WHIRL_SOAK") != NULL;
}

static void vary_ratio(whirl_batch *batch, const void *context) {
    (void)context;
    strcpy(batch->parameter, "r_k");
    batch->confirm = soaking();
    assert_true(whirl_analysis_add(&batch->analyses, "winding"));
}

/// Runs the study of the case file with r_k over all points.
static whirl_result *run_points(void) {
    double values[POINTS];
    for (int i = 0; i < POINTS; i++) values[i] = known[i].r_k;
    return run_case_at("paper-point", 1, values, POINTS, vary_ratio, NULL);
}

/// Returns the line of the disc's x whose order is nearest.
static const double *nearest_line(const whirl_table *table, size_t point, double order) {
    const double *lines = whirl_table_field(table, point, "spectrum/lines", DISC), *best = lines;
    assert_non_null(lines);
    for (int i = 0; i < WHIRL_MAX_LINES; i++)
        if (fabs(lines[5 * i] - order) < fabs(best[0] - order)) best = lines + 5 * i;
    return best;
}

/// Returns the order of the largest line of x below 0.9X.
static double largest_subharmonic(const whirl_table *table, size_t point) {
    const double *lines = whirl_table_field(table, point, "spectrum/lines", DISC);
    double order = 0.0, amplitude = 0.0;
    assert_non_null(lines);
    for (int i = 0; i < WHIRL_MAX_LINES; i++)
        if (lines[5 * i] < 0.9 && lines[5 * i + 1] > amplitude) {
            order = lines[5 * i];
            amplitude = lines[5 * i + 1];
        }
    return order;
}

/// Checks numbers to the printed digits, or to three times the scatter of a chaotic motion.
static void check_scattered(const char *what, const char *digits, double scatter, double obtained) {
    if (scatter == 0.0)
        check_digits("model", what, digits, obtained);
    else
        check_within("model", what, strtod(digits, NULL), obtained, hypot(half_unit(digits), 3.0 * scatter));
}

static void check_line(const whirl_table *table, size_t point, const known_line *line) {
    const double *found = nearest_line(table, point, strtod(line->order, NULL));
    const char *name = words("r_k = %.2f, line at %sX", known[point].r_k, line->order);
    check_within("model", words("%s: order", name), strtod(line->order, NULL), found[0], 5e-4);
    const char *amplitude = words("%s: amplitude of x", name);
    if (line->sharp) {
        note_within("model", amplitude, strtod(line->amplitude, NULL), found[1], half_unit(line->amplitude));
        check_digits("model", words("%s by another program", amplitude), line->sharp, found[1]);
    } else {
        check_scattered(amplitude, line->amplitude, line->scatter, found[1]);
    }
}

static void check_spectrum(const whirl_table *table, size_t point) {
    const known_point *k = &known[point];
    for (int i = 0; i < MAX_KNOWN_LINES && k->lines[i].order; i++) check_line(table, point, &k->lines[i]);
    if (k->high_order > 0.0) {
        const double order = largest_subharmonic(table, point);
        check_holds(
            "model",
            words("r_k = %.2f, largest line below 0.9X between %.2fX and %.2fX", k->r_k, k->low_order, k->high_order),
            order > k->low_order && order < k->high_order);
    }
}

/// Writes a number for which no value is known beforehand.
static void put_evidence(double r_k, const char *what, double value) {
    if (!isnan(value)) printf("evidence | r_k = %.2f, %s | - | %.4g | - | -\n", r_k, what, value);
}

/// Checks the evidence for the verdict other than the exponent.
static void check_evidence(const whirl_table *table, size_t point, const whirl_verdict *verdict) {
    const known_point *k = &known[point];
    char name[64];
    whirl_verdict_name(verdict, name, sizeof name);
    printf("evidence | r_k = %.2f, verdict and confidence | %s | %s, %s | - | -\n", k->r_k, k->regime, name,
           whirl_confidence_name(verdict->confidence));
    if (soaking())
        check_holds("evidence", words("r_k = %.2f, twice the steps give the same verdict", k->r_k),
                    verdict->confirmed && verdict->other_regime == verdict->regime &&
                        verdict->other_period == verdict->period);
    put_evidence(k->r_k, "distance of returns over the size of the motion", verdict->recurrence);
    put_evidence(k->r_k, "digits to which averages of two halves agree", verdict->regularity);
    put_evidence(k->r_k, "K of the 0-1 test", verdict->chaos);
    put_evidence(k->r_k, "largest correlation of points 1/8 to 1/4 of the watched ones apart",
                 table_number(table, point, "evidence/correlation", 0));
    put_evidence(k->r_k, "turns of the disc round its mean position a revolution",
                 table_number(table, point, "winding/winding", DISC));
    if (verdict->regime == WHIRL_QUASI_PERIODIC)
        check_within("evidence", words("r_k = %.2f, rotation number against the printed line", k->r_k),
                     strtod(k->lines[0].order, NULL), verdict->rotation, 5e-4);
    if (verdict->regime == WHIRL_PERIODIC) {
        const double modulus = exp(k->exponent * verdict->period);
        const double error = 3.0 * hypot(k->error, table_number(table, point, "lyapunov/error", 0));
        check_within("evidence", words("r_k = %.2f, modulus of the largest multiplier", k->r_k), modulus,
                     table_number(table, point, "evidence/modulus", 0), modulus * expm1(error * verdict->period));
    }
}

static void check_point(const whirl_table *table, size_t point) {
    const known_point *k = &known[point];
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    char name[64];
    whirl_verdict_name(&verdict, name, sizeof name);
    check_text("model", words("r_k = %.2f, regime", k->r_k), k->regime, name);
    check_evidence(table, point, &verdict);
    const double error = table_number(table, point, "lyapunov/error", 0);
    check_within("model", words("r_k = %.2f, largest exponent per revolution", k->r_k), k->exponent,
                 table_number(table, point, "lyapunov/largest", 0), 3.0 * hypot(k->error, error));
    check_scattered(words("r_k = %.2f, max r1", k->r_k), k->max_radius, k->radius_scatter,
                    table_number(table, point, "orbit/max_radius", DISC));
    check_scattered(words("r_k = %.2f, max e", k->r_k), k->max_eccentricity, k->eccentricity_scatter,
                    table_number(table, point, "orbit/eccentricity", JOURNAL));
    if (k->rub_share) {
        const char *what = words("r_k = %.2f, share of rub, percent", k->r_k);
        const double share = 100.0 * table_number(table, point, "rub/share", 0);
        if (strcmp(k->rub_share, "0") == 0)
            check_within("model", what, 0.0, share, 0.0);
        else
            check_scattered(what, k->rub_share, k->rub_scatter, share);
    }
    check_spectrum(table, point);
}

/// The points are computed once, before all tests.
static int compute(void **state) {
    *state = run_points();
    return 0;
}

static int discard(void **state) {
    whirl_result_free(*state);
    return 0;
}

static void check_range(const whirl_result *result, size_t first, size_t last) {
    const whirl_table *table = &result->tables[0];
    assert_int_equal(POINTS, table->count);
    for (size_t i = first; i <= last; i++) check_point(table, i);
}

static void simple_motion(void **state) {
    check_range(*state, 0, 1);
}
static void quasi_periodic_motion(void **state) {
    check_range(*state, 2, 3);
}
static void weak_chaos(void **state) {
    check_range(*state, 4, 5);
}
static void subharmonic_motion(void **state) {
    check_range(*state, 6, 7);
}
static void chaos_with_rub(void **state) {
    check_range(*state, 8, 9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(simple_motion),      cmocka_unit_test(quasi_periodic_motion), cmocka_unit_test(weak_chaos),
        cmocka_unit_test(subharmonic_motion), cmocka_unit_test(chaos_with_rub),
    };
    return cmocka_run_group_tests(tests, compute, discard);
}
