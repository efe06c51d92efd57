// Measured records as run-ups: vectors, spectra and orbits of a record with known orders, and model and measurement in
// one picture.
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

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double radian = 0.01745329251994329577, two_pi = 6.283185307179586476925;

/// A coast-down from 60 to 30 turns a second in 6 s: the ellipse x = 3 + 20 cos(a - 30 deg), y = 10 cos(a - 150 deg) um
/// of the angle a, and a circle of 2 um at twice the speed against the rotation, seen by probes at two angles. The mark
/// is the zero of a straight edge, which is interpolated without error.
static void write_record(const char *path, const char *mark, double first, double second) {
    enum { COUNT = 30000 };
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "# A coast-down\ntime [s];%s;de %g [um];de %g [um]\n", mark, first, second);
    for (int i = 0; i <= COUNT; i++) {
        const double t = 2.0 + 6.0 * i / COUNT, s = t - 2.0, speed = two_pi * (60.0 - 5.0 * s);
        const double a = two_pi * (60.0 * s - 2.5 * s * s);
        const double x = 3.0 + 20.0 * cos(a - 30.0 * radian) + 2.0 * cos(2.0 * a);
        const double y = 10.0 * cos(a - 150.0 * radian) - 2.0 * sin(2.0 * a);
        const double seen[] = {x * cos(first * radian) + y * sin(first * radian),
                               x * cos(second * radian) + y * sin(second * radian)};
        fprintf(file, "%.17g;%.17g;%.17g;%.17g\n", t,
                strncmp(mark, "speed", 5) == 0 ? speed / two_pi * 60.0 : asin(sin(a)), seen[0], seen[1]);
    }
    assert_int_equal(fclose(file), 0);
}

static whirl_result *read_record(const char *mark, double first, double second) {
    char path[] = "/tmp/whirl-record-XXXXXX";
    const int descriptor = mkstemp(path);
    assert_true(descriptor >= 0);
    close(descriptor);
    write_record(path, mark, first, second);
    whirl_result *result;
    const whirl_status status = whirl_result_read_record(path, &result);
    unlink(path);
    assert_string_equal(status.message, "");
    assert_int_equal(status.code, WHIRL_OK);
    return result;
}

/// Returns number in row `row` of a field, in micrometres for lengths.
static double number_of(const whirl_result *result, const char *field, size_t row, size_t column) {
    const whirl_table *table = &result->tables[0];
    const whirl_field *shape = whirl_layout_field(&table->layout, field);
    const double *numbers = whirl_table_field(table, 0, field, 0);
    assert_non_null(numbers);
    return numbers[row * shape->columns + column];
}

static void check_record(const whirl_result *result, const char *what, double lag_tolerance) {
    const whirl_table *table = &result->tables[0];
    const size_t rows = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_TIME)->rows;
    double amplitude = 0.0, lag = 0.0, centre = 0.0, speed = 0.0, backward = 0.0;
    size_t seen = 0;
    for (size_t row = 0; row < rows; row++) {
        const double time = number_of(result, WHIRL_FIELD_RUNUP_TIME, row, 0);
        if (isnan(time)) continue;
        seen++;
        const double x = number_of(result, WHIRL_FIELD_RUNUP_AMPLITUDE, row, 0);
        const double y = number_of(result, WHIRL_FIELD_RUNUP_AMPLITUDE, row, 1);
        amplitude = fmax(amplitude, fmax(fabs(x / 20.0 - 1.0), fabs(y / 10.0 - 1.0)));
        lag = fmax(lag, fabs(number_of(result, WHIRL_FIELD_RUNUP_LAG, row, 0) - 30.0));
        lag = fmax(lag, fabs(number_of(result, WHIRL_FIELD_RUNUP_LAG, row, 1) - 150.0));
        centre = fmax(centre, fabs(number_of(result, WHIRL_FIELD_RUNUP_CENTRE, row, 0) - 3.0));
        // At a constant rate the mean speed of a turn is that at the middle of its time.
        const double mean = two_pi * (60.0 - 5.0 * time);
        speed = fmax(speed, fabs(number_of(result, WHIRL_FIELD_RUNUP_SPEED, row, 0) / mean - 1.0));
        backward = fmax(backward, fabs(number_of(result, WHIRL_FIELD_RUNUP_WHIRL_AMPLITUDE, row, 3) - 2.0));
    }
    assert_true(seen > 200);
    check_within("Measured run", words("%s: amplitudes at 1X", what), 0.0, amplitude, 1e-5);
    check_within("Measured run", words("%s: lags (deg)", what), 0.0, lag, lag_tolerance);
    check_within("Measured run", words("%s: mean position (um)", what), 0.0, centre, 1e-4);
    check_within("Measured run", words("%s: speed", what), 0.0, speed, 1e-5);
    check_within("Measured run", words("%s: backward whirl at 2X (um)", what), 0.0, backward, 1e-4);
}

