// A small result made by hand: two stations, one contact, a swept table of the fields that the analyses really have and
// a second one whose fields are invented. All numbers differ; some are NaN, infinite, zero with a sign, or subnormal.
#ifndef UNIT_STORE_SYNTHETIC_H
#define UNIT_STORE_SYNTHETIC_H

#include "whirl/engine/result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SYNTHETIC_STATIONS = 2, SYNTHETIC_POINTS = 3, SYNTHETIC_RECORD = 4 };

static inline void *synthetic_take(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) abort();
    return memory;
}

/// Fills the block of every point with successive numbers, with special values between them.
static inline void synthetic_fill(whirl_table *table, size_t count) {
    static const double special[] = {NAN, INFINITY, -INFINITY, -0.0, 5e-324, 1.0 / 3.0};
    table->count = count;
    table->values = synthetic_take(count, sizeof *table->values);
    table->branch = synthetic_take(count, sizeof *table->branch);
    table->blocks = synthetic_take(count * table->layout.size, sizeof *table->blocks);
    for (size_t i = 0; i < count; ++i) {
        table->values[i] = 0.1 + 0.1 * (double)i;
        table->branch[i] = (int)(i % 3) - 1;
    }
    for (size_t i = 0; i < count * table->layout.size; ++i)
        table->blocks[i] = i % 11 == 5 ? special[i / 11 % 6] : (double)i / 7.0;
}

/// Sets a field of the first station, contact or of the point.
static inline void synthetic_set(whirl_table *table, size_t point, const char *name, double value) {
    const whirl_field *field = whirl_layout_field(&table->layout, name);
    if (!field) abort();
    table->blocks[point * table->layout.size + field->offset] = value;
}

/// Gives a table without numbers the fields of these analyses.
static inline void synthetic_layout(whirl_table *table, const whirl_result *result, const char *const *analyses,
                                    size_t count) {
    const whirl_system system = {.dimension = 8,
                                 .period = 6.283185307179586,
                                 .probe_count = result->station_count,
                                 .probes = result->stations,
                                 .contact_count = result->contact_count};
    snprintf(table->parameter, sizeof table->parameter, "r_k");
    for (size_t i = 0; i < count; ++i)
        if (!whirl_analysis_add(&table->analyses, analyses[i])) abort();
    table->integrate = whirl_integrate_default();
    table->record = whirl_record_default();
    table->record.record = SYNTHETIC_RECORD;
    if (whirl_layout_new(&system, &table->integrate, &table->record, table->analyses, &table->layout).code) abort();
}

/// Makes branches of orbits ("trace") or of tori ("torus"): arbitrary numbers, except for those that count others.
static inline void synthetic_traced(whirl_table *table, const whirl_result *result, const char *analysis) {
    char revolutions[WHIRL_NAME_SIZE];
    snprintf(table->name, sizeof table->name, "%s", strcmp(analysis, "torus") == 0 ? "tori" : "branch");
    snprintf(revolutions, sizeof revolutions, "%s/revolutions", analysis);
    synthetic_layout(table, result, &analysis, 1);
    synthetic_fill(table, 2);
    for (size_t i = 0; i < table->count; ++i) {
        synthetic_set(table, i, revolutions, 1.0);
        if (strcmp(analysis, "torus") == 0) synthetic_set(table, i, "torus/node_count", 16.0);
    }
}

/// Makes a sweep with the fields of the analyses.
static inline void synthetic_sweep(whirl_table *table, const whirl_result *result) {
    static const char *const analyses[] = {"poincare", "regime", "lyapunov", "spectrum", "orbit", "rub"};
    snprintf(table->name, sizeof table->name, "sweep");
    table->role = WHIRL_ROLE_SURVEY;
    synthetic_layout(table, result, analyses, sizeof analyses / sizeof *analyses);
    synthetic_fill(table, SYNTHETIC_POINTS);
    static const double codes[SYNTHETIC_POINTS] = {WHIRL_PERIODIC, WHIRL_CHAOTIC, WHIRL_DIVERGING};
    for (size_t i = 0; i < SYNTHETIC_POINTS; ++i) {
        synthetic_set(table, i, "regime/code", codes[i]);
        synthetic_set(table, i, "regime/period", i == 0 ? 2.0 : 0.0);
        synthetic_set(table, i, "regime/diverged_at", i == 2 ? 17.0 : 0.0);
    }
}

/// Appends a field of a point with so many rows.
static inline void synthetic_append(whirl_layout *layout, const char *name, size_t rows) {
    whirl_field *field = &layout->fields[layout->field_count++];
    *field = (whirl_field){.unit = "1",
                           .meaning = "a number (invented)",
                           .extent = WHIRL_PER_POINT,
                           .rows = rows,
                           .columns = 1,
                           .repeat = 1,
                           .offset = layout->size};
    snprintf(field->name, sizeof field->name, "%s", name);
    layout->size += rows;
}

