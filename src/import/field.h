/// Reading the keys of a section. A problem is one sentence: file, section, key, what was found, what is expected.
/// Reading ends with the first problem.
#ifndef IMPORT_FIELD_H
#define IMPORT_FIELD_H

#include "arena.h"
#include "note.h"
#include "value.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct import_reader {
    const char *file;
    memory_arena *arena;
    whirl_status status;
    note_list notes;
} import_reader;

typedef struct field_section {
    import_reader *reader;
    const char *name; ///< name between the brackets
    value *table;
} field_section;

/// Returns true if no problem was found.
bool field_good(const import_reader *reader);

/// Reports a problem with a key (NULL: with the section) that has this value (NULL: none).
void field_refuse(field_section *section, const char *key, const value *at, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/// Returns `size` bytes of zeros from the reader's arena; NULL, with a problem reported, without memory.
void *field_memory(import_reader *reader, size_t size);

/// Expected unit and range of a key.
typedef struct field_kind {
    const char *key, *unit;
    whirl_range range;
} field_kind;

/// Reads a number; `fallback` for a missing key, NAN: the key is required.
double field_number(field_section *section, const field_kind *kind, double fallback);

/// Reads a whole number from 0 to a million; `fallback` for a missing key, below -1: the key is required.
long field_whole(field_section *section, const char *key, long fallback);

/// Reads true or false; `fallback` for a missing key.
bool field_truth(field_section *section, const char *key, bool fallback);

/// Reads a text, borrowed; `fallback` for a missing key.
const char *field_text(field_section *section, const char *key, const char *fallback);

/// Reads a number, a list, or a list of rows of equal length, as [*rows][*columns]; *rows is 0 and the result NULL if
/// the key is missing.
double *field_table(field_section *section, const field_kind *kind, size_t *rows, size_t *columns);

/// Reads a number or a list; *count is 0 and the result NULL if the key is missing.
double *field_numbers(field_section *section, const field_kind *kind, size_t *count);

#endif
