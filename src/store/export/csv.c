// Results as CSV files (RFC 4180). The files are described in docs/result-file.md.
#include "atomic_file.h"
#include "format.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "number_text.h"
#include "whirl/engine/descriptor.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

/// A line of a file while it is written.
typedef struct line {
    FILE *stream;
    bool started;
} line;

static void put_cell(line *row, const char *text) {
    if (row->started) fputc(',', row->stream);
    row->started = true;
    if (!text[strcspn(text, ",\"\r\n")]) {
        fputs(text, row->stream);
        return;
    }
    fputc('"', row->stream);
    for (; *text; ++text) {
        if (*text == '"') fputc('"', row->stream);
        fputc(*text, row->stream);
    }
    fputc('"', row->stream);
}

static void put_number_cell(line *row, double value) {
    char text[NUMBER_SIZE];
    number_text(value, text);
    put_cell(row, isnan(value) ? "NaN" : isinf(value) ? value < 0 ? "-inf" : "inf" : text);
}

static void put_count_cell(line *row, size_t value) {
    char text[24];
    snprintf(text, sizeof text, "%zu", value);
    put_cell(row, text);
}

static void end_line(line *row) {
    fputs("\r\n", row->stream);
    row->started = false;
}

// ---------------------------------------------------------------- headings

/// Returns true if the table has one length scale. If its parameter changes the scale, lengths are written in the unit
/// of the case.
static bool has_one_scale(const whirl_table *table) {
    return !table->length_scales;
}

/// Returns the units that the case asks for (key `units`); without them amplitudes are zero to peak.
static whirl_shown_units units_of(const whirl_result *result) {
    whirl_shown_units units;
    whirl_result_shown_units(result, NULL, &units); // no words are given that could be wrong
    return units;
}

/// Writes the unit of a length and how amplitudes are counted: "[um p-p]" if the case asks for it, else "[0.2 mm 0-p]",
/// "[mm]", "[0.2 mm per radian]".
static void length_text(const whirl_shown_units *units, const whirl_table *table, const whirl_field *field,
                        const char *behind, char *text, size_t size) {
    const double scale = units->result->length_scale;
    const whirl_unit length = units->size.size > 0.0 ? units->size : whirl_result_length_unit(units->result);
    const char *counted = whirl_shown_counted(units, whirl_field_counting(field));
    static const char micro[] = "\xC2\xB5"; // written as u: spreadsheets guess another alphabet than UTF-8
    const bool is_micro = strncmp(length.name, micro, sizeof micro - 1) == 0;
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "%s%.60s", is_micro ? "u" : "", length.name + (is_micro ? sizeof micro - 1 : 0));
    const char *space = *counted ? " " : "";
    if (units->size.size <= 0.0 && has_one_scale(table) && scale != length.size)
        snprintf(text, size, "[%.10g %s%s%s%s]", scale / length.size, name, space, counted, behind);
    else
        snprintf(text, size, "[%s%s%s%s]", name, space, counted, behind);
}

/// Writes the unit of a column in brackets: lengths in the unit of the case, scales as numbers.
static void unit_text(const whirl_shown_units *units, const whirl_table *table, const whirl_field *field, size_t column,
                      char *text, size_t size) {
    const whirl_result *result = units->result;
    const char *unit = whirl_column_unit(field, column);
    if (strncmp(unit, "length", 6) == 0)
        length_text(units, table, field, strcmp(unit, "length") == 0 ? "" : " per radian", text, size);
    else if (strcmp(unit, "parameter") == 0)
        snprintf(text, size, "[%s]", whirl_result_parameter_unit(result, table->parameter));
    else if (strcmp(unit, "force") == 0 && result->force_scale != 1.0)
        snprintf(text, size, "[%.10g N]", result->force_scale);
    else if (*whirl_result_keyphasor(result) && (strstr(unit, "order") || strstr(unit, "revolution")))
        snprintf(text, size, "[%s of %.60s]", unit, whirl_result_keyphasor(result));
    else
        snprintf(text, size, "[%s]", strcmp(unit, "force") == 0 ? "N" : unit);
}

