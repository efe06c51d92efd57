// The critical speed map: critical speeds without damping over a parameter, such as the stiffness of the bearings.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "margins.h"
#include "mode_lines.h"
#include "units.h"

static void critical_speeds_list(figure_list *to, const drawing *of, const whirl_table *table) {
    (void)of;
    const figure_place place = {.kind = &critical_speeds_figure, .table = table, .point = NO_POINT};
    if (table_has(table, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED) && table->count > 1)
        list_figure(to, &place, "critical-speeds", "Critical speeds over %s", table->parameter);
}

/// Returns critical speed number `which` of a direction (1 forward, -1 backward, 0 to and fro) at a point; NaN if there
/// is none.
static double speed_of(const whirl_table *table, size_t point, int direction, size_t which) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED);
    const double *speeds = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
    const double *directions = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, 0);
    for (size_t i = 0; whirl_table_done(table, point) && i < field->rows && isfinite(speeds[i]); i++) {
        if (units_way(directions[i]) == direction && which-- == 0) return speeds[i];
    }
    return NAN;
}

/// Adds a line for each critical speed of a direction, in their order; the first line has the direction's name in the
/// legend.
static void add_direction(whirl_figure *figure, whirl_panel *panel, const drawing *of, const whirl_table *table,
                          int direction, double unit) {
    static const char *const colours[] = {"#D55E00", "#606060", "#0072B2"};
    // Add lines until no point has a critical speed of that number.
    const double size = whirl_shown_parameter(of->units, table->parameter).size;
    bool any = true;
    for (size_t which = 0; any; which++) {
        whirl_series *line = NULL;
        any = false;
        for (size_t point = 0; point < table->count; point++) {
            const double speed = speed_of(table, point, direction, which);
            if (isnan(speed)) {
                series_break(figure, line);
                continue;
            }
            if (!line)
                line = panel_named(figure, panel, WHIRL_LINE, which == 0 ? mode_way_name(direction) : "",
                                   colours[direction + 1], 0.8);
            if (line) line->dashed = direction < 0;
            series_add(figure, line, table->values[point] / size, speed / unit);
            any = true;
        }
    }
}

typedef struct laid {
    double stiffness, speed;
} laid;

static int by_speed(const void *a, const void *b) {
    const laid *one = a, *other = b;
    return (one->speed > other->speed) - (one->speed < other->speed);
}

/// Adds the stiffness kxx or kyy of the bearings at a station over the speed, at all critical speeds found.
static void add_bearings(whirl_figure *figure, whirl_panel *panel, const drawing *of, const whirl_table *table,
                         size_t station, size_t column, double unit) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_CRITICAL_SPEEDS_BEARINGS);
    const double size = whirl_shown_parameter(of->units, table->parameter).size;
    laid *found = field ? malloc((table->count * field->rows + 1) * sizeof *found) : NULL;
    size_t count = 0;
    for (size_t point = 0; point < table->count && found; point++) {
        const double *speeds = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
        const double *bearings = whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_BEARINGS, station);
        for (size_t i = 0; whirl_table_done(table, point) && i < field->rows; i++)
            if (bearings[2 * i + column] > 0.0) found[count++] = (laid){bearings[2 * i + column], speeds[i]};
    }
    if (count > 1) {
        char name[2 * WHIRL_NAME_SIZE];
        qsort(found, count, sizeof *found, by_speed);
        snprintf(name, sizeof name, "%s of %s", column ? "kyy" : "kxx", of->result->stations[station].name);
        whirl_series *line = panel_named(figure, panel, WHIRL_LINE, name, line_colour(2 + station), 0.8);
        if (line) line->dashed = column == 1;
        for (size_t i = 0; i < count; i++) series_add(figure, line, found[i].stiffness / size, found[i].speed / unit);
    }
    free(found);
}

/// Returns true for values with equal ratios; both axes are logarithmic then.
static bool has_ratios(const whirl_table *table) {
    const double *v = table->values;
    const size_t last = table->count - 1;
    return table->count > 2 && v[0] > 0.0 && v[last] > 0.0 &&
           fabs(log(v[1] / v[0]) * (double)last - log(v[last] / v[0])) < 1e-6 * fabs(log(v[last] / v[0])) &&
           fabs((v[1] - v[0]) * (double)last - (v[last] - v[0])) > 1e-6 * fabs(v[last] - v[0]);
}

/// Finds the running speeds in any table of the result, rad/s. Returns false if there are none.
static bool running_of(const whirl_result *result, double *low, double *high) {
    for (size_t t = 0; t < result->table_count; t++)
        if (margin_running(&result->tables[t], low, high)) return true;
    return false;
}

