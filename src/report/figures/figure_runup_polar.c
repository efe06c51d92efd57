// Figures of run-ups as paths over the speed: the synchronous motion as a vector, and the mean position within its
// walls.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine_at.h"
#include "point_panels.h"
#include "runup_panels.h"
#include "units.h"

/// Figures of this file: values of figure_place.which.
enum { POLAR, CENTRELINE, KINDS };

static const struct {
    const char *name, *title, *field;
} alike[KINDS] = {{"runup-polar", "%.60s at the speed of the shaft, as a vector", WHIRL_FIELD_RUNUP_AMPLITUDE},
                  {"runup-centreline", "Mean position of %.60s over the speed", WHIRL_FIELD_RUNUP_CENTRE}};

/// A path of a run: its points, and the speeds there.
typedef struct path {
    size_t rows;
    const double *speeds; ///< [rows]
    double *kept;         ///< [rows] speeds of the points that are drawn; `count` of them are set
    size_t count;
    double reach; ///< largest distance of a point from the centre
} path;

static path path_of(const whirl_table *table, size_t run) {
    path made = {.rows = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_SPEED)->rows,
                 .speeds = whirl_table_field(table, run, WHIRL_FIELD_RUNUP_SPEED, 0)};
    made.kept = calloc(made.rows + 1, sizeof *made.kept);
    return made;
}

static void path_add(whirl_figure *figure, whirl_series *line, path *to, size_t row, double x, double y) {
    if (!isfinite(x) || !isfinite(y) || !isfinite(to->speeds[row])) return;
    series_add(figure, line, x, y);
    to->kept[to->count++] = to->speeds[row];
    to->reach = fmax(to->reach, hypot(x, y));
}

static void path_frame(whirl_figure *figure, whirl_panel *panel, double reach) {
    const double size = reach > 0.0 ? 1.12 * reach : 1.0;
    axis_show(&panel->x, (span){-size, size});
    axis_show(&panel->y, (span){-size, size});
    panel_level(figure, panel, 0.0, "#9A9A9A", 0.3);
    panel_upright(figure, panel, 0.0, "#9A9A9A", 0.3);
}

// ---------------------------------------------------------------- vectors

/// Adds the path of the vector of x (axis 0) or y of a run; the lag turns the vector clockwise from the axis.
static void polar_add_line(whirl_figure *figure, whirl_series *line, path *to, const drawing *of,
                           const whirl_table *table, size_t run, const figure_place *place, size_t axis,
                           bool compensated) {
    const char *const sizes = compensated ? WHIRL_FIELD_RUNUP_COMPENSATED : WHIRL_FIELD_RUNUP_AMPLITUDE;
    const char *const lags = compensated ? WHIRL_FIELD_RUNUP_COMPENSATED_LAG : WHIRL_FIELD_RUNUP_LAG;
    const size_t columns = whirl_layout_field(&table->layout, sizes)->columns;
    const double *amplitude = whirl_table_field(table, run, sizes, place->station);
    const double *lag = whirl_table_field(table, run, lags, place->station);
    const double degree = 3.141592653589793238463 / 180.0;
    const double length = units_length(of->units, table, run, WHIRL_AMPLITUDE);
    for (size_t row = 0; row < to->rows && amplitude && lag; row++) {
        const double size = length * amplitude[row * columns + axis];
        const double angle = (axis == 0 ? 0.0 : 90.0) - lag[row * columns + axis];
        path_add(figure, line, to, row, size * cos(degree * angle), size * sin(degree * angle));
    }
}

/// Returns true if the slow roll was subtracted from the motion of a station.
static bool polar_is_compensated(const whirl_table *table, size_t run, size_t station) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_COMPENSATED);
    const double *sizes = whirl_table_field(table, run, WHIRL_FIELD_RUNUP_COMPENSATED, station);
    for (size_t row = 0; field && sizes && row < field->rows; row++)
        if (isfinite(sizes[2 * row])) return true;
    return false;
}

/// Adds the paths of all runs along an axis, less the slow roll if it was subtracted; for a single run also the path
/// with slow roll, dashed. Returns the largest size of a vector.
static double polar_add_lines(const drawing *of, const figure_place *place, size_t axis, whirl_panel *panel,
                              whirl_figure *figure) {
    const whirl_table *table = place->table;
    size_t runs[MAX_RUNS];
    const size_t count = runup_list_runs(table, runs);
    double reach = 0.0;
    // Draw each run; for a single run with slow roll both paths.
    for (size_t i = 0; i < count; i++) {
        const bool compensated = polar_is_compensated(table, runs[i], place->station);
        for (int raw = compensated && count == 1; raw >= 0; raw--) {
            char label[UNIT_LABEL_SIZE] = "";
            path own = path_of(table, runs[i]);
            if (count > 1 && axis == 0) units_point_label(of->units, table, runs[i], label, sizeof label);
            whirl_series *line = panel_named(figure, panel, WHIRL_LINE, label, raw ? "#707070" : line_colour(i), 0.8);
            if (own.kept && line) {
                line->dashed = raw;
                polar_add_line(figure, line, &own, of, table, runs[i], place, axis, compensated && !raw);
                if (!raw) runup_label_speeds(of, figure, panel, line, own.kept);
            }
            figure->failed = figure->failed || !own.kept;
            reach = fmax(reach, own.reach);
            free(own.kept);
        }
    }
    return reach;
}

