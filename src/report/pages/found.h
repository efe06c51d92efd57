/// Writes findings as sentences, each an item of a list.
#ifndef REPORT_FOUND_H
#define REPORT_FOUND_H

#include "page.h"
#include "whirl/engine/result.h"

/// Function applied to a table.
typedef void each_table(const page *to, size_t result, const whirl_table *table, void *context);

/// Returns true for a table that is chosen; `by`: data of the function.
typedef bool choose_table(const whirl_table *table, const void *by);

/// Applies `act` (NULL: nothing) to all tables of all results that have points and are chosen by `chosen` with `by`.
/// Returns the number of tables.
size_t found_each(const page *to, choose_table *chosen, const void *by, each_table *act, void *context);

/// Writes the statements of all tables, and the number of criteria that hold; `lacks`: why there may be none.
void found_statements(const page *to, const char *lacks);

/// Writes the statements of a table below its heading.
void found_table(const page *to, size_t result, const whirl_table *table);

#endif
