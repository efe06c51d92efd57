// Universal files: functions over time, frequency or speed, datasets 58 and 58b (listed.h). "Record 6" and the like are
// the lines of a dataset in its specification.
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "listed.h"
#include "two_pi.h"
#include "utf8.h"

enum { LINE = 256, UNIVERSAL_TEXT = 96, UNIVERSAL_LINES = 11, UNIVERSAL_SOME = 1024 };

struct universal_record {
    char heading[UNIVERSAL_TEXT], unit[UNIVERSAL_TEXT]; ///< "disc x", "um"
    char axis[UNIVERSAL_TEXT], axis_unit[UNIVERSAL_TEXT];
    bool complex, doubled, even, binary, big; ///< doubled: of 8 bytes
    bool mixed;                               ///< binary, uneven: abscissas of 4 bytes, ordinates of 8
    uint64_t count, at;                       ///< points; address of the first number
    size_t line;                              ///< of the first number
    double start, step;
};

/// Lines of a file, and its bytes, read one after another.
typedef struct universal_reader {
    foreign_file *file;
    uint64_t at; ///< address behind the last line
    size_t line; ///< its number, from 1
    uint64_t begin;
    size_t size; ///< bytes in the buffer, which are those from address `begin` on
    unsigned char buffer[1 << 15];
} universal_reader;

static universal_reader *universal_reader_new(foreign_file *file, uint64_t at, size_t line) {
    universal_reader *r = malloc(sizeof *r);
    if (!r) {
        foreign_no_memory(file);
        return NULL;
    }
    r->file = file;
    r->at = r->begin = at;
    r->line = line;
    r->size = 0;
    return r;
}

/// Reads bytes into the buffer, unless it has the next one. Returns false at the end of the file, or after a failure.
static bool universal_fill(universal_reader *r) {
    if (r->at >= r->begin && r->at - r->begin < r->size) return true;
    const uint64_t size = r->file->source->size, left = r->at < size ? size - r->at : 0;
    r->begin = r->at;
    r->size = left < sizeof r->buffer ? (size_t)left : sizeof r->buffer;
    if (!foreign_read(r->file, r->begin, r->buffer, r->size)) r->size = 0;
    return r->size > 0;
}

/// Reads a line, without its end and the blanks before that; longer ones are cut. Returns false at the end of the file.
static bool universal_line(universal_reader *r, char text[LINE]) {
    size_t length = 0;
    bool any = false;
    for (bool ended = false; !ended && universal_fill(r);) {
        const unsigned char *from = r->buffer + (r->at - r->begin);
        const size_t left = r->size - (size_t)(r->at - r->begin);
        const unsigned char *end = memchr(from, '\n', left);
        const size_t some = end ? (size_t)(end - from) : left,
                     kept = some < LINE - 1 - length ? some : LINE - 1 - length;
        memcpy(text + length, from, kept);
        length += kept;
        r->at += some + (end ? 1 : 0);
        ended = end != NULL;
        any = true;
    }
    while (length > 0 && isspace((unsigned char)text[length - 1])) length--;
    text[length] = '\0';
    // A byte 0 would end the text, and other bytes are no digits.
    for (size_t i = 0; i < length; i++)
        if (text[i] == '\0') text[i] = '?';
    r->line++;
    return any;
}

/// Returns true for a line that begins or ends a dataset.
static bool universal_is_mark(const char *text) {
    return strcmp(text + strspn(text, " \t"), "-1") == 0;
}

/// Copies the columns [from, to) of a line, without the blanks around them.
static void universal_field(const char *line, size_t from, size_t to, char text[LINE]) {
    const size_t length = strlen(line), last = to < length ? to : length;
    while (from < last && isspace((unsigned char)line[from])) from++;
    size_t end = last;
    while (end > from && isspace((unsigned char)line[end - 1])) end--;
    const size_t size = end > from ? end - from : 0;
    if (size > 0) memcpy(text, line + from, size);
    text[size] = '\0';
}

