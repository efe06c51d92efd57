// How tori are shown: quasi-periodic motions past Neimark-Sacker points, one row a branch of tori.
#include <math.h>

#include "page.h"
#include "quantities.h"
#include "report_parts.h"
#include "shown_kinds.h"

// ---------------------------------------------------------------- the summary

/// ", stable", ", unstable", ", 12 of them stable".
static void print_stability(FILE *out, const whirl_tori *own) {
    if (own->stable > 0 && own->stable < own->found)
        fprintf(out, ", %zu of them stable", own->stable);
    else
        fputs(own->stable > 0 ? ", stable" : ", unstable", out);
}

/// "rotation number 0.39865 to 0.41552; second line of disc, y: order 0.60135 to 0.58448".
static void print_lines(FILE *out, const whirl_shown_units *units, const whirl_table *table, const whirl_tori *own) {
    const whirl_result *result = units->result;
    fprintf(out, "      rotation number %.6g to %.6g",
            whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_ROTATION, 0),
            whirl_table_number(table, own->last, WHIRL_FIELD_TORUS_ROTATION, 0));
    if (own->station < result->station_count) {
        const double *first = whirl_table_field(table, own->first, WHIRL_FIELD_TORUS_FREQUENCY, own->station);
        const double *last = whirl_table_field(table, own->last, WHIRL_FIELD_TORUS_FREQUENCY, own->station);
        fprintf(out, "; second line of %s, %c: order %.6g to %.6g", result->stations[own->station].name,
                "xy"[own->axis], first[own->axis], last[own->axis]);
    }
    fputc('\n', out);
}

static void print_torus_end(FILE *out, const whirl_table *table, const whirl_unit *unit, size_t point) {
    const double *resonance = whirl_table_field(table, point, WHIRL_FIELD_TORUS_RESONANCE, 0);
    const double limit = whirl_table_number(table, point, WHIRL_FIELD_TORUS_LIMIT, 0);
    char text[WHIRL_MESSAGE_SIZE];
    whirl_torus_end_text(whirl_table_number(table, point, WHIRL_FIELD_TORUS_END, 0), resonance[0], resonance[1], text,
                         sizeof text);
    fprintf(out, "    %14.9g%s%s  %s", table->values[point] / unit->size, *unit->name ? " " : "", unit->name, text);
    if (isfinite(limit)) fprintf(out, " at %.6g", limit / unit->size);
    fputc('\n', out);
}

static void print_tori(FILE *out, const whirl_shown_units *units, const whirl_table *table, const whirl_unit *unit,
                       const whirl_tori *own) {
    fprintf(out, "  torus %.0f: ", whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_NUMBER, 0));
    if (own->found > 0) fprintf(out, "%zu point%s ", own->found, own->found == 1 ? "" : "s");
    fprintf(out, "from %.6g%s%s, where branch %.0f changes",
            whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_BEGINS, 0) / unit->size, *unit->name ? " " : "",
            unit->name, whirl_table_number(table, own->first, WHIRL_FIELD_TORUS_BRANCH, 0));
    if (own->found > 0) print_stability(out, own);
    fputc('\n', out);
    if (own->found > 0) print_lines(out, units, table, own);
    if (!isnan(whirl_table_number(table, own->last, WHIRL_FIELD_TORUS_END, 0)))
        print_torus_end(out, table, unit, own->last);
}

static void summarize(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    for (size_t point = 0; point < table->count; point++) {
        const whirl_tori own = whirl_table_tori(table, point);
        print_tori(out, units, table, &unit, &own);
        point = own.last;
    }
}

// ---------------------------------------------------------------- the page

/// A page under way, and one branch of tori: rows of the table.
typedef struct tori_view {
    const page *to;
    size_t index; ///< of the result
    const whirl_result *result;
    const whirl_table *table;
    const whirl_case *machine; ///< or NULL
    double unit;               ///< of the parameter
    whirl_tori own;
} tori_view;

/// "all", "none", "12 of 20".
static void write_stable(const tori_view *v) {
    if (v->own.stable == 0 || v->own.stable == v->own.found)
        fprintf(v->to->stream, "<td>%s</td>", v->own.stable ? "all" : "none");
    else
        fprintf(v->to->stream, "<td>%zu of %zu</td>", v->own.stable, v->own.found);
}

/// The frequency of the largest line, as an order or in the unit of frequencies.
static double shown_frequency(const tori_view *v, size_t point) {
    const whirl_shown_units *units = &v->to->units[v->index];
    const double order = whirl_table_field(v->table, point, WHIRL_FIELD_TORUS_FREQUENCY, v->own.station)[v->own.axis];
    const double size = units_order(units, machine_clock(v->machine, v->result, v->table, point));
    return isfinite(size) ? order * size : order;
}

