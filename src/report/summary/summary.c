// Writes the summary of a result as text.
#include "summary.h"

#include <stdlib.h>
#include <string.h>

#include "findings_render.h"
#include "machine_at.h"
#include "shown_kinds.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/internal/findings.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

/// Returns the number of starts in a table that continue neighbours' motions.
static size_t count_from_neighbours(const whirl_table *table) {
    size_t count = 0;
    for (size_t i = 0; i < table->source->count; i++) count += whirl_table_from_neighbour(table->source, i);
    return count;
}

/// Writes " and rho: 32 x 16 points", or ", rho and sigma: 32 x 16 x 3 points" with a third parameter.
static void print_axes(FILE *out, const whirl_table *table) {
    const size_t planes = whirl_table_planes(table);
    const bool stacked = table->plane > 0;
    fprintf(out, "%s%s%s%s: %zu x %zu", stacked ? ", " : " and ", table->second, stacked ? " and " : "", table->third,
            table->row, whirl_table_rows(table));
    if (stacked) fprintf(out, " x %zu", planes);
    fputs(" points", out);
}

/// Writes "tolerances of omega: 3 points at each of 64 samples, of 5 machines each".
static void print_samples(FILE *out, const whirl_table *table) {
    const size_t places = whirl_table_places(table), each = whirl_tolerance_each(&table->tolerances);
    fprintf(out, "%s%s%s: %zu point%s at each of %d samples", table->name, *table->parameter ? " of " : "",
            table->parameter, places, summary_plural((double)places), table->tolerances.samples);
    if (each > 1) fprintf(out, ", of %zu machines each", each);
    fputc('\n', out);
}

void summarize_heading(FILE *out, const whirl_table *table) {
    if (table->tolerances.samples > 0) {
        print_samples(out, table);
        return;
    }
    if (!*table->parameter) {
        fprintf(out, "%s:\n", table->name);
        return;
    }
    const size_t planned = whirl_table_planned(table);
    fprintf(out, "%s of %s", table->name, table->parameter);
    if (table->row > 0)
        print_axes(out, table);
    else
        fprintf(out, ": %zu point%s", planned, summary_plural((double)planned));
    if (table->source) fprintf(out, ", %zu starts each", table->source->starts);
    if (table->source && table->source->neighbours > 0)
        fprintf(out, " and %zu from neighbours", count_from_neighbours(table));
    fputc('\n', out);
}

/// Writes the parameter values of a table's condition: "  with clearance = 90 um".
static void print_given(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    char name[2 * WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "%s with", table->name);
    if (*whirl_result_fact(units->result, name)) fprintf(out, "  with %s\n", whirl_result_fact(units->result, name));
}

enum { MAX_POINTS = 2, MAX_ROWS = 24 };

static whirl_status print_table(FILE *out, const whirl_findings *findings, const whirl_shown_units *units,
                                const whirl_table *table) {
    // Write the method that "auto" chose, and a heading with the parameters of the table.
    if (table->integrate.chosen) fprintf(out, "method auto took %s for the %s\n", table->integrate.method, table->name);
    summarize_heading(out, table);
    print_given(out, units, table);
    if (table->count > 0 && table->row == 0)
        whirl_result_write_end(units->result, table->name, table->parameter, table->values[0], out);
    // Write the statements and sheets of the table.
    if (table->count == 0 && !whirl_analysis_kind(table->analyses)->found) fputs("  no point was computed\n", out);
    if (!findings_write_table(out, findings, table->name, MAX_POINTS, MAX_ROWS))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a summary");
    return whirl_ok();
}

whirl_status whirl_result_write_summary(const whirl_result *result, FILE *out) {
    // Write the title, warnings, fits, film tables, and how far the run came.
    size_t done, total;
    whirl_result *view;
    fprintf(out, "%s\n", result->title[0] ? result->title : result->case_name);
    whirl_shown_units units;
    char said[SENTENCE_SIZE];
    whirl_result_shown_units(result, NULL, &units); // an unknown unit in the file is ignored
    for (size_t i = 0; *whirl_result_warning(result, i); i++) {
        whirl_shown_sentence(&units, whirl_result_warning(result, i), said, sizeof said);
        fprintf(out, "warning: %s\n", said);
    }
    for (size_t i = 0; *whirl_result_fit(result, i); i++) {
        whirl_shown_sentence(&units, whirl_result_fit(result, i), said, sizeof said);
        fprintf(out, "%s\n", said);
    }
    if (*whirl_result_film_tables(result)) fprintf(out, "film tables: %s\n", whirl_result_film_tables(result));
    const char *const keyphasor = whirl_result_keyphasor(result);
    if (*keyphasor) whirl_write_keyphasor(keyphasor, whirl_result_clock(result), out);
    if (whirl_result_partial(result, &done, &total)) {
        if (done == 0)
            fprintf(out, "partial: stopped before the first of %zu point%s\n", total, summary_plural((double)total));
        else if (done < total)
            fprintf(out, "partial: stopped after %zu of %zu point%s\n", done, total, summary_plural((double)total));
        else
            fputs("partial: stopped when all points were done, before all were confirmed or refined\n", out);
    }
    // Make the findings, of a view in which every attractor has a row.
    whirl_status status = whirl_result_by_attractor(result, &view);
    if (status.code != WHIRL_OK) return status;
    whirl_result_shown_units(view, NULL, &units);
    whirl_findings *findings = NULL;
    whirl_case *machine = NULL;
    status = machine_of(view, &machine);
    if (status.code == WHIRL_OK) status = findings_of(view, &units, machine, &findings);
    // Write the findings on the machine, then each table.
    if (status.code == WHIRL_OK && !findings_write_table(out, findings, "", MAX_ROWS, MAX_ROWS))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a summary");
    for (size_t i = 0; i < view->table_count && status.code == WHIRL_OK; i++)
        status = print_table(out, findings, &units, &view->tables[i]);
    whirl_findings_free(findings);
    whirl_case_free(machine);
    whirl_result_view_free(view);
    return status;
}
