// Converts libyaml's events to nodes one by one, so that limits apply during parsing: no input takes long.
#include "tree.h"
#include "problem.h"
#include "source.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

#include "utf8.h"
#include "whirl/status.h"

typedef struct tree_builder {
    memory_arena *arena;
    whirl_problems *problems;
    file_node *root;
    file_node *open; ///< the list or mapping that is being filled
    char *key;       ///< key of the next member, or NULL
    int key_line, key_column;
    size_t key_from;
    size_t depth, nodes;
    bool done, no_memory;
} tree_builder;

static int line_of(const yaml_event_t *event) {
    return (int)event->start_mark.line + 1;
}
static int tree_column(const yaml_event_t *event) {
    return (int)event->start_mark.column + 1;
}

/// Reports a problem that stops parsing.
static bool stop(tree_builder *b, const yaml_event_t *event, const char *message) {
    problem_in_file(b->problems, line_of(event), tree_column(event), "%s", message);
    return false;
}

static file_node *add_node(tree_builder *b, const yaml_event_t *event, node_kind kind) {
    // Make a node that knows its place in the text.
    file_node *made = arena_take(b->arena, sizeof *made);
    if (!made) {
        b->no_memory = true;
        return NULL;
    }
    *made = (file_node){.kind = kind,
                        .line = line_of(event),
                        .column = tree_column(event),
                        .from = event->start_mark.index,
                        .to = event->end_mark.index,
                        .parent = b->open};
    // The first node is the root.
    if (!b->open) {
        b->root = made;
        return made;
    }
    // Append it to the open list or mapping; in a mapping it gets the key read before.
    made->index = ++b->open->count;
    if (b->open->kind == NODE_MAPPING) {
        made->key = b->key;
        made->key_line = b->key_line;
        made->key_column = b->key_column;
        made->key_from = b->key_from;
        b->key = NULL;
    }
    *(b->open->last ? &b->open->last->next : &b->open->first) = made;
    b->open->last = made;
    return made;
}

/// Checks the text of quoted scalars: escapes can produce characters that source_check refuses, and surrogates.
static bool is_text(const char *text, size_t length) {
    for (size_t i = 0; i < length;) {
        const size_t bytes = utf8_length(text + i, length - i);
        if (bytes == 0 || !(utf8_is_plain(text + i, bytes) || text[i] == '\n' || text[i] == '\t')) return false;
        i += bytes;
    }
    return true;
}

static bool take_scalar(tree_builder *b, const yaml_event_t *event) {
    // Refuse anchors, tags and control characters.
    const char *value = (const char *)event->data.scalar.value;
    const size_t length = event->data.scalar.length;
    if (event->data.scalar.anchor)
        return stop(b, event, "has an anchor (&), expected a case without anchors and aliases");
    if (event->data.scalar.tag) return stop(b, event, "has a tag (!), expected a case without tags");
    if (!is_text(value, length)) return stop(b, event, "has a control character, expected text");
    // In a mapping every other scalar is a key.
    char *text = arena_text(b->arena, value, length);
    b->no_memory = b->no_memory || !text;
    if (!text) return false;
    if (b->open && b->open->kind == NODE_MAPPING && !b->key) {
        if (length == 0) return stop(b, event, "has an empty key, expected a name");
        b->key = text;
        b->key_line = line_of(event);
        b->key_column = tree_column(event);
        b->key_from = event->start_mark.index;
        return true;
    }
    // Other scalars are values.
    file_node *made = add_node(b, event, NODE_TEXT);
    if (!made) return false;
    made->text = text;
    made->quoted = event->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
    b->done = b->done || !b->open;
    return true;
}

static bool open_collection(tree_builder *b, const yaml_event_t *event, node_kind kind, const void *anchor,
                            const void *tag) {
    if (anchor) return stop(b, event, "has an anchor (&), expected a case without anchors and aliases");
    if (tag) return stop(b, event, "has a tag (!), expected a case without tags");
    if (b->open && b->open->kind == NODE_MAPPING && !b->key)
        return stop(b, event, "has a list or a mapping for a key, expected a name");
    if (++b->depth > TREE_MAX_DEPTH) return stop(b, event, "is nested deeper than 32 levels, expected a case");
    file_node *made = add_node(b, event, kind);
    if (!made) return false;
    made->flow = kind == NODE_LIST ? event->data.sequence_start.style == YAML_FLOW_SEQUENCE_STYLE
                                   : event->data.mapping_start.style == YAML_FLOW_MAPPING_STYLE;
    b->open = made;
    return true;
}

