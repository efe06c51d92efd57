// Writes coexisting attractors: where the starts of every point lead.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "html.h"
#include "page.h"
#include "regimes.h"
#include "units.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

enum { SHOWN = 32, MAX_RANGES = 8, MAX_NAMES = 6 };

/// A table of a view, with the unit in which its parameter is shown.
typedef struct shown_view {
    FILE *stream;
    const whirl_table *table;
    double unit; ///< in SI
} shown_view;

static const char *plural(size_t count) {
    return count == 1 ? "" : "s";
}

/// Writes "P-1, P-2, chaotic": the motions of rows, each named once.
static void write_motions(const shown_view *to, size_t first, size_t end) {
    char names[MAX_NAMES][WHIRL_NAME_SIZE];
    size_t count = 0;
    for (size_t i = first; i < end && count < MAX_NAMES; i++) {
        const whirl_verdict verdict = whirl_table_verdict(to->table, i);
        size_t k = 0;
        regime_name(&verdict, names[count], sizeof names[count]);
        while (strcmp(names[k], names[count]) != 0) k++;
        if (k == count) html_printf(to->stream, "%s%s", count ? ", " : "", names[count]);
        count += k == count;
    }
    if (count == MAX_NAMES) fputs(", &hellip;", to->stream);
}

/// Writes the row of one attractor: its motions, range, and shares.
static void write_attractor(const shown_view *to, size_t first, size_t end) {
    const whirl_table *table = to->table;
    const whirl_coexisting *one = &table->attractors[first];
    // Find the range of shares, and the number of points whose own starts led to the attractor.
    double low = one->share, high = one->share, error = one->error;
    size_t met = 0;
    for (size_t i = first; i < end; i++) {
        low = fmin(low, table->attractors[i].share);
        high = fmax(high, table->attractors[i].share);
        error = fmax(error, table->attractors[i].error);
        met += table->attractors[i].starts > 0;
    }
    // Write number and motions.
    fprintf(to->stream,
            "<tr><th scope=\"row\"><span class=\"swatch\" style=\"background:%s\"></span>%zu</th><td class=\"wide\">",
            attractor_colour(one->number), one->number);
    write_motions(to, first, end);
    // Write the range of the parameter.
    fputs("</td><td class=\"whole\">", to->stream);
    if (*table->parameter && end - first > 1)
        html_printf(to->stream, "%.5g to %.5g", table->values[first] / to->unit, table->values[end - 1] / to->unit);
    else if (*table->parameter)
        html_printf(to->stream, "%.5g", table->values[first] / to->unit);
    // Write the number of points, the shares and the error.
    fprintf(to->stream, "</td><td class=\"number\">%zu</td><td class=\"number\">%.3g", end - first, 100.0 * low);
    if (high > low) fprintf(to->stream, " to %.3g", 100.0 * high);
    fputs("&nbsp;%", to->stream);
    if (met < end - first) fprintf(to->stream, "<br>(at %zu from neighbours)", end - first - met);
    fprintf(to->stream, "</td><td class=\"number\">%.2g&nbsp;%%</td></tr>\n", 100.0 * error);
}

static void write_attractors(const shown_view *to, const char *label) {
    const whirl_table *table = to->table;
    html_table(to->stream, "Attractors", "");
    fputs("<thead><tr><th></th><th>Motion</th><th>", to->stream);
    html_text(to->stream, label);
    fputs("</th><th class=\"number\">Points</th><th class=\"number\">Share of<br>the starts</th>"
          "<th class=\"number\">Standard error<br>at most</th></tr></thead>\n<tbody>\n",
          to->stream);
    size_t shown = 0, end;
    for (size_t first = 0; first < table->count; first = end) {
        for (end = first; end < table->count && table->attractors[end].number == table->attractors[first].number;)
            end++;
        if (shown++ < SHOWN) write_attractor(to, first, end);
    }
    fputs("</tbody></table></div>\n", to->stream);
    if (shown > SHOWN) fprintf(to->stream, "<p class=\"soft small\">And %zu more.</p>\n", shown - SHOWN);
}

