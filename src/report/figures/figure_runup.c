// Figures of run-ups: motions, speed and torques over the time, and motions over the speed.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "runup_panels.h"
#include "shown_kinds.h"
#include "units.h"

/// Figures of a run: values of figure_place.which.
enum { OVER_SPEED, OVER_TIME, ORDERS, SHAFTS, SHAFT, AXIAL, TWIST, CONTACTS, TORQUES };

enum { MAX_ORDERS = 4, MAX_TORQUE_PANELS = 6 };

/// Figures of motions besides x and y: their fields and words.
static const struct {
    int which;
    const char *name, *title, *motion, *amplitude, *lag, *extreme, *quantity, *about;
    bool twists;
} extras[] = {{AXIAL, "runup-axial", "%.60s along the shaft over the speed", WHIRL_FIELD_RUNUP_AXIAL,
               WHIRL_FIELD_RUNUP_AXIAL_AMPLITUDE, WHIRL_FIELD_RUNUP_AXIAL_LAG, WHIRL_FIELD_RUNUP_AXIAL_EXTREME,
               "axial displacement", "in the direction of growing positions", false},
              {TWIST, "runup-twist", "Twist of %.60s over the speed", WHIRL_FIELD_RUNUP_TWIST,
               WHIRL_FIELD_RUNUP_TWIST_AMPLITUDE, WHIRL_FIELD_RUNUP_TWIST_LAG, WHIRL_FIELD_RUNUP_TWIST_EXTREME, "twist",
               "relative to the mean turn", true}};

static void runup_list(figure_list *to, const drawing *of, const whirl_table *table) {
    // Figures that each station has.
    static const struct {
        size_t which;
        const char *name, *title;
    } alike[] = {{OVER_SPEED, "runup", "%.60s over the speed"},
                 {OVER_TIME, "runup-time", "%.60s over the time"},
                 {ORDERS, "runup-orders", "%.60s at multiples of the speed"},
                 {SHAFTS, "runup-shafts", "%.60s at the speeds of all shafts"}};
    char name[2 * WHIRL_NAME_SIZE];
    size_t runs[MAX_RUNS];
    // List figures only for tables with runs, which are not records of a data set.
    if (!table_has(table, WHIRL_FIELD_RUNUP_END) || table->role == WHIRL_ROLE_RECORDS ||
        runup_list_runs(table, runs) == 0)
        return;
    figure_place place = {.kind = &runup_figure, .table = table, .point = NO_POINT, .which = SHAFT};
    list_figure(to, &place, "runup-shaft", "Speed of the shaft over the time");
    // List the figures of stations, except those that twist.
    for (size_t s = 0; s < of->result->station_count; s++)
        for (size_t i = 0; i < sizeof alike / sizeof *alike && !of->result->stations[s].twists; i++) {
            if (alike[i].which == SHAFTS && !table_has(table, WHIRL_FIELD_RUNUP_SHAFT_TIME)) continue;
            place.which = alike[i].which;
            place.station = s;
            snprintf(name, sizeof name, "%s-%.63s", alike[i].name, of->result->stations[s].name);
            list_figure(to, &place, name, alike[i].title, of->result->stations[s].name);
        }
    // List the figures of stations that move along their shafts, and of those that twist and also move otherwise.
    for (size_t kind = 0; kind < sizeof extras / sizeof *extras; kind++)
        for (size_t s = 0; s < of->result->station_count && table_has(table, extras[kind].motion); s++) {
            if (!isfinite(whirl_table_number(table, runs[0], extras[kind].extreme, s))) continue;
            place.which = extras[kind].which;
            place.station = s;
            snprintf(name, sizeof name, "%s-%.63s", extras[kind].name, of->result->stations[s].name);
            list_figure(to, &place, name, extras[kind].title, of->result->stations[s].name);
        }
    // List the figures of contacts and torques.
    place.which = CONTACTS;
    if (of->result->contact_count > 0) list_figure(to, &place, "runup-contacts", "Contacts over the time");
    place.which = TORQUES;
    if (table_has(table, WHIRL_FIELD_RUNUP_TORQUE_OF))
        list_figure(to, &place, "runup-torques", "Torques over the time");
}

