#include "page.h"
#include "html.h"
#include "page_findings.h"

#include <string.h>

#include "quantities.h"
#include "shown_kinds.h"
#include "whirl/version.h"

/// Writes the title of the page: the source of the claims, or the title of the only result, or the number of results.
static void page_title(const page *to, char *title, size_t size) {
    if (to->claims && *to->claims->source)
        snprintf(title, size, "%s", to->claims->source);
    else if (to->count == 1 && *to->results[0]->title)
        snprintf(title, size, "%s", to->results[0]->title);
    else
        snprintf(title, size, "Report on %zu result%s", to->count, to->count == 1 ? "" : "s");
}

void page_head(const page *to, const char *title) {
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
          "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' file: data:; "
          "style-src 'unsafe-inline'\">\n<title>",
          to->stream);
    html_text(to->stream, title);
    fputs("</title>\n", to->stream);
    page_style(to->stream);
    fputs("</head>\n<body>\n<header>\n<h1>", to->stream);
    html_text(to->stream, title);
    fputs("</h1>\n", to->stream);
}

void page_document(const page *to) {
    static const char *const lines[][2] = {{"Machine", "document tag"},     {"Customer", "document customer"},
                                           {"Project", "document project"}, {"Revision", "document revision"},
                                           {"Author", "document author"},   {"Date", "document date"}};
    size_t count = 0;
    for (size_t i = 0; i < sizeof lines / sizeof *lines && to->count > 0; i++) {
        const char *fact = whirl_result_fact(to->results[0], lines[i][1]);
        if (!*fact) continue;
        if (count++ == 0) fputs("<dl class=\"document\">\n", to->stream);
        fprintf(to->stream, "<dt>%s</dt><dd>", lines[i][0]);
        html_text(to->stream, fact);
        fputs("</dd>\n", to->stream);
    }
    if (count > 0) fputs("</dl>\n", to->stream);
}

static void write_head(const page *to) {
    char title[512];
    page_title(to, title, sizeof title);
    page_head(to, title);
    page_document(to);
    fputs("<p class=\"soft\">", to->stream);
    html_printf(to->stream, "%zu result%s, %swritten by whirl %s.", to->count, to->count == 1 ? "" : "s",
                to->claims ? "compared with claims, " : "", WHIRL_VERSION);
    fputs("</p>\n</header>\n", to->stream);
}

/// Writes a line of the contents.
static void write_entry(FILE *stream, const char *anchor, size_t number, const char *text) {
    fprintf(stream, "<li><a href=\"#%s-%zu\">", anchor, number);
    html_text(stream, text);
    fputs("</a></li>\n", stream);
}

static bool has_figures(const page *to, size_t result, bool diagrams) {
    bool found = false;
    for (size_t i = 0; i < to->figures->count; i++)
        found = found || (to->figures->items[i].result == result && !to->figures->items[i].whole &&
                          &to->figures->items[i] != page_main_figure(to, result) &&
                          (to->figures->items[i].name.point < 0) == diagrams);
    return found;
}

/// Returns the kind of a table that has a section of its own, else NULL: a table at rest over two parameters has only a
/// figure, and motions may have no sheet.
static const shown_kind *section_of(const page *to, size_t r, const whirl_table *table) {
    const shown_kind *kind = shown_kind_of(table);
    if (kind != &shown_motions) return *table->second ? NULL : kind;
    for (size_t i = 0; i < to->findings[r]->sheet_count; i++)
        if (strcmp(to->findings[r]->sheets[i].table, table->name) == 0) return kind;
    return NULL;
}

/// Writes the heading of a table's section, "Peaks of the response", with the table's own name if there are several,
/// and its anchor.
static void name_section(const page *to, size_t r, const whirl_table *table, char *name, char *anchor, size_t size) {
    const shown_kind *kind = section_of(to, r, table);
    size_t alike = 0;
    bool first = true;
    for (const whirl_table *other = to->results[r]->tables;
         other < to->results[r]->tables + to->results[r]->table_count; other++) {
        const bool same = section_of(to, r, other) == kind;
        alike += same;
        first = first && !(same && other < table);
    }
    snprintf(name, size, alike > 1 ? "%s: %s" : "%s", kind->name, table->name);
    snprintf(anchor, size, first ? "%s" : "%s-%s", kind->anchor, table->name);
}

