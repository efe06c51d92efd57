#include "text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void text_clear(text *t) {
    t->length = 0;
    t->no_memory = false;
}

static bool text_make_room(text *t, size_t more) {
    if (t->length + more + 1 <= t->capacity) return true;
    const size_t capacity = 2 * (t->length + more + 1);
    char *bytes = realloc(t->bytes, capacity);
    t->no_memory = t->no_memory || !bytes;
    if (!bytes) return false;
    t->bytes = bytes;
    t->capacity = capacity;
    return true;
}

void text_add(text *t, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = vsnprintf(NULL, 0, format, arguments);
    if (length >= 0 && text_make_room(t, (size_t)length)) {
        vsnprintf(t->bytes + t->length, (size_t)length + 1, format, again);
        t->length += (size_t)length;
    }
    va_end(again);
    va_end(arguments);
}

void json_text(text *t, const char *value) {
    text_add(t, "\"");
    for (const char *c = value; *c; c++) {
        if (*c == '"' || *c == '\\')
            text_add(t, "\\%c", *c);
        else if ((unsigned char)*c < 0x20)
            text_add(t, "\\u%04x", (unsigned char)*c);
        else
            text_add(t, "%c", *c);
    }
    text_add(t, "\"");
}

void json_number(text *t, double value) {
    if (isfinite(value))
        text_add(t, "%.17g", value);
    else
        text_add(t, "null");
}

void json_next(text *t) {
    const char last = t->length > 0 ? t->bytes[t->length - 1] : '{';
    if (last != '{' && last != '[') text_add(t, ",");
}

void json_name(text *t, const char *name) {
    json_next(t);
    json_text(t, name);
    text_add(t, ":");
}

const char *text_bytes(const text *t) {
    return t->no_memory || !t->bytes ? "{\"message\":\"no memory\",\"problems\":[]}" : t->bytes;
}
