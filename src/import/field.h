/// Reading the keys of a section, with a sentence for what is wrong: the file, the section, the key, what was found and
/// what is expected. The first problem stands; after it nothing more is read.
#ifndef IMPORT_FIELD_H
#define IMPORT_FIELD_H

#include "note.h"
#include "value.h"
#include "whirl/engine/descriptor.h"

typedef struct import_reader {
    const char *file;
    memory_arena *arena;
    whirl_status status;
    note_list notes;
} import_reader;

typedef struct field_section {
    import_reader *reader;
    const char *name; ///< as it stands between the brackets
    value *table;
} field_section;

/// Whether nothing is wrong yet.
bool field_good(const import_reader *reader);

/// Says what is wrong with a key (NULL: with the section) that has this value (NULL: none).
void field_refuse(field_section *section, const char *key, const value *at, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/// `size` bytes of zeros of the reader's memory; NULL, and a problem, without it.
void *field_memory(import_reader *reader, size_t size);

/// What a key should be: unit, range.
typedef struct field_kind {
    const char *key, *unit;
    whirl_range range;
} field_kind;

/// A number; `fallback` where the key is missing, NAN: then it must be there.
double field_number(field_section *section, const field_kind *kind, double fallback);

/// A whole number from 0 to a million; `fallback` where it is missing, below -1: then it must be there.
long field_whole(field_section *section, const char *key, long fallback);

/// true or false.
bool field_truth(field_section *section, const char *key, bool fallback);

/// A text, or `fallback`; borrowed.
const char *field_text(field_section *section, const char *key, const char *fallback);

/// A number, a list of them, or a list of equally long rows, one after the other: [*rows][*columns]; *rows is 0 and the
/// result NULL where the key is missing.
double *field_table(field_section *section, const field_kind *kind, size_t *rows, size_t *columns);

/// A number or a list of them; *count is 0 and the result NULL where the key is missing.
double *field_numbers(field_section *section, const field_kind *kind, size_t *count);

#endif
