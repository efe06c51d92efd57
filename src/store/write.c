// Writes a result to an HDF5 file.
#include "atomic_file.h"
#include "finished.h"
#include "format.h"
#include "h5file.h"
#include "items.h"
#include "mapped.h"
#include "shape.h"
#include "whirl/internal/shown.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------- the case and its parts

static texts texts_of(const char *first, size_t stride, size_t count) {
    return (texts){first, stride, count};
}

/// Writes the units in which figures show numbers, for users who draw their own figures.
static void put_shown(whirl_status *status, hid_t group, const whirl_result *result) {
    whirl_shown_units units;
    if (status->code == WHIRL_OK) *status = whirl_result_shown_units(result, NULL, &units);
    if (status->code != WHIRL_OK) return;
    put_number_attribute(status, group, "shown_length", units.length);
    put_text_attribute(status, group, "shown_length_unit", units.length_name);
    put_whole_attribute(status, group, "shown_length_over", units.ratio);
    put_number_attribute(status, group, "shown_amplitude", units.amplitude);
    put_text_attribute(status, group, "shown_amplitude_unit", units.amplitude_name);
    put_number_attribute(status, group, "shown_frequency", units.frequency);
    put_text_attribute(status, group, "shown_frequency_unit", units.frequency_name);
}

static void put_case(whirl_status *status, hid_t file, const whirl_result *result) {
    const char *text = result->case_text ? result->case_text : "";
    if (strlen(text) > FORMAT_MAX_CASE_BYTES) {
        *status = whirl_fail(WHIRL_BAD_INPUT, "the text of the case has %zu bytes, expected at most %d", strlen(text),
                             FORMAT_MAX_CASE_BYTES);
        return;
    }
    const hid_t group = put_group(status, file, "case");
    put_texts(status, group, "text", texts_of(text, 0, 1));
    put_text_attribute(status, group, "name", result->case_name);
    put_number_attribute(status, group, "speed", result->speed);
    put_text_attribute(status, group, "speed_unit", "rad/s");
    put_number_attribute(status, group, "length_scale", result->length_scale);
    put_text_attribute(status, group, "length_scale_unit", "m");
    put_number_attribute(status, group, "force_scale", result->force_scale);
    put_text_attribute(status, group, "force_scale_unit", "N");
    put_shown(status, group, result);
    close_group(group);
}

static void put_parameters(whirl_status *status, hid_t file, const whirl_result *result) {
    const size_t count = result->parameter_count, stride = sizeof *result->parameters;
    const whirl_parameter *parameters = result->parameters;
    // Gather values and shown units.
    double *values = malloc((2 * count + 1) * sizeof *values), *sizes = values ? values + count : NULL;
    whirl_unit *shown = calloc(count + 1, sizeof *shown);
    whirl_shown_units units = {0};
    if (!values || !shown) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu parameters", count);
    if (status->code == WHIRL_OK) *status = whirl_result_shown_units(result, NULL, &units);
    for (size_t i = 0; i < count && status->code == WHIRL_OK; ++i) {
        values[i] = parameters[i].value;
        shown[i] = whirl_shown_parameter(&units, parameters[i].name);
        sizes[i] = shown[i].size;
    }
    // Write them, a data set each.
    const hid_t group = put_group(status, file, "parameters");
    put_texts(status, group, "name", texts_of(count ? parameters->name : "", stride, count));
    put_numbers(status, group, "value", values, list_of(count), "/parameters/unit");
    put_texts(status, group, "unit", texts_of(count ? parameters->unit : "", stride, count));
    put_texts(status, group, "text", texts_of(count ? parameters->text : "", stride, count));
    put_texts(status, group, "shown_unit", texts_of(shown ? shown->name : "", sizeof *shown, count));
    put_numbers(status, group, "shown_size", sizes, list_of(count), "/parameters/unit");
    close_group(group);
    free(values);
    free(shown);
}