/// The run of a line, and the field over which it is drawn.
typedef struct course {
    const drawing *of;
    const whirl_table *table;
    size_t point;
    const char *over; ///< WHIRL_FIELD_RUNUP_TIME or _SPEED, or those of a shaft with a speed of its own
    double over_size;
    size_t shaft; ///< number of that shaft, from 1; 0: the rotor's
} course;

/// Adds a line through all rows of a column, times `factor`. The line of a lag breaks where the lag wraps.
static void runup_add_line(whirl_figure *figure, whirl_series *line, const course *c, const char *field, size_t which,
                           size_t column, double factor) {
    const whirl_field *shape = whirl_layout_field(&c->table->layout, field);
    const double *values = whirl_table_field(c->table, c->point, field, which);
    const double *over = whirl_table_field(c->table, c->point, c->over, 0);
    const bool wraps = strcmp(field, WHIRL_FIELD_RUNUP_LAG) == 0 || strcmp(field, WHIRL_FIELD_RUNUP_SHAFT_LAG) == 0 ||
                       strcmp(field, WHIRL_FIELD_RUNUP_AXIAL_LAG) == 0 ||
                       strcmp(field, WHIRL_FIELD_RUNUP_TWIST_LAG) == 0;
    const size_t rows = (size_t)c->table->record.runup.rows, first = c->shaft > 0 ? (c->shaft - 1) * rows : 0;
    double before = NAN;
    for (size_t row = first; shape && values && over && row < (c->shaft > 0 ? first + rows : shape->rows); row++) {
        const double value = values[row * shape->columns + column];
        if (!isfinite(over[row]) || !isfinite(value)) continue;
        if (wraps && fabs(value - before) > 180.0) series_break(figure, line);
        series_add(figure, line, over[row] / c->over_size, factor * value);
        before = value;
    }
}

static course runup_course_of(const drawing *of, const whirl_table *table, size_t point, bool by_speed) {
    const whirl_unit *speed = &of->units->of[WHIRL_QUANTITY_SPEED];
    return (course){of,
                    table,
                    point,
                    by_speed ? WHIRL_FIELD_RUNUP_SPEED : WHIRL_FIELD_RUNUP_TIME,
                    by_speed ? speed->size : of->units->of[WHIRL_QUANTITY_TIME].size,
                    0};
}

/// Returns the course of a shaft with a speed of its own, from 1.
static course runup_course_of_shaft(const drawing *of, const whirl_table *table, size_t point, size_t shaft,
                                    bool by_speed) {
    course c = runup_course_of(of, table, point, by_speed);
    c.over = by_speed ? WHIRL_FIELD_RUNUP_SHAFT_SPEED : WHIRL_FIELD_RUNUP_SHAFT_TIME;
    c.shaft = shaft;
    return c;
}

static whirl_panel *runup_length_panel(const drawing *of, whirl_figure *figure, const char *name,
                                       whirl_counting counting, const char *quantity, bool by_speed, double height) {
    whirl_panel *panel = figure_panel(figure, name, 1.0, height);
    if (!panel) return NULL;
    runup_label_over(of, &panel->x, by_speed);
    symbol_length(of->units, counting, quantity, panel->y.label, sizeof panel->y.label);
    return panel;
}

