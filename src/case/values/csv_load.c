// Tables of numbers from text files and from files of arrays (HDF5, MAT, universal), and columns chosen from them.
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "csv_part.h"
#include "input.h"
#include "whirl/engine/case.h"
#include "whirl/internal/arrays.h"
#include "whirl/internal/csv.h"

/// CSV_MAX_BYTES: largest text file. CSV_MAX_COLUMNS: most columns that a text file may have if only some are chosen.
enum { CSV_MAX_BYTES = 1 << 30, CSV_MAX_COLUMNS = 4096 };

bool csv_is_measured(const char *name) {
    static const char *const ends[] = {".h5", ".hdf5", ".mat", ".uff", ".unv"};
    const char *dot = strrchr(name, '.');
    for (size_t i = 0; dot && i < sizeof ends / sizeof *ends; i++) {
        size_t k = 0;
        while (dot[k] && tolower((unsigned char)dot[k]) == ends[i][k]) k++;
        if (!dot[k] && !ends[i][k]) return true;
    }
    return false;
}

// ---------------------------------------------------------------- columns of text files

/// Returns the index of the column that `text` chooses, or column_count.
static size_t csv_find(const csv_table *table, const char *text) {
    static const char numbered[] = "column ";
    char whole[2 * CSV_TEXT + 4];
    for (size_t c = 0; c < table->column_count; c++) {
        const csv_column *own = &table->columns[c];
        snprintf(whole, sizeof whole, "%s [%s]", own->name, own->unit);
        if (strcmp(own->name, text) == 0 || strcmp(whole, text) == 0) return c;
        snprintf(whole, sizeof whole, "%s (%s)", own->name, own->unit);
        if (strcmp(whole, text) == 0) return c;
    }
    if (strncmp(text, numbered, sizeof numbered - 1) != 0) return table->column_count;
    char *end;
    const unsigned long number = strtoul(text + sizeof numbered - 1, &end, 10);
    return *end || number < 1 || number > table->column_count ? table->column_count : number - 1;
}

/// Fails for a column that the file does not have, with those that it has.
static whirl_status csv_fail_unknown(const csv_table *table, const char *text) {
    char names[WHIRL_MESSAGE_SIZE] = "";
    enum { SHOWN = 6 };
    for (size_t c = 0; c < table->column_count && c < SHOWN; c++) {
        const size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s'%.40s'", c ? ", " : "", table->columns[c].name);
    }
    return whirl_fail(WHIRL_BAD_INPUT, "%.150s: there is no column '%.60s', expected one of %.300s%s", table->path,
                      text, names, table->column_count > SHOWN ? ", ..." : "");
}

/// Returns true for the name of a unit; brackets of headings may have other remarks, "CH1 (raw)".
static bool csv_is_unit(const char *unit) {
    char text[CSV_TEXT + 4];
    double size = 0.0;
    snprintf(text, sizeof text, "1 %s", unit);
    return *unit && whirl_quantity_value(text, unit, &size).code == WHIRL_OK;
}

/// Replaces the columns of a table by chosen ones.
static whirl_status csv_choose(csv_table *table, const csv_chosen *chosen, size_t count) {
    csv_table own = *table;
    own.columns = calloc(count, sizeof *own.columns);
    own.numbers = malloc((count * table->count + 1) * sizeof *own.numbers);
    own.column_count = count;
    own.capacity = table->count;
    whirl_status status =
        own.columns && own.numbers ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for columns of a table");
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        char text[CSV_TEXT];
        csv_column *column = &own.columns[i];
        const size_t from = csv_find(table, chosen[i].dataset);
        if (from == table->column_count) {
            status = csv_fail_unknown(table, chosen[i].dataset);
            break;
        }
        // A unit of the heading must be that of the file, and stands for a missing one.
        const char *unit = table->columns[from].unit;
        snprintf(text, sizeof text, "%s", chosen[i].heading);
        *column = table->columns[from];
        column->unit[0] = '\0';
        csv_part(column, text);
        if (!*column->unit)
            memcpy(column->unit, unit, sizeof column->unit);
        else if (csv_is_unit(unit))
            status = csv_check_unit(&own, i, unit);
        memcpy(own.numbers + i * table->count, csv_numbers(table, from), table->count * sizeof *own.numbers);
    }
    // Keep the chosen columns, or those of the file.
    const csv_table *dropped = status.code == WHIRL_OK ? table : &own;
    free(dropped->columns);
    free(dropped->numbers);
    if (status.code == WHIRL_OK) *table = own;
    return status;
}

/// Reads the text of a table, and chooses columns unless `count` is 0.
static whirl_status csv_read_some(const char *path, const char *text, size_t length, const csv_chosen *chosen,
                                  size_t count, size_t most_columns, csv_table *out) {
    const whirl_status status = csv_read(path, text, length, count > 0 ? CSV_MAX_COLUMNS : most_columns, out);
    return status.code == WHIRL_OK && count > 0 ? csv_choose(out, chosen, count) : status;
}

// ---------------------------------------------------------------- files

whirl_status csv_load_chosen(const char *path, const csv_chosen *chosen, size_t count, size_t most_columns,
                             csv_table *out) {
    char *text = NULL;
    size_t length = 0;
    input_file in;
    *out = (csv_table){.path = path};
    if (arrays_is_file(path) || (count > 0 && csv_is_measured(path)))
        return csv_load_vectors(path, chosen, count, most_columns, out);
    if (!input_read(path, CSV_MAX_BYTES, &in, &text, &length))
        return whirl_fail(in.no_memory ? WHIRL_NO_MEMORY : WHIRL_BAD_INPUT, "cannot read %.200s: %.128s", path,
                          in.reason);
    const whirl_status status = in.size > length ? whirl_fail(WHIRL_BAD_INPUT, "%.200s: is larger than 1 GiB", path)
                                                 : csv_read_some(path, text, length, chosen, count, most_columns, out);
    free(text);
    return status;
}

whirl_status csv_load(const char *path, size_t most_columns, csv_table *out) {
    return csv_load_chosen(path, NULL, 0, most_columns, out);
}

whirl_status csv_read_chosen(const char *path, const void *bytes, size_t size, const csv_chosen *chosen, size_t count,
                             size_t most_columns, csv_table *out) {
    if (arrays_is_bytes(bytes, size) || csv_is_measured(path))
        return csv_read_vectors(path, bytes, size, chosen, count, most_columns, out);
    return csv_read_some(path, bytes, size, chosen, count, most_columns, out);
}

whirl_status csv_list(const char *path, const void *bytes, size_t size, csv_listed **out, size_t *count) {
    csv_table table = {.path = path};
    if (arrays_is_bytes(bytes, size) || csv_is_measured(path)) return csv_list_vectors(path, bytes, size, out, count);
    whirl_status status = csv_read(path, bytes, size, CSV_MAX_COLUMNS, &table);
    *count = 0;
    *out = status.code == WHIRL_OK ? calloc(table.column_count + 1, sizeof **out) : NULL;
    if (status.code == WHIRL_OK && !*out) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the columns of a file");
    for (size_t c = 0; c < table.column_count && status.code == WHIRL_OK; c++) {
        csv_listed *own = &(*out)[(*count)++];
        memcpy(own->name, table.columns[c].name, sizeof own->name);
        memcpy(own->unit, table.columns[c].unit, sizeof own->unit);
        own->count = table.count;
    }
    csv_free(&table);
    return status;
}
