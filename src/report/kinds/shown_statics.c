// How statics are shown: a line a station.
#include <math.h>
#include <stdio.h>

#include "page.h"
#include "shown_kinds.h"
#include "summary.h"

/// The numbers of a station as they are told.
typedef struct row {
    double load, deflection, slope, moment, elevation, mass[2]; ///< N, shown length, mrad, N m, shown length, kg
} row;

static row row_of(const whirl_result *result, const whirl_table *table, size_t point, size_t station, double unit) {
    const double length = whirl_result_length_scale(result, table, point) / unit;
    const double *mass = whirl_table_field(table, point, WHIRL_FIELD_STATICS_MASS, station);
    return (row){
        .load = whirl_table_number(table, point, WHIRL_FIELD_STATICS_LOAD, station),
        .deflection = length * whirl_table_number(table, point, WHIRL_FIELD_STATICS_DEFLECTION, station),
        .slope = 1e3 * whirl_table_number(table, point, WHIRL_FIELD_STATICS_SLOPE, station),
        .moment = whirl_table_number(table, point, WHIRL_FIELD_STATICS_MOMENT, station),
        .elevation = length * whirl_table_number(table, point, WHIRL_FIELD_STATICS_ELEVATION, station),
        .mass = {whirl_table_number(table, point, WHIRL_FIELD_STATICS_MASS, station), mass ? mass[1] : (double)NAN}};
}

/// Numbers of pads without a film, "2, 3".
static void print_unloaded(FILE *out, const whirl_table *table, size_t point, size_t station) {
    char digits[32] = "";
    const double unloaded = whirl_table_number(table, point, WHIRL_FIELD_STATICS_UNLOADED, station);
    if (unloaded > 0.0) snprintf(digits, sizeof digits, "%.0f", unloaded);
    for (const char *digit = digits; *digit; digit++) fprintf(out, "%s%c", digit > digits ? ", " : "", *digit);
}

/// Where the shaft rests in its film or stands in its seal.
static void print_film(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t point,
                       size_t station) {
    const whirl_result *result = units->result;
    const whirl_unit length = summary_length_unit(units);
    const double film = whirl_table_number(table, point, WHIRL_FIELD_STATICS_FILM, station);
    const double attitude = whirl_table_number(table, point, WHIRL_FIELD_STATICS_ATTITUDE, station);
    if (!isfinite(film)) return;
    const bool seal = whirl_table_number(table, point, WHIRL_FIELD_STATICS_SEAL, station) == 1.0;
    fprintf(out, "    %s: %s at eccentricity ratio %.4g", result->stations[station].name,
            seal ? "stands in its seal" : "rests in its film",
            whirl_table_number(table, point, WHIRL_FIELD_STATICS_ECCENTRICITY, station));
    if (isfinite(attitude)) fprintf(out, ", attitude %.4g deg", attitude);
    fprintf(out, ", least thickness %.4g %s", whirl_result_length_scale(result, table, point) / length.size * film,
            length.name);
    if (whirl_table_number(table, point, WHIRL_FIELD_STATICS_UNLOADED, station) > 0.0) {
        fputs("; no load on pads ", out);
        print_unloaded(out, table, point, station);
    }
    fputc('\n', out);
}

/// kxx, kxy, kyx, kyy in MN/m and cxx, cxy, cyx, cyy in kN s/m of the bearings of a station; false where there are
/// none.
static bool coefficients_of(const whirl_table *table, size_t point, size_t station, double out[8]) {
    const double *const k = whirl_table_field(table, point, WHIRL_FIELD_STATICS_STIFFNESS, station);
    const double *const c = whirl_table_field(table, point, WHIRL_FIELD_STATICS_DAMPING, station);
    if (!k || !c || isnan(*k)) return false;
    for (size_t i = 0; i < 4; i++) out[i] = 1e-6 * k[i], out[4 + i] = 1e-3 * c[i];
    return true;
}

static void print_coefficients(FILE *out, const char *name, const double own[8]) {
    fprintf(out, "    %s: stiffness xx %.4g, xy %.4g, yx %.4g, yy %.4g MN/m; damping %.4g, %.4g, %.4g, %.4g kN s/m\n",
            name, own[0], own[1], own[2], own[3], own[4], own[5], own[6], own[7]);
}

static void print_point(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t point) {
    const whirl_result *result = units->result;
    const whirl_unit length = summary_length_unit(units);
    for (size_t station = 0; station < result->station_count; station++) {
        const row at = row_of(result, table, point, station, length.size);
        double coefficients[8];
        print_film(out, units, table, point, station);
        if (coefficients_of(table, point, station, coefficients))
            print_coefficients(out, result->stations[station].name, coefficients);
        if (isnan(at.deflection)) continue;
        fprintf(out, "    %s: %.4g %s up, slope %.4g mrad, bending moment %.5g N m", result->stations[station].name,
                at.deflection, length.name, at.slope, at.moment);
        if (isfinite(at.load)) fprintf(out, "; bearing carries %.6g N", at.load);
        if (isfinite(at.elevation) && (*table->record.coupling || at.elevation != 0.0))
            fprintf(out, ", raised by %.6g %s", at.elevation, length.name);
        fputc('\n', out);
    }
}

