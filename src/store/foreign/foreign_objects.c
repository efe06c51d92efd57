// Headers of objects, their links and attributes (foreign.h).
#include "foreign.h"

#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------- headers

void foreign_object_free(foreign_object *object) {
    for (size_t i = 0; i < object->part_count; i++) free(object->parts[i]);
    free(object->parts);
    free(object->messages);
    *object = (foreign_object){0};
}

/// Keeps a block of messages with its object, which frees it, also after a failure.
static bool object_keep(foreign_file *file, foreign_object *object, unsigned char *block) {
    unsigned char **parts = block ? realloc(object->parts, (object->part_count + 1) * sizeof *parts) : NULL;
    if (!parts) {
        if (block) foreign_no_memory(file);
        free(block);
        return false;
    }
    object->parts = parts;
    object->parts[object->part_count++] = block;
    return true;
}

static bool object_add(foreign_file *file, foreign_object *object, const foreign_message *message) {
    enum { MAX_MESSAGES = 1 << 16 };
    if (object->count == MAX_MESSAGES) return foreign_fail(file, "is damaged");
    if (object->count == object->capacity) {
        const size_t capacity = object->capacity ? 2 * object->capacity : 32;
        foreign_message *messages = realloc(object->messages, capacity * sizeof *messages);
        if (!messages) return foreign_no_memory(file);
        object->messages = messages;
        object->capacity = capacity;
    }
    object->messages[object->count++] = *message;
    return true;
}

/// Takes the messages of a part of a header: of version 1, or of version 2 with or without an order.
static bool object_messages(foreign_file *file, foreign_object *object, plain_part part, unsigned version,
                            bool ordered) {
    const size_t head = version == 1 ? 8 : ordered ? 6 : 4;
    while (part.left >= head) {
        foreign_message one = {.type = (unsigned)plain_number(&part, version == 1 ? 2 : 1)};
        const size_t length = (size_t)plain_number(&part, 2);
        one.flags = (unsigned)plain_number(&part, 1);
        plain_skip(&part, version == 1 ? 3 : ordered ? 2 : 0);
        if (length > part.left) return foreign_fail(file, "is damaged");
        one.content = (plain_part){part.at, length, false};
        if (!object_add(file, object, &one)) return false;
        plain_skip(&part, length);
    }
    return true;
}

/// Reads the first part of a header of version 1 (IV.A.1.a).
static bool object_read_old(foreign_file *file, uint64_t address, foreign_object *out) {
    unsigned char head[16] = {0};
    if (!foreign_read(file, address, head, sizeof head)) return false;
    plain_part part = {head + 8, 8, false};
    const uint64_t size = plain_number(&part, 4);
    unsigned char *block = foreign_block(file, address + 16, size < 4 ? 4 : size, NULL);
    return object_keep(file, out, block) &&
           object_messages(file, out, (plain_part){block, (size_t)size, false}, 1, false);
}

/// Reads the first part of a header of version 2 (IV.A.1.b).
static bool object_read_new(foreign_file *file, uint64_t address, foreign_object *out, bool *ordered) {
    unsigned char head[6] = {0}, length[8] = {0};
    if (!foreign_read(file, address, head, sizeof head)) return false;
    const unsigned flags = head[5], bytes = 1U << (flags & 3U);
    const uint64_t before = 6 + (flags & 0x20U ? 16U : 0U) + (flags & 0x10U ? 4U : 0U);
    *ordered = (flags & 4U) != 0;
    if (head[4] != 2) return foreign_fail(file, "is damaged");
    if (!foreign_read(file, address + before, length, bytes)) return false;
    plain_part part = {length, sizeof length, false};
    const uint64_t size = plain_number(&part, (int)bytes), all = size > FOREIGN_MAX_BLOCK ? size : size + 4;
    unsigned char *block = foreign_block(file, address + before + bytes, all, NULL);
    return object_keep(file, out, block) &&
           object_messages(file, out, (plain_part){block, (size_t)size, false}, 2, *ordered);
}

