// How modes are shown: in numbers, with critical speeds and thresholds of stability.
#include <math.h>

#include "page.h"
#include "quantities.h"
#include "shown_kinds.h"
#include "summary.h"

/// What rounding leaves of no damping, over the frequency.
static const double rounding = 1e-10;

/// A damping ratio, 0 where it is nothing but rounding.
static double shown_ratio(double ratio) {
    return fabs(ratio) < rounding ? 0.0 : ratio;
}

static const char *way_of(double direction) {
    static const char *const names[] = {"backward", "to and fro", "forward"};
    return names[units_way(direction) + 1];
}

// ---------------------------------------------------------------- the summary

/// The peak of loops of control, and the zone that it is in; an unstable machine is in none.
static void print_sensitivity(FILE *out, const whirl_table *table, size_t point) {
    const double peak = whirl_table_number(table, point, WHIRL_FIELD_MODES_SENSITIVITY, 0);
    const double frequency = whirl_table_number(table, point, WHIRL_FIELD_MODES_SENSITIVITY_FREQUENCY, 0);
    const char zone = peak < 3.0 ? 'A' : peak < 4.0 ? 'B' : peak < 5.0 ? 'C' : 'D';
    if (!isfinite(peak)) return;
    fprintf(out, "  peak sensitivity of the loops of control %.7g at %.6g Hz: ", peak, frequency / 6.283185307179586);
    if (shown_modes_growing(table, point) > 0)
        fputs("no zone of ISO 14839-3, as the machine is unstable\n", out);
    else
        fprintf(out, "zone %c of ISO 14839-3\n", zone);
}

int shown_modes_growing(const whirl_table *table, size_t point) {
    const double stability = whirl_table_number(table, point, WHIRL_FIELD_MODES_STABILITY, 0);
    return (stability > 0.0) - (stability < 0.0);
}

/// Whether a point is stable, which stands first as reports leave out what is long, and its lowest modes, a line each:
/// "  254.1 rad/s  (40.44 Hz, 2426 rpm)  damping ratio 0.0213  forward".
static void print_modes(FILE *out, const whirl_table *table, const mode_lines *lines, size_t point) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    const double *frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0);
    const double *ratio = whirl_table_field(table, point, WHIRL_FIELD_MODES_DAMPING_RATIO, 0);
    const double *direction = whirl_table_field(table, point, WHIRL_FIELD_MODES_DIRECTION, 0);
    const double rigid = whirl_table_number(table, point, WHIRL_FIELD_MODES_RIGID_BODY, 0);
    const double stability = whirl_table_number(table, point, WHIRL_FIELD_MODES_STABILITY, 0);
    static const char *const names[] = {"stable", "undamped", "unstable"};
    if (isfinite(stability))
        fprintf(out, "  %s: the largest real part of all eigenvalues%s is %.4g 1/s\n",
                names[shown_modes_growing(table, point) + 1], rigid > 0 ? " but zeros" : "", stability);
    if (rigid > 0)
        fprintf(out, "  %10d rad/s: %g rigid-body mode%s, which nothing holds\n", 0, rigid, summary_plural(rigid));
    for (size_t i = 0; field && frequency && i < field->rows && isfinite(frequency[i]); i++) {
        static const char *const ways[] = {"backward", "", "forward"};
        const char *const whirls = ways[units_way(direction[i]) + 1];
        const char *const name = mode_lines_name(lines, point, i);
        fprintf(out, "  %10.6g rad/s (%.6g Hz)  damping ratio %-*.4g%-*s%s\n", frequency[i],
                frequency[i] / 6.283185307179586, *whirls || *name ? 11 : 0, shown_ratio(ratio[i]), *name ? 10 : 0,
                whirls, name);
    }
    const double modulo = whirl_table_number(table, point, WHIRL_FIELD_MODES_MODULO, 0);
    if (isfinite(modulo))
        fprintf(out, "  frequencies are known but for multiples of %.6g rad/s: coefficients turn with the shaft\n",
                modulo);
    const double *known = whirl_table_field(table, point, WHIRL_FIELD_MODES_KNOWN, 0);
    if (known && isfinite(known[0]))
        fprintf(out,
                "  %smodes from %.6g to %.6g rad/s: beyond, tables of bearings do not know the frequency of whirl\n",
                frequency && isfinite(frequency[0]) ? "" : "no ", known[0], known[1]);
    print_sensitivity(out, table, point);
}