/// Adds a band for the running speeds, behind all lines.
static void add_running(whirl_figure *figure, whirl_panel *panel, const drawing *of, const whirl_table *table,
                        double unit) {
    const double size = whirl_shown_parameter(of->units, table->parameter).size;
    double low, high;
    span along = span_empty();
    if (!running_of(of->result, &low, &high)) return;
    for (size_t point = 0; point < table->count; point++) span_widen(&along, table->values[point] / size);
    whirl_series *band = panel_named(figure, panel, WHIRL_BOXES, "running speeds", "#D8D8D8", 1.0);
    series_add_box(figure, band, along, (span){low / unit, fmax(high, 1.002 * low) / unit});
}

/// Returns true if names at two speeds would overlap: nearer than 1/22 of the axis.
static bool names_meet(const whirl_panel *panel, span all, double one, double other) {
    if (panel->y.logarithmic && all.low > 0.0) return log(other / one) < log(all.high / all.low) / 22.0;
    return other - one < (all.high - all.low) / 22.0;
}

/// Adds names of lines at the last point: "1F" for the first forward, B backward, M to and fro. Names of lines with
/// close ends are placed next to each other.
static void add_names(whirl_figure *figure, whirl_panel *panel, const drawing *of, const whirl_table *table,
                      double unit) {
    const double size = whirl_shown_parameter(of->units, table->parameter).size;
    const size_t last = table->count - 1;
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED);
    const double *speeds = whirl_table_field(table, last, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0);
    const double *directions = whirl_table_field(table, last, WHIRL_FIELD_CRITICAL_SPEEDS_DIRECTION, 0);
    whirl_series *names = panel_series(figure, panel, WHIRL_TEXTS, "#303030", 1.0);
    size_t number[3] = {0, 0, 0};
    char text[WHIRL_NAME_SIZE] = "";
    double before = 0.0;
    span all = span_empty();
    // Find the range of all speeds, by which close names are recognized.
    if (names) names->side = WHIRL_LEFT;
    for (size_t point = 0; point < table->count; point++)
        for (size_t i = 0; whirl_table_done(table, point) && i < field->rows; i++)
            span_widen(&all, whirl_table_field(table, point, WHIRL_FIELD_CRITICAL_SPEEDS_SPEED, 0)[i]);
    // Write each name; those of close lines are joined into one text.
    for (size_t i = 0; whirl_table_done(table, last) && i < field->rows && isfinite(speeds[i]); i++) {
        const int way = units_way(directions[i]);
        const size_t used = strlen(text);
        const bool near = used > 0 && names_meet(panel, all, before, speeds[i]);
        if (used > 0 && !near) {
            series_add_text(figure, names, table->values[last] / size, before / unit, text);
            *text = '\0';
        }
        snprintf(text + (near ? used : 0), sizeof text - (near ? used : 0), "%s%zu%c", near ? ", " : "",
                 ++number[way + 1], "BMF"[way + 1]);
        before = speeds[i];
    }
    if (*text) series_add_text(figure, names, table->values[last] / size, before / unit, text);
}

static void critical_speeds_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const whirl_unit speed = of->units->speed.size > 0.0 ? of->units->speed : (whirl_unit){"rpm", 0.104719755119659774};
    // Set up the panel.
    whirl_panel *panel = figure_panel(figure, "speeds", 1.0, 8.5);
    if (!panel) return;
    symbol_parameter(of->units, table->parameter, panel->x.label, sizeof panel->x.label);
    snprintf(panel->y.label, sizeof panel->y.label, "critical speed (%s)", speed.name);
    panel->x.logarithmic = panel->y.logarithmic = has_ratios(table);
    // Draw the running speed, critical speeds by direction, and stiffnesses of the bearings.
    add_running(figure, panel, of, table, speed.size);
    for (int direction = 1; direction >= -1; direction--)
        add_direction(figure, panel, of, table, direction, speed.size);
    const bool springs = table_has(table, WHIRL_FIELD_CRITICAL_SPEEDS_BEARINGS);
    for (size_t k = 0; k < 2 * of->result->station_count && springs; k++)
        add_bearings(figure, panel, of, table, k / 2, k % 2, speed.size);
    add_names(figure, panel, of, table, speed.size);
    snprintf(
        figure->caption, sizeof figure->caption,
        "Critical speeds of the machine without damping over %s: speeds at which a mode goes round once a "
        "revolution, with the rotation (blue, 1F, 2F, ...) or against it (orange, dashed, 1B, 2B, ...).%s",
        table->parameter,
        springs
            ? " Springs of that stiffness replace all bearings; the bearings' own stiffness over the speed is overlaid."
            : "");
}

const figure_kind critical_speeds_figure = {.list = critical_speeds_list, .describe = critical_speeds_describe};
