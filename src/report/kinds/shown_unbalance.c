// How responses to unbalance are shown.
#include <math.h>
#include <stdlib.h>

#include "page.h"
#include "shown_kinds.h"
#include "summary.h"

enum { PLACED_TEXT = 1024 };

/// "    45 deg: peak at 2480.1 rpm, 0.034 mm 0-p, amplification 8.21 (half power); margin ...".
static void print_peaks(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t station) {
    const whirl_result *result = units->result;
    margin_row rows[2 * MARGIN_PEAKS];
    const size_t count = margin_rows(result, table, units, station, rows);
    for (const margin_row *row = rows; row < rows + count; row++)
        fprintf(out, "    %.4g deg: peak at %.6g %s, %.4g %s %s, amplification %.4g (%s)%s%s\n", row->probe, row->speed,
                margin_speed_unit(units).name, row->amplitude, summary_length_unit(units).name, units->amplitude_name,
                row->amplification, row->way, *row->text ? "; " : "", row->text);
}

static const double degree = 3.14159265358979323846 / 180.0;

/// "4.93 kg mm at disc1 (0 deg), ...": unbalances by rule; "" where the machine has its own.
static void list_placed(const whirl_result *result, const whirl_table *table, char *text, size_t size) {
    size_t used = 0;
    *text = '\0';
    for (size_t station = 0; station < result->station_count && used < size; station++) {
        const double *at = table->count > 0 ? whirl_table_field(table, 0, WHIRL_FIELD_UNBALANCE_PLACED, station) : NULL;
        if (!at || !(hypot(at[0], at[1]) > 0.0)) continue;
        used += (size_t)snprintf(text + used, size - used, "%s%.5g kg mm at %s (%.4g deg)", used ? ", " : "",
                                 1e3 * hypot(at[0], at[1]), result->stations[station].name,
                                 fabs(atan2(at[1], at[0]) / degree));
    }
}

/// "  scaled by 2.1: ..." and a line for every clearance.
static void print_scaled(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const whirl_result *result = units->result;
    const whirl_unit speed = margin_speed_unit(units), length = scaled_unit(units);
    char more[SCALED_TEXT];
    scaled by;
    scaled_row *rows = malloc((result->station_count + 1) * sizeof *rows);
    if (rows && scaled_of(result, table, &by)) {
        scaled_told(units, &by, more);
        fprintf(
            out,
            "  vibration limit %.4g %s p-p; largest at a probe where it runs %.4g %s p-p (%s): responses are scaled "
            "by %.4g%s\n",
            by.limit / length.size, length.name, by.largest / length.size, length.name,
            result->stations[by.station].name, by.factor, more);
        const size_t count = scaled_rows(result, table, &by, rows);
        for (const scaled_row *row = rows; row < rows + count; row++)
            fprintf(out,
                    "    %s: scaled major axis %.4g %s p-p at %.6g %s, %.3g %% of the diametral clearance %.4g %s, "
                    "75 %% allowed: %s\n",
                    result->stations[row->station].name, row->axis / length.size, length.name, row->speed / speed.size,
                    speed.name, 100.0 * row->axis / row->clearance, row->clearance / length.size, length.name,
                    row->holds ? "holds" : "fails");
    } else if (margin_asked(table)) {
        fprintf(out, "  responses are not scaled: %s\n", scaled_lacks);
    }
    free(rows);
}

/// "  separation margin: fails: 2 of 6 peaks", of all that is asked of responses.
static void print_asked(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const asked_rows all = asked_of(units, table);
    for (const asked_row *row = all.rows; row < all.rows + all.count; row++)
        fprintf(out, "  %s%s%s%s%s: %s\n", row->what, *row->asked ? ", " : "", row->asked, *row->found ? ": " : "",
                row->found, row->told);
}

/// The largest response of every station, and where, and its peaks.
static void summarize(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const whirl_result *result = units->result;
    char placed[PLACED_TEXT];
    list_placed(result, table, placed, sizeof placed);
    if (*placed) fprintf(out, "  unbalances by rule: %s\n", placed);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_UNBALANCE_SEEN))
        fprintf(out, "  compensated for runout; what probes read with it is " WHIRL_FIELD_UNBALANCE_SEEN "\n");
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter), length = summary_length_unit(units);
    for (size_t station = 0; station < result->station_count; station++) {
        double largest = 0.0;
        size_t where = 0;
        for (size_t point = 0; point < table->count; point++) {
            const double *axes = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_AXES, station);
            if (!whirl_table_done(table, point) || !axes || !(axes[0] > largest)) continue;
            largest = axes[0];
            where = point;
        }
        if (largest == 0.0) {
            fprintf(out, "  %s: no response\n", result->stations[station].name);
            continue;
        }
        fprintf(out, "  %s: largest response %.4g %s %s", result->stations[station].name,
                units->amplitude * largest * whirl_result_length_scale(result, table, where) / length.size, length.name,
                units->amplitude_name);
        if (table->parameter[0])
            fprintf(out, " at %.6g%s%s", table->values[where] / unit.size, *unit.name ? " " : "", unit.name);
        fputc('\n', out);
        print_peaks(out, units, table, station);
    }
    print_scaled(out, units, table);
    print_asked(out, units, table);
}

