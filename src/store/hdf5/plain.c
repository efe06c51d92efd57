// Walks through the object headers of a file and checks them (h5file.h).
#include <stdlib.h>
#include <string.h>

#include "h5file.h"

enum {
    /// II.A, superblock version 3.
    BASE_ADDRESS = 12,
    SUPERBLOCK_EXTENSION = 20,
    ROOT_HEADER = 36,

    /// IV.A.1.b, object header version 2.
    HEADER_VERSION = 2,
    CREATION_ORDER = 1 << 2,
    PHASE_CHANGE = 1 << 4,
    TIMES = 1 << 5,
    CHECKSUM = 4,

    /// IV.A.1.a: flags of messages that are whirl's: constant, not to be shared.
    MESSAGE_FLAGS = 1 << 0 | 1 << 2
};

/// An address to be checked; length: of a part of a header, 0 for an object.
typedef struct place {
    uint64_t address, length;
} place;

typedef struct places {
    size_t count, capacity;
    place *items;
} places;

typedef struct walk {
    const byte_source *source;
    uint64_t seen;         ///< header bytes checked so far; more than the file has mean an overlap or a cycle
    places objects, parts; ///< parts: of the present object
    unsigned char *bytes;  ///< current header, or part of it
    size_t capacity;
    uint64_t wrong; ///< address of something that whirl does not write
    bool memory;    ///< memory ran out
    int reason;     ///< errno of a read that failed
} walk;

static bool push(walk *through, places *list, place one) {
    if (list->count == list->capacity) {
        const size_t capacity = list->capacity ? 2 * list->capacity : 64;
        place *items = realloc(list->items, capacity * sizeof *items);
        if (!items) {
            through->memory = true;
            return false;
        }
        list->items = items;
        list->capacity = capacity;
    }
    list->items[list->count++] = one;
    return true;
}

/// Counts bytes as checked. Returns false if they are not in the file, or if more bytes would be checked than it has.
static bool see(walk *through, uint64_t address, uint64_t length) {
    const uint64_t size = through->source->size;
    if (address > size || length > size - address || length > size - through->seen) return false;
    through->seen += length;
    return true;
}

/// Reads bytes of the file into `bytes`, in place of those read before.
static bool load(walk *through, uint64_t address, size_t length) {
    if (length > through->capacity) {
        unsigned char *bytes = realloc(through->bytes, length);
        through->memory = !bytes;
        if (!bytes) return false;
        through->bytes = bytes;
        through->capacity = length;
    }
    through->reason = through->source->read(through->source->context, address, through->bytes, length);
    return through->reason == 0;
}

/// Checks the messages of one part of an object's header, which ends at `end` in the file. Bytes that are fewer than
/// the head of a message may remain.
static bool walk_messages(walk *through, plain_part part, uint64_t end, bool ordered, plain_object *object) {
    const size_t head = ordered ? 6 : 4;
    while (part.left >= head) {
        through->wrong = end - part.left;
        const unsigned type = (unsigned)plain_number(&part, 1);
        const size_t length = (size_t)plain_number(&part, 2);
        const unsigned flags = (unsigned)plain_number(&part, 1);
        plain_lead lead = {PLAIN_NONE, 0, 0};
        if (ordered) plain_skip(&part, 2);
        if (length > part.left || flags & ~(unsigned)MESSAGE_FLAGS) return false;
        if (!plain_message(through->source, type, (plain_part){part.at, length, false}, object, &lead)) {
            through->reason = object->reason;
            return false;
        }
        if (lead.kind == PLAIN_CONTINUATION && !push(through, &through->parts, (place){lead.address, lead.length}))
            return false;
        if (lead.kind == PLAIN_OBJECT && !push(through, &through->objects, (place){lead.address, 0})) return false;
        plain_skip(&part, length);
    }
    return true;
}

/// Checks a continuation of a header (IV.A.1.c): a signature, messages and a checksum.
static bool walk_continuation(walk *through, place one, bool ordered, plain_object *object) {
    through->wrong = one.address;
    if (one.length < 4 + CHECKSUM || !see(through, one.address, one.length)) return false;
    const size_t length = (size_t)one.length - CHECKSUM;
    if (!load(through, one.address, length) || memcmp(through->bytes, "OCHK", 4) != 0) return false;
    return walk_messages(through, (plain_part){through->bytes + 4, length - 4, false}, one.address + length, ordered,
                         object);
}

/// Reads the head of an object's header: length and start of its messages.
static bool read_head(walk *through, uint64_t address, bool *ordered, uint64_t *length, size_t *begin) {
    enum { MAX_HEAD = 4 + 2 + 16 + 4 + 8 };
    const uint64_t size = through->source->size;
    if (address > size) return false;
    const size_t there = size - address < MAX_HEAD ? (size_t)(size - address) : MAX_HEAD;
    if (!load(through, address, there)) return false;
    plain_part part = {through->bytes, there, false};
    const bool signature = there >= 4 && memcmp(part.at, "OHDR", 4) == 0;
    plain_skip(&part, 4);
    const unsigned version = (unsigned)plain_number(&part, 1), flags = (unsigned)plain_number(&part, 1);
    if (flags & TIMES) plain_skip(&part, 16);
    if (flags & PHASE_CHANGE) plain_skip(&part, 4);
    *ordered = flags & CREATION_ORDER;
    *length = plain_number(&part, 1 << (flags & 3));
    *begin = (size_t)(part.at - through->bytes);
    return signature && version == HEADER_VERSION && !part.short_of;
}

static bool walk_object(walk *through, uint64_t address) {
    plain_object object = {0};
    bool ordered;
    uint64_t length;
    size_t begin;
    through->wrong = address;
    through->parts.count = 0;
    if (!read_head(through, address, &ordered, &length, &begin)) return false;
    const uint64_t first = address + begin;
    if (length > through->source->size || !see(through, first, length + CHECKSUM)) return false;
    if (!load(through, first, (size_t)length)) return false;
    if (!walk_messages(through, (plain_part){through->bytes, (size_t)length, false}, first + length, ordered, &object))
        return false;
    for (size_t i = 0; i < through->parts.count; ++i)
        if (!walk_continuation(through, through->parts.items[i], ordered, &object)) return false;
    through->wrong = address;
    return plain_object_whole(&object);
}

static bool walk_file(walk *through) {
    if (!load(through, BASE_ADDRESS, ROOT_HEADER + 8 - BASE_ADDRESS)) return false;
    plain_part base = {through->bytes, 8, false},
               extension = {through->bytes + SUPERBLOCK_EXTENSION - BASE_ADDRESS, 8, false},
               root = {through->bytes + ROOT_HEADER - BASE_ADDRESS, 8, false};
    if (plain_number(&base, 8) != 0 || plain_number(&extension, 8) != PLAIN_NOWHERE) return false;
    if (!push(through, &through->objects, (place){plain_number(&root, 8), 0})) return false;
    while (through->objects.count > 0)
        if (!walk_object(through, through->objects.items[--through->objects.count].address)) return false;
    return true;
}

whirl_status plain_check(const byte_source *source) {
    walk through = {.source = source};
    const bool well = walk_file(&through);
    free(through.objects.items);
    free(through.parts.items);
    free(through.bytes);
    if (well) return whirl_ok();
    if (through.memory) return whirl_fail(WHIRL_NO_MEMORY, "no memory to look through the file");
    if (through.reason) return whirl_fail(WHIRL_IO_ERROR, "%s", strerror(through.reason));
    return whirl_fail(WHIRL_BAD_INPUT, "is damaged, or holds what whirl does not write (at byte %llu)",
                      (unsigned long long)through.wrong);
}
