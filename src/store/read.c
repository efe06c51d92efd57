// Reads a result from an HDF5 file. The file may come from anywhere, so that everything in it is checked before use.
#include "read.h"

#include "bytes.h"
#include "exhausted.h"
#include "format.h"
#include "h5file.h"
#include "items.h"
#include "mapped.h"
#include "shape.h"
#include "stored.h"
#include "whirl/engine/study.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/// A file that is being read, and the receiver of its points.
typedef struct reading {
    size_t limit;             ///< bytes of the file
    whirl_layout known;       ///< fields of this version of whirl
    const block_taker *taker; ///< receives the blocks; NULL: they go to the tables
} reading;

/// Returns zeroed memory, or NULL with the status set.
static void *take(whirl_status *status, size_t count, size_t size) {
    if (status->code != WHIRL_OK) return NULL;
    void *memory = calloc(count ? count : 1, size);
    if (!memory) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu x %zu bytes", count, size);
    return memory;
}

// ---------------------------------------------------------------- the case and its parts

static void get_case(whirl_status *status, hid_t file, whirl_result *result) {
    const hid_t group = get_group(status, file, "case");
    result->case_text = get_long_text(status, group, "text", FORMAT_MAX_CASE_BYTES);
    get_text_attribute(status, group, "name", result->case_name, sizeof result->case_name);
    get_number_attribute(status, group, "speed", &result->speed);
    get_number_attribute(status, group, "length_scale", &result->length_scale);
    get_number_attribute(status, group, "force_scale", &result->force_scale);
    close_group(group);
}

static void get_parameters(whirl_status *status, hid_t file, whirl_result *result) {
    const hid_t group = get_group(status, file, "parameters");
    const size_t count = get_length(status, group, "value", FORMAT_MAX_PARAMETERS);
    double *values = take(status, count, sizeof *values);
    whirl_parameter *parameters = take(status, count, sizeof *parameters);
    result->parameters = parameters;
    get_numbers(status, group, "value", values, list_of(count));
    if (status->code == WHIRL_OK) {
        const size_t stride = sizeof *parameters;
        get_texts(status, group, "name", parameters->name, sizeof parameters->name, stride, count);
        get_texts(status, group, "unit", parameters->unit, sizeof parameters->unit, stride, count);
        get_texts(status, group, "text", parameters->text, sizeof parameters->text, stride, count);
        for (size_t i = 0; i < count; ++i) parameters[i].value = values[i];
        result->parameter_count = count;
    }
    close_group(group);
    free(values);
}

/// Reads a member of all stations. Coordinates are indices of the state, which has four a station for a rotor and may
/// have more for other systems.
static void get_station_numbers(whirl_status *status, hid_t group, const whirl_member *member, whirl_probe *stations,
                                size_t count) {
    double numbers[WHIRL_MAX_PROBES];
    int64_t wholes[WHIRL_MAX_PROBES];
    const bool index = member->type != WHIRL_MEMBER_NUMBER;
    if (index)
        get_wholes(status, group, member->name, wholes, list_of(count));
    else
        get_numbers(status, group, member->name, numbers, list_of(count));
    for (size_t i = 0; status->code == WHIRL_OK && i < count; ++i) {
        if (index && (wholes[i] < 0 || wholes[i] > INT_MAX))
            *status = whirl_fail(WHIRL_BAD_INPUT, "/stations/%s holds %lld, expected an index", member->name,
                                 (long long)wholes[i]);
        else
            whirl_member_set(member, &stations[i], index ? (double)wholes[i] : numbers[i]);
    }
}

static void get_stations(whirl_status *status, hid_t file, whirl_result *result) {
    const hid_t group = get_group(status, file, "stations");
    const size_t count = get_length(status, group, "clearance", WHIRL_MAX_PROBES);
    whirl_probe *stations = take(status, count, sizeof *stations);
    result->stations = stations;
    if (status->code == WHIRL_OK)
        get_texts(status, group, "name", stations->name, sizeof stations->name, sizeof *stations, count);
    for (const whirl_member *member = whirl_probe_members(); status->code == WHIRL_OK && member->part; ++member)
        get_station_numbers(status, group, member, stations, count);
    if (status->code == WHIRL_OK) result->station_count = count;
    close_group(group);
}

