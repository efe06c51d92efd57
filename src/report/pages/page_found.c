// What was found, first, and the figure that shows it.
#include <string.h>

#include "found.h"
#include "shown_kinds.h"

/// Whether sentences tell of a table: not of points that a sweep beside them tells of, nor of kinds at rest that have
/// sentences of their own for all of their tables.
static bool is_told(const whirl_result *result, const whirl_table *table) {
    const shown_kind *kind = shown_kind_of(table);
    if (table->count == 0 || (kind && kind->found && kind->found(table))) return false;
    return strcmp(table->name, "detail") != 0 || result->table_count == 1;
}

static void write_tables(const page *to, size_t index, bool at_rest) {
    const whirl_result *result = to->results[index];
    for (const whirl_table *table = result->tables; table < result->tables + result->table_count; table++) {
        const whirl_kind *kind = whirl_analysis_kind(table->analyses);
        if (is_told(result, table) && at_rest == !(kind->moves || kind->found)) found_table(to, index, table);
    }
}

void page_found(const page *to, size_t index) {
    fputs("<ul class=\"found\">\n", to->stream);
    write_tables(to, index, false);
    found_at_rest(to, (found_part){index, index + 1, false});
    write_tables(to, index, true);
    fputs("</ul>\n", to->stream);
    const drawn_figure *main = page_main_figure(to, index);
    if (main) page_figure(to, main);
}
