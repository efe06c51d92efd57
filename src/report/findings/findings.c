// Makes all findings of a result, and finds a sheet by its name.
#include "whirl/internal/findings.h"

#include <stdlib.h>
#include <string.h>

#include "exhausted.h"
#include "findings_build.h"
#include "findings_render.h"
#include "machine_at.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

// ---------------------------------------------------------------- all of a result

static void find_table(const finder *of) {
    const shown_kind *kind = shown_kind_of(of->table);
    if (of->table->count > 0 || whirl_analysis_kind(of->table->analyses)->found || kind == &shown_motions)
        kind->find(of);
    find_ranges(of);
    find_derivatives(of);
}

whirl_status findings_of(const whirl_result *view, const whirl_shown_units *units, const whirl_case *machine,
                         whirl_findings **findings) {
    static const whirl_table whole = {.name = ""};
    const int before = exhausted_watch();
    whirl_findings *all = find_begin();
    if (all) find_machine(&(finder){all, units, view, &whole, machine});
    for (size_t t = 0; all && t < view->table_count; t++)
        find_table(&(finder){all, units, view, &view->tables[t], machine});
    // Functions that search peaks, scales and lines of modes return no status: without memory they find nothing. So a
    // lack of memory is detected here.
    if (all && exhausted(before)) all->failed = true;
    return find_made(all, findings);
}

whirl_status whirl_findings_new(const whirl_result *result, const char *units, whirl_findings **findings) {
    whirl_shown_units shown;
    whirl_result *view;
    whirl_case *machine = NULL;
    *findings = NULL;
    whirl_status status = whirl_result_by_attractor(result, &view);
    if (status.code != WHIRL_OK) return status;
    status = whirl_result_shown_units(view, units, &shown);
    if (status.code == WHIRL_OK) status = machine_of(view, &machine);
    if (status.code == WHIRL_OK) status = findings_of(view, &shown, machine, findings);
    whirl_case_free(machine);
    whirl_result_view_free(view);
    return status;
}

/// Makes the findings on the spread of a number that a sheet's name requests: "spread:FIELD column C at STATION", with
/// "TABLE/" before it if several tables have samples.
static whirl_status find_asked_spread(const whirl_result *view, const whirl_shown_units *units, const char *name,
                                      whirl_findings **findings) {
    const char *of = strchr(name, ':') + 1, *slash = memchr(name, '/', (size_t)(of - name));
    const size_t length = slash ? (size_t)(slash - name) : 0;
    whirl_spread_of number;
    whirl_spread_at at;
    if (!whirl_spread_read(of, &number))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "'%.80s' is no number of points, expected FIELD, and as needed column NAME, row N, below X, "
                          "above X and at last at STATION",
                          of);
    for (size_t t = 0; t < view->table_count; t++) {
        const whirl_table *table = &view->tables[t];
        const bool named = !slash || (strlen(table->name) == length && strncmp(table->name, name, length) == 0);
        if (!named || table->tolerances.samples == 0 || !whirl_spread_place(view, table, &number, &at)) continue;
        whirl_findings *all = find_begin();
        if (all) find_spread_of(&(finder){all, units, view, table, NULL}, &number);
        return find_made(all, findings);
    }
    return whirl_fail(WHIRL_BAD_INPUT, "no table of samples has the number '%.80s'", of);
}

const char *findings_asked_spread(const char *name) {
    static const char *const sheets[] = {"spread", "indices", "probabilities"};
    const char *colon = strchr(name, ':');
    for (size_t i = 0; i < sizeof sheets / sizeof *sheets && colon; i++) {
        const size_t length = strlen(sheets[i]), before = (size_t)(colon - name);
        if (before < length || strncmp(colon - length, sheets[i], length) != 0) continue;
        if (before == length || colon[-(ptrdiff_t)length - 1] == '/') return sheets[i];
    }
    return NULL;
}

whirl_status findings_of_spread(const whirl_result *result, const char *units, const char *name,
                                whirl_findings **findings) {
    whirl_shown_units shown;
    const int before = exhausted_watch();
    *findings = NULL;
    whirl_status status = whirl_result_shown_units(result, units, &shown);
    if (status.code == WHIRL_OK) status = find_asked_spread(result, &shown, name, findings);
    if (!exhausted(before)) return status;
    whirl_findings_free(*findings);
    *findings = NULL;
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for what was found");
}

// ---------------------------------------------------------------- a sheet by its name

void whirl_sheet_name(const whirl_findings *findings, const whirl_sheet *sheet, char *text, size_t size) {
    size_t count = 0;
    for (size_t i = 0; i < findings->sheet_count; i++) count += strcmp(findings->sheets[i].name, sheet->name) == 0;
    snprintf(text, size, "%s%s%s", count > 1 ? sheet->table : "", count > 1 ? "/" : "", sheet->name);
}

whirl_status whirl_findings_sheet(const whirl_findings *findings, const char *name, const whirl_sheet **sheet) {
    // The name may begin with that of a table: TABLE/SHEET.
    const char *const slash = strchr(name, '/');
    const size_t length = slash ? (size_t)(slash - name) : 0;
    const char *const own = slash ? slash + 1 : name;
    const char **names = calloc(findings->sheet_count + 1, sizeof *names);
    if (!names) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the names of sheets");
    // Find the sheets of that name.
    size_t found = 0;
    *sheet = NULL;
    for (size_t i = 0; i < findings->sheet_count; i++) {
        const whirl_sheet *one = &findings->sheets[i];
        names[i] = one->name;
        if (strcmp(one->name, own) != 0) continue;
        if (slash && (strlen(one->table) != length || strncmp(one->table, name, length) != 0)) continue;
        if (found++ == 0) *sheet = one;
    }
    // Fail if there is not exactly one.
    whirl_status status = whirl_ok();
    if (found > 1) {
        status = whirl_fail(WHIRL_BAD_INPUT, "%zu tables have a sheet '%.80s', expected one of them: %.80s/%.80s",
                            found, name, (*sheet)->table, own);
    } else if (found == 0 && findings->sheet_count == 0) {
        status = whirl_fail(WHIRL_BAD_INPUT, "the result has no sheets");
    } else if (found == 0) {
        const char *near = whirl_nearest_name(own, names, findings->sheet_count);
        status = near ? whirl_fail(WHIRL_BAD_INPUT, "there is no sheet '%.80s', did you mean %.80s?", name, near)
                      : whirl_fail(WHIRL_BAD_INPUT, "there is no sheet '%.80s', expected one of %zu, such as %.80s",
                                   name, findings->sheet_count, names[0]);
    }
    if (status.code != WHIRL_OK) *sheet = NULL;
    free((void *)names);
    return status;
}
