#include "field.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

enum { PLACE_SIZE = 200, MAX_WHOLE = 1000000 };

bool field_good(const import_reader *reader) {
    return reader->status.code == WHIRL_OK;
}

void field_refuse(field_section *section, const char *key, const value *at, const char *format, ...) {
    import_reader *const reader = section->reader;
    char place[PLACE_SIZE], said[WHIRL_MESSAGE_SIZE], whole[2 * WHIRL_MESSAGE_SIZE], line[16] = "";
    va_list arguments;
    if (!field_good(reader)) return;
    va_start(arguments, format);
    vsnprintf(said, sizeof said, format, arguments);
    va_end(arguments);
    const int number = at ? at->line : section->table->line;
    if (number > 0) snprintf(line, sizeof line, "%d:", number);
    snprintf(place, sizeof place, "[%.80s]%s%.60s", section->name, key ? " " : "", key ? key : "");
    snprintf(whole, sizeof whole, "%.100s:%s %s: %s", reader->file, line, place, said);
    whole[WHIRL_MESSAGE_SIZE - 1] = '\0'; // before it is made plain: the cut may go through a letter
    whirl_make_plain(whole);
    reader->status = whirl_fail(WHIRL_BAD_INPUT, "%s", whole);
}

void *field_memory(import_reader *reader, size_t size) {
    void *const memory = field_good(reader) ? arena_take(reader->arena, size) : NULL;
    if (!memory && field_good(reader))
        reader->status = whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.200s", reader->file);
    return memory;
}

/// Finds the value of a key; NULL without one, which is a problem for a required key.
static value *field_find_key(field_section *section, const char *key, bool required, const char *expected) {
    value *const found = field_good(section->reader) ? value_member(section->table, key) : NULL;
    if (!found && required) field_refuse(section, key, NULL, "is missing, expected %s", expected);
    return found;
}

static void refuse_kind(field_section *section, const char *key, const value *at, const char *expected) {
    char shown[VALUE_SHOWN_SIZE];
    field_refuse(section, key, at, "is %s, expected %s", value_shown(at, shown), expected);
}

static void describe(const field_kind *kind, char expected[64]) {
    snprintf(expected, 64, "a number in %.40s", kind->unit);
}

static double check_number(field_section *section, const field_kind *kind, const value *at) {
    const whirl_key key = {.name = kind->key, .unit = kind->unit, .range = kind->range};
    char expected[64];
    if (at->kind != VALUE_NUMBER) {
        describe(kind, expected);
        refuse_kind(section, kind->key, at, expected);
        return 0.0;
    }
    const whirl_status good = whirl_key_check_number(&key, at->number);
    if (good.code != WHIRL_OK) field_refuse(section, kind->key, at, "%s", good.message);
    return at->number;
}

double field_number(field_section *section, const field_kind *kind, double fallback) {
    char expected[64];
    describe(kind, expected);
    const value *const found = field_find_key(section, kind->key, isnan(fallback), expected);
    return found ? check_number(section, kind, found) : fallback;
}

long field_whole(field_section *section, const char *key, long fallback) {
    static const char expected[] = "a whole number from 0 to 1000000";
    const value *const found = field_find_key(section, key, fallback < -1, expected);
    if (!found) return fallback;
    if (found->kind == VALUE_NUMBER && found->number >= 0.0 && found->number <= MAX_WHOLE &&
        found->number == floor(found->number))
        return (long)found->number;
    refuse_kind(section, key, found, expected);
    return 0;
}

bool field_truth(field_section *section, const char *key, bool fallback) {
    const value *const found = field_find_key(section, key, false, "");
    if (found && found->kind != VALUE_TRUTH) refuse_kind(section, key, found, "true or false");
    return found ? found->number != 0.0 : fallback;
}

const char *field_text(field_section *section, const char *key, const char *fallback) {
    const value *const found = field_find_key(section, key, false, "");
    if (found && found->kind != VALUE_TEXT) refuse_kind(section, key, found, "a text");
    return found && found->kind == VALUE_TEXT ? found->text : fallback;
}

/// Returns the number of values in each row of a list, 1 for a list of numbers; refuses unequal rows.
static size_t width_of(field_section *section, const field_kind *kind, const value *list) {
    const bool nested = list->kind == VALUE_LIST && list->first && list->first->kind == VALUE_LIST;
    const size_t width = nested ? list->first->count : 1;
    for (const value *row = nested ? list->first : NULL; row; row = row->next) {
        if (row->kind != VALUE_LIST) {
            refuse_kind(section, kind->key, row, "a row of numbers like the one before");
        } else if (row->count == 0 || row->count != width) {
            field_refuse(section, kind->key, row, "has a row of %zu numbers after one of %zu, expected equal rows",
                         row->count, width);
        }
    }
    return width;
}

double *field_table(field_section *section, const field_kind *kind, size_t *rows, size_t *columns) {
    const value *const found = field_find_key(section, kind->key, false, "");
    *rows = 0;
    if (!found) return NULL;
    const bool list = found->kind == VALUE_LIST;
    if (list && found->count == 0) field_refuse(section, kind->key, found, "is an empty list, expected numbers");
    if (!list && found->kind != VALUE_NUMBER) refuse_kind(section, kind->key, found, "a list of numbers");
    *columns = width_of(section, kind, found);
    double *const numbers = field_memory(section->reader, (list ? found->count : 1) * *columns * sizeof *numbers);
    double *next = numbers;
    for (const value *row = list ? found->first : found; numbers && row && field_good(section->reader);
         row = list ? row->next : NULL, ++*rows)
        for (const value *item = row->kind == VALUE_LIST ? row->first : row; item;
             item = row->kind == VALUE_LIST ? item->next : NULL)
            *next++ = check_number(section, kind, item);
    return numbers;
}

double *field_numbers(field_section *section, const field_kind *kind, size_t *count) {
    size_t columns = 1;
    double *const numbers = field_table(section, kind, count, &columns);
    if (numbers && columns > 1)
        field_refuse(section, kind->key, value_member(section->table, kind->key),
                     "has rows, expected a list of numbers");
    return numbers;
}
