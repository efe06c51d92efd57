// Changes values in the text of a case; the rest, comments included, stays byte for byte.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "content.h"
#include "path.h"
#include "tree.h"
#include "utf8.h"
#include "whirl/status.h"

/// Returns the length in bytes of the first `characters` characters.
static size_t byte_offset(const char *text, size_t length, size_t characters) {
    size_t at = 0;
    for (size_t i = 0; i < characters && at < length; i++) {
        const size_t bytes = utf8_length(text + at, length - at);
        at += bytes > 0 ? bytes : 1;
    }
    return at;
}

static const file_node *find_node(const file_node *at, const char *path) {
    char here[PATH_SIZE];
    node_path(at, here, sizeof here);
    if (strcmp(here, path) == 0) return at;
    for (const file_node *child = at->first; child; child = child->next) {
        const file_node *found = find_node(child, path);
        if (found) return found;
    }
    return NULL;
}

// ---------------------------------------------------------------- one change

/// Returns `text` with `count` bytes from `at` on replaced by before + value + after. Freed by the caller; NULL without
/// memory, or beyond the end of the text.
static char *splice(const char *text, size_t length, size_t at, size_t count, const char *before, const char *value,
                    const char *after) {
    if (at > length || count > length - at) return NULL;
    const size_t size = length - count + strlen(before) + strlen(value) + strlen(after) + 1;
    char *result = size > 0 ? malloc(size) : NULL;
    if (result)
        snprintf(result, size, "%.*s%s%s%s%.*s", (int)at, text, before, value, after, (int)(length - at - count),
                 text + at + count);
    return result;
}

/// Returns the offset after the bracket of a list or mapping whose last item ends at `at`.
static size_t behind_bracket(const char *text, size_t length, size_t at, char bracket) {
    for (; at < length && text[at] != bracket; at++)
        if (text[at] == '#') at += strcspn(text + at, "\n");
    return at < length ? at + 1 : length;
}

/// Returns the offset after a value with all below it.
static size_t edit_end(const char *text, size_t length, const file_node *node) {
    const size_t end = node->last ? edit_end(text, length, node->last) : byte_offset(text, length, node->to);
    if (node->kind == NODE_TEXT || !node->flow) return end;
    return behind_bracket(text, length, end, node->kind == NODE_LIST ? ']' : '}');
}

/// Finds the bytes of a list that a new value replaces. Of a list with dashes these are all bytes after the colon of
/// its key, since a bracketed list may need another indent.
static void list_extent(const char *text, size_t length, const file_node *list, size_t *from, size_t *to) {
    const file_node *end = list->last ? list->last : list;
    *to = byte_offset(text, length, end->to);
    if (list->flow) {
        *to = behind_bracket(text, length, *to, ']');
    } else if (list->key) {
        *from = byte_offset(text, length, list->key_from);
        *from += strcspn(text + *from, ":") + 1;
    }
}

static char *replace(const char *text, size_t length, const file_node *node, const char *value) {
    size_t from = byte_offset(text, length, node->from), to = byte_offset(text, length, node->to);
    if (node->kind == NODE_LIST) list_extent(text, length, node, &from, &to);
    return splice(text, length, from, to - from, from > 0 && text[from - 1] == ':' ? " " : "", value, "");
}

/// Inserts a new member before the first one of a mapping.
static char *insert(const char *text, size_t length, const file_node *mapping, const char *member) {
    if (mapping->flow) {
        const size_t at = byte_offset(text, length, mapping->to);
        return splice(text, length, at, 0, "", member, mapping->first ? ", " : "");
    }
    char indent[PATH_SIZE];
    snprintf(indent, sizeof indent, "\n%*s", mapping->first->key_column - 1, "");
    return splice(text, length, byte_offset(text, length, mapping->first->key_from), 0, "", member, indent);
}

