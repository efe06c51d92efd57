/// The lines of a file that problems are about.
#ifndef CASE_EXCERPT_H
#define CASE_EXCERPT_H

#include "whirl/engine/case.h"

#include <stddef.h>

/// Adds excerpts to all problems, in the order of problems_sort, from the text of the file.
void problems_quote(whirl_problems *problems, const char *text, size_t length);

#endif