bool foreign_object_read(foreign_file *file, uint64_t address, foreign_object *out) {
    unsigned char signature[4] = {0};
    bool ordered = false;
    *out = (foreign_object){0};
    if (!foreign_read(file, address, signature, sizeof signature)) return false;
    const unsigned version = memcmp(signature, "OHDR", 4) == 0 ? 2 : 1;
    if (version == 1 && signature[0] != 1) return foreign_fail(file, "is damaged");
    if (!(version == 1 ? object_read_old(file, address, out) : object_read_new(file, address, out, &ordered)))
        return false;
    // Messages may be continued elsewhere, and there again.
    for (size_t i = 0; i < out->count; i++) {
        if (out->messages[i].type != FOREIGN_CONTINUATION) continue;
        plain_part part = out->messages[i].content;
        const uint64_t at = plain_number(&part, 8), size = plain_number(&part, 8);
        if (part.short_of || size < 8) return foreign_fail(file, "is damaged");
        unsigned char *block = foreign_block(file, at, size, version == 2 ? "OCHK" : NULL);
        if (!object_keep(file, out, block)) return false;
        const plain_part more =
            version == 2 ? (plain_part){block + 4, (size_t)size - 8, false} : (plain_part){block, (size_t)size, false};
        if (!object_messages(file, out, more, version, ordered)) return false;
    }
    return true;
}

const foreign_message *foreign_object_find(const foreign_object *object, unsigned type) {
    for (size_t i = 0; i < object->count; i++)
        if (object->messages[i].type == type) return &object->messages[i];
    return NULL;
}

// ---------------------------------------------------------------- links

/// A search of the links of a group.
typedef struct link_search {
    foreign_file *file;
    foreign_heap heap;
    foreign_link_taker take;
    foreign_message_taker take_message;
    void *context;
    bool ended;
} link_search;

/// Reads a link (IV.A.2.g); those that lead elsewhere are left out.
static bool link_read(link_search *of, plain_part part) {
    enum { HARD = 0 };
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    const unsigned kind = flags & 8U ? (unsigned)plain_number(&part, 1) : HARD;
    if (flags & 4U) plain_skip(&part, 8);
    if (flags & 16U) plain_skip(&part, 1);
    const uint64_t length = plain_number(&part, 1 << (flags & 3U));
    if (part.short_of || version != 1 || length == 0 || length > part.left) return foreign_fail(of->file, "is damaged");
    const char *name = (const char *)part.at;
    plain_skip(&part, (size_t)length);
    if (kind != HARD) return true;
    const uint64_t address = plain_number(&part, 8);
    if (part.short_of) return foreign_fail(of->file, "is damaged");
    of->ended = !of->take(of->context, name, (size_t)length, address);
    return !of->ended;
}

/// Takes a record of the tree of names (III.A.2, type 5): a hash, and an id in the heap.
static bool link_record(void *context, plain_part record) {
    link_search *of = context;
    size_t size = 0;
    plain_skip(&record, 4);
    unsigned char *bytes = foreign_heap_object(of->file, &of->heap, record, &size);
    const bool more = bytes && link_read(of, (plain_part){bytes, size, false});
    free(bytes);
    return more;
}

/// Hands over the names of a node of a symbol table (III.C), which are in a heap.
static bool link_symbols(link_search *of, uint64_t address, const unsigned char *names, uint64_t names_size) {
    enum { HEAD = 8, ENTRY = 40, LINKED = 2 };
    unsigned char head[HEAD] = {0};
    if (!foreign_read(of->file, address, head, sizeof head)) return false;
    const uint64_t count = head[6] | (unsigned)head[7] << 8U;
    unsigned char *block = foreign_block(of->file, address, HEAD + count * ENTRY, "SNOD");
    for (uint64_t i = 0; block && i < count && of->file->status.code == WHIRL_OK && !of->ended; i++) {
        plain_part entry = {block + HEAD + i * ENTRY, ENTRY, false};
        const uint64_t name = plain_number(&entry, 8), object = plain_number(&entry, 8), kind = plain_number(&entry, 4);
        const unsigned char *end = name < names_size ? memchr(names + name, '\0', (size_t)(names_size - name)) : NULL;
        if (!end) {
            foreign_fail(of->file, "is damaged");
        } else if (kind != LINKED) {
            of->ended = !of->take(of->context, (const char *)names + name, (size_t)(end - (names + name)), object);
        }
    }
    free(block);
    return of->file->status.code == WHIRL_OK && !of->ended;
}

