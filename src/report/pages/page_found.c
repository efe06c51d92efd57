// Writes the findings that come first on a page with the main figure, attractors of a basin, and jumps.
#include <math.h>
#include <string.h>

#include "found.h"
#include "html.h"
#include "page.h"
#include "quantities.h"
#include "regimes.h"
#include "shown_kinds.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/status.h"

/// Returns true if sentences describe a table; the sentences of the sweep cover detail points. A study that found no
/// branch or torus has a statement about that.
static bool is_covered(const whirl_result *result, const whirl_table *table) {
    if (table->count == 0) return shown_kind_of(table);
    return table->role != WHIRL_ROLE_DETAIL || result->table_count == 1;
}

static void write_tables(const page *to, size_t index, bool at_rest) {
    const whirl_result *result = to->results[index];
    for (const whirl_table *table = result->tables; table < result->tables + result->table_count; table++) {
        const whirl_kind *kind = whirl_analysis_kind(table->analyses);
        if (is_covered(result, table) && at_rest == !(kind->moves || kind->found)) found_table(to, index, table);
    }
}

void page_found(const page *to, size_t index) {
    fputs("<ul class=\"found\">\n", to->stream);
    write_tables(to, index, false);
    write_tables(to, index, true);
    fputs("</ul>\n", to->stream);
    const drawn_figure *main = page_main_figure(to, index);
    if (main) page_figure(to, main);
}

// ---------------------------------------------------------------- page_attractors
// Attractors of a basin, one row each: how many starts lead to it.

enum { SHOWN = 64 };

static void write_attractor(const page *to, const whirl_table *table, size_t number, const whirl_attractor *one) {
    const whirl_verdict verdict = whirl_table_verdict(table, one->first);
    const shown_estimate exponent = estimate_shown(point_exponent(table, one->first));
    char name[WHIRL_NAME_SIZE];
    whirl_verdict_name(&verdict, name, sizeof name);
    fprintf(to->stream, "<tr><th scope=\"row\">%zu</th><td>", number);
    html_text(to->stream, name);
    fprintf(to->stream,
            "</td><td class=\"number\">%zu</td><td class=\"number\">%.1f&nbsp;%% &plusmn; %.1f&nbsp;%%</td>"
            "<td class=\"number\">%.5g, %.5g</td><td class=\"number\">",
            one->points, 100.0 * one->share, 100.0 * one->error, table->values[one->first],
            whirl_table_second(table, one->first));
    if (isfinite(exponent.value)) html_printf(to->stream, "%.*f", exponent.decimals, exponent.value);
    fputs("</td></tr>\n", to->stream);
}

void page_attractors(const page *to, size_t index) {
    const whirl_table *table = whirl_result_role(to->results[index], WHIRL_ROLE_BASIN);
    whirl_attractor found[SHOWN];
    size_t count, known = 0, done = 0;
    if (!table || whirl_table_attractors(table, NULL, found, SHOWN, &count).code != WHIRL_OK || count == 0) return;
    for (size_t i = 0; i < table->count; i++) done += whirl_table_done(table, i);
    for (size_t k = 0; k < count && k < SHOWN; k++) known += found[k].points;
    fprintf(to->stream, "<h3 id=\"attractors-%zu\">Attractors</h3>\n<p>Motions that the starts come to rest on",
            index + 1);
    if (known < done) fprintf(to->stream, "; the attractor of %zu of %zu starts is unknown", done - known, done);
    fputs(". Errors are those of as many starts drawn at random.</p>\n", to->stream);
    html_table(to->stream, "Attractors", "");
    fputs("<thead><tr><th></th><th>Motion</th><th class=\"number\">Starts</th><th class=\"number\">Share</th>"
          "<th class=\"number\">First start<br>(",
          to->stream);
    html_printf(to->stream, "%s, %s", table->parameter, table->second);
    fputs(")</th><th class=\"number\">Largest<br>exponent</th></tr></thead>\n<tbody>\n", to->stream);
    for (size_t k = 0; k < count && k < SHOWN; k++) write_attractor(to, table, k + 1, &found[k]);
    fputs("</tbody></table></div>\n", to->stream);
}

// ---------------------------------------------------------------- page_jumps
// Jumps along the sweep: places where the regime stays the same but the motion changes suddenly.

enum { MAX_JUMPS = 24 };

static void write_jump(const page *to, size_t index, const whirl_table *table, const whirl_jump *jump) {
    const whirl_verdict verdict = whirl_table_verdict(table, jump->from);
    const double unit = whirl_shown_parameter(&to->units[index], table->parameter).size;
    char name[WHIRL_NAME_SIZE];
    regime_name(&verdict, name, sizeof name);
    fputs("<tr><th scope=\"row\">", to->stream);
    html_printf(to->stream, "%.5g to %.5g", table->values[jump->from] / unit, table->values[jump->to] / unit);
    if (table->attractors) html_printf(to->stream, ", attractor %zu", table->attractors[jump->from].number);
    fputs(table->branch[jump->from] < 0 ? " <span class=\"soft\">(from the last value)</span></th><td>" : "</th><td>",
          to->stream);
    html_text(to->stream, name);
    fputs("</td><td>", to->stream);
    html_text(to->stream, to->results[index]->stations[jump->station].name);
    fprintf(to->stream, "</td><td class=\"number\">%.2g&nbsp;%%</td><td class=\"number\">%.2g&nbsp;%%</td></tr>\n",
            100.0 * jump->change, 100.0 * jump->usual);
}

void page_jumps(const page *to, size_t index) {
    const whirl_table *table = whirl_result_role(to->results[index], WHIRL_ROLE_SURVEY);
    whirl_jump jumps[MAX_JUMPS];
    char label[UNIT_LABEL_SIZE];
    size_t count;
    // Find neighbouring points between which the motion jumps.
    if (!table || whirl_table_jumps(table, jumps, MAX_JUMPS, &count).code != WHIRL_OK || count == 0) return;
    units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
    // Explain what jumps mean.
    fprintf(to->stream, "<h4 id=\"jumps-%zu\">Jumps within a regime</h4>\n", index + 1);
    fprintf(
        to->stream,
        "<p>Between %zu pair%s of neighbouring points the regime stays, but the motion changes far more than around "
        "%s. Two motions may coexist there, and the start decides between them; or one motion changes suddenly. A "
        "sweep with <code>start: carry</code> and <code>direction: both</code>, or other "
        "initial states, may decide.</p>\n",
        count, count == 1 ? "" : "s", count == 1 ? "it" : "them");
    // List the largest jumps.
    html_table(to->stream, "Jumps within a regime", "");
    fputs("<thead><tr><th>", to->stream);
    html_text(to->stream, label);
    fputs("</th><th>Regime</th><th>Station</th><th class=\"number\">Change, of the<br>motion's size</th>"
          "<th class=\"number\">From point to<br>point around</th></tr></thead>\n<tbody>\n",
          to->stream);
    for (size_t i = 0; i < count && i < MAX_JUMPS; i++) write_jump(to, index, table, &jumps[i]);
    fputs("</tbody></table></div>\n", to->stream);
    if (count > MAX_JUMPS) fprintf(to->stream, "<p class=\"soft small\">And %zu more.</p>\n", count - MAX_JUMPS);
}
