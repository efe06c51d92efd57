// Figures of a bearing by itself: what it does over speed, load or Sommerfeld number, and where the journal rests.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "whirl/engine/bearing_table.h"

static const double degree = 3.14159265358979323846 / 180.0, rpm = 3.14159265358979323846 / 30.0, um = 1e-6;

/// What the horizontal axis has.
typedef enum along { ALONG_SPEED, ALONG_LOAD, ALONG_SOMMERFELD } along;

/// A number of a point, and of which panel and axis it is.
typedef struct quantity {
    const char *panel, *label, *name;
    int index; ///< of coefficients 0 to 7; -1 to -5: eccentricity, attitude, film, power, flow
} quantity;

static double value_of(const whirl_bearing *of, const whirl_bearing_point *point, int index, along axis) {
    if (!point->found) return NAN;
    switch (index) {
    case -1:
        return point->eccentricity / of->pad_clearance;
    case -2:
        return fabs(point->attitude) < 1e-9 ? 0.0 : point->attitude / degree;
    case -3:
        return axis == ALONG_SOMMERFELD ? point->film / of->pad_clearance : point->film / um;
    case -4:
        return 1e-3 * point->power;
    default:
        break;
    }
    const double value = point->reduced[0][index / 4][index / 2 % 2][index % 2];
    if (axis != ALONG_SOMMERFELD) return value * (index < 4 ? 1e-6 : 1e-3);
    return value * of->pad_clearance / point->load * (index < 4 ? 1.0 : point->speed);
}

static double place_of(const whirl_bearing_point *point, along axis) {
    return axis == ALONG_SPEED ? point->speed / rpm : axis == ALONG_LOAD ? point->load : point->sommerfeld;
}

static bool one_speed(const whirl_bearing_table *table) {
    for (size_t i = 1; i < table->count; i++)
        if (table->points[i].speed != table->points[0].speed) return false;
    return true;
}

static int by_sommerfeld(const void *a, const void *b) {
    const double one = (*(const whirl_bearing_point *const *)a)->sommerfeld;
    const double other = (*(const whirl_bearing_point *const *)b)->sommerfeld;
    return (one > other) - (one < other);
}

/// The points in the order in which lines go; NULL without memory.
static const whirl_bearing_point **order(const whirl_bearing_table *table, along axis) {
    const whirl_bearing_point **points = malloc((table->count + 1) * sizeof *points);
    for (size_t i = 0; i < table->count && points; i++) points[i] = &table->points[i];
    if (points && axis == ALONG_SOMMERFELD) qsort(points, table->count, sizeof *points, by_sommerfeld);
    return points;
}

/// Points of one load hang together over the speed, those of the next begin anew.
static void add_values(whirl_figure *figure, whirl_panel *panel, const whirl_bearing_table *table, along axis,
                       const quantity *what, const char *colour) {
    whirl_series *line = panel_named(figure, panel, WHIRL_LINE, what->name, colour, 0.9);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, colour, 2.0);
    const whirl_bearing_point **points = order(table, axis);
    figure->failed = figure->failed || !points;
    for (size_t i = 0; i < table->count && points; i++) {
        const double x = place_of(points[i], axis), y = value_of(table->bearing, points[i], what->index, axis);
        const bool anew =
            i > 0 && axis == ALONG_SPEED && !table->bearing->pairs && points[i]->load != points[i - 1]->load;
        if (anew || isnan(y)) series_break(figure, line);
        if (isnan(y)) continue;
        series_add(figure, line, x, y);
        series_add(figure, dots, x, y);
    }
    free(points);
}

/// Of all points and the `count` quantities from `index` on. One that does not change has room around it, more than its
/// rounding; above coefficients there is a row for their legend.
static span range_of(const whirl_bearing_table *table, along axis, int index, int count) {
    const double legend = count > 1 ? 0.16 : 0.0;
    span range = span_empty();
    for (size_t i = 0; i < table->count; i++)
        for (int k = 0; k < count; k++)
            span_widen(&range, value_of(table->bearing, &table->points[i], index + k, axis));
    const double size = 0.1 * fmax(fabs(range.low), fabs(range.high));
    range = span_with_margin(range, 0.06, index == -2 ? 5.0 : size);
    range.high += legend / (1.0 - legend) * (range.high - range.low);
    return range;
}

