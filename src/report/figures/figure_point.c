// Panels of one point and station, as in figures 4 to 11 of the paper of cases/paper.yaml: waveform, orbit, spectrum
// and Poincaré map, and the full spectrum below.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "machine_at.h"
#include "point_panels.h"
#include "quantities.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/handles.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

/// An orbit counts as near a circle if its distance from the circle is at most this share of its size.
static const double NEAR = 0.35;

enum { SHOWN_TURNS = 10 }; ///< revolutions of the waveform panel

static const char dark[] = "#303030";

/// Returns the rows of a field of axial displacements or twists; none if the station does not move so.
static numbers point_extra(const whirl_table *table, size_t point, const char *field, size_t station) {
    const numbers own = point_numbers(table, point, field, station);
    return own.at && isfinite(own.at[0]) ? own : (numbers){.at = NULL};
}

static subject subject_of(const drawing *to, const whirl_table *table, size_t point, size_t station) {
    // Note the point, and its units.
    const whirl_shown_units *units = to->units;
    subject of = {.result = to->result,
                  .machine = to->machine,
                  .table = table,
                  .point = point,
                  .station = station,
                  .units = units};
    of.length = whirl_shown_length(units, table, point);
    of.amplitude = of.length * units->amplitude;
    of.order = units_order(units, machine_clock(to->machine, to->result, table, point));
    // Gather walls and recorded data of the station.
    of.walls = machine_walls_at(to->machine, to->result, table, point, station);
    machine_wall_at(to->machine, table, point, station, of.walls.clearance, &of.wall);
    of.waveform = point_waveform(table, point, station);
    of.section = point_section(table, point, station);
    of.spectrum = point_spectrum(table, point, station);
    of.lines = point_lines(table, point, station);
    of.axial = point_extra(table, point, WHIRL_FIELD_WAVEFORM_AXIAL, station);
    of.axial_spectrum = point_extra(table, point, WHIRL_FIELD_SPECTRUM_AXIAL_AMPLITUDE, station);
    of.axial_lines = point_extra(table, point, WHIRL_FIELD_SPECTRUM_AXIAL_LINES, station);
    of.twist = point_extra(table, point, WHIRL_FIELD_WAVEFORM_TWIST, station);
    of.twist_spectrum = point_extra(table, point, WHIRL_FIELD_SPECTRUM_TWIST_AMPLITUDE, station);
    of.twist_lines = point_extra(table, point, WHIRL_FIELD_SPECTRUM_TWIST_LINES, station);
    of.turn = (size_t)whirl_record_samples(&table->record, table->integrate.steps_per_revolution);
    if (of.turn == 0) of.turn = 1;
    // Find the range of the motion.
    of.x = of.y = span_empty();
    for (size_t k = 0; k < of.waveform.rows; k++) {
        span_widen(&of.x, of.length * of.waveform.at[2 * k]);
        span_widen(&of.y, of.length * of.waveform.at[2 * k + 1]);
    }
    for (size_t k = 0; k < of.section.rows; k++) {
        span_widen(&of.x, of.length * of.section.at[4 * k]);
        span_widen(&of.y, of.length * of.section.at[4 * k + 1]);
    }
    of.size = fmax(fmax(of.x.high - of.x.low, of.y.high - of.y.low), 1e-9 * of.length);
    return of;
}

/// A square window of the plane: its middle and its side.
typedef struct window {
    double x, y, side;
} window;

static window window_around(span x, span y, double side) {
    return (window){0.5 * (x.low + x.high), 0.5 * (y.low + y.high), side};
}

/// Returns true if a circle around (0, 0) passes through a window; false for radius 0.
static bool circle_shows(const window *in, double radius) {
    const double half = 0.5 * in->side, x = fabs(in->x), y = fabs(in->y);
    return radius > 0.0 && radius >= hypot(fmax(x - half, 0.0), fmax(y - half, 0.0)) &&
           radius <= hypot(x + half, y + half);
}

