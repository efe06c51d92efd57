// Orbits of motions in a lateral analysis: for every station with a clearance, the motions of the table within the
// walls around it.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "machine_at.h"
#include "point_panels.h"
#include "quantities.h"
#include "shown_kinds.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

enum { MAX_STATIONS = 12, MAX_MOTIONS = 6, STEPS = 180 };

/// Finds the motions to draw, the first ones with a waveform; returns their number.
static size_t motions_of(const whirl_table *table, size_t motions[MAX_MOTIONS]) {
    size_t count = 0;
    for (size_t i = 0; i < table->count && count < MAX_MOTIONS; i++)
        if (whirl_table_done(table, i) && point_waveform(table, i, 0).at) motions[count++] = i;
    return count;
}

/// Selects the stations with walls, in their order, and returns their number. Of too many it selects those whose
/// motions come nearest to a wall.
static size_t stations_of(const drawing *of, const whirl_table *table, const size_t *motions, size_t count,
                          size_t stations[MAX_STATIONS]) {
    double shares[MAX_STATIONS];
    size_t used = 0;
    // Compute each station's largest radius over its walls, in all motions.
    for (size_t s = 0; s < of->result->station_count; s++) {
        double share = 0.0;
        for (size_t k = 0; k < count; k++) {
            const machine_walls walls = machine_walls_at(of->machine, of->result, table, motions[k], s);
            const double radius = max_radius(table, motions[k], s), all[] = {walls.clearance, walls.gap};
            for (size_t i = 0; i < 2; i++)
                if (all[i] > 0.0) share = fmax(share, radius / all[i]);
        }
        if (!(share > 0.0)) continue;
        // Keep the station if there is room, or in place of the kept one with the least share, if that is less.
        size_t least = 0;
        for (size_t i = 1; i < used; i++)
            if (shares[i] < shares[least]) least = i;
        if (used == MAX_STATIONS && share <= shares[least]) continue;
        if (used == MAX_STATIONS) {
            memmove(shares + least, shares + least + 1, (used - least - 1) * sizeof *shares);
            memmove(stations + least, stations + least + 1, (used - least - 1) * sizeof *stations);
            used--;
        }
        shares[used] = share;
        stations[used++] = s;
    }
    return used;
}

static void orbits_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &orbits_figure, .table = table, .point = NO_POINT};
    size_t motions[MAX_MOTIONS], stations[MAX_STATIONS];
    if (!accompanying_motions(table)) return;
    const size_t count = motions_of(table, motions);
    if (count == 0 || stations_of(of, table, motions, count, stations) == 0) return;
    char name[WHIRL_NAME_SIZE];
    const char *const own_name = table->name + strlen("motions");
    snprintf(name, sizeof name, "orbits%s%s", *own_name ? "-" : "", *own_name ? own_name + 1 : "");
    list_figure(to, &place, name, "Orbits within their clearances: %.60s", table->name);
}

void stator_line(whirl_figure *figure, whirl_panel *panel, double radius) {
    if (!(radius > 0.0)) return;
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, "#707070", 0.53);
    if (line) line->dashed = true;
    for (int k = 0; k <= STEPS; k++) {
        const double angle = 2.0 * 3.14159265358979323846 * k / STEPS;
        series_add(figure, line, radius * cos(angle), radius * sin(angle));
    }
}

double wall_line(whirl_figure *figure, whirl_panel *panel, const machine_wall *wall, double scale) {
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, "#9A9A9A", 0.9);
    double most = 0.0;
    for (size_t k = 0; k <= WALL_ANGLES; k += 2) {
        const double angle = 2.0 * 3.14159265358979323846 * (double)k / WALL_ANGLES;
        const double radius = scale * wall->radius[k % WALL_ANGLES];
        series_add(figure, line, radius * cos(angle), radius * sin(angle));
        most = fmax(most, radius);
    }
    return most;
}

