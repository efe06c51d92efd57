/// What a function writes to a stream, as a text in memory, for programs in other languages.
#ifndef REPORT_TEXT_WRITTEN_H
#define REPORT_TEXT_WRITTEN_H

#include <stdio.h>

#include "whirl/status.h"

/// Writes `of`.
typedef whirl_status write_function(const void *of, FILE *stream);

/// Writes into a text, to be freed by whirl_text_free. On failure *text is NULL; out of memory the message is "no
/// memory " and `purpose`.
whirl_status text_written(write_function *write, const void *of, const char *purpose, char **text);

#endif
