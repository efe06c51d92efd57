// Vectors of HDF5 files as tables of numbers.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "csv_part.h"
#include "whirl/engine/case.h"
#include "whirl/internal/arrays.h"
#include "whirl/status.h"

/// Most numbers of a table.
#define VECTORS_MAX_NUMBERS ((size_t)1 << 27U)

/// A vector of a file: a dataset, or a part of it in which one index runs.
typedef struct vector_part {
    char name[CSV_TEXT]; ///< the dataset
    arrays_item item;
    size_t first[ARRAYS_MAX_RANK], count[ARRAYS_MAX_RANK];
    size_t length; ///< of the vector
} vector_part;

/// Describes the shape of a dataset: "60 x 3 x 1600".
static const char *vector_shape(const arrays_item *item, char text[CSV_TEXT]) {
    text[0] = '\0';
    for (int i = 0; i < item->rank; i++) {
        const size_t used = strlen(text);
        snprintf(text + used, CSV_TEXT - used, "%s%zu", i ? " x " : "", item->sizes[i]);
    }
    return text;
}

/// Takes a dataset whose numbers are in one row or column as a vector; false for others.
static bool vector_of_all(vector_part *out) {
    int longer = 0;
    bool empty = false;
    out->length = 1;
    for (int i = 0; i < out->item.rank; i++) {
        const size_t size = out->item.sizes[i];
        out->first[i] = 0;
        out->count[i] = size;
        empty = empty || size == 0;
        longer += size > 1;
        if (size > 1) out->length = size;
    }
    return out->item.rank > 0 && longer <= 1 && !empty;
}

/// Reads an index, from 0 or from the end, or ':'. Returns false if it is neither, or not in the dataset.
static bool vector_index(const char **at, size_t size, size_t *first, size_t *count) {
    while (isblank((unsigned char)**at)) ++*at;
    if (**at == ':') {
        ++*at;
        *first = 0;
        *count = size;
    } else {
        char *end;
        const double number = strtod(*at, &end);
        const double index = number < 0.0 ? number + (double)size : number;
        if (end == *at || index != floor(index) || !(index >= 0.0 && index < (double)size)) return false;
        *at = end;
        *first = (size_t)index;
        *count = 1;
    }
    while (isblank((unsigned char)**at)) ++*at;
    return true;
}

/// Understands "run/signals[:, 2]", where a dataset of that whole name does not exist.
static whirl_status vector_find(arrays_file *file, const char *path, const char *text, vector_part *out) {
    char shape[CSV_TEXT];
    const size_t length = strlen(text);
    const char *bracket = length > 0 && text[length - 1] == ']' ? strrchr(text, '[') : NULL;
    snprintf(out->name, sizeof out->name, "%s", text);
    whirl_status status = arrays_find(file, out->name, &out->item);
    const bool indexed = status.code == WHIRL_BAD_INPUT && bracket && bracket > text;
    if (indexed) {
        out->name[bracket - text] = '\0';
        status = arrays_find(file, out->name, &out->item);
    }
    if (status.code != WHIRL_OK) return status;
    if (!out->item.numbers)
        return whirl_fail(WHIRL_BAD_INPUT, "%.150s: %s has %s, expected numbers", path, out->name, out->item.described);
    if (!indexed) {
        if (vector_of_all(out)) return whirl_ok();
        return out->item.rank == 0
                   ? whirl_fail(WHIRL_BAD_INPUT, "%.150s: %s is a single number, expected a vector", path, out->name)
                   : whirl_fail(WHIRL_BAD_INPUT,
                                "%.150s: %s has %s numbers, expected a vector, or indices one of which is ':', as in "
                                "%s[:%s]",
                                path, out->name, vector_shape(&out->item, shape), out->name,
                                out->item.rank == 2 ? ", 0" : ", 0, 0");
    }
    // One index runs, the others are numbers.
    const char *at = bracket + 1;
    int running = 0;
    bool good = true;
    for (int i = 0; i < out->item.rank && good; i++) {
        const bool runs = at[strspn(at, " \t")] == ':';
        good = vector_index(&at, out->item.sizes[i], &out->first[i], &out->count[i]) &&
               *at == (i + 1 < out->item.rank ? ',' : ']');
        at += good;
        running += runs;
        if (runs) out->length = out->item.sizes[i];
    }
    if (good && running == 1) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "%.150s: %.40s are no indices of %s, which has %s numbers: expected one for each dimension, from "
                      "0, and one of them ':'",
                      path, bracket, out->name, vector_shape(&out->item, shape));
}

