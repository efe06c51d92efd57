#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "explorer_tables.h"
#include "figure_build.h"
#include "mode_lines.h"
#include "regimes.h"

/// Limits of what a browser can load: points of a table, cells of a map, numbers of a section, numbers of studies at
/// rest, numbers of orbits' nodes. Beyond them data are thinned evenly. Maps with more cells than MAX_CELLS_IN_FULL
/// have only the fields that are most used.
enum {
    MAX_POINTS = 1 << 16,
    MAX_CELLS = 1 << 20,
    MAX_CELLS_IN_FULL = 1 << 14,
    MAX_SECTION = 1 << 20,
    MIN_ROWS = 8,    ///< least number of rows of a section after thinning; with fewer rows the section is left out
    MAX_ROWS = 4096, ///< largest number of rows of a field of a motion
    MAX_AT_REST = 1 << 22,
    MAX_NUMBERED = 127, ///< largest number of attractors with colours of their own
    MAX_NODES = 1 << 20
};

/// Points of a table that go into the page: every `stride`-th one; in maps every `stride`-th column and row of all
/// planes. Only the first table, the diagram, has sections: the page computes the motions of other points. Studies at
/// rest have all fields, branches have all points.
typedef struct selection {
    const whirl_table *table;
    size_t stride, count;
    size_t first; ///< first selected point, below `stride`
    bool sections, moves;
    bool lean;  ///< a large map, which has only its most used fields
    bool whole; ///< all fields have all of their rows
} selection;

/// Returns the first selected point from `point` on; table->count if there is none.
static size_t chosen_from(const selection *chosen, size_t point) {
    const whirl_table *table = chosen->table;
    for (; point < table->count; point++) {
        const size_t slot = table->row ? whirl_table_slot(table, point) : point;
        const size_t column = table->row ? slot % table->row : point;
        const size_t row = table->row ? slot / table->row % whirl_table_rows(table) : 0;
        if (table->row && !whirl_table_done(table, point)) continue;
        if (column % chosen->stride == chosen->first && row % chosen->stride == 0) break;
    }
    return point;
}

static size_t first_chosen(const selection *chosen) {
    return chosen_from(chosen, 0);
}

static size_t next_chosen(const selection *chosen, size_t point) {
    return chosen_from(chosen, point + 1);
}

/// Returns the end of a JSON list of points whose first item writes the opening bracket: "[]" for an empty list.
static const char *end_of_list(const selection *chosen) {
    return chosen->count == 0 ? "[]" : "]";
}

static selection select_all(const whirl_table *table) {
    return (selection){.table = table, .stride = 1, .count = table->count, .sections = true};
}

static size_t thinned(size_t count, size_t stride) {
    return count ? (count - 1) / stride + 1 : 0;
}

/// Selects as many points of a map as allowed. Columns and rows are thinned by the same factor, so that squares which
/// were not refined stay squares.
static selection select_cells(const whirl_table *table, bool sections) {
    const size_t rows = whirl_table_rows(table), planes = whirl_table_planes(table);
    selection chosen = {.table = table, .stride = 1, .sections = sections};
    while (thinned(table->row, chosen.stride) * thinned(rows, chosen.stride) * planes > MAX_CELLS &&
           chosen.stride < table->row + rows)
        chosen.stride += table->refine > 0 ? chosen.stride : 1;
    for (size_t p = first_chosen(&chosen); p < table->count; p = next_chosen(&chosen, p)) chosen.count++;
    chosen.lean = chosen.count > MAX_CELLS_IN_FULL;
    return chosen;
}

static selection select_points(const whirl_table *table, bool sections) {
    const whirl_kind *kind = whirl_analysis_kind(table->analyses);
    if (kind->found) return select_all(table);
    if (table->row) return select_cells(table, sections);
    const size_t fitting = MAX_AT_REST / (table->layout.size + 1) + 1;
    const size_t most = !kind->moves && fitting < MAX_POINTS ? fitting : MAX_POINTS;
    const size_t stride = thinned(table->count, most);
    return (selection){.table = table,
                       .stride = stride ? stride : 1,
                       .count = thinned(table->count, stride ? stride : 1),
                       .sections = sections,
                       .moves = kind->moves};
}