static void put_stations(whirl_status *status, hid_t file, const whirl_result *result) {
    const size_t count = result->station_count;
    if (count > WHIRL_MAX_PROBES) {
        *status = whirl_fail(WHIRL_BAD_INPUT, "there are %zu stations, expected at most %d", count, WHIRL_MAX_PROBES);
        return;
    }
    const hid_t group = put_group(status, file, "stations");
    put_texts(status, group, "name", texts_of(count ? result->stations->name : "", sizeof *result->stations, count));
    for (const whirl_member *member = whirl_probe_members(); member->part; ++member) {
        double numbers[WHIRL_MAX_PROBES];
        int64_t wholes[WHIRL_MAX_PROBES];
        for (size_t i = 0; i < count; ++i) numbers[i] = whirl_member_number(member, &result->stations[i]);
        for (size_t i = 0; i < count; ++i) wholes[i] = (int64_t)numbers[i];
        if (member->type == WHIRL_MEMBER_NUMBER)
            put_numbers(status, group, member->name, numbers, list_of(count), member->key.unit);
        else
            put_wholes(status, group, member->name, wholes, list_of(count));
    }
    close_group(group);
}

static void put_contacts(whirl_status *status, hid_t file, const whirl_result *result) {
    const size_t count = result->contact_count;
    const hid_t group = put_group(status, file, "contacts");
    put_texts(status, group, "name", texts_of(count ? result->contacts[0] : "", WHIRL_NAME_SIZE, count));
    close_group(group);
}

static void put_provenance(whirl_status *status, hid_t file, const whirl_result *result) {
    const hid_t group = put_group(status, file, "provenance");
    for (size_t i = 0; i < result->fact_count; ++i)
        put_text_attribute(status, group, result->facts[i].name, result->facts[i].value);
    close_group(group);
}

// ---------------------------------------------------------------- tables

static void put_options(whirl_status *status, hid_t group, const whirl_member *member, const void *options) {
    for (; member->part; ++member)
        if (!member->name)
            continue;
        else if (member->type == WHIRL_MEMBER_WORD)
            put_text_attribute(status, group, member->name, (const char *)options + member->offset);
        else if (member->type == WHIRL_MEMBER_NUMBER)
            put_number_attribute(status, group, member->name, whirl_member_number(member, options));
        else
            put_whole_attribute(status, group, member->name, (int64_t)whirl_member_number(member, options));
}

/// Writes the names of the analyses: the bits of a set have other meanings in other versions.
static void put_analyses(whirl_status *status, hid_t group, whirl_analysis_set set) {
    char names[FORMAT_MAX_ANALYSES][WHIRL_NAME_SIZE];
    size_t count = 0;
    const whirl_analysis *analyses = whirl_analyses();
    for (size_t i = 0; i < FORMAT_MAX_ANALYSES && analyses[i].name; ++i)
        if (set >> i & 1u) snprintf(names[count++], WHIRL_NAME_SIZE, "%s", analyses[i].name);
    put_texts_attribute(status, group, "analyses", texts_of(names[0], WHIRL_NAME_SIZE, count));
}

/// Returns the shape of a table's datasets: a complete map with one start a place has its axes (planes, rows, columns);
/// other tables are lists.
static shape shape_of(const whirl_table *table) {
    const size_t row = table->row, plane = table->plane > 0 ? table->plane : table->count;
    const bool plain = row > 0 && table->refine == 0 && table->starts <= 1 && table->count == table->planned;
    if (!plain || plane == 0 || table->count % plane != 0 || plane % row != 0) return list_of(table->count);
    if (table->plane > 0) return (shape){3, {table->count / plane, plane / row, row}};
    return (shape){2, {plane / row, row}};
}

static void put_column_names(whirl_status *status, hid_t dataset, const whirl_field *field) {
    char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE];
    if (whirl_field_column_names(field, names))
        put_texts_attribute(status, dataset, "column_names", texts_of(names[0], WHIRL_NAME_SIZE, field->columns));
}

