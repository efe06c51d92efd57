// Trees of version 2, and heaps of links and attributes (foreign.h).
#include "foreign.h"

#include <stdlib.h>
#include <string.h>

/// Returns the bytes that hold numbers up to `most`.
static unsigned bytes_for(uint64_t most) {
    unsigned bits = 0;
    while (most >>= 1) bits++;
    return bits / 8 + 1;
}

// ---------------------------------------------------------------- trees

enum { TREE_MAX_DEPTH = 8 };

/// A tree: sizes of its nodes, by their height.
typedef struct tree {
    foreign_file *file;
    uint64_t node;
    size_t record;
    unsigned depth, count_bytes, all_bytes[TREE_MAX_DEPTH + 1];
    foreign_record_taker take;
    void *context;
    bool ended;
} tree;

/// Walks through a node of `count` records.
static bool tree_node(tree *of, uint64_t address, uint64_t count, unsigned height) {
    enum { HEAD = 6 };
    const uint64_t pointer = height > 0 ? 8U + of->count_bytes + (height > 1 ? of->all_bytes[height - 1] : 0U) : 0;
    const uint64_t size = HEAD + count * of->record + (height > 0 ? (count + 1) * pointer : 0);
    if (size > of->node) return foreign_fail(of->file, "is damaged");
    unsigned char *block = foreign_block(of->file, address, size, height > 0 ? "BTIN" : "BTLF");
    if (!block) return false;
    plain_part records = {block + HEAD, (size_t)count * of->record, false};
    plain_part children = {block + HEAD + count * of->record, (size_t)(size - HEAD - count * of->record), false};
    bool more = true;
    // A child comes before each record, and one after the last.
    for (uint64_t i = 0; i <= count && more; i++) {
        if (height > 0) {
            const uint64_t at = plain_number(&children, 8), own = plain_number(&children, (int)of->count_bytes);
            if (height > 1) plain_skip(&children, of->all_bytes[height - 1]);
            more = tree_node(of, at, own, height - 1);
        }
        if (!more || i == count) break;
        more = of->take(of->context, (plain_part){records.at, of->record, false});
        of->ended = !more;
        plain_skip(&records, of->record);
    }
    free(block);
    return more && of->file->status.code == WHIRL_OK;
}

bool foreign_tree(foreign_file *file, uint64_t address, foreign_record_taker take, void *context) {
    enum { HEAD = 38, PREFIX = 10 };
    tree of = {.file = file, .take = take, .context = context};
    unsigned char *head = foreign_block(file, address, HEAD, "BTHD");
    if (!head) return false;
    plain_part part = {head + 6, HEAD - 6, false};
    of.node = plain_number(&part, 4);
    of.record = (size_t)plain_number(&part, 2);
    of.depth = (unsigned)plain_number(&part, 2);
    plain_skip(&part, 2);
    const uint64_t root = plain_number(&part, 8), count = plain_number(&part, 2);
    free(head);
    if (of.record == 0 || of.node < PREFIX + of.record || of.node > FOREIGN_MAX_BLOCK || of.depth > TREE_MAX_DEPTH)
        return foreign_fail(file, "is damaged");
    if (root == PLAIN_NOWHERE || count == 0) return true;
    // Numbers of records have as many bytes as the largest one needs: of a leaf, and of all below a node.
    uint64_t most = (of.node - PREFIX) / of.record, all = most;
    of.count_bytes = bytes_for(most);
    for (unsigned height = 1; height <= of.depth; height++) {
        const uint64_t pointer = 8U + of.count_bytes + of.all_bytes[height - 1];
        if (of.node < PREFIX + pointer) return foreign_fail(file, "is damaged");
        most = (of.node - PREFIX - pointer) / (of.record + pointer);
        if (all > UINT64_MAX / 2 / (most + 1)) return foreign_fail(file, "is damaged");
        all = (most + 1) * all + most;
        of.all_bytes[height] = bytes_for(all);
    }
    return tree_node(&of, root, count, of.depth) || of.ended;
}

// ---------------------------------------------------------------- heaps