/// Reads a number of a line; an empty field is 0. Exponents may be written as Fortran does, 1.0D+00.
static bool universal_number(const char *line, size_t from, size_t to, double *out) {
    char text[LINE], *end;
    universal_field(line, from, to, text);
    *out = 0.0;
    if (!*text) return true;
    if (text[strspn(text, "+-0123456789.eEdD")]) return false;
    for (char *at = text; *at; at++)
        if (*at == 'D' || *at == 'd') *at = 'E';
    *out = strtod(text, &end);
    return *end == '\0' && isfinite(*out);
}

/// Reads a whole number of a line.
static bool universal_whole(const char *line, size_t from, size_t to, long most, long *out) {
    double number;
    *out = 0;
    if (!universal_number(line, from, to, &number) || number != floor(number) || fabs(number) > (double)most)
        return false;
    *out = (long)number;
    return true;
}

bool universal_is_file(const byte_source *source) {
    enum { HEAD = 512 };
    char head[HEAD + 1], kind[LINE];
    const size_t size = source->size < HEAD ? (size_t)source->size : HEAD;
    long number;
    if (size == 0 || source->read(source->context, 0, head, size) != 0) return false;
    head[size] = '\0';
    // The first line that is not empty is -1, and the next one begins with the number of a dataset.
    const char *at = head + strspn(head, " \t\r\n");
    if (strncmp(at, "-1", 2) != 0) return false;
    at += 2 + strspn(at + 2, " \t\r");
    if (*at != '\n') return false;
    at++;
    universal_field(at, 0, 6 < strcspn(at, "\r\n") ? 6 : strcspn(at, "\r\n"), kind);
    return universal_whole(kind, 0, 6, 999999, &number) && number > 0;
}

// ---------------------------------------------------------------- headers

/// Returns true for a text that is this word in capital or small letters; `word` has small ones.
static bool universal_is_word(const char *text, const char *word) {
    while (*word && *text && tolower((unsigned char)*text) == *word) text++, word++;
    return *text == *word;
}

/// Copies a text that can be shown, without blanks around it; "" for "NONE" and for others.
static void universal_word(const char *line, size_t from, size_t to, char text[UNIVERSAL_TEXT]) {
    char field[LINE];
    universal_field(line, from, to, field);
    text[0] = '\0';
    if (universal_is_word(field, "none") || strlen(field) >= UNIVERSAL_TEXT) return;
    for (size_t i = 0, some; field[i]; i += some) {
        some = utf8_length(field + i, strlen(field + i));
        if (some == 0 || !utf8_is_plain(field + i, some) || field[i] == '/') return;
    }
    snprintf(text, UNIVERSAL_TEXT, "%s", field);
}

/// Reads the unit of an axis (records 8 and 9). Old files have capital letters alone.
static void universal_unit(const char *line, char unit[UNIVERSAL_TEXT]) {
    static const char *const known[][2] = {{"MM", "mm"},    {"UM", "um"},   {"M", "m"},    {"IN", "in"}, {"MIL", "mil"},
                                           {"MILS", "mil"}, {"S", "s"},     {"SEC", "s"},  {"sec", "s"}, {"HZ", "Hz"},
                                           {"RPM", "rpm"},  {"DEG", "deg"}, {"RAD", "rad"}};
    universal_word(line, 47, 67, unit);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(unit, known[i][0]) == 0) snprintf(unit, UNIVERSAL_TEXT, "%s", known[i][1]);
}

/// Names a record by the point and direction of its response (record 6), "disc x", or else by its first line.
static bool universal_name(const char *first, const char *form, char heading[UNIVERSAL_TEXT]) {
    static const char *const directions[] = {"-rz", "-ry", "-rx", "-z", "270", "180", "",
                                             "x",   "y",   "z",   "rx", "ry",  "rz"};
    char name[UNIVERSAL_TEXT], node[LINE];
    long direction;
    if (!universal_whole(form, 51, 55, 6, &direction)) return false;
    universal_word(form, 31, 41, name);
    universal_field(form, 41, 51, node);
    if (!*name && strcmp(node, "0") != 0) universal_word(form, 41, 51, name);
    if (*name)
        snprintf(heading, UNIVERSAL_TEXT, "%.80s%s%s", name, direction ? " " : "", directions[direction + 6]);
    else
        universal_word(first, 0, 80, heading);
    return true;
}