/// Returns the factor that converts a field's numbers at a point to the unit in the heading.
static double unit_factor(const whirl_shown_units *units, const whirl_table *table, size_t point,
                          const whirl_field *field, size_t column) {
    if (strncmp(whirl_column_unit(field, column), "length", 6) != 0) return 1.0;
    const double counted = whirl_field_counting(field) == WHIRL_AMPLITUDE ? units->amplitude : 1.0;
    const double scale = whirl_result_length_scale(units->result, table, point);
    if (units->size.size > 0.0) return counted * scale / units->size.size;
    return has_one_scale(table) ? counted : counted * scale / whirl_result_length_unit(units->result).size;
}

static const char *repetition_name(const whirl_result *result, const whirl_field *field, size_t which) {
    if (field->extent == WHIRL_PER_STATION && which < result->station_count) return result->stations[which].name;
    if (field->extent == WHIRL_PER_CONTACT && which < result->contact_count) return result->contacts[which];
    return "";
}

/// Writes the name of a column of a field; "" for a field with one column.
static void column_text(const whirl_field *field, size_t column, char *text, size_t size) {
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    if (field->columns == 1)
        snprintf(text, size, "%s", "");
    else if (whirl_field_column_names(field, names))
        snprintf(text, size, "%.63s", names[column]);
    else
        snprintf(text, size, "column %zu", column + 1);
}

/// Writes a heading such as "orbit/mean disc x [0.0002 m]".
static void put_field_heading(line *row, const whirl_shown_units *units, const whirl_table *table,
                              const whirl_field *field, size_t which, size_t column) {
    char unit[WHIRL_NAME_SIZE + 40], name[WHIRL_NAME_SIZE], text[400];
    unit_text(units, table, field, column, unit, sizeof unit);
    column_text(field, column, name, sizeof name);
    const char *station = repetition_name(units->result, field, which);
    snprintf(text, sizeof text, "%.63s%s%.63s%s%.63s %s", field->name, *station ? " " : "", station, *name ? " " : "",
             name, unit);
    put_cell(row, text);
}

static void put_parameter_heading(line *row, const whirl_result *result, const char *parameter) {
    const whirl_unit unit = whirl_result_unit(result, parameter);
    char text[2 * WHIRL_NAME_SIZE + 8];
    snprintf(text, sizeof text, "%s [%s]", parameter, *unit.name ? unit.name : "1");
    put_cell(row, text);
}

static void put_point_headings(line *row, const whirl_result *result, const whirl_table *table) {
    put_cell(row, "point");
    if (*table->parameter) put_parameter_heading(row, result, table->parameter);
    if (table->row > 0) put_parameter_heading(row, result, table->second);
    if (table->plane > 0) put_parameter_heading(row, result, table->third);
    put_cell(row, "branch");
}

/// Writes the value of a parameter in the unit of the case, without rounding errors of the conversion: 2000 rpm is
/// 2000.
static void put_value_cell(line *row, const whirl_result *result, const char *parameter, double value) {
    char text[NUMBER_SIZE];
    const double size = whirl_result_unit(result, parameter).size;
    snprintf(text, sizeof text, "%.14g", value / size);
    if (size == 1.0 || !isfinite(value))
        put_number_cell(row, value);
    else
        put_cell(row, text);
}

static void put_point_cells(line *row, const whirl_result *result, const whirl_table *table, size_t point) {
    char branch[16];
    snprintf(branch, sizeof branch, "%d", table->branch[point]);
    put_count_cell(row, whirl_table_slot(table, point) + 1);
    if (*table->parameter) put_value_cell(row, result, table->parameter, table->values[point]);
    if (table->row > 0) put_value_cell(row, result, table->second, whirl_table_second(table, point));
    if (table->plane > 0) put_value_cell(row, result, table->third, whirl_table_third(table, point));
    put_cell(row, branch);
}