/// Number of a map's columns, rows and planes in the page.
typedef struct page_grid {
    size_t columns, rows, planes;
} page_grid;

static page_grid grid_of(const selection *chosen) {
    const whirl_table *table = chosen->table;
    return (page_grid){thinned(table->row, chosen->stride), thinned(whirl_table_rows(table), chosen->stride),
                       whirl_table_planes(table)};
}

/// Returns the number of a point's cell, counted row by row, plane by plane.
static size_t cell_of(const selection *chosen, page_grid grid, size_t point) {
    const size_t row = chosen->table->row, rows = whirl_table_rows(chosen->table);
    const size_t slot = whirl_table_slot(chosen->table, point), plane = slot / row / rows;
    return (plane * grid.rows + slot / row % rows / chosen->stride) * grid.columns + slot % row / chosen->stride;
}

static void write_float64(FILE *stream, const char *key, const double *values, size_t count) {
    script_key(stream, ',', key);
    fputc('"', stream);
    base64 to = {.stream = stream};
    for (size_t i = 0; i < count; i++) base64_float64(&to, values[i]);
    base64_end(&to);
    fputc('"', stream);
}

/// Writes the values along both axes, NaN for columns and rows without a point. Returns false without memory.
static bool write_axes(FILE *stream, const selection *chosen, page_grid grid) {
    const size_t count = grid.columns + grid.rows + grid.planes;
    double *x = malloc(count * sizeof *x);
    if (!x) return false;
    double *y = x + grid.columns, *z = y + grid.rows;
    const bool any = grid.columns > 0 && grid.rows > 0;
    for (size_t i = 0; i < count; i++) x[i] = (double)NAN;
    for (size_t p = first_chosen(chosen); any && p < chosen->table->count; p = next_chosen(chosen, p)) {
        const size_t cell = cell_of(chosen, grid, p);
        x[cell % grid.columns] = chosen->table->values[p];
        y[cell / grid.columns % grid.rows] = whirl_table_second(chosen->table, p);
        z[cell / grid.columns / grid.rows] = whirl_table_third(chosen->table, p);
    }
    write_float64(stream, "x", x, grid.columns);
    write_float64(stream, "y", y, grid.rows);
    if (chosen->table->plane > 0) write_float64(stream, "z", z, grid.planes);
    free(x);
    return true;
}

/// Writes the width in cells of every point of a refined map. A point covers the square that begins with its own cell.
static void write_widths(FILE *stream, const selection *chosen) {
    const whirl_table *table = chosen->table;
    char before = '[';
    if (table->refine == 0) return;
    script_key(stream, ',', "widths");
    for (size_t p = first_chosen(chosen); p < table->count; p = next_chosen(chosen, p), before = ',') {
        const double width = whirl_table_number(table, p, WHIRL_FIELD_MAP_WIDTH, 0) / (double)chosen->stride;
        fprintf(stream, "%c%.0f", before, width > 1.0 ? fmin(width, (double)table->refine) : 1.0);
    }
    fputs(end_of_list(chosen), stream);
}

/// Writes the second and third parameter of a map, its columns, rows and planes in the page, and the cell of every
/// point. Cells are counted row by row and plane by plane. They are left out if there is a point for every cell: then
/// point n is in cell n.
static bool write_cells(FILE *stream, const selection *chosen) {
    const page_grid grid = grid_of(chosen);
    script_key(stream, ',', "map");
    script_text_member(stream, '{', "second", chosen->table->second);
    if (chosen->table->plane > 0) script_text_member(stream, ',', "third", chosen->table->third);
    fprintf(stream, ",\"columns\":%zu,\"rows\":%zu", grid.columns, grid.rows);
    const bool well = write_axes(stream, chosen, grid);
    if (chosen->count < grid.columns * grid.rows * grid.planes) {
        script_key(stream, ',', "cells");
        char before = '[';
        for (size_t p = first_chosen(chosen); p < chosen->table->count; p = next_chosen(chosen, p), before = ',')
            fprintf(stream, "%c%zu", before, cell_of(chosen, grid, p));
        fputs(end_of_list(chosen), stream);
    }
    write_widths(stream, chosen);
    fputc('}', stream);
    return well;
}

