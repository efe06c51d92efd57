// Attractors of a basin, one row each: how many starts come to rest on it.
#include <math.h>

#include "html.h"
#include "page.h"
#include "quantities.h"

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
    const whirl_table *table = whirl_result_table(to->results[index], "basin");
    whirl_attractor found[SHOWN];
    size_t count, told = 0, done = 0;
    if (!table || whirl_table_attractors(table, NULL, found, SHOWN, &count).code != WHIRL_OK || count == 0) return;
    for (size_t i = 0; i < table->count; i++) done += whirl_table_done(table, i);
    for (size_t k = 0; k < count && k < SHOWN; k++) told += found[k].points;
    fprintf(to->stream, "<h3 id=\"attractors-%zu\">Attractors</h3>\n<p>Motions that the starts come to rest on",
            index + 1);
    if (told < done) fprintf(to->stream, "; %zu of %zu starts have none that is told", done - told, done);
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