/// Names the abscissa (record 8) by its kind, or, where it has none, by that of the function.
static void universal_axis(universal_record *own, const char *form, long function) {
    enum { TIME = 17, FREQUENCY, RPM, ORDER, TIME_RESPONSE = 1 };
    static const char *const names[] = {"time", "frequency", "speed", "order"}, *const units[] = {"s", "Hz", "rpm", ""};
    long kind;
    if (!universal_whole(form, 0, 10, 1000, &kind)) kind = 0;
    if (kind <= 1) kind = function == TIME_RESPONSE ? TIME : function > TIME_RESPONSE ? FREQUENCY : 0;
    universal_word(form, 26, 46, own->axis);
    universal_unit(form, own->axis_unit);
    if (kind < TIME || kind > ORDER) {
        if (!*own->axis) snprintf(own->axis, sizeof own->axis, "abscissa");
        return;
    }
    snprintf(own->axis, sizeof own->axis, "%s", names[kind - TIME]);
    if (!*own->axis_unit) snprintf(own->axis_unit, sizeof own->axis_unit, "%s", units[kind - TIME]);
}

/// Returns the number of numbers of a point.
static size_t universal_each(const universal_record *own) {
    return (own->complex ? 2 : 1) + (own->even ? 0 : 1);
}

static bool universal_fail(const universal_reader *r, size_t record, const char *what) {
    return foreign_fail(r->file, "dataset 58 number %zu, line %zu: %s", record + 1, r->line, what);
}

/// Reads the lines before the numbers.
static bool universal_header(universal_reader *r, const char *kind, bool binary, size_t record, universal_record *own) {
    enum { FLOAT_IEEE = 2, MAX_POINTS = 1 << 30 };
    char lines[UNIVERSAL_LINES][LINE];
    long order = 0, floats = FLOAT_IEEE, type, count, even, function;
    *own = (universal_record){.binary = binary};
    if (own->binary && (!universal_whole(kind, 7, 13, 9, &order) || !universal_whole(kind, 13, 19, 9, &floats)))
        return universal_fail(r, record, "the order of its bytes cannot be read");
    if (floats != FLOAT_IEEE) return universal_fail(r, record, "has numbers of another kind than IEEE 754");
    own->big = order != 1;
    for (size_t i = 0; i < UNIVERSAL_LINES; i++)
        if (!universal_line(r, lines[i]) || universal_is_mark(lines[i])) return universal_fail(r, record, "is cut off");
    const size_t end = r->line;
    r->line = end - UNIVERSAL_LINES + 7; // for messages
    // Record 7: type of the numbers, their count, and even abscissas.
    const char *form = lines[6];
    if (!universal_whole(form, 0, 10, 9, &type) || !universal_whole(form, 10, 20, MAX_POINTS, &count) || count < 0 ||
        !universal_whole(form, 20, 30, 1, &even) || !universal_number(form, 30, 43, &own->start) ||
        !universal_number(form, 43, 56, &own->step))
        return universal_fail(r, record, "its type, count and spacing cannot be read (record 7)");
    if (type != 2 && type != 4 && type != 5 && type != 6)
        return universal_fail(r, record, "has an unknown type of numbers, expected 2, 4, 5 or 6");
    own->complex = type >= 5;
    own->doubled = type == 4 || type == 6;
    own->even = even != 0;
    own->count = (uint64_t)count;
    if (!universal_whole(lines[5], 0, 5, 1000, &function)) function = 0;
    if (!universal_name(lines[0], lines[5], own->heading))
        return universal_fail(r, record, "its direction cannot be read (record 6)");
    universal_axis(own, lines[7], function);
    universal_unit(lines[8], own->unit);
    own->at = r->at;
    own->line = r->line = end;
    // Each number of a text has at least 13 columns, blanks at its end aside.
    if (!binary && own->count > (r->file->source->size - r->at) / universal_each(own) / 12)
        return universal_fail(r, record, "is cut off");
    return true;
}

