// Places of chunks, by the indexes that HDF5 has for them (foreign.h).
#include "foreign.h"

#include <stdlib.h>
#include <string.h>

/// Returns the number of chunks that a dimension may have.
static uint64_t chunk_count(const foreign_array *array, int dimension) {
    return (array->most[dimension] - 1) / array->chunk[dimension] + 1; // sizes are above 0 where chunks are read
}

/// Returns the number of a chunk, the last dimension fastest.
static uint64_t chunk_number(const foreign_array *array, const uint64_t *place) {
    uint64_t number = 0;
    for (int i = 0; i < array->rank; i++) number = number * chunk_count(array, i) + place[i];
    return number;
}

// ---------------------------------------------------------------- trees

/// Finds a chunk in a tree of version 1 (III.A.1, type 1). Keys are the places of the first numbers of chunks.
static bool chunk_in_tree(foreign_file *file, const foreign_array *array, const uint64_t *place, foreign_chunk *out) {
    enum { HEAD = 24, MAX_DEPTH = 16 };
    const size_t key = 8 + 8 * ((size_t)array->rank + 1), entry = key + 8;
    uint64_t address = array->address;
    for (int depth = 0; depth < MAX_DEPTH && address != PLAIN_NOWHERE; depth++) {
        unsigned char head[HEAD] = {0};
        if (!foreign_read(file, address, head, sizeof head)) return false;
        const uint64_t count = head[6] | (unsigned)head[7] << 8U;
        unsigned char *block = foreign_block(file, address, HEAD + count * entry + key, "TREE");
        if (!block) return false;
        // Find the last key that is not behind the place.
        int order = 1;
        uint64_t at = PLAIN_NOWHERE, i = 0;
        foreign_chunk own = {0};
        for (; i < count; i++) {
            plain_part part = {block + HEAD + i * entry, entry, false};
            own.size = plain_number(&part, 4);
            own.mask = (unsigned)plain_number(&part, 4);
            order = 0;
            for (int k = 0; k < array->rank; k++) {
                const uint64_t start = plain_number(&part, 8), of = place[k] * array->chunk[k];
                if (order == 0 && start != of) order = start < of ? -1 : 1;
            }
            plain_skip(&part, 8);
            const uint64_t child = plain_number(&part, 8);
            if (order > 0) break;
            at = child;
            *out = own;
            if (order == 0) break;
        }
        const bool leaf = head[5] == 0, chunks = head[4] == 1;
        free(block);
        if (!chunks) return foreign_fail(file, "is damaged");
        if (leaf) {
            out->address = at;
            return order == 0 && i < count && at != PLAIN_NOWHERE;
        }
        address = at;
    }
    return false;
}

/// A search of a tree of version 2.
typedef struct chunk_search {
    const foreign_array *array;
    const uint64_t *place;
    foreign_chunk *out;
    bool found;
} chunk_search;

/// Takes a record of chunks (III.A.2, types 10 and 11): address, size and mask with filters, place.
static bool chunk_record(void *context, plain_part record) {
    chunk_search *of = context;
    const size_t places = 8 * (size_t)of->array->rank;
    foreign_chunk own = {.address = plain_number(&record, 8), .size = of->array->chunk_bytes};
    if (record.left > places) {
        own.size = plain_number(&record, (int)(record.left - places - 4 < 8 ? record.left - places - 4 : 8));
        own.mask = (unsigned)plain_number(&record, 4);
    }
    for (int i = 0; i < of->array->rank; i++)
        if (plain_number(&record, 8) != of->place[i]) return true;
    if (record.short_of) return true;
    *of->out = own;
    of->found = own.address != PLAIN_NOWHERE;
    return false;
}

// ---------------------------------------------------------------- arrays of addresses

