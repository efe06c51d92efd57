// How stability is shown: decrements, the limit of the cross coupling, and whether seals are to be counted.
#include <math.h>
#include <stdio.h>

#include "page.h"
#include "shown_kinds.h"
#include "summary.h"

static const double two_pi = 6.283185307179586476925;

static double number(const whirl_table *table, size_t point, const char *field) {
    return whirl_table_number(table, point, field, 0);
}

/// The critical speed ratio and, where the density of the gas is said, the region.
static void print_screening(FILE *out, const whirl_table *table, size_t point) {
    const double ratio = number(table, point, WHIRL_FIELD_STABILITY_RATIO);
    const double region = number(table, point, WHIRL_FIELD_STABILITY_REGION);
    if (!isfinite(ratio)) return;
    fprintf(out, "    critical speed ratio %.4g: first critical speed on rigid supports %.6g rpm", ratio,
            number(table, point, WHIRL_FIELD_STABILITY_RIGID) * 60.0 / two_pi);
    if (isfinite(region))
        fprintf(out, "; gas of %.4g kg/m3: region %c", number(table, point, WHIRL_FIELD_STABILITY_DENSITY),
                region > 0.5 ? 'B' : 'A');
    fputc('\n', out);
}

static void print_point(FILE *out, const whirl_shown_units *units, const whirl_table *table, size_t point) {
    const whirl_result *result = units->result;
    char text[ASKED_TEXT];
    const asked_stability at = asked_stability_at(table, point);
    asked_stability_told(&at, text);
    if (isnan(at.decrement)) {
        fprintf(out, "    %s\n", text);
        return;
    }
    const double basic = number(table, point, WHIRL_FIELD_STABILITY_BASIC);
    fprintf(out,
            isnan(basic) ? "    logarithmic decrement: bearings alone none, as no mode swings"
                         : "    logarithmic decrement: bearings alone %.4g",
            basic);
    if (at.stages) fprintf(out, ", with stages %.4g", at.decrement);
    fprintf(out, " (at %.5g Hz)", number(table, point, WHIRL_FIELD_STABILITY_FREQUENCY) / two_pi);
    if (isfinite(at.complete)) fprintf(out, ", with seals and impellers %.4g", at.complete);
    fputc('\n', out);
    if (at.stages && isfinite(at.ratio))
        fprintf(out, "    cross coupling: anticipated %.6g N/m, limit %.6g N/m, %.4g times as much\n", at.anticipated,
                at.limit, at.ratio);
    else if (at.stages)
        fprintf(out, "    cross coupling: anticipated %.6g N/m, no limit below 1000 times as much\n", at.anticipated);
    else
        fputs("    cross coupling: none is anticipated without stages, so that no limit is found\n", out);
    print_screening(out, table, point);
    for (size_t station = 0; station < result->station_count; station++) {
        const double *own = whirl_table_field(table, point, WHIRL_FIELD_STABILITY_PART, station);
        if (own && isfinite(*own))
            fprintf(out, "    bearings and what is at %s: %.4g\n", result->stations[station].name, *own);
    }
    fprintf(out, "    %s\n", text);
}

static void summarize(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    summary_ends(out, units, table, print_point);
}

