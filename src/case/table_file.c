// Tables of files: converts comma-separated values to the list that a case or a balancing file would have instead.
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arena.h"
#include "problem.h"
#include "settings.h"
#include "source.h"
#include "table_file.h"
#include "tree.h"
#include "utf8.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

enum { MAX_COLUMNS = 16 };

/// State of reading a table.
typedef struct readings_table {
    case_reader *reader; ///< reader of the table's file, with its problems
    const whirl_group *group;
    char separator;
    int line;
    size_t count; ///< columns
    struct {
        const char *key, *unit; ///< "": numbers have their own unit, or are in SI
    } columns[MAX_COLUMNS];
    file_node *list;
} readings_table;

/// Reads a cell up to the next separator into `text` [size], without surrounding blanks and quotes. Sets *first to the
/// cell's first character in the line, and moves *at past the cell. Returns false at the end of the line.
static bool take_cell(const readings_table *table, const char **at, const char *end, char *text, size_t size,
                      const char **first) {
    const char *from = *at, *to;
    if (from > end) return false;
    while (from < end && isblank((unsigned char)*from) && *from != table->separator) from++;
    const bool quoted = from < end && *from == '"';
    *first = from;
    for (to = from + quoted; to < end && *to != (quoted ? '"' : table->separator); to++) {
    }
    const char *next = to;
    while (next < end && *next != table->separator) next++;
    *at = next + 1;
    from += quoted;
    while (to > from && isspace((unsigned char)to[-1])) to--;
    snprintf(text, size, "%.*s", (int)(to - from), from);
    return true;
}

static file_node *new_node(const readings_table *table, node_kind kind, int column) {
    file_node *node = arena_take(table->reader->arena, sizeof *node);
    if (node) *node = (file_node){.kind = kind, .line = table->line, .column = column};
    table->reader->no_memory = table->reader->no_memory || !node;
    return node;
}

static void append(file_node *parent, file_node *node) {
    node->parent = parent;
    node->index = ++parent->count;
    if (parent->last)
        parent->last->next = node;
    else
        parent->first = node;
    parent->last = node;
}

/// Reads a heading such as "amplitude [um]", "amplitude (um)" or "amplitude": a key of the group, and the unit of its
/// column.
static void read_heading(readings_table *table, char *text, int column) {
    // Split the heading into name and unit.
    const char *names[MAX_COLUMNS] = {NULL}, *unit = "";
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    size_t length = strcspn(text, "[("), count = 0;
    if (text[length]) {
        char *const end = text + strlen(text) - 1;
        unit = text + length + 1;
        if (end > unit && (*end == ']' || *end == ')')) *end = '\0';
    }
    while (length > 0 && isspace((unsigned char)text[length - 1])) length--;
    // Find the key of that name.
    for (size_t k = 0; k < table->group->key_count && count < MAX_COLUMNS; k++)
        names[count++] = table->group->keys[k].name;
    size_t found = 0;
    while (found < count && (strlen(names[found]) != length || strncmp(names[found], text, length) != 0)) found++;
    if (found == count) {
        text[length] = '\0';
        describe_names(text, names, count, advice);
        problem_in_file(table->reader->problems, table->line, column, "is no column: %s, %s", text_shown(text, shown),
                        advice);
        return;
    }
    // Refuse a second column of that key, and add the column.
    for (size_t c = 0; c < table->count; c++)
        if (strcmp(table->columns[c].key, names[found]) == 0)
            problem_in_file(table->reader->problems, table->line, column, "is a second column %s", names[found]);
    table->columns[table->count].key = names[found];
    table->columns[table->count].unit = arena_text(table->reader->arena, unit, strlen(unit));
    table->reader->no_memory = table->reader->no_memory || !table->columns[table->count].unit;
    table->count++;
}

static void read_headings(readings_table *table, const char *from, const char *end) {
    char text[WHY_SIZE];
    const char *at = from, *first;
    const size_t length = (size_t)(end - from);
    table->separator = memchr(from, ',', length) ? ',' : memchr(from, ';', length) ? ';' : '\t';
    while (take_cell(table, &at, end, text, sizeof text, &first)) {
        if (table->count == MAX_COLUMNS) {
            problem_in_file(table->reader->problems, table->line, 1, "has more than %d columns", MAX_COLUMNS);
            return;
        }
        read_heading(table, text, (int)(first - from) + 1);
    }
}

