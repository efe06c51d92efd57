// The table of what is asked of a lateral analysis beside what was found, with the clause.
#include <stdio.h>

#include "page.h"
#include "shown_kinds.h"

static void write_row(const page *to, const whirl_table *table, const asked_row *row) {
    const char *const cells[] = {row->what, row->asked, row->found, row->told};
    fputs("<tr><th>", to->stream);
    html_text(to->stream, table->name);
    fputs("</th>", to->stream);
    for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) {
        fputs("<td>", to->stream);
        html_text(to->stream, cells[i]);
        fputs("</td>", to->stream);
    }
    fprintf(to->stream, "<td class=\"whole\">SP6.8.%s</td></tr>\n", row->clause);
}

static void write_rows(const page *to, size_t result, const whirl_table *table, void *context) {
    const asked_rows all = asked_of(&to->units[result], table);
    (void)context;
    for (size_t i = 0; i < all.count; i++) write_row(to, table, &all.rows[i]);
}

void page_asked(const page *to) {
    const found_part all = {0, to->count, true};
    if (found_each(to, all, WHIRL_FIELD_UNBALANCE_PROBE, NULL, NULL) +
            found_each(to, all, WHIRL_FIELD_STABILITY_COMPLETE, NULL, NULL) ==
        0)
        return;
    html_table(to->stream, "What is asked for", "");
    fputs("<thead><tr><th>of</th><th>what</th><th>asked for</th><th>found, at its least</th><th>verdict</th>"
          "<th>clause</th></tr></thead>\n<tbody>\n",
          to->stream);
    found_each(to, all, WHIRL_FIELD_UNBALANCE_PROBE, write_rows, NULL);
    found_each(to, all, WHIRL_FIELD_STABILITY_COMPLETE, write_rows, NULL);
    fputs("</tbody></table></div>\n<p class=\"soft small\">Clauses are those of API RP 684, 2nd edition of 2005; in "
          "API 617 "
          "2.6 (7th edition, 2002) or 4.8 (8th, 2014, part 1) stands in the place of SP6.8. Which standard and edition "
          "counts, and what it asks for, is for the user to check.</p>\n",
          to->stream);
}
