// Figures of the deflection of shafts by their weight and by unbalance.
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "figure_kinds.h"
#include "machine_along.h"
#include "machine_layout.h"
#include "margins.h"
#include "shaft_bends.h"
#include "speed_unit.h"

// ---------------------------------------------------------------- sag

static void list_sag(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &sag_figure, .table = table, .point = NO_POINT};
    bool any = false;
    if (!table_has(table, WHIRL_FIELD_STATICS_DEFLECTION) || !whirl_table_done(table, table->count - 1)) return;
    for (size_t s = 0; s < of->result->station_count; s++)
        any = any || isfinite(*whirl_table_field(table, table->count - 1, WHIRL_FIELD_STATICS_DEFLECTION, s));
    if (any) list_figure(to, &place, "sag", "Sag of the shafts by their weight");
}

static void describe_sag(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const size_t point = table->count - 1;
    const double length = whirl_shown_length(of->units, table, point);
    machine_along along;
    span range = {0.0, 0.0};
    double values[WHIRL_MAX_PROBES];
    whirl_panel *panel = figure_panel(figure, "sag", 1.0, 4.5);
    if (!panel) return;
    // Compute the bent line between stations. Shafts that are not of finite elements have none.
    shaft_bends *bends = bends_new(of, table, point);
    const whirl_shaft_line *line = bends ? bends_line(bends) : NULL;
    double *moved = line ? calloc(line->count, sizeof *moved) : NULL;
    along_place(of, &along);
    // Find the range of the sag, at stations and between them.
    for (size_t s = 0; s < of->result->station_count; s++) {
        values[s] = length * *whirl_table_field(table, point, WHIRL_FIELD_STATICS_DEFLECTION, s);
        span_widen(&range, values[s]);
    }
    for (size_t i = 0; moved && line->sag && i < line->count; i++) {
        moved[i] = line->sag[i] / bends_length(bends) * length;
        span_widen(&range, moved[i]);
    }
    // Set up the panel, with the machine behind the line.
    symbol_length(of->units, WHIRL_FROM_CENTRE, "sag, upwards", panel->y.label, sizeof panel->y.label);
    const double high = fmax(1.12 * fmax(-range.low, range.high), 1e-9 * length);
    axis_show(&panel->y, (span){-high, high});
    along_machine(figure, panel, &along, high);
    along_axis(figure, panel, of, &along);
    panel_level(figure, panel, 0.0, "#909090", 0.4);
    along_shape(figure, panel, &(along_curve){of, &along, moved && line->sag ? bends : NULL, moved, 1, 0}, values);
    snprintf(figure->caption, sizeof figure->caption,
             "Sag of the shafts by their weight on rigid bearings, measured upwards from the straight line on which "
             "bearings "
             "without elevations lie; marks at stations.%s",
             along_caption(&along));
    free(moved);
    bends_free(bends);
    layout_free(along.layout);
}

const figure_kind sag_figure = {.list = list_sag, .describe = describe_sag};

// ---------------------------------------------------------------- response to unbalance

enum { DEFLECTED = 6 };

/// Returns the point of a table nearest to a speed, rad/s.
static size_t point_near(const whirl_table *table, double speed) {
    size_t near = table->count;
    double least = HUGE_VAL;
    for (size_t point = 0; point < table->count; point++) {
        if (!whirl_table_done(table, point)) continue;
        const double apart = fabs(*whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_SPEED, 0) - speed);
        if (apart < least) least = apart, near = point;
    }
    return near;
}

static void add_point(const whirl_table *table, double speed, size_t points[DEFLECTED], size_t *count) {
    const size_t own = point_near(table, speed);
    for (size_t i = 0; i < *count; i++)
        if (points[i] == own) return;
    if (own < table->count && *count < DEFLECTED) points[(*count)++] = own;
}

/// Returns the largest peak at a probe that is smaller than `below`; amplitude 0 if there is none.
static margin_row next_peak(const drawing *of, const whirl_table *table, double below) {
    margin_row rows[2 * MARGIN_PEAKS], largest = {.amplitude = 0.0};
    for (size_t s = 0; s < of->result->station_count; s++) {
        const size_t count = margin_probed(of->result, table, s) ? margin_rows(of->result, table, s, rows) : 0;
        for (size_t i = 0; i < count; i++)
            if (rows[i].amplitude < below && rows[i].amplitude > largest.amplitude) largest = rows[i];
    }
    return largest;
}

static int deflected_by_number(const void *a, const void *b) {
    const size_t one = *(const size_t *)a, other = *(const size_t *)b;
    return (one > other) - (one < other);
}

