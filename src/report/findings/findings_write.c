// Writes findings in every form: a sheet, the findings of a table, or those of a result, also as texts for programs in
// other languages.
#include <stdint.h>
#include <string.h>

#include "findings_build.h"
#include "findings_render.h"
#include "text_written.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/handles.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

whirl_status whirl_sheet_form_of(const char *name, whirl_sheet_form *form) {
    static const char *const names[] = {"text", "csv", "latex", "markdown", "json"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strcmp(name, names[i]) != 0) continue;
        *form = (whirl_sheet_form)i;
        return whirl_ok();
    }
    return whirl_fail(WHIRL_BAD_INPUT, "the format is '%.40s', expected text, csv, latex, markdown or json", name);
}

whirl_status whirl_sheet_write(const whirl_sheet *sheet, whirl_sheet_form form, FILE *stream) {
    if (form == WHIRL_SHEET_JSON) return sheet_write_json(sheet, stream);
    if (form == WHIRL_SHEET_TEXT && !sheet_write_text(stream, sheet, sheet->rows + 1))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the sheet %.80s", sheet->name);
    if (form == WHIRL_SHEET_CSV) sheet_write_csv(stream, sheet);
    if (form == WHIRL_SHEET_LATEX) sheet_write_latex(stream, sheet);
    if (form == WHIRL_SHEET_MARKDOWN) sheet_write_markdown(stream, sheet);
    return whirl_ok();
}

bool findings_write_table(FILE *stream, const whirl_findings *findings, const char *table, size_t points, size_t rows) {
    const bool summary = rows < SIZE_MAX;
    bool well = true;
    for (size_t i = 0; i < findings->statement_count; i++)
        if (strcmp(findings->statements[i].table, table) == 0) {
            char text[STATEMENT_SIZE];
            statement_text(&findings->statements[i], text, sizeof text);
            fprintf(stream, "  %s\n", text);
        }
    for (size_t i = 0; i < findings->sheet_count && well; i++) {
        const whirl_sheet *sheet = &findings->sheets[i];
        if (strcmp(sheet->table, table) == 0 && !(summary && (sheet->looked_up || sheet->unsummarized)))
            well = sheet_write_text(stream, sheet, sheet->of_points ? points : rows);
    }
    return well;
}

/// Largest number of statements of the same kind that text shows; other forms have all.
enum { MAX_ALIKE = 20 };

/// Returns the number of statements before `end` with the same `what`.
static size_t statements_alike(const whirl_findings *findings, size_t end, const char *what) {
    size_t count = 0;
    for (size_t i = 0; i < end; i++) count += strcmp(findings->statements[i].what, what) == 0;
    return count;
}

whirl_status whirl_findings_write_text(const whirl_findings *findings, FILE *stream) {
    char text[STATEMENT_SIZE];
    bool well = true;
    for (size_t i = 0; i < findings->statement_count; i++) {
        const whirl_statement *own = &findings->statements[i];
        const size_t before = statements_alike(findings, i, own->what);
        const size_t all = before == MAX_ALIKE ? statements_alike(findings, findings->statement_count, own->what) : 0;
        if (before == MAX_ALIKE) fprintf(stream, "  %s: %zu more, which JSON has\n", own->what, all - before);
        if (before >= MAX_ALIKE) continue;
        statement_text(own, text, sizeof text);
        fprintf(stream, "  %s\n", text);
    }
    for (size_t i = 0; i < findings->sheet_count && well; i++)
        well = sheet_write_text(stream, &findings->sheets[i], SIZE_MAX);
    return well ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for what was found");
}

// ---------------------------------------------------------------- all of a result

/// Selection to write: a sheet, or all findings of a result.
typedef struct findings_asked {
    const whirl_result *result;
    const whirl_findings *findings;
    const whirl_sheet *sheet; ///< NULL: all
    whirl_sheet_form form;
} findings_asked;

static bool findings_has(const whirl_findings *findings, const char *table) {
    for (size_t i = 0; i < findings->statement_count; i++)
        if (strcmp(findings->statements[i].table, table) == 0) return true;
    for (size_t i = 0; i < findings->sheet_count; i++)
        if (strcmp(findings->sheets[i].table, table) == 0) return true;
    return false;
}