/// Adds a column without numbers.
static whirl_status vector_add_column(csv_table *table, const char *heading, const char *unit, const char *source,
                                      size_t most) {
    char text[CSV_TEXT];
    if (table->column_count == most)
        return whirl_fail(WHIRL_BAD_INPUT, "%.200s: has more than %zu columns, expected `columns` that choose",
                          table->path, most);
    csv_column *columns = realloc(table->columns, (table->column_count + 1) * sizeof *columns);
    if (!columns) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a table");
    table->columns = columns;
    csv_column *own = &columns[table->column_count];
    *own = (csv_column){.place = CSV_VECTOR + (int)table->column_count};
    snprintf(text, sizeof text, "%s", heading);
    csv_part(own, text);
    if (!*own->unit) snprintf(own->unit, sizeof own->unit, "%.*s", CSV_TEXT - 1, unit);
    snprintf(own->source, sizeof own->source, "%s", source);
    table->column_count++;
    return whirl_ok();
}

/// Makes room for the numbers of the last column, NULL without memory; the first one gives the number of rows.
static double *vector_room(csv_table *table, size_t count) {
    if (table->column_count == 1) {
        table->count = table->capacity = count;
        table->lines = malloc((count + 1) * sizeof *table->lines);
        for (size_t i = 0; table->lines && i < count; i++) table->lines[i] = (int)(i + 1);
    }
    double *numbers = realloc(table->numbers, (table->column_count * table->capacity + 1) * sizeof *numbers);
    if (numbers) table->numbers = numbers;
    if (!numbers || !table->lines) return NULL;
    return numbers + (table->column_count - 1) * table->capacity;
}

whirl_status csv_add_vector(csv_table *table, const char *heading, const char *unit, const char *source,
                            const double *numbers, size_t count) {
    table->vectors = true;
    const whirl_status status = vector_add_column(table, heading, unit, source, SIZE_MAX);
    if (status.code != WHIRL_OK) return status;
    double *own = vector_room(table, count);
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a table");
    memcpy(own, numbers, count * sizeof *own);
    return whirl_ok();
}

whirl_status csv_check_unit(const csv_table *table, size_t column, const char *unit) {
    const csv_column *own = &table->columns[column];
    char text[ARRAYS_TEXT + 4];
    double size = 0.0;
    if (!*unit || strcmp(unit, own->unit) == 0) return whirl_ok();
    snprintf(text, sizeof text, "1 %s", unit);
    if (whirl_quantity_value(text, own->unit, &size).code == WHIRL_OK && fabs(size - 1.0) < 1e-9) return whirl_ok();
    return csv_fail(table, table->heading, own->place, "its unit is '%.40s', and [%.40s] in its heading, expected one",
                    unit, own->unit);
}