static void get_contacts(whirl_status *status, hid_t file, whirl_result *result) {
    const hid_t group = get_group(status, file, "contacts");
    const size_t count = get_length(status, group, "name", WHIRL_MAX_CONTACTS);
    result->contacts = take(status, count, WHIRL_NAME_SIZE);
    get_texts(status, group, "name", (char *)result->contacts, WHIRL_NAME_SIZE, WHIRL_NAME_SIZE, count);
    if (status->code == WHIRL_OK) result->contact_count = count;
    close_group(group);
}

static void get_provenance(whirl_status *status, hid_t file, whirl_result *result) {
    const hid_t group = get_group(status, file, "provenance");
    const size_t count = get_attribute_count(status, group, FORMAT_MAX_FACTS);
    whirl_fact *facts = take(status, count, sizeof *facts);
    result->facts = facts;
    for (size_t i = 0; status->code == WHIRL_OK && i < count; ++i) {
        get_attribute_name(status, group, i, facts[i].name, sizeof facts[i].name);
        get_text_attribute(status, group, facts[i].name, facts[i].value, sizeof facts[i].value);
        whirl_make_plain(facts[i].name);
    }
    if (status->code == WHIRL_OK) result->fact_count = count;
    close_group(group);
}

// ---------------------------------------------------------------- tables

static void get_options(whirl_status *status, hid_t group, const whirl_member *member, void *options) {
    double number = 0.0;
    for (; status->code == WHIRL_OK && member->part; ++member) {
        const bool flag = member->type == WHIRL_MEMBER_FLAG;
        const double low = flag ? 0 : member->key.range.low, high = flag ? 1 : member->key.range.high;
        if (!member->name) continue;
        if (member->type == WHIRL_MEMBER_WORD)
            get_text_attribute(status, group, member->name, (char *)options + member->offset, WHIRL_NAME_SIZE);
        else if (member->type == WHIRL_MEMBER_NUMBER)
            get_number_attribute(status, group, member->name, &number);
        else
            number = (double)get_whole_attribute(status, group, member->name, (int64_t)low, (int64_t)high);
        if (status->code == WHIRL_OK) whirl_member_set(member, options, number);
    }
}

/// Reads the analyses. Unknown ones, of a later version, are skipped; their fields are read.
static void get_analyses(whirl_status *status, hid_t group, whirl_analysis_set *set) {
    char names[FORMAT_MAX_ANALYSES][WHIRL_NAME_SIZE];
    const size_t count = get_texts_attribute(status, group, "analyses", names[0], WHIRL_NAME_SIZE, FORMAT_MAX_ANALYSES);
    for (size_t i = 0; i < count; ++i) whirl_analysis_add(set, names[i]);
}

/// Unit and meaning of a field that was read from a file; fields of this program point to those of the registry.
typedef struct field_words {
    char unit[WHIRL_NAME_SIZE], meaning[FORMAT_MAX_MEANING];
} field_words;

static void get_extent(whirl_status *status, hid_t dataset, const whirl_result *result, whirl_field *field) {
    const size_t repeats[3] = {1, result->station_count, result->contact_count};
    char word[WHIRL_NAME_SIZE] = "";
    get_text_attribute(status, dataset, "extent", word, sizeof word);
    if (status->code != WHIRL_OK) return;
    for (int extent = 0; extent < 3; ++extent)
        if (strcmp(word, format_extents[extent]) == 0) {
            field->extent = (whirl_extent)extent;
            field->repeat = (size_t)get_whole_attribute(status, dataset, "repeat", (int64_t)repeats[extent],
                                                        (int64_t)repeats[extent]);
            return;
        }
    *status = whirl_fail(WHIRL_BAD_INPUT, "%s: extent is '%s', expected point, station or contact", field->name, word);
}