/// Returns the window of the orbit; it includes the nearest part of a circle that the orbit comes near to.
static window orbit_window(const subject *of) {
    span x = of->x, y = of->y;
    size_t far = 0;
    double most = 0.0;
    for (size_t k = 0; k < of->waveform.rows; k++) {
        const double r = of->length * hypot(of->waveform.at[2 * k], of->waveform.at[2 * k + 1]);
        if (r > most) far = k, most = r;
    }
    const double way = most > 0.0 ? atan2(of->waveform.at[2 * far + 1], of->waveform.at[2 * far]) : 0.0;
    const double circles[] = {of->length * machine_wall_radius(&of->wall, way), of->length * of->walls.gap};
    for (int i = 0; i < 2 && most > 0.0; i++) {
        const double r = circles[i];
        if (r <= 0.0 || fabs(r - most) > NEAR * of->size) continue;
        span_widen(&x, of->length * of->waveform.at[2 * far] * r / most);
        span_widen(&y, of->length * of->waveform.at[2 * far + 1] * r / most);
        if (of->size < r) continue; // for a small orbit an arc is enough
        for (int side = -1; side <= 1; side += 2) span_widen(&x, side * r), span_widen(&y, side * r);
    }
    return window_around(x, y, 1.16 * fmax(x.high - x.low, y.high - y.low));
}

/// Returns which circles the orbit's window shows: bit 0 the bearing, bit 1 the stator.
static unsigned shown_circles(const subject *of) {
    const window in = orbit_window(of);
    return (unsigned)circle_shows(&in, of->length * machine_wall_radius(&of->wall, atan2(in.y, in.x))) |
           (unsigned)circle_shows(&in, of->length * of->walls.gap) << 1;
}

// ---------------------------------------------------------------- panels

/// Writes the symbols of x and y for the label of an axis.
static void name_both(const subject *of, char *text, size_t size) {
    char x[SYMBOL_SIZE], y[SYMBOL_SIZE];
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$x$", x, sizeof x);
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$y$", y, sizeof y);
    if (of->units->ratio)
        snprintf(text, size, "%.120s, %.120s", x, y);
    else
        snprintf(text, size, "$x$, %.200s", y);
}

static void add_waveform(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    const size_t rows = of->waveform.rows;
    const double turns = (double)rows / (double)of->turn, shown = fmin(turns, SHOWN_TURNS);
    span both = of->x;
    span_widen(&both, of->y.low);
    span_widen(&both, of->y.high);
    axis_show(&panel->x, (span){turns - shown, turns});
    axis_show(&panel->y, span_with_margin(both, 0.12, 1e-9 * of->length));
    snprintf(panel->x.label, sizeof panel->x.label, "revolution");
    name_both(of, panel->y.label, sizeof panel->y.label);
    panel->keyed = true;
    // Draw x and y over the last revolutions.
    for (size_t column = 0; column < 2; column++) {
        whirl_series *line = panel_named(figure, panel, WHIRL_LINE, column ? "$y$" : "$x$", line_colour(column), 0.53);
        for (size_t k = 0; k < rows; k++) {
            const double at = (double)(k + 1) / (double)of->turn;
            if (at >= turns - shown - 1.0 / (double)of->turn)
                series_add(figure, line, at, of->length * of->waveform.at[2 * k + column]);
        }
    }
    // Mark the points of the section, once a revolution.
    whirl_series *marks = panel_series(figure, panel, WHIRL_DOTS, dark, 0.9);
    for (size_t k = 0; k < rows; k++) {
        const double at = (double)(k + 1) / (double)of->turn;
        if ((rows - 1 - k) % of->turn != 0 || at < turns - shown) continue;
        series_add(figure, marks, at, of->length * of->waveform.at[2 * k]);
        series_add(figure, marks, at, of->length * of->waveform.at[2 * k + 1]);
    }
}

static void show_window(whirl_panel *panel, const subject *of, const window *in) {
    axis_show(&panel->x, (span){in->x - 0.5 * in->side, in->x + 0.5 * in->side});
    axis_show(&panel->y, (span){in->y - 0.5 * in->side, in->y + 0.5 * in->side});
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$x$", panel->x.label, sizeof panel->x.label);
    symbol_length(of->units, WHIRL_FROM_CENTRE, "$y$", panel->y.label, sizeof panel->y.label);
    panel->equal = true;
}

/// Adds the part of a circle around (0, 0) within a window, and slightly more.
static void add_circle(whirl_figure *figure, whirl_series *line, const window *in, double radius) {
    // Draw only the arc that may cross the window: seen from (0, 0), that within the angle of a circle around the
    // window.
    enum { STEPS = 500 };
    const double distance = hypot(in->x, in->y), reach = 0.85 * in->side, pi = acos(-1.0);
    const double half = distance > reach ? asin(reach / distance) : pi, middle = atan2(in->y, in->x);
    for (int k = -STEPS; k <= STEPS; k++) {
        const double angle = middle + half * k / STEPS;
        series_add(figure, line, radius * cos(angle), radius * sin(angle));
    }
}

