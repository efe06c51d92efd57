// Keys of a section that were not read.
#include <stdio.h>
#include <string.h>

#include "ross.h"

/// Longest name of a key and its section, in bytes; notes show no more of it.
enum { MAX_SHOWN = 96 };

/// Keys that only drawings use.
static const char *const drawing_keys[] = {"color", "scale_factor"};

/// Keys that count as read in every section, so that they are never noted as unknown.
static const char *const other_keys[] = {"tag", "material", "n"};

void ross_note_rest(field_section *section, const char *tag, bool computed) {
    note_list *const notes = &section->reader->notes;
    // Mark keys of drawings, and others without an effect, as read.
    bool drawn = false;
    for (size_t i = 0; i < sizeof drawing_keys / sizeof *drawing_keys; i++)
        drawn = value_member(section->table, drawing_keys[i]) || drawn;
    for (size_t i = 0; i < sizeof other_keys / sizeof *other_keys; i++)
        (void)value_member(section->table, other_keys[i]);
    if (drawn) note_of(notes, NOTE_DRAWING, tag);
    // Note the keys that nothing has read.
    for (const value *one = section->table->first; one; one = one->next) {
        if (one->seen || one->kind == VALUE_NOTHING) continue;
        if (computed) {
            note_of(notes, NOTE_EXTRA, tag);
            return;
        }
        const size_t whole = strlen(one->key) + strlen(section->name) + sizeof " of ";
        const size_t size = whole < MAX_SHOWN ? whole : MAX_SHOWN;
        char *const which = field_memory(section->reader, size);
        if (!which) return;
        snprintf(which, size, "%s of %s", one->key, section->name);
        note_of(notes, NOTE_UNKNOWN, which);
    }
}