enum { MAX_ATTRACTORS = 64 };

static void write_attractor(FILE *stream, const whirl_table *table, const whirl_attractor *one) {
    const whirl_verdict verdict = whirl_table_verdict(table, one->first);
    char name[WHIRL_NAME_SIZE];
    regime_name(&verdict, name, sizeof name);
    script_text_member(stream, '{', "name", name);
    fprintf(stream, ",\"starts\":%zu", one->points);
    script_number_member(stream, ',', "share", one->share);
    script_number_member(stream, ',', "error", one->error);
    fputc('}', stream);
}

/// Writes the attractors of a basin, and for every point the number of its attractor, from 1; 0: unknown.
static void write_attractors(FILE *stream, const selection *chosen) {
    const whirl_table *table = chosen->table;
    if (table->role != WHIRL_ROLE_BASIN) return;
    whirl_attractor found[MAX_ATTRACTORS];
    size_t *labels = calloc(table->count + 1, sizeof *labels), count = 0;
    // Without memory they are left out, and the page shows regimes.
    if (labels && whirl_table_attractors(table, labels, found, MAX_ATTRACTORS, &count).code == WHIRL_OK) {
        script_key(stream, ',', "attractors");
        fputc('[', stream);
        for (size_t k = 0; k < count; k++) {
            if (k > 0) fputc(',', stream);
            write_attractor(stream, table, &found[k]);
        }
        fputc(']', stream);
        script_key(stream, ',', "attractor");
        char before = '[';
        for (size_t p = first_chosen(chosen); p < table->count; p = next_chosen(chosen, p), before = ',')
            fprintf(stream, "%c%zu", before, labels[p]);
        fputs(end_of_list(chosen), stream);
    }
    free(labels);
}

/// Writes numbers of all chosen points under a key, as float64 in base64.
static void write_chosen(FILE *stream, const char *key, const selection *chosen, const double *values) {
    script_key(stream, ',', key);
    fputc('"', stream);
    base64 to = {.stream = stream};
    for (size_t p = first_chosen(chosen); p < chosen->table->count; p = next_chosen(chosen, p))
        base64_float64(&to, values[p]);
    base64_end(&to);
    fputc('"', stream);
}

/// Writes the parameter values of points that are not cells of a map.
static void write_values(FILE *stream, const selection *chosen) {
    const whirl_table *table = chosen->table;
    write_chosen(stream, "values", chosen, table->values);
    script_key(stream, ',', "branch");
    char before = '[';
    for (size_t p = first_chosen(chosen); p < table->count; p = next_chosen(chosen, p), before = ',')
        fprintf(stream, "%c%d", before, table->branch[p] < MAX_NUMBERED ? table->branch[p] : MAX_NUMBERED);
    fputs(end_of_list(chosen), stream);
    script_key(stream, ',', "done");
    before = '[';
    for (size_t p = first_chosen(chosen); p < table->count; p = next_chosen(chosen, p), before = ',')
        fprintf(stream, "%c%d", before, whirl_table_done(table, p));
    fputs(end_of_list(chosen), stream);
}

