// What is asked of a lateral analysis beside what was found, with the clause: margins, vibration, clearances,
// stability.
//
// Clauses are told by what follows the number of the chapter, which editions have alike: SP6.8 of API RP 684 (2nd
// edition, 2005), 2.6 of API 617 (7th, 2002), 4.8 of its first part (8th, 2014). Which edition counts is for the user
// to check.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "page.h"
#include "shown_kinds.h"

enum { CELL = 256 };

/// A row: of a table, what is asked, what was found, and what follows.
typedef struct asked_row {
    const char *what, *clause;
    char asked[CELL], found[CELL], verdict[CELL];
} asked_row;

static void write_row(const page *to, const whirl_table *table, const asked_row *row) {
    const char *const cells[] = {row->what, row->asked, row->found, row->verdict};
    fputs("<tr><th>", to->stream);
    html_text(to->stream, table->name);
    fputs("</th>", to->stream);
    for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) {
        fputs("<td>", to->stream);
        html_text(to->stream, cells[i]);
        fputs("</td>", to->stream);
    }
    fprintf(to->stream, "<td class=\"whole\">SP6.8.%s</td></tr>\n", row->clause);
}

// ---------------------------------------------------------------- responses

/// The peak that lacks most of its margin, or has least more than that.
static void write_margin(const page *to, size_t result, const whirl_table *table) {
    asked_row row = {.what = "separation margin", .clause = "2.10"};
    const whirl_result *own = to->results[result];
    const margin_tally all = margin_count(own, table, &to->units[result]);
    const margin_row *const peak = &all.worst;
    if (all.told > 0) {
        snprintf(row.asked, CELL, "%.3g %% (amplification %.3g)", peak->asked, peak->amplification);
        snprintf(row.found, CELL, isnan(peak->had) ? "peak within the running speeds" : "%.3g %% %s", peak->had,
                 peak->above ? "above" : "below");
        const size_t used = strlen(row.found);
        snprintf(row.found + used, CELL - used, ": %s at %.5g %s", own->stations[all.station].name, peak->speed,
                 margin_speed_unit(&to->units[result]).name);
    }
    const char *const lacks = margin_lacks(table);
    if (all.told == 0 && !lacks)
        snprintf(row.found, CELL, "no amplification of 2.5 or more%s at the speeds that were looked at",
                 *table->record.probes_at ? " at a probe" : "");
    if (all.held < all.told)
        snprintf(row.verdict, CELL, "fails: %zu of %zu peaks", all.told - all.held, all.told);
    else
        snprintf(row.verdict, CELL, "%s%s",
                 lacks      ? "not known: "
                 : all.told ? "holds"
                            : "none asked for",
                 lacks ? lacks : "");
    write_row(to, table, &row);
}

static void write_vibration(const page *to, size_t result, const whirl_table *table, const scaled *by) {
    const whirl_unit length = scaled_unit(&to->units[result]);
    asked_row row = {.what = "vibration at probes where it runs", .clause = "2.11"};
    snprintf(row.asked, CELL, "at most %.4g %s p-p", by->limit / length.size, length.name);
    snprintf(row.found, CELL, "%.4g %s p-p at %s", by->largest / length.size, length.name,
             to->results[result]->stations[by->station].name);
    snprintf(row.verdict, CELL, by->beyond ? "fails" : "holds");
    write_row(to, table, &row);
}

/// The clearance of which scaled responses take most.
static void write_clearance(const page *to, size_t result, const whirl_table *table, const scaled *by) {
    const whirl_result *own = to->results[result];
    const whirl_unit speed = margin_speed_unit(&to->units[result]);
    asked_row row = {.what = "close clearances", .clause = "2.12", .asked = "at most 75 % of the diametral clearance"};
    scaled_row close;
    if (!scaled_tightest(own, table, by, &close)) return;
    snprintf(row.found, CELL, "%.3g %% at %s, %.5g %s, scaled by %.4g", 100.0 * close.axis / close.clearance,
             own->stations[close.station].name, close.speed / speed.size, speed.name, by->factor);
    snprintf(row.verdict, CELL, "%s", scaled_verdict(by, &close));
    write_row(to, table, &row);
}

