/// Writes statements and sheets.
#ifndef REPORT_PAGE_FINDINGS_H
#define REPORT_PAGE_FINDINGS_H

#include "page.h"
#include "whirl/engine/result.h"

/// Writes all statements of a table, or (NULL) of the whole machine, as items of a list, a sentence each. Returns their
/// number.
size_t page_statements(const page *to, size_t result, const whirl_table *table);

/// Writes all sheets of a table, or (NULL) of the whole machine.
void page_sheets(const page *to, size_t result, const whirl_table *table);

/// Writes the acceptance criteria of all results: criterion, required, found, verdict, clause.
void page_asked(const page *to);

/// Writes a part of a page as a text, which the caller frees. Without memory it returns NULL and sets page.failed.
typedef void page_part(const page *to, size_t result, const whirl_table *table);
char *page_text(const page *to, page_part *write, size_t result, const whirl_table *table);

#endif
