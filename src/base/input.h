/// Input files: opening one never blocks.
#ifndef BASE_INPUT_H
#define BASE_INPUT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { INPUT_REASON = 128 };

/// An open input file.
typedef struct input_file {
    int descriptor; ///< -1 if it is not open; the caller closes it
    uint64_t size;
    bool no_memory;            ///< reason why it could not be read
    char reason[INPUT_REASON]; ///< the reason in words: "it is a folder"
} input_file;

/// Opens a plain file. False if it does not exist or is something else (a folder, a FIFO or a device), which could
/// block or never end.
bool input_open(const char *path, input_file *in);

/// Reads the first bytes of a plain file, at most `most`. The text, with a zero byte at its end, is to be freed. False
/// as input_open, or without memory. Afterwards the file is closed and in->descriptor is -1.
bool input_read(const char *path, size_t most, input_file *in, char **text, size_t *length);

/// Writes the path of a file that another one names: from the folder of that file, unless it begins at the root. False
/// if it is too long.
bool input_beside(const char *file, const char *path, char *out, size_t size);

#endif
