/// A YAML document as a tree with the place of everything in the file.
#ifndef CASE_TREE_H
#define CASE_TREE_H

#include "arena.h"
#include "whirl/engine/case.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>

enum { TREE_MAX_BYTES = 1 << 20, TREE_MAX_DEPTH = 32, TREE_MAX_NODES = 100000 };

typedef enum node_kind { NODE_TEXT, NODE_LIST, NODE_MAPPING } node_kind;

typedef struct file_node {
    node_kind kind;
    int line, column;         ///< from 1
    const char *text;         ///< value of NODE_TEXT, trimmed by YAML; else NULL
    bool quoted;              ///< the text was quoted
    const char *key;          ///< key of a mapping's member, else NULL
    int key_line, key_column; ///< place of that key
    size_t from, to; ///< characters of the file before the value and up to its end (of a collection: its first sign's)
    size_t key_from; ///< characters before the key
    bool flow;       ///< the list or mapping is written with brackets
    size_t index;    ///< index of a list's item, from 1
    struct file_node *parent; ///< NULL for the root
    struct file_node *first, *last, *next;
    size_t count; ///< number of items or members
} file_node;

/// Parses one document. Problems go to `problems`; the status is WHIRL_BAD_INPUT if they prevent a tree. Duplicate keys
/// are reported and kept. Memory is the arena's.
whirl_status tree_read(const char *text, size_t length, memory_arena *arena, whirl_problems *problems,
                       file_node **root);

// ---------------------------------------------------------------- node.c

/// Returns the member of a mapping with a key, or NULL.
const file_node *node_member(const file_node *mapping, const char *key);

/// Returns true for an empty value (`response:`), ~ or null.
bool node_is_null(const file_node *node);

/// "rotor.elements[2].film.load"; "" for the root. Cut at `size` - 1 bytes.
void node_path(const file_node *node, char *text, size_t size);

// ---------------------------------------------------------------- excerpt
// The lines of a file that problems are about.

/// Adds excerpts to all problems, in the order of problems_sort, from the text of the file.
void problems_quote(whirl_problems *problems, const char *text, size_t length);

// ---------------------------------------------------------------- problem
// Collecting what is wrong.

enum { SHOWN_SIZE = 64 };

#if defined(__GNUC__)
#define PROBLEM_FORMAT(n) __attribute__((format(printf, n, n + 1)))
#else
#define PROBLEM_FORMAT(n)
#endif

/// Reports a problem at a place without a key; line 0: the file as a whole.
void problem_in_file(whirl_problems *problems, int line, int column, const char *format, ...) PROBLEM_FORMAT(4);

/// Reports a problem of a value: at the value's place if it is a word, else at its key.
void problem_at(whirl_problems *problems, const file_node *where, const char *format, ...) PROBLEM_FORMAT(3);

/// Reports a problem at the key of a mapping's member.
void problem_at_key(whirl_problems *problems, const file_node *where, const char *format, ...) PROBLEM_FORMAT(3);

/// Reports that a mapping lacks `key`.
void problem_missing(whirl_problems *problems, const file_node *mapping, const char *key, const char *format, ...)
    PROBLEM_FORMAT(4);

/// Message for a value that could not be read for lack of memory, so that the file is not blamed.
extern const char problem_no_memory[];

/// Returns true if that message was reported, or there was no memory to report anything.
bool problems_blame_memory(const whirl_problems *problems);

/// Sorts problems by line, then column.
void problems_sort(whirl_problems *problems);

/// Describes a value in a message: the text (shortened), "a list", "a mapping", "nothing".
const char *node_shown(const file_node *node, char text[SHOWN_SIZE]);

/// Shortens a text for a message, without line breaks.
const char *text_shown(const char *text, char shown[SHOWN_SIZE]);

// ---------------------------------------------------------------- source
// The bytes of a file, before anything is made of them.

/// Reads a plain file, at most one byte more than TREE_MAX_BYTES after a byte order mark. *text is freed by the caller;
/// `problems`, which may be NULL, are then those of this file. WHIRL_BAD_INPUT with a sentence for a file that cannot
/// be read (missing, a folder, a pipe, a device, no permission).
whirl_status source_load(const char *path, whirl_problems *problems, char **text, size_t *length);

/// Reports invalid text: too many bytes, bytes that are not UTF-8, control characters, tabs as indentation.
void source_check(const char *text, size_t length, whirl_problems *problems);

#endif
