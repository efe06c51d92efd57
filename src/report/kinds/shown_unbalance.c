// How responses to unbalance are shown.
#include "html.h"
#include "margins.h"
#include "shown_kinds.h"
#include "summary.h"

/// "    45 deg: peak at 2480.1 rpm, 0.034 mm 0-p, amplification 8.21 (half power); margin ...".
static void print_peaks(FILE *out, const whirl_result *result, const whirl_table *table, const whirl_shown_units *units,
                        size_t station) {
    margin_row rows[2 * MARGIN_PEAKS];
    const size_t count = margin_rows(result, table, units, station, rows);
    for (const margin_row *row = rows; row < rows + count; row++)
        fprintf(out, "    %.4g deg: peak at %.6g rpm, %.4g %s %s, amplification %.4g (%s)%s%s\n", row->probe,
                row->speed, row->amplitude, summary_length_unit(units).name, units->amplitude_name, row->amplification,
                row->way, *row->text ? "; " : "", row->text);
}

/// The largest response of every station, and where, and its peaks.
static void summarize(FILE *out, const whirl_result *result, const whirl_table *table) {
    const whirl_shown_units units = summary_units(result);
    const whirl_unit unit = whirl_shown_parameter(&units, table->parameter), length = summary_length_unit(&units);
    for (size_t station = 0; station < result->station_count; station++) {
        double largest = 0.0;
        size_t where = 0;
        for (size_t point = 0; point < table->count; point++) {
            const double *axes = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_AXES, station);
            if (!whirl_table_done(table, point) || !axes || !(axes[0] > largest)) continue;
            largest = axes[0];
            where = point;
        }
        fprintf(out, "  %s: largest response %.4g %s %s", result->stations[station].name,
                units.amplitude * largest * whirl_result_length_scale(result, table, where) / length.size, length.name,
                units.amplitude_name);
        if (table->parameter[0])
            fprintf(out, " at %.6g%s%s", table->values[where] / unit.size, *unit.name ? " " : "", unit.name);
        fputc('\n', out);
        print_peaks(out, result, table, &units, station);
    }
}

static void section(const page *to, size_t index, const whirl_table *table) {
    const whirl_shown_units *units = &to->units[index];
    const whirl_result *result = to->results[index];
    const whirl_unit length = summary_length_unit(units);
    const bool running = table->record.running_low > 0.0 || table->record.running_high > 0.0;
    margin_row rows[2 * MARGIN_PEAKS];
    fputs("<p>Critical speeds as peaks that the probes see, with the amplification factor, speed over the width at "
          "half power, and, where the running speeds are said, the separation margin after API 617 (which edition "
          "counts is for the user to check).</p>\n",
          to->stream);
    html_table(to->stream, "Peaks of the response", "");
    fputs("<thead><tr><th>station</th><th class=\"number\">probe (deg)</th><th class=\"number\">speed (rpm)</th>"
          "<th class=\"number\">amplitude (",
          to->stream);
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
            fprintf(to->stream, "</th><td>%.4g</td><td>%.6g</td><td>%.4g</td><td>%.4g</td><td>%s</td>", row->probe,
                    row->speed, row->amplitude, row->amplification, row->way);
            fprintf(to->stream, running ? "<td>%s</td></tr>\n" : "%s</tr>\n", row->text);
        }
    }
    fputs("</tbody></table></div>\n", to->stream);
}

const shown_kind shown_unbalance = {.field = WHIRL_FIELD_UNBALANCE_AMPLITUDE,
                                    .anchor = "peaks",
                                    .name = "Peaks of the response",
                                    .explored = true,
                                    .summarize = summarize,
                                    .section = section};