/// Appends the attractor of a point to a text: "...; attractor 2, 4.2 % +- 2.9 % of 48 starts", or "...; attractor 3,
/// found from a neighbour: 0 of 48 starts".
static void append_attractor(const whirl_table *table, size_t point, char *text, size_t size) {
    const size_t used = strlen(text);
    if (!table->attractors) return;
    const whirl_coexisting *one = &table->attractors[point];
    if (one->starts == 0) {
        snprintf(text + used, size - used, "%sattractor %zu, found from a neighbour: 0 of %zu starts", used ? "; " : "",
                 one->number, one->of);
        return;
    }
    snprintf(text + used, size - used, "%sattractor %zu, %.2g %% +- %.2g %% of %zu starts", used ? "; " : "",
             one->number, 100.0 * one->share, 100.0 * one->error, one->of);
}

static void write_verdicts(FILE *stream, const selection *chosen) {
    const whirl_table *table = chosen->table;
    if (!whirl_layout_has_verdict(&table->layout) || chosen->lean) return; // large maps have no texts
    script_key(stream, ',', "verdicts");
    char before = '[';
    for (size_t p = first_chosen(chosen); p < table->count; p = next_chosen(chosen, p), before = ',') {
        const whirl_verdict verdict = whirl_table_verdict(table, p);
        char name[WHIRL_NAME_SIZE], reason[WHIRL_MESSAGE_SIZE];
        whirl_verdict_name(&verdict, name, sizeof name);
        whirl_verdict_reason(&verdict, reason, sizeof reason);
        append_attractor(table, p, reason, sizeof reason);
        fputc(before, stream);
        fputc('[', stream);
        script_text(stream, name);
        fputc(',', stream);
        script_text(stream, reason);
        fputc(']', stream);
    }
    fputs(end_of_list(chosen), stream);
}

/// The part of a field that goes into the page: one row with all columns; for machines at rest all rows; for a section
/// the displacements x and y of its last rows.
typedef struct kept_part {
    size_t first_row, rows, columns;
} kept_part;

/// Returns true for the most used fields, the only ones besides sections that the page of a large map has.
static bool is_looked_at_most(const whirl_field *field) {
    static const char *const names[] = {WHIRL_FIELD_REGIME_CODE,       WHIRL_FIELD_REGIME_PERIOD,
                                        WHIRL_FIELD_REGIME_CONFIDENCE, WHIRL_FIELD_LYAPUNOV_LARGEST,
                                        WHIRL_FIELD_REGIME_EXPONENT,   WHIRL_FIELD_ORBIT_MAX_RADIUS,
                                        WHIRL_FIELD_RUB_SHARE};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(field->name, names[i]) == 0) return true;
    return false;
}

/// Returns the whole field, or the MAX_ROWS rows of it to write: the last ones of a section, the first ones (lowest
/// orders) of a spectrum.
static kept_part whole_part_of(const whirl_field *field) {
    const size_t rows = field->rows < MAX_ROWS ? field->rows : MAX_ROWS;
    const bool section = strcmp(field->name, WHIRL_FIELD_POINCARE_SECTION) == 0;
    return (kept_part){section ? field->rows - rows : 0, rows, field->columns};
}

static kept_part part_of(const whirl_field *field, const selection *chosen) {
    if (field->singles > 0) return (kept_part){0};
    if (chosen->whole) return whole_part_of(field);
    const bool section =
        strcmp(field->name, WHIRL_FIELD_POINCARE_SECTION) == 0 && chosen->count <= MAX_SECTION / MIN_ROWS;
    if (chosen->lean && !section && !is_looked_at_most(field)) return (kept_part){0};
    if (field->rows == 1 || !chosen->moves) return (kept_part){0, field->rows, field->columns};
    if (strncmp(field->name, "torus/section_", strlen("torus/section_")) == 0) return (kept_part){0, field->rows, 2};
    if (strcmp(field->name, WHIRL_FIELD_TRACE_SECTION) == 0) return (kept_part){0, field->rows, 2};
    if (strcmp(field->name, WHIRL_FIELD_TRACE_MULTIPLIERS) == 0) return (kept_part){0, field->rows, field->columns};
    if (!chosen->sections || chosen->count == 0 || strcmp(field->name, WHIRL_FIELD_POINCARE_SECTION) != 0)
        return (kept_part){0};
    const size_t most = MAX_SECTION / chosen->count;
    const size_t rows = field->rows < most ? field->rows : most;
    return (kept_part){field->rows - rows, rows, 2};
}

