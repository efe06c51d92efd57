// Figures of the motions in run-ups: orbits at some moments, and waveforms of stations and contacts.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine_at.h"
#include "point_panels.h"
#include "runup_panels.h"

/// Figures of motions: values of figure_place.which. For a figure of a contact, figure_place.station is the index of
/// the contact.
enum { ORBITS, WAVEFORMS, CONTACT_WAVEFORMS, KINDS };

static const struct {
    const char *name, *title, *field, *option;
} alike[KINDS] = {
    {"runup-orbit", "Orbits of %.60s in the run", WHIRL_FIELD_RUNUP_ORBIT, "orbits"},
    {"runup-waveform", "Waveforms of %.60s", WHIRL_FIELD_RUNUP_WAVEFORM, "waveform"},
    {"runup-contact", "Force and gap of %.60s", WHIRL_FIELD_RUNUP_CONTACT_FORCE, "waveform"},
};

/// Largest number of orbits in a figure, including the orbit of the largest motion.
enum { MAX_ORBITS = 9 };

// ---------------------------------------------------------------- orbits

void runup_orbit_panel(const drawing *of, const figure_place *place, size_t run, const double *orbit, double time,
                       double speed, const char *what, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const whirl_unit *seconds = &of->units->of[WHIRL_QUANTITY_TIME], *rate = &of->units->of[WHIRL_QUANTITY_SPEED];
    const size_t count = (size_t)table->record.runup.samples;
    const double length = whirl_shown_length(of->units, table, run);
    const machine_walls walls = machine_walls_at(of->machine, of->result, table, run, place->station);
    whirl_panel *panel = figure_panel(figure, what, 1.0 / 3.0, 2.9);
    double *closed = malloc(2 * (count + 1) * sizeof *closed), size = 0.0;
    figure->failed = figure->failed || !panel || !closed;
    if (panel && closed) {
        // Close the orbit by its first sample, at the beginning of the turn.
        memcpy(closed, orbit, 2 * count * sizeof *closed);
        memcpy(closed + 2 * count, orbit, 2 * sizeof *closed);
        panel->equal = true;
        snprintf(panel->title, sizeof panel->title, "%.4g %.16s, %.4g %.16s", time / seconds->size, seconds->name,
                 speed / rate->size, rate->name);
        symbol_length(of->units, WHIRL_FROM_CENTRE, "$x$", panel->x.label, sizeof panel->x.label);
        symbol_length(of->units, WHIRL_FROM_CENTRE, "$y$", panel->y.label, sizeof panel->y.label);
        if (walls.clearance > 0.0) {
            machine_wall wall;
            machine_wall_at(of->machine, table, run, place->station, walls.clearance, &wall);
            size = wall_line(figure, panel, &wall, length);
        }
        for (size_t k = 0; k < count; k++) size = fmax(size, length * hypot(orbit[2 * k], orbit[2 * k + 1]));
        if (length * walls.gap < 2.0 * size) {
            stator_line(figure, panel, length * walls.gap);
            size = fmax(size, length * walls.gap);
        }
        size = size > 0.0 ? 1.08 * size : 1.0;
        axis_show(&panel->x, (span){-size, size});
        axis_show(&panel->y, (span){-size, size});
        whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.7);
        for (size_t k = 0; k < count; k++) series_add(figure, line, length * orbit[2 * k], length * orbit[2 * k + 1]);
        const numbers samples = {.at = closed, .rows = count + 1, .columns = 2};
        orbit_marks(figure, panel, &samples, count, length, 0.1 * size, line_colour(0), 2.2);
    }
    free(closed);
}

static void orbits_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const size_t samples = (size_t)table->record.runup.samples, all = (size_t)table->record.runup.orbits;
    size_t runs[MAX_RUNS];
    if (runup_list_runs(table, runs) == 0) return;
    const double *times = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_ORBIT_TIME, 0);
    const double *speeds = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_ORBIT_SPEED, 0);
    const double *orbits = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_ORBIT, place->station);
    const double *peak = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_PEAK_ORBIT, place->station);
    const size_t step = (all + MAX_ORBITS - 2) / (MAX_ORBITS - 1);
    if (!times || !speeds || !orbits || !peak) return;
    figure->width = 17.5;
    // Draw every `step`-th orbit, counted from the last of the run.
    for (size_t left = (all - 1) / step + 1; left > 0; left--) {
        const size_t k = all - 1 - (left - 1) * step;
        char name[32];
        snprintf(name, sizeof name, "orbit-%zu", k + 1);
        if (isfinite(times[k]))
            runup_orbit_panel(of, place, runs[0], orbits + 2 * k * samples, times[k], speeds[k], name, figure);
    }
    // Draw the orbit of the largest motion.
    if (isfinite(peak[0])) {
        runup_orbit_panel(
            of, place, runs[0], peak, whirl_table_number(table, runs[0], WHIRL_FIELD_RUNUP_PEAK_TIME, place->station),
            whirl_table_number(table, runs[0], WHIRL_FIELD_RUNUP_PEAK_SPEED, place->station), "peak", figure);
    }
    snprintf(
        figure->caption, sizeof figure->caption,
        "Orbits of %.60s over single turns of the shaft; the last panel shows its largest motion. A dot marks where "
        "the turn begins (the mark is at the x axis), an arrow the direction of motion; walls are grey.",
        of->result->stations[place->station].name);
    runup_caption_runs(of, table, 1, figure);
}