static void summarize(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    if (*table->record.coupling) fprintf(out, "  aligned for no moment and no shear at %s\n", table->record.coupling);
    summary_ends(out, units, table, print_point);
}

/// Where shafts rest in their films and seals, if there are any.
static void write_films(const page *to, size_t index, const whirl_table *table) {
    const whirl_result *result = to->results[index];
    const whirl_unit length = summary_length_unit(&to->units[index]);
    const double scale = whirl_result_length_scale(result, table, 0) / length.size;
    size_t count = 0;
    for (size_t station = 0; station < result->station_count; station++) {
        const double film = whirl_table_number(table, 0, WHIRL_FIELD_STATICS_FILM, station);
        if (!isfinite(film)) continue;
        if (count++ == 0) {
            html_table(to->stream, "Shafts at rest in films and seals", "");
            fprintf(to->stream,
                    "<thead><tr><th>station</th><th>in</th><th class=\"number\">eccentricity ratio</th><th "
                    "class=\"number\">attitude "
                    "(deg)</th><th class=\"number\">least thickness (%s)</th><th>pads that carry "
                    "nothing</th></tr></thead>\n<tbody>\n",
                    length.name);
        }
        fputs("<tr><th>", to->stream);
        html_text(to->stream, result->stations[station].name);
        const bool seal = whirl_table_number(table, 0, WHIRL_FIELD_STATICS_SEAL, station) == 1.0;
        fputs(seal ? "</th><td>seal</td>" : "</th><td>film</td>", to->stream);
        html_number(to->stream, whirl_table_number(table, 0, WHIRL_FIELD_STATICS_ECCENTRICITY, station));
        html_number(to->stream, whirl_table_number(table, 0, WHIRL_FIELD_STATICS_ATTITUDE, station));
        html_number(to->stream, scale * film);
        fputs("<td>", to->stream);
        print_unloaded(to->stream, table, 0, station);
        fputs("</td></tr>\n", to->stream);
    }
    if (count > 0) fputs("</tbody></table></div>\n", to->stream);
}

static void begin_coefficients(FILE *stream) {
    fputs("<p>Stiffness and damping of bearings about where the machine rests: forces against displacements and "
          "velocities, kxy along x by y.</p>\n",
          stream);
    html_table(stream, "Coefficients of bearings", "");
    fputs("<thead><tr><th>at</th><th>bearing</th>", stream);
    for (size_t i = 0; i < 8; i++)
        fprintf(stream, "<th class=\"number\">%c%c%c (%s)</th>", i < 4 ? 'k' : 'c', i & 2u ? 'y' : 'x',
                i & 1u ? 'y' : 'x', i < 4 ? "MN/m" : "kN s/m");
    fputs("</tr></thead>\n<tbody>\n", stream);
}

/// A row a station, of all points that have any.
static void write_coefficients(const page *to, size_t index, const whirl_table *table) {
    const whirl_result *result = to->results[index];
    const whirl_unit unit = whirl_shown_parameter(&to->units[index], table->parameter);
    const size_t all = table->count * result->station_count;
    size_t count = 0;
    for (size_t n = 0; n < all; n++) {
        const size_t point = n / result->station_count, station = n % result->station_count;
        double own[8];
        if (!whirl_table_done(table, point) || !coefficients_of(table, point, station, own)) continue;
        if (count++ == 0) begin_coefficients(to->stream);
        fputs("<tr><th>", to->stream);
        if (*table->parameter)
            html_printf(to->stream, "%.6g %s", table->values[point] / unit.size, unit.name);
        else
            fputs("the speed of the case", to->stream);
        fputs("</th><td>", to->stream);
        html_text(to->stream, result->stations[station].name);
        fputs("</td>", to->stream);
        for (size_t i = 0; i < 8; i++) html_number(to->stream, own[i]);
        fputs("</tr>\n", to->stream);
    }
    if (count > 0) fputs("</tbody></table></div>\n", to->stream);
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
        for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) html_number(to->stream, cells[i]);
        fputs("</tr>\n", to->stream);
    }
    fputs("</tbody></table></div>\n", to->stream);
    if (table->count > 0) write_films(to, index, table);
    write_coefficients(to, index, table);
}

const shown_kind shown_statics = {.field = WHIRL_FIELD_STATICS_LOAD,
                                  .anchor = "statics",
                                  .name = "Weight and loads of bearings",
                                  .single = true,
                                  .held = "sag and loads leave out",
                                  .summarize = summarize,
                                  .section = section};
