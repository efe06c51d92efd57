// How responses to unbalance are shown.
#include <math.h>

#include "html.h"
#include "margins.h"
#include "shown_kinds.h"
#include "summary.h"

static const double rpm = 0.104719755119659774, degree = 3.14159265358979323846 / 180.0;

/// "    45 deg: peak at 2480.1 rpm, 0.034 mm 0-p, amplification 8.21 (half power); margin ...".
static void print_peaks(FILE *out, const whirl_result *result, const whirl_table *table, size_t station) {
    const whirl_shown_units units = summary_units(result);
    const whirl_unit length = summary_length_unit(&units);
    whirl_response_peak peaks[MARGIN_PEAKS];
    for (size_t probe = 0; probe < 2; probe++) {
        const size_t count = margin_peaks(table, station, probe, peaks);
        for (size_t i = 0; i < count; i++) {
            char margin[MARGIN_TEXT], way[MARGIN_TEXT];
            margin_text(table, &peaks[i], margin);
            margin_way(&peaks[i], way);
            fprintf(out, "    %.4g deg: peak at %.6g rpm, %.4g %s %s, amplification %.4g (%s)%s%s\n",
                    table->record.probe_angle / degree + (probe ? 90.0 : 0.0), peaks[i].speed / rpm,
                    units.amplitude * peaks[i].amplitude * result->length_scale / length.size, length.name,
                    units.amplitude_name, peaks[i].amplification, way, *margin ? "; " : "", margin);
        }
    }
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
        print_peaks(out, result, table, station);
    }
}

static void section(const page *to, size_t index, const whirl_table *table) {
    const whirl_shown_units *units = &to->units[index];
    const whirl_result *result = to->results[index];
    const whirl_unit length = summary_length_unit(units);
    const bool running = table->record.running_low > 0.0 || table->record.running_high > 0.0;
    whirl_response_peak peaks[MARGIN_PEAKS];
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
    for (size_t k = 0; k < 2 * result->station_count; k++) {
        const size_t count = margin_peaks(table, k / 2, k % 2, peaks);
        for (size_t i = 0; i < count; i++) {
            char margin[MARGIN_TEXT], way[MARGIN_TEXT];
            margin_text(table, &peaks[i], margin);
            margin_way(&peaks[i], way);
            fputs("<tr><th>", to->stream);
            html_text(to->stream, result->stations[k / 2].name);
            fprintf(to->stream, "</th><td>%.4g</td><td>%.6g</td><td>%.4g</td><td>%.4g</td><td>%s</td>",
                    table->record.probe_angle / degree + (k % 2 ? 90.0 : 0.0), peaks[i].speed / rpm,
                    units->amplitude * peaks[i].amplitude * result->length_scale / length.size, peaks[i].amplification,
                    way);
            fprintf(to->stream, running ? "<td>%s</td></tr>\n" : "%s</tr>\n", running ? margin : "");
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
