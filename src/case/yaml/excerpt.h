/// The lines of a file that problems are about.
#ifndef CASE_EXCERPT_H
#define CASE_EXCERPT_H

#include <stddef.h>

#include "whirl/engine/case.h"

/// Gives every problem, in the order of problems_sort, what stands at its place in the text of the file.
void problems_quote(whirl_problems *problems, const char *text, size_t length);

#endif
