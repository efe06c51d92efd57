// Figures of a single turn of a run-up: the orbit with the mark, the motion, forces and gaps of contacts, and torques
// over the angle of the shaft.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "machine_at.h"
#include "point_panels.h"
#include "runup_panels.h"
#include "shown_kinds.h"
#include "whirl/engine/case.h"

static const char turn_stem[] = "runup-turn-";

/// Largest number of panels of torques between stations, and of contacts.
enum { MAX_TURN_TORQUES = 6, MAX_TURN_CONTACTS = 4 };

/// The turn of a figure.
typedef struct turn_view {
    const drawing *of;
    const whirl_table *table;
    size_t run, orbit, station;
    size_t samples;
} turn_view;

static const double *turn_field(const turn_view *t, const char *field, size_t which) {
    return whirl_table_field(t->table, t->run, field, which);
}

/// Adds a panel over the angle of the shaft.
static whirl_panel *turn_panel(const char *name, double height, whirl_figure *figure) {
    whirl_panel *panel = figure_panel(figure, name, 1.0, height);
    if (!panel) return NULL;
    snprintf(panel->x.label, sizeof panel->x.label, "angle of the shaft from the mark (°)");
    axis_show(&panel->x, (span){0.0, 360.0});
    return panel;
}

/// Adds a line: column `column` of values [samples][columns], times `factor`.
static void turn_line(const turn_view *t, whirl_figure *figure, whirl_series *line, const double *values,
                      size_t columns, size_t column, double factor) {
    for (size_t k = 0; k < t->samples; k++)
        series_add(figure, line, 360.0 * (double)k / (double)t->samples, factor * values[k * columns + column]);
}

static void turn_add_motion(const turn_view *t, whirl_figure *figure) {
    static const char *const names[] = {"$x$", "$y$"};
    const double *orbit = turn_field(t, WHIRL_FIELD_RUNUP_ORBIT, t->station) + 2 * t->orbit * t->samples;
    const bool twists = t->of->result->stations[t->station].twists;
    whirl_panel *panel = turn_panel(twists ? "twist" : "motion", 3.2, figure);
    if (!panel) return;
    // A twist is the displacement of a point 1 m from the axis.
    const double scale = whirl_result_length_scale(t->of->result, t->table, t->run);
    const double factor = twists ? scale * 180.0 / acos(-1.0) : whirl_shown_length(t->of->units, t->table, t->run);
    if (twists)
        snprintf(panel->y.label, sizeof panel->y.label, "twist (°)");
    else
        symbol_length(t->of->units, WHIRL_FROM_CENTRE, "$x$, $y$", panel->y.label, sizeof panel->y.label);
    for (size_t axis = 0; axis < (twists ? 1 : 2); axis++)
        turn_line(t, figure, panel_named(figure, panel, WHIRL_LINE, twists ? "" : names[axis], line_colour(axis), 0.7),
                  orbit, 2, axis, factor);
    runup_show_below_legend(panel);
}

static void turn_add_contacts(const turn_view *t, whirl_figure *figure) {
    const size_t contacts = t->of->result->contact_count, first = t->orbit * t->samples;
    const whirl_unit *unit = &t->of->units->of[WHIRL_QUANTITY_FORCE];
    if (contacts == 0) return;
    // Draw forces, and gaps below, of the first contacts.
    whirl_panel *force = turn_panel("force", 2.6, figure), *gap = turn_panel("gap", 2.6, figure);
    if (!force || !gap) return;
    snprintf(force->y.label, sizeof force->y.label, "normal force (%s)", unit->name);
    symbol_length(t->of->units, WHIRL_FROM_CENTRE, "gap", gap->y.label, sizeof gap->y.label);
    for (size_t c = 0; c < contacts && c < MAX_TURN_CONTACTS; c++) {
        turn_line(t, figure, panel_named(figure, force, WHIRL_LINE, t->of->result->contacts[c], line_colour(c), 0.7),
                  turn_field(t, WHIRL_FIELD_RUNUP_ORBIT_FORCE, c) + first, 1, 0,
                  t->of->result->force_scale / unit->size);
        turn_line(t, figure, panel_series(figure, gap, WHIRL_LINE, line_colour(c), 0.7),
                  turn_field(t, WHIRL_FIELD_RUNUP_ORBIT_GAP, c) + first, 1, 0,
                  whirl_shown_length(t->of->units, t->table, t->run));
    }
    runup_show_below_legend(force);
    whirl_series *closed = panel_series(figure, gap, WHIRL_LINE, "#9A9A9A", 0.4);
    series_add(figure, closed, 0.0, 0.0);
    series_add(figure, closed, 360.0, 0.0);
}

