// Writes the findings that come first on a page, with the main figure.

#include "found.h"
#include "page.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/result.h"

/// Returns true if sentences describe a table. A study that found no branch or torus has a statement about that.
static bool is_covered(const whirl_table *table) {
    return table->count > 0 || shown_kind_of(table) != &shown_motions;
}

static void write_tables(const page *to, size_t index, bool at_rest) {
    const whirl_result *result = to->results[index];
    for (const whirl_table *table = result->tables; table < result->tables + result->table_count; table++) {
        const whirl_kind *kind = whirl_analysis_kind(table->analyses);
        if (is_covered(table) && at_rest == !(kind->moves || kind->found)) found_table(to, index, table);
    }
}

void page_found(const page *to, size_t index) {
    fputs("<ul class=\"found\">\n", to->stream);
    write_tables(to, index, false);
    write_tables(to, index, true);
    fputs("</ul>\n", to->stream);
    const drawn_figure *main = page_main_figure(to, index);
    if (main) page_figure(to, main);
}