/// Adds a missing path as nested mappings: "integrate: {transient: 100}".
static char *edit_add(const char *text, size_t length, const file_node *root, const char *path, const char *value) {
    char parent[PATH_SIZE], member[PATH_SIZE + 64];
    const char *dot = strrchr(path, '.');
    const file_node *found = dot ? NULL : root;
    if (dot) {
        snprintf(parent, sizeof parent, "%.*s", (int)(dot - path), path);
        found = find_node(root, parent);
    }
    if (found && found->kind == NODE_MAPPING) {
        snprintf(member, sizeof member, "%s: %s", dot ? dot + 1 : path, value);
        return insert(text, length, found, member);
    }
    snprintf(member, sizeof member, "{%s: %s}", dot ? dot + 1 : path, value);
    if (found && node_is_null(found)) return replace(text, length, found, member);
    return found || !dot ? NULL : edit_add(text, length, root, parent, member);
}

/// Returns the text without a member of a mapping. In a flow mapping the member's comma is removed with it. In a block
/// mapping its lines are; if the dash of a list item precedes the member, only the text up to the next key is removed.
/// NULL without memory.
static char *take_away(const char *text, size_t length, const file_node *node) {
    size_t from = byte_offset(text, length, node->key_from), to = edit_end(text, length, node);
    const size_t indent = (size_t)node->key_column - 1;
    const bool own_lines = !node->parent->flow && strspn(text + from - indent, " ") >= indent;
    if (own_lines) {
        from -= indent;
        if (text[to - 1] != '\n') to += strcspn(text + to, "\n");
        if (to < length && text[to - 1] != '\n') to++;
    } else if (node->next) {
        to = byte_offset(text, length, node->next->key_from);
    } else {
        while (strchr(" \r\n", text[from - 1])) from--;
        from -= text[from - 1] == ',';
    }
    return splice(text, length, from, to - from, "", "", "");
}

// ---------------------------------------------------------------- checking

typedef struct edit_tree {
    memory_arena arena;
    whirl_problems problems;
    file_node *root;
} edit_tree;

static whirl_status read_tree(const char *text, size_t length, edit_tree *tree) {
    char sentence[sizeof(whirl_problem)];
    *tree = (edit_tree){0};
    const whirl_status status = tree_read(text, length, &tree->arena, &tree->problems, &tree->root);
    if (status.code != WHIRL_BAD_INPUT && tree->problems.count == 0) return status;
    whirl_problem_text(&tree->problems, 0, sentence, sizeof sentence);
    return whirl_fail(WHIRL_BAD_INPUT, "%s", sentence);
}

static void tree_free(edit_tree *tree) {
    arena_free(&tree->arena);
    whirl_problems_free(&tree->problems);
}

/// Returns true for a list, which begins with a bracket.
static bool is_list(const char *value) {
    return value[0] == '[';
}

/// Writes a list of values as "[a, b]".
static void list_text(const file_node *list, char text[PATH_SIZE]) {
    size_t used = (size_t)snprintf(text, PATH_SIZE, "[");
    for (const file_node *item = list->first; item && used < PATH_SIZE; item = item->next)
        used += (size_t)snprintf(text + used, PATH_SIZE - used, "%s%s", item == list->first ? "" : ", ",
                                 item->kind == NODE_TEXT ? item->text : "");
    if (used < PATH_SIZE) snprintf(text + used, PATH_SIZE - used, "]");
}

/// Returns true if the edited text reads back as the value.
static bool says(const char *text, const char *path, const char *value) {
    edit_tree tree;
    char list[PATH_SIZE] = "";
    const whirl_status status = read_tree(text, strlen(text), &tree);
    const file_node *node = status.code == WHIRL_OK ? find_node(tree.root, path) : NULL;
    if (node && node->kind == NODE_LIST) list_text(node, list);
    const bool good = node && node->kind != NODE_MAPPING && strcmp(node->text ? node->text : list, value) == 0;
    tree_free(&tree);
    return good;
}

/// Returns a value in single quotes, for values with special characters of YAML. NULL without memory.
static char *quoted(const char *value) {
    char *result = malloc(2 * strlen(value) + 3), *to = result;
    if (!result) return NULL;
    *to++ = '\'';
    for (const char *c = value; *c; c++) {
        if (*c == '\'') *to++ = '\'';
        *to++ = *c;
    }
    *to++ = '\'';
    *to = '\0';
    return result;
}