// ---------------------------------------------------------------- waveforms

/// A waveform to draw: a column of a field over the time, and their units.
typedef struct waveform {
    const double *times, *values; ///< [count], [count][columns]
    size_t count, columns, column;
    double time_unit, factor;
} waveform;

static bool waveform_is_there(const waveform *of) {
    return of->times && of->values && of->count > 0 && isfinite(of->times[0]);
}

static void waveform_add_line(whirl_figure *figure, whirl_series *line, const waveform *of) {
    for (size_t k = 0; k < of->count && isfinite(of->times[k]); k++)
        series_add(figure, line, of->times[k] / of->time_unit, of->factor * of->values[k * of->columns + of->column]);
}

/// Adds a panel for a waveform. window: 0 around the largest value, else around event `window`.
static whirl_panel *waveform_panel(const drawing *of, const char *quantity, const char *largest, size_t window,
                                   double height, whirl_figure *figure) {
    char name[2 * WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, window == 0 ? "%.40s" : "%.40s-event-%zu", quantity, window);
    whirl_panel *panel = figure_panel(figure, name, 1.0, height);
    if (!panel) return NULL;
    if (window == 0)
        snprintf(panel->title, sizeof panel->title, "around the largest %s", largest);
    else
        snprintf(panel->title, sizeof panel->title, "around event %zu", window);
    runup_label_over(of, &panel->x, false);
    return panel;
}

static waveform waveform_of(const drawing *of, const whirl_table *table, size_t run, const char *times,
                            const char *values, size_t which, size_t window) {
    const whirl_field *field = whirl_layout_field(&table->layout, values);
    const size_t count = field ? field->rows / WHIRL_RUNUP_WAVEFORMS : 0;
    waveform made = {.times = whirl_table_field(table, run, times, which),
                     .values = whirl_table_field(table, run, values, which),
                     .count = count,
                     .columns = field ? field->columns : 1,
                     .time_unit = of->units->of[WHIRL_QUANTITY_TIME].size};
    if (made.times) made.times += window * count;
    if (made.values) made.values += window * count * made.columns;
    return made;
}

static void waveforms_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    static const char *const names[] = {"$x$", "$y$"};
    const whirl_table *table = place->table;
    size_t runs[MAX_RUNS];
    // Waveforms are those of the first run.
    if (runup_list_runs(table, runs) == 0) return;
    figure->width = 17.5;
    // Draw a panel for each window that was recorded.
    for (size_t window = 0; window < WHIRL_RUNUP_WAVEFORMS; window++) {
        waveform own = waveform_of(of, table, runs[0], WHIRL_FIELD_RUNUP_WAVEFORM_TIME, WHIRL_FIELD_RUNUP_WAVEFORM,
                                   place->station, window);
        whirl_panel *panel =
            waveform_is_there(&own) ? waveform_panel(of, "motion", "motion", window, 3.6, figure) : NULL;
        if (!panel) continue;
        own.factor = whirl_shown_length(of->units, table, runs[0]);
        symbol_length(of->units, WHIRL_FROM_CENTRE, "$x$, $y$", panel->y.label, sizeof panel->y.label);
        for (own.column = 0; own.column < 2; own.column++)
            waveform_add_line(
                figure, panel_named(figure, panel, WHIRL_LINE, names[own.column], line_colour(own.column), 0.6), &own);
        // Draw the axial displacement of a station that moves along its shaft, and the twist of one that twists.
        for (int twists = 0; twists < 2; twists++) {
            waveform extra = waveform_of(of, table, runs[0], WHIRL_FIELD_RUNUP_WAVEFORM_TIME,
                                         twists ? WHIRL_FIELD_RUNUP_TWIST_WAVEFORM : WHIRL_FIELD_RUNUP_AXIAL_WAVEFORM,
                                         place->station, window);
            if (!extra.values || !isfinite(extra.values[0])) continue;
            whirl_panel *below = waveform_panel(of, twists ? "twist" : "axial", "motion", window, 2.8, figure);
            if (!below) return;
            below->title[0] = '\0';
            extra.factor = twists ? 180.0 / acos(-1.0) : own.factor;
            if (twists)
                snprintf(below->y.label, sizeof below->y.label, "twist (\u00b0)");
            else
                symbol_length(of->units, WHIRL_FROM_CENTRE, "axial displacement", below->y.label,
                              sizeof below->y.label);
            waveform_add_line(figure, panel_series(figure, below, WHIRL_LINE, line_colour(2), 0.6), &extra);
        }
    }
    // Describe the windows.
    snprintf(figure->caption, sizeof figure->caption,
             "Motion of %.60s over %d turns of the shaft around its largest and around the first events of the run.",
             of->result->stations[place->station].name, table->record.runup.waveform);
    runup_caption_runs(of, table, 1, figure);
}