/// Skips the numbers of a record, and the line that ends its dataset.
static bool universal_skip(universal_reader *r, const char *kind, size_t record, universal_record *own) {
    char line[LINE];
    if (own->binary) {
        const uint64_t values = own->count * universal_each(own), mixed = own->count * (own->complex ? 20 : 12);
        const uint64_t left = r->file->source->size - r->at;
        double stated;
        if (!universal_number(kind, 31, 43, &stated) || !(stated >= 0.0 && stated <= 0x1p53))
            return universal_fail(r, record, "its size cannot be read");
        own->mixed = own->doubled && !own->even && (uint64_t)stated == mixed;
        // Some programs state a smaller size (pyuff for complex numbers: half of it).
        const uint64_t size = own->mixed ? mixed : values * (own->doubled ? 8 : 4);
        if ((uint64_t)stated > size)
            return foreign_fail(r->file, "dataset 58 number %zu has %.0f bytes, expected %llu of its type and count",
                                record + 1, stated, (unsigned long long)size);
        if (size > left) return universal_fail(r, record, "is cut off");
        r->at += size;
        if (!universal_line(r, line)) return universal_fail(r, record, "is cut off");
        if (!*line && !universal_line(r, line)) return universal_fail(r, record, "is cut off");
        return universal_is_mark(line) || universal_fail(r, record, "does not end after its numbers");
    }
    do
        if (!universal_line(r, line)) return universal_fail(r, record, "is cut off");
    while (!universal_is_mark(line));
    return true;
}

// ---------------------------------------------------------------- numbers

/// Numbers of a record, read one after another.
typedef struct universal_numbers {
    universal_reader *r;
    const universal_record *own;
    size_t number; ///< of the record, from 0
    size_t place;  ///< of the next number in its point
    size_t column;
    char line[LINE];
} universal_numbers;

static bool universal_begin(foreign_file *file, const listed_table *table, size_t record, universal_numbers *out) {
    const universal_record *own = &table->records[record];
    *out = (universal_numbers){.own = own, .number = record};
    out->r = universal_reader_new(file, own->at, own->line);
    return out->r != NULL;
}

/// Returns true if the next number is an abscissa.
static bool universal_at_abscissa(const universal_numbers *of) {
    return !of->own->even && of->place == 0;
}

/// Reads the next number, of bytes.
static bool universal_next_bytes(universal_numbers *of, double *out) {
    const universal_record *own = of->own;
    const bool eight = own->doubled && !(own->mixed && universal_at_abscissa(of));
    const foreign_type type = {.kind = FOREIGN_REAL, .size = eight ? 8 : 4, .big = own->big};
    unsigned char bytes[8];
    for (size_t i = 0; i < type.size; i++) {
        if (!universal_fill(of->r)) return universal_fail(of->r, of->number, "is cut off");
        bytes[i] = of->r->buffer[of->r->at++ - of->r->begin];
    }
    *out = foreign_number(&type, bytes);
    return true;
}

/// Reads the next number, of a line.
static bool universal_next_text(universal_numbers *of, double *out) {
    const universal_record *own = of->own;
    const size_t width = own->doubled && !universal_at_abscissa(of) ? 20 : 13;
    while (of->column >= strlen(of->line)) {
        if (!universal_line(of->r, of->line) || universal_is_mark(of->line))
            return universal_fail(of->r, of->number, "has fewer numbers than it says");
        of->column = 0;
    }
    if (!universal_number(of->line, of->column, of->column + width, out))
        return universal_fail(of->r, of->number, "a number cannot be read");
    of->column += width;
    return true;
}

/// Reads the next point.
static bool universal_next(universal_numbers *of, double *abscissa, double ordinate[2]) {
    const size_t each = universal_each(of->own);
    ordinate[1] = 0.0;
    for (of->place = 0; of->place < each; of->place++) {
        double *to = universal_at_abscissa(of) ? abscissa : &ordinate[of->place - (of->own->even ? 0 : 1)];
        if (!(of->own->binary ? universal_next_bytes(of, to) : universal_next_text(of, to))) return false;
    }
    return true;
}