/// Begins the dataset of a field, with its attributes.
static void begin_field(whirl_status *status, column *out, hid_t group, const whirl_result *result,
                        const whirl_table *table, const whirl_field *field) {
    const shape points = shape_of(table);
    size_t dimensions[SHAPE_MAX_RANK];
    char names[SHAPE_MAX_RANK][WHIRL_NAME_SIZE];
    const int rank = format_dimensions(field, points, dimensions);
    if (field->singles > 0)
        column_of_singles(status, out, group, field->name, points, dimensions, rank, field->unit);
    else
        column_of_numbers(status, out, group, field->name, points, dimensions, rank, field->unit);
    (void)format_dimension_names(field, points, names);
    put_texts_attribute(status, out->dataset, "dimensions", texts_of(names[0], WHIRL_NAME_SIZE, (size_t)rank));
    const whirl_unit si = whirl_field_si(result, table, field);
    put_number_attribute(status, out->dataset, "SI_factor", si.size);
    put_text_attribute(status, out->dataset, "SI_unit", si.name);
    put_text_attribute(status, out->dataset, "meaning", field->meaning);
    put_column_names(status, out->dataset, field);
    put_text_attribute(status, out->dataset, "extent", format_extents[field->extent]);
    put_whole_attribute(status, out->dataset, "repeat", (int64_t)field->repeat);
    put_whole_attribute(status, out->dataset, "rows", (int64_t)field->rows);
    put_whole_attribute(status, out->dataset, "columns", (int64_t)field->columns);
    if (field->singles > 0) put_whole_attribute(status, out->dataset, "singles", (int64_t)field->singles);
}

/// Source of the numbers of a point.
typedef struct point_source {
    const whirl_result *result;
    const finished *own;
    const size_t *attractors;            ///< [points of the whole table] numbers of attractors
    const double *shares, *share_errors; ///< [points of the whole table] shares of starts, and their standard errors
} point_source;

typedef double (*number_of)(const point_source *from, size_t at);
typedef int64_t (*whole_of)(const point_source *from, size_t at);

/// Writes a dataset with one number for each point.
static void put_each_number(whirl_status *status, hid_t group, const char *name, const char *unit, number_of number,
                            const point_source *from) {
    const shape points = shape_of(&from->own->table);
    column out;
    if (status->code != WHIRL_OK) return;
    column_of_numbers(status, &out, group, name, points, points.sizes, points.rank, unit);
    for (size_t at = 0; status->code == WHIRL_OK && at < from->own->table.count; ++at) {
        const double value = number(from, at);
        mapped_evict_often(from->own->table.mapped, at);
        mapped_evict_often(from->own->mapped, at);
        column_put(status, &out, &value);
    }
    column_end(status, &out);
}

static void put_each_whole(whirl_status *status, hid_t group, const char *name, whole_of whole,
                           const point_source *from) {
    column out;
    if (status->code != WHIRL_OK) return;
    column_of_wholes(status, &out, group, name, shape_of(&from->own->table));
    for (size_t at = 0; status->code == WHIRL_OK && at < from->own->table.count; ++at) {
        const int64_t value = whole(from, at);
        mapped_evict_often(from->own->table.mapped, at);
        mapped_evict_often(from->own->mapped, at);
        column_put(status, &out, &value);
    }
    column_end(status, &out);
}

/// Writes the numbers of all fields in one pass over the points, since their blocks may be on disk.
static void put_fields(whirl_status *status, hid_t group, const whirl_result *result, const whirl_table *whole,
                       const finished *own) {
    column columns[WHIRL_MAX_FIELDS];
    const whirl_layout *layout = &whole->layout;
    for (size_t i = 0; i < layout->field_count; ++i)
        begin_field(status, &columns[i], group, result, &own->table, &layout->fields[i]);
    for (size_t at = 0; status->code == WHIRL_OK && at < own->table.count; ++at) {
        const double *block = whirl_table_block(whole, finished_point(own, at));
        if (!block)
            *status =
                whirl_fail(WHIRL_IO_ERROR, "point %zu of the %s is lost", finished_point(own, at) + 1, whole->name);
        for (size_t i = 0; block && i < layout->field_count; ++i)
            column_put(status, &columns[i], block + layout->fields[i].offset);
    }
    for (size_t i = 0; i < layout->field_count; ++i) column_end(status, &columns[i]);
}

