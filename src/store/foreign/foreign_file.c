// The bytes of a file: its superblock, and blocks of metadata (foreign.h).
#include "foreign.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool foreign_fail(foreign_file *file, const char *format, ...) {
    char text[WHIRL_MESSAGE_SIZE];
    va_list arguments;
    if (file->status.code != WHIRL_OK) return false;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    file->status = whirl_fail(WHIRL_BAD_INPUT, "%s", text);
    return false;
}

bool foreign_no_memory(foreign_file *file) {
    if (file->status.code == WHIRL_OK) file->status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a file of numbers");
    return false;
}

bool foreign_inside(const foreign_file *file, uint64_t address, uint64_t length) {
    const uint64_t size = file->source->size - file->base;
    return address <= size && length <= size - address;
}

bool foreign_read(foreign_file *file, uint64_t address, void *to, size_t size) {
    if (file->status.code != WHIRL_OK) return false;
    if (!foreign_inside(file, address, size)) return foreign_fail(file, "is damaged or cut off");
    const int reason = file->source->read(file->source->context, file->base + address, to, size);
    if (reason) file->status = whirl_fail(WHIRL_IO_ERROR, "cannot be read: %s", strerror(reason));
    return reason == 0;
}

unsigned char *foreign_block(foreign_file *file, uint64_t address, uint64_t size, const char *signature) {
    if (file->status.code == WHIRL_OK && (file->visits == 0 || size > FOREIGN_MAX_BLOCK || size < 4))
        foreign_fail(file, "is damaged, or has parts that are too large");
    if (file->status.code != WHIRL_OK) return NULL;
    file->visits--;
    if (!foreign_inside(file, address, size)) {
        foreign_fail(file, "is damaged or cut off");
        return NULL;
    }
    unsigned char *bytes = malloc((size_t)size);
    if (!bytes) foreign_no_memory(file);
    if (bytes && foreign_read(file, address, bytes, (size_t)size)) {
        if (!signature || memcmp(bytes, signature, 4) == 0) return bytes;
        foreign_fail(file, "is damaged");
    }
    free(bytes);
    return NULL;
}

int foreign_find_superblock(const byte_source *source, uint64_t most, uint64_t *at) {
    unsigned char head[sizeof h5_signature];
    for (*at = 0; *at <= most && *at < source->size && source->size - *at >= sizeof head;
         *at = *at > 0 ? 2 * *at : 512) {
        const int reason = source->read(source->context, *at, head, sizeof head);
        if (reason || memcmp(head, h5_signature, sizeof head) == 0) return reason;
    }
    *at = source->size;
    return 0;
}

bool foreign_open(foreign_file *file, const byte_source *source) {
    enum { MIN_SIZE = 48, MAX_SIZE = 104 };
    unsigned char bytes[MAX_SIZE] = {0};
    *file = (foreign_file){.source = source, .visits = FOREIGN_MAX_VISITS};
    const int reason = foreign_find_superblock(source, 1 << 24, &file->base);
    const uint64_t left = source->size - file->base;
    if (reason) file->status = whirl_fail(WHIRL_IO_ERROR, "cannot be read: %s", strerror(reason));
    if (reason == 0 && left < MIN_SIZE) return foreign_fail(file, "is no HDF5, MAT or universal file");
    if (!foreign_read(file, 0, bytes, left < MAX_SIZE ? (size_t)left : MAX_SIZE)) return false;
    const unsigned version = bytes[8];
    plain_part part = {bytes, sizeof bytes, false};
    plain_skip(&part, version < 2 ? 13 : 9);
    const uint64_t offsets = plain_number(&part, 1), lengths = plain_number(&part, 1);
    if (version > 3) return foreign_fail(file, "is an HDF5 file of version %u, expected 0 to 3", version);
    if (offsets != 8 || lengths != 8)
        return foreign_fail(file, "has addresses of %u bytes, expected 8", (unsigned)offsets);
    plain_skip(&part, version < 2 ? (version == 1 ? 13 : 9) : 1);
    plain_skip(&part, 16); // base address, which is that of the superblock, and free space or an extension
    const uint64_t end = plain_number(&part, 8);
    if (version < 2) plain_skip(&part, 16); // driver information, offset of the root's name
    file->root = plain_number(&part, 8);
    if (end > source->size)
        return foreign_fail(file, "is cut off: %llu bytes, expected %llu", (unsigned long long)source->size,
                            (unsigned long long)end);
    return true;
}
