// Gives words and units to summaries.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "summary.h"
#include "whirl/engine/report.h"

const char *summary_plural(double count) {
    return count == 1 ? "" : "s";
}

whirl_unit summary_length_unit(const whirl_shown_units *units) {
    return units->size.size > 0.0 ? units->size : whirl_result_length_unit(units->result);
}

void whirl_write_keyphasor(const char *keyphasor, double rate, FILE *out) {
    fprintf(out, "  sections: once a turn of the %s (%.6g Hz), which counts as a revolution here\n", keyphasor,
            rate / 6.283185307179586);
}

void whirl_result_write_end(const whirl_result *result, const char *table, const char *parameter, double first,
                            FILE *out) {
    char name[WHIRL_NAME_SIZE + 16];
    snprintf(name, sizeof name, "%.63s ends at", table);
    const char *const said = whirl_result_fact(result, name), *const missed = strstr(said, "short of ");
    if (!missed) return;
    const whirl_unit unit = whirl_result_unit(result, parameter);
    const char *const gap = *unit.name ? " " : "";
    const double last = strtod(said, NULL), end = strtod(missed + strlen("short of "), NULL);
    if (last == first)
        fprintf(out, "  the step is larger than the range: %.6g%s%s is the only value\n", last / unit.size, gap,
                unit.name);
    else
        fprintf(out, "  the steps end at %.6g%s%s, short of %.6g%s%s\n", last / unit.size, gap, unit.name,
                end / unit.size, gap, unit.name);
}

// ---------------------------------------------------------------- summary_doubts
// Undetermined motions in the summary.

/// Writes "undetermined at 3 points, first at 6400 rpm: still settling ...; to settle it, let it run 4 times as long".
static void print_doubt(FILE *out, const whirl_shown_units *units, const whirl_table *table, const whirl_doubt *doubt) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    char text[WHIRL_MESSAGE_SIZE];
    fprintf(out, "  undetermined at %zu point%s", doubt->points, doubt->points == 1 ? "" : "s");
    if (table->parameter[0])
        fprintf(out, ", first at %.6g%s%s", table->values[doubt->first] / unit.size, *unit.name ? " " : "", unit.name);
    whirl_verdict_reason(&doubt->verdict, text, sizeof text);
    fprintf(out, ": %s", text);
    whirl_verdict_advice(&doubt->verdict, text, sizeof text);
    if (*text) fprintf(out, "; to settle it, %s", text);
    fputc('\n', out);
}

void summarize_doubts(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    whirl_doubt doubts[WHIRL_REMEDIES];
    const size_t count = whirl_layout_has_verdict(&table->layout) ? whirl_table_doubts(table, doubts) : 0;
    bool remedied = false;
    for (size_t i = 0; i < count; i++) {
        print_doubt(out, units, table, &doubts[i]);
        const whirl_remedy remedy = doubts[i].verdict.advice.remedy;
        remedied = remedied || (remedy != WHIRL_NO_REMEDY && remedy != WHIRL_OTHER_START);
    }
    if (remedied) fputs("  whirl run --refine does these points again so\n", out);
}