/// What was located along the parameter: "  critical speed at 2753.2 rpm: forward, damping ratio 0.02".
static void print_critical(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    static const char *const names[] = {"", "critical speed", "instability begins", "instability ends"};
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    for (size_t point = 0; point < table->count; point++) {
        const double *rows = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        if (!whirl_table_done(table, point) || !rows) continue;
        for (size_t i = 0; i < field->rows; i++, rows += field->columns) {
            if (!(rows[0] >= 1 && rows[0] <= 3)) continue;
            fprintf(out, "  %-18s at %.9g%s%s: %s, %.6g rad/s, damping ratio %.3g\n", names[(int)rows[0]],
                    rows[1] / unit.size, *unit.name ? " " : "", unit.name, way_of(rows[5]), rows[3],
                    shown_ratio(rows[4]));
        }
    }
}

/// The modes at the first and the last value that are done.
static void print_modes_at_ends(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter);
    size_t first = 0, last = table->count;
    mode_lines lines;
    mode_lines_of(table, &lines);
    while (first < table->count && !whirl_table_done(table, first)) first++;
    while (last > first && !whirl_table_done(table, last - 1)) last--;
    for (size_t point = first; point < last; point += point + 1 < last ? last - 1 - point : 1) {
        fprintf(out, " modes at %.6g%s%s", table->values[point] / unit.size, *unit.name ? " " : "", unit.name);
        if (lines.count > 0 && point + 1 < last)
            fprintf(out, " (names are those at %.6g%s%s)", table->values[last - 1] / unit.size, *unit.name ? " " : "",
                    unit.name);
        fputs(":\n", out);
        print_modes(out, table, &lines, point);
    }
    mode_lines_free(&lines);
}

static void summarize(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    if (whirl_table_planned(table) > 1) {
        print_critical(out, units, table);
        print_modes_at_ends(out, units, table);
    } else if (whirl_table_done(table, 0)) {
        print_modes(out, table, &(mode_lines){.line = NULL}, 0);
    }
}

// ---------------------------------------------------------------- the page

static size_t count_critical(const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    size_t count = 0;
    for (size_t point = 0; field && point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++)
            count += isfinite(row[i * field->columns]);
    }
    return count;
}

/// Between which frequencies of whirl tables of bearings are known, where they are over these.
static void write_known(FILE *stream, const whirl_table *table) {
    for (size_t point = 0; point < table->count; point++) {
        const double *known = whirl_table_field(table, point, WHIRL_FIELD_MODES_KNOWN, 0);
        if (!known || !whirl_table_done(table, point) || !isfinite(known[0])) continue;
        fprintf(
            stream,
            "<p>Coefficients of bearings are those at the damped frequency of each mode; modes are told from %.6g to "
            "%.6g rad/s, where tables know them.</p>\n",
            known[0], known[1]);
        return;
    }
}

/// Whether frequencies are known but for multiples of the speed, at any point.
static bool is_modulated(const whirl_table *table) {
    for (size_t point = 0; point < table->count; point++) {
        const double *modulo = whirl_table_field(table, point, WHIRL_FIELD_MODES_MODULO, 0);
        if (modulo && whirl_table_done(table, point) && isfinite(*modulo)) return true;
    }
    return false;
}

/// Frequency in Hz, damping ratio, logarithmic decrement, way round.
static void write_mode(FILE *stream, double frequency, double ratio, double direction) {
    static const double turn = 6.283185307179586;
    html_number(stream, frequency / turn);
    ratio = shown_ratio(ratio);
    fprintf(stream, "<td class=\"number\">%.4g</td><td class=\"number\">%.4g</td><td>%s</td></tr>\n", ratio,
            fabs(ratio) < 1.0 ? turn * ratio / sqrt(1.0 - ratio * ratio) : (double)INFINITY, way_of(direction));
}

