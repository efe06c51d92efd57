// Checks the messages of object headers: only those of whirl's files are valid (h5file.h).
#include "h5file.h"

#include "bytes.h"
#include "shape.h"

#include <string.h>

enum {
    MAX_RANK = SHAPE_MAX_RANK,
    MIN_CHUNK =
        1 << 21, ///< bytes that a chunk may have in a file that is smaller: a table without points has chunks, too
    MAX_PAGE_BITS = 10, ///< log2 of the chunk addresses in a page, as in HDF5
    FLETCHER = 4        ///< bytes of the checksum after a chunk
};

/// Types of messages, IV.A.2.
enum {
    NIL = 0x00,
    DATASPACE = 0x01,
    LINK_INFO = 0x02,
    DATATYPE = 0x03,
    FILL_VALUE = 0x05,
    LINK = 0x06,
    LAYOUT = 0x08,
    GROUP_INFO = 0x0a,
    FILTERS = 0x0b,
    ATTRIBUTE = 0x0c,
    CONTINUATION = 0x10,
    ATTRIBUTE_INFO = 0x15
};

static bool in_file(uint64_t size, uint64_t address, uint64_t length) {
    return address <= size && length <= size - address;
}

/// Reads a dataspace (IV.A.2.b, version 2): a single value or a simple space of no more than `most` values.
static bool read_dataspace(plain_part *part, size_t *rank, uint64_t most, uint64_t *values) {
    const unsigned version = (unsigned)plain_number(part, 1);
    *rank = (size_t)plain_number(part, 1);
    const unsigned flags = (unsigned)plain_number(part, 1), kind = (unsigned)plain_number(part, 1);
    *values = 1;
    if (version != 2 || *rank > MAX_RANK || flags > 1 || kind > 1 || (kind == 0) != (*rank == 0)) return false;
    for (size_t i = 0; i < *rank; ++i) {
        const uint64_t length = plain_number(part, 8);
        if (length > 0 && *values > most / length) return false;
        *values *= length;
    }
    if (flags & 1) plain_skip(part, 8 * *rank);
    return !part->short_of;
}

/// Returns true if a type begins with these bytes; its version, the upper half of the first byte, does not matter.
static bool is_type(const plain_part *part, const unsigned char *type, size_t length) {
    return part->left >= length && (part->at[0] & 0x0f) == type[0] && memcmp(part->at + 1, type + 1, length - 1) == 0;
}

/// Reads a datatype (IV.A.2.d): int64, double, float, or text of fixed length in any character set. Versions 1 to 3 are
/// the same for these.
static bool read_datatype(plain_part *part, size_t *size) {
    static const unsigned char whole[] = {0x00, 0x08, 0, 0, 8, 0, 0, 0, 0, 0, 64, 0};
    static const unsigned char real[] = {0x01, 0x20, 0x3f, 0,    8,    0,    0,    0,    0, 0,
                                         64,   0,    0x34, 0x0b, 0x00, 0x34, 0xff, 0x03, 0, 0};
    static const unsigned char single[] = {0x01, 0x20, 0x1f, 0,    4,    0,    0,    0,    0, 0,
                                           32,   0,    0x17, 0x08, 0x00, 0x17, 0x7f, 0x00, 0, 0};
    enum { TEXT = 3, UTF8 = 0x10 };
    const unsigned version = part->left > 0 ? part->at[0] >> 4 : 0;
    const bool number =
        is_type(part, whole, sizeof whole) || is_type(part, real, sizeof real) || is_type(part, single, sizeof single);
    const unsigned kind = (unsigned)plain_number(part, 1) & 15, alphabet = (unsigned)plain_number(part, 1);
    const unsigned rest = (unsigned)plain_number(part, 2);
    *size = (size_t)plain_number(part, 4);
    const bool text = kind == TEXT && (alphabet & ~(unsigned)UTF8) == 0 && rest == 0 && *size > 0;
    return version >= 1 && version <= 3 && (number || text) && !part->short_of;
}

/// Checks that links or attributes (IV.A.2.c, IV.A.2.v) are not stored outside of the header. A number of `width` bytes
/// may precede the addresses.
static bool check_info(plain_part part, size_t width) {
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    bool nowhere = true;
    if (flags & 1) plain_skip(&part, width);
    for (int i = 0; i < (flags & 2 ? 3 : 2); ++i) nowhere = plain_number(&part, 8) == PLAIN_NOWHERE && nowhere;
    return version == 0 && flags <= 3 && nowhere && !part.short_of;
}

