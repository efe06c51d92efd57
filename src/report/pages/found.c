// Writes findings as sentences: those of all tables with their judgements, and those of one table.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "findings_render.h"
#include "found.h"
#include "html.h"
#include "page.h"
#include "page_findings.h"
#include "quantities.h"
#include "summary.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"

size_t found_each(const page *to, choose_table *chosen, const void *by, each_table *act, void *context) {
    size_t count = 0;
    for (size_t r = 0; r < to->count; r++)
        for (size_t t = 0; t < to->results[r]->table_count; t++) {
            const whirl_table *table = &to->results[r]->tables[t];
            if (table->count == 0 || !chosen(table, by)) continue;
            if (act) act(to, r, table, context);
            count++;
        }
    return count;
}

// ---------------------------------------------------------------- all tables

/// Writes the criteria with a judgement, and their tables: "; fails: separation margin (unbalance), stability, Level II
/// (stability)".
static void list_judged(const page *to, whirl_judgement judgement) {
    size_t count = 0;
    for (size_t r = 0; r < to->count; r++)
        for (size_t i = 0; i < to->findings[r]->statement_count; i++) {
            const whirl_statement *own = &to->findings[r]->statements[i];
            if (!*own->clause || own->judgement != judgement) continue;
            if (count == 0) html_printf(to->stream, "; %s: ", whirl_judgement_name(judgement));
            html_printf(to->stream, "%s%s (%s)", count++ ? ", " : "", own->what, own->table);
        }
}

/// Writes the number of acceptance criteria that hold, and names the criteria that fail; `lacks`: why there may be
/// none.
static void write_judgements(const page *to, const char *lacks) {
    size_t all = 0, held = 0;
    for (size_t r = 0; r < to->count; r++)
        for (size_t i = 0; i < to->findings[r]->statement_count; i++) {
            const whirl_statement *own = &to->findings[r]->statements[i];
            all += *own->clause && own->judgement != WHIRL_NOT_ASKED;
            held += *own->clause && own->judgement == WHIRL_HOLDS;
        }
    fputs("<li><strong>What is asked for.</strong> ", to->stream);
    if (all == 0)
        fprintf(to->stream, "Nothing: %s", lacks);
    else
        fprintf(to->stream, "%zu of %zu hold", held, all);
    list_judged(to, WHIRL_FAILS);
    list_judged(to, WHIRL_NOT_KNOWN);
    fputs(all > 0 ? ". See the table below.</li>\n" : ".</li>\n", to->stream);
}

void found_statements(const page *to, const char *lacks) {
    for (size_t r = 0; r < to->count; r++)
        for (size_t i = 0; i < to->findings[r]->statement_count; i++) {
            const whirl_statement *own = &to->findings[r]->statements[i];
            char text[STATEMENT_SIZE];
            if (!*own->table || *own->clause || own->at.count > 0) continue;
            statement_text(own, text, sizeof text);
            plus_minus(text);
            fputs("<li><strong>", to->stream);
            html_text(to->stream, own->table);
            fputs(".</strong> ", to->stream);
            html_text(to->stream, text);
            fputs(".</li>\n", to->stream);
        }
    write_judgements(to, lacks);
}

// ---------------------------------------------------------------- a table

static void write_heading(const page *to, size_t index, const whirl_table *table) {
    (void)index;
    summarize_heading(to->stream, table);
}

void found_table(const page *to, size_t index, const whirl_table *table) {
    // Begin the item with the heading of the summary, without its colon.
    char *heading = page_text(to, write_heading, index, table);
    if (!heading) return;
    heading[strcspn(heading, "\n")] = '\0';
    const size_t length = strlen(heading);
    if (length > 0 && heading[length - 1] == ':') heading[length - 1] = '\0';
    fputs("<li><strong>", to->stream);
    html_text(to->stream, heading);
    fputs(".</strong> ", to->stream);
    free(heading);
    // Write the statements.
    if (page_statements(to, index, table) == 0) fputs("See its tables.", to->stream);
    fputs("</li>\n", to->stream);
}
