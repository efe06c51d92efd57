// What functions write, as texts for programs in other languages.
#ifndef REPORT_WRITTEN_H
#define REPORT_WRITTEN_H

#include <stdio.h>

#include "whirl/status.h"

/// Writes `of`.
typedef whirl_status write_function(const void *of, FILE *stream);

/// What it writes, to be freed by whirl_text_free; *text is NULL after a failure, of memory with "no memory " and
/// `purpose`.
whirl_status text_written(write_function *write, const void *of, const char *purpose, char **text);

#endif
