// Keys of a section that were not read.
#include <stdio.h>
#include <string.h>

#include "ross.h"

/// Keys of drawings.
static const char *const drawing_keys[] = {"color", "scale_factor"};

/// Keys that are read where needed, and never noted.
static const char *const other_keys[] = {"tag", "material", "n"};

void ross_note_rest(field_section *section, const char *tag, bool computed) {
    note_list *const notes = &section->reader->notes;
    // Keys of drawings and others without an effect.
    bool drawn = false;
    for (size_t i = 0; i < sizeof drawing_keys / sizeof *drawing_keys; i++)
        drawn = value_member(section->table, drawing_keys[i]) || drawn;
    for (size_t i = 0; i < sizeof other_keys / sizeof *other_keys; i++)
        (void)value_member(section->table, other_keys[i]);
    if (drawn) note_of(notes, NOTE_DRAWING, tag);
    // Count the keys that nothing has read.
    size_t left = 0;
    const value *first = NULL;
    for (const value *one = section->table->first; one; one = one->next) {
        if (one->seen || one->kind == VALUE_NOTHING) continue;
        if (!first) first = one;
        left++;
    }
    if (left == 0) return;
    if (computed) {
        note_of(notes, NOTE_EXTRA, tag);
        return;
    }
    const size_t size = strlen(first->key) + strlen(section->name) + 16;
    char *const which = field_memory(section->reader, size);
    if (which) snprintf(which, size, "%s of %s", first->key, section->name);
    for (size_t i = 0; which && i < left; i++) note_of(notes, NOTE_UNKNOWN, which);
}