bool universal_values(foreign_file *file, const listed_table *table, const listed_array *array, const size_t *first,
                      const size_t *count, double *out) {
    const universal_record *own = &table->records[array->record];
    universal_numbers of;
    if (*first > own->count || *count > own->count - *first) return foreign_fail(file, "has no such part");
    // Abscissas of even spacing are not in the file.
    if (array->part == LISTED_ABSCISSA && own->even) {
        for (size_t i = 0; i < *count; i++) out[i] = own->start + own->step * (double)(*first + i);
        return true;
    }
    if (!universal_begin(file, table, array->record, &of)) return false;
    bool good = true;
    for (size_t i = 0; i < *first + *count && good; i++) {
        double abscissa = 0.0, z[2] = {0.0, 0.0};
        good = universal_next(&of, &abscissa, z);
        if (!good || i < *first) continue;
        out[i - *first] = array->part == LISTED_ABSCISSA    ? abscissa
                          : array->part == LISTED_IMAGINARY ? z[1]
                          : array->part == LISTED_AMPLITUDE ? hypot(z[0], z[1])
                          : array->part == LISTED_LAG       ? -atan2(z[1], z[0]) * 360.0 / two_pi
                                                            : z[0];
    }
    free(of.r);
    return good;
}

// ---------------------------------------------------------------- lists

/// Compares the abscissas of two records. Returns false after a failure.
static bool universal_same_axis(foreign_file *file, const listed_table *table, size_t a, size_t b, bool *same) {
    const universal_record *x = &table->records[a], *y = &table->records[b];
    *same = x->count == y->count && strcmp(x->axis, y->axis) == 0 && strcmp(x->axis_unit, y->axis_unit) == 0;
    if (*same && x->even && y->even) *same = x->start == y->start && x->step == y->step;
    if (!*same || (x->even && y->even)) return true;
    universal_numbers of_x = {.r = NULL}, of_y = {.r = NULL};
    bool good = universal_begin(file, table, a, &of_x) && universal_begin(file, table, b, &of_y);
    for (uint64_t i = 0; i < x->count && good && *same; i++) {
        double at_x = x->start + x->step * (double)i, at_y = y->start + y->step * (double)i, z[2];
        good = universal_next(&of_x, &at_x, z) && universal_next(&of_y, &at_y, z);
        *same = fabs(at_x - at_y) <= 1e-9 * fabs(at_x);
    }
    free(of_x.r);
    free(of_y.r);
    return good;
}

/// Describes a part of a record.
static void universal_describe(const listed_table *table, size_t record, int part, listed_array *out) {
    const universal_record *own = &table->records[record];
    out->item =
        (arrays_item){.rank = 1, .sizes = {(size_t)own->count}, .numbers = true, .described = "numbers", .factor = 1.0};
    out->record = record;
    out->part = part;
    snprintf(out->item.unit, sizeof out->item.unit, "%s",
             part == LISTED_ABSCISSA ? own->axis_unit
             : part == LISTED_LAG    ? "deg"
                                     : own->unit);
}

static bool universal_add(foreign_file *file, listed_table *table, const char *name, size_t record, int part) {
    listed_array *own = listed_add(file, table, name);
    if (own) universal_describe(table, record, part, own);
    return own != NULL;
}

/// Returns true if an earlier record has the same heading.
static bool universal_is_second(const listed_table *table, size_t record) {
    for (size_t i = 0; i < record; i++)
        if (strcmp(table->records[i].heading, table->records[record].heading) == 0) return true;
    return false;
}

/// Names the arrays of all records: the abscissa, if they have the same one, and their ordinates.
static bool universal_list_names(foreign_file *file, listed_table *table) {
    char name[2 * UNIVERSAL_TEXT];
    bool common = true, good = true;
    for (size_t i = 1; i < table->record_count && common && good; i++)
        good = universal_same_axis(file, table, 0, i, &common);
    if (good && common) good = universal_add(file, table, table->records[0].axis, 0, LISTED_ABSCISSA);
    for (size_t i = 0; i < table->record_count && good; i++) {
        universal_record *own = &table->records[i];
        // A second record of a point is told apart by its number.
        if (!*own->heading || universal_is_second(table, i)) {
            snprintf(name, sizeof name, "%.80s/%d", *own->heading ? own->heading : "record", (int)i + 1);
            snprintf(own->heading, sizeof own->heading, "%.*s", UNIVERSAL_TEXT - 1, name);
        }
        if (!common) {
            snprintf(name, sizeof name, "%s/%s", own->heading, own->axis);
            good = universal_add(file, table, name, i, LISTED_ABSCISSA);
        }
        if (good) good = universal_add(file, table, own->heading, i, own->complex ? LISTED_AMPLITUDE : LISTED_ORDINATE);
        if (!good || !own->complex) continue;
        snprintf(name, sizeof name, "%s lag", own->heading);
        good = universal_add(file, table, name, i, LISTED_LAG);
    }
    return good;
}