/// Checks that a known field has the extent and columns that this program expects, and one row where it expects one.
static void check_known(whirl_status *status, const whirl_layout *known, const whirl_field *field) {
    const whirl_field *ours = whirl_layout_field(known, field->name);
    if (status->code != WHIRL_OK || !ours) return;
    if (ours->extent != field->extent || ours->columns != field->columns || (ours->rows == 1 && field->rows != 1))
        *status = whirl_fail(WHIRL_BAD_INPUT, "%s has %zu x %zu numbers a %s, expected %zu x %zu a %s", field->name,
                             field->rows, field->columns, format_extents[field->extent], ours->rows, ours->columns,
                             format_extents[ours->extent]);
}

/// Reads shape, unit and meaning of a field. Its numbers, `count` times the shape, must fit into a file of `limit`
/// bytes.
static void get_field(whirl_status *status, hid_t group, const whirl_result *result, size_t count, size_t limit,
                      whirl_layout *layout, whirl_field *field, field_words *words) {
    const hid_t dataset = get_dataset(status, group, field->name);
    get_text_attribute(status, dataset, "unit", words->unit, sizeof words->unit);
    get_text_attribute(status, dataset, "meaning", words->meaning, sizeof words->meaning);
    field->unit = words->unit;
    field->meaning = words->meaning;
    get_extent(status, dataset, result, field);
    field->rows = (size_t)get_whole_attribute(status, dataset, "rows", 0, INT_MAX);
    field->columns = (size_t)get_whole_attribute(status, dataset, "columns", 1, INT_MAX);
    if (strcmp(field->name, WHIRL_FIELD_DATASET_SIGNALS) == 0)
        field->singles = (size_t)get_whole_attribute(status, dataset, "singles", 2, INT_MAX);
    close_dataset(dataset);
    if (status->code != WHIRL_OK) return;
    if (field->singles > 0 && field->singles != 2 * field->columns) {
        *status = whirl_fail(WHIRL_BAD_INPUT, "%s has %zu samples in %zu columns, expected two in each", field->name,
                             field->singles, field->columns);
        return;
    }
    // Two factors below 2^31 and one of at most 256 overflow no double, nor size_t once the product is small. A table
    // without points has no numbers, so that any shape is allowed.
    const double numbers = (double)field->rows * (double)field->columns * (double)(field->repeat ? field->repeat : 1);
    const double most = count ? (double)(limit / sizeof(double)) / (double)count : 0x1p31;
    if (numbers > most) {
        *status = whirl_fail(WHIRL_BAD_INPUT, "%s claims more numbers than the file has", field->name);
        return;
    }
    field->offset = layout->size;
    layout->size += field->repeat * field->rows * field->columns;
}

static void get_field_names(whirl_status *status, hid_t group, const char *table, whirl_layout *layout) {
    char names[WHIRL_MAX_FIELDS][WHIRL_NAME_SIZE];
    const size_t count = get_texts_attribute(status, group, "fields", names[0], WHIRL_NAME_SIZE, WHIRL_MAX_FIELDS);
    for (size_t i = 0; i < count; ++i) {
        if (!format_is_name(names[i], 1) || whirl_layout_field(layout, names[i])) {
            *status =
                whirl_fail(WHIRL_BAD_INPUT, "/%s has a field '%s', expected a new analysis/quantity", table, names[i]);
            return;
        }
        memcpy(layout->fields[i].name, names[i], WHIRL_NAME_SIZE);
        layout->field_count = i + 1;
    }
}

/// Returns a zeroed array of a table, in a file if it is large; NULL with the status set.
static void *take_array(whirl_status *status, whirl_table *table, size_t count, size_t size) {
    if (status->code != WHIRL_OK) return NULL;
    void *array = mapped_take(&table->mapped, count, size, MAPPED_MIN);
    if (!array) *status = whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu x %zu bytes", count, size);
    return array;
}