/// Name and reason of a verdict, for readers of the file; this library reads only the numbers of verdicts.
typedef struct verdict_words {
    char name[WHIRL_NAME_SIZE], reason[WHIRL_MESSAGE_SIZE];
} verdict_words;

static void put_into_words(const whirl_table *table, size_t point, verdict_words *words) {
    // The zero bytes after the texts are written, too.
    *words = (verdict_words){.name = ""};
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    whirl_verdict_name(&verdict, words->name, sizeof words->name);
    whirl_verdict_reason(&verdict, words->reason, sizeof words->reason);
}

static void put_verdicts(whirl_status *status, hid_t group, const whirl_table *whole, const finished *own) {
    verdict_words words;
    size_t longest_name = 0, longest_reason = 0;
    column names, reasons;
    if (status->code != WHIRL_OK) return;
    // Find the longest texts.
    for (size_t i = 0; i < own->table.count; ++i) {
        put_into_words(whole, finished_point(own, i), &words);
        const size_t name = strlen(words.name), reason = strlen(words.reason);
        if (name > longest_name) longest_name = name;
        if (reason > longest_reason) longest_reason = reason;
    }
    // Write names and reasons.
    const hid_t verdicts = put_group(status, group, "verdict");
    column_of_texts(status, &names, verdicts, "name", shape_of(&own->table), longest_name + 1);
    column_of_texts(status, &reasons, verdicts, "reason", shape_of(&own->table), longest_reason + 1);
    for (size_t i = 0; status->code == WHIRL_OK && i < own->table.count; ++i) {
        put_into_words(whole, finished_point(own, i), &words);
        column_put(status, &names, words.name);
        column_put(status, &reasons, words.reason);
    }
    column_end(status, &names);
    column_end(status, &reasons);
    close_group(verdicts);
}

/// Checks the fields of a table before they are written: names, meanings, columns, and offsets without gaps.
static whirl_status check_layout(const whirl_table *table) {
    const whirl_layout *layout = &table->layout;
    size_t offset = 0;
    for (size_t i = 0; i < layout->field_count; ++i) {
        const whirl_field *field = &layout->fields[i];
        if (!format_is_name(field->name, 1) || strncmp(field->name, "verdict/", 8) == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "table %s: '%s' cannot name a field, expected analysis/quantity",
                              table->name, field->name);
        if (field->offset != offset)
            return whirl_fail(WHIRL_BAD_INPUT, "table %s: the field %s lies at %zu, expected %zu", table->name,
                              field->name, field->offset, offset);
        if (strlen(field->meaning) >= FORMAT_MAX_MEANING)
            return whirl_fail(WHIRL_BAD_INPUT, "table %s: the meaning of %s is longer than %d bytes", table->name,
                              field->name, FORMAT_MAX_MEANING - 1);
        if (field->columns == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "table %s: the field %s has no columns, expected one at least",
                              table->name, field->name);
        offset += field->repeat * field->rows * field->columns;
    }
    if (offset != layout->size)
        return whirl_fail(WHIRL_BAD_INPUT, "table %s: a block has %zu numbers, expected %zu", table->name, layout->size,
                          offset);
    return whirl_ok();
}

static double value_of(const point_source *from, size_t at) {
    return from->own->table.values[at];
}

static double length_scale_of(const point_source *from, size_t at) {
    return whirl_result_length_scale(from->result, &from->own->table, at);
}

static int64_t branch_of(const point_source *from, size_t at) {
    return from->own->table.branch[at];
}

/// Returns the index of a point in the study, from 1.
static int64_t place_of(const point_source *from, size_t at) {
    return (int64_t)whirl_table_slot(&from->own->table, at) + 1;
}

static int64_t attractor_of(const point_source *from, size_t at) {
    return (int64_t)from->attractors[finished_point(from->own, at)];
}

static double share_of(const point_source *from, size_t at) {
    return from->shares[finished_point(from->own, at)];
}

static double share_error_of(const point_source *from, size_t at) {
    return from->share_errors[finished_point(from->own, at)];
}

