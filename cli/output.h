/// Where a result goes.
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include <stdbool.h>

/// True when a file can be made beside `path`, so that hours of computing are not lost to a wrong name; complains if not.
/// `input` must not be the same file.
bool output_is_writable(const char *path, const char *input);

#endif