/// Adds the unit of the column to a number without unit; returns other texts unchanged.
static const char *with_unit(const readings_table *table, const char *text, size_t column) {
    const char *unit = table->columns[column].unit;
    const bool plain = text[strspn(text, "+-.0123456789eE")] == '\0';
    const size_t size = strlen(text) + strlen(unit) + 2;
    char *made = arena_take(table->reader->arena, size);
    if (made) snprintf(made, size, "%s%s%s", text, *unit && plain ? " " : "", plain ? unit : "");
    table->reader->no_memory = table->reader->no_memory || !made;
    return made;
}

static void read_row(const readings_table *table, const char *from, const char *end) {
    char text[WHY_SIZE];
    const char *at = from, *first;
    size_t cells = 0;
    file_node *row = new_node(table, NODE_MAPPING, 1);
    while (row && take_cell(table, &at, end, text, sizeof text, &first)) {
        file_node *cell = cells < table->count && *text ? new_node(table, NODE_TEXT, (int)(first - from) + 1) : NULL;
        if (cell) {
            cell->key = table->columns[cells].key;
            cell->key_line = cell->line;
            cell->key_column = cell->column;
            cell->text = with_unit(table, text, cells);
            if (cell->text) append(row, cell);
        }
        cells++;
    }
    if (cells != table->count)
        problem_in_file(table->reader->problems, table->line, 1, "has %zu cells, expected %zu as the headings", cells,
                        table->count);
    else if (row)
        append(table->list, row);
}

/// Reads the lines of a table, headings first. Skips empty lines and those that begin with #.
static void read_lines(readings_table *table, const char *text, size_t length) {
    const char *end = text + length;
    for (const char *from = text; from < end && !table->reader->no_memory;) {
        const char *stop = memchr(from, '\n', (size_t)(end - from)), *last = stop ? stop : end;
        const char *next = last + 1;
        table->line++;
        if (last > from && last[-1] == '\r') last--;
        const char *sign = from;
        while (sign < last && isspace((unsigned char)*sign)) sign++;
        const bool empty = sign == last || *sign == '#';
        if (!empty && table->count > 0) read_row(table, from, last);
        if (!empty && table->count == 0) {
            read_headings(table, from, last);
            if (table->reader->problems->count > 0) return;
        }
        from = next;
    }
    if (table->list->count == 0 && table->reader->problems->count == 0)
        problem_in_file(table->reader->problems, 0, 0, "has no rows, expected a line of headings and lines of numbers");
}

const file_node *table_read(case_reader *reader, const char *path, const whirl_group *group) {
    char *text = NULL;
    size_t length = 0;
    const whirl_status status = source_load(path, reader->problems, &text, &length);
    reader->no_memory = reader->no_memory || status.code == WHIRL_NO_MEMORY;
    readings_table table = {.reader = reader, .group = group, .list = NULL};
    if (status.code == WHIRL_OK) source_check(text, length, reader->problems);
    if (status.code == WHIRL_OK && reader->problems->count == 0) {
        table.list = new_node(&table, NODE_LIST, 1);
        const char *after = utf8_skip_mark(text, &length);
        if (table.list) read_lines(&table, after, length);
    } else if (status.code == WHIRL_BAD_INPUT && reader->problems->count == 0) {
        problem_in_file(reader->problems, 0, 0, "%s", status.message);
    }
    free(text);
    return table.list;
}

void table_take_problems(case_reader *reader, const file_node *where, const whirl_problems *of) {
    for (size_t i = 0; i < of->count; i++) {
        const whirl_problem *one = &of->items[i];
        const char *key = strrchr(one->key, '.');
        char place[320];
        snprintf(place, sizeof place, one->line > 0 ? "%s:%d:%d: " : "%s: ", of->file, one->line, one->column);
        problem_at(reader->problems, where, "%s%s%s%s", place, key ? key + 1 : "", key ? ": " : "", one->message);
    }
}