/// Adds the torques on the shaft that are not 0 throughout the turn.
static void turn_add_torques(const turn_view *t, whirl_figure *figure) {
    enum { TORQUES = SHAFT_TORQUES };
    const whirl_unit *unit = &t->of->units->of[WHIRL_QUANTITY_MOMENT];
    const double *values = turn_field(t, WHIRL_FIELD_RUNUP_ORBIT_TORQUE, 0);
    if (!values) return;
    values += TORQUES * t->orbit * t->samples;
    whirl_panel *panel = NULL;
    for (size_t i = 0; i < TORQUES; i++) {
        double largest = 0.0;
        for (size_t k = 0; k < t->samples; k++) largest = fmax(largest, fabs(values[TORQUES * k + i]));
        if (!(largest > 0.0)) continue;
        if (!panel) panel = turn_panel("torque", 3.2, figure);
        if (!panel) return;
        snprintf(panel->y.label, sizeof panel->y.label, "torque (%s)", unit->name);
        turn_line(t, figure, panel_named(figure, panel, WHIRL_LINE, shaft_torque_names[i], line_colour(i + 1), 0.7),
                  values, TORQUES, i, 1.0 / unit->size);
    }
    if (panel) runup_show_below_legend(panel);
}

/// Names a shaft of a machine with several: by its name if its speed is its own, else by its stations.
static void turn_name_shaft(const turn_view *t, size_t shaft, char *name, size_t size) {
    const size_t own = (size_t)t->table->record.runup.shaft_count;
    const char *first = NULL, *last = NULL;
    if (shaft > 0 && shaft <= own) {
        char word[WHIRL_NAME_SIZE];
        whirl_runup_shaft_name(&t->table->record.runup, shaft - 1, word);
        snprintf(name, size, "%s", word);
        return;
    }
    for (size_t s = 0; s < t->of->result->station_count; s++) {
        const double *of = turn_field(t, WHIRL_FIELD_RUNUP_ORBIT_SHAFT, s);
        if (!of || *of != (double)shaft) continue;
        if (!first) first = t->of->result->stations[s].name;
        last = t->of->result->stations[s].name;
    }
    if (!first)
        snprintf(name, size, "shaft %zu", shaft + 1);
    else
        snprintf(name, size, first == last ? "shaft of %.60s" : "shaft of %.60s to %.60s", first, last);
}

/// Adds the torques on each shaft of a machine with several, a panel each. Returns false if it has only one.
static bool turn_add_shafts(const turn_view *t, whirl_figure *figure) {
    static const char *const names[] = {"motor", "load", "friction", "rotor", "drag", "gears", "inertia"};
    enum { PARTS = sizeof names / sizeof *names, INERTIA = PARTS - 1 };
    const whirl_field *listed = whirl_layout_field(&t->table->layout, WHIRL_FIELD_RUNUP_ORBIT_SHAFT_SPEED);
    const double *values = turn_field(t, WHIRL_FIELD_RUNUP_ORBIT_SHAFT_TORQUE, 0);
    const size_t all = (size_t)t->table->record.runup.orbits * t->samples;
    const whirl_unit *unit = &t->of->units->of[WHIRL_QUANTITY_MOMENT];
    if (!listed || !values || all == 0) return false;
    for (size_t shaft = 0; shaft < listed->rows / all; shaft++) {
        const double *own = values + PARTS * (shaft * all + t->orbit * t->samples);
        whirl_panel *panel = NULL;
        for (size_t i = 0; i < PARTS; i++) {
            double largest = 0.0;
            for (size_t k = 0; k < t->samples; k++) largest = fmax(largest, fabs(own[PARTS * k + i]));
            if (!(largest > 0.0)) continue;
            if (!panel) panel = turn_panel("shaft-torque", 3.2, figure);
            if (!panel) return true;
            snprintf(panel->y.label, sizeof panel->y.label, "torque (%s)", unit->name);
            whirl_series *line =
                panel_named(figure, panel, WHIRL_LINE, names[i], i == INERTIA ? "#9A9A9A" : line_colour(i + 1), 0.7);
            if (line) line->dashed = i == INERTIA;
            turn_line(t, figure, line, own, PARTS, i, 1.0 / unit->size);
        }
        if (!panel) continue;
        turn_name_shaft(t, shaft, panel->title, sizeof panel->title);
        runup_show_below_legend(panel);
    }
    return true;
}