/// Draws the motion of a station: for one run the largest radius, and amplitudes and lags of x and y; for several runs
/// the largest radius and the lag of x of each.
static void runup_describe_motion(const drawing *of, const figure_place *place, whirl_figure *figure, bool by_speed) {
    static const char *const names[] = {"$x$ at 1X", "$y$ at 1X"};
    // Find the runs of the table.
    size_t runs[MAX_RUNS];
    const whirl_table *table = place->table;
    const size_t count = runup_list_runs(table, runs), s = place->station;
    // Draw the largest radius of every run.
    whirl_panel *panel = runup_length_panel(of, figure, "radius", WHIRL_ZERO_TO_PEAK, "largest radius", by_speed, 4.0);
    for (size_t i = 0; i < count; i++) {
        const course c = runup_course_of(of, table, runs[i], by_speed);
        char label[UNIT_LABEL_SIZE] = "";
        if (count > 1) units_point_label(of->units, table, runs[i], label, sizeof label);
        runup_add_line(figure, panel_named(figure, panel, WHIRL_LINE, label, line_colour(i), 1.0), &c,
                       WHIRL_FIELD_RUNUP_RADIUS, s, 0, units_length(of->units, table, runs[i], WHIRL_ZERO_TO_PEAK));
    }
    // For one run, draw amplitudes along x and y.
    whirl_panel *amplitude =
        count == 1 ? runup_length_panel(of, figure, "amplitude", WHIRL_AMPLITUDE, "amplitude", by_speed, 4.0) : NULL;
    for (size_t axis = 0; axis < 2 && amplitude; axis++) {
        const course c = runup_course_of(of, table, runs[0], by_speed);
        runup_add_line(figure, panel_named(figure, amplitude, WHIRL_LINE, names[axis], line_colour(axis + 1), 0.8), &c,
                       WHIRL_FIELD_RUNUP_AMPLITUDE, s, axis, units_length(of->units, table, runs[0], WHIRL_AMPLITUDE));
    }
    // Draw the lag along x and y, for several runs along x.
    whirl_panel *lag = figure_panel(figure, "lag", 1.0, 3.5);
    if (!lag) return;
    runup_label_over(of, &lag->x, by_speed);
    snprintf(lag->y.label, sizeof lag->y.label, "lag at 1X (\u00b0)");
    for (size_t i = 0; i < count; i++) {
        const course c = runup_course_of(of, table, runs[i], by_speed);
        for (size_t axis = 0; axis < (count == 1 ? 2u : 1u); axis++)
            runup_add_line(figure, panel_series(figure, lag, WHIRL_LINE, line_colour(count == 1 ? axis + 1 : i), 0.8),
                           &c, WHIRL_FIELD_RUNUP_LAG, s, axis, 1.0);
    }
    // Describe the panels.
    snprintf(figure->caption, sizeof figure->caption,
             "%.60s while the speed changes: the largest distance from the centre since the row before%s, and the "
             "lag of %s behind the mark on the shaft.",
             of->result->stations[s].name,
             count == 1 ? ", amplitudes of x and y at the speed of the shaft over its last turn" : " of each run",
             count == 1 ? "x and y" : "x");
}

static void runup_describe_orders(const drawing *of, const figure_place *place, whirl_figure *figure) {
    // Find the first run.
    size_t runs[MAX_RUNS];
    const whirl_table *table = place->table;
    runup_list_runs(table, runs);
    static const char *const ways[] = {"forward", "backward"};
    static const char *const amplitudes[] = {"forward amplitude", "backward amplitude"};
    // Draw forward and backward amplitudes at multiples of the speed, a panel each.
    for (size_t way = 0; way < 2; way++) {
        whirl_panel *panel = runup_length_panel(of, figure, ways[way], WHIRL_AMPLITUDE, amplitudes[way], true, 4.5);
        const course c = runup_course_of(of, table, runs[0], true);
        const double size = units_length(of->units, table, runs[0], WHIRL_AMPLITUDE);
        for (size_t order = 0; order < MAX_ORDERS; order++) {
            char label[16];
            snprintf(label, sizeof label, "at %zuX", order + 1);
            whirl_series *line = way == 0 ? panel_named(figure, panel, WHIRL_LINE, label, line_colour(order), 0.9)
                                          : panel_series(figure, panel, WHIRL_LINE, line_colour(order), 0.9);
            runup_add_line(figure, line, &c, WHIRL_FIELD_RUNUP_WHIRL_AMPLITUDE, place->station, 2 * order + way, size);
        }
    }
    // Describe both panels.
    snprintf(figure->caption, sizeof figure->caption,
             "Circular parts of the motion of %.60s with and against the rotation, at 1 to 4 times the speed of the "
             "shaft: exact integrals over single turns.",
             of->result->stations[place->station].name);
}