/// Opens a dataset with a number for each point. column_close must be called after a failure, too.
static column open_numbers(whirl_status *status, hid_t group, const char *name, shape points) {
    column from;
    column_open(status, &from, group, name, points, points.sizes, points.rank);
    return from;
}

static column open_wholes(whirl_status *status, hid_t group, const char *name, shape points) {
    column from;
    column_open_wholes(status, &from, group, name, points);
    return from;
}

/// Reads the values of the parameter. Returns the words of the fields, still empty, which follow in the same memory.
static field_words *get_values(whirl_status *status, hid_t group, shape points, whirl_table *table) {
    const size_t numbers = table->count * sizeof(double);
    table->values = take_array(status, table, 1, numbers + table->layout.field_count * sizeof(field_words) + 1);
    column from = open_numbers(status, group, "values", points);
    for (size_t i = 0; status->code == WHIRL_OK && i < table->count; ++i) {
        mapped_evict_often(table->mapped, i);
        column_get(status, &from, &table->values[i]);
    }
    column_close(&from);
    return table->values ? (field_words *)((char *)table->values + numbers) : NULL;
}

static void get_branch(whirl_status *status, hid_t group, shape points, whirl_table *table) {
    table->branch = take_array(status, table, table->count, sizeof *table->branch);
    column from = open_wholes(status, group, "branch", points);
    for (size_t i = 0; status->code == WHIRL_OK && i < table->count; ++i) {
        int64_t branch = 0;
        mapped_evict_often(table->mapped, i);
        column_get(status, &from, &branch);
        if (branch < -1 || branch > 1)
            *status = whirl_fail(WHIRL_BAD_INPUT, "/%s/branch holds %lld, expected -1, 0 or 1", table->name,
                                 (long long)branch);
        else
            table->branch[i] = (int)branch;
    }
    column_close(&from);
}

/// Reads the length scales; keeps them if a point's scale differs from the case's.
static void get_length_scales(whirl_status *status, hid_t group, const whirl_result *result, shape points,
                              whirl_table *table) {
    double *scales = table->length_scales = take_array(status, table, table->count, sizeof *scales);
    bool changes = false;
    column from = open_numbers(status, group, "length_scale", points);
    for (size_t i = 0; status->code == WHIRL_OK && i < table->count; ++i) {
        mapped_evict_often(table->mapped, i);
        column_get(status, &from, &scales[i]);
        const bool own = scales[i] != result->length_scale;
        changes = changes || own;
        if (status->code == WHIRL_OK && own && !(scales[i] > 0.0))
            *status = whirl_fail(WHIRL_BAD_INPUT, "/%s/length_scale holds %g, expected lengths above 0", table->name,
                                 scales[i]);
    }
    column_close(&from);
    if (changes) return;
    mapped_drop(&table->mapped, scales);
    table->length_scales = NULL;
}

/// Reads the grid of a refined map.
static void get_grid(whirl_status *status, hid_t group, whirl_table *table) {
    const int64_t most = (int64_t)1 << 28; // a drawing of the map visits all of them
    const bool refined = whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_WIDTH) &&
                         whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_SECOND);
    if (status->code != WHIRL_OK || !refined) return;
    table->refine = (size_t)get_whole_attribute(status, group, "refine", 2, WHIRL_MAX_SQUARE);
    table->grid = (size_t)get_whole_attribute(status, group, "grid", 1, most);
}