/// Reads an entry of an array of addresses: an address and, with filters, size and mask.
static bool chunk_entry(foreign_file *file, const foreign_array *array, uint64_t at, unsigned entry, bool filtered,
                        foreign_chunk *out) {
    unsigned char bytes[32] = {0};
    if (!foreign_read(file, at, bytes, entry)) return false;
    plain_part part = {bytes, entry, false};
    *out = (foreign_chunk){.address = plain_number(&part, 8), .size = array->chunk_bytes};
    if (filtered) {
        out->size = plain_number(&part, (int)entry - 12);
        out->mask = (unsigned)plain_number(&part, 4);
    }
    return out->address != PLAIN_NOWHERE;
}

/// Returns true for the bytes of an entry that there are.
static bool entry_is_known(unsigned client, unsigned entry) {
    return client == 0 ? entry == 8 : client == 1 && entry >= 13 && entry <= 20;
}

/// Finds a chunk in a fixed array (III.E).
static bool chunk_in_fixed(foreign_file *file, const foreign_array *array, const uint64_t *place, foreign_chunk *out) {
    enum { HEAD = 24, BLOCK = 14, CHECKSUM = 4 };
    unsigned char *head = foreign_block(file, array->address, HEAD, "FAHD");
    if (!head) return false;
    plain_part part = {head + 5, HEAD - 5, false};
    const unsigned client = (unsigned)plain_number(&part, 1), entry = (unsigned)plain_number(&part, 1);
    const unsigned bits = (unsigned)plain_number(&part, 1);
    const uint64_t count = plain_number(&part, 8), block = plain_number(&part, 8), number = chunk_number(array, place);
    free(head);
    if (!entry_is_known(client, entry) || bits > 32 || number >= count) return foreign_fail(file, "is damaged");
    if (block == PLAIN_NOWHERE) return false;
    const uint64_t page = (uint64_t)1 << bits, pages = (count + page - 1) / page;
    if (count <= page) return chunk_entry(file, array, block + BLOCK + number * entry, entry, client == 1, out);
    // Entries are in pages, which have checksums; a bit says which of them were written.
    if (count > file->source->size) return foreign_fail(file, "is damaged");
    unsigned char byte;
    const uint64_t of = number / page, bitmap = (pages + 7) / 8;
    if (!foreign_read(file, block + BLOCK + of / 8, &byte, 1)) return false;
    if (!(byte >> (7 - of % 8) & 1U)) return false;
    const uint64_t from = block + BLOCK + bitmap + CHECKSUM + of * (page * entry + CHECKSUM);
    return chunk_entry(file, array, from + number % page * entry, entry, client == 1, out);
}

/// Finds an address in the head of a block of addresses.
static bool chunk_address(foreign_file *file, uint64_t at, uint64_t *out) {
    unsigned char bytes[8] = {0};
    if (!foreign_read(file, at, bytes, sizeof bytes)) return false;
    plain_part part = {bytes, sizeof bytes, false};
    *out = plain_number(&part, 8);
    return *out != PLAIN_NOWHERE;
}

static unsigned log2_of(uint64_t value) {
    unsigned bits = 0;
    while (value >>= 1U) bits++;
    return bits;
}