/// Reads the numbers of a vector as the last column of the table.
static whirl_status vector_take(arrays_file *file, csv_table *table, const vector_part *part) {
    const csv_column *own = &table->columns[table->column_count - 1];
    if (table->column_count > 1 && part->length != table->count)
        return csv_fail(table, table->heading, own->place,
                        "it has %zu numbers, and %s has %zu, expected as many in all", part->length,
                        table->columns[0].source, table->count);
    if (part->length > VECTORS_MAX_NUMBERS / table->column_count)
        return csv_fail(table, table->heading, own->place, "it has %zu numbers, expected at most %zu in all columns",
                        part->length, VECTORS_MAX_NUMBERS);
    double *numbers = vector_room(table, part->length);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a table");
    const whirl_status status = arrays_read(file, part->name, part->first, part->count, numbers);
    if (status.code != WHIRL_OK) return status;
    for (size_t i = 0; i < part->length; i++) {
        if (!isfinite(numbers[i]))
            return csv_fail(table, table->lines[i], own->place, "it is no number: cut the record at its gaps");
        numbers[i] *= part->item.factor;
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- all vectors

/// Vectors of a file that are found.
typedef struct vector_search {
    size_t count, most, capacity;
    struct {
        char name[CSV_TEXT];
    } * found;
} vector_search;

static whirl_status vector_note(void *context, const char *name, const arrays_item *item) {
    vector_search *of = context;
    vector_part part = {.item = *item};
    if (!item->numbers || strlen(name) >= CSV_TEXT || !vector_of_all(&part) || part.length < 2 || of->count > of->most)
        return whirl_ok();
    if (of->count == of->capacity) {
        const size_t capacity = of->capacity ? 2 * of->capacity : 64;
        void *found = realloc(of->found, capacity * sizeof *of->found);
        if (!found) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a table");
        of->found = found;
        of->capacity = capacity;
    }
    snprintf(of->found[of->count++].name, CSV_TEXT, "%s", name);
    return whirl_ok();
}

/// Chooses all vectors of a file.
static whirl_status vector_all(arrays_file *file, const char *path, size_t most, vector_search *of) {
    char format[CSV_TEXT];
    of->most = most;
    whirl_status status = arrays_text(file, "/", "format", format, sizeof format);
    if (status.code == WHIRL_OK && strcmp(format, "whirl result") == 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "%.200s is a result of whirl, expected `record`, or `columns` that choose its numbers", path);
    if (status.code == WHIRL_OK) status = arrays_visit(file, vector_note, of);
    if (status.code != WHIRL_OK || of->count > 0) return status;
    return whirl_fail(WHIRL_BAD_INPUT, "%.200s: there is no vector of numbers, expected `columns` that choose some",
                      path);
}

/// Reads chosen vectors, or all, of a file that could be opened.
static whirl_status vector_read(arrays_file *file, const csv_chosen *chosen, size_t count, size_t most_columns,
                                csv_table *out) {
    vector_search all = {.count = 0};
    whirl_status status = count == 0 ? vector_all(file, out->path, most_columns, &all) : whirl_ok();
    const size_t columns = count > 0 ? count : all.count;
    for (size_t i = 0; i < columns && status.code == WHIRL_OK; i++) {
        const char *dataset = count > 0 ? chosen[i].dataset : all.found[i].name;
        vector_part part = {.length = 0};
        status = strlen(dataset) < CSV_TEXT
                     ? vector_find(file, out->path, dataset, &part)
                     : whirl_fail(WHIRL_BAD_INPUT, "%.150s: the name '%.60s...' has %zu bytes, expected at most %d",
                                  out->path, dataset, strlen(dataset), CSV_TEXT - 1);
        const char *unit = status.code == WHIRL_OK && strcmp(part.item.unit, "1") != 0 ? part.item.unit : "";
        if (status.code == WHIRL_OK)
            status = vector_add_column(out, count > 0 ? chosen[i].heading : dataset, unit, dataset, most_columns);
        if (status.code == WHIRL_OK) status = csv_check_unit(out, out->column_count - 1, unit);
        if (status.code == WHIRL_OK) status = vector_take(file, out, &part);
    }
    free(all.found);
    arrays_close(file);
    return status;
}

whirl_status csv_load_vectors(const char *path, const csv_chosen *chosen, size_t count, size_t most_columns,
                              csv_table *out) {
    arrays_file *file;
    *out = (csv_table){.path = path, .vectors = true};
    const whirl_status status = arrays_open(path, &file);
    return status.code == WHIRL_OK ? vector_read(file, chosen, count, most_columns, out) : status;
}

whirl_status csv_read_vectors(const char *path, const void *bytes, size_t size, const csv_chosen *chosen, size_t count,
                              size_t most_columns, csv_table *out) {
    arrays_file *file;
    *out = (csv_table){.path = path, .vectors = true};
    const whirl_status status = arrays_open_bytes(bytes, size, path, &file);
    return status.code == WHIRL_OK ? vector_read(file, chosen, count, most_columns, out) : status;
}

// ---------------------------------------------------------------- lists

/// Columns of a file that are found.
typedef struct vector_list {
    csv_listed *items;
    size_t count, capacity;
} vector_list;

/// Adds a column. Names that are too long cannot be chosen and are left out.
static whirl_status vector_list_add(vector_list *of, const char *name, const char *indices, const char *unit,
                                    size_t count) {
    if (strlen(name) + strlen(indices) >= CSV_TEXT) return whirl_ok();
    if (of->count == of->capacity) {
        const size_t capacity = of->capacity ? 2 * of->capacity : 64;
        csv_listed *items = realloc(of->items, capacity * sizeof *items);
        if (!items) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the columns of a file");
        of->items = items;
        of->capacity = capacity;
    }
    csv_listed *own = &of->items[of->count++];
    *own = (csv_listed){.count = count};
    snprintf(own->name, sizeof own->name, "%s%s", name, indices);
    snprintf(own->unit, sizeof own->unit, "%.*s", CSV_TEXT - 1, strcmp(unit, "1") != 0 ? unit : "");
    return whirl_ok();
}

/// Lists a dataset: a vector, or the rows or columns of a matrix, whichever are fewer.
static whirl_status vector_list_note(void *context, const char *name, const arrays_item *item) {
    enum { MAX_PARTS = 64 };
    vector_list *of = context;
    vector_part part = {.item = *item};
    if (!item->numbers) return whirl_ok();
    if (vector_of_all(&part))
        return part.length < 2 ? whirl_ok() : vector_list_add(of, name, "", item->unit, part.length);
    if (item->rank != 2) return whirl_ok();
    const bool rows = item->sizes[0] < item->sizes[1];
    const size_t parts = item->sizes[rows ? 0 : 1], length = item->sizes[rows ? 1 : 0];
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < parts && parts <= MAX_PARTS && status.code == WHIRL_OK; i++) {
        char indices[40];
        snprintf(indices, sizeof indices, rows ? "[%zu, :]" : "[:, %zu]", i);
        status = vector_list_add(of, name, indices, item->unit, length);
    }
    return status;
}

whirl_status csv_list_vectors(const char *path, const void *bytes, size_t size, csv_listed **out, size_t *count) {
    arrays_file *file;
    vector_list of = {.count = 0};
    *out = NULL;
    *count = 0;
    whirl_status status = arrays_open_bytes(bytes, size, path, &file);
    if (status.code != WHIRL_OK) return status;
    status = arrays_visit(file, vector_list_note, &of);
    arrays_close(file);
    if (status.code != WHIRL_OK) {
        free(of.items);
        return status;
    }
    *out = of.items;
    *count = of.count;
    return status;
}
