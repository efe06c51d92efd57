// A result made by hand for the tests of reports: a disc that may rub and a journal, swept and shown in detail. Motions
// are written down, not integrated: a circle about (0, -0.5), whose once-a-revolution dots are chosen by the regime.
#ifndef UNIT_REPORT_SAMPLE_H
#define UNIT_REPORT_SAMPLE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/result.h"
#include "whirl/internal/spectrum.h"

enum { SAMPLE_RECORD = 24, SAMPLE_TURNS = 4, SAMPLE_STEPS = 16 };

static inline void *sample_take(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) abort();
    return memory;
}

/// Returns the numbers of a field of a point, which the caller may change.
static inline double *sample_field(whirl_table *table, size_t point, const char *name, size_t which) {
    const whirl_field *field = whirl_layout_field(&table->layout, name);
    if (!field) abort();
    return table->blocks + point * table->layout.size + field->offset + which * field->rows * field->columns;
}

static inline void sample_verdict(whirl_table *table, size_t point, whirl_regime regime, int period, int curves) {
    *sample_field(table, point, "regime/code", 0) = regime;
    *sample_field(table, point, "regime/period", 0) = period;
    *sample_field(table, point, "regime/curves", 0) = curves;
    *sample_field(table, point, "regime/exponent", 0) = regime == WHIRL_CHAOTIC ? 0.4 : -0.1;
    *sample_field(table, point, "regime/exponent_error", 0) = 0.01;
}

/// Sets the lines (order, amplitude in x) of the spectrum of the first station; order 0 ends the list.
static inline void sample_lines(whirl_table *table, size_t point, const double (*lines)[2]) {
    double *at = sample_field(table, point, "spectrum/lines", 0);
    for (size_t i = 0; i < WHIRL_MAX_LINES * 5; i++) at[i] = (double)NAN;
    for (size_t i = 0; lines[i][0] > 0.0; i++) {
        const double line[5] = {lines[i][0], lines[i][1], 0.5 * lines[i][1], 0.7 * lines[i][1], 0.3 * lines[i][1]};
        memcpy(at + 5 * i, line, sizeof line);
    }
}

static inline void sample_motion(whirl_table *table, size_t point, size_t station) {
    const whirl_field *samples = whirl_layout_field(&table->layout, "waveform/samples");
    const double step = 6.283185307179586 / SAMPLE_STEPS;
    for (size_t k = 0; samples && k < samples->rows; k++) {
        double *at = sample_field(table, point, "waveform/samples", station) + 2 * k;
        at[0] = 0.3 * cos(step * (double)(k + 1));
        at[1] = -0.5 + 0.3 * sin(step * (double)(k + 1));
    }
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    for (size_t n = 0; n < SAMPLE_RECORD; n++) {
        const double turn = verdict.regime == WHIRL_PERIODIC ? (double)(n % (size_t)verdict.period) / verdict.period
                                                             : fmod(0.381966 * (double)n, 1.0);
        double *at = sample_field(table, point, "poincare/section", station) + 4 * n;
        at[0] = 0.3 * cos(6.283185307179586 * turn);
        at[1] = -0.5 + 0.3 * sin(6.283185307179586 * turn);
        at[2] = at[3] = 0.0;
    }
    *sample_field(table, point, "orbit/max_radius", station) = 0.8;
    *sample_field(table, point, "orbit/backward", station) = 0.25;
    const whirl_field *bins = whirl_layout_field(&table->layout, "spectrum/amplitude");
    for (size_t k = 0; bins && k < bins->rows; k++) {
        double *at = sample_field(table, point, "spectrum/amplitude", station) + 5 * k;
        at[0] = (double)k / SAMPLE_RECORD;
        at[1] = at[2] = k == SAMPLE_RECORD ? 0.3 : 0.001;
        at[3] = at[1];
        at[4] = 0.0005;
    }
}

static inline void sample_table(const whirl_result *result, whirl_table *table, const char *name, size_t count,
                                bool detail) {
    static const char *const analyses[] = {"poincare", "regime", "lyapunov", "spectrum", "orbit", "rub", "waveform"};
    const whirl_system system = {.dimension = 8,
                                 .period = 6.283185307179586,
                                 .probe_count = result->station_count,
                                 .probes = result->stations,
                                 .contact_count = result->contact_count};
    table->role = detail ? WHIRL_ROLE_DETAIL : WHIRL_ROLE_SURVEY;
    snprintf(table->name, sizeof table->name, "%s", name);
    snprintf(table->parameter, sizeof table->parameter, "%s", result->parameters[0].name);
    for (size_t i = 0; i < (detail ? 7 : 6); i++)
        if (!whirl_analysis_add(&table->analyses, analyses[i])) abort();
    table->integrate = whirl_integrate_default();
    table->integrate.steps_per_revolution = SAMPLE_STEPS;
    table->record = whirl_record_default();
    table->record.record = SAMPLE_RECORD;
    table->record.samples_per_revolution = SAMPLE_STEPS;
    table->record.waveform_revolutions = detail ? SAMPLE_TURNS : 0;
    table->record.spectra = detail;
    if (whirl_layout_new(&system, &table->integrate, &table->record, table->analyses, &table->layout).code) abort();
    table->count = count;
    table->values = sample_take(count, sizeof *table->values);
    table->branch = sample_take(count, sizeof *table->branch);
    table->blocks = sample_take(count * table->layout.size, sizeof *table->blocks);
    for (size_t i = 0; i < count * table->layout.size; i++) table->blocks[i] = (double)NAN;
}

