/// Collects what a function writes to a stream in a text in memory, for programs in other languages.
#ifndef REPORT_TEXT_WRITTEN_H
#define REPORT_TEXT_WRITTEN_H

#include <stdio.h>

#include "whirl/status.h"

/// Writes `of` to a stream.
typedef whirl_status write_function(const void *of, FILE *stream);

/// Calls `write` and makes *text of what it wrote; free it with whirl_text_free. On failure *text is NULL; without
/// memory the message is "no memory " and `purpose`.
whirl_status text_written(write_function *write, const void *of, const char *purpose, char **text);

#endif
