// Centrelines: positions of rest of journals in their bearings over the parameter, within the walls around them.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "machine_at.h"
#include "point_panels.h"

enum { MAX_BEARINGS = 12 };

/// Finds the rest position [2] of a station's journal at a point, in shown units of length. Returns false if it is
/// unknown.
static bool centreline_place(const drawing *of, const whirl_table *table, size_t point, size_t station,
                             double place[2]) {
    const double *at = whirl_table_field(table, point, WHIRL_FIELD_STATICS_PLACE, station);
    const double length = whirl_shown_length(of->units, table, point);
    if (!at || !whirl_table_done(table, point) || !isfinite(at[0]) || !isfinite(at[1])) return false;
    for (size_t i = 0; i < 2; i++) place[i] = length * at[i];
    return true;
}

/// Finds the first and the last point at which a film carries a journal; returns 0 if there is none, 1 if they are one
/// point, else 2.
static size_t centreline_ends(const drawing *of, const whirl_table *table, size_t station, size_t ends[2]) {
    size_t count = 0;
    double place[2];
    for (size_t point = 0; point < table->count; point++) {
        if (!centreline_place(of, table, point, station, place)) continue;
        if (whirl_table_number(table, point, WHIRL_FIELD_STATICS_SEAL, station) == 1.0) continue;
        if (count == 0) ends[count++] = point;
        ends[1] = point;
    }
    return count > 0 && ends[1] > ends[0] ? 2 : count;
}

static size_t centreline_stations(const drawing *of, const whirl_table *table, size_t stations[MAX_BEARINGS]) {
    size_t used = 0, ends[2];
    for (size_t s = 0; s < of->result->station_count && used < MAX_BEARINGS; s++)
        if (centreline_ends(of, table, s, ends) > 0) stations[used++] = s;
    return used;
}

static void centreline_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &centreline_figure, .table = table, .point = NO_POINT, .station = SIZE_MAX};
    size_t stations[MAX_BEARINGS];
    if (table_has(table, WHIRL_FIELD_STATICS_PLACE) && centreline_stations(of, table, stations) > 0)
        list_figure(to, &place, "centreline", "Places of rest of journals in their bearings");
}

/// Adds the parameter's value next to an end of the line, towards the middle of the panel.
static void add_end(whirl_figure *figure, whirl_panel *panel, const drawing *of, const whirl_table *table, size_t point,
                    const double place[2]) {
    const whirl_unit unit = whirl_shown_parameter(of->units, table->parameter);
    char text[2 * WHIRL_NAME_SIZE];
    whirl_series *name = panel_series(figure, panel, WHIRL_TEXTS, "#404040", 5.5);
    if (!name || !*table->parameter) return;
    name->side = place[0] > 0.0 ? WHIRL_LEFT : WHIRL_RIGHT;
    snprintf(text, sizeof text, "%.5g%s%s", table->values[point] / unit.size, *unit.name ? " " : "", unit.name);
    series_add_text(figure, name, place[0], place[1], text);
}

static void add_bearing(whirl_figure *figure, const drawing *of, const whirl_table *table, size_t station) {
    const char *const name = of->result->stations[station].name;
    // Find the first and the last point, and the walls at the first.
    size_t ends[2] = {0, 0};
    const size_t count = centreline_ends(of, table, station, ends);
    const machine_walls walls = machine_walls_at(of->machine, of->result, table, ends[0], station);
    const double scale = whirl_shown_length(of->units, table, ends[0]);
    // Set up a panel with the wall of the bearing.
    whirl_panel *panel = figure_panel(figure, name, 1.0 / 3.0, 2.4);
    if (!panel) return;
    snprintf(panel->title, sizeof panel->title, "%.60s", name);
    panel->equal = true;
    machine_wall wall;
    machine_wall_at(of->machine, table, ends[0], station, walls.clearance, &wall);
    const double size = 1.08 * wall_line(figure, panel, &wall, scale);
    axis_show(&panel->x, (span){-size, size});
    axis_show(&panel->y, (span){-size, size});
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$x$", panel->x.label, sizeof panel->x.label);
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$y$", panel->y.label, sizeof panel->y.label);
    // Draw the path of the journal, and mark its ends.
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.8);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, line_colour(0), 1.6);
    double place[2];
    for (size_t point = ends[0]; point <= ends[count - 1]; point++) {
        if (!centreline_place(of, table, point, station, place)) {
            series_break(figure, line);
            continue;
        }
        series_add(figure, line, place[0], place[1]);
        series_add(figure, dots, place[0], place[1]);
    }
    for (size_t i = 0; i < count; i++)
        if (centreline_place(of, table, ends[i], station, place)) add_end(figure, panel, of, table, ends[i], place);
}

static void centreline_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    size_t stations[MAX_BEARINGS];
    const size_t used = centreline_stations(of, place->table, stations);
    for (size_t i = 0; i < used; i++) add_bearing(figure, of, place->table, stations[i]);
    snprintf(figure->caption, sizeof figure->caption,
             "Where journals rest in their films%s%s: grey lines are the walls at the first point, as far as the "
             "middle of the journal can go; a dot for each point, the first and the last with their value.",
             *place->table->parameter ? " over " : "", place->table->parameter);
}

const figure_kind centreline_figure = {.list = centreline_list,
                                       .describe = centreline_describe,
                                       .stem = "centreline",
                                       .study = "{statics: {parameter: ..., from: ..., to: ...}}"};