static bool close_collection(tree_builder *b) {
    b->depth--;
    b->open = b->open->parent;
    b->done = b->done || !b->open;
    return true;
}

/// Handles an event; returns false to end parsing.
static bool take_event(tree_builder *b, const yaml_event_t *event) {
    if (++b->nodes > TREE_MAX_NODES) return stop(b, event, "has more than 100000 values, expected a case");
    switch (event->type) {
    case YAML_DOCUMENT_START_EVENT:
        return b->done ? stop(b, event, "begins a second document, expected one") : true;
    case YAML_ALIAS_EVENT:
        return stop(b, event, "has an alias (*), expected a case without anchors and aliases");
    case YAML_SCALAR_EVENT:
        return take_scalar(b, event);
    case YAML_SEQUENCE_START_EVENT:
        return open_collection(b, event, NODE_LIST, event->data.sequence_start.anchor, event->data.sequence_start.tag);
    case YAML_MAPPING_START_EVENT:
        return open_collection(b, event, NODE_MAPPING, event->data.mapping_start.anchor, event->data.mapping_start.tag);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        return close_collection(b);
    case YAML_STREAM_END_EVENT:
        return false;
    default:
        return true;
    }
}

static void report_syntax(tree_builder *b, const yaml_parser_t *parser) {
    if (parser->error == YAML_MEMORY_ERROR) {
        b->no_memory = true;
        return;
    }
    const bool context = parser->context != NULL;
    if (context && strcmp(parser->context, "while parsing a block collection") == 0) {
        problem_in_file(b->problems, (int)parser->problem_mark.line + 1, (int)parser->problem_mark.column + 1,
                        "is in the list that begins in line %d, expected '- ' before every item",
                        (int)parser->context_mark.line + 1);
        return;
    }
    problem_in_file(b->problems, (int)parser->problem_mark.line + 1, (int)parser->problem_mark.column + 1,
                    "is not YAML: %s%s%s%s", parser->problem ? parser->problem : "it cannot be read",
                    context ? " (" : "", context ? parser->context : "", context ? ")" : "");
}

static void tree_parse(tree_builder *b, yaml_parser_t *parser) {
    for (bool more = true; more;) {
        yaml_event_t event;
        if (!yaml_parser_parse(parser, &event)) {
            report_syntax(b, parser);
            return;
        }
        more = take_event(b, &event);
        yaml_event_delete(&event);
    }
}

static int by_key(const void *a, const void *b) {
    const file_node *one = *(const file_node *const *)a, *other = *(const file_node *const *)b;
    const int order = strcmp(one->key, other->key);
    return order ? order : one->index < other->index ? -1 : 1;
}

static bool report_duplicates(const file_node *mapping, whirl_problems *problems) {
    const file_node **members = malloc((mapping->count + 1) * sizeof *members);
    if (!members) return false;
    size_t count = 0;
    for (const file_node *member = mapping->first; member; member = member->next) members[count++] = member;
    qsort(members, count, sizeof *members, by_key);
    for (size_t i = 1; i < count; i++)
        if (strcmp(members[i]->key, members[i - 1]->key) == 0)
            problem_at_key(problems, members[i], "is a second key of that name, the first is in line %d",
                           members[i - 1]->key_line);
    free(members);
    return true;
}

/// Reports duplicate keys at a node and below it. The recursion is as deep as the tree, at most TREE_MAX_DEPTH. Returns
/// false without memory.
static bool tree_check_keys(const file_node *at, whirl_problems *problems) {
    if (at->kind == NODE_MAPPING && at->count > 1 && !report_duplicates(at, problems)) return false;
    for (const file_node *child = at->first; child; child = child->next)
        if (!tree_check_keys(child, problems)) return false;
    return true;
}

whirl_status tree_read(const char *text, size_t length, memory_arena *arena, whirl_problems *problems,
                       file_node **root) {
    *root = NULL;
    source_check(text, length, problems);
    if (problems->count > 0) return whirl_fail(WHIRL_BAD_INPUT, "%.200s is not text", problems->file);
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory to parse %.200s", problems->file);
    yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, length);
    tree_builder b = {.arena = arena, .problems = problems};
    tree_parse(&b, &parser);
    yaml_parser_delete(&parser);
    if (b.no_memory || (b.done && !tree_check_keys(b.root, problems)))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory to parse %.200s", problems->file);
    if (!b.done && problems->count == 0) problem_in_file(problems, 1, 1, "is empty, expected a mapping of keys");
    *root = b.done ? b.root : NULL;
    return b.done ? whirl_ok() : whirl_fail(WHIRL_BAD_INPUT, "%.200s cannot be read", problems->file);
}
