/// Notes on what a conversion left out or chose: a sentence each, shown to the user and written into the case.
#ifndef IMPORT_NOTE_H
#define IMPORT_NOTE_H

#include "arena.h"

#include <stdbool.h>
#include <stddef.h>

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

#endif
