#include "journal_frame.h"

#include <string.h>

#include "crc32c.h"

static const char header_magic[16] = {'w', 'h', 'i', 'r', 'l', ' ', 'j', 'o', 'u', 'r', 'n', 'a', 'l', ' ', '1', '\n'};
const unsigned char journal_magic[8] = {0xf7, 'p', 'o', 'i', 'n', 't', '\r', '\n'};

enum {
    HEADER_SIZE = 16, ///< offset of the identity's length
    HEADER_CHECK = 24,
    HEAD_IDENTITY = 8,
    HEAD_SLOT = 16,
    HEAD_SIZE = 24,
    HEAD_BATCH = 32,
    HEAD_CHECK = 36
};

static void put32(unsigned char *to, uint32_t value) {
    for (int i = 0; i < 4; ++i) to[i] = (unsigned char)(value >> 8 * i);
}

static void put64(unsigned char *to, uint64_t value) {
    for (int i = 0; i < 8; ++i) to[i] = (unsigned char)(value >> 8 * i);
}

static uint32_t get32(const unsigned char *from) {
    uint32_t value = 0;
    for (int i = 3; i >= 0; --i) value = value << 8 | from[i];
    return value;
}

static uint64_t get64(const unsigned char *from) {
    return (uint64_t)get32(from + 4) << 32 | get32(from);
}

uint64_t journal_hash(const char *identity, size_t size) {
    uint64_t hash = 14695981039346656037u;
    for (size_t i = 0; i < size; ++i) hash = (hash ^ (unsigned char)identity[i]) * 1099511628211u;
    return hash;
}

// ---------------------------------------------------------------- header

size_t header_size(size_t size) {
    return JOURNAL_LEAD + size + JOURNAL_TAIL;
}

void header_put(unsigned char *to, const char *identity, size_t size) {
    memcpy(to, header_magic, sizeof header_magic);
    put64(to + HEADER_SIZE, size);
    put32(to + HEADER_CHECK, crc32c(0, to, HEADER_CHECK));
    memcpy(to + JOURNAL_LEAD, identity, size);
    put32(to + JOURNAL_LEAD + size, crc32c(0, to, JOURNAL_LEAD + size));
}

bool header_lead(const unsigned char *from, uint64_t *size) {
    if (memcmp(from, header_magic, sizeof header_magic) != 0) return false;
    *size = get64(from + HEADER_SIZE);
    return get32(from + HEADER_CHECK) == crc32c(0, from, HEADER_CHECK);
}

bool header_is_sound(const unsigned char *from, size_t size) {
    return get32(from + JOURNAL_LEAD + size) == crc32c(0, from, JOURNAL_LEAD + size);
}

// ---------------------------------------------------------------- frames

size_t frame_size(size_t size, size_t dimension) {
    return JOURNAL_HEAD + (size + dimension) * sizeof(double) + JOURNAL_TAIL;
}

unsigned char *frame_numbers_put(unsigned char *to, const double *from, size_t count) {
    for (size_t i = 0; i < count; ++i, to += 8) {
        uint64_t bits;
        memcpy(&bits, &from[i], sizeof bits);
        put64(to, bits);
    }
    return to;
}

void frame_head_put(unsigned char *to, const frame_head *head) {
    memcpy(to, journal_magic, sizeof journal_magic);
    put64(to + HEAD_IDENTITY, head->identity);
    put64(to + HEAD_SLOT, head->slot);
    put64(to + HEAD_SIZE, head->size);
    put32(to + HEAD_BATCH, head->batch);
    put32(to + HEAD_CHECK, crc32c(0, to, HEAD_CHECK));
}

void frame_checksum_put(unsigned char *to, uint32_t sum) {
    put32(to, sum);
}

void frame_put(unsigned char *to, const frame_head *head, const double *block, size_t size, const double *end,
               size_t dimension) {
    frame_head_put(to, head);
    unsigned char *tail = frame_numbers_put(frame_numbers_put(to + JOURNAL_HEAD, block, size), end, dimension);
    frame_checksum_put(tail, crc32c(0, to, (size_t)(tail - to)));
}

bool frame_head_get(const unsigned char *from, frame_head *head) {
    if (memcmp(from, journal_magic, sizeof journal_magic) != 0) return false;
    *head = (frame_head){.identity = get64(from + HEAD_IDENTITY),
                         .slot = get64(from + HEAD_SLOT),
                         .size = get64(from + HEAD_SIZE),
                         .batch = get32(from + HEAD_BATCH)};
    return get32(from + HEAD_CHECK) == crc32c(0, from, HEAD_CHECK);
}

uint32_t frame_checksum(const unsigned char *tail) {
    return get32(tail);
}

void frame_numbers(const unsigned char *from, double *to, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        const uint64_t bits = get64(from + 8 * i);
        memcpy(&to[i], &bits, sizeof bits);
    }
}
