// How critical speeds without damping are shown: in numbers, forward and backward apart.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "page.h"
#include "shown_kinds.h"
#include "summary.h"

enum { LISTED = 6, MOST_ROWS = 40, LIST_SIZE = 160 };

/// "384.9, 1054.8": the lowest of a direction (1, -1; 0: to and fro), in a unit; "" where there is none.
static void list_speeds(const whirl_table *table, size_t point, int direction, double unit, char *text, size_t size) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED);
    const double *speeds = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
    const double *directions = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, 0);
    size_t used = 0, count = 0;
    *text = '\0';
    for (size_t i = 0; i < field->rows && count < LISTED && isfinite(speeds[i]); i++) {
        if (units_way(directions[i]) == direction && used < size)
            used += (size_t)snprintf(text + used, size - used, "%s%.6g", count++ ? ", " : "", speeds[i] / unit);
    }
}

static void print_point(FILE *out, const whirl_table *table, size_t point, const whirl_unit *speed) {
    static const char *const names[] = {"backward", "to and fro", "forward"};
    const double rigid = whirl_table_number(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_RIGID_BODY, 0);
    for (int direction = 1; direction >= -1; direction--) {
        char text[LIST_SIZE];
        list_speeds(table, point, direction, speed->size, text, sizeof text);
        if (*text) fprintf(out, "    %-10s %s %s\n", names[direction + 1], text, speed->name);
    }
    if (rigid > 0.0) fprintf(out, "    and %g rigid-body mode%s, which nothing holds\n", rigid, summary_plural(rigid));
}

static void summarize(FILE *out, const whirl_shown_units *units, const whirl_table *table) {
    const whirl_unit unit = whirl_shown_parameter(units, table->parameter), speed = margin_speed_unit(units);
    // Of many points those at the ends.
    const bool all = table->count <= LISTED;
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point) || (!all && point > 0 && point + 1 < table->count)) continue;
        if (*table->parameter)
            fprintf(out, "  at %.6g%s%s:\n", table->values[point] / unit.size, *unit.name ? " " : "", unit.name);
        print_point(out, table, point, &speed);
    }
}

static void section(const page *to, size_t index, const whirl_table *table) {
    char label[UNIT_LABEL_SIZE], text[LIST_SIZE];
    const double unit = whirl_shown_parameter(&to->units[index], table->parameter).size;
    const size_t step = 1 + table->count / MOST_ROWS;
    const whirl_unit speed = margin_speed_unit(&to->units[index]);
    units_parameter_label(&to->units[index], table->parameter, label, sizeof label);
    html_table(to->stream, "Critical speeds without damping", "");
    fputs("<thead><tr><th class=\"number\">", to->stream);
    html_text(to->stream, label);
    fprintf(to->stream,
            "</th><th>forward (%s)</th><th>backward (%s)</th><th>to and fro (%s)</th></tr></thead>\n<tbody>\n",
            speed.name, speed.name, speed.name);
    for (size_t point = 0; point < table->count; point += step) {
        if (!whirl_table_done(table, point)) continue;
        fprintf(to->stream, "<tr><th class=\"number\">%.6g</th>", table->values[point] / unit);
        static const int order[] = {1, -1, 0};
        for (int i = 0; i < 3; i++) {
            list_speeds(table, point, order[i], speed.size, text, sizeof text);
            fprintf(to->stream, "<td>%s</td>", text);
        }
        fputs("</tr>\n", to->stream);
    }
    fputs("</tbody></table></div>\n", to->stream);
}

const shown_kind shown_critical_speeds = {.field = WHIRL_FIELD_CRITICAL_SPEEDS_SPEED,
                                          .anchor = "critical-speeds",
                                          .name = "Critical speeds without damping",
                                          .about = "Of the machine without damping, the lowest 6 of each direction.",
                                          .summarize = summarize,
                                          .section = section};