// ---------------------------------------------------------------- files

static void write_points(FILE *stream, const whirl_result *result, const whirl_table *table,
                         const whirl_field *unused) {
    (void)unused;
    // Headings.
    line row = {stream, false};
    const whirl_layout *layout = &table->layout;
    const whirl_shown_units units = units_of(result);
    char method[WHIRL_NAME_SIZE + 16];
    snprintf(method, sizeof method, "%s%s", table->integrate.method, table->integrate.chosen ? " (by auto)" : "");
    put_point_headings(&row, result, table);
    put_cell(&row, "verdict"), put_cell(&row, "method");
    for (const whirl_field *field = layout->fields; field < layout->fields + layout->field_count; ++field)
        for (size_t i = 0; field->rows == 1 && field->singles == 0 && i < field->repeat * field->columns; ++i)
            put_field_heading(&row, &units, table, field, i / field->columns, i % field->columns);
    end_line(&row);
    // One line for each finished point.
    for (size_t point = 0; point < table->count; ++point) {
        char verdict[WHIRL_NAME_SIZE];
        if (!whirl_table_done(table, point) || !whirl_table_block(table, point)) continue;
        const whirl_verdict found = whirl_table_verdict(table, point);
        whirl_verdict_name(&found, verdict, sizeof verdict);
        if (found.regime == WHIRL_NOT_JUDGED) verdict[0] = '\0';
        put_point_cells(&row, result, table, point);
        put_cell(&row, verdict);
        put_cell(&row, method);
        const double *block = whirl_table_block(table, point);
        for (const whirl_field *field = layout->fields; field < layout->fields + layout->field_count; ++field) {
            for (size_t i = 0; field->rows == 1 && field->singles == 0 && i < field->repeat * field->columns; ++i)
                put_number_cell(&row, unit_factor(&units, table, point, field, i % field->columns) *
                                          block[field->offset + i]);
        }
        end_line(&row);
    }
}

static bool all_missing(const double *numbers, size_t count) {
    for (size_t i = 0; i < count; ++i)
        if (!isnan(numbers[i])) return false;
    return true;
}

static void put_rows_headings(line *row, const whirl_shown_units *units, const whirl_table *table,
                              const whirl_field *field) {
    put_point_headings(row, units->result, table);
    if (field->extent != WHIRL_PER_POINT) put_cell(row, format_extents[field->extent]);
    put_cell(row, "row");
    char unit[WHIRL_NAME_SIZE + 40], name[WHIRL_NAME_SIZE], text[2 * WHIRL_NAME_SIZE + 48];
    for (size_t i = 0; i < field->columns; ++i) {
        column_text(field, i, name, sizeof name);
        unit_text(units, table, field, i, unit, sizeof unit);
        snprintf(text, sizeof text, "%s %s", *name ? name : "value", unit);
        put_cell(row, text);
    }
    end_line(row);
}

/// Writes a line for each row of a field; rows without any number are left out.
static void write_rows(FILE *stream, const whirl_result *result, const whirl_table *table, const whirl_field *field) {
    line row = {stream, false};
    const whirl_shown_units units = units_of(result);
    put_rows_headings(&row, &units, table, field);
    for (size_t i = 0; i < table->count * field->repeat * field->rows; ++i) {
        const size_t point = i / (field->repeat * field->rows), inner = i % (field->repeat * field->rows);
        const double *block = whirl_table_done(table, point) ? whirl_table_block(table, point) : NULL;
        const double *numbers = block ? block + field->offset + inner * field->columns : NULL;
        if (!numbers || all_missing(numbers, field->columns)) continue;
        put_point_cells(&row, result, table, point);
        if (field->extent != WHIRL_PER_POINT) put_cell(&row, repetition_name(result, field, inner / field->rows));
        put_count_cell(&row, inner % field->rows + 1);
        for (size_t c = 0; c < field->columns; ++c)
            put_number_cell(&row, unit_factor(&units, table, point, field, c) * numbers[c]);
        end_line(&row);
    }
}

