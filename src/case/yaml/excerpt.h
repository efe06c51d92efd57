/// Excerpts: the lines of a file with problems, as shown next to the messages.
#ifndef CASE_EXCERPT_H
#define CASE_EXCERPT_H

#include "whirl/engine/case.h"

#include <stddef.h>

/// Adds excerpts to all problems, in the order of problems_sort, from the text of the file.
void problems_quote(whirl_problems *problems, const char *text, size_t length);

#endif
