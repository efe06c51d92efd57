/// Loading the bytes of a file, and checking them before they are parsed.
#ifndef CASE_SOURCE_H
#define CASE_SOURCE_H

#include "whirl/engine/case.h"
#include "whirl/status.h"

#include <stddef.h>

/// Reads a plain file, at most one byte more than TREE_MAX_BYTES after a byte order mark. *text is freed by the caller;
/// `problems`, which may be NULL, are then those of this file. WHIRL_BAD_INPUT with a sentence for a file that cannot
/// be read (missing, a folder, a pipe, a device, no permission).
whirl_status source_load(const char *path, whirl_problems *problems, char **text, size_t *length);

/// Reports invalid text: too many bytes, bytes that are not UTF-8, control characters, tabs as indentation.
void source_check(const char *text, size_t length, whirl_problems *problems);

#endif
