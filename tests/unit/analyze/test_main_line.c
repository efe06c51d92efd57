// Lines of motions whose lines are known: two frequencies, a third one, lines that die out, grow and wander; and
// verdicts that use lines where sections are too short to show their curve.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "main_line.h"
#include "section.h"
#include "whirl/engine/analyze.h"

enum { SAMPLES = 64, DIMENSION = 4, MAX_REVOLUTIONS = 128 };

static const double two_pi = 6.283185307179586476925;

/// x + iy = e^(i tau) + line e^(growth n) e^(i phase) + a combination of both + third e^(i third phase); phases turn at
/// their orders, plus their wander times the revolutions n.
typedef struct known_lines {
    double order, line, growth, wander, third, third_order, third_wander;
} known_lines;

/// Computes x, y, vx and vy (displacements and their rates) after n revolutions.
static void lines_at(const known_lines *of, double n, double out[DIMENSION]) {
    const double phases[] = {two_pi * n, two_pi * n * (of->order + 0.5 * of->wander * n),
                             two_pi * n * (2.0 * of->order - 1.0 + of->wander * n),
                             two_pi * n * (of->third_order + 0.5 * of->third_wander * n)};
    const double rates[] = {1.0, of->order + of->wander * n, 2.0 * of->order - 1.0 + 2.0 * of->wander * n,
                            of->third_order + of->third_wander * n};
    const double grown = of->line * exp(of->growth * n), amplitudes[] = {1.0, grown, 0.1 * grown, of->third};
    for (size_t i = 0; i < DIMENSION; i++) out[i] = 0.0;
    for (size_t k = 0; k < 4; k++) {
        out[0] += amplitudes[k] * cos(phases[k]);
        out[1] += amplitudes[k] * sin(phases[k]);
        out[2] -= amplitudes[k] * rates[k] * sin(phases[k]);
        out[3] += amplitudes[k] * rates[k] * cos(phases[k]);
    }
}

/// A record of up to MAX_REVOLUTIONS, and its arrays.
typedef struct known_record {
    whirl_probe probe;
    whirl_record record;
    double waveform[2 * MAX_REVOLUTIONS * SAMPLES], section[DIMENSION * MAX_REVOLUTIONS], growth[MAX_REVOLUTIONS],
        low[DIMENSION], high[DIMENSION];
} known_record;

static known_record *record_lines(const known_lines *of, size_t revolutions) {
    known_record *r = calloc(1, sizeof *r);
    assert_non_null(r);
    assert_true(revolutions <= MAX_REVOLUTIONS);
    const size_t count = revolutions * SAMPLES;
    r->probe = (whirl_probe){.name = "disc", .x = 0, .y = 1, .vx = 2, .vy = 3};
    for (size_t i = 0; i < DIMENSION; i++) r->low[i] = INFINITY, r->high[i] = -INFINITY;
    for (size_t j = 0; j < count; j++) {
        double x[DIMENSION];
        lines_at(of, (double)(j + 1) / SAMPLES, x);
        r->waveform[j] = x[0];
        r->waveform[count + j] = x[1];
        for (size_t i = 0; i < DIMENSION; i++) r->low[i] = fmin(r->low[i], x[i]), r->high[i] = fmax(r->high[i], x[i]);
        if ((j + 1) % SAMPLES == 0) memcpy(r->section + DIMENSION * ((j + 1) / SAMPLES - 1), x, sizeof x);
    }
    for (size_t n = 0; n < revolutions; n++) r->growth[n] = of->growth + 1e-4 * cos(2.0 * (double)n);
    r->record = (whirl_record){.dimension = DIMENSION,
                               .record_count = revolutions,
                               .section_count = revolutions,
                               .growth_count = revolutions,
                               .section = r->section,
                               .growth = r->growth,
                               .low = r->low,
                               .high = r->high,
                               .probe_count = 1,
                               .probes = &r->probe,
                               .samples_per_revolution = SAMPLES,
                               .sample_count = count,
                               .waveform = r->waveform};
    return r;
}

enum { REVOLUTIONS = 64 };
static const double golden = 0.381966011250105;

static void two_frequencies(void **state) {
    static const double orders[] = {0.381966011250105, 0.4494897427831781, 0.5857864376269049, 2.618033988749895};
    (void)state;
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
        known_record *r = record_lines(&(known_lines){.order = orders[i], .line = 0.7}, REVOLUTIONS);
        const main_line found = main_line_find(&r->record);
        printf("lines | order of a whirl at %.6f | %.9f | %.9f | %.1e | 1e-6\n", orders[i], orders[i], found.order,
               fabs(found.order - orders[i]));
        assert_true(fabs(found.order - orders[i]) < 1e-6);
        assert_true(fabs(found.trend) < 1e-8 && fabs(found.drift) < 1e-6);
        assert_true(found.frequencies == 2 && main_line_stays(&found, &r->record));
        free(r);
    }
}