static bool is_periodic(const subject *of) {
    return whirl_table_verdict(of->table, of->point).regime == WHIRL_PERIODIC;
}

/// Returns the size of dots in the section: larger for periodic motions, which have few.
static double mark_size(const subject *of) {
    return is_periodic(of) ? 2.2 : 1.1;
}

/// Adds the head of an arrow at a point of an orbit, along the chord between its neighbours.
static void add_arrow(whirl_figure *figure, whirl_panel *panel, const double *before, const double *at,
                      const double *after, double length, double size, const char *colour) {
    const double chord = hypot(after[0] - before[0], after[1] - before[1]), slim = 0.42;
    if (!(chord > 0.0)) return;
    const double along[] = {(after[0] - before[0]) / chord, (after[1] - before[1]) / chord};
    const double tip[] = {length * at[0], length * at[1]};
    whirl_series *head = panel_series(figure, panel, WHIRL_LINE, colour, 0.9);
    for (int side = 1; side >= -1; side--) {
        if (side == 0) {
            series_add(figure, head, tip[0], tip[1]);
            continue;
        }
        series_add(figure, head, tip[0] - size * (along[0] - side * slim * along[1]),
                   tip[1] - size * (along[1] + side * slim * along[0]));
    }
}

void orbit_marks(whirl_figure *figure, whirl_panel *panel, const numbers *samples, size_t turn, double length,
                 double size, const char *colour, double dot) {
    whirl_series *marks = panel_series(figure, panel, WHIRL_DOTS, colour, dot);
    const double *at = samples->at;
    for (size_t k = 0; k < samples->rows; k++)
        if ((samples->rows - 1 - k) % turn == 0) series_add(figure, marks, length * at[2 * k], length * at[2 * k + 1]);
    if (samples->rows <= turn || turn < 4) return;
    span x = span_empty(), y = span_empty();
    for (size_t k = samples->rows - turn; k < samples->rows; k++) {
        span_widen(&x, length * at[2 * k]);
        span_widen(&y, length * at[2 * k + 1]);
    }
    const double own = 0.3 * fmax(x.high - x.low, y.high - y.low);
    const size_t k = samples->rows - 1 - turn + turn / 2;
    add_arrow(figure, panel, at + 2 * (k - 1), at + 2 * k, at + 2 * (k + 1), length, fmin(size, own), colour);
}

/// Adds the part of the bearing's wall within a window, and slightly more.
static void add_wall(whirl_figure *figure, whirl_series *line, const window *in, const subject *of) {
    if (of->wall.round) {
        add_circle(figure, line, in, of->length * of->walls.clearance);
        return;
    }
    for (size_t k = 0; k <= WALL_ANGLES; k++) {
        const double angle = 2.0 * acos(-1.0) * (double)k / WALL_ANGLES;
        const double radius = of->length * of->wall.radius[k % WALL_ANGLES];
        series_add(figure, line, radius * cos(angle), radius * sin(angle));
    }
}

static void add_orbit(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    const window in = orbit_window(of);
    const unsigned circles = shown_circles(of);
    show_window(panel, of, &in);
    if (circles & 1u) add_wall(figure, panel_series(figure, panel, WHIRL_LINE, "#9A9A9A", 0.9), &in, of);
    whirl_series *gap = circles & 2u ? panel_series(figure, panel, WHIRL_LINE, "#707070", 0.53) : NULL;
    if (gap) gap->dashed = true;
    if (gap) add_circle(figure, gap, &in, of->length * of->walls.gap);
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(0), 0.38);
    for (size_t k = 0; k < of->waveform.rows; k++)
        series_add(figure, line, of->length * of->waveform.at[2 * k], of->length * of->waveform.at[2 * k + 1]);
    orbit_marks(figure, panel, &of->waveform, of->turn, of->length, 0.05 * in.side, line_colour(1), mark_size(of));
}