static void ask_response(const page *to, size_t result, const whirl_table *table, void *context) {
    scaled by;
    (void)context;
    if (!margin_asked(table)) return;
    write_margin(to, result, table);
    if (!scaled_of(to->results[result], table, &by)) {
        asked_row row = {.what = "vibration at probes, clearances", .clause = "2.11"};
        snprintf(row.verdict, CELL, "not known: %s", scaled_lacks);
        write_row(to, table, &row);
        return;
    }
    write_vibration(to, result, table, &by);
    write_clearance(to, result, table, &by);
}

// ---------------------------------------------------------------- stability

/// What points of a table have of their stability.
typedef struct stability_found {
    bool stages, one, two; ///< whether there are stages; Level I holds at all; the least of all is asked for
    double decrement,
        complete;         ///< the least with stages, and of all; NaN: none
    double ratio, factor; ///< limit over anticipated, and what is asked of it, where it lacks most
} stability_found;

static stability_found find_stability(const whirl_table *table) {
    stability_found of = {false, true, false, NAN, NAN, INFINITY, 2.0};
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const bool asked = margin_level_two_asked(table, i);
        const double complete = whirl_table_number(table, i, WHIRL_FIELD_STABILITY_COMPLETE, 0);
        const double anticipated = whirl_table_number(table, i, WHIRL_FIELD_STABILITY_ANTICIPATED, 0);
        const double ratio = whirl_table_number(table, i, WHIRL_FIELD_STABILITY_LIMIT, 0) / anticipated;
        const double factor = margin_coupling(table, i);
        if (isnan(of.complete) || complete < of.complete) of.complete = complete, of.two = asked;
        if (!(anticipated > 0.0)) continue;
        of.stages = true;
        of.one = of.one && !asked;
        of.decrement = fmin(of.decrement, whirl_table_number(table, i, WHIRL_FIELD_STABILITY_DECREMENT, 0));
        if (ratio / factor < of.ratio / of.factor) of.ratio = ratio, of.factor = factor;
    }
    return of;
}

static void ask_stability(const page *to, size_t result, const whirl_table *table, void *context) {
    static const char none[] = "no mode that does not go backward";
    asked_row one = {.what = "stability, Level I", .clause = "5"}, two = {.what = "stability, Level II", .clause = "6"};
    const stability_found of = find_stability(table);
    (void)result, (void)context;
    snprintf(one.asked, CELL, "limit of the cross coupling at least %g times the anticipated, decrement at least %g",
             of.factor, margin_decrement);
    if (isnan(of.decrement))
        snprintf(one.found, CELL, "%s", none);
    else
        snprintf(one.found, CELL, isfinite(of.ratio) ? "decrement %.3g, limit %.3g times" : "decrement %.3g, no limit",
                 of.decrement, of.ratio);
    snprintf(one.verdict, CELL, of.one ? "holds" : "not enough: Level II decides");
    if (of.stages) write_row(to, table, &one);
    snprintf(two.asked, CELL, "decrement above %g with seals and impellers", margin_decrement);
    snprintf(two.found, CELL, isnan(of.complete) ? none : "decrement %.3g", of.complete);
    snprintf(two.verdict, CELL,
             isnan(of.complete)               ? ""
             : of.complete > margin_decrement ? "holds"
             : of.two                         ? "fails"
                                              : "fails, though Level I holds there");
    write_row(to, table, &two);
}

void page_asked(const page *to) {
    const found_part all = {0, to->count, true};
    if (found_each(to, all, WHIRL_FIELD_UNBALANCE_PROBE, NULL, NULL) +
            found_each(to, all, WHIRL_FIELD_STABILITY_COMPLETE, NULL, NULL) ==
        0)
        return;
    html_table(to->stream, "What is asked for", "");
    fputs("<thead><tr><th>of</th><th>what</th><th>asked for</th><th>found, at its least</th><th>verdict</th>"
          "<th>clause</th></tr></thead>\n<tbody>\n",
          to->stream);
    found_each(to, all, WHIRL_FIELD_UNBALANCE_PROBE, ask_response, NULL);
    found_each(to, all, WHIRL_FIELD_STABILITY_COMPLETE, ask_stability, NULL);
    fputs("</tbody></table></div>\n<p class=\"soft small\">Clauses are those of API RP 684, 2nd edition of 2005; in "
          "API 617 "
          "2.6 (7th edition, 2002) or 4.8 (8th, 2014, part 1) stands in the place of SP6.8. Which standard and edition "
          "counts, and what it asks for, is for the user to check.</p>\n",
          to->stream);
}