/// Makes the sweep of r_k over 11 values from 1.0 to 0.0: six P-1, one P-2, two quasi-periodic, two chaotic with rub.
static inline void sample_sweep(whirl_result *result, whirl_table *table) {
    static const double lines[][2] = {{1.0, 0.3}, {0.5, 0.1}, {0.0, 0.0}};
    sample_table(result, table, "sweep", 11, false);
    for (size_t i = 0; i < table->count; i++) {
        table->values[i] = 1.0 - 0.1 * (double)i;
        if (i < 6) sample_verdict(table, i, WHIRL_PERIODIC, 1, 0);
        if (i == 6) sample_verdict(table, i, WHIRL_PERIODIC, 2, 0);
        if (i == 7 || i == 8) sample_verdict(table, i, WHIRL_QUASI_PERIODIC, 0, 1);
        if (i > 8) sample_verdict(table, i, WHIRL_CHAOTIC, 0, 0);
        *sample_field(table, i, "rub/share", 0) = i > 8 ? 0.04 : 0.0;
        sample_lines(table, i, lines);
        for (size_t s = 0; s < result->station_count; s++) sample_motion(table, i, s);
    }
}

/// Makes two points in detail: r_k = 0.6 (P-1) and 0.25 (chaotic, rubbing).
static inline void sample_detail(whirl_result *result, whirl_table *table) {
    static const double periodic[][2] = {{1.0, 0.3}, {3.0, 0.003}, {0.0, 0.0}};
    static const double broad[][2] = {{1.0, 0.1}, {0.43, 0.08}, {0.40, 0.06}, {0.46, 0.05}, {0.0, 0.0}};
    sample_table(result, table, "detail", 2, true);
    for (size_t i = 0; i < 2; i++) {
        table->values[i] = i == 0 ? 0.6 : 0.25;
        sample_verdict(table, i, i == 0 ? WHIRL_PERIODIC : WHIRL_CHAOTIC, i == 0, 0);
        *sample_field(table, i, "rub/share", 0) = i == 0 ? 0.0 : 0.039;
        sample_lines(table, i, i == 0 ? periodic : broad);
        for (size_t s = 0; s < result->station_count; s++) sample_motion(table, i, s);
    }
}

/// Makes the result; the caller frees it by whirl_result_free.
static inline whirl_result *sample_result(void) {
    static const whirl_probe stations[] = {{.name = "disc", .x = 0, .y = 1, .vx = 4, .vy = 5, .gap = 1.2},
                                           {.name = "journal", .x = 2, .y = 3, .vx = 6, .vy = 7, .clearance = 1.0}};
    static const whirl_parameter parameters[] = {{"r_k", "1", "0.6", 0.6}, {"c", "m", "0.2 mm", 2e-4}};
    whirl_result *result = sample_take(1, sizeof *result);
    snprintf(result->title, sizeof result->title, "A rotor made by hand");
    snprintf(result->case_name, sizeof result->case_name, "made.yaml");
    result->case_text = sample_take(1, 64);
    strcpy(result->case_text, "whirl: 1\n");
    result->speed = 650.0;
    result->length_scale = 2e-4;
    result->force_scale = 1.0;
    result->parameter_count = 2;
    result->parameters = sample_take(2, sizeof *parameters);
    memcpy(result->parameters, parameters, sizeof parameters);
    result->station_count = 2;
    result->stations = sample_take(2, sizeof *stations);
    memcpy(result->stations, stations, sizeof stations);
    result->contact_count = 1;
    result->contacts = sample_take(1, sizeof *result->contacts);
    strcpy(result->contacts[0], "rub at disc");
    if (whirl_result_add_fact(result, "version", "0.1.0").code) abort();
    result->table_count = 2;
    result->tables = sample_take(2, sizeof *result->tables);
    sample_sweep(result, &result->tables[0]);
    sample_detail(result, &result->tables[1]);
    return result;
}

#endif