/// Writes numbers as [repetition][column][point][row], so that one coordinate of one station is contiguous.
static void write_numbers(FILE *stream, const selection *chosen, const whirl_field *field, kept_part part) {
    const whirl_table *table = chosen->table;
    base64 to = {.stream = stream};
    for (size_t which = 0; which < field->repeat; which++)
        for (size_t column = 0; column < part.columns; column++)
            for (size_t p = first_chosen(chosen); p < table->count; p = next_chosen(chosen, p)) {
                const double *from = whirl_table_field(table, p, field->name, which);
                for (size_t row = 0; row < part.rows; row++)
                    base64_float32(&to, from[(part.first_row + row) * field->columns + column]);
            }
    base64_end(&to);
}

static void write_fields(FILE *stream, const selection *chosen) {
    // Names by extent, in the data of the page.
    static const char *const extents[] = {
        [WHIRL_PER_POINT] = "point", [WHIRL_PER_STATION] = "station", [WHIRL_PER_CONTACT] = "contact"};
    // A table of one attractor has its blocks in the table from which it was made.
    const whirl_table *source = chosen->table->source ? chosen->table->source : chosen->table;
    const whirl_layout *layout = &chosen->table->layout;
    script_key(stream, ',', "fields");
    fputc('[', stream);
    bool first = true;
    // Write the description of each field, and its numbers of the chosen points.
    for (size_t f = 0; f < layout->field_count; f++) {
        const whirl_field *field = &layout->fields[f];
        const kept_part part = part_of(field, chosen);
        if (part.rows == 0 || !source->blocks) continue;
        if (!first) fputc(',', stream);
        first = false;
        script_text_member(stream, '{', "name", field->name);
        script_text_member(stream, ',', "unit", field->unit);
        script_text_member(stream, ',', "meaning", field->meaning);
        script_text_member(stream, ',', "extent", extents[field->extent]);
        fprintf(stream, ",\"repeat\":%zu,\"rows\":%zu,\"columns\":%zu", field->repeat, part.rows, part.columns);
        script_key(stream, ',', "data");
        fputc('"', stream);
        write_numbers(stream, chosen, field, part);
        fputs("\"}", stream);
    }
    fputc(']', stream);
}

/// Writes the critical speeds and thresholds located between points, for all points, with all digits.
static void write_critical(FILE *stream, const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    bool first = true;
    if (!field) return;
    script_key(stream, ',', "critical");
    fputc('[', stream);
    for (size_t p = 0; p < table->count; p++) {
        const double *row = whirl_table_done(table, p) ? whirl_table_field(table, p, field->name, 0) : NULL;
        for (size_t i = 0; row && i < field->rows; i++, row += field->columns) {
            if (!isfinite(row[0])) continue;
            fputs(first ? "[" : ",[", stream);
            first = false;
            for (size_t column = 0; column < field->columns; column++) {
                if (column > 0) fputc(',', stream);
                script_number(stream, row[column]);
            }
            fputc(']', stream);
        }
    }
    fputc(']', stream);
}

/// Writes the names of mode lines (modes followed over the parameter), and the line of every mode of every point:
/// float32, little-endian, base64, NaN for none.
static void write_mode_lines(FILE *stream, const selection *chosen) {
    mode_lines lines;
    if (!mode_lines_of(chosen->table, &lines)) return;
    script_key(stream, ',', "mode_names");
    for (size_t i = 0; i < lines.count; i++) {
        fputc(i > 0 ? ',' : '[', stream);
        script_text(stream, lines.names[i]);
    }
    fputc(']', stream);
    script_key(stream, ',', "mode_lines");
    fputc('"', stream);
    base64 to = {.stream = stream};
    for (size_t p = first_chosen(chosen); p < chosen->table->count; p = next_chosen(chosen, p))
        for (size_t i = 0; i < lines.modes; i++) {
            const size_t line = lines.line[p * lines.modes + i];
            base64_float32(&to, line == SIZE_MAX ? (double)NAN : (double)line);
        }
    base64_end(&to);
    fputc('"', stream);
    mode_lines_free(&lines);
}

