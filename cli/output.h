/// Where a result goes.
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include <stdbool.h>

/// True when a file can be made beside `path`, so that hours of computing are not lost to a wrong name; complains if not.
/// `input` must not be the same file.
bool output_is_writable(const char *path, const char *input);

/// False, with a complaint, when `path` or a folder in it is a file, so that it can be no folder.
bool output_may_be_folder(const char *path);

#endif