static void write_row(FILE *stream, const double *row, double unit, bool is_speed) {
    static const char *const kinds[] = {"", "critical speed", "instability begins", "instability ends"};
    fprintf(stream, "<tr><th>%s</th><td class=\"number\">%.9g</td>", kinds[(int)row[0]], row[1] / unit);
    if (!is_speed) html_number(stream, row[2] * 60.0 / 6.283185307179586);
    write_mode(stream, row[3], row[4], row[5]);
}

static const char of_modes[] = "<th class=\"number\">frequency (Hz)</th><th class=\"number\">damping ratio</th>"
                               "<th class=\"number\">logarithmic decrement</th><th>whirl</th></tr></thead>\n<tbody>\n";

/// The modes that the figure of shapes shows: those of the last point.
static void write_lowest(const page *to, size_t index, const whirl_table *table) {
    enum { SHOWN = 12 };
    const size_t last = table->count - 1;
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    const double *frequency = whirl_table_field(table, last, WHIRL_FIELD_MODES_FREQUENCY, 0);
    const double *ratio = whirl_table_field(table, last, WHIRL_FIELD_MODES_DAMPING_RATIO, 0);
    const double *direction = whirl_table_field(table, last, WHIRL_FIELD_MODES_DIRECTION, 0);
    char label[UNIT_LABEL_SIZE];
    mode_lines lines;
    if (!frequency || !whirl_table_done(table, last) || !isfinite(frequency[0])) return;
    mode_lines_of(table, &lines);
    units_point_label(&to->units[index], table, last, label, sizeof label);
    html_table(to->stream, "Lowest modes", "");
    fputs("<thead><tr><th>mode at ", to->stream);
    html_text(to->stream, label);
    fprintf(to->stream, "</th>%s", of_modes);
    for (size_t i = 0; i < field->rows && i < SHOWN && isfinite(frequency[i]); i++) {
        const char *name = mode_lines_name(&lines, last, i);
        fprintf(to->stream, "<tr><th>%zu%s%s</th>", i + 1, *name ? ": " : "", name);
        write_mode(to->stream, frequency[i], ratio[i], direction[i]);
    }
    mode_lines_free(&lines);
    fputs("</tbody></table></div>\n", to->stream);
}

/// Critical speeds, and thresholds of stability.
static void write_critical(const page *to, size_t index, const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_CRITICAL);
    const bool speeds = units_of_speed(table, WHIRL_FIELD_MODES_SPEED); // it need not be told beside the parameter
    char label[UNIT_LABEL_SIZE];
    units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
    html_table(to->stream, "Critical speeds and thresholds of stability", "");
    fputs("<thead><tr><th>What</th><th class=\"number\">", to->stream);
    html_text(to->stream, label);
    fprintf(to->stream, "</th>%s%s", speeds ? "" : "<th class=\"number\">speed (rpm)</th>", of_modes);
    for (size_t point = 0; point < table->count; point++) {
        const double *row = whirl_table_field(table, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; row && whirl_table_done(table, point) && i < field->rows; i++, row += field->columns)
            if (row[0] >= 1.0 && row[0] <= 3.0)
                write_row(to->stream, row, whirl_shown_parameter(&to->units[index], table->parameter).size, speeds);
    }
    fputs("</tbody></table></div>\n", to->stream);
}

static void section(const page *to, size_t index, const whirl_table *table) {
    const bool modulated = is_modulated(table);
    write_known(to->stream, table);
    if (modulated)
        fputs("<p>Coefficients turn with the shaft: frequencies are known but for multiples of its speed, and critical "
              "speeds are not told.</p>\n",
              to->stream);
    if (count_critical(table) > 0)
        write_critical(to, index, table);
    else
        fputs(
            modulated
                ? "<p>Between the values that were looked at the machine neither loses nor regains its stability.</p>\n"
                : "<p>Between the values that were looked at no natural frequency meets the speed of the shaft, and "
                  "the machine neither loses nor regains its stability.</p>\n",
            to->stream);
    if (table->count > 0) write_lowest(to, index, table);
}

/// Over a parameter; of one point the summary tells the modes.
static bool is_found(const whirl_table *table) {
    return *table->parameter;
}

const shown_kind shown_modes = {.field = WHIRL_FIELD_MODES_FREQUENCY,
                                .explored = true,
                                .anchor = "critical",
                                .name = "Critical speeds and stability",
                                .found = is_found,
                                .summarize = summarize,
                                .section = section};