/// Reads the headers of all datasets 58.
static bool universal_records(universal_reader *r, listed_table *table) {
    char line[LINE], kind[LINE];
    size_t capacity = 0;
    while (universal_line(r, line)) {
        if (!universal_is_mark(line) || !universal_line(r, line)) continue;
        universal_field(line, 0, 7, kind);
        if (!universal_is_word(kind, "58") && !universal_is_word(kind, "58b")) {
            while (universal_line(r, line) && !universal_is_mark(line)) {
            }
            continue;
        }
        if (table->record_count == LISTED_MAX_NAMES)
            return foreign_fail(r->file, "has more than %d records", LISTED_MAX_NAMES);
        if (table->record_count == capacity) {
            capacity = capacity ? 2 * capacity : 8;
            universal_record *records = realloc(table->records, capacity * sizeof *records);
            if (!records) return foreign_no_memory(r->file);
            table->records = records;
        }
        universal_record *own = &table->records[table->record_count];
        if (!universal_header(r, line, kind[2] != '\0', table->record_count, own) ||
            !universal_skip(r, line, table->record_count, own))
            return false;
        table->record_count++;
    }
    return r->file->status.code == WHIRL_OK;
}

bool universal_list(foreign_file *file, listed_table *table) {
    universal_reader *r = universal_reader_new(file, 0, 0);
    if (!r) return false;
    const bool good = universal_records(r, table);
    free(r);
    if (!good) return false;
    if (table->record_count == 0)
        return foreign_fail(file, "has no dataset 58, expected functions over time, frequency or speed");
    return universal_list_names(file, table);
}

/// Returns true if `name` is this text, followed by nothing or by a '/'; *rest is behind that.
static bool universal_begins(const char *name, const char *text, const char **rest) {
    const size_t length = strlen(text);
    if (strncmp(name, text, length) != 0 || (name[length] && name[length] != '/')) return false;
    *rest = name + length + (name[length] ? 1 : 0);
    return true;
}

bool universal_find(const listed_table *table, const char *name, listed_array *out) {
    static const struct {
        const char *word;
        int part;
    } parts[] = {{"real", LISTED_ORDINATE},
                 {"imaginary", LISTED_IMAGINARY},
                 {"amplitude", LISTED_AMPLITUDE},
                 {"lag", LISTED_LAG}};
    for (size_t i = 0; i < table->count; i++)
        if (strcmp(table->arrays[i].name, name) == 0) {
            *out = table->arrays[i];
            return true;
        }
    // A record has parts, and a number: "disc x/real", "record 2", "record 2/time".
    for (size_t i = 0; i < table->record_count; i++) {
        const universal_record *own = &table->records[i];
        char number[40];
        const char *rest;
        snprintf(number, sizeof number, "record %zu", i + 1);
        if (!universal_begins(name, number, &rest) && !universal_begins(name, own->heading, &rest)) continue;
        *out = (listed_array){.name = NULL};
        int part = *rest ? -1 : own->complex ? LISTED_AMPLITUDE : LISTED_ORDINATE;
        if (strcmp(rest, own->axis) == 0 || strcmp(rest, "abscissa") == 0) part = LISTED_ABSCISSA;
        for (size_t k = 0; k < sizeof parts / sizeof *parts && own->complex; k++)
            if (strcmp(rest, parts[k].word) == 0) part = parts[k].part;
        if (part < 0) continue;
        universal_describe(table, i, part, out);
        return true;
    }
    return false;
}