/// Returns the number of attractors at every point [places], followed by the parameter's values [places]; the caller
/// frees it.
static double *places_of(const whirl_table *table, size_t places) {
    double *found = calloc(2 * places + 1, sizeof *found);
    for (size_t i = 0; found && i < table->count; i++) {
        found[table->attractors[i].place] = (double)table->attractors[i].beside;
        found[places + table->attractors[i].place] = table->values[i];
    }
    return found;
}

/// Writes "Several exist side by side at 7 of 41 points: 0.29 to 0.31, 0.498."
static void write_side_by_side(const shown_view *to, size_t places) {
    double *found = places_of(to->table, places);
    const double *values = found ? found + places : NULL;
    size_t several = 0, ranges = 0;
    // Count the points with several attractors.
    for (size_t k = 0; found && k < places; k++) several += found[k] > 1.5;
    if (several == 0)
        fputs("At no point several were found side by side. ", to->stream);
    else
        fprintf(to->stream, "Several exist side by side at %zu of %zu point%s", several, places, plural(places));
    // List their ranges, if they are along one parameter.
    for (size_t k = 0; found && several > 0 && *to->table->parameter && to->table->row == 0 && k < places; k++) {
        size_t last = k;
        if (!(found[k] > 1.5)) continue;
        while (last + 1 < places && found[last + 1] > 1.5) last++;
        if (ranges++ < MAX_RANGES) {
            html_printf(to->stream, "%s %.5g", ranges == 1 ? ":" : ",", values[k] / to->unit);
            if (last > k) html_printf(to->stream, " to %.5g", values[last] / to->unit);
        }
        k = last;
    }
    if (ranges > MAX_RANGES) fprintf(to->stream, " and %zu more ranges", ranges - MAX_RANGES);
    if (several > 0) fputs(". ", to->stream);
    free(found);
}

static void write_sentences(const shown_view *to) {
    const whirl_table *source = to->table->source;
    // Count the starts without a verdict.
    size_t done = 0, untold = 0;
    for (size_t i = 0; i < source->count; i++) {
        done += whirl_table_done(source, i);
        untold += whirl_table_done(source, i) && whirl_table_verdict(source, i).regime == WHIRL_UNDETERMINED;
    }
    // Explain the starts, and what was found side by side.
    fprintf(to->stream,
            "<p>Every point was started from %zu states: the initial state and %zu that fill their ranges. ",
            source->starts, source->starts - 1);
    if (source->neighbours > 0)
        fputs("If a neighbouring point had an attractor that none of these starts reached, the point was also started "
              "from "
              "the end of that motion: an attractor found only so has a share of 0. ",
              to->stream);
    write_side_by_side(to, whirl_table_places(source));
    // Explain what starts can miss, and how attractors are numbered.
    if (untold > 0) fprintf(to->stream, "%zu of %zu starts have no verdict. ", untold, done);
    fprintf(to->stream,
            "An attractor that %.2g&nbsp;%% of the states lead to is missed by %zu starts with a chance of 5&nbsp;%%. "
            "Attractors of neighbouring points have one number where each is the nearest of the other and the motion "
            "changes by less than half of its extent%s. Errors are those of as many starts drawn at random.</p>\n",
            100.0 * whirl_missed_share(source->starts), source->starts,
            to->table->row > 0 ? "; the maps show the one of every point that most starts lead to" : "");
}

void page_starts(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    for (size_t t = 0; t < result->table_count; t++) {
        const whirl_table *table = &result->tables[t];
        char label[UNIT_LABEL_SIZE];
        if (!table->source || table->count == 0) continue;
        const shown_view shown = {to->stream, table, whirl_shown_parameter(&to->units[index], table->parameter).size};
        units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
        fprintf(to->stream, "<h3 id=\"attractors-%zu\">Attractors</h3>\n", index + 1);
        write_sentences(&shown);
        if (table->row == 0) write_attractors(&shown, *table->parameter ? label : "");
    }
}
