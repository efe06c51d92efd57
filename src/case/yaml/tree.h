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
    /// Number of characters before the value; number up to the end of its last character (of a list or mapping: of its
    /// first one).
    size_t from, to;
    size_t key_from;          ///< characters before the key
    bool flow;                ///< the list or mapping is written with brackets
    size_t index;             ///< index of a list's item, from 1
    struct file_node *parent; ///< NULL for the root
    struct file_node *first, *last, *next;
    size_t count; ///< number of items or members
} file_node;

/// Parses one document. Problems go to `problems`; the status is WHIRL_BAD_INPUT if they prevent a tree. Duplicate keys
/// are reported and kept. Memory is the arena's.
whirl_status tree_read(const char *text, size_t length, memory_arena *arena, whirl_problems *problems,
                       file_node **root);

/// Returns the member of a mapping with a key, or NULL.
const file_node *node_member(const file_node *mapping, const char *key);

/// Returns true for an empty value (`response:`), ~ or null.
bool node_is_null(const file_node *node);

/// Writes the path of a node: "rotor.elements[2].film.load"; "" for the root. Cut at `size` - 1 bytes.
void node_path(const file_node *node, char *text, size_t size);

#endif