static void vectors_of_a_record(void **state) {
    (void)state;
    whirl_result *result = read_record("keyphasor [V]", 0.0, 90.0);
    check_record(result, "probes x, y", 1e-2);
    whirl_result_free(result);
    result = read_record("keyphasor [V]", 45.0, 135.0);
    check_record(result, "probes at 45, 135 deg", 1e-2);
    whirl_result_free(result);
    result = read_record("speed [rpm]", -30.0, 70.0);
    check_record(result, "a speed in place of the mark", 1e-2);
    whirl_result_free(result);
}

/// The orbit of a turn begins at the mark; a spectrum has the lines of the record.
static void orbits_and_spectra_of_a_record(void **state) {
    (void)state;
    whirl_result *result = read_record("keyphasor [V]", 45.0, 135.0);
    const double *orbit = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_ORBIT, 0);
    assert_non_null(orbit);
    check_within("Measured run", "x at the mark (um)", 3.0 + 20.0 * cos(30.0 * radian) + 2.0, orbit[0], 1e-3);
    check_within("Measured run", "y at the mark (um)", 10.0 * cos(150.0 * radian), orbit[1], 1e-3);
    const whirl_field *orders = whirl_layout_field(&result->tables[0].layout, WHIRL_FIELD_RUNUP_SPECTRUM_ORDER);
    const double *spectrum = whirl_table_field(&result->tables[0], 0, WHIRL_FIELD_RUNUP_SPECTRUM, 0);
    const double *last = spectrum + 2 * (99 * orders->rows);
    // 1X: half the sum of x e^(i 30 deg) and y turned by 90 deg.
    const double re = 20.0 * cos(-30.0 * radian) - 10.0 * sin(-150.0 * radian);
    const double im = 20.0 * sin(-30.0 * radian) + 10.0 * cos(-150.0 * radian);
    check_within("Measured run", "forward line at 1X (um)", 0.5 * hypot(re, im), last[2 * 16], 1e-3);
    check_within("Measured run", "backward line at 2X (um)", 2.0, last[2 * 32 + 1], 1e-3);
    check_within("Measured run", "forward line at 2X (um)", 0.0, last[2 * 32], 1e-3);
    whirl_result_free(result);
}

/// A model whose figure has the same panels.
static const char model[] =
    "whirl: 1\n"
    "rotor:\n"
    "  speed: 3600 rpm\n"
    "  length_scale: 1 um\n"
    "  stations: {de: {mass: 1 kg, damping: 20 N.s/m, eccentricity: 10 um}}\n"
    "  elements: [spring: {between: [de, ground], stiffness: 35000 N/m}]\n"
    "study: {runup: {speed_from: 3600 rpm, speed_to: 1200 rpm, rate: 200 rad/s2, spectra: 9}}\n";

static void model_and_measurement_in_one_picture(void **state) {
    (void)state;
    whirl_result *record = read_record("keyphasor [V]", 45.0, 135.0), *computed = result_of_text(model);
    const char *const names[] = {"runup-de", "runup-polar-de", "runup-centreline-de"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        whirl_figure *alone, *own, *both;
        const whirl_figure_options units = {.units = "um, rpm"}, with = {.units = "um, rpm", .with = record};
        assert_int_equal(whirl_figure_new(computed, names[i], &units, &alone).code, WHIRL_OK);
        assert_int_equal(whirl_figure_new(record, names[i], &units, &own).code, WHIRL_OK);
        assert_int_equal(whirl_figure_new(computed, names[i], &with, &both).code, WHIRL_OK);
        assert_int_equal(both->count, alone->count);
        for (size_t p = 0; p < both->count; p++) {
            const whirl_panel *panel = both->panels[p], *second = own->panels[p];
            size_t added = 0;
            for (size_t k = 0; k < panel->count; k++) {
                const whirl_series *series = panel->series[k];
                bool same = !series->dashed || series->shape != WHIRL_LINE;
                added += series->dashed && series->shape == WHIRL_LINE && series->count > 100;
                for (size_t n = 0; n < second->count && !same; n++)
                    same = second->series[n]->count == series->count &&
                           memcmp(series->x, second->series[n]->x, series->count * sizeof(double)) == 0 &&
                           memcmp(series->y, second->series[n]->y, series->count * sizeof(double)) == 0;
                assert_true(same);
                for (size_t n = 0; n < series->count; n++)
                    assert_true(isnan(series->y[n]) || (series->y[n] >= panel->y.low && series->y[n] <= panel->y.high));
            }
            assert_true(added > 0);
        }
        assert_non_null(strstr(both->caption, "Full lines are computed, dashed ones measured."));
        whirl_figure_free(alone);
        whirl_figure_free(own);
        whirl_figure_free(both);
    }
    whirl_figure *none;
    whirl_status status =
        whirl_figure_new(computed, "runup-spectrogram-de", &(whirl_figure_options){.with = record}, &none);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_non_null(strstr(status.message, "cannot share one picture"));
    assert_null(none);
    status = whirl_figure_new(computed, "runup-waveform-de", &(whirl_figure_options){.with = record}, &none);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    whirl_result_free(record);
    whirl_result_free(computed);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(vectors_of_a_record),
                                       cmocka_unit_test(orbits_and_spectra_of_a_record),
                                       cmocka_unit_test(model_and_measurement_in_one_picture)};
    return cmocka_run_group_tests_name("measured runs", tests, NULL, NULL);
}