/// Reads the indices of the table's points in the study; leaves `slots` NULL if the table has all points.
static void get_slots(whirl_status *status, hid_t group, shape points, whirl_table *table) {
    table->slots = take_array(status, table, table->count, sizeof *table->slots);
    const int64_t most = (int64_t)1 << 48; // tables of all sizes can be summed
    const int64_t planned = get_whole_attribute(status, group, "points", (int64_t)table->count, most);
    const int64_t all = (int64_t)(table->places * (table->starts + WHIRL_MAX_NEIGHBOUR_STARTS));
    const int64_t last = table->grid > 0 ? (int64_t)table->grid : all > 0 ? all : planned;
    // Indices are counted from 1 in the file, and rise.
    int64_t before = 0, place = 0;
    column from = open_wholes(status, group, "point", points);
    for (size_t i = 0; status->code == WHIRL_OK && i < table->count; ++i) {
        mapped_evict_often(table->mapped, i);
        before = place;
        column_get(status, &from, &place);
        if (status->code == WHIRL_OK && (place <= before || place > last))
            *status = whirl_fail(WHIRL_BAD_INPUT, "/%s/point holds %lld, expected %lld to %lld", table->name,
                                 (long long)place, (long long)before + 1, (long long)last);
        table->slots[i] = (size_t)place - 1;
    }
    column_close(&from);
    if (status->code != WHIRL_OK) return;
    // A table with all points needs no indices.
    if ((size_t)planned > table->count) table->planned = (size_t)planned;
    if (table->planned > 0 || table->grid > 0 || table->places > 0) return;
    mapped_drop(&table->mapped, table->slots);
    table->slots = NULL;
}

/// Reads the blocks of all points, one after the other.
static void get_points(whirl_status *status, const whirl_table *table, size_t index, const block_taker *taker,
                       column *columns, double *block) {
    const whirl_layout *layout = &table->layout;
    const bool counted = whirl_layout_field(layout, WHIRL_FIELD_TRACE_REVOLUTIONS) ||
                         whirl_layout_field(layout, WHIRL_FIELD_TORUS_REVOLUTIONS);
    for (size_t point = 0; status->code == WHIRL_OK && point < table->count; ++point) {
        double *here = taker ? block : table->blocks + point * layout->size;
        for (size_t i = 0; i < layout->field_count; ++i)
            column_get(status, &columns[i], here + layout->fields[i].offset);
        if (status->code == WHIRL_OK && counted) *status = whirl_block_check(layout, here, &table->record);
        if (status->code == WHIRL_OK && taker) *status = taker->take(taker->context, table, index, point, block);
    }
}

static void get_blocks(whirl_status *status, hid_t group, shape points, whirl_table *table, size_t index,
                       const block_taker *taker) {
    column columns[WHIRL_MAX_FIELDS];
    const whirl_layout *layout = &table->layout;
    double *block = take(status, table->count > 0 ? layout->size : 0, sizeof *block);
    if (!taker) table->blocks = take(status, table->count * layout->size, sizeof *table->blocks);
    for (size_t i = 0; i < layout->field_count; ++i) {
        size_t dimensions[SHAPE_MAX_RANK];
        const int rank = format_dimensions(&layout->fields[i], points, dimensions);
        if (layout->fields[i].singles > 0)
            column_open_singles(status, &columns[i], group, layout->fields[i].name, points, dimensions, rank);
        else
            column_open(status, &columns[i], group, layout->fields[i].name, points, dimensions, rank);
    }
    get_points(status, table, index, taker, columns, block);
    for (size_t i = 0; i < layout->field_count; ++i) column_close(&columns[i]);
    free(block);
}

/// Reads the number of starts at every place.
static void get_starts(whirl_status *status, hid_t group, whirl_table *table) {
    const int64_t most = (int64_t)1 << 28;
    if (status->code != WHIRL_OK || !whirl_layout_field(&table->layout, WHIRL_FIELD_STARTS_NUMBER)) return;
    table->starts = (size_t)get_whole_attribute(status, group, "starts", 1, WHIRL_MAX_STARTS);
    if (!whirl_layout_field(&table->layout, WHIRL_FIELD_STARTS_NEIGHBOUR)) return;
    table->neighbours = (size_t)get_whole_attribute(status, group, "neighbours", 1, INT_MAX);
    table->places = (size_t)get_whole_attribute(status, group, "places", 1, most);
}

