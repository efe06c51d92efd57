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
    bool no_memory;            ///< true: it could not be read for lack of memory
    char reason[INPUT_REASON]; ///< the reason in words: "it is a folder"
} input_file;

/// Opens a plain file. False if it does not exist or is something else (a folder, a FIFO or a device), which could
/// block or never end.
bool input_open(const char *path, input_file *in);

/// Reads the first bytes of a plain file, at most `most`, into a new text with a zero byte at its end, which the caller
/// frees. Returns false where input_open does, if reading fails, or without memory. Afterwards the file is closed and
/// in->descriptor is -1.
bool input_read(const char *path, size_t most, input_file *in, char **text, size_t *length);

/// Writes to `out` the path of a file that `file` names as `path`: a relative path starts in the folder of `file`.
/// Returns false if the result is too long.
bool input_path_from(const char *file, const char *path, char *out, size_t size);

#endif