/// Reads a link (IV.A.2.g), which must be a hard link.
static bool read_link(plain_part part, plain_lead *lead) {
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    const unsigned kind = flags & 8 ? (unsigned)plain_number(&part, 1) : 0;
    if (flags & 4) plain_skip(&part, 8);
    if (flags & 16) plain_skip(&part, 1);
    const uint64_t length = plain_number(&part, 1 << (flags & 3));
    if (version != 1 || flags > 31 || kind != 0 || length == 0 || length > part.left) return false;
    plain_skip(&part, (size_t)length);
    lead->kind = PLAIN_OBJECT;
    lead->address = plain_number(&part, 8);
    return !part.short_of;
}

/// Checks an attribute (IV.A.2.m, version 3): name, type, space and values follow one another.
static bool check_attribute(plain_part part) {
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    const size_t name = (size_t)plain_number(&part, 2), type = (size_t)plain_number(&part, 2),
                 space = (size_t)plain_number(&part, 2);
    const unsigned alphabet = (unsigned)plain_number(&part, 1);
    if (version != 3 || flags != 0 || alphabet > 1 || part.short_of || name == 0 || name + type + space > part.left)
        return false;
    if (memchr(part.at, '\0', name) != part.at + name - 1) return false;
    plain_part of_type = {part.at + name, type, false}, of_space = {part.at + name + type, space, false};
    size_t size, rank;
    uint64_t values;
    plain_skip(&part, name + type + space);
    return read_datatype(&of_type, &size) && read_dataspace(&of_space, &rank, part.left, &values) && rank <= 1 &&
           values * size <= part.left;
}

/// Head of a fixed array (VII.C), which lists the addresses of the chunks of a large dataset.
typedef struct fixed_array {
    size_t entry, page_bits;
    uint64_t entries, block;
} fixed_array;

static bool read_fixed_array(const byte_source *source, uint64_t address, fixed_array *array, int *reason) {
    enum { HEADER = 28, FILTERED = 1 };
    unsigned char bytes[HEADER];
    if (!in_file(source->size, address, HEADER)) return false;
    *reason = source->read(source->context, address, bytes, sizeof bytes);
    if (*reason || memcmp(bytes, "FAHD", 4) != 0) return false;
    plain_part header = {bytes + 4, HEADER - 4, false};
    const unsigned version = (unsigned)plain_number(&header, 1), client = (unsigned)plain_number(&header, 1);
    array->entry = (size_t)plain_number(&header, 1), array->page_bits = (size_t)plain_number(&header, 1);
    array->entries = plain_number(&header, 8), array->block = plain_number(&header, 8);
    if (version != 0 || client != FILTERED || array->entry < 13 || array->entry > 20 || array->page_bits == 0 ||
        array->page_bits > MAX_PAGE_BITS)
        return false;
    return array->entries > 0 && array->entries <= source->size / array->entry;
}

/// Checks the addresses of chunks, which all have the same size. Addresses that do not fit into one page are in
/// several, each with a checksum.
static bool check_places(const byte_source *source, uint64_t address, const fixed_array *array, uint64_t stored,
                         int *reason) {
    enum { BLOCK = 14, FILTERED = 1, MAX_BYTES = BLOCK + 20 * (1 << MAX_PAGE_BITS) };
    unsigned char bytes[MAX_BYTES];
    const bool paged = array->entries > (uint64_t)1 << array->page_bits;
    if (!in_file(source->size, array->block, BLOCK + array->entries * array->entry + 4)) return false;
    const uint64_t length = BLOCK + (paged ? 0 : array->entries * array->entry);
    if (length > MAX_BYTES) return false;
    *reason = source->read(source->context, array->block, bytes, (size_t)length);
    if (*reason || memcmp(bytes, "FADB", 4) != 0) return false;
    plain_part part = {bytes + 4, (size_t)length - 4, false};
    const unsigned version = (unsigned)plain_number(&part, 1), client = (unsigned)plain_number(&part, 1);
    if (version != 0 || client != FILTERED || plain_number(&part, 8) != address) return false;
    for (uint64_t i = 0; !paged && i < array->entries; ++i) {
        const uint64_t chunk = plain_number(&part, 8), bytes_of_chunk = plain_number(&part, (int)array->entry - 12);
        const uint64_t left_out = plain_number(&part, 4);
        if (chunk == PLAIN_NOWHERE) continue;
        if (!in_file(source->size, chunk, bytes_of_chunk) || bytes_of_chunk != stored || left_out != 0) return false;
    }
    return true;
}

static bool check_fixed_array(const byte_source *source, uint64_t address, uint64_t stored, int *reason) {
    fixed_array array;
    if (!read_fixed_array(source, address, &array, reason)) return false;
    return array.block == PLAIN_NOWHERE || check_places(source, address, &array, stored, reason);
}