/// Chooses the points at which shapes are drawn, in their order, and returns their number: both ends of the running
/// speeds and the largest peaks at probes; if there are none of these, the point with the largest orbit.
static size_t choose_points(const drawing *of, const whirl_table *table, size_t points[DEFLECTED]) {
    double low, high, below = HUGE_VAL, most = -1.0;
    size_t count = 0, largest = table->count;
    if (margin_running(table, &low, &high)) {
        add_point(table, low, points, &count);
        add_point(table, high, points, &count);
    }
    for (bool any = true; any && count < DEFLECTED;) {
        const margin_row peak = next_peak(of, table, below);
        any = peak.amplitude > 0.0;
        if (any) add_point(table, peak.speed, points, &count);
        below = peak.amplitude;
    }
    for (size_t point = 0; point < table->count && count == 0; point++)
        for (size_t s = 0; s < of->result->station_count && whirl_table_done(table, point); s++) {
            const double axis = *whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_AXES, s);
            if (axis > most) most = axis, largest = point;
        }
    if (largest < table->count) points[count++] = largest;
    qsort(points, count, sizeof *points, deflected_by_number);
    return count;
}

static void list_deflected(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &deflected_figure, .table = table, .point = NO_POINT, .station = SIZE_MAX};
    size_t points[DEFLECTED];
    if (table_has(table, WHIRL_FIELD_UNBALANCE_AMPLITUDE) && of->result->station_count > 1 &&
        choose_points(of, table, points) > 0)
        list_figure(to, &place, "deflected", "Shafts bent by unbalance");
}

/// Returns x_cos, x_sin, y_cos or y_sin of a station, in shown units.
static double station_number(const whirl_table *table, size_t point, size_t station, size_t column, double length) {
    static const double degree = 3.14159265358979323846 / 180.0;
    const double size = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_AMPLITUDE, station)[column / 2];
    const double lag = whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_LAG, station)[column / 2];
    const double angle = isfinite(lag) ? lag * degree : 0.0;
    return length * size * (column % 2 ? sin(angle) : cos(angle));
}

static void add_deflected(whirl_figure *figure, const drawing *of, const whirl_table *table, size_t point, bool lowest,
                          const machine_along *along) {
    // Make a panel named after the point.
    const double length = whirl_shown_length(of->units, table, point);
    const speed_unit unit = speed_unit_of(of, table, WHIRL_FIELD_UNBALANCE_SPEED);
    char name[WHIRL_NAME_SIZE];
    double values[4][WHIRL_MAX_PROBES], most = 0.0;
    snprintf(name, sizeof name, "point-%zu", point + 1);
    whirl_panel *panel = figure_panel(figure, name, 0.5, 2.4);
    // Compute the bent line between stations. Shafts that are not of finite elements have none.
    shaft_bends *bends = bends_new(of, table, point);
    const size_t places = bends ? bends_line(bends)->count : 0;
    double *moved = places > 0 ? calloc(4 * places, sizeof *moved) : NULL;
    const bool bent = moved && bends_response(bends, moved);
    // Find the largest displacement, at stations and between them.
    for (size_t i = 0; bent && i < 4 * places; i++) most = fmax(most, fabs(moved[i] *= length));
    for (size_t i = 0; i < 4 * of->result->station_count; i++)
        most = fmax(most, fabs(values[i % 4][i / 4] = station_number(table, point, i / 4, i % 4, length)));
    // Draw the machine, then real and imaginary parts along x and y.
    if (panel) {
        const double high = most > 0.0 ? 1.1 * most : 1.0;
        snprintf(panel->title, sizeof panel->title, "%.5g %.40s",
                 *whirl_table_field(table, point, WHIRL_FIELD_UNBALANCE_SPEED, 0) / unit.size, unit.name);
        symbol_length(of->units, WHIRL_FROM_CENTRE, "displacement", panel->y.label, sizeof panel->y.label);
        axis_show(&panel->y, (span){-high, high});
        along_machine(figure, panel, along, high);
        along_axis(figure, panel, of, along);
        if (!lowest) *panel->x.label = '\0';
        for (size_t column = 0; column < 4; column++)
            along_shape(figure, panel, &(along_curve){of, along, bent ? bends : NULL, moved, 4, column},
                        values[column]);
    }
    free(moved);
    bends_free(bends);
}

static void describe_deflected(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    machine_along along;
    size_t points[DEFLECTED];
    const size_t count = choose_points(of, table, points);
    figure->font = 6.5;
    along_place(of, &along);
    for (size_t i = 0; i < count; i++) add_deflected(figure, of, table, points[i], i + 2 >= count, &along);
    snprintf(
        figure->caption, sizeof figure->caption,
        "Shafts in the response to unbalance, from where they rest, at the points nearest to the largest peaks (to "
        "the largest orbit, if there are no peaks)%s: blue x, orange y; full lines when the mark is at the x axis, "
        "dashed lines a quarter of a revolution later; marks at stations.%s",
        margin_asked(table) ? " and to both ends of the running speeds" : "", along_caption(&along));
    layout_free(along.layout);
}

const figure_kind deflected_figure = {.list = list_deflected, .describe = describe_deflected};
