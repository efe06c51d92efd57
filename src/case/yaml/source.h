/// The bytes of a file, before anything is made of them.
#ifndef CASE_SOURCE_H
#define CASE_SOURCE_H

#include <stddef.h>

#include "whirl/engine/case.h"
#include "whirl/status.h"

/// Reads at most one byte more than TREE_MAX_BYTES, whatever the size of the file; pipes and devices too. *text is
/// freed by the caller; `problems`, which may be NULL, are then of this file. WHIRL_BAD_INPUT with a sentence for what
/// cannot be read (nothing there, a directory, no permission).
whirl_status source_load(const char *path, whirl_problems *problems, char **text, size_t *length);

/// Reports what is no text: too many bytes, bytes that are not UTF-8, control characters, tabs that indent.
void source_check(const char *text, size_t length, whirl_problems *problems);

#endif