/// Writes the attractor of every point of a basin, or of a table with several starts a place, its share of the starts,
/// and the share's standard error; for people, like verdicts in words.
static void put_attractors(whirl_status *status, hid_t group, const whirl_table *whole, const finished *own) {
    const size_t count = whole->count;
    size_t *attractors = calloc(count + 1, sizeof *attractors);
    double *shares = calloc(2 * count + 1, sizeof *shares), *errors = shares ? shares + count : NULL;
    *status = attractors && shares ? whirl_table_attractor_numbers(whole, attractors, shares, errors)
                                   : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", count);
    const point_source from = {.own = own, .attractors = attractors, .shares = shares, .share_errors = errors};
    put_each_whole(status, group, "attractor", attractor_of, &from);
    put_each_number(status, group, "share", "1", share_of, &from);
    put_each_number(status, group, "share_error", "1", share_error_of, &from);
    free(attractors);
    free(shares);
}

/// Writes the values of the second or third parameter at points `step` apart.
static void put_axis(whirl_status *status, hid_t group, const char *name, const whirl_table *whole, const finished *own,
                     const char *unit, double (*value)(const whirl_table *table, size_t point), size_t count,
                     size_t step) {
    if (status->code != WHIRL_OK) return;
    double *values = malloc((count + 1) * sizeof *values);
    if (!values) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an axis of %zu values", count);
    for (size_t i = 0; values && i < count; ++i) values[i] = value(whole, finished_point(own, i * step));
    put_numbers(status, group, name, values, list_of(count), unit);
    free(values);
}

/// Writes the axes of a complete map, whose points have a dimension for each: "x" of its columns, "y" of its rows, "z"
/// of its planes. These are for users of the file: this library reads the values of the points.
static void put_axes(whirl_status *status, hid_t group, const whirl_result *result, const whirl_table *whole,
                     const finished *own) {
    const shape map = shape_of(&own->table);
    if (map.rank < 2) return;
    const size_t row = map.sizes[map.rank - 1], rows = map.sizes[map.rank - 2];
    put_numbers(status, group, "x", own->table.values, list_of(row),
                whirl_result_parameter_unit(result, whole->parameter));
    put_axis(status, group, "y", whole, own, whirl_result_parameter_unit(result, whole->second), whirl_table_second,
             rows, row);
    if (map.rank == 3)
        put_axis(status, group, "z", whole, own, whirl_result_parameter_unit(result, whole->third), whirl_table_third,
                 map.sizes[0], row * rows);
}

static void put_points(whirl_status *status, hid_t group, const whirl_result *result, const whirl_table *whole) {
    finished own;
    *status = finished_points(whole, &own);
    if (status->code != WHIRL_OK) return;
    put_whole_attribute(status, group, "points", (int64_t)own.table.planned);
    const point_source from = {.result = result, .own = &own};
    put_each_number(status, group, "values", whirl_result_parameter_unit(result, whole->parameter), value_of, &from);
    put_axes(status, group, result, whole, &own);
    put_each_whole(status, group, "branch", branch_of, &from);
    put_each_whole(status, group, "point", place_of, &from);
    put_each_number(status, group, "length_scale", "m", length_scale_of, &from);
    if (status->code == WHIRL_OK) put_fields(status, group, result, whole, &own);
    if (whirl_layout_has_verdict(&whole->layout)) put_verdicts(status, group, whole, &own);
    const bool attractors = whole->starts > 1 || whole->role == WHIRL_ROLE_BASIN;
    if (status->code == WHIRL_OK && attractors) put_attractors(status, group, whole, &own);
    finished_free(&own);
}

