/// A source of bytes that are read at any offset: a file or a block of memory.
#ifndef STORE_BYTES_H
#define STORE_BYTES_H

#include "whirl/status.h"

#include <stddef.h>
#include <stdint.h>

typedef struct byte_source {
    /// Reads exactly `size` bytes, which must lie within the source; returns 0, or an errno.
    int (*read)(void *context, uint64_t offset, void *to, size_t size);
    void *context;
    uint64_t size;
} byte_source;

/// Returns a source that reads a borrowed block of memory.
byte_source bytes_of_memory(const void *bytes, size_t size);

enum { BYTE_WINDOW = 1 << 16 };

/// An ordinary file opened for reading. A window of it is buffered, since headers are read in many small pieces.
typedef struct byte_file {
    int descriptor;
    byte_source source; ///< its context is this structure, which must not move
    uint64_t start;     ///< start of the window
    size_t length;
    unsigned char window[BYTE_WINDOW];
} byte_file;
/// Opens a file. WHIRL_IO_ERROR with path and reason.
whirl_status bytes_open(byte_file *file, const char *path);
void bytes_close(byte_file *file);

/// Read or write a range of bytes of an open file; interrupted calls are repeated. Return 0 or an errno.
int bytes_read_at(int descriptor, uint64_t offset, void *to, size_t size);
int bytes_write_at(int descriptor, uint64_t offset, const void *from, size_t size);

#endif
