/// Files that are read: opening one never waits.
#ifndef BASE_INPUT_H
#define BASE_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { INPUT_REASON = 128 };

/// A file that is open to be read.
typedef struct input_file {
    int descriptor; ///< -1 where it is not open; closed by who opened it
    uint64_t size;
    bool no_memory;            ///< why it could not be read
    char reason[INPUT_REASON]; ///< the same in words: "it is a folder"
} input_file;

/// Opens a plain file. False where there is none, or something else: a folder, a FIFO or a device, which would wait or
/// never end.
bool input_open(const char *path, input_file *in);

/// Reads the first bytes of a plain file, at most `most`. The text, with a zero byte behind it, is to be freed. False
/// as input_open, or without memory: then all is closed and in->descriptor is -1, as it is afterwards.
bool input_read(const char *path, size_t most, input_file *in, char **text, size_t *length);

#endif
