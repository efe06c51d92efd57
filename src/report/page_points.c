// Regimes along the sweep, and the table of the points that are shown one by one.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "html.h"
#include "page.h"
#include "quantities.h"
#include "regimes.h"

enum { SHORT_INTERVAL = 3, SHOWN_LINES = 5 };

static void write_swatch(FILE *stream, regime_class kind) {
    fprintf(stream, "<span class=\"swatch\" style=\"background:%s\"></span>", regime_class_colour(kind));
}

static void write_range(FILE *stream, const whirl_table *table, size_t first, size_t last) {
    if (first == last)
        html_printf(stream, "%.5g", table->values[first]);
    else
        html_printf(stream, "%.5g to %.5g", table->values[first], table->values[last]);
}

static void write_interval(FILE *stream, const whirl_table *table, const regime_interval *interval, bool branches) {
    fputs("<tr><td class=\"whole\">", stream);
    write_range(stream, table, interval->first, interval->last);
    if (branches) fputs(interval->branch < 0 ? " <span class=\"soft\">(from the last value)</span>" : "", stream);
    fputs("</td><td class=\"whole\">", stream);
    write_swatch(stream, interval->kind);
    html_text(stream, interval->name);
    fprintf(stream, "</td><td class=\"number\">%zu</td><td class=\"number\">%zu</td></tr>\n", interval->count,
            interval->rubbing);
}

/// Several short windows in a row stand as one line that names their regimes.
static void write_windows(FILE *stream, const whirl_table *table, const regime_interval *windows, size_t count) {
    size_t points = 0, rubbing = 0;
    fputs("<tr><td class=\"whole\">", stream);
    write_range(stream, table, windows[0].first, windows[count - 1].last);
    fputs("</td><td class=\"wide\">changing: ", stream);
    for (size_t i = 0; i < count; i++) {
        bool named = false;
        points += windows[i].count;
        rubbing += windows[i].rubbing;
        for (size_t k = 0; k < i; k++) named = named || strcmp(windows[k].name, windows[i].name) == 0;
        if (!named) html_printf(stream, "%s%s", i ? ", " : "", windows[i].name);
    }
    fprintf(stream,
            " <span class=\"soft\">(%zu windows)</span></td><td class=\"number\">%zu</td><td "
            "class=\"number\">%zu</td></tr>\n",
            count, points, rubbing);
}

static void write_interval_head(FILE *stream, const char *parameter) {
    fputs("<div class=\"scroll\"><table>\n<thead><tr><th>", stream);
    html_text(stream, parameter);
    fputs("</th><th>Regime</th><th class=\"number\">Points</th><th class=\"number\">of these with "
          "rub</th></tr></thead>\n<tbody>\n",
          stream);
}

static void write_merged(FILE *stream, const whirl_table *table, const regime_interval *intervals, size_t count,
                         bool branches) {
    for (size_t i = 0; i < count;) {
        size_t end = i;
        while (end < count && intervals[end].count < SHORT_INTERVAL && intervals[end].branch == intervals[i].branch)
            end++;
        if (end - i >= 2) {
            write_windows(stream, table, &intervals[i], end - i);
            i = end;
        } else {
            write_interval(stream, table, &intervals[i++], branches);
        }
    }
}

void page_intervals(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    const whirl_table *table = whirl_result_table(result, "sweep");
    if (!table || table->count == 0) return;
    regime_interval *intervals = malloc(table->count * sizeof *intervals);
    if (!intervals) return;
    const size_t count = regime_intervals(table, result->contact_count, intervals, table->count);
    char label[LABEL_SIZE];
    parameter_label(result, table->parameter, label, sizeof label);
    if (count == 0) {
        free(intervals);
        return;
    }
    const bool branches = intervals[0].branch != intervals[count - 1].branch;
    size_t windows = 0;
    for (size_t i = 1; i < count; i++)
        windows += intervals[i].count < SHORT_INTERVAL && intervals[i - 1].count < SHORT_INTERVAL;
    fputs("<h3>Regimes along the sweep</h3>\n", to->stream);
    write_interval_head(to->stream, label);
    write_merged(to->stream, table, intervals, count, branches);
    fputs("</tbody></table></div>\n", to->stream);
    if (windows > 0) {
        fprintf(to->stream, "<details><summary>All %zu intervals</summary>\n", count);
        write_interval_head(to->stream, label);
        for (size_t i = 0; i < count; i++) write_interval(to->stream, table, &intervals[i], branches);
        fputs("</tbody></table></div></details>\n", to->stream);
    }
    free(intervals);
}