static void write_parameters(FILE *stream, const whirl_result *result, const whirl_table *table,
                             const whirl_field *field) {
    (void)table, (void)field;
    line row = {stream, false};
    put_cell(&row, "name"), put_cell(&row, "value"), put_cell(&row, "unit"), put_cell(&row, "text");
    end_line(&row);
    for (size_t i = 0; i < result->parameter_count; ++i) {
        const whirl_parameter *parameter = &result->parameters[i];
        put_cell(&row, parameter->name);
        put_number_cell(&row, parameter->value);
        put_cell(&row, parameter->unit);
        put_cell(&row, parameter->text);
        end_line(&row);
    }
}

static void put_options(line *row, const char *table, const whirl_member *member, const void *options) {
    char value[WHIRL_NAME_SIZE];
    for (; member->part; ++member) {
        if (!member->name) continue;
        whirl_member_text(member, options, value);
        put_cell(row, table), put_cell(row, member->name), put_cell(row, value), put_cell(row, member->key.meaning);
        end_line(row);
    }
}

static void write_options(FILE *stream, const whirl_result *result, const whirl_table *unused,
                          const whirl_field *field) {
    (void)unused, (void)field;
    line row = {stream, false};
    put_cell(&row, "table"), put_cell(&row, "option"), put_cell(&row, "value"), put_cell(&row, "meaning");
    end_line(&row);
    for (const whirl_table *table = result->tables; table < result->tables + result->table_count; ++table) {
        const whirl_member *members;
        for (size_t group = 0, at; (members = whirl_table_options(table, group, &at)) != NULL; group++)
            put_options(&row, table->name, members, (const char *)table + at);
    }
}

/// Writes a line for each attractor of each place; none without memory.
static void write_attractors(FILE *stream, const whirl_result *result, const whirl_table *table,
                             const whirl_field *unused) {
    static const char *const headings[] = {"attractor", "verdict", "starts", "of", "share", "error", "first point"};
    (void)unused;
    // Headings.
    line row = {stream, false};
    whirl_coexistence found;
    put_cell(&row, "place");
    if (*table->parameter) put_parameter_heading(&row, result, table->parameter);
    if (table->row > 0) put_parameter_heading(&row, result, table->second);
    if (table->plane > 0) put_parameter_heading(&row, result, table->third);
    for (size_t i = 0; i < sizeof headings / sizeof *headings; ++i) put_cell(&row, headings[i]);
    end_line(&row);
    // One line for each attractor of each place.
    if (whirl_table_coexistence(table, &found).code != WHIRL_OK) return;
    for (size_t i = 0; i < found.count; ++i) {
        const whirl_coexisting *one = &found.items[i];
        const whirl_verdict verdict = whirl_table_verdict(table, one->first);
        char name[WHIRL_NAME_SIZE];
        whirl_verdict_name(&verdict, name, sizeof name);
        put_count_cell(&row, one->place + 1);
        if (*table->parameter) put_value_cell(&row, result, table->parameter, table->values[one->first]);
        if (table->row > 0) put_value_cell(&row, result, table->second, whirl_table_second(table, one->first));
        if (table->plane > 0) put_value_cell(&row, result, table->third, whirl_table_third(table, one->first));
        put_count_cell(&row, one->number);
        put_cell(&row, name);
        put_count_cell(&row, one->starts);
        put_count_cell(&row, one->of);
        put_number_cell(&row, one->share);
        put_number_cell(&row, one->error);
        put_count_cell(&row, whirl_table_slot(table, one->first) + 1);
        end_line(&row);
    }
    whirl_coexistence_free(&found);
}

typedef void (*write_fn)(FILE *stream, const whirl_result *result, const whirl_table *table, const whirl_field *field);