/// Adds the torques of motors, shafts, couplings and meshes, the first ones, a panel each.
static void turn_add_courses(const turn_view *t, whirl_figure *figure) {
    const whirl_field *listed = whirl_layout_field(&t->table->layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
    const double *of_what = turn_field(t, WHIRL_FIELD_RUNUP_TORQUE_OF, 0);
    const double *values = turn_field(t, WHIRL_FIELD_RUNUP_ORBIT_TORQUE_COURSE, 0);
    const size_t all = (size_t)t->table->record.runup.orbits * t->samples;
    const whirl_unit *unit = &t->of->units->of[WHIRL_QUANTITY_MOMENT];
    for (size_t i = 0; listed && of_what && values && i < listed->rows && i < MAX_TURN_TORQUES; i++) {
        const double *own = values + i * all + t->orbit * t->samples;
        char name[2 * WHIRL_NAME_SIZE + 40];
        if (!isfinite(own[0])) continue;
        whirl_panel *panel = turn_panel("course", 2.2, figure);
        if (!panel) return;
        torque_name(t->of->result, of_what + 3 * i, name, sizeof name);
        snprintf(panel->title, sizeof panel->title, "%.80s", name);
        snprintf(panel->y.label, sizeof panel->y.label, "torque (%s)", unit->name);
        turn_line(t, figure, panel_series(figure, panel, WHIRL_LINE, line_colour(i), 0.7), own, 1, 0, 1.0 / unit->size);
    }
}

/// Adds the axial displacement of a station that moves along its shaft, or the twist of one that twists and also moves
/// otherwise. Returns false if it does not.
static bool turn_add_extra(const turn_view *t, bool twists, whirl_figure *figure) {
    const double *values =
        turn_field(t, twists ? WHIRL_FIELD_RUNUP_TWIST_ORBIT : WHIRL_FIELD_RUNUP_AXIAL_ORBIT, t->station);
    if (!values || !isfinite(values[t->orbit * t->samples])) return false;
    whirl_panel *panel = turn_panel(twists ? "twist" : "axial", 2.8, figure);
    if (!panel) return false;
    if (twists)
        snprintf(panel->y.label, sizeof panel->y.label, "twist (°)");
    else
        symbol_length(t->of->units, WHIRL_FROM_CENTRE, "axial displacement", panel->y.label, sizeof panel->y.label);
    const double factor = twists ? 180.0 / acos(-1.0) : whirl_shown_length(t->of->units, t->table, t->run);
    turn_line(t, figure, panel_series(figure, panel, WHIRL_LINE, line_colour(2), 0.7), values + t->orbit * t->samples,
              1, 0, factor);
    return true;
}

static void turn_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    size_t runs[MAX_RUNS];
    if (runup_list_runs(table, runs) == 0) return;
    const turn_view t = {.of = of,
                         .table = table,
                         .run = runs[0],
                         .orbit = place->column,
                         .station = place->station,
                         .samples = (size_t)table->record.runup.samples};
    const double *orbits = turn_field(&t, WHIRL_FIELD_RUNUP_ORBIT, t.station);
    const double *speeds = turn_field(&t, WHIRL_FIELD_RUNUP_ORBIT_SPEED, 0);
    const double *times = turn_field(&t, WHIRL_FIELD_RUNUP_ORBIT_TIME, 0);
    if (!orbits || !speeds || !times) return;
    figure->width = 17.5;
    if (!of->result->stations[t.station].twists)
        runup_orbit_panel(of, place, t.run, orbits + 2 * t.orbit * t.samples, times[t.orbit], speeds[t.orbit], "orbit",
                          figure);
    turn_add_motion(&t, figure);
    const bool axial = turn_add_extra(&t, false, figure), twist = turn_add_extra(&t, true, figure);
    turn_add_contacts(&t, figure);
    const bool shafts = turn_add_shafts(&t, figure);
    if (!shafts) turn_add_torques(&t, figure);
    turn_add_courses(&t, figure);
    // Describe the turn and the panels.
    const whirl_unit *seconds = &of->units->of[WHIRL_QUANTITY_TIME], *rate = &of->units->of[WHIRL_QUANTITY_SPEED];
    snprintf(
        figure->caption, sizeof figure->caption,
        "%.60s in the turn at %.5g %.16s, %.5g %.16s, over the angle of the shaft from the mark on%s%s%s%s. Torques "
        "are positive where they drive; those that are 0 throughout the turn are left out.%s",
        of->result->stations[t.station].name, times[t.orbit] / seconds->size, seconds->name,
        speeds[t.orbit] / rate->size, rate->name,
        of->result->stations[t.station].twists ? "" : ": orbit (dot: at the mark) and motion",
        axial ? "; axial displacement" : "", twist ? "; twist" : "",
        of->result->contact_count > 0 ? "; normal forces and gaps of contacts, below 0 where they are compressed" : "",
        shafts ? " Dashed: inertia of a shaft times its acceleration, the sum of the torques on it." : "");
    runup_caption_runs(of, table, 1, figure);
}

/// Returns the orbit of a run whose time is nearest; the number of orbits if there is none.
static size_t turn_nearest(const whirl_table *table, size_t run, double time) {
    const size_t all = (size_t)table->record.runup.orbits;
    const double *times = whirl_table_field(table, run, WHIRL_FIELD_RUNUP_ORBIT_TIME, 0);
    size_t best = all;
    for (size_t k = 0; times && k < all; k++)
        if (isfinite(times[k]) && (best == all || fabs(times[k] - time) < fabs(times[best] - time))) best = k;
    return best;
}

