// Writes statements and sheets into the page.
#include <stdlib.h>
#include <string.h>

#include "findings_render.h"
#include "html.h"
#include "page.h"
#include "page_findings.h"
#include "quantities.h"

enum { CELL_SIZE = 1024, MAX_ROWS = 80 };

/// Returns the name of a table in findings; "" for findings about the whole machine.
static const char *name_of(const whirl_table *table) {
    return table ? table->name : "";
}

size_t page_statements(const page *to, size_t result, const whirl_table *table) {
    const whirl_findings *findings = to->findings[result];
    size_t count = 0;
    for (size_t i = 0; i < findings->statement_count; i++) {
        char text[STATEMENT_SIZE];
        if (strcmp(findings->statements[i].table, name_of(table)) != 0) continue;
        statement_text(&findings->statements[i], text, sizeof text);
        plus_minus(text);
        fputs(count++ ? "<li>" : "<ul class=\"notes\">\n<li>", to->stream);
        html_text(to->stream, text);
        fputs("</li>\n", to->stream);
    }
    if (count > 0) fputs("</ul>\n", to->stream);
    return count;
}

/// Returns the class of a cell: numbers are aligned right, long texts get a wide column, and the name of a regime stays
/// next to its colour.
static const char *cell_class(const whirl_column *column, const whirl_cell *cell, const char *text) {
    enum { LONG = 28 };
    if (column->digits > 0 && !column->between) return " class=\"number\"";
    return strlen(text) > LONG ? " class=\"wide\"" : cell && cell->colour ? " class=\"whole\"" : "";
}

static void write_row(FILE *stream, const whirl_sheet *sheet, size_t row) {
    char text[CELL_SIZE];
    fputs("<tr>", stream);
    for (size_t c = 0, shown = 0; c < sheet->columns; c++) {
        const whirl_column *column = &sheet->column[c];
        const bool head = row == 0 || shown == 0;
        if (sheet_column_empty(sheet, c)) continue;
        const whirl_cell *cell = row > 0 ? &sheet->cells[(row - 1) * sheet->columns + c] : NULL;
        *text = '\0';
        if (cell) whirl_cell_text(column, cell, text, sizeof text);
        plus_minus(text);
        fprintf(stream, "<%s%s", head ? "th" : "td", cell_class(column, cell, text));
        if (!cell && column->meaning) {
            fputs(" title=\"", stream);
            html_text(stream, column->meaning);
            fputc('"', stream);
        }
        fputc('>', stream);
        if (cell && cell->colour)
            fprintf(stream, "<span class=\"swatch\" style=\"background:%s\"></span>", cell->colour);
        html_text(stream, cell ? text : column->heading);
        if (row == 0 && *column->unit) {
            fputs(" <span class=\"whole\">(", stream);
            html_text(stream, column->unit);
            fputs(")</span>", stream);
        }
        fprintf(stream, "</%s>", head ? "th" : "td");
        shown++;
    }
    fputs("</tr>\n", stream);
}

/// Writes a sheet; of many points only every n-th. On paper nothing is folded.
static void write_sheet(const page *to, const whirl_sheet *sheet) {
    const size_t step = sheet->of_points ? 1 + (sheet->rows - 1) / MAX_ROWS : 1;
    const bool folded = sheet->looked_up && !to->printed;
    fputs(folded ? "<details><summary>" : "<h4>", to->stream);
    html_text(to->stream, sheet->title);
    fputs(folded ? "</summary>\n" : "</h4>\n", to->stream);
    if (*sheet->about) {
        fputs("<p>", to->stream);
        html_text(to->stream, sheet->about);
        fputs("</p>\n", to->stream);
    }
    html_table(to->stream, sheet->title, "");
    fputs("<thead>", to->stream);
    write_row(to->stream, sheet, 0);
    fputs("</thead>\n<tbody>\n", to->stream);
    for (size_t row = 1; row <= sheet->rows; row += step) write_row(to->stream, sheet, row);
    fputs("</tbody></table></div>\n", to->stream);
    if (step > 1)
        fprintf(to->stream, "<p class=\"soft small\">One of %zu points; the others are in the result.</p>\n", step);
    if (folded) fputs("</details>\n", to->stream);
}

void page_sheets(const page *to, size_t result, const whirl_table *table) {
    const whirl_findings *findings = to->findings[result];
    for (size_t i = 0; i < findings->sheet_count; i++)
        if (strcmp(findings->sheets[i].table, name_of(table)) == 0) write_sheet(to, &findings->sheets[i]);
}

// ---------------------------------------------------------------- acceptance criteria

static void write_phrase(const page *to, const whirl_phrase *phrase) {
    char text[STATEMENT_SIZE];
    whirl_phrase_text(phrase, text, sizeof text);
    fputs("<td class=\"wide\">", to->stream);
    html_text(to->stream, text);
    fputs("</td>", to->stream);
}

void page_asked(const page *to) {
    size_t count = 0;
    // Write a row for each statement with a clause; the first begins the table.
    for (size_t r = 0; r < to->count; r++)
        for (size_t i = 0; i < to->findings[r]->statement_count; i++) {
            const whirl_statement *own = &to->findings[r]->statements[i];
            if (!*own->clause) continue;
            if (count++ == 0) {
                html_table(to->stream, "What is asked for", "");
                fputs("<thead><tr><th>of</th><th>what</th><th>asked for</th><th>found, at its worst</th>"
                      "<th>verdict</th><th>clause</th></tr></thead>\n<tbody>\n",
                      to->stream);
            }
            fputs("<tr><th>", to->stream);
            html_text(to->stream, own->table);
            fputs("</th><td>", to->stream);
            html_text(to->stream, own->what);
            fputs("</td>", to->stream);
            write_phrase(to, &own->asked);
            write_phrase(to, &own->found);
            write_phrase(to, &own->judged);
            fprintf(to->stream, "<td class=\"whole\">%s</td></tr>\n", own->clause);
        }
    // End the table with the source of its clauses.
    if (count == 0) return;
    fputs("</tbody></table></div>\n<p class=\"soft small\">Clauses are those of API RP 684, 2nd edition of 2005; "
          "API 617 has 2.6 (7th edition, 2002) or 4.8 (8th, 2014, part 1) in place of SP6.8. Which standard "
          "and edition counts, and what it asks for, is for the user to check.</p>\n",
          to->stream);
}

// ---------------------------------------------------------------- texts

char *page_text(const page *to, page_part *write, size_t result, const whirl_table *table) {
    char *text = NULL;
    size_t size = 0;
    page own = *to;
    own.stream = open_memstream(&text, &size);
    if (own.stream) write(&own, result, table);
    if (own.stream && fclose(own.stream) == 0) return text;
    if (own.stream) free(text);
    *to->failed = true;
    return NULL;
}