static void write_line(const tori_view *v) {
    if (v->own.station >= v->result->station_count) {
        fputs("<td></td><td></td>", v->to->stream);
        return;
    }
    fprintf(v->to->stream, "<td class=\"number\">%.6g to %.6g</td><td>", shown_frequency(v, v->own.first),
            shown_frequency(v, v->own.last));
    html_text(v->to->stream, v->result->stations[v->own.station].name);
    fprintf(v->to->stream, " %c</td>", "xy"[v->own.axis]);
}

static void write_end(const tori_view *v) {
    const double *resonance = whirl_table_field(v->table, v->own.last, WHIRL_FIELD_TORUS_RESONANCE, 0);
    const double limit = point_number(v->table, v->own.last, WHIRL_FIELD_TORUS_LIMIT);
    char text[WHIRL_MESSAGE_SIZE];
    whirl_torus_end_text(point_number(v->table, v->own.last, WHIRL_FIELD_TORUS_END), resonance[0], resonance[1], text,
                         sizeof text);
    fprintf(v->to->stream, "<td class=\"number\">%.9g</td><td class=\"wide\">",
            v->table->values[v->own.last] / v->unit);
    html_text(v->to->stream, text);
    if (isfinite(limit)) fprintf(v->to->stream, ", at %.6g", limit / v->unit);
    fputs("</td></tr>\n", v->to->stream);
}

static void write_row(const tori_view *v) {
    FILE *stream = v->to->stream;
    fprintf(stream, "<tr><th class=\"number\">%.0f</th><td class=\"number\">%.9g</td><td class=\"number\">%.0f</td>",
            point_number(v->table, v->own.first, WHIRL_FIELD_TORUS_NUMBER),
            point_number(v->table, v->own.first, WHIRL_FIELD_TORUS_BEGINS) / v->unit,
            point_number(v->table, v->own.first, WHIRL_FIELD_TORUS_BRANCH));
    if (v->own.found > 0) {
        fprintf(stream, "<td class=\"number\">%.6g to %.6g</td>",
                point_number(v->table, v->own.first, WHIRL_FIELD_TORUS_ROTATION),
                point_number(v->table, v->own.last, WHIRL_FIELD_TORUS_ROTATION));
        write_line(v);
        write_stable(v);
        fprintf(stream, "<td class=\"number\">%zu</td>", v->own.found);
    } else {
        fputs("<td></td><td></td><td></td><td></td><td class=\"number\">0</td>", stream);
    }
    write_end(v);
}

static void write_head(const tori_view *v, const char *label) {
    FILE *stream = v->to->stream;
    const whirl_shown_units *units = &v->to->units[v->index];
    html_table(stream, "Quasi-periodic motions", "");
    fputs("<thead><tr><th class=\"number\">Torus</th><th class=\"number\">Begins at ", stream);
    html_text(stream, label);
    fputs("</th><th class=\"number\">Branch</th><th class=\"number\">Rotation number</th><th class=\"number\">",
          stream);
    html_printf(stream, units->frequency > 0.0 ? "Second frequency (%s)" : "Second frequency (order)%s",
                units->frequency > 0.0 ? units->frequency_name : "");
    fputs("</th><th>Largest at</th><th>Stable</th><th class=\"number\">Points</th><th class=\"number\">To</th>"
          "<th>Ends</th></tr></thead>\n<tbody>\n",
          stream);
}

static void section(const page *to, size_t index, const whirl_table *table) {
    const whirl_result *result = to->results[index];
    char label[UNIT_LABEL_SIZE];
    if (table->count == 0) {
        fputs("<p>Along the branches that were followed no torus begins.</p>\n", to->stream);
        return;
    }
    whirl_case *machine = machine_of(result);
    tori_view v = {.to = to, .index = index, .result = result, .table = table, .machine = machine};
    v.unit = whirl_shown_parameter(&to->units[index], table->parameter).size;
    units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
    write_head(&v, label);
    for (size_t point = 0; point < table->count; point = v.own.last + 1) {
        v.own = whirl_table_tori(table, point);
        write_row(&v);
    }
    fputs("</tbody></table></div>\n", to->stream);
    whirl_case_free(machine);
}

const shown_kind shown_tori = {.field = WHIRL_FIELD_TORUS_NUMBER,
                               .anchor = "tori",
                               .name = "Quasi-periodic motions",
                               .summarize = summarize,
                               .section = section};