/// Adds the Poincare section. The window fits the section, but has at least a fifth of the motion's size, so that
/// rounding errors of a fixed point are not magnified.
static void add_section(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    span x = span_empty(), y = span_empty();
    for (size_t k = 0; k < of->section.rows; k++) {
        span_widen(&x, of->length * of->section.at[4 * k]);
        span_widen(&y, of->length * of->section.at[4 * k + 1]);
    }
    const double extent = fmax(x.high - x.low, y.high - y.low);
    const double least =
        fmax(0.2 * of->size, 1e-3 * hypot(x.high, y.high)); // without a waveform the size of the motion is unknown
    const window in = window_around(x, y, fmax(1.24 * extent, least));
    show_window(panel, of, &in);
    const bool cloud = of->section.rows > 1000 && extent > 1e-3 * of->size && !is_periodic(of);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, line_colour(0), cloud ? 0.36 : mark_size(of));
    for (size_t k = 0; k < of->section.rows; k++)
        series_add(figure, dots, of->length * of->section.at[4 * k], of->length * of->section.at[4 * k + 1]);
}

/// Draws a motion besides x and y over the last revolutions; size: factor to shown values.
static void add_extra(whirl_figure *figure, whirl_panel *panel, const subject *of, const numbers *own, double size) {
    const double turns = (double)own->rows / (double)of->turn, shown = fmin(turns, SHOWN_TURNS);
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, line_colour(2), 0.53);
    axis_show(&panel->x, (span){turns - shown, turns});
    snprintf(panel->x.label, sizeof panel->x.label, "revolution");
    for (size_t k = 0; k < own->rows; k++) {
        const double at = (double)(k + 1) / (double)of->turn;
        if (at >= turns - shown - 1.0 / (double)of->turn) series_add(figure, line, at, size * own->at[k]);
    }
}

static void add_axial(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    symbol_length(of->units, WHIRL_FROM_CENTRE, "axial displacement", panel->y.label, sizeof panel->y.label);
    add_extra(figure, panel, of, &of->axial, of->length);
}

static void add_twist(whirl_figure *figure, whirl_panel *panel, const subject *of) {
    snprintf(panel->y.label, sizeof panel->y.label, "twist (\u00b0)");
    add_extra(figure, panel, of, &of->twist, 180.0 / acos(-1.0));
}

// ---------------------------------------------------------------- the figure

enum {
    WAVEFORM_PANEL,
    ORBIT_PANEL,
    SPECTRUM_PANEL,
    SECTION_PANEL,
    FULL_PANEL,
    LINES_PANEL,
    AXIAL_PANEL,
    AXIAL_SPECTRUM_PANEL,
    TWIST_PANEL,
    TWIST_SPECTRUM_PANEL,
    PANEL_COUNT
};

/// Finds which panels have data, in the order of their letters.
static void panels_there(const subject *of, bool there[PANEL_COUNT]) {
    there[WAVEFORM_PANEL] = there[ORBIT_PANEL] = of->waveform.at != NULL;
    there[SPECTRUM_PANEL] = there[FULL_PANEL] = of->spectrum.at != NULL;
    there[LINES_PANEL] = of->spectrum.at == NULL && of->lines.at != NULL;
    there[SECTION_PANEL] = of->section.at != NULL;
    there[AXIAL_PANEL] = of->axial.at != NULL;
    there[AXIAL_SPECTRUM_PANEL] = of->axial_spectrum.at != NULL || of->axial_lines.at != NULL;
    there[TWIST_PANEL] = of->twist.at != NULL;
    there[TWIST_SPECTRUM_PANEL] = of->twist_spectrum.at != NULL || of->twist_lines.at != NULL;
}

static void (*const adders[])(whirl_figure *, whirl_panel *, const subject *) = {
    add_waveform, add_orbit, add_half_spectrum,  add_section, add_full_spectrum,
    add_lines,    add_axial, add_axial_spectrum, add_twist,   add_twist_spectrum};