/// Walks through the tree of a group of old style (III.A.1, type 0).
static bool link_tree(link_search *of, uint64_t address, int depth, const unsigned char *names, uint64_t names_size) {
    enum { HEAD = 24, MAX_DEPTH = 16 };
    unsigned char head[HEAD] = {0};
    if (depth > MAX_DEPTH) return foreign_fail(of->file, "is damaged");
    if (!foreign_read(of->file, address, head, sizeof head)) return false;
    const unsigned level = head[5];
    const uint64_t count = head[6] | (unsigned)head[7] << 8U;
    unsigned char *block = foreign_block(of->file, address, HEAD + 8 + count * 16, "TREE");
    if (!block) return false;
    bool more = head[4] == 0 || foreign_fail(of->file, "is damaged");
    for (uint64_t i = 0; i < count && more; i++) {
        plain_part child = {block + HEAD + 8 + i * 16, 8, false};
        const uint64_t at = plain_number(&child, 8);
        more = level > 0 ? link_tree(of, at, depth + 1, names, names_size) : link_symbols(of, at, names, names_size);
    }
    free(block);
    return more;
}

/// Reads the names of a group of old style: a local heap (III.D) and a tree.
static void link_table(link_search *of, plain_part message) {
    enum { HEAP = 32 };
    const uint64_t tree = plain_number(&message, 8), heap = plain_number(&message, 8);
    unsigned char *head = message.short_of ? NULL : foreign_block(of->file, heap, HEAP, "HEAP");
    if (!head) {
        foreign_fail(of->file, "is damaged");
        return;
    }
    plain_part part = {head + 8, HEAP - 8, false};
    const uint64_t size = plain_number(&part, 8);
    plain_skip(&part, 8);
    const uint64_t at = plain_number(&part, 8);
    free(head);
    unsigned char *names = foreign_block(of->file, at, size, NULL);
    if (names) link_tree(of, tree, 0, names, size);
    free(names);
}

/// Reads the addresses of a heap and of a tree of names in it, of links (IV.A.2.c) or attributes (IV.A.2.v). Returns
/// false if there is no heap.
static bool info_read(foreign_file *file, plain_part part, int count_bytes, foreign_heap *heap, uint64_t *tree) {
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    if (flags & 1U) plain_skip(&part, (size_t)count_bytes);
    const uint64_t at = plain_number(&part, 8);
    *tree = plain_number(&part, 8);
    if (part.short_of || version != 0) return foreign_fail(file, "is damaged");
    return at != PLAIN_NOWHERE && *tree != PLAIN_NOWHERE && foreign_heap_read(file, at, heap);
}

bool foreign_links(foreign_file *file, const foreign_object *group, foreign_link_taker take, void *context) {
    link_search of = {.file = file, .take = take, .context = context};
    uint64_t tree;
    for (size_t i = 0; i < group->count && file->status.code == WHIRL_OK && !of.ended; i++) {
        const foreign_message *one = &group->messages[i];
        if (one->type == FOREIGN_SYMBOL_TABLE) link_table(&of, one->content);
        if (one->type == FOREIGN_LINK) link_read(&of, one->content);
        if (one->type == FOREIGN_LINK_INFO && info_read(file, one->content, 8, &of.heap, &tree))
            foreign_tree(file, tree, link_record, &of);
    }
    return file->status.code == WHIRL_OK;
}

// ---------------------------------------------------------------- attributes

/// Takes a record of the tree of attributes' names (III.A.2, type 8): an id in the heap comes first.
static bool attribute_record(void *context, plain_part record) {
    link_search *of = context;
    size_t size = 0;
    unsigned char *bytes = foreign_heap_object(of->file, &of->heap, record, &size);
    of->ended = !bytes || !of->take_message(of->context, (plain_part){bytes, size, false});
    free(bytes);
    return !of->ended;
}

bool foreign_attributes(foreign_file *file, const foreign_object *object, foreign_message_taker take, void *context) {
    enum { SHARED = 2 };
    link_search of = {.file = file, .take_message = take, .context = context};
    uint64_t tree;
    for (size_t i = 0; i < object->count && file->status.code == WHIRL_OK && !of.ended; i++) {
        const foreign_message *one = &object->messages[i];
        if (one->type == FOREIGN_ATTRIBUTE && !(one->flags & SHARED)) of.ended = !take(context, one->content);
        if (one->type == FOREIGN_ATTRIBUTE_INFO && info_read(file, one->content, 2, &of.heap, &tree))
            foreign_tree(file, tree, attribute_record, &of);
    }
    return file->status.code == WHIRL_OK;
}
