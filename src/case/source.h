/// The bytes of a file, before anything is made of them.
#ifndef CASE_SOURCE_H
#define CASE_SOURCE_H

#include <stddef.h>

#include "whirl/case.h"
#include "whirl/status.h"

/// Reads at most TREE_MAX_BYTES bytes; a longer file, a directory or a missing file is a problem. *text is freed by
/// the caller. Pipes and devices are read like files.
whirl_status source_load(const char *path, whirl_problems *problems, char **text, size_t *length);

/// Reports what is no text: too many bytes, bytes that are not UTF-8, control characters, tabs that indent.
void source_check(const char *text, size_t length, whirl_problems *problems);

/// Bytes of the UTF-8 character at `text`, or 0 where there is none (overlong forms and surrogates included).
size_t utf8_length(const unsigned char *text, size_t left);

#endif