/// Draws the axial displacement or the twist of a station: for one run its mean, least and largest values and its
/// amplitudes at multiples of the speed, for several runs the least and largest values and the amplitude at 1X of each;
/// and the lag at 1X.
static void runup_describe_extra(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const size_t kind = place->which == TWIST;
    const double degrees = 180.0 / acos(-1.0);
    static const char *const names[] = {"mean", "least", "largest"};
    size_t runs[MAX_RUNS];
    const whirl_table *table = place->table;
    const size_t count = runup_list_runs(table, runs), s = place->station;
    whirl_panel *panel =
        runup_length_panel(of, figure, "displacement", WHIRL_FROM_CENTRE, extras[kind].quantity, true, 4.0);
    whirl_panel *amplitude = runup_length_panel(of, figure, "amplitude", WHIRL_AMPLITUDE, "amplitude", true, 4.0);
    whirl_panel *lag = figure_panel(figure, "lag", 1.0, 3.5);
    if (!panel || !amplitude || !lag) return;
    if (extras[kind].twists) {
        snprintf(panel->y.label, sizeof panel->y.label, "twist (\u00b0)");
        snprintf(amplitude->y.label, sizeof amplitude->y.label, "amplitude (\u00b0)");
    }
    runup_label_over(of, &lag->x, true);
    snprintf(lag->y.label, sizeof lag->y.label, "lag at 1X (\u00b0)");
    for (size_t i = 0; i < count; i++) {
        const course c = runup_course_of(of, table, runs[i], true);
        const double length =
            extras[kind].twists ? degrees : units_length(of->units, table, runs[i], WHIRL_FROM_CENTRE);
        const double size = extras[kind].twists ? degrees : units_length(of->units, table, runs[i], WHIRL_AMPLITUDE);
        char label[UNIT_LABEL_SIZE] = "";
        if (count > 1) units_point_label(of->units, table, runs[i], label, sizeof label);
        for (size_t column = count > 1 ? 1 : 0; column < 3; column++) {
            whirl_series *line = count > 1
                                     ? panel_series(figure, panel, WHIRL_LINE, line_colour(i), 0.8)
                                     : panel_named(figure, panel, WHIRL_LINE, names[column], line_colour(column), 0.8);
            runup_add_line(figure, line, &c, extras[kind].motion, s, column, length);
        }
        for (size_t order = 0; order < (count > 1 ? 1u : (size_t)MAX_ORDERS); order++) {
            if (count == 1) snprintf(label, sizeof label, "at %zuX", order + 1);
            runup_add_line(figure,
                           panel_named(figure, amplitude, WHIRL_LINE, label, line_colour(count > 1 ? i : order), 0.8),
                           &c, extras[kind].amplitude, s, order, size);
        }
        runup_add_line(figure, panel_series(figure, lag, WHIRL_LINE, line_colour(i), 0.8), &c, extras[kind].lag, s, 0,
                       1.0);
    }
    // The lines of a single run have names of their own in each panel.
    if (count == 1) {
        runup_show_below_legend(panel);
        runup_show_below_legend(amplitude);
    }
    snprintf(figure->caption, sizeof figure->caption,
             "%s of %.60s while the speed changes, %s: %sits least and largest values since the row before, its "
             "amplitude%s over single turns, and the lag at 1X behind the mark on the shaft.",
             extras[kind].twists ? "Twist" : "Axial displacement", of->result->stations[s].name, extras[kind].about,
             count > 1 ? "" : "its mean over a turn, ", count > 1 ? " at 1X" : "s at 1 to 4 times the speed");
}