// ---------------------------------------------------------------- points

static void write_number(FILE *stream, const char *format, double value, int rows) {
    fputs("<td class=\"number\"", stream);
    if (rows > 1) fprintf(stream, " rowspan=\"%d\"", rows);
    fputs(">", stream);
    if (isnan(value))
        fputs("&ndash;", stream);
    else {
        char text[64];
        snprintf(text, sizeof text, format, value);
        html_text(stream, text);
    }
    fputs("</td>", stream);
}

static void write_lines(FILE *stream, numbers lines) {
    fputs("<td class=\"wide\">", stream);
    for (size_t i = 0; i < lines.rows && i < SHOWN_LINES; i++) {
        const double *line = &lines.at[5 * i];
        html_printf(stream, "%s%.4g:\u00a0%.3g", i ? ", " : "", line[0], fmax(line[1], line[2]));
    }
    if (!lines.at) fputs("&ndash;", stream);
    fputs("</td>", stream);
}

/// "high", and what the second tolerance says where it was asked.
static void write_confidence(FILE *stream, const whirl_verdict *verdict) {
    char other[WHIRL_NAME_SIZE];
    const whirl_verdict second = {.regime = verdict->other_regime, .period = verdict->other_period};
    html_text(stream, whirl_confidence_name(verdict->confidence));
    if (!verdict->confirmed) return;
    regime_name(&second, other, sizeof other);
    fputs("<br><span class=\"soft\">second tolerance: ", stream);
    html_text(stream, other);
    fputs("</span>", stream);
}

/// Why the verdict is what it is, and what would settle it where it is in doubt.
static void write_reason(FILE *stream, const whirl_verdict *verdict, int columns) {
    char text[512];
    reason_text(verdict, text, sizeof text);
    fprintf(stream, "<tr class=\"reason\"><td></td><td colspan=\"%d\">", columns - 1);
    html_text(stream, text);
    whirl_verdict_advice(verdict, text, sizeof text);
    if (verdict->confidence == WHIRL_LOW && *text) html_printf(stream, ". To settle it, %s.", text);
    fputs("</td></tr>\n", stream);
}

/// All exponents with their sum and what it is exactly, where they were computed.
static void write_exponents(FILE *stream, const whirl_table *table, size_t point, int columns) {
    const numbers values = point_numbers(table, point, "exponents/values", 0);
    const numbers errors = point_numbers(table, point, "exponents/errors", 0);
    const numbers sum = point_numbers(table, point, "exponents/sum", 0);
    const numbers exact = point_numbers(table, point, "exponents/sum_exact", 0);
    const numbers dimension = point_numbers(table, point, "exponents/dimension", 0);
    if (!values.at || !errors.at || errors.rows < values.rows) return;
    fprintf(stream, "<tr class=\"reason\"><td></td><td colspan=\"%d\">exponents ", columns - 1);
    for (size_t i = 0; i < values.rows; i++) {
        const shown_estimate shown = estimate_shown((whirl_estimate){values.at[i], errors.at[i]});
        fprintf(stream, "%s%.*f&nbsp;&plusmn;&nbsp;%.*f", i ? ", " : "", shown.decimals, shown.value, shown.decimals,
                shown.error);
    }
    if (sum.at && exact.at) html_printf(stream, "; their sum %.6f, exactly %.6f", sum.at[0], exact.at[0]);
    if (dimension.at) html_printf(stream, "; Kaplan-Yorke dimension %.3g", dimension.at[0]);
    fputs("</td></tr>\n", stream);
}

/// The columns that belong to the point and stretch over the rows of its stations.
static void write_point_columns(FILE *stream, const whirl_table *table, size_t point, const whirl_result *result) {
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    const shown_estimate exponent = estimate_shown(point_exponent(table, point));
    const int rows = (int)result->station_count;
    char text[LABEL_SIZE];
    fprintf(stream, "<th rowspan=\"%d\">", rows);
    if (*table->parameter)
        html_printf(stream, "%.6g", table->values[point]);
    else
        html_text(stream, table->name);
    fprintf(stream, "</th><td class=\"whole\" rowspan=\"%d\">", rows);
    write_swatch(stream, regime_class_of(&verdict));
    whirl_verdict_name(&verdict, text, sizeof text);
    html_text(stream, text);
    fprintf(stream, "</td><td class=\"whole\" rowspan=\"%d\">", rows);
    write_confidence(stream, &verdict);
    fprintf(stream, "</td><td class=\"number\" rowspan=\"%d\">", rows);
    if (isnan(exponent.value))
        fputs("&ndash;", stream);
    else
        fprintf(stream, "%.*f&nbsp;&plusmn;&nbsp;%.*f", exponent.decimals, exponent.value, exponent.decimals,
                exponent.error);
    fputs("</td>", stream);
    write_number(stream, "%.3g %%", 100.0 * rub_share(table, point, result->contact_count), rows);
}

