/// Where a result goes.
#ifndef CLI_OUTPUT_H
#define CLI_OUTPUT_H

#include <stdbool.h>

/// True when a result and its journals can be made by this name, so that hours of computing are not lost to a wrong
/// one; complains if not. `input` must not be the same file.
bool output_is_writable(const char *path, const char *input);

/// True when nothing stands at `path`; complains if something does, for results are not replaced unasked.
bool output_is_free(const char *path);

/// What is derived from a file holds what stands in it: from now on this process makes no file that more people can
/// read than this one.
void keep_private(const char *path);

/// False, with a complaint, when `path` or a folder in it is a file, so that it can be no folder.
bool output_may_be_folder(const char *path);

#endif
