// Jumps along the sweep: where one regime goes on but the motion does not.
#include "html.h"
#include "page.h"
#include "quantities.h"
#include "regimes.h"

enum { MOST_JUMPS = 24 };

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
    const whirl_table *table = whirl_result_table(to->results[index], "sweep");
    whirl_jump jumps[MOST_JUMPS];
    char label[UNIT_LABEL_SIZE];
    size_t count;
    if (!table || whirl_table_jumps(table, jumps, MOST_JUMPS, &count).code != WHIRL_OK || count == 0) return;
    units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
    fprintf(to->stream, "<h4 id=\"jumps-%zu\">Jumps within a regime</h4>\n", index + 1);
    fprintf(
        to->stream,
        "<p>Between %zu pair%s of neighbouring points the regime stays, but the motion changes far more than around "
        "%s. Two motions may exist side by side there, of which the start decides; or one changes suddenly. These "
        "numbers do not tell which: a sweep with <code>start: carry</code> and <code>direction: both</code>, or other "
        "initial states, may.</p>\n",
        count, count == 1 ? "" : "s", count == 1 ? "it" : "them");
    html_table(to->stream, "Jumps within a regime", "");
    fputs("<thead><tr><th>", to->stream);
    html_text(to->stream, label);
    fputs("</th><th>Regime</th><th>Station</th><th class=\"number\">Change, of the<br>motion's size</th>"
          "<th class=\"number\">From point to<br>point around</th></tr></thead>\n<tbody>\n",
          to->stream);
    for (size_t i = 0; i < count && i < MOST_JUMPS; i++) write_jump(to, index, table, &jumps[i]);
    fputs("</tbody></table></div>\n", to->stream);
    if (count > MOST_JUMPS) fprintf(to->stream, "<p class=\"soft small\">And %zu more.</p>\n", count - MOST_JUMPS);
}