/// Reads a layout (IV.A.2.i, version 4): chunks with checksums, either a single one or a fixed array.
static bool read_layout(const byte_source *source, plain_part part, plain_object *object) {
    enum { CHUNKED = 2, ONE_FILTERED = 2, ONE = 1, FIXED_ARRAY = 3 };
    // Read the version, the kind and the size of a chunk.
    const unsigned version = (unsigned)plain_number(&part, 1), kind = (unsigned)plain_number(&part, 1);
    const unsigned flags = (unsigned)plain_number(&part, 1);
    const size_t rank = (size_t)plain_number(&part, 1), width = (size_t)plain_number(&part, 1);
    if (version != 4 || kind != CHUNKED || rank < 2 || rank > MAX_RANK + 1 || width < 1 || width > 8) return false;
    const uint64_t most = source->size > MIN_CHUNK ? source->size : MIN_CHUNK;
    uint64_t stored = 1;
    object->chunk_rank = rank - 1;
    for (size_t i = 0; i < rank; ++i) {
        const uint64_t length = plain_number(&part, (int)width);
        if (length == 0 || stored > most / length) return false;
        stored *= length;
        object->chunk = (size_t)length; // the last one is the size of an element
    }
    stored += FLETCHER;
    // A single chunk.
    const unsigned index = (unsigned)plain_number(&part, 1);
    if (index == ONE && flags == ONE_FILTERED) {
        const uint64_t length = plain_number(&part, 8), left_out = plain_number(&part, 4);
        const uint64_t address = plain_number(&part, 8);
        if (part.short_of) return false;
        return address == PLAIN_NOWHERE ||
               (in_file(source->size, address, length) && length == stored && left_out == 0);
    }
    // A fixed array of chunks.
    if (index != FIXED_ARRAY || flags != 0) return false;
    const uint64_t page_bits = plain_number(&part, 1), address = plain_number(&part, 8);
    if (part.short_of || page_bits == 0 || page_bits > MAX_PAGE_BITS) return false;
    return address == PLAIN_NOWHERE || check_fixed_array(source, address, stored, &object->reason);
}

static bool read_dataset_space(plain_part part, plain_object *object) {
    uint64_t values;
    return read_dataspace(&part, &object->rank, UINT64_MAX, &values) && object->rank > 0;
}

static bool check_filters(plain_part part) {
    // IV.A.2.l, version 2: one filter, number 3 (Fletcher32), without values.
    static const unsigned char checksums[] = {2, 1, 3, 0, 0, 0, 0, 0};
    return part.left == sizeof checksums && memcmp(part.at, checksums, sizeof checksums) == 0;
}

/// Checks a fill value message (IV.A.2.f, version 3): there must be no fill value.
static bool check_fill(plain_part part) {
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    return version == 3 && flags < 1 << 4 && !part.short_of;
}

/// Checks group info (IV.A.2.k, version 0), which has hints for sizes.
static bool check_group_info(plain_part part) {
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    plain_skip(&part, (flags & 1 ? 4 : 0) + (flags & 2 ? 4 : 0));
    return version == 0 && flags <= 3 && !part.short_of;
}

bool plain_message(const byte_source *source, unsigned type, plain_part message, plain_object *object,
                   plain_lead *lead) {
    // Most messages occur once.
    if (type < 32 && type != NIL && type != LINK && type != ATTRIBUTE && type != CONTINUATION) {
        if (object->found >> type & 1) return false;
        object->found |= 1u << type;
    }
    switch (type) {
    case NIL:
        return true;
    case DATASPACE:
        return read_dataset_space(message, object);
    case LINK_INFO:
        return check_info(message, 8);
    case DATATYPE:
        return read_datatype(&message, &object->type_size);
    case FILL_VALUE:
        return check_fill(message);
    case LINK:
        return read_link(message, lead);
    case LAYOUT:
        return read_layout(source, message, object);
    case GROUP_INFO:
        return check_group_info(message);
    case FILTERS:
        return check_filters(message);
    case ATTRIBUTE:
        return check_attribute(message);
    case ATTRIBUTE_INFO:
        return check_info(message, 2);
    case CONTINUATION:
        lead->kind = PLAIN_CONTINUATION;
        lead->address = plain_number(&message, 8);
        lead->length = plain_number(&message, 8);
        return !message.short_of;
    default:
        return false;
    }
}

bool plain_object_whole(const plain_object *object) {
    const unsigned group = 1u << LINK_INFO | 1u << GROUP_INFO;
    const unsigned dataset = 1u << DATASPACE | 1u << DATATYPE | 1u << FILL_VALUE | 1u << LAYOUT | 1u << FILTERS;
    const unsigned found = object->found & ~(1u << ATTRIBUTE_INFO);
    if (found == group) return true;
    return found == dataset && object->rank == object->chunk_rank && object->type_size == object->chunk;
}
