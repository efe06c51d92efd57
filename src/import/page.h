/// Writing a case: quantities, comments, and mappings in braces that are broken into lines.
#ifndef IMPORT_PAGE_H
#define IMPORT_PAGE_H

#include "arena.h"
#include "value.h"
#include "whirl/engine/descriptor.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { PAGE_WIDTH = 120, QUANTITY_SIZE = 64 };

/// A line that is being written, broken between its items.
typedef struct page_line {
    FILE *out;
    int column, indent; ///< current column; indent of the next line
    int items;          ///< since page_open
} page_line;

/// Writes a number and its unit. The number has at most 15 significant digits, so that 0.1 is not written
/// 0.10000000000000001, and a decimal point in every locale.
void page_quantity(double number, const char *unit, char text[QUANTITY_SIZE]);

/// Starts a line with `head`; later lines are indented by `indent`.
page_line page_open(FILE *out, int indent, const char *head);

/// Adds an item, after a comma unless it is the first. The format is that of printf.
void page_item(page_line *line, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Adds "key: number unit".
void page_number(page_line *line, const char *key, double number, const char *unit);

/// Ends the line with `tail`, and with a comment (cut at the end of the line) unless NULL.
void page_close(page_line *line, const char *tail, const char *comment);

/// Writes a text as a comment, broken into lines, each after `mark` ("# "); later lines are indented by the width of
/// `hang`.
void page_comment(FILE *out, const char *mark, const char *hang, const char *text);

// ---------------------------------------------------------------- note
// Notes on what a conversion left out or chose: a sentence each, shown to the user and written into the case.

/// Omissions that several sections share, reported in one sentence.
typedef enum note_kind {
    NOTE_DRAWING,
    NOTE_AXIAL,
    NOTE_AXIAL_MASS,
    NOTE_LEAKAGE,
    NOTE_NOTHING_LATERAL,
    NOTE_SKEW_MASS,
    NOTE_THINNED,
    NOTE_EXTRA,
    NOTE_UNKNOWN,
    NOTE_AXIAL_DAMPING,
    NOTE_COUPLING_AXIAL,
    NOTE_COUPLING_LENGTH,
    NOTE_COUPLING_LOOSE,
    NOTE_HUTCHINSON,
    NOTE_ROTARY,
    NOTE_CONE,
    NOTE_MAGNETIC,
    NOTE_MAGNETIC_TABLE,
    NOTE_MAGNETIC_FILTER,
    NOTE_KINDS
} note_kind;

typedef struct note note;
struct note {
    const char *text;
    note *next;
};

typedef struct note_tags {
    size_t count;
    const char *first[3]; ///< the first of them, borrowed
} note_tags;

typedef struct note_list {
    memory_arena *arena;
    size_t count;
    note *first, *last;
    note_tags tags[NOTE_KINDS];
    bool no_memory;
} note_list;

/// Adds a sentence.
void note_add(note_list *to, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Remembers that the section with this tag (borrowed) has lost something of that kind.
void note_of(note_list *to, note_kind kind, const char *tag);

/// Adds a sentence for every kind with sections that lost something.
void note_finish(note_list *to);

// ---------------------------------------------------------------- field
// Reading the keys of a section. A problem is one sentence: file, section, key, what was found, what is expected.
// Reading ends with the first problem.

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