/// Returns the edited text if it reads back as intended, or NULL.
static char *try_edit(const char *text, size_t length, const file_node *root, const char *path, const char *value,
                      const char *written) {
    const file_node *node = find_node(root, path);
    char *result = node ? replace(text, length, node, written) : edit_add(text, length, root, path, written);
    if (result && says(result, path, value)) return result;
    free(result);
    return NULL;
}

/// Returns the text with `value` at the path, quoted if necessary, or NULL.
static char *write_value(const char *text, size_t length, const file_node *root, const char *path, const char *value) {
    char *edited = try_edit(text, length, root, path, value, value);
    char *quotes = edited ? NULL : quoted(value);
    if (quotes) edited = try_edit(text, length, root, path, value, quotes);
    free(quotes);
    return edited;
}

/// Returns the text without `node`, or a copy of the text if `node` is NULL. Returns NULL without memory, and if the
/// path would still exist or the rest could not be read.
static char *without(const char *text, size_t length, const file_node *node, const char *path) {
    if (!node) return splice(text, length, 0, 0, "", "", "");
    char *edited = node->key ? take_away(text, length, node) : NULL;
    edit_tree left;
    const bool good = edited && read_tree(edited, strlen(edited), &left).code == WHIRL_OK;
    const bool gone = good && !find_node(left.root, path);
    if (edited) tree_free(&left);
    if (gone) return edited;
    free(edited);
    return NULL;
}

/// Puts the bytes of a byte order mark before an edited text, which it frees; NULL without memory.
static char *with_mark(const char *whole, size_t mark, char *edited) {
    char *marked = malloc(mark + strlen(edited) + 1);
    if (marked) {
        memcpy(marked, whole, mark);
        strcpy(marked + mark, edited);
    }
    free(edited);
    return marked;
}

whirl_status whirl_case_remove(const char *text, size_t length, const char *path, char **edited) {
    edit_tree tree;
    const char *const whole = text;
    *edited = NULL;
    text = utf8_skip_mark(text, &length);
    const size_t mark = (size_t)(text - whole); // bytes of a byte order mark, which stays
    whirl_status status = read_tree(text, length, &tree);
    if (status.code == WHIRL_OK) {
        *edited = without(text, length, find_node(tree.root, path), path);
        if (*edited && mark > 0) *edited = with_mark(whole, mark, *edited);
        if (!*edited) status = whirl_fail(WHIRL_BAD_INPUT, "%.80s cannot be taken out of the text of the case", path);
    }
    tree_free(&tree);
    return status;
}

whirl_status whirl_case_edit(const char *text, size_t length, const char *path, const char *value, char **edited) {
    edit_tree tree;
    *edited = NULL;
    if (strlen(path) >= PATH_SIZE || (value && (strlen(value) >= PATH_SIZE - 64 || strpbrk(value, "\r\n"))))
        return whirl_fail(WHIRL_BAD_INPUT, "%.80s cannot be written, expected a short value in one line", path);
    const char *const whole = text;
    text = utf8_skip_mark(text, &length);
    const size_t mark = (size_t)(text - whole); // bytes of a byte order mark, which stays
    whirl_status status = read_tree(text, length, &tree);
    const file_node *node = status.code == WHIRL_OK ? find_node(tree.root, path) : NULL;
    const bool values_only = node && node->kind == NODE_LIST && (!node->last || node->last->kind == NODE_TEXT);
    if (node && node->kind != NODE_TEXT && !(values_only && (!value || is_list(value))))
        status = whirl_fail(WHIRL_BAD_INPUT, "%s is %s, expected a value", path,
                            node->kind == NODE_LIST ? "a list" : "a mapping");
    if (status.code == WHIRL_OK) {
        *edited = value ? write_value(text, length, tree.root, path, value) : without(text, length, node, path);
        if (*edited && mark > 0) *edited = with_mark(whole, mark, *edited);
        if (!*edited)
            status =
                value ? whirl_fail(WHIRL_BAD_INPUT, "%s cannot be set to %.100s in the text of the case", path, value)
                      : whirl_fail(WHIRL_BAD_INPUT, "%s cannot be taken out of the text of the case", path);
    }
    tree_free(&tree);
    return status;
}