bool foreign_heap_read(foreign_file *file, uint64_t address, foreign_heap *heap) {
    enum { HEAD = 142, MAX_WIDTH = 1024 };
    unsigned char *head = foreign_block(file, address, HEAD, "FRHP");
    if (!head) return false;
    plain_part part = {head + 7, HEAD - 7, false};
    const uint64_t filters = plain_number(&part, 2);
    plain_skip(&part, 1);
    const uint64_t most = plain_number(&part, 4);
    plain_skip(&part, (size_t)12 * 8);
    *heap = (foreign_heap){.width = (unsigned)plain_number(&part, 2), .filtered = filters > 0};
    heap->start = plain_number(&part, 8);
    heap->direct = plain_number(&part, 8);
    heap->bits = (unsigned)plain_number(&part, 2);
    plain_skip(&part, 2);
    heap->root = plain_number(&part, 8);
    heap->rows = (unsigned)plain_number(&part, 2);
    free(head);
    const bool powers = heap->start > 0 && (heap->start & (heap->start - 1)) == 0 && heap->direct >= heap->start &&
                        (heap->direct & (heap->direct - 1)) == 0;
    if (part.short_of || !powers || heap->direct > FOREIGN_MAX_BLOCK || heap->width == 0 || heap->width > MAX_WIDTH ||
        heap->bits == 0 || heap->bits > 64 || heap->rows > 64)
        return foreign_fail(file, "is damaged");
    if (heap->filtered) return foreign_fail(file, "has compressed names, which whirl does not read");
    const unsigned of_blocks = bytes_for(heap->direct - 1), of_objects = bytes_for(most);
    heap->length_bytes = of_blocks < of_objects ? of_blocks : of_objects;
    return true;
}

static uint64_t row_size(const foreign_heap *heap, unsigned row) {
    return heap->start << (row > 1 ? row - 1 : 0);
}

/// Finds the block of objects with an offset, and its place from the offset on. Indirect blocks have rows of blocks,
/// whose size doubles from the third row on.
static bool heap_block(foreign_file *file, const foreign_heap *heap, uint64_t *offset, uint64_t *address,
                       uint64_t *size) {
    unsigned rows = heap->rows;
    const unsigned offset_bytes = (heap->bits + 7) / 8;
    *address = heap->root;
    *size = heap->start;
    while (rows > 0) {
        // Find the row and the column of the offset.
        unsigned row = 0;
        uint64_t before = 0;
        while (row < rows && row < 48 && *offset - before >= row_size(heap, row) * heap->width)
            before += row_size(heap, row++) * heap->width;
        if (row == rows || row == 48) return foreign_fail(file, "is damaged");
        const uint64_t own = row_size(heap, row), column = (*offset - before) / own;
        const uint64_t entry = (uint64_t)row * heap->width + column;
        unsigned char *block = foreign_block(file, *address, 4 + 1 + 8 + offset_bytes + 8 * (entry + 1), "FHIB");
        if (!block) return false;
        plain_part part = {block + 4 + 1 + 8 + offset_bytes + 8 * entry, 8, false};
        *address = plain_number(&part, 8);
        free(block);
        *offset -= before + column * own;
        *size = own;
        // A block that is larger than those of objects is indirect; it has as many rows as its size takes.
        const unsigned of_it = rows;
        rows = 0;
        if (own > heap->direct)
            for (uint64_t all = 0; all < own; rows++) all += row_size(heap, rows) * heap->width;
        if (rows >= of_it && of_it > 0 && own > heap->direct) return foreign_fail(file, "is damaged");
    }
    return true;
}

unsigned char *foreign_heap_object(foreign_file *file, const foreign_heap *heap, plain_part id, size_t *size) {
    enum { MANAGED = 0, TINY = 2 };
    const unsigned first = (unsigned)plain_number(&id, 1), kind = first >> 4U & 3U;
    if (kind == TINY) {
        *size = (first & 15U) + 1;
        unsigned char *bytes = *size <= id.left ? malloc(*size) : NULL;
        if (bytes) memcpy(bytes, id.at, *size);
        if (!bytes) foreign_fail(file, "is damaged");
        return bytes;
    }
    if (kind != MANAGED) {
        foreign_fail(file, "has a name or an attribute that whirl does not read: it is too large");
        return NULL;
    }
    uint64_t offset = plain_number(&id, (int)(heap->bits + 7) / 8), address, block;
    const uint64_t length = plain_number(&id, (int)heap->length_bytes);
    if (id.short_of || length == 0) {
        foreign_fail(file, "is damaged");
        return NULL;
    }
    if (!heap_block(file, heap, &offset, &address, &block)) return NULL;
    if (offset > block || length > block - offset || address == PLAIN_NOWHERE) {
        foreign_fail(file, "is damaged");
        return NULL;
    }
    *size = (size_t)length;
    unsigned char *bytes = malloc(*size + 4); // a block of metadata has four bytes or more
    if (!bytes) foreign_no_memory(file);
    if (bytes && foreign_read(file, address + offset, bytes, *size)) return bytes;
    free(bytes);
    return NULL;
}