/// Makes a map of a table: so many points in rows, and rows in planes, all of them with so many numbers more.
static inline void synthetic_planes(whirl_table *table, size_t row, size_t rows, size_t planes, size_t numbers) {
    free(table->values), free(table->branch), free(table->blocks);
    snprintf(table->name, sizeof table->name, "map");
    snprintf(table->second, sizeof table->second, "rho");
    table->row = row;
    synthetic_append(&table->layout, "map/second", 1);
    if (planes > 0) synthetic_append(&table->layout, "map/third", 1);
    if (planes > 0) snprintf(table->third, sizeof table->third, "sigma");
    table->plane = planes > 0 ? row * rows : 0;
    if (numbers > 0) synthetic_append(&table->layout, "made/long", numbers);
    const size_t count = row * rows * (planes > 0 ? planes : 1);
    synthetic_fill(table, count);
    for (size_t i = 0; i < count; ++i) {
        table->values[i] = 0.1 * (double)(i % row);
        synthetic_set(table, i, "map/second", 0.5 * (double)(i / row % rows));
        if (planes > 0) synthetic_set(table, i, "map/third", 7.0 * (double)(i / row / rows));
    }
}

/// Makes that map without planes.
static inline void synthetic_map(whirl_table *table, size_t row, size_t rows, size_t numbers) {
    synthetic_planes(table, row, rows, 0, numbers);
}

/// Makes a table with fields of every extent and shape: [3][2], [3], [2], a single number, and one without rows.
static inline void synthetic_detail(whirl_table *table, const whirl_result *result) {
    static const struct {
        const char *name, *unit, *meaning;
        whirl_extent extent;
        size_t rows, columns;
    } shapes[] = {
        {"made/array", "length", "left, right (invented)", WHIRL_PER_STATION, 3, 2},
        {"made/column", "force", "a column", WHIRL_PER_CONTACT, 3, 1},
        {"made/row", "order", "first, second", WHIRL_PER_POINT, 1, 2},
        {"made/number", "1", "a number", WHIRL_PER_STATION, 1, 1},
        {"made/nothing", "1", "no rows", WHIRL_PER_POINT, 0, 1},
    };
    const size_t repeat[] = {1, result->station_count, result->contact_count};
    snprintf(table->name, sizeof table->name, "detail");
    table->role = WHIRL_ROLE_DETAIL;
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
        whirl_field *field = &table->layout.fields[table->layout.field_count++];
        *field = (whirl_field){.unit = shapes[i].unit,
                               .meaning = shapes[i].meaning,
                               .extent = shapes[i].extent,
                               .rows = shapes[i].rows,
                               .columns = shapes[i].columns,
                               .repeat = repeat[shapes[i].extent],
                               .offset = table->layout.size};
        snprintf(field->name, sizeof field->name, "%s", shapes[i].name);
        table->layout.size += field->repeat * field->rows * field->columns;
    }
    table->integrate = (whirl_integrate_options){.method = "cvode", .steps_per_revolution = 64, .rtol = 1e-11};
    table->record = (whirl_record_options){.modes = 3,
                                           .transient = 7,
                                           .record = 5,
                                           .watch = 6,
                                           .waveform_revolutions = 2,
                                           .samples_per_revolution = 32,
                                           .highest_order = 2.5,
                                           .growth = WHIRL_GROWTH_ALL};
    synthetic_fill(table, 1);
    table->values[0] = NAN;
}

static inline whirl_result *synthetic_result(void) {
    whirl_result *result = synthetic_take(1, sizeof *result);
    snprintf(result->title, sizeof result->title, "A rotor, \"made\" by hand; r\xc3\xb6tor");
    snprintf(result->case_name, sizeof result->case_name, "cases/made.yaml");
    result->case_text = synthetic_take(1, 64);
    strcpy(result->case_text, "whirl: 1\ntitle: made # by hand\n");
    result->speed = 650.0;
    result->length_scale = 2e-4;
    result->force_scale = 4225.0;
    static const whirl_parameter parameters[] = {{"r_k", "1", "0.6", 0.6},
                                                 {"omega", "rad/s", "650 rad/s", 650.0},
                                                 {"k2", "N/m", "= 50*(650/0.2)^2", 528125000.0}};
    result->parameter_count = 3;
    result->parameters = synthetic_take(3, sizeof *parameters);
    memcpy(result->parameters, parameters, sizeof parameters);
    static const whirl_probe stations[SYNTHETIC_STATIONS] = {
        {.name = "disc", .x = 0, .y = 1, .vx = 4, .vy = 5, .gap = 1.2, .shaft = 1, .position = 0.25},
        {.name = "journal", .x = 2, .y = 3, .vx = 6, .vy = 7, .clearance = 1.0, .clockwise = true}};
    result->station_count = SYNTHETIC_STATIONS;
    result->stations = synthetic_take(SYNTHETIC_STATIONS, sizeof *stations);
    memcpy(result->stations, stations, sizeof stations);
    result->contact_count = 1;
    result->contacts = synthetic_take(1, sizeof *result->contacts);
    strcpy(result->contacts[0], "rub at disc");
    if (whirl_result_add_fact(result, "version", "9.8.7").code || whirl_result_add_fact(result, "a fact", "").code)
        abort();
    result->table_count = 2;
    result->tables = synthetic_take(2, sizeof *result->tables);
    synthetic_sweep(&result->tables[0], result);
    synthetic_detail(&result->tables[1], result);
    return result;
}

#endif