static void put_table(whirl_status *status, hid_t file, const whirl_result *result, const whirl_table *table) {
    // Names, and the shape of the points.
    if (status->code == WHIRL_OK) *status = check_layout(table);
    const hid_t group = put_group(status, file, table->name);
    const whirl_layout *layout = &table->layout;
    put_text_attribute(status, group, "role", whirl_role_name(table->role));
    put_text_attribute(status, group, "parameter", table->parameter);
    put_whole_attribute(status, group, "clock_of", table->clock_of);
    put_number_attribute(status, group, "clock_factor", table->clock_factor);
    if (*table->second) put_text_attribute(status, group, "second", table->second);
    if (table->row > 0) put_whole_attribute(status, group, "row", (int64_t)table->row);
    if (table->plane > 0) {
        put_text_attribute(status, group, "third", table->third);
        put_whole_attribute(status, group, "plane", (int64_t)table->plane);
    }
    if (table->starts > 1) put_whole_attribute(status, group, "starts", (int64_t)table->starts);
    if (table->neighbours > 0) {
        put_whole_attribute(status, group, "neighbours", (int64_t)table->neighbours);
        put_whole_attribute(status, group, "places", (int64_t)table->places);
    }
    if (table->refine > 0) {
        put_whole_attribute(status, group, "refine", (int64_t)table->refine);
        put_whole_attribute(status, group, "grid", (int64_t)table->grid);
    }
    // Analyses, fields and options.
    put_analyses(status, group, table->analyses);
    put_texts_attribute(status, group, "fields",
                        texts_of(layout->fields[0].name, sizeof *layout->fields, layout->field_count));
    const whirl_member *members;
    for (size_t i = 0, at; (members = whirl_table_options(table, i, &at)) != NULL; i++)
        put_options(status, group, members, (const char *)table + at);
    if (status->code == WHIRL_OK) put_points(status, group, result, table);
    close_group(group);
}

// ---------------------------------------------------------------- the whole file

static whirl_status check_tables(const whirl_result *result) {
    if (result->table_count > FORMAT_MAX_TABLES)
        return whirl_fail(WHIRL_BAD_INPUT, "there are %zu tables, expected at most %d", result->table_count,
                          FORMAT_MAX_TABLES);
    for (size_t i = 0; i < result->table_count; ++i) {
        const char *name = result->tables[i].name;
        if (!format_is_name(name, 0) || format_reserved(name) || whirl_result_table(result, name) != &result->tables[i])
            return whirl_fail(WHIRL_BAD_INPUT, "'%s' cannot name a table, expected a new word of letters and digits",
                              name);
    }
    return whirl_ok();
}

static void put_result(whirl_status *status, hid_t file, const whirl_result *result) {
    size_t done, total;
    *status = check_tables(result);
    put_text_attribute(status, file, "format", FORMAT_NAME);
    put_whole_attribute(status, file, "format_version", FORMAT_VERSION);
    put_whole_attribute(status, file, "partial", whirl_result_partial(result, &done, &total));
    put_text_attribute(status, file, "title", result->title);
    put_texts_attribute(
        status, file, "tables",
        texts_of(result->table_count ? result->tables->name : "", sizeof *result->tables, result->table_count));
    if (status->code == WHIRL_OK) put_case(status, file, result);
    if (status->code == WHIRL_OK) put_parameters(status, file, result);
    if (status->code == WHIRL_OK) put_stations(status, file, result);
    put_contacts(status, file, result);
    put_provenance(status, file, result);
    for (size_t i = 0; i < result->table_count; ++i) put_table(status, file, result, &result->tables[i]);
}

static whirl_status make_file(const whirl_result *result, int descriptor) {
    h5_bytes bytes;
    hid_t file;
    whirl_status status = h5_create(&bytes, descriptor, &file);
    if (status.code != WHIRL_OK) return status;
    put_result(&status, file, result);
    const whirl_status closed = h5_finish(&bytes, file);
    // An error of the disk comes first: it causes all later failures.
    return bytes.reason || status.code == WHIRL_OK ? closed : status;
}

whirl_status whirl_result_write(const whirl_result *result, const char *path) {
    atomic_file out;
    whirl_status status = atomic_file_open(&out, path);
    if (status.code != WHIRL_OK) return status;
    const h5_errors errors = h5_quiet();
    status = make_file(result, fileno(out.stream));
    h5_loud(errors);
    if (status.code == WHIRL_OK) return atomic_file_commit(&out);
    atomic_file_discard(&out);
    return whirl_fail(status.code, "cannot write %.100s: %.250s", path, status.message);
}