/// Draws amplitude and lag of the first run at the speed of the rotor and of every shaft with a speed of its own, each
/// over its own speed.
static void runup_describe_shafts(const drawing *of, const figure_place *place, whirl_figure *figure) {
    size_t runs[MAX_RUNS];
    const whirl_table *table = place->table;
    runup_list_runs(table, runs);
    const size_t shafts = (size_t)table->record.runup.shaft_count, s = place->station;
    const double size = units_length(of->units, table, runs[0], WHIRL_AMPLITUDE);
    whirl_panel *amplitude =
        runup_length_panel(of, figure, "amplitude", WHIRL_AMPLITUDE, "amplitude of $x$", true, 4.5);
    whirl_panel *lag = figure_panel(figure, "lag", 1.0, 3.5);
    if (!amplitude || !lag) return;
    runup_label_over(of, &lag->x, true);
    snprintf(lag->y.label, sizeof lag->y.label, "lag of $x$ (\u00b0)");
    for (size_t shaft = 0; shaft <= shafts; shaft++) {
        const course c = shaft == 0 ? runup_course_of(of, table, runs[0], true)
                                    : runup_course_of_shaft(of, table, runs[0], shaft, true);
        char name[WHIRL_NAME_SIZE] = "the rotor", label[2 * WHIRL_NAME_SIZE];
        if (shaft > 0) whirl_runup_shaft_name(&table->record.runup, shaft - 1, name);
        snprintf(label, sizeof label, "1X of %s", name);
        runup_add_line(figure, panel_named(figure, amplitude, WHIRL_LINE, label, line_colour(shaft), 0.9), &c,
                       shaft == 0 ? WHIRL_FIELD_RUNUP_AMPLITUDE : WHIRL_FIELD_RUNUP_SHAFT_AMPLITUDE, s, 0, size);
        runup_add_line(figure, panel_series(figure, lag, WHIRL_LINE, line_colour(shaft), 0.8), &c,
                       shaft == 0 ? WHIRL_FIELD_RUNUP_LAG : WHIRL_FIELD_RUNUP_SHAFT_LAG, s, 0, 1.0);
    }
    snprintf(figure->caption, sizeof figure->caption,
             "Motion of %.60s along x at the speed of each shaft, over that speed: integrals over single turns of that "
             "shaft, and the lag behind its mark.",
             of->result->stations[s].name);
}

/// Returns true if films or seals brake the shaft of a run.
static bool runup_is_dragged(const whirl_table *table, size_t run) {
    const whirl_field *torques = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_TORQUE);
    const double *rows = whirl_table_field(table, run, WHIRL_FIELD_RUNUP_TORQUE, 0);
    for (size_t i = 0; rows && torques->columns == 5 && i < torques->rows; i++)
        if (fabs(rows[5 * i + 4]) > 0.0) return true;
    return false;
}