/// Whether any station is a journal.
static bool has_bearing(const whirl_result *result) {
    bool found = false;
    for (size_t s = 0; s < result->station_count; s++) found = found || result->stations[s].clearance > 0.0;
    return found;
}

/// Whether any station may touch a stator.
static bool has_gap(const whirl_result *result) {
    bool found = false;
    for (size_t s = 0; s < result->station_count; s++) found = found || result->stations[s].gap > 0.0;
    return found;
}

static void write_point(FILE *stream, const whirl_table *table, size_t point, const whirl_result *result) {
    for (size_t s = 0; s < result->station_count; s++) {
        const double clearance = result->stations[s].clearance, gap = result->stations[s].gap;
        const double radius = max_radius(table, point, s);
        fputs("<tr class=\"open\">", stream);
        if (s == 0) write_point_columns(stream, table, point, result);
        fputs("<td>", stream);
        html_text(stream, result->stations[s].name);
        fputs("</td>", stream);
        write_number(stream, "%.4f", radius, 1);
        if (has_bearing(result)) write_number(stream, "%.4f", clearance > 0.0 ? radius / clearance : (double)NAN, 1);
        if (has_gap(result)) write_number(stream, "%.4f", gap > 0.0 ? radius / gap : (double)NAN, 1);
        write_number(stream, "%.3g %%", 100.0 * backward_share(table, point, s), 1);
        write_lines(stream, point_lines(table, point, s));
        fputs("</tr>\n", stream);
    }
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    const int columns = 11 - !has_bearing(result) - !has_gap(result);
    write_reason(stream, &verdict, columns);
    write_exponents(stream, table, point, columns);
}

void page_points(const page *to, size_t index) {
    const whirl_result *result = to->results[index];
    const whirl_table *table = detail_table(result);
    if (!table || table->count == 0 || result->station_count == 0) return;
    char label[LABEL_SIZE], length[LABEL_SIZE];
    parameter_label(result, table->parameter, label, sizeof label);
    length_symbol(result, length, sizeof length);
    fputs("<h3>Points in detail</h3>\n<div class=\"scroll\"><table>\n<thead><tr><th>", to->stream);
    html_text(to->stream, *table->parameter ? label : "Point");
    fputs("</th><th>Regime</th><th>Confidence</th><th class=\"number\">Largest exponent<br>(1/revolution)</th>"
          "<th class=\"number\">Time in<br>contact</th><th>Station</th><th class=\"number\">Largest<br>radius / ",
          to->stream);
    html_text(to->stream, length);
    fputs("</th>", to->stream);
    if (has_bearing(result)) fputs("<th class=\"number\">Largest<br>eccentricity</th>", to->stream);
    if (has_gap(result)) fputs("<th class=\"number\">Largest<br>radius / gap</th>", to->stream);
    fputs("<th class=\"number\">Time against<br>the rotation</th><th>Largest lines (order: larger amplitude of x and y "
          "/ ",
          to->stream);
    html_text(to->stream, length);
    fputs(")</th></tr></thead>\n<tbody>\n", to->stream);
    for (size_t i = 0; i < table->count; i++)
        if (whirl_table_done(table, i)) write_point(to->stream, table, i, result);
    fputs("</tbody></table></div>\n<p class=\"soft small\">", to->stream);
    fputs(
        "Time against the rotation: the share of the time in which the station moves backward about the centre (0, 0), "
        "x&nbsp;y\u2032&nbsp;\u2212&nbsp;y&nbsp;x\u2032&nbsp;&lt;&nbsp;0; an orbit beside the centre does so for about "
        "half "
        "of the time, whatever its sense. The exponent in the reason is that of the evidence, which may be averaged "
        "in another way than the one in the table.</p>\n",
        to->stream);
}
