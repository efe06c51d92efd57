/// What stands in a file of TOML or JSON, as one tree for both.
#ifndef IMPORT_VALUE_H
#define IMPORT_VALUE_H

#include <stdbool.h>
#include <stddef.h>

#include "memory.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum value_kind {
    VALUE_TABLE,
    VALUE_LIST,
    VALUE_TEXT,
    VALUE_NUMBER,
    VALUE_TRUTH,
    VALUE_NOTHING, ///< null
    VALUE_DATE
} value_kind;

typedef struct value value;
struct value {
    value_kind kind;
    const char *key;  ///< of a member of a table; NULL elsewhere
    int line;         ///< from 1; 0 where it is not known
    const char *text; ///< of VALUE_TEXT
    double number;    ///< of VALUE_NUMBER; 0 or 1 of VALUE_TRUTH
    size_t count;     ///< of members or items
    value *first, *last, *next;
    bool seen; ///< someone has asked for it
};

/// Adds an empty value to a table or list, or makes a root (`parent` NULL). Texts are copied, `key` NULL in lists.
/// NULL without memory.
value *value_add(memory_arena *arena, value *parent, value_kind kind, const char *key, size_t key_length, int line);

/// Gives a value its text. False without memory.
bool value_set_text(memory_arena *arena, value *to, const char *text, size_t length);

/// The member of that name, marked as seen; NULL where there is none or it is null.
value *value_member(value *table, const char *key);

/// What stands there in a few words for a message: the number, the text (shortened), "a list", "a table", ...
enum { VALUE_SHOWN_SIZE = 48 };
const char *value_shown(const value *of, char shown[VALUE_SHOWN_SIZE]);

/// Lists within lists, and tables within tables, that a file may have.
enum { VALUE_MAX_DEPTH = 64 };

/// Reads a file of TOML 1.0, members in the order of the file. WHIRL_BAD_INPUT with "NAME:LINE: ..."; WHIRL_NO_MEMORY.
whirl_status value_read_toml(memory_arena *arena, const char *text, size_t length, const char *name, value **root);

/// The same of JSON; lines are not known but where it cannot be read.
whirl_status value_read_json(memory_arena *arena, const char *text, size_t length, const char *name, value **root);

#ifdef __cplusplus
}
#endif
#endif