/// Draws the speed of each run; for a single run the torques on the shaft too.
static void runup_describe_shaft(const drawing *of, const figure_place *place, whirl_figure *figure) {
    size_t runs[MAX_RUNS];
    const whirl_table *table = place->table;
    const size_t count = runup_list_runs(table, runs);
    const whirl_unit *speed = &of->units->of[WHIRL_QUANTITY_SPEED], *torque = &of->units->of[WHIRL_QUANTITY_MOMENT];
    whirl_panel *panel = figure_panel(figure, "speed", 1.0, 4.5);
    if (!panel) return;
    runup_label_over(of, &panel->x, false);
    snprintf(panel->y.label, sizeof panel->y.label, "speed (%s)", speed->name);
    // Draw the speed of each run.
    for (size_t i = 0; i < count; i++) {
        const course c = runup_course_of(of, table, runs[i], false);
        char label[UNIT_LABEL_SIZE] = "";
        if (count > 1) units_point_label(of->units, table, runs[i], label, sizeof label);
        runup_add_line(figure,
                       count > 1 ? panel_named(figure, panel, WHIRL_LINE, label, line_colour(i), 1.0)
                                 : panel_series(figure, panel, WHIRL_LINE, line_colour(0), 1.0),
                       &c, WHIRL_FIELD_RUNUP_SPEED, 0, 0, 1.0 / speed->size);
    }
    // For a single run, draw the speeds of the other shafts.
    const size_t shafts = count == 1 ? (size_t)table->record.runup.shaft_count : 0;
    for (size_t shaft = 1; shaft <= shafts; shaft++) {
        char name[WHIRL_NAME_SIZE];
        whirl_runup_shaft_name(&table->record.runup, shaft - 1, name);
        const course c = runup_course_of_shaft(of, table, runs[0], shaft, false);
        runup_add_line(figure, panel_named(figure, panel, WHIRL_LINE, name, line_colour(shaft), 1.0), &c,
                       WHIRL_FIELD_RUNUP_SHAFT_SPEED, 0, 0, 1.0 / speed->size);
    }
    // For a single driven run, draw the torques, unless they change within a turn: then they have a figure of their
    // own.
    const bool driven = whirl_runup_driven(&table->record.runup) && !table_has(table, WHIRL_FIELD_RUNUP_TORQUE_OF);
    whirl_panel *torques = count == 1 && driven ? figure_panel(figure, "torque", 1.0, 4.0) : NULL;
    if (torques) {
        const course c = runup_course_of(of, table, runs[0], false);
        runup_label_over(of, &torques->x, false);
        snprintf(torques->y.label, sizeof torques->y.label, "torque (%s)", torque->name);
        for (size_t i = 0; i < (runup_is_dragged(table, runs[0]) ? SHAFT_TORQUES : SHAFT_TORQUES - 1); i++)
            runup_add_line(figure,
                           panel_named(figure, torques, WHIRL_LINE, shaft_torque_names[i], line_colour(i + 1), 0.8), &c,
                           WHIRL_FIELD_RUNUP_TORQUE, 0, i, 1.0 / torque->size);
    }
    snprintf(figure->caption, sizeof figure->caption, "Speed of the shaft over the time%s.",
             torques ? ", and torques on it at the end of each turn: of the motor, its load, friction in contacts, the "
                       "action of the rotor's motion and its weight on the unbalances, and drag of films and seals"
                     : "");
}

static void runup_describe_contacts(const drawing *of, const figure_place *place, whirl_figure *figure) {
    // Find the first run.
    size_t runs[MAX_RUNS];
    const whirl_table *table = place->table;
    runup_list_runs(table, runs);
    // Set up panels of forces and of the share of a turn in contact.
    const whirl_unit *force = &of->units->of[WHIRL_QUANTITY_FORCE];
    whirl_panel *panel = figure_panel(figure, "force", 1.0, 4.5), *share = figure_panel(figure, "share", 1.0, 3.0);
    if (!panel || !share) return;
    runup_label_over(of, &panel->x, false);
    runup_label_over(of, &share->x, false);
    snprintf(panel->y.label, sizeof panel->y.label, "normal force (%s)", force->name);
    snprintf(share->y.label, sizeof share->y.label, "share of a turn");
    // Draw both for each contact.
    for (size_t contact = 0; contact < of->result->contact_count; contact++) {
        const course c = runup_course_of(of, table, runs[0], false);
        runup_add_line(figure,
                       panel_named(figure, panel, WHIRL_LINE, of->result->contacts[contact], line_colour(contact), 0.9),
                       &c, WHIRL_FIELD_RUNUP_FORCE, contact, 0, of->result->force_scale / force->size);
        runup_add_line(figure, panel_series(figure, share, WHIRL_LINE, line_colour(contact), 0.9), &c,
                       WHIRL_FIELD_RUNUP_SHARE, contact, 0, 1.0);
    }
    // Describe the panels.
    snprintf(figure->caption, sizeof figure->caption,
             "Largest normal force of contacts since the row before, and the share of the last turn in which they "
             "were closed.");
}