/// Draws the walls around a station for all motions (a parameter may change the clearance). Returns the largest radius
/// in the shown unit.
static double add_walls(whirl_figure *figure, whirl_panel *panel, const drawing *of, const whirl_table *table,
                        size_t station, const size_t *motions, size_t count) {
    double widest = 0.0, clearances[MAX_MOTIONS], gaps[MAX_MOTIONS];
    for (size_t k = 0; k < count; k++) {
        const machine_walls walls = machine_walls_at(of->machine, of->result, table, motions[k], station);
        const double scale = whirl_shown_length(of->units, table, motions[k]);
        bool film = true, stator = true; // not drawn yet
        clearances[k] = scale * walls.clearance;
        gaps[k] = scale * walls.gap;
        for (size_t i = 0; i < k; i++) {
            film = film && fabs(clearances[i] - clearances[k]) > 1e-9 * clearances[k];
            stator = stator && fabs(gaps[i] - gaps[k]) > 1e-9 * gaps[k];
        }
        widest = fmax(widest, fmax(clearances[k], gaps[k]));
        if (film && walls.clearance > 0.0) {
            machine_wall wall;
            machine_wall_at(of->machine, table, motions[k], station, walls.clearance, &wall);
            widest = fmax(widest, wall_line(figure, panel, &wall, scale));
        }
        if (stator) stator_line(figure, panel, gaps[k]);
    }
    return widest;
}

/// Adds a panel with the motions at a station; only the first panel's motions are in the legend.
static void add_station(whirl_figure *figure, const drawing *of, const whirl_table *table, size_t station,
                        const size_t *motions, size_t count) {
    const char *name = of->result->stations[station].name;
    // Set up a panel with bearing and stator.
    whirl_panel *panel = figure_panel(figure, name, 1.0 / 3.0, 2.2);
    if (!panel) return;
    snprintf(panel->title, sizeof panel->title, "%.60s", name);
    panel->equal = true;
    const double size = 1.08 * add_walls(figure, panel, of, table, station, motions, count);
    axis_show(&panel->x, (span){-size, size});
    axis_show(&panel->y, (span){-size, size});
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$x$", panel->x.label, sizeof panel->x.label);
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$y$", panel->y.label, sizeof panel->y.label);
    // Draw the kept samples of each motion, with marks once a revolution.
    const int all = whirl_record_samples(&table->record, table->integrate.steps_per_revolution);
    const size_t turn = all > 0 ? (size_t)all : 1;
    for (size_t k = 0; k < count; k++) {
        const numbers samples = point_waveform(table, motions[k], station);
        const double length = whirl_shown_length(of->units, table, motions[k]);
        char label[UNIT_LABEL_SIZE] = "";
        if (figure->count == 1) units_point_label(of->units, table, motions[k], label, sizeof label);
        whirl_series *line = panel_named(figure, panel, WHIRL_LINE, label, line_colour(k), 0.7);
        for (size_t i = 0; i < samples.rows; i++)
            series_add(figure, line, length * samples.at[2 * i], length * samples.at[2 * i + 1]);
        orbit_marks(figure, panel, &samples, turn, length, 0.06 * size, line_colour(k), 1.7);
    }
}

static void orbits_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    size_t motions[MAX_MOTIONS], stations[MAX_STATIONS];
    const size_t count = motions_of(table, motions), used = stations_of(of, table, motions, count, stations);
    for (size_t i = 0; i < used; i++) add_station(figure, of, table, stations[i], motions, count);
    snprintf(
        figure->caption, sizeof figure->caption,
        "Orbits of the motions over their last revolutions, about the middle of every clearance%s: full grey lines "
        "are the limits of the journal's centre in films and seals, dashed ones stators that may be "
        "touched; dots mark each revolution, when the mark is at the x axis; arrows show the direction of motion.",
        used == MAX_STATIONS ? ", of the stations that come nearest to a wall" : "");
}

const figure_kind orbits_figure = {.list = orbits_list, .describe = orbits_describe};