static void draw_curves(whirl_figure *figure, const whirl_bearing_table *table, along axis) {
    static const quantity with_units[] = {
        {"eccentricity", "eccentricity ratio", "", -1},
        {"attitude", "attitude (deg)", "", -2},
        {"film", "film (\u00b5m)", "", -3},
        {"power", "power (kW)", "", -4},
        {"stiffness", "stiffness $K$ (MN/m)", "$K_{xx}$", 0},
        {"stiffness", "", "$K_{xy}$", 1},
        {"stiffness", "", "$K_{yx}$", 2},
        {"stiffness", "", "$K_{yy}$", 3},
        {"damping", "damping $C$ (kN s/m)", "$C_{xx}$", 4},
        {"damping", "", "$C_{xy}$", 5},
        {"damping", "", "$C_{yx}$", 6},
        {"damping", "", "$C_{yy}$", 7},
    };
    static const char *const labels[] = {"speed (rpm)", "load (N)", "Sommerfeld number $S$"};
    whirl_panel *panel = NULL;
    for (size_t i = 0; i < sizeof with_units / sizeof *with_units; i++) {
        const quantity *what = &with_units[i];
        const bool bare = axis == ALONG_SOMMERFELD;
        if (bare && what->index == -4) continue;
        if (*what->label) {
            panel = figure_panel(figure, what->panel, what->index >= 0 ? 1.0 : 0.5, what->index >= 0 ? 4.5 : 3.2);
            if (!panel) return;
            snprintf(panel->x.label, sizeof panel->x.label, "%s", labels[axis]);
            const char *label = what->label;
            if (bare && what->index == 0) label = "stiffness $K c/W$";
            if (bare && what->index == 4) label = "damping $C c \u03c9/W$";
            if (bare && what->index == -3) label = "film over clearance";
            snprintf(panel->y.label, sizeof panel->y.label, "%s", label);
            panel->x.logarithmic = bare && table->count > 1;
            panel->keyed = what->index >= 0;
            axis_show(&panel->y, range_of(table, axis, what->index, what->index >= 0 ? 4 : 1));
        }
        add_values(figure, panel, table, axis, what,
                   what->index < 0 ? "#0072B2" : line_colour((size_t)what->index % 4));
    }
    snprintf(figure->caption, sizeof figure->caption,
             "%s over %s: eccentricity ratio (clearance of the pads), attitude from the load with the rotation, least "
             "film%s, stiffness and damping%s.%s",
             "The bearing",
             axis == ALONG_SPEED  ? "the speed"
             : axis == ALONG_LOAD ? "the load"
                                  : "the Sommerfeld number",
             axis == ALONG_SOMMERFELD ? "" : ", power loss", axis == ALONG_SOMMERFELD ? " without dimensions" : "",
             axis == ALONG_SPEED && table->bearing->load_count > 1 && !table->bearing->pairs ? " A line a load." : "");
}

/// How far from the middle the journal touches a pad in a direction, in clearances of pads.
static double touches(const whirl_pads *pads, double angle) {
    enum { LOOKS = 180 };
    double least = 1.0 + WHIRL_MAX_PADS;
    for (size_t i = 0; i < pads->count; i++) {
        const whirl_pad *pad = &pads->pads[i];
        for (int k = 0; k <= (pads->tilting ? 0 : LOOKS); k++) {
            const double at = pads->tilting ? pad->pivot : pad->pivot + pad->arc * ((double)k / LOOKS - pad->offset);
            const double towards = cos(at - angle), free = 1.0 - pad->preload * cos(at - pad->pivot);
            if (towards > 1e-3) least = fmin(least, free / towards);
        }
    }
    return least;
}

static void draw_locus(whirl_figure *figure, const whirl_bearing_table *table) {
    const whirl_bearing *of = table->bearing;
    whirl_panel *panel = figure_panel(figure, "locus", 0.7, 6.9);
    if (!panel) return;
    panel->equal = true;
    snprintf(panel->x.label, sizeof panel->x.label, "$x/c$");
    snprintf(panel->y.label, sizeof panel->y.label, "$y/c$");
    whirl_series *wall = panel_series(figure, panel, WHIRL_LINE, "#606060", 0.8);
    for (int k = 0; k <= 360; k++) {
        const double r = fmin(touches(&of->pads, k * degree), 1.3);
        series_add(figure, wall, r * cos(k * degree), r * sin(k * degree));
    }
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, "#0072B2", 0.7);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, "#0072B2", 2.5);
    // Of one viscosity all places lie on one curve.
    const whirl_bearing_point **points = order(table, ALONG_SOMMERFELD);
    figure->failed = figure->failed || !points;
    for (size_t i = 0; i < table->count && points; i++) {
        if (!points[i]->found) continue;
        series_add(figure, line, points[i]->state.at[0], points[i]->state.at[1]);
        series_add(figure, dots, points[i]->state.at[0], points[i]->state.at[1]);
    }
    free(points);
    snprintf(figure->caption, sizeof figure->caption,
             "Where the journal rests, in clearances of the pads; grey: where it touches one. The load is at %.5g deg "
             "from x towards y.",
             of->load_angle / degree);
}

whirl_status whirl_bearing_figure(const whirl_bearing_table *table, const char *name, whirl_figure **out) {
    static const char *const names[] = {"curves", "sommerfeld", "locus"};
    size_t which = 0;
    *out = NULL;
    while (name && which < sizeof names / sizeof *names && strcmp(names[which], name) != 0) which++;
    if (which == sizeof names / sizeof *names)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "there is no figure '%.100s' of a bearing, expected curves, sommerfeld or locus", name);
    whirl_figure *figure = calloc(1, sizeof *figure);
    if (!figure) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure of a bearing");
    figure->width = 12.0;
    figure->font = 7.0;
    snprintf(figure->name, sizeof figure->name, "bearing-%s", names[which]);
    snprintf(figure->title, sizeof figure->title, "%.200s: %s",
             *table->bearing->title ? table->bearing->title : table->bearing->kind,
             which == 2   ? "where the journal rests"
             : which == 1 ? "over the Sommerfeld number"
                          : "over speed and load");
    if (which == 2)
        draw_locus(figure, table);
    else
        draw_curves(figure, table, which == 1 ? ALONG_SOMMERFELD : one_speed(table) ? ALONG_LOAD : ALONG_SPEED);
    if (figure->failed) {
        whirl_figure_free(figure);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure of a bearing");
    }
    figure_finish(figure, NULL);
    *out = figure;
    return whirl_ok();
}