/// Checks that every place has the same number of starts, those from neighbours not counted.
static void check_starts(whirl_status *status, const whirl_table *table) {
    const size_t planned = whirl_table_planned(table), own = table->places * table->starts;
    if (status->code != WHIRL_OK || table->starts == 0) return;
    if (table->places > 0 ? planned < own : planned % table->starts != 0)
        *status =
            whirl_fail(WHIRL_BAD_INPUT, "/%s has %zu points from %zu starts each, expected as many from every one",
                       table->name, planned, table->starts);
}

/// Checks that a study of tolerances has the same number of points for every sampled machine.
static void check_samples(whirl_status *status, const whirl_table *table) {
    const whirl_field *values = whirl_layout_field(&table->layout, WHIRL_FIELD_TOLERANCES_VALUES);
    if (status->code != WHIRL_OK || table->role != WHIRL_ROLE_TOLERANCES) return;
    *status = whirl_members_check(whirl_tolerance_members(), &table->tolerances);
    if (status->code != WHIRL_OK) return;
    const size_t machines = whirl_tolerance_machines(&table->tolerances), planned = whirl_table_planned(table);
    if (!values || values->rows != (size_t)table->tolerances.parameters || planned == 0 || planned % machines != 0)
        *status = whirl_fail(WHIRL_BAD_INPUT,
                             "/%s has %zu points of %zu machines of samples, expected as many of every machine",
                             table->name, planned, machines);
}

/// Reads the planes of a map. Each must have all its rows, and each row all its points.
static void get_planes(whirl_status *status, hid_t group, size_t planned, whirl_table *table) {
    if (status->code != WHIRL_OK || !whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_THIRD) || table->grid > 0)
        return;
    get_text_attribute(status, group, "third", table->third, sizeof table->third);
    table->plane = (size_t)get_whole_attribute(status, group, "plane", 1, planned > 0 ? (int64_t)planned : 1);
    if (status->code == WHIRL_OK && (planned % table->plane != 0 || table->plane % table->row != 0))
        *status =
            whirl_fail(WHIRL_BAD_INPUT, "/%s has %zu points in planes of %zu and rows of %zu, expected whole ones",
                       table->name, planned, table->plane, table->row);
}

/// Checks that the datasets of a map have its rows and planes.
static void check_rows(whirl_status *status, shape points, size_t planned, const whirl_table *table) {
    const size_t row = points.sizes[points.rank - 1], plane = points.rank == 3 ? points.sizes[1] * row : 0;
    if (status->code != WHIRL_OK || points.rank == 1) return;
    if (row != table->row || plane != table->plane || planned != table->count)
        *status = whirl_fail(WHIRL_BAD_INPUT, "/%s has rows of %zu points, and %zu in a plane, expected %zu and %zu",
                             table->name, row, plane, table->row, table->plane);
}

/// Reads the second parameter of a map and the length of its rows, which its datasets must have, too.
static void get_plane(whirl_status *status, hid_t group, shape points, whirl_table *table) {
    const size_t planned = whirl_table_places(table);
    const bool is_map = whirl_layout_field(&table->layout, WHIRL_FIELD_MAP_SECOND);
    if (status->code == WHIRL_OK && points.rank > 1 && (!is_map || table->grid > 0))
        *status = whirl_fail(WHIRL_BAD_INPUT, "/%s has rows of points, expected a list", table->name);
    if (is_map || table->role == WHIRL_ROLE_CURVES)
        get_text_attribute(status, group, "second", table->second, sizeof table->second);
    if (status->code != WHIRL_OK || !is_map) return;
    table->row = (size_t)get_whole_attribute(status, group, "row", 1, planned > 0 ? (int64_t)planned : 1);
    if (status->code == WHIRL_OK && planned % table->row != 0)
        *status = whirl_fail(WHIRL_BAD_INPUT, "/%s has %zu points in rows of %zu, expected whole rows", table->name,
                             planned, table->row);
    get_planes(status, group, planned, table);
    check_rows(status, points, planned, table);
}

