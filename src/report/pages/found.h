/// What was found, in sentences, each an item of a list.
#ifndef REPORT_FOUND_H
#define REPORT_FOUND_H

#include "page.h"

/// Results of a page.
typedef struct found_part {
    size_t first, end; ///< [first, end)
    bool all;          ///< what was not looked for is told, too
} found_part;

/// What is done with a table.
typedef void each_table(const page *to, size_t result, const whirl_table *table, void *context);

/// Does it (NULL: nothing) with every table that has points and the field; how many have.
size_t found_each(const page *to, found_part part, const char *field, each_table *act, void *context);

/// Critical speeds with damping, margins, clearances, stability.
void found_at_rest(const page *to, found_part part);

/// Of a table what the summary says: kinds of motion with their ranges, trust, doubts, attractors, jumps.
void found_table(const page *to, size_t result, const whirl_table *table);

#endif
