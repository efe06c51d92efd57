#include "checksums.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SIZES = 16, SIGNATURE = 4 };

static uint32_t turn(uint32_t word, int bits) {
    return word << bits | word >> (32 - bits);
}

static uint32_t word_at(const uint8_t *bytes) {
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/// Computes the hash "lookup3" of Jenkins (2006, public domain) with the initial value 0, which HDF5 uses for its
/// metadata.
static uint32_t lookup3(const uint8_t *bytes, size_t length) {
    uint32_t a = 0xdeadbeefu + (uint32_t)length, b = a, c = a;
    uint8_t last[12] = {0};
    if (length == 0) return c;
    for (; length > 12; length -= 12, bytes += 12) {
        a += word_at(bytes), b += word_at(bytes + 4), c += word_at(bytes + 8);
        a -= c, a ^= turn(c, 4), c += b;
        b -= a, b ^= turn(a, 6), a += c;
        c -= b, c ^= turn(b, 8), b += a;
        a -= c, a ^= turn(c, 16), c += b;
        b -= a, b ^= turn(a, 19), a += c;
        c -= b, c ^= turn(b, 4), b += a;
    }
    memcpy(last, bytes, length);
    a += word_at(last), b += word_at(last + 4), c += word_at(last + 8);
    c ^= b, c -= turn(b, 14);
    a ^= c, a -= turn(c, 11);
    b ^= a, b -= turn(a, 25);
    c ^= b, c -= turn(b, 16);
    a ^= c, a -= turn(c, 4);
    b ^= a, b -= turn(a, 14);
    c ^= b, c -= turn(b, 24);
    return c;
}

/// Returns true at a structure of metadata (HDF5 File Format Specification 3.0) that begins with a signature and ends
/// with a checksum.
static bool begins_structure(const uint8_t *bytes) {
    static const char signatures[][SIGNATURE + 1] = {"\x89HDF", "OHDR", "OCHK", "FRHP", "FHDB", "FHIB", "BTHD",
                                                     "BTLF",    "BTIN", "EAHD", "EAIB", "EASB", "EADB", "FAHD",
                                                     "FADB",    "SMTB", "SMLI", "FSHD", "FSSE"};
    for (size_t i = 0; i < sizeof signatures / sizeof *signatures; i++)
        if (memcmp(bytes, signatures[i], SIGNATURE) == 0) return true;
    return false;
}

static void add(checksum_list *sums, size_t start, size_t length) {
    if (sums->count == sums->capacity) {
        sums->capacity = sums->capacity ? 2 * sums->capacity : 64;
        sums->items = realloc(sums->items, sums->capacity * sizeof *sums->items);
        if (!sums->items) abort();
    }
    sums->items[sums->count++] = (checksum){start, length};
}

/// Finds the checksums. A structure has the length after which the next four bytes are its checksum.
static void find(checksum_list *sums, const uint8_t *bytes, size_t size) {
    for (size_t start = 0; start + SIGNATURE < size; start++) {
        if (!begins_structure(bytes + start)) continue;
        for (size_t length = SIGNATURE; length < CHECKSUM_MAX && start + length + 4 <= size; length++) {
            if (word_at(bytes + start + length) != lookup3(bytes + start, length)) continue;
            add(sums, start, length);
            break;
        }
    }
}

const checksum_list *checksums_of(const uint8_t *bytes, size_t size) {
    static checksum_list known[MAX_SIZES];
    static size_t count;
    static const uint8_t signature[] = {0x89, 'H', 'D', 'F'};
    for (size_t i = 0; i < count; i++)
        if (known[i].file_size == size) return &known[i];
    if (count == MAX_SIZES || size < sizeof signature || memcmp(bytes, signature, sizeof signature) != 0) return NULL;
    checksum_list sums = {.file_size = size};
    find(&sums, bytes, size);
    // A sound file has those of its superblock and of its root at least.
    if (sums.count < 2 || sums.items[0].start != 0) {
        free(sums.items);
        return NULL;
    }
    known[count] = sums;
    return &known[count++];
}

void checksums_mend(const checksum_list *sums, uint8_t *bytes) {
    for (size_t i = 0; i < sums->count; i++) {
        const checksum *one = &sums->items[i];
        const uint32_t sum = lookup3(bytes + one->start, one->length);
        for (int k = 0; k < 4; k++) bytes[one->start + one->length + (size_t)k] = (uint8_t)(sum >> 8 * k);
    }
}