/// Content of one file of an export, FOLDER/NAME.csv.
typedef struct csv_file {
    write_fn write;
    const whirl_result *result;
    const whirl_table *table;
    const whirl_field *field;
} csv_file;

/// Action on the files of an export: write them, or look for existing ones.
typedef struct csv_visitor {
    const char *folder;
    const whirl_result *result;
    whirl_status (*visit)(void *context, const csv_file *file, const char *path);
    void *context;
} csv_visitor;

/// Writes a file, whole or not at all.
static whirl_status csv_write(void *context, const csv_file *file, const char *path) {
    atomic_file out;
    (void)context;
    const whirl_status status = atomic_file_open(&out, path);
    if (status.code != WHIRL_OK) return status;
    file->write(out.stream, file->result, file->table, file->field);
    return atomic_file_commit(&out);
}

/// Stores the path if a file exists there and none was found before.
static whirl_status csv_look(void *context, const csv_file *file, const char *path) {
    char *const found = context;
    (void)file;
    if (!*found && atomic_file_there(path)) snprintf(found, ATOMIC_PATH_SIZE, "%s", path);
    return whirl_ok();
}

static whirl_status csv_visit(const csv_visitor *by, const char *name, write_fn write, const whirl_table *table,
                              const whirl_field *field) {
    const csv_file file = {write, by->result, table, field};
    char path[ATOMIC_PATH_SIZE];
    if (snprintf(path, sizeof path, "%s/%s.csv", by->folder, name) >= (int)sizeof path)
        return whirl_fail(WHIRL_IO_ERROR, "cannot write %s.csv: the path is too long", name);
    return by->visit(by->context, &file, path);
}

static whirl_status csv_visit_table(const csv_visitor *by, const whirl_table *table) {
    whirl_status status = csv_visit(by, table->name, write_points, table, NULL);
    const whirl_layout *layout = &table->layout;
    char attractors[WHIRL_NAME_SIZE + 16];
    snprintf(attractors, sizeof attractors, "%s-attractors", table->name);
    if (table->starts > 1 && status.code == WHIRL_OK) status = csv_visit(by, attractors, write_attractors, table, NULL);
    for (size_t i = 0; i < layout->field_count && status.code == WHIRL_OK; ++i) {
        const whirl_field *field = &layout->fields[i];
        char name[2 * WHIRL_NAME_SIZE + 8];
        if (field->singles > 0 || field->rows == 1) continue;
        snprintf(name, sizeof name, "%s-%s", table->name, field->name);
        for (char *slash = name; (slash = strchr(slash, '/'));) *slash = '-';
        status = csv_visit(by, name, write_rows, table, field);
    }
    return status;
}

/// Visits all files of an export, in order.
static whirl_status csv_visit_all(const csv_visitor *by) {
    whirl_status status = csv_visit(by, "parameters", write_parameters, NULL, NULL);
    if (status.code == WHIRL_OK) status = csv_visit(by, "options", write_options, NULL, NULL);
    for (size_t i = 0; i < by->result->table_count && status.code == WHIRL_OK; ++i) {
        const char *name = by->result->tables[i].name;
        if (!format_is_name(name, 0) || format_reserved(name))
            return whirl_fail(WHIRL_BAD_INPUT, "'%s' cannot name a table", name);
        status = csv_visit_table(by, &by->result->tables[i]);
    }
    return status;
}

whirl_status whirl_result_export_csv(const whirl_result *result, const char *path) {
    const csv_visitor writer = {path, result, csv_write, NULL};
    const whirl_status status = atomic_folder(path);
    return status.code == WHIRL_OK ? csv_visit_all(&writer) : status;
}

bool whirl_result_find_csv(const whirl_result *result, const char *path, char *found, size_t size) {
    char first[ATOMIC_PATH_SIZE] = "";
    const csv_visitor looker = {path, result, csv_look, first};
    csv_visit_all(&looker); // a table that cannot name a file is reported by whirl_result_export_csv
    snprintf(found, size, "%s", first);
    return *first != '\0';
}