/// Loads a point of a branch with its orbit, to be freed. Returns false if the table has no orbit there.
static bool take_trace(const whirl_table *table, size_t point, whirl_trace *trace) {
    return whirl_table_done(table, point) && whirl_table_trace(table, point, trace).code == WHIRL_OK;
}

/// Returns the number of numbers in an orbit's nodes, the states at the beginnings of its segments.
static size_t count_nodes(const whirl_orbit *orbit) {
    return orbit->segment_count * orbit->dimension;
}

static size_t count_all_nodes(const whirl_table *table) {
    size_t all = 0;
    for (size_t p = 0; p < table->count; p++) {
        whirl_trace trace;
        if (!take_trace(table, p, &trace)) continue;
        all += count_nodes(trace.point.orbit);
        whirl_orbit_free(trace.point.orbit);
    }
    return all;
}

/// Writes orbits of branches, which the page compares with motions: period and nodes, with all digits, of every
/// "orbit_stride"-th point.
static void write_orbits(FILE *stream, const whirl_table *table) {
    if (table->role != WHIRL_ROLE_BRANCHES || !whirl_layout_field(&table->layout, WHIRL_FIELD_TRACE_NODES) ||
        !table->blocks)
        return;
    const size_t stride = count_all_nodes(table) / MAX_NODES + 1;
    fprintf(stream, ",\"orbit_stride\":%zu", stride);
    script_key(stream, ',', "orbits");
    fputc('"', stream);
    base64 to = {.stream = stream};
    for (size_t p = 0; p < table->count; p += stride) {
        whirl_trace trace;
        if (!take_trace(table, p, &trace)) continue;
        const whirl_orbit *orbit = trace.point.orbit;
        base64_float64(&to, orbit->period);
        for (size_t i = 0; i < count_nodes(orbit); i++) base64_float64(&to, orbit->nodes[i]);
        whirl_orbit_free(trace.point.orbit);
    }
    base64_end(&to);
    fputc('"', stream);
}

bool explorer_write_table(FILE *stream, const whirl_table *table, bool sections) {
    // Write name, parameter and number of points.
    bool well = true;
    const selection chosen = select_points(table, sections && table->count > 0);
    script_text_member(stream, '{', "name", table->name);
    script_text_member(stream, ',', "parameter", table->parameter);
    fprintf(stream, ",\"points\":%zu,\"count\":%zu", table->count, chosen.count);
    if (table->source)
        fprintf(stream, ",\"starts\":%zu,\"places\":%zu", table->source->starts, whirl_table_places(table));
    // Write the options of the table.
    const whirl_member *members;
    for (size_t i = 0, at; (members = whirl_table_options(table, i, &at)) != NULL; i++)
        script_members(stream, members, (const char *)table + at);
    // Write scales and values of the chosen points.
    if (table->length_scales) write_chosen(stream, "length_scales", &chosen, table->length_scales);
    if (table->row)
        well = write_cells(stream, &chosen);
    else
        write_values(stream, &chosen);
    // Write verdicts and everything that figures of the page need.
    write_attractors(stream, &chosen);
    write_verdicts(stream, &chosen);
    write_critical(stream, table);
    write_mode_lines(stream, &chosen);
    write_fields(stream, &chosen);
    write_orbits(stream, table);
    fputc('}', stream);
    return well;
}

void explorer_write_point(FILE *stream, const whirl_table *table, size_t point) {
    const selection chosen = {.table = table, .stride = table->count, .first = point, .count = 1, .whole = true};
    write_fields(stream, &chosen);
}