/// Removes fields in single precision from the layout: signals may be larger than the memory, and whirl_signals_read
/// reads them.
static void leave_out_signals(whirl_layout *layout) {
    const size_t all = layout->field_count;
    layout->field_count = layout->size = 0;
    for (size_t i = 0; i < all; ++i) {
        if (layout->fields[i].singles > 0) continue;
        whirl_field *kept = &layout->fields[layout->field_count++];
        *kept = layout->fields[i];
        kept->offset = layout->size;
        layout->size += kept->repeat * kept->rows * kept->columns;
    }
}

static void get_table(whirl_status *status, hid_t file, const whirl_result *result, const reading *how, size_t index) {
    whirl_table *table = &result->tables[index];
    const hid_t group = get_group(status, file, table->name);
    whirl_layout *layout = &table->layout;
    // Role, parameter and analyses.
    char role[WHIRL_NAME_SIZE] = "";
    get_text_attribute(status, group, "role", role, sizeof role);
    table->role = whirl_role_of(role);
    if (status->code == WHIRL_OK && table->role == WHIRL_ROLES)
        *status = whirl_fail(WHIRL_BAD_INPUT, "/%s has the role '%.40s', expected %s, %s, ...", table->name, role,
                             whirl_role_name(WHIRL_ROLE_POINT), whirl_role_name(WHIRL_ROLE_SURVEY));
    get_text_attribute(status, group, "parameter", table->parameter, sizeof table->parameter);
    get_analyses(status, group, &table->analyses);
    // Options; those of analyses that the table lacks have defaults.
    const whirl_member *members;
    whirl_members_default(whirl_trace_members(), &table->record.trace);
    whirl_members_default(whirl_runup_members(), &table->record.runup);
    whirl_members_default(whirl_fit_members(), &table->record.fit);
    whirl_members_default(whirl_dataset_members(), &table->record.dataset);
    for (size_t i = 0, at; (members = whirl_table_options(table, i, &at)) != NULL; i++)
        get_options(status, group, members, (char *)table + at);
    if (status->code == WHIRL_OK) *status = whirl_record_options_check(&table->record);
    // Fields and points.
    get_field_names(status, group, table->name, layout);
    const shape points = get_shape(status, group, "values", how->limit / sizeof(double));
    table->count = shape_count(points);
    field_words *words = get_values(status, group, points, table);
    get_branch(status, group, points, table);
    get_grid(status, group, table);
    get_starts(status, group, table);
    get_slots(status, group, points, table);
    check_starts(status, table);
    get_plane(status, group, points, table);
    get_length_scales(status, group, result, points, table);
    table->clock_of = (int)get_whole_attribute(status, group, "clock_of", 0, WHIRL_CLOCK_UNKNOWN);
    get_number_attribute(status, group, "clock_factor", &table->clock_factor);
    // Shapes and words of the fields.
    for (size_t i = 0; status->code == WHIRL_OK && i < layout->field_count; ++i) {
        get_field(status, group, result, table->count, how->limit, layout, &layout->fields[i], &words[i]);
        check_known(status, &how->known, &layout->fields[i]);
    }
    if (!how->taker) leave_out_signals(layout);
    check_samples(status, table);
    if (status->code == WHIRL_OK) *status = whirl_layout_check(layout, table->analyses, &table->record);
    // Each field fits into the file, so that a block of all fields takes at most 64 times its size. Each dataset is
    // checked before it is read.
    if (status->code == WHIRL_OK && (!how->taker || how->taker->take))
        get_blocks(status, group, points, table, index, how->taker);
    close_group(group);
}

