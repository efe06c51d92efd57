/// Checks of the path of a result.
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include <stdbool.h>

/// Returns true if a result and its journals can be written at `path`; otherwise reports an error, before hours of
/// computing are lost. `input` is the case, which must not be the same file.
bool output_is_writable(const char *path, const char *input);

/// Returns true if nothing exists at `path`; otherwise reports an error: results are replaced only with --force.
bool output_is_free(const char *path);

/// Restricts the permissions of all new files of this process to those of the file at `path`, from which they are
/// computed.
void keep_private(const char *path);

/// Returns true if `path` is a folder or can become one; otherwise reports that it is a file, or that a part of its
/// path is one.
bool output_may_be_folder(const char *path);

#endif