/// Writes the caption of the letters: " (a) Waveform, (b) orbit (grey: bearing), ...".
static void name_panels(const subject *of, char *text, size_t size) {
    // Name what each panel shows; circles of the orbit are explained.
    const unsigned circles = of->waveform.at ? shown_circles(of) : 0;
    const char *orbit = circles == 3u   ? "orbit (grey: bearing, dashed: stator)"
                        : circles == 1u ? "orbit (grey: bearing)"
                        : circles == 2u ? "orbit (dashed: stator)"
                                        : "orbit";
    const char *const names[] = {"waveform",
                                 orbit,
                                 "spectrum",
                                 "Poincar\u00e9 map (once a revolution)",
                                 "full spectrum of x + iy",
                                 "lines of the full spectrum",
                                 "axial displacement",
                                 of->axial_spectrum.at ? "its spectrum" : "its lines",
                                 "twist",
                                 of->twist_spectrum.at ? "its spectrum" : "its lines"};
    // Join the names of the panels with data.
    bool there[PANEL_COUNT];
    size_t used = 0;
    char letter = 'a';
    panels_there(of, there);
    text[0] = '\0';
    for (int i = 0; i < PANEL_COUNT && used < size; i++)
        if (there[i]) {
            used += (size_t)snprintf(text + used, size - used, "%s (%c) %s", letter > 'a' ? "," : "", letter, names[i]);
            letter++;
        }
}

/// Returns true if a point has anything to show at a station.
static bool is_there(const whirl_table *table, size_t point, size_t station) {
    return whirl_table_done(table, point) &&
           (point_waveform(table, point, station).at || point_section(table, point, station).at ||
            point_spectrum(table, point, station).at || point_lines(table, point, station).at);
}

/// Writes the verdict of a point, ": P-1"; "" for a motion that was not judged.
static void name_verdict(const whirl_table *table, size_t point, char text[LABEL_SIZE + 2]) {
    const whirl_verdict verdict = whirl_table_verdict(table, point);
    char name[LABEL_SIZE];
    whirl_verdict_name(&verdict, name, sizeof name);
    text[0] = '\0';
    if (verdict.regime != WHIRL_NOT_JUDGED) snprintf(text, LABEL_SIZE + 2, ": %s", name);
}

static void add_to_list(figure_list *to, const drawing *of, const whirl_table *table, size_t i, size_t station) {
    char point[UNIT_LABEL_SIZE], verdict_text[LABEL_SIZE + 2], name[200];
    const whirl_unit unit = whirl_shown_parameter(of->units, table->parameter);
    const char *station_name = of->result->stations[station].name;
    const figure_place place = {.kind = &point_figure, .table = table, .point = (long)i, .station = station};
    units_point_label(of->units, table, i, point, sizeof point);
    name_verdict(table, i, verdict_text);
    if (*table->parameter)
        snprintf(name, sizeof name, "%.63s-%.6g%.20s-%.63s", table->parameter, table->values[i] / unit.size, unit.name,
                 station_name);
    else
        snprintf(name, sizeof name, "%.63s-%.63s", table->name, station_name);
    list_figure(to, &place, name, "%.80s, %.60s%.56s", point, station_name, verdict_text);
}

static void point_list(figure_list *to, const drawing *of, const whirl_table *table) {
    if (table != detail_table(of->result)) return;
    for (size_t i = 0; i < table->count; i++)
        for (size_t s = 0; s < of->result->station_count; s++)
            if (is_there(table, i, s)) add_to_list(to, of, table, i, s);
}

// ---------------------------------------------------------------- any point: "@6000 rpm:disc", "@#12"

static bool is_along(const whirl_table *table, const char *parameter) {
    return *parameter && table->row == 0 && strcmp(table->parameter, parameter) == 0;
}

/// Finds the point whose value is nearest to the given one, in all tables along a parameter, among points with
/// something to show. Of equally near points that of the last table is taken: a detail, which follows its sweep, has
/// more to show.
static whirl_status nearest_point(const drawing *of, const char *parameter, const char *text, size_t station,
                                  const whirl_table **table, size_t *point) {
    const whirl_result *result = of->result;
    size_t total = 0, count = 0, nearest = 0;
    for (size_t t = 0; t < result->table_count; t++)
        if (is_along(&result->tables[t], parameter)) total += result->tables[t].count;
    double *const values = malloc((total + 1) * sizeof *values);
    if (!values) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the values of %zu points", total);
    for (size_t t = result->table_count; t-- > 0;)
        for (size_t i = 0; is_along(&result->tables[t], parameter) && i < result->tables[t].count; i++)
            values[count++] = is_there(&result->tables[t], i, station) ? result->tables[t].values[i] : (double)NAN;
    const whirl_status status = whirl_nearest_value(result, parameter, values, total, text, &nearest);
    free(values);
    *point = nearest;
    for (size_t t = result->table_count; t-- > 0 && status.code == WHIRL_OK;) {
        *table = &result->tables[t];
        if (!is_along(*table, parameter)) continue;
        if (*point < (*table)->count) break;
        *point -= (*table)->count;
    }
    return status;
}

