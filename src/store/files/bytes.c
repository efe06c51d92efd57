#include "bytes.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "input.h"

int bytes_read_at(int descriptor, uint64_t offset, void *to, size_t size) {
    unsigned char *next = to;
    while (size > 0) {
        const ssize_t got = pread(descriptor, next, size, (off_t)offset);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return got < 0 ? errno : EIO; // the file has become shorter
        next += got;
        offset += (uint64_t)got;
        size -= (size_t)got;
    }
    return 0;
}

int bytes_write_at(int descriptor, uint64_t offset, const void *from, size_t size) {
    const unsigned char *next = from;
    while (size > 0) {
        const ssize_t put = pwrite(descriptor, next, size, (off_t)offset);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return put < 0 ? errno : EIO;
        next += put;
        offset += (uint64_t)put;
        size -= (size_t)put;
    }
    return 0;
}

static int read_memory(void *context, uint64_t offset, void *to, size_t size) {
    memcpy(to, (const unsigned char *)context + offset, size);
    return 0;
}

byte_source bytes_of_memory(const void *bytes, size_t size) {
    return (byte_source){read_memory, (void *)(uintptr_t)bytes, size}; // read_memory does not change them
}

static int read_file(void *context, uint64_t offset, void *to, size_t size) {
    byte_file *file = context;
    if (size > BYTE_WINDOW / 2) return bytes_read_at(file->descriptor, offset, to, size);
    if (offset < file->start || offset + size > file->start + file->length) {
        const uint64_t left = file->source.size - offset;
        const size_t length = left < BYTE_WINDOW ? (size_t)left : BYTE_WINDOW;
        file->length = 0;
        const int reason = bytes_read_at(file->descriptor, offset, file->window, length);
        if (reason) return reason;
        file->start = offset;
        file->length = length;
    }
    memcpy(to, file->window + (offset - file->start), size);
    return 0;
}

static whirl_status cannot_read(const char *path, const char *reason) {
    return whirl_fail(WHIRL_IO_ERROR, "cannot read %s: %s", path, reason);
}

whirl_status bytes_open(byte_file *file, const char *path) {
    input_file in;
    file->start = file->length = 0;
    const bool open = input_open(path, &in);
    file->descriptor = in.descriptor;
    if (!open) return cannot_read(path, in.reason);
    file->source = (byte_source){read_file, file, in.size};
    return whirl_ok();
}

void bytes_close(byte_file *file) {
    if (file->descriptor >= 0) close(file->descriptor);
    file->descriptor = -1;
}