/// Decrements with bearings and what is at one station alone: a row a station, a column a point.
static void write_parts(const page *to, size_t index, const whirl_table *table) {
    const whirl_result *result = to->results[index];
    const whirl_unit unit = whirl_shown_parameter(&to->units[index], table->parameter);
    enum { MOST = 6 };
    const size_t step = 1 + (table->count - 1) / MOST;
    size_t count = 0;
    for (size_t station = 0; station < result->station_count && table->count > 0; station++) {
        bool any = false;
        for (size_t point = 0; point < table->count; point += step)
            any = any || isfinite(whirl_table_number(table, point, WHIRL_FIELD_STABILITY_PART, station));
        if (!any) continue;
        if (count++ == 0) {
            html_table(to->stream, "Decrements with single seals and impellers", "");
            fputs("<thead><tr><th>bearings, and seals and impellers at</th>", to->stream);
            for (size_t point = 0; point < table->count; point += step) {
                fputs("<th class=\"number\">", to->stream);
                if (*table->parameter)
                    html_printf(to->stream, "%.6g %s", table->values[point] / unit.size, unit.name);
                else
                    fputs("decrement", to->stream);
                fputs("</th>", to->stream);
            }
            fputs("</tr></thead>\n<tbody>\n", to->stream);
        }
        fputs("<tr><th>", to->stream);
        html_text(to->stream, result->stations[station].name);
        fputs("</th>", to->stream);
        for (size_t point = 0; point < table->count; point += step)
            html_number(to->stream, whirl_table_number(table, point, WHIRL_FIELD_STABILITY_PART, station));
        fputs("</tr>\n", to->stream);
    }
    if (count > 0) fputs("</tbody></table></div>\n", to->stream);
}

static void section(const page *to, size_t index, const whirl_table *table) {
    static const char *const shown[] = {WHIRL_FIELD_STABILITY_ANTICIPATED, WHIRL_FIELD_STABILITY_LIMIT,
                                        WHIRL_FIELD_STABILITY_BASIC,       WHIRL_FIELD_STABILITY_DECREMENT,
                                        WHIRL_FIELD_STABILITY_COMPLETE,    WHIRL_FIELD_STABILITY_RATIO,
                                        WHIRL_FIELD_STABILITY_DENSITY};
    const whirl_unit unit = whirl_shown_parameter(&to->units[index], table->parameter);
    html_table(to->stream, "Stability", "");
    fputs("<thead><tr><th>at</th><th class=\"number\">anticipated (N/m)</th><th class=\"number\">limit (N/m)</th>"
          "<th class=\"number\">bearings alone</th><th class=\"number\">with stages</th>"
          "<th class=\"number\">with seals and impellers</th><th class=\"number\">critical speed ratio</th>"
          "<th class=\"number\">gas (kg/m3)</th><th>region</th><th>what follows</th></tr></thead>\n<tbody>\n",
          to->stream);
    for (size_t point = 0; point < table->count; point++) {
        char text[ASKED_TEXT];
        if (!whirl_table_done(table, point)) continue;
        const asked_stability at = asked_stability_at(table, point);
        asked_stability_told(&at, text);
        if (*table->parameter)
            fprintf(to->stream, "<tr><th class=\"number\">%.6g %s</th>", table->values[point] / unit.size, unit.name);
        else
            fputs("<tr><th>the speed of the case</th>", to->stream);
        for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
            html_number(to->stream, number(table, point, shown[i]));
        fprintf(to->stream, "<td>%s</td>", !isfinite(at.region) ? "" : at.region > 0.5 ? "B" : "A");
        fputs("<td>", to->stream);
        html_text(to->stream, text);
        fputs("</td></tr>\n", to->stream);
    }
    fputs("</tbody></table></div>\n", to->stream);
    write_parts(to, index, table);
}

static bool is_found(const whirl_table *table) {
    (void)table;
    return true;
}

const shown_kind shown_stability = {.field = WHIRL_FIELD_STABILITY_BASIC,
                                    .anchor = "stability",
                                    .name = "Stability by decrements",
                                    .about = "The least logarithmic decrement of forward modes up to the speed, or of "
                                             "the first where that is faster: with bearings alone, with the cross "
                                             "coupling of stages (anticipated, and its limit, where the decrement is "
                                             "0), and with seals and impellers. After API 617 (which edition counts is "
                                             "for the user to check) bearings and stages tell enough where that limit "
                                             "is 2 times the anticipated or more, in region B of the screening diagram "
                                             "10 times or more, and the decrement 0.1 or more; else it is to be above "
                                             "0.1 with seals and impellers. The critical speed ratio is the speed over "
                                             "the first forward critical speed without damping on rigid supports.",
                                    .single = true,
                                    .found = is_found,
                                    .summarize = summarize,
                                    .section = section};