/// Adds the figure of the point nearest to a value, along the first parameter that accepts the value.
static whirl_status add_nearest(figure_list *to, const drawing *of, const char *text, size_t station) {
    whirl_status first = whirl_ok();
    for (size_t t = 0; t < of->result->table_count; t++) {
        const whirl_table *table = &of->result->tables[t];
        size_t point = 0;
        if (!is_along(table, table->parameter) || table->count == 0) continue;
        const whirl_status status = nearest_point(of, table->parameter, text, station, &table, &point);
        if (status.code == WHIRL_OK) add_to_list(to, of, table, point, station);
        if (status.code == WHIRL_OK || status.code == WHIRL_NO_MEMORY) return status;
        if (first.code == WHIRL_OK) first = status;
    }
    if (first.code != WHIRL_OK) return first;
    return whirl_fail(WHIRL_BAD_INPUT, "no table along one parameter has points with sections or spectra: a point of a "
                                       "map is given by its number, @#NUMBER");
}

static whirl_status add_numbered(figure_list *to, const drawing *of, const char *text, size_t station) {
    char *end;
    const unsigned long long point = strtoull(text, &end, 10);
    const whirl_table *table = &of->result->tables[0];
    if (table->source) table = table->source; // all starts, not one for each attractor
    if (end == text || *end || point >= table->count)
        return whirl_fail(WHIRL_BAD_INPUT, "the point is '%.60s', expected a number from 0 to %zu", text,
                          table->count > 0 ? table->count - 1 : 0);
    if (!is_there(table, (size_t)point, station))
        return whirl_fail(WHIRL_BAD_INPUT, "point %.60s has no section, waveform or spectrum, or is not done", text);
    add_to_list(to, of, table, (size_t)point, station);
    return whirl_ok();
}

static whirl_status point_find(figure_list *to, const drawing *of, const char *name) {
    char text[200];
    if (*name != '@' || of->result->table_count == 0) return whirl_ok();
    snprintf(text, sizeof text, "%s", name + 1);
    char *colon = strchr(text, ':');
    size_t station = 0;
    if (colon) *colon = '\0';
    while (colon && station < of->result->station_count && strcmp(of->result->stations[station].name, colon + 1) != 0)
        station++;
    if (station == of->result->station_count)
        return whirl_fail(WHIRL_BAD_INPUT, "there is no station '%.60s'", colon ? colon + 1 : "");
    return *text == '#' ? add_numbered(to, of, text + 1, station) : add_nearest(to, of, text, station);
}

static void point_describe(const drawing *to, const figure_place *place, whirl_figure *figure) {
    static const char *const panel_names[] = {"waveform",      "orbit", "spectrum",       "section", "full-spectrum",
                                              "full-spectrum", "axial", "axial-spectrum", "twist",   "twist-spectrum"};
    // Gather the data, and find the panels that they fill.
    const subject of = subject_of(to, place->table, (size_t)place->point, place->station);
    char point[UNIT_LABEL_SIZE], verdict_text[LABEL_SIZE + 2], panels[400];
    bool there[PANEL_COUNT];
    char letter = 'a';
    panels_there(&of, there);
    figure->width = 17.5;
    figure->font = 8.0;
    // Add the panels, with letters.
    for (int i = 0; i < PANEL_COUNT; i++) {
        if (!there[i]) continue;
        const bool wide = i == FULL_PANEL || i == LINES_PANEL, low = i >= FULL_PANEL;
        whirl_panel *panel = figure_panel(figure, panel_names[i], wide ? 1.0 : 0.5, low ? 4.2 : 6.5);
        if (!panel) return;
        panel->letter = letter++;
        adders[i](figure, panel, &of);
    }
    // Describe the point, its verdict and the panels.
    units_point_label(of.units, of.table, of.point, point, sizeof point);
    name_verdict(of.table, of.point, verdict_text);
    name_panels(&of, panels, sizeof panels);
    snprintf(figure->caption, sizeof figure->caption, "%.120s, %.60s%.102s.%s.%s", point,
             of.result->stations[of.station].name, verdict_text, panels,
             of.waveform.at ? " Dots of the orbit: once a revolution; arrow: the way it goes."
                            : " No waveform was kept.");
}

const figure_kind point_figure = {.list = point_list, .describe = point_describe, .find = point_find};