/// What scaled responses take of clearances, and the unbalances that they are by.
static void write_scaled(const page *to, size_t index, const whirl_table *table) {
    const whirl_result *result = to->results[index];
    const whirl_unit speed = margin_speed_unit(&to->units[index]), length = scaled_unit(&to->units[index]);
    char placed[PLACED_TEXT], more[SCALED_TEXT];
    scaled by;
    scaled_row *rows = malloc((result->station_count + 1) * sizeof *rows);
    list_placed(result, table, placed, sizeof placed);
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_UNBALANCE_SEEN))
        fputs("<p>Responses are compensated for runout; what probes read with it is <code>" WHIRL_FIELD_UNBALANCE_SEEN
              "</code>.</p>\n",
              to->stream);
    if (*placed) {
        fputs("<p>Unbalances by rule, in the place of the machine's own: ", to->stream);
        html_text(to->stream, placed);
        fputs(".</p>\n", to->stream);
    }
    if (rows && scaled_of(result, table, &by)) {
        scaled_told(&to->units[index], &by, more);
        fprintf(
            to->stream,
            "<p>The vibration limit is %.4g %s p-p, the largest that a probe sees where the machine runs %.4g %s p-p: "
            "responses are scaled by %.4g (6 at most)%s.</p>\n",
            by.limit / length.size, length.name, by.largest / length.size, length.name, by.factor, more);
        html_table(to->stream, "Scaled responses and clearances", "");
        fprintf(to->stream,
                "<thead><tr><th>station</th><th class=\"number\">major axis (%s p-p)</th><th class=\"number\">speed "
                "(%s)</th><th class=\"number\">diametral clearance (%s)</th><th class=\"number\">share (%%)</th>"
                "<th>75 %% allowed</th></tr></thead>\n<tbody>\n",
                length.name, speed.name, length.name);
        const size_t count = scaled_rows(result, table, &by, rows);
        for (const scaled_row *row = rows; row < rows + count; row++) {
            fputs("<tr><th>", to->stream);
            html_text(to->stream, result->stations[row->station].name);
            fprintf(to->stream,
                    "</th><td class=\"number\">%.4g</td><td class=\"number\">%.6g</td><td class=\"number\">%.4g</td>"
                    "<td class=\"number\">%.3g</td><td>%s</td></tr>\n",
                    row->axis / length.size, row->speed / speed.size, row->clearance / length.size,
                    100.0 * row->axis / row->clearance, row->holds ? "holds" : "fails");
        }
        fputs("</tbody></table></div>\n", to->stream);
    } else if (margin_asked(table)) {
        fprintf(to->stream, "<p>Responses are not scaled: %s.</p>\n", scaled_lacks);
    }
    free(rows);
}

static void section(const page *to, size_t index, const whirl_table *table) {
    const whirl_shown_units *units = &to->units[index];
    const whirl_result *result = to->results[index];
    const whirl_unit length = summary_length_unit(units);
    const bool running = margin_asked(table);
    margin_row rows[2 * MARGIN_PEAKS];
    html_table(to->stream, "Peaks of the response", "");
    fprintf(to->stream,
            "<thead><tr><th>station</th><th class=\"number\">probe (deg)</th><th class=\"number\">speed (%s)</th>"
            "<th class=\"number\">amplitude (",
            margin_speed_unit(units).name);
    html_text(to->stream, length.name);
    fputc(' ', to->stream);
    html_text(to->stream, units->amplitude_name);
    fprintf(to->stream, ")</th><th class=\"number\">amplification</th><th>found by</th>%s</tr></thead>\n<tbody>\n",
            running ? "<th>margin</th>" : "");
    for (size_t station = 0; station < result->station_count; station++) {
        const size_t count = margin_rows(result, table, units, station, rows);
        for (const margin_row *row = rows; row < rows + count; row++) {
            fputs("<tr><th>", to->stream);
            html_text(to->stream, result->stations[station].name);
            fprintf(to->stream,
                    "</th><td class=\"number\">%.4g</td><td class=\"number\">%.6g</td><td class=\"number\">%.4g</td>"
                    "<td class=\"number\">%.4g</td><td>%s</td>",
                    row->probe, row->speed, row->amplitude, row->amplification, row->way);
            fprintf(to->stream, running ? "<td>%s</td></tr>\n" : "%s</tr>\n", row->text);
        }
    }
    fputs("</tbody></table></div>\n", to->stream);
    write_scaled(to, index, table);
}

const shown_kind shown_unbalance = {
    .field = WHIRL_FIELD_UNBALANCE_AMPLITUDE,
    .anchor = "peaks",
    .name = "Peaks of the response",
    .about = "Critical speeds as peaks of all stations, as probes there see them, with the amplification "
             "factor, speed over the width at half power, and, where the running "
             "speeds are said, the separation margin after API 617 (which edition "
             "counts is for the user to check).",
    .explored = true,
    .found = margin_asked,
    .summarize = summarize,
    .section = section};
