// What was found, first, and the figure that shows it.
#include <string.h>

#include "found.h"
#include "shown_kinds.h"

/// Whether sentences tell of a table: not of points that a sweep beside them tells of, nor of kinds at rest that have
/// sentences of their own for all of their tables.
static bool is_told(const whirl_result *result, const whirl_table *table) {
    const shown_kind *kind = shown_kind_of(table);
    if (table->count == 0 || (kind && kind->found)) return false;
    return strcmp(table->name, "detail") != 0 || result->table_count == 1;
}

void page_found(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    fputs("<ul class=\"found\">\n", to->stream);
    for (size_t t = 0; t < result->table_count; t++)
        if (is_told(result, &result->tables[t])) found_table(to, index, &result->tables[t]);
    found_at_rest(to, (found_part){index, index + 1, false});
    fputs("</ul>\n", to->stream);
    const drawn_figure *main = page_main_figure(to, index);
    if (main) page_figure(to, main);
}
