// What the summary says of undetermined motions.
#include "summary.h"

#include <stdio.h>

/// "undetermined at 3 points, first at 6400 rpm: still settling ...; to settle it, let it run 4 times as long".
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