static void polar_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    static const char *const names[] = {"x", "y"}, *const titles[] = {"$x$ at 1X", "$y$ at 1X"};
    // Set up a panel for x and one for y, and draw their vectors.
    const whirl_table *table = place->table;
    const whirl_unit *speed = &of->units->of[WHIRL_QUANTITY_SPEED];
    double reach = 0.0;
    size_t runs[MAX_RUNS];
    whirl_panel *panels[2];
    for (size_t axis = 0; axis < 2; axis++) {
        whirl_panel *panel = panels[axis] = figure_panel(figure, names[axis], 0.5, 5.0);
        if (!panel) return;
        panel->equal = true;
        snprintf(panel->title, sizeof panel->title, "%s", titles[axis]);
        symbol_length(of->units, WHIRL_AMPLITUDE, "amplitude along $x$", panel->x.label, sizeof panel->x.label);
        symbol_length(of->units, WHIRL_AMPLITUDE, "amplitude along $y$", panel->y.label, sizeof panel->y.label);
        reach = fmax(reach, polar_add_lines(of, place, axis, panel, figure));
    }
    // Give both panels the same frame.
    for (size_t axis = 0; axis < 2; axis++) path_frame(figure, panels[axis], reach);
    // Describe the compensation and the panels.
    const bool compensated = runup_list_runs(table, runs) > 0 && polar_is_compensated(table, runs[0], place->station);
    char without[160] = "";
    if (compensated)
        snprintf(without, sizeof without, ", less the slow roll at %.6g %s (dashed: with it)",
                 table->record.runup.slow_roll / speed->size, speed->name);
    snprintf(figure->caption, sizeof figure->caption,
             "Motion of %.60s along x and y at the speed of the shaft, as a vector%s: its length is the amplitude, its "
             "angle the lag, clockwise from the axis. Dots have the speed in %s.",
             of->result->stations[place->station].name, without, speed->name);
    runup_caption_runs(of, table, MAX_RUNS, figure);
}

// ---------------------------------------------------------------- mean positions

static void centreline_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const size_t station = place->station;
    size_t runs[MAX_RUNS];
    // The path is that of the first run.
    if (runup_list_runs(table, runs) == 0) return;
    const double scale = whirl_shown_length(of->units, table, runs[0]);
    const double *centre = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_CENTRE, station);
    const machine_walls walls = machine_walls_at(of->machine, of->result, table, runs[0], station);
    whirl_panel *panel = figure_panel(figure, "centre", 0.6, 7.0);
    path own = path_of(table, runs[0]);
    figure->failed = figure->failed || !panel || !own.kept;
    // Set up the panel, with the wall of the bearing.
    if (panel && own.kept && centre) {
        double reach = 0.0;
        panel->equal = true;
        symbol_length(of->units, WHIRL_FROM_CENTRE, "$x$", panel->x.label, sizeof panel->x.label);
        symbol_length(of->units, WHIRL_FROM_CENTRE, "$y$", panel->y.label, sizeof panel->y.label);
        if (walls.clearance > 0.0) {
            machine_wall wall;
            machine_wall_at(of->machine, table, runs[0], station, walls.clearance, &wall);
            reach = wall_line(figure, panel, &wall, scale);
        }
        // Draw the path with marks of the speed.
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.8);
        for (size_t row = 0; row < own.rows && line; row++)
            path_add(figure, line, &own, row, scale * centre[2 * row], scale * centre[2 * row + 1]);
        if (line) runup_label_speeds(of, figure, panel, line, own.kept);
        path_frame(figure, panel, fmax(reach, own.reach));
    }
    free(own.kept);
    // Describe the panel.
    snprintf(figure->caption, sizeof figure->caption,
             "Mean position of %.60s over single turns of the shaft%s. Dots have the speed in %s.",
             of->result->stations[station].name,
             walls.clearance > 0.0 ? "; grey: the limit of the journal's centre in its bearing" : "",
             of->units->of[WHIRL_QUANTITY_SPEED].name);
    runup_caption_runs(of, table, 1, figure);
}

// ---------------------------------------------------------------- the figures

static void polar_list(figure_list *to, const drawing *of, const whirl_table *table) {
    char name[2 * WHIRL_NAME_SIZE];
    size_t runs[MAX_RUNS];
    if (!table_has(table, WHIRL_FIELD_RUNUP_AMPLITUDE) || runup_list_runs(table, runs) == 0) return;
    for (size_t s = 0; s < of->result->station_count; s++)
        for (size_t which = 0; which < KINDS && !of->result->stations[s].twists; which++) {
            const figure_place place = {
                .kind = &runup_polar_figure, .table = table, .point = NO_POINT, .station = s, .which = which};
            snprintf(name, sizeof name, "%s-%.63s", alike[which].name, of->result->stations[s].name);
            list_figure(to, &place, name, alike[which].title, of->result->stations[s].name);
        }
}

static void polar_describe_any(const drawing *of, const figure_place *place, whirl_figure *figure) {
    if (place->which == POLAR)
        polar_describe(of, place, figure);
    else
        centreline_describe(of, place, figure);
}

const figure_kind runup_polar_figure = {.list = polar_list, .describe = polar_describe_any};