static void write_kinds(const page *to, size_t r) {
    for (size_t t = 0; t < to->results[r]->table_count; t++) {
        const whirl_table *table = &to->results[r]->tables[t];
        char name[256], anchor[256];
        const shown_kind *kind = section_of(to, r, table);
        if (!kind) continue;
        name_section(to, r, table, name, anchor, sizeof name);
        fprintf(to->stream, "<h3 id=\"%s-%zu\">%s</h3>\n", anchor, r + 1, name);
        if (strcmp(anchor, kind->anchor) == 0 && kind->about) {
            fputs("<p>", to->stream);
            html_text(to->stream, kind->about);
            fputs("</p>\n", to->stream);
        }
        page_sheets(to, r, table);
    }
}

static void write_result_contents(const page *to, size_t r) {
    // Link to the result.
    const whirl_result *result = to->results[r];
    fprintf(to->stream, "<li><a href=\"#result-%zu\">", r + 1);
    html_text(to->stream, to->names[r]);
    fputs("</a>\n<ul>\n", to->stream);
    // Link to its figures.
    if (has_figures(to, r, true)) write_entry(to->stream, "diagrams", r + 1, page_diagrams_title(result));
    if (has_figures(to, r, false)) write_entry(to->stream, "motions", r + 1, "Single points");
    // Link to the sections of its tables.
    for (size_t t = 0; t < result->table_count; t++) {
        char name[256], anchor[256];
        if (!section_of(to, r, &result->tables[t])) continue;
        name_section(to, r, &result->tables[t], name, anchor, sizeof name);
        write_entry(to->stream, anchor, r + 1, name);
    }
    // Link to options and provenance.
    write_entry(to->stream, "computed", r + 1, "What was computed");
    if (result->fact_count > 0) write_entry(to->stream, "provenance", r + 1, "Provenance");
    fputs("</ul></li>\n", to->stream);
}

static void write_contents(const page *to) {
    fputs("<nav aria-label=\"Contents\"><ul>\n", to->stream);
    if (to->explorer) fputs("<li><a href=\"explorer.html\">Explorer: touch the diagrams</a></li>\n", to->stream);
    if (to->claims) fputs("<li><a href=\"#claims\">Claims</a></li>\n", to->stream);
    for (size_t r = 0; r < to->count; r++) write_result_contents(to, r);
    fputs("</ul></nav>\n", to->stream);
}

/// Writes weight, shafts, stations and parts in a section that is folded at first, as it is only looked up.
static void page_parts(const page *to, size_t result) {
    bool any = false;
    for (size_t i = 0; i < to->findings[result]->sheet_count; i++) any = any || !*to->findings[result]->sheets[i].table;
    if (!any) return;
    fputs("<details><summary>Weight, shafts, stations and parts of the machine</summary>\n", to->stream);
    page_statements(to, result, NULL);
    page_sheets(to, result, NULL);
    fputs("</details>\n", to->stream);
}

static void write_result(const page *to, size_t result) {
    fprintf(to->stream, "<section id=\"result-%zu\">\n<h2>", result + 1);
    // Write the heading. The title of an only result is the title of the page, so its heading is another one.
    const char *title = *to->results[result]->title ? to->results[result]->title : to->names[result];
    html_text(to->stream, to->count == 1 && !to->claims ? "What was found" : title);
    fputs(" <span class=\"soft small\">", to->stream);
    html_text(to->stream, to->names[result]);
    fputs("</span></h2>\n", to->stream);
    // Write the sections.
    page_machine(to, result);
    page_parts(to, result);
    page_found(to, result);
    page_figures(to, result);
    write_kinds(to, result);
    page_computed(to, result);
    page_provenance(to, result);
    fputs("</section>\n", to->stream);
}

void page_write(const page *to) {
    write_head(to);
    write_contents(to);
    fputs("<main>\n", to->stream);
    if (to->claims) page_claims(to);
    for (size_t r = 0; r < to->count; r++) write_result(to, r);
    fputs("</main>\n</body>\n</html>\n", to->stream);
}
