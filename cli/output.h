/// Path of a result.
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include <stdbool.h>

/// True when a result and its journals can be made by this name, so that hours of computing are not lost to a wrong
/// one; complains if not. `input` must not be the same file.
bool output_is_writable(const char *path, const char *input);

/// Returns true if nothing exists at `path`; otherwise reports an error, since results are not overwritten unasked.
bool output_is_free(const char *path);

/// Restricts the permissions of all new files of this process to those of a file that they are derived from.
void keep_private(const char *path);

/// False, with a complaint, when `path` or a folder in it is a file, so that it can be no folder.
bool output_may_be_folder(const char *path);

#endif