/// Adds the figure of a station in the turn nearest to a time, if the first run of the table has orbits.
static bool turn_add(figure_list *to, const drawing *of, const whirl_table *table, size_t station, double time) {
    size_t runs[MAX_RUNS];
    char name[2 * WHIRL_NAME_SIZE];
    if (!table_has(table, WHIRL_FIELD_RUNUP_ORBIT_INSTANT) || table->role == WHIRL_ROLE_RECORDS ||
        runup_list_runs(table, runs) == 0)
        return false;
    const bool asked = isfinite(time);
    if (!asked) time = whirl_table_number(table, runs[0], WHIRL_FIELD_RUNUP_PEAK_TIME, station);
    const size_t orbit = turn_nearest(table, runs[0], time);
    if (orbit == (size_t)table->record.runup.orbits) return false;
    const figure_place place = {
        .kind = &runup_turn_figure, .table = table, .point = (long)runs[0], .station = station, .column = orbit};
    const double at = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_ORBIT_TIME, 0)[orbit];
    const whirl_unit *seconds = &of->units->of[WHIRL_QUANTITY_TIME];
    // A figure that is made on request has the time in its name.
    char moment[40] = "";
    if (asked) snprintf(moment, sizeof moment, "-%.5g-%.16s", at / seconds->size, seconds->name);
    snprintf(name, sizeof name, "%s%.63s%s", turn_stem, of->result->stations[station].name, moment);
    list_figure(to, &place, name, "%.60s in the turn at %.5g %.16s", of->result->stations[station].name,
                at / seconds->size, seconds->name);
    return true;
}

static void turn_list(figure_list *to, const drawing *of, const whirl_table *table) {
    for (size_t s = 0; s < of->result->station_count; s++)
        if (!of->result->stations[s].twists) turn_add(to, of, table, s, (double)NAN);
}

/// Returns the listed figure of a turn with this name, in the tables of the drawing; NULL if there is none.
static const figure_place *turn_listed(const figure_list *list, const drawing *of, const char *name) {
    for (const figure_place *place = list->items; place < list->items + list->count; place++)
        if (place->kind == &runup_turn_figure && place->table >= of->result->tables &&
            place->table < of->result->tables + of->result->table_count &&
            (strcmp(place->name.name, name) == 0 || strcmp(place->within, name) == 0))
            return place;
    return NULL;
}

/// Finds "runup-turn-STATION@TIME", and the turn of a station that twists.
static whirl_status turn_find(figure_list *list, const drawing *of, const char *name) {
    double time = NAN;
    char whole[2 * WHIRL_NAME_SIZE];
    size_t station = 0;
    if (strncmp(name, turn_stem, strlen(turn_stem)) != 0) return whirl_ok();
    whirl_status status = runup_find(of, name, turn_stem, WHIRL_FIELD_RUNUP_ORBIT_INSTANT, "orbits");
    // Read the time behind the last @, and the name before it: that of a listed figure, or of a station.
    const char *const at = strrchr(name, '@');
    snprintf(whole, sizeof whole, "%.*s", at ? (int)(at - name) : (int)sizeof whole - 1, name);
    const char *const word = whole + strlen(turn_stem);
    if (status.code == WHIRL_OK && at) status = whirl_quantity_value(at + 1, "s", &time);
    if (status.code != WHIRL_OK) return status;
    const figure_place *const listed = turn_listed(list, of, whole);
    while (!listed && station < of->result->station_count && strcmp(of->result->stations[station].name, word) != 0)
        station++;
    if (listed) station = listed->station;
    if (station == of->result->station_count) return whirl_fail(WHIRL_BAD_INPUT, "there is no station '%.60s'", word);
    // Show the run of the listed figure, or the first one that kept turns.
    const whirl_table *const end = of->result->tables + of->result->table_count;
    for (const whirl_table *table = listed ? listed->table : of->result->tables; table < end; table++) {
        size_t runs[MAX_RUNS];
        if (!table_has(table, WHIRL_FIELD_RUNUP_ORBIT_INSTANT) || runup_list_runs(table, runs) == 0) continue;
        const double last = whirl_table_number(table, runs[0], WHIRL_FIELD_RUNUP_END_TIME, 0);
        if (at && !(time >= 0.0 && time <= last * (1.0 + 1e-9)))
            return whirl_fail(WHIRL_BAD_INPUT, "the time is '%.60s', expected 0 to %.6g s, the end of the run", at + 1,
                              last);
        if (turn_add(list, of, table, station, time)) break;
    }
    return whirl_ok();
}

const figure_kind runup_turn_figure = {.list = turn_list, .describe = turn_describe, .find = turn_find};