/// Finds a chunk in an extensible array (III.F). Its first entries are in the index block, the others in data blocks,
/// of which every second group (super block) has twice as many, and the other ones blocks of twice the size.
static bool chunk_in_extensible(foreign_file *file, const foreign_array *array, const uint64_t *place,
                                foreign_chunk *out) {
    enum { HEAD = 72, PREFIX = 14, CHECKSUM = 4 };
    unsigned char *head = foreign_block(file, array->address, HEAD - CHECKSUM, "EAHD");
    if (!head) return false;
    plain_part part = {head + 5, HEAD - CHECKSUM - 5, false};
    const unsigned client = (unsigned)plain_number(&part, 1), entry = (unsigned)plain_number(&part, 1);
    const unsigned bits = (unsigned)plain_number(&part, 1), first = (unsigned)plain_number(&part, 1);
    const uint64_t least = plain_number(&part, 1), pointers = plain_number(&part, 1);
    const unsigned page_bits = (unsigned)plain_number(&part, 1);
    plain_skip(&part, (size_t)6 * 8);
    const uint64_t index = plain_number(&part, 8);
    free(head);
    // The dimension that may grow comes first, as there may be any number of chunks along it.
    int grows = 0;
    for (int i = 0; i < array->rank; i++)
        if (array->most[i] == UINT64_MAX) grows = i;
    uint64_t number = place[grows];
    for (int i = 0; i < array->rank; i++)
        if (i != grows) number = number * chunk_count(array, i) + place[i];
    const bool filtered = client == 1;
    if (!entry_is_known(client, entry) || bits > 64 || page_bits > 32 || least == 0 || (least & (least - 1)) != 0 ||
        pointers < 2 || (pointers & (pointers - 1)) != 0 || index == PLAIN_NOWHERE)
        return index == PLAIN_NOWHERE ? false : foreign_fail(file, "is damaged");
    const uint64_t offset_bytes = (bits + 7) / 8, blocks = 2 * (pointers - 1), supers = 2 * (uint64_t)log2_of(pointers);
    if (number < first) return chunk_entry(file, array, index + PREFIX + number * entry, entry, filtered, out);
    number -= first;
    // Find the super block, the data block in it, and the place in that.
    const unsigned super = log2_of(number / least + 1);
    if (super > 56) return foreign_fail(file, "is damaged");
    const uint64_t size = ((uint64_t)1 << (super + 1) / 2) * least,
                   inside = number - (((uint64_t)1 << super) - 1) * least;
    const uint64_t page = (uint64_t)1 << page_bits, own = inside / size, at = inside % size;
    const uint64_t data_blocks = (uint64_t)1 << super / 2;
    uint64_t block, table = index + PREFIX + (uint64_t)first * entry;
    if (super < supers) {
        // Addresses of the first super blocks' data blocks are in the index block.
        uint64_t before = 0;
        for (unsigned s = 0; s < super; s++) before += (uint64_t)1 << s / 2;
        if (!chunk_address(file, table + 8 * (before + own), &block)) return false;
    } else {
        uint64_t address;
        if (!chunk_address(file, table + 8 * blocks + 8 * (super - supers), &address)) return false;
        const uint64_t pages = size > page ? size / page : 0, bitmap = (pages + 7) / 8;
        // A bit for each page of a data block says whether it was written.
        const uint64_t bits_at = address + PREFIX + offset_bytes, of = own * pages + at / page;
        unsigned char byte = 0xff;
        if (pages > 0 && !foreign_read(file, bits_at + of / 8, &byte, 1)) return false;
        if (!(byte >> (7 - of % 8) & 1U)) return false;
        if (!chunk_address(file, bits_at + data_blocks * bitmap + 8 * own, &block)) return false;
    }
    const uint64_t entries = block + PREFIX + offset_bytes;
    if (size <= page) return chunk_entry(file, array, entries + at * entry, entry, filtered, out);
    return chunk_entry(file, array, entries + CHECKSUM + at / page * (page * entry + CHECKSUM) + at % page * entry,
                       entry, filtered, out);
}

bool foreign_chunk_find(foreign_file *file, const foreign_array *array, const uint64_t *place, foreign_chunk *out) {
    chunk_search of = {array, place, out, false};
    *out = (foreign_chunk){.address = array->address, .size = array->size, .mask = array->mask};
    if (array->address == PLAIN_NOWHERE) return false;
    switch (array->index) {
    case FOREIGN_TREE_1:
        return chunk_in_tree(file, array, place, out);
    case FOREIGN_SINGLE:
        return true;
    case FOREIGN_IMPLICIT:
        out->address += chunk_number(array, place) * array->chunk_bytes;
        return true;
    case FOREIGN_FIXED:
        return chunk_in_fixed(file, array, place, out);
    case FOREIGN_EXTENSIBLE:
        return chunk_in_extensible(file, array, place, out);
    case FOREIGN_TREE_2:
        return foreign_tree(file, array->address, chunk_record, &of) && of.found;
    }
    return false;
}