static void get_tables(whirl_status *status, hid_t file, reading *how, whirl_result *result) {
    char names[FORMAT_MAX_TABLES][WHIRL_NAME_SIZE];
    const size_t count = get_texts_attribute(status, file, "tables", names[0], WHIRL_NAME_SIZE, FORMAT_MAX_TABLES);
    result->tables = take(status, count, sizeof *result->tables);
    if (status->code == WHIRL_OK) *status = whirl_layout_known(&how->known);
    for (size_t i = 0; status->code == WHIRL_OK && i < count; ++i) {
        if (!format_is_name(names[i], 0) || format_reserved(names[i]) || whirl_result_table(result, names[i])) {
            *status = whirl_fail(WHIRL_BAD_INPUT, "'%s' cannot name a table", names[i]);
            return;
        }
        memcpy(result->tables[i].name, names[i], WHIRL_NAME_SIZE);
        result->table_count = i + 1;
        get_table(status, file, result, how, i);
    }
}

// ---------------------------------------------------------------- the whole result

static void check_format(whirl_status *status, hid_t file) {
    char format[WHIRL_NAME_SIZE] = "";
    get_text_attribute(status, file, "format", format, sizeof format);
    if (status->code == WHIRL_OK && strcmp(format, FORMAT_NAME) != 0)
        *status = whirl_fail(WHIRL_BAD_INPUT, "is an HDF5 file, but not a result of whirl");
    const int64_t version = get_whole_attribute(status, file, "format_version", 1, INT_MAX);
    if (status->code == WHIRL_OK && version != FORMAT_VERSION)
        *status =
            whirl_fail(WHIRL_BAD_INPUT, "has format version %lld, this whirl reads version %d: %s", (long long)version,
                       FORMAT_VERSION, version < FORMAT_VERSION ? "compute it again" : "a later whirl reads it");
}

static void get_result(whirl_status *status, hid_t file, size_t limit, const block_taker *taker, whirl_result *result) {
    reading how = {.limit = limit, .taker = taker};
    check_format(status, file);
    result->partial = get_whole_attribute(status, file, "partial", 0, 1) != 0;
    get_text_attribute(status, file, "title", result->title, sizeof result->title);
    get_case(status, file, result);
    get_parameters(status, file, result);
    get_stations(status, file, result);
    get_contacts(status, file, result);
    get_provenance(status, file, result);
    get_tables(status, file, &how, result);
    stored_check_unread(status, file);
}

whirl_status read_result(const byte_source *source, const char *name, const block_taker *taker, whirl_result **result) {
    *result = calloc(1, sizeof **result);
    if (!*result) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a result");
    const int before = exhausted_watch();
    const h5_errors errors = h5_quiet();
    h5_bytes bytes;
    hid_t file;
    whirl_status status = h5_open(&bytes, source, &file);
    get_result(&status, file, (size_t)source->size, taker, *result);
    const bool no_memory = exhausted(before);
    h5_close(&bytes, file);
    if (no_memory) status = whirl_fail(WHIRL_NO_MEMORY, "no memory to read it");
    if (status.code == WHIRL_OK) {
        h5_loud(errors);
        return status;
    }
    // HDF5 1.10 leaks memory after a wrong checksum and would print messages at exit: they stay off after a damaged
    // file.
    whirl_result_free(*result);
    *result = NULL;
    if (bytes.reason) return whirl_fail(WHIRL_IO_ERROR, "cannot read %.250s: %s", name, strerror(bytes.reason));
    return whirl_fail(status.code, "%.120s: %.250s", name, status.message);
}

whirl_status read_file(const char *path, const block_taker *taker, whirl_result **result) {
    byte_file file;
    *result = NULL;
    whirl_status status = bytes_open(&file, path);
    if (status.code != WHIRL_OK) return status;
    status = read_result(&file.source, path, taker, result);
    bytes_close(&file);
    return status;
}

whirl_status whirl_result_read(const char *path, whirl_result **result) {
    return read_file(path, NULL, result);
}

whirl_status whirl_result_read_outline(const char *path, whirl_result **outline) {
    return read_file(path, &(block_taker){NULL, NULL}, outline);
}
