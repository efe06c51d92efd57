// Tables of numbers in text files.
#include "whirl/internal/csv.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "csv_part.h"
#include "utf8.h"
#include "whirl/engine/case.h"
#include "whirl/status.h"

enum { CSV_FIRST_ROWS = 4096 };

/// A table while it is read.
typedef struct csv_reader {
    csv_table *table;
    size_t most; ///< most columns
    char separator;
    int line;
} csv_reader;

whirl_status csv_fail(const csv_table *table, int line, int column, const char *format, ...) {
    char text[WHIRL_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const int vector = column - CSV_VECTOR;
    if (!table->vectors) return whirl_fail(WHIRL_BAD_INPUT, "%.150s:%d:%d: %.300s", table->path, line, column, text);
    if (vector < 0 || (size_t)vector >= table->column_count)
        return whirl_fail(WHIRL_BAD_INPUT, "%.150s: %.300s", table->path, text);
    if (line < 1)
        return whirl_fail(WHIRL_BAD_INPUT, "%.150s: %s: %.300s", table->path, table->columns[vector].source, text);
    return whirl_fail(WHIRL_BAD_INPUT, "%.150s: %s, number %d: %.300s", table->path, table->columns[vector].source,
                      line, text);
}

/// A cell of a line, without blanks and quotes around it; borrowed.
typedef struct csv_cell {
    const char *text;
    int length, place; ///< length in bytes; column of its first character in the line, from 1
} csv_cell;

/// Takes the next cell of a line that begins at `line`. Returns false after the last one.
static bool csv_next(const csv_reader *r, const char *line, const char **at, const char *end, csv_cell *cell) {
    if (!*at || *at > end) return false;
    const char *from = *at, *stop = memchr(from, r->separator, (size_t)(end - from));
    const char *to = stop ? stop : end;
    *at = stop ? stop + 1 : NULL;
    while (from < to && (isspace((unsigned char)*from) || *from == '"')) from++;
    while (to > from && (isspace((unsigned char)to[-1]) || to[-1] == '"')) to--;
    *cell = (csv_cell){from, (int)(to - from), (int)(from - line) + 1};
    return true;
}

/// Copies a cell. Fails for one that is longer than any name or number.
static whirl_status csv_copy(const csv_reader *r, const csv_cell *cell, char text[CSV_TEXT]) {
    if (cell->length >= CSV_TEXT)
        return csv_fail(r->table, r->line, cell->place, "the cell has %d bytes ('%.*s...'), expected at most %d",
                        cell->length, (int)utf8_cut(cell->text, 20), cell->text, CSV_TEXT - 1);
    snprintf(text, CSV_TEXT, "%.*s", cell->length, cell->text);
    return whirl_ok();
}

void csv_part(csv_column *own, char text[CSV_TEXT]) {
    char *unit = strpbrk(text, "[(");
    if (unit) {
        *unit++ = '\0';
        unit[strcspn(unit, "])")] = '\0';
    }
    for (char *end = text + strlen(text); end > text && isspace((unsigned char)end[-1]);) *--end = '\0';
    snprintf(own->name, sizeof own->name, "%s", text);
    snprintf(own->unit, sizeof own->unit, "%s", unit ? unit : "");
}

static whirl_status csv_headings(csv_reader *r, const char *from, const char *end) {
    csv_table *table = r->table;
    char text[CSV_TEXT];
    const char *at = from;
    csv_cell cell;
    whirl_status status = whirl_ok();
    const size_t length = (size_t)(end - from);
    table->heading = r->line;
    r->separator = memchr(from, ',', length) ? ',' : memchr(from, ';', length) ? ';' : '\t';
    table->columns = calloc(r->most, sizeof *table->columns);
    if (!table->columns) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a table");
    while (status.code == WHIRL_OK && csv_next(r, from, &at, end, &cell)) {
        if (table->column_count == r->most)
            return csv_fail(table, r->line, cell.place, "has more than %zu columns", r->most);
        csv_column *own = &table->columns[table->column_count++];
        own->place = cell.place;
        status = csv_copy(r, &cell, text);
        if (status.code == WHIRL_OK) csv_part(own, text);
    }
    return status;
}

static whirl_status csv_grow(csv_table *table) {
    const size_t capacity = table->capacity > 0 ? 2 * table->capacity : CSV_FIRST_ROWS;
    if (table->count < table->capacity) return whirl_ok();
    double *numbers = malloc(table->column_count * capacity * sizeof *numbers);
    int *lines = realloc(table->lines, capacity * sizeof *lines);
    if (lines) table->lines = lines;
    if (!numbers || !lines) {
        free(numbers);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu rows", capacity);
    }
    for (size_t c = 0; c < table->column_count && table->count > 0; c++)
        memcpy(numbers + c * capacity, table->numbers + c * table->capacity, table->count * sizeof *numbers);
    free(table->numbers);
    table->numbers = numbers;
    table->capacity = capacity;
    return whirl_ok();
}

static whirl_status csv_row(csv_reader *r, const char *from, const char *end) {
    // Make memory for the row.
    csv_table *table = r->table;
    char text[CSV_TEXT], *rest;
    const char *at = from;
    csv_cell cell;
    size_t cells = 0;
    whirl_status status = csv_grow(table);
    if (status.code != WHIRL_OK) return status;
    // Read each cell as a number.
    while (csv_next(r, from, &at, end, &cell)) {
        const int place = cell.place;
        if (cells == table->column_count)
            return csv_fail(table, r->line, place, "there are more cells than the %zu headings", table->column_count);
        status = csv_copy(r, &cell, text);
        if (status.code != WHIRL_OK) return status;
        double *own = table->numbers + cells * table->capacity + table->count;
        *own = strtod(text, &rest);
        if (cell.length == 0)
            return csv_fail(table, r->line, place, "the cell is empty, expected a number: cut the record at its gaps");
        if (rest == text || rest != text + cell.length || !isfinite(*own))
            return csv_fail(table, r->line, place, "'%.30s' is no number", text);
        cells++;
    }
    // Refuse a row with cells missing.
    if (cells < table->column_count)
        return csv_fail(table, r->line, (int)(end - from) + 1, "there are %zu cells, expected %zu as the headings",
                        cells, table->column_count);
    table->lines[table->count++] = r->line;
    return whirl_ok();
}

/// Keeps a title; a long one ends with "...".
static void csv_entitle(csv_table *table, const char *text, size_t length) {
    const size_t most = sizeof table->title - 1;
    const bool cut = length > most;
    if (cut) length = utf8_cut(text, most - strlen("..."));
    snprintf(table->title, sizeof table->title, "%.*s%s", (int)length, text, cut ? "..." : "");
}

/// Reads all lines. Skips empty lines and comments after #, the first of which is the title.
whirl_status csv_read(const char *path, const char *text, size_t length, size_t most_columns, csv_table *out) {
    *out = (csv_table){.path = path};
    csv_reader r = {.table = out, .most = most_columns};
    text = utf8_skip_mark(text, &length);
    const char *end = text + length;
    whirl_status status = whirl_ok();
    // Find the end of each line, without blanks around it.
    for (const char *from = text; from < end && status.code == WHIRL_OK;) {
        const char *stop = memchr(from, '\n', (size_t)(end - from)), *last = stop ? stop : end, *next = last + 1;
        r.line++;
        while (last > from && isspace((unsigned char)last[-1]) && last[-1] != '\t') last--;
        const char *begin = from;
        while (begin < last && isspace((unsigned char)*begin)) begin++;
        // Keep the first comment as a title; read headings, then rows.
        if (begin < last && *begin == '#') {
            begin += 1 + strspn(begin + 1, " ");
            if (!*out->title && begin < last) csv_entitle(out, begin, (size_t)(last - begin));
        } else if (begin < last) {
            status = out->column_count == 0 ? csv_headings(&r, from, last) : csv_row(&r, from, last);
        }
        from = next;
    }
    return status;
}

void csv_free(csv_table *table) {
    free(table->columns);
    free(table->numbers);
    free(table->lines);
    *table = (csv_table){.path = NULL};
}

whirl_status csv_unit(const csv_table *table, size_t column, const char *si, const char *example, double *size) {
    char text[CSV_TEXT + sizeof "1 "];
    const csv_column *own = &table->columns[column];
    *size = 1.0;
    if (!*own->unit && table->vectors)
        return csv_fail(table, table->heading, own->place,
                        "it has no unit, expected an attribute unit, or a heading with one in brackets: [%s]", example);
    if (!*own->unit)
        return csv_fail(table, table->heading, own->place, "this column has no unit, expected one in brackets: [%s]",
                        example);
    snprintf(text, sizeof text, "1 %s", own->unit);
    if (whirl_quantity_value(text, si, size).code == WHIRL_OK && *size > 0.0) return whirl_ok();
    return csv_fail(table, table->heading, own->place, "[%.40s] is no unit of a %s", own->unit,
                    strcmp(si, "m") == 0     ? "length"
                    : strcmp(si, "s") == 0   ? "time"
                    : strcmp(si, "rad") == 0 ? "angle"
                                             : "speed");
}

const double *csv_numbers(const csv_table *table, size_t column) {
    return table->numbers + column * table->capacity;
}