/// A third frequency counts if its line is a hundredth of the largest or more. A line that wanders by 0.4 bins is not
/// constant.
static void a_third_frequency(void **state) {
    static const struct {
        double size, wander;
        int frequencies; ///< 0: any number
        bool stays;
    } thirds[] = {{0.005, 0.0, 2, true}, {0.005, 2e-4, 2, true}, {0.02, 0.0, 3, true},
                  {0.1, 0.0, 3, true},   {0.02, 2e-4, 0, false}, {0.1, 2e-4, 0, false}};
    static const double order = 0.63;
    (void)state;
    for (size_t i = 0; i < sizeof thirds / sizeof *thirds; i++) {
        const known_lines of = {.order = golden,
                                .line = 0.7,
                                .third = thirds[i].size,
                                .third_order = order,
                                .third_wander = thirds[i].wander};
        known_record *r = record_lines(&of, REVOLUTIONS);
        const main_line found = main_line_find(&r->record);
        assert_true(fabs(found.order - golden) < 1e-4);
        if (thirds[i].frequencies > 0) assert_int_equal(found.frequencies, thirds[i].frequencies);
        assert_int_equal(main_line_stays(&found, &r->record), thirds[i].stays);
        assert_int_equal(isnan(found.second), thirds[i].frequencies == 2);
        if (thirds[i].frequencies == 3) {
            printf("lines | order of a third frequency of %g | %.6f | %.9f | %.1e | 1e-6\n", thirds[i].size, order,
                   found.second, fabs(found.second - order));
            assert_true(fabs(found.second - order) < 1e-6);
            assert_true(fabs(found.second_trend) < 1e-8 && fabs(found.second_drift) < 1e-6);
        }
        free(r);
    }
}

/// The reported trend is the rate at which the line changes; up to 0.2 % over the record counts as none.
static void a_line_that_changes(void **state) {
    static const struct {
        double growth;
        bool stays;
    } rates[] = {{1e-5, true}, {-1e-5, true}, {1e-4, false}, {-1e-4, false}, {-1e-3, false}};
    (void)state;
    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++) {
        known_record *r =
            record_lines(&(known_lines){.order = golden, .line = 0.7, .growth = rates[i].growth}, REVOLUTIONS);
        const main_line found = main_line_find(&r->record);
        printf("lines | growth of a line, 1/revolution | %g | %g | %.1e | 1e-6\n", rates[i].growth, found.trend,
               fabs(found.trend - rates[i].growth));
        assert_true(fabs(found.trend - rates[i].growth) < 1e-6);
        assert_int_equal(main_line_stays(&found, &r->record), rates[i].stays);
        free(r);
    }
}

/// The reported drift is the change of the order from half to half of the record: half of the record times `wander`. Up
/// to a twentieth of a bin counts as none.
static void a_line_that_wanders(void **state) {
    static const struct {
        double wander;
        bool stays;
    } rates[] = {{1e-6, true}, {-1e-6, true}, {1e-4, false}, {-1e-4, false}};
    (void)state;
    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++) {
        known_record *r =
            record_lines(&(known_lines){.order = golden, .line = 0.7, .wander = rates[i].wander}, REVOLUTIONS);
        const main_line found = main_line_find(&r->record);
        assert_true(fabs(found.drift - 0.5 * REVOLUTIONS * rates[i].wander) < 1e-2 * fabs(found.drift) + 1e-6);
        assert_int_equal(main_line_stays(&found, &r->record), rates[i].stays);
        free(r);
    }
}

/// Forty revolutions are too few for a curve. Verdicts on two and on three frequencies then follow from lines alone.
/// With a third line that wanders or a line that decays the verdict stays open.
static void verdicts(void **state) {
    static const struct {
        known_lines lines;
        int frequencies;
    } motions[] = {
        {{.order = 0.381966011250105, .line = 0.7}, 2},
        {{.order = 0.4494897427831781, .line = 0.7}, 2},
        {{.order = 0.381966011250105, .line = 0.7, .third = 0.05, .third_order = 0.63}, 3},
        {{.order = 0.381966011250105, .line = 0.7, .third = 0.05, .third_order = 0.63, .third_wander = 2e-4}, 0},
        {{.order = 0.381966011250105, .line = 0.7, .growth = -1e-3}, 0}};
    (void)state;
    for (size_t i = 0; i < sizeof motions / sizeof *motions; i++) {
        known_record *r = record_lines(&motions[i].lines, 40);
        const whirl_verdict verdict = whirl_judge(&r->record);
        assert_int_equal(verdict.regime, motions[i].frequencies ? WHIRL_QUASI_PERIODIC : WHIRL_UNDETERMINED);
        assert_int_equal(verdict.frequencies, motions[i].frequencies);
        assert_int_equal(verdict.curves, 0);
        assert_true(verdict.agreement <= WHIRL_FAIR);
        assert_true(fabs(verdict.line - motions[i].lines.order) < 1e-3);
        assert_int_equal(verdict.second > 0.0, motions[i].lines.third > 0.0);
        free(r);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_frequencies), cmocka_unit_test(a_third_frequency),
                                       cmocka_unit_test(a_line_that_changes), cmocka_unit_test(a_line_that_wanders),
                                       cmocka_unit_test(verdicts)};
    return cmocka_run_group_tests_name("main line", tests, NULL, NULL);
}