/// Writes the findings of each table below its name.
static whirl_status findings_write_tables(const findings_asked *asked, FILE *stream) {
    if (findings_has(asked->findings, "")) {
        fputs("machine:\n", stream);
        if (!findings_write_table(stream, asked->findings, "", SIZE_MAX, SIZE_MAX))
            return whirl_fail(WHIRL_NO_MEMORY, "no memory for what was found");
    }
    for (size_t t = 0; t < asked->result->table_count; t++) {
        const char *const table = asked->result->tables[t].name;
        if (!findings_has(asked->findings, table)) continue;
        fprintf(stream, "%s:\n", table);
        if (!findings_write_table(stream, asked->findings, table, SIZE_MAX, SIZE_MAX))
            return whirl_fail(WHIRL_NO_MEMORY, "no memory for what was found");
    }
    return whirl_ok();
}

static whirl_status findings_write_asked(const void *of, FILE *stream) {
    const findings_asked *const asked = of;
    if (asked->sheet) return whirl_sheet_write(asked->sheet, asked->form, stream);
    if (asked->form == WHIRL_SHEET_TEXT) return findings_write_tables(asked, stream);
    return whirl_findings_write_json(asked->findings, stream);
}

static whirl_status findings_write_names(const void *of, FILE *stream) {
    const whirl_findings *const findings = of;
    char name[2 * WHIRL_NAME_SIZE];
    for (size_t i = 0; i < findings->sheet_count; i++) {
        whirl_sheet_name(findings, &findings->sheets[i], name, sizeof name);
        fprintf(stream, "%s\t%s\n", name, findings->sheets[i].title);
    }
    return whirl_ok();
}

whirl_status whirl_result_findings(const whirl_result *result, const char *sheet, const char *units, const char *format,
                                   char **text) {
    whirl_findings *findings;
    findings_asked asked = {.result = result};
    *text = NULL;
    whirl_status status = whirl_sheet_form_of(format, &asked.form);
    if (status.code != WHIRL_OK) return status;
    if (!sheet && asked.form != WHIRL_SHEET_TEXT && asked.form != WHIRL_SHEET_JSON)
        return whirl_fail(WHIRL_BAD_INPUT, "a file of format %.40s holds one sheet, expected the name of one", format);
    const char *const spread = sheet ? findings_asked_spread(sheet) : NULL;
    status =
        spread ? findings_of_spread(result, units, sheet, &findings) : whirl_findings_new(result, units, &findings);
    if (status.code != WHIRL_OK) return status;
    asked.findings = findings;
    if (sheet) status = whirl_findings_sheet(findings, spread ? spread : sheet, &asked.sheet);
    if (status.code == WHIRL_OK) status = text_written(findings_write_asked, &asked, "for what was found", text);
    whirl_findings_free(findings);
    return status;
}

whirl_status whirl_result_sheets(const whirl_result *result, const char *units, char **lines) {
    whirl_findings *findings;
    *lines = NULL;
    whirl_status status = whirl_findings_new(result, units, &findings);
    if (status.code != WHIRL_OK) return status;
    status = text_written(findings_write_names, findings, "for the names of sheets", lines);
    whirl_findings_free(findings);
    return status;
}

static whirl_status findings_write_warnings(const void *of, FILE *stream) {
    const whirl_shown_units *const units = of;
    char said[SENTENCE_SIZE];
    for (size_t i = 0; *whirl_result_warning(units->result, i); i++) {
        whirl_shown_sentence(units, whirl_result_warning(units->result, i), said, sizeof said);
        fprintf(stream, "%s\n", said);
    }
    return whirl_ok();
}

whirl_status whirl_result_warnings(const whirl_result *result, const char *units, char **lines) {
    whirl_shown_units shown;
    *lines = NULL;
    const whirl_status status = whirl_result_shown_units(result, units, &shown);
    return status.code == WHIRL_OK ? text_written(findings_write_warnings, &shown, "for warnings", lines) : status;
}