static void contact_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const whirl_unit *unit = &of->units->of[WHIRL_QUANTITY_FORCE];
    size_t runs[MAX_RUNS];
    // Waveforms are those of the first run.
    if (runup_list_runs(table, runs) == 0) return;
    figure->width = 17.5;
    for (size_t window = 0; window < WHIRL_RUNUP_WAVEFORMS; window++) {
        // Find the recorded force and gap of the window.
        waveform force = waveform_of(of, table, runs[0], WHIRL_FIELD_RUNUP_CONTACT_TIME,
                                     WHIRL_FIELD_RUNUP_CONTACT_FORCE, place->station, window);
        waveform gap = waveform_of(of, table, runs[0], WHIRL_FIELD_RUNUP_CONTACT_TIME, WHIRL_FIELD_RUNUP_CONTACT_GAP,
                                   place->station, window);
        if (!waveform_is_there(&force) || !waveform_is_there(&gap)) continue;
        // Set up two panels, the gap below the force.
        whirl_panel *panel = waveform_panel(of, "force", "force", window, 2.8, figure);
        whirl_panel *below = waveform_panel(of, "gap", "force", window, 2.8, figure);
        if (!panel || !below) return;
        below->title[0] = '\0';
        force.factor = of->result->force_scale / unit->size;
        gap.factor = whirl_shown_length(of->units, table, runs[0]);
        snprintf(panel->y.label, sizeof panel->y.label, "normal force (%s)", unit->name);
        symbol_length(of->units, WHIRL_FROM_CENTRE, "gap", below->y.label, sizeof below->y.label);
        // Draw both, and the line of gap 0.
        waveform_add_line(figure, panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.6), &force);
        whirl_series *line = panel_series(figure, below, WHIRL_LINE, line_colour(1), 0.6);
        waveform_add_line(figure, line, &gap);
        if (!line || line->count == 0) continue;
        whirl_series *closed = panel_series(figure, below, WHIRL_LINE, "#9A9A9A", 0.4);
        series_add(figure, closed, line->x[0], 0.0);
        series_add(figure, closed, line->x[line->count - 1], 0.0);
    }
    // Describe the windows.
    snprintf(figure->caption, sizeof figure->caption,
             "Normal force and gap of %.60s over %d turns of the shaft, around its largest force and around the first "
             "events of the run. A gap below 0 means that the contact is compressed.",
             of->result->contacts[place->station], table->record.runup.waveform);
    runup_caption_runs(of, table, 1, figure);
}

// ---------------------------------------------------------------- the figures

static void motion_list(figure_list *to, const drawing *of, const whirl_table *table) {
    char name[2 * WHIRL_NAME_SIZE];
    size_t runs[MAX_RUNS];
    if (!table_has(table, WHIRL_FIELD_RUNUP_END) || table->role == WHIRL_ROLE_RECORDS ||
        runup_list_runs(table, runs) == 0)
        return;
    for (size_t which = 0; which < KINDS; which++) {
        const bool contacts = which == CONTACT_WAVEFORMS;
        const size_t count = contacts ? of->result->contact_count : of->result->station_count;
        for (size_t i = 0; i < count && table_has(table, alike[which].field); i++) {
            const char *const owner = contacts ? of->result->contacts[i] : of->result->stations[i].name;
            const figure_place place = {
                .kind = &runup_motion_figure, .table = table, .point = NO_POINT, .station = i, .which = which};
            if (!contacts && of->result->stations[i].twists) continue;
            snprintf(name, sizeof name, "%s-%.63s", alike[which].name, owner);
            list_figure(to, &place, name, alike[which].title, owner);
        }
    }
}

static whirl_status motion_find(figure_list *list, const drawing *of, const char *name) {
    whirl_status status = whirl_ok();
    (void)list;
    for (size_t which = 0; which < KINDS && status.code == WHIRL_OK; which++)
        if (which != CONTACT_WAVEFORMS || strncmp(name, "runup-contacts", strlen("runup-contacts")) != 0)
            status = runup_find(of, name, alike[which].name, alike[which].field, alike[which].option);
    return status;
}

static void motion_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    if (place->which == ORBITS)
        orbits_describe(of, place, figure);
    else if (place->which == WAVEFORMS)
        waveforms_describe(of, place, figure);
    else
        contact_describe(of, place, figure);
}

const figure_kind runup_motion_figure = {.list = motion_list, .describe = motion_describe, .find = motion_find};
