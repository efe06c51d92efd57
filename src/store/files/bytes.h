/// Bytes that are read at any place: a file's, or those of a block of memory.
#ifndef STORE_BYTES_H
#define STORE_BYTES_H

#include "whirl/status.h"

#include <stddef.h>
#include <stdint.h>

typedef struct byte_source {
    /// Reads exactly `size` bytes that are there; 0, or an errno.
    int (*read)(void *context, uint64_t offset, void *to, size_t size);
    void *context;
    uint64_t size;
} byte_source;

/// A block of memory, which is borrowed.
byte_source bytes_of_memory(unsigned char *bytes, size_t size);

enum { BYTE_WINDOW = 1 << 16 };

/// An ordinary file opened for reading. WHIRL_IO_ERROR with path and reason. A window of it is buffered, since headers
/// are read in many small pieces.
typedef struct byte_file {
    int descriptor;
    byte_source source; ///< its context is this structure, which must not move
    uint64_t start;     ///< start of the window
    size_t length;
    unsigned char window[BYTE_WINDOW];
} byte_file;
whirl_status bytes_open(byte_file *file, const char *path);
void bytes_close(byte_file *file);

/// Read or write a range of bytes of an open file; interrupted calls are repeated. Return 0 or an errno.
int bytes_read_at(int descriptor, uint64_t offset, void *to, size_t size);
int bytes_write_at(int descriptor, uint64_t offset, const void *from, size_t size);

#endif
