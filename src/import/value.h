/// Content of a TOML or JSON file, as one tree for both.
#ifndef IMPORT_VALUE_H
#define IMPORT_VALUE_H

#include <stdbool.h>
#include <stddef.h>

#include "arena.h"
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
    const char *key;  ///< key of a member of a table; else NULL
    int line;         ///< from 1; 0 if unknown
    const char *text; ///< value of VALUE_TEXT
    double number;    ///< value of VALUE_NUMBER; 0 or 1 for VALUE_TRUTH
    size_t count;     ///< number of members or items
    value *first, *last, *next;
    bool seen; ///< a reader has asked for it
};

/// Adds an empty value to a table or list, or makes a root (`parent` NULL). Texts are copied, `key` NULL in lists.
/// NULL without memory.
value *value_add(memory_arena *arena, value *parent, value_kind kind, const char *key, size_t key_length, int line);

/// Gives a value its text. False without memory.
bool value_set_text(memory_arena *arena, value *to, const char *text, size_t length);

/// Returns the member of that name, and marks it as seen; NULL if it is missing or null.
value *value_member(value *table, const char *key);

/// Describes a value in a message: the number, the text (shortened), "a list", "a table", ...
enum { VALUE_SHOWN_SIZE = 48 };
const char *value_shown(const value *of, char shown[VALUE_SHOWN_SIZE]);

/// Lists within lists, and tables within tables, that a file may have.
enum { VALUE_MAX_DEPTH = 64 };

/// Reads a file of TOML 1.0, members in the order of the file. WHIRL_BAD_INPUT with "NAME:LINE: ..."; WHIRL_NO_MEMORY.
whirl_status value_read_toml(memory_arena *arena, const char *text, size_t length, const char *name, value **root);

/// Reads JSON in the same way; lines are known only for syntax errors.
whirl_status value_read_json(memory_arena *arena, const char *text, size_t length, const char *name, value **root);

#ifdef __cplusplus
}
#endif
#endif
