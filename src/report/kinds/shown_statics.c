// How statics are shown: a line a station.
#include <math.h>
#include <stdio.h>

#include "html.h"
#include "shown_kinds.h"
#include "summary.h"

/// The numbers of a station as they are told.
typedef struct row {
    double load, deflection, slope, moment, elevation, mass[2]; ///< N, shown length, mrad, N m, shown length, kg
} row;

static double number(const whirl_table *table, size_t point, const char *field, size_t station, size_t column) {
    const double *at = whirl_table_field(table, point, field, station);
    return at ? at[column] : (double)NAN;
}

static row row_of(const whirl_result *result, const whirl_table *table, size_t point, size_t station, double unit) {
    const double length = whirl_result_length_scale(result, table, point) / unit;
    return (row){.load = number(table, point, WHIRL_FIELD_STATICS_LOAD, station, 0),
                 .deflection = length * number(table, point, WHIRL_FIELD_STATICS_DEFLECTION, station, 0),
                 .slope = 1e3 * number(table, point, WHIRL_FIELD_STATICS_SLOPE, station, 0),
                 .moment = number(table, point, WHIRL_FIELD_STATICS_MOMENT, station, 0),
                 .elevation = length * number(table, point, WHIRL_FIELD_STATICS_ELEVATION, station, 0),
                 .mass = {number(table, point, WHIRL_FIELD_STATICS_MASS, station, 0),
                          number(table, point, WHIRL_FIELD_STATICS_MASS, station, 1)}};
}

static void print_point(FILE *out, const whirl_result *result, const whirl_table *table, size_t point) {
    const whirl_shown_units units = summary_units(result);
    const whirl_unit length = summary_length_unit(&units);
    for (size_t station = 0; station < result->station_count; station++) {
        const row at = row_of(result, table, point, station, length.size);
        if (isnan(at.deflection)) continue;
        fprintf(out, "    %s: %.4g %s up, slope %.4g mrad, bending moment %.5g N m", result->stations[station].name,
                at.deflection, length.name, at.slope, at.moment);
        if (isfinite(at.load)) fprintf(out, "; bearing carries %.6g N", at.load);
        if (isfinite(at.elevation) && *table->record.coupling)
            fprintf(out, ", raised by %.6g %s", at.elevation, length.name);
        fputc('\n', out);
    }
}

/// Of several points the first and the last.
static void summarize(FILE *out, const whirl_result *result, const whirl_table *table) {
    const whirl_unit unit = whirl_result_unit(result, table->parameter);
    if (*table->record.coupling) fprintf(out, "  aligned for no moment and no shear at %s\n", table->record.coupling);
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point) || (point > 0 && point + 1 < table->count)) continue;
        if (*table->parameter)
            fprintf(out, "  at %.6g%s%s:\n", table->values[point] / unit.size, *unit.name ? " " : "", unit.name);
        print_point(out, result, table, point);
    }
}

static void write_cell(FILE *stream, double value) {
    if (isfinite(value))
        fprintf(stream, "<td class=\"number\">%.6g</td>", value);
    else
        fputs("<td></td>", stream);
}

static void section(const page *to, size_t index, const whirl_table *table) {
    const whirl_result *result = to->results[index];
    const whirl_unit length = summary_length_unit(&to->units[index]);
    fputs("<p>What the weight does to each shaft on its own bearings, which hold it without giving way, "
          "whatever couplings, springs and mounts it has",
          to->stream);
    fputs(*table->record.coupling ? ", raised for no moment and no shear at " : "", to->stream);
    html_text(to->stream, table->record.coupling);
    fputs(*table->parameter ? "; of the first point.</p>\n" : ".</p>\n", to->stream);
    html_table(to->stream, "Weight, loads of bearings and sag", "");
    fprintf(to->stream,
            "<thead><tr><th>station</th><th class=\"number\">load (N)</th><th class=\"number\">elevation (%s)</th>"
            "<th class=\"number\">deflection upwards (%s)</th><th class=\"number\">slope (mrad)</th>"
            "<th class=\"number\">bending moment (N m)</th><th class=\"number\">mass to the left (kg)</th>"
            "<th class=\"number\">mass to the right (kg)</th></tr></thead>\n<tbody>\n",
            length.name, length.name);
    for (size_t station = 0; station < result->station_count && table->count > 0; station++) {
        const row at = row_of(result, table, 0, station, length.size);
        if (isnan(at.deflection)) continue;
        fputs("<tr><th>", to->stream);
        html_text(to->stream, result->stations[station].name);
        fputs("</th>", to->stream);
        const double cells[] = {at.load, at.elevation, at.deflection, at.slope, at.moment, at.mass[0], at.mass[1]};
        for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) write_cell(to->stream, cells[i]);
        fputs("</tr>\n", to->stream);
    }
    fputs("</tbody></table></div>\n", to->stream);
}

const shown_kind shown_statics = {.field = WHIRL_FIELD_STATICS_LOAD,
                                  .anchor = "statics",
                                  .name = "Weight and loads of bearings",
                                  .single = true,
                                  .summarize = summarize,
                                  .section = section};
