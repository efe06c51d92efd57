// What was found, first: verdicts and how many points have each, and the figure that shows them.
#include <string.h>

#include "html.h"
#include "page.h"
#include "regimes.h"

enum { MOST_KINDS = 12 };

/// "P-1" and its points.
typedef struct kind {
    char name[WHIRL_NAME_SIZE];
    size_t points;
} kind;

/// The kinds of verdicts of a table; what finds no room is counted with the last of them, "others".
static size_t count_kinds(const whirl_table *table, kind *kinds) {
    size_t count = 0;
    for (size_t point = 0; point < table->count; point++) {
        char name[WHIRL_NAME_SIZE];
        size_t k = 0;
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict verdict = whirl_table_verdict(table, point);
        regime_name(&verdict, name, sizeof name);
        while (k < count && k + 1 < MOST_KINDS && strcmp(kinds[k].name, name) != 0) k++;
        if (k == count) kinds[count++] = (kind){.points = 0};
        if (kinds[k].points++ == 0) snprintf(kinds[k].name, sizeof kinds[k].name, "%s", name);
        if (strcmp(kinds[k].name, name) != 0) snprintf(kinds[k].name, sizeof kinds[k].name, "others");
    }
    return count;
}

static void write_kinds(FILE *stream, const whirl_table *table) {
    kind kinds[MOST_KINDS];
    const size_t count = count_kinds(table, kinds);
    if (count == 0) return;
    fputs("<p class=\"found\"><strong>", stream);
    html_text(stream, table->name);
    fputs("</strong> found: ", stream);
    for (size_t k = 0; k < count; k++)
        html_printf(stream, "%s%s at %zu point%s", k ? ", " : "", kinds[k].name, kinds[k].points,
                    kinds[k].points == 1 ? "" : "s");
    fputs(".</p>\n", stream);
}

/// Why motions are undetermined, and what would tell them.
static void write_doubts(const page *to, size_t index, const whirl_table *table) {
    whirl_doubt doubts[WHIRL_REMEDIES];
    const whirl_unit unit = whirl_shown_parameter(&to->units[index], table->parameter);
    const size_t count = whirl_table_doubts(table, doubts);
    for (size_t i = 0; i < count; i++) {
        const whirl_verdict *const verdict = &doubts[i].verdict;
        char text[1024];
        fputs("<p>", to->stream);
        html_printf(to->stream, "Undetermined at %zu point%s", doubts[i].points, doubts[i].points == 1 ? "" : "s");
        if (table->parameter[0])
            html_printf(to->stream, ", first at %.6g%s%s", table->values[doubts[i].first] / unit.size,
                        *unit.name ? " " : "", unit.name);
        whirl_verdict_reason(verdict, text, sizeof text);
        html_printf(to->stream, ": %s.", text);
        whirl_verdict_advice(verdict, text, sizeof text);
        if (*text) html_printf(to->stream, " To settle it, %s", text);
        if (*text && verdict->advice.remedy != WHIRL_OTHER_START)
            fputs("; <code>whirl run --refine</code> does so", to->stream);
        fputs(*text ? ".</p>\n" : "</p>\n", to->stream);
    }
}

void page_found(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    for (size_t t = 0; t < result->table_count; t++)
        if (whirl_layout_has_verdict(&result->tables[t].layout) && result->tables[t].count > 0) {
            write_kinds(to->stream, &result->tables[t]);
            write_doubts(to, index, &result->tables[t]);
            break;
        }
    const drawn_figure *main = page_main_figure(to, index);
    if (main) page_figure(to, main);
}