/// Draws a torque as a band from its least to its largest value in every row.
static void runup_draw_torque(const drawing *of, const figure_place *place, size_t run, size_t torque, double height,
                              whirl_figure *figure) {
    const whirl_table *table = place->table;
    const whirl_field *rows = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_TORQUE_COURSE);
    const double *names = whirl_table_field(table, run, WHIRL_FIELD_RUNUP_TORQUE_OF, 0);
    const double *values = whirl_table_field(table, run, WHIRL_FIELD_RUNUP_TORQUE_COURSE, 0);
    const double end = whirl_table_number(table, run, WHIRL_FIELD_RUNUP_END_TIME, 0);
    const whirl_unit *unit = &of->units->of[WHIRL_QUANTITY_MOMENT], *time = &of->units->of[WHIRL_QUANTITY_TIME];
    char name[2 * WHIRL_NAME_SIZE + 40];
    whirl_panel *panel = figure_panel(figure, "torque", 1.0, height);
    if (!panel || !names || !values || !rows) return;
    torque_name(of->result, names + 3 * torque, name, sizeof name);
    snprintf(panel->title, sizeof panel->title, "%.80s", name);
    runup_label_over(of, &panel->x, false);
    snprintf(panel->y.label, sizeof panel->y.label, "torque (%s)", unit->name);
    // The outline of the band: least values forwards, then largest values backwards.
    const size_t count = (size_t)table->record.runup.rows;
    const double duration = table->record.runup.duration > 0.0 ? table->record.runup.duration : end;
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(torque), 0.7);
    for (size_t row = 0; row < count; row++) {
        const double *own = values + 2 * (torque * count + row);
        const double at = ((double)row + 0.5) / (double)count * duration / time->size;
        if (!isfinite(own[0]) || !isfinite(own[1])) continue;
        series_add(figure, line, at, own[row % 2] / unit->size);
        series_add(figure, line, at, own[1 - row % 2] / unit->size);
    }
}

/// Draws the torques of the first run with the largest ranges.
static void runup_describe_torques(const drawing *of, const figure_place *place, whirl_figure *figure) {
    size_t runs[MAX_RUNS], chosen[MAX_TORQUE_PANELS], count = 0;
    const whirl_table *table = place->table;
    const whirl_field *rows = whirl_layout_field(&table->layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
    runup_list_runs(table, runs);
    const double *extremes = whirl_table_field(table, runs[0], WHIRL_FIELD_RUNUP_TORQUE_EXTREME, 0);
    if (!rows || !extremes) return;
    for (size_t t = 0; t < rows->rows; t++) {
        const double range = extremes[4 * t] - extremes[4 * t + 2];
        size_t at = count;
        while (at > 0 && extremes[4 * chosen[at - 1]] - extremes[4 * chosen[at - 1] + 2] < range) at--;
        if (!isfinite(range) || at == MAX_TORQUE_PANELS) continue;
        count = count < MAX_TORQUE_PANELS ? count + 1 : count;
        memmove(chosen + at + 1, chosen + at, (count - 1 - at) * sizeof *chosen);
        chosen[at] = t;
    }
    for (size_t i = 0; i < count; i++) runup_draw_torque(of, place, runs[0], chosen[i], count > 3 ? 2.6 : 3.6, figure);
    snprintf(figure->caption, sizeof figure->caption,
             "Torques of motors and between stations that twist%s: from the least to the largest value in each row of "
             "the run.",
             rows->rows > count ? ", those with the largest ranges" : "");
}

static void runup_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    switch (place->which) {
    case OVER_SPEED:
        runup_describe_motion(of, place, figure, true);
        break;
    case OVER_TIME:
        runup_describe_motion(of, place, figure, false);
        break;
    case ORDERS:
        runup_describe_orders(of, place, figure);
        break;
    case SHAFTS:
        runup_describe_shafts(of, place, figure);
        break;
    case SHAFT:
        runup_describe_shaft(of, place, figure);
        break;
    case AXIAL:
    case TWIST:
        runup_describe_extra(of, place, figure);
        break;
    case TORQUES:
        runup_describe_torques(of, place, figure);
        break;
    default:
        runup_describe_contacts(of, place, figure);
    }
    runup_caption_runs(of, place->table,
                       place->which == ORDERS || place->which == SHAFTS || place->which >= CONTACTS ? 1 : MAX_RUNS,
                       figure);
}

const figure_kind runup_figure = {.list = runup_list, .describe = runup_describe, .stem = "runup", .study = "runup"};
