/// A text that grows, with the pieces of JSON.
#ifndef EXPLORER_TEXT_H
#define EXPLORER_TEXT_H

#include <stdbool.h>
#include <stddef.h>

typedef struct text {
    char *bytes;
    size_t length, capacity;
    bool no_memory;
} text;

/// Empties a text; its memory is kept.
void text_clear(text *t);

/// Appends a text, formatted as by printf.
void text_add(text *t, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// Appends a string with quotes and escapes.
void json_text(text *t, const char *value);

/// Appends a number that reads back as the same double; null for NaN and infinity.
void json_number(text *t, double value);

/// Appends `"name":`, with a comma before it unless a container has just begun.
void json_name(text *t, const char *name);

/// Appends a comma unless a container has just begun.
void json_next(text *t);

/// Returns the text, or a sentence if memory ran out.
const char *text_bytes(const text *t);

#endif
