// Figures of a single bearing: quantities over speed, load or Sommerfeld number, and the journal's positions.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "whirl/internal/bearing_table.h"

static const double degree = 3.14159265358979323846 / 180.0;

/// Quantity on the horizontal axis.
typedef enum along { ALONG_SPEED, ALONG_LOAD, ALONG_SOMMERFELD } along;

/// A curve: a number of each point, with its panel and the label of the axis.
typedef struct quantity {
    const char *panel, *label, *name;
    int index; ///< 0 to 7: coefficients; -1 to -5: eccentricity, attitude, film, power, flow
} quantity;

/// Curves of a table over one axis, and the units in which they are drawn.
typedef struct curves {
    const whirl_bearing_table *table;
    const whirl_shown_units *units;
    along axis;
} curves;

static double shown(const curves *of, whirl_quantity of_kind, double value) {
    return value / of->units->of[of_kind].size;
}

static double figure_bearing_value(const curves *drawn, const whirl_bearing_point *point, int index) {
    const whirl_bearing *of = drawn->table->bearing;
    const bool bare = drawn->axis == ALONG_SOMMERFELD;
    if (!point->found) return NAN;
    switch (index) {
    case -1:
        return point->eccentricity / of->pad_clearance;
    case -2:
        return fabs(point->attitude) < 1e-9 ? 0.0 : point->attitude / degree;
    case -3:
        return bare ? point->film / of->pad_clearance : shown(drawn, WHIRL_QUANTITY_LENGTH, point->film);
    case -4:
        return shown(drawn, WHIRL_QUANTITY_POWER, point->power);
    default:
        break;
    }
    const double value = point->reduced[0][index / 4][index / 2 % 2][index % 2];
    if (!bare) return shown(drawn, index < 4 ? WHIRL_QUANTITY_STIFFNESS : WHIRL_QUANTITY_DAMPING, value);
    return value * of->pad_clearance / point->load * (index < 4 ? 1.0 : point->speed);
}

static double figure_bearing_place(const curves *drawn, const whirl_bearing_point *point) {
    return drawn->axis == ALONG_SPEED  ? shown(drawn, WHIRL_QUANTITY_SPEED, point->speed)
           : drawn->axis == ALONG_LOAD ? shown(drawn, WHIRL_QUANTITY_FORCE, point->load)
                                       : point->sommerfeld;
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

/// Returns the points in the order in which lines connect them; NULL without memory.
static const whirl_bearing_point **order(const whirl_bearing_table *table, along axis) {
    const whirl_bearing_point **points = malloc((table->count + 1) * sizeof *points);
    for (size_t i = 0; i < table->count && points; i++) points[i] = &table->points[i];
    if (points && axis == ALONG_SOMMERFELD) qsort(points, table->count, sizeof *points, by_sommerfeld);
    return points;
}

/// Adds one quantity as lines and dots. Over the speed, points with the same load form a line.
static void add_values(whirl_figure *figure, whirl_panel *panel, const curves *drawn, const quantity *what,
                       const char *colour) {
    const whirl_bearing_table *table = drawn->table;
    whirl_series *line = panel_named(figure, panel, WHIRL_LINE, what->name, colour, 0.9);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, colour, 2.0);
    const whirl_bearing_point **points = order(table, drawn->axis);
    figure->failed = figure->failed || !points;
    for (size_t i = 0; i < table->count && points; i++) {
        const double x = figure_bearing_place(drawn, points[i]),
                     y = figure_bearing_value(drawn, points[i], what->index);
        const bool anew =
            i > 0 && drawn->axis == ALONG_SPEED && !table->bearing->pairs && points[i]->load != points[i - 1]->load;
        if (anew || isnan(y)) series_break(figure, line);
        if (isnan(y)) continue;
        series_add(figure, line, x, y);
        series_add(figure, dots, x, y);
    }
    free(points);
}

/// Returns the range of the `count` quantities from `index` on, over all points. A constant quantity gets a margin
/// larger than its rounding error, and panels of several quantities get space for their legend.
static span figure_bearing_range(const curves *drawn, int index, int count) {
    span range = span_empty();
    for (size_t i = 0; i < drawn->table->count; i++)
        for (int k = 0; k < count; k++)
            span_widen(&range, figure_bearing_value(drawn, &drawn->table->points[i], index + k));
    const double size = 0.1 * fmax(fabs(range.low), fabs(range.high));
    range = span_with_margin(range, 0.06, index == -2 ? 5.0 : size);
    return count > 1 ? span_below_legend(range) : range;
}

/// Writes the label of a quantity's panel, "film (um)".
static void label_of(const curves *drawn, const quantity *what, char *label, size_t size) {
    const whirl_shown_units *units = drawn->units;
    const bool bare = drawn->axis == ALONG_SOMMERFELD;
    const char *unit = what->index == -3   ? units->length_name
                       : what->index == -4 ? units->of[WHIRL_QUANTITY_POWER].name
                       : what->index == 0  ? units->of[WHIRL_QUANTITY_STIFFNESS].name
                                           : units->of[WHIRL_QUANTITY_DAMPING].name;
    if (bare && what->index == 0)
        snprintf(label, size, "stiffness $K c/W$");
    else if (bare && what->index == 4)
        snprintf(label, size, "damping $C c \u03c9/W$");
    else if (bare && what->index == -3)
        snprintf(label, size, "film over clearance");
    else if (what->index == -1 || what->index == -2)
        snprintf(label, size, "%s", what->label);
    else
        snprintf(label, size, "%s (%.60s)", what->label, unit);
}

static void draw_curves(whirl_figure *figure, const curves *drawn) {
    // The quantities; one with a label begins a new panel.
    const whirl_bearing_table *table = drawn->table;
    const along axis = drawn->axis;
    static const quantity with_units[] = {
        {"eccentricity", "eccentricity ratio", "", -1},
        {"attitude", "attitude (deg)", "", -2},
        {"film", "film", "", -3},
        {"power", "power", "", -4},
        {"stiffness", "stiffness $K$", "$K_{xx}$", 0},
        {"stiffness", "", "$K_{xy}$", 1},
        {"stiffness", "", "$K_{yx}$", 2},
        {"stiffness", "", "$K_{yy}$", 3},
        {"damping", "damping $C$", "$C_{xx}$", 4},
        {"damping", "", "$C_{xy}$", 5},
        {"damping", "", "$C_{yx}$", 6},
        {"damping", "", "$C_{yy}$", 7},
    };
    // Name the axis that all panels share.
    whirl_panel *panel = NULL;
    char along_label[2 * WHIRL_NAME_SIZE] = "Sommerfeld number $S$";
    if (axis == ALONG_SPEED)
        snprintf(along_label, sizeof along_label, "speed (%.60s)", drawn->units->of[WHIRL_QUANTITY_SPEED].name);
    if (axis == ALONG_LOAD)
        snprintf(along_label, sizeof along_label, "load (%.60s)", drawn->units->of[WHIRL_QUANTITY_FORCE].name);
    // Add the quantities; over the Sommerfeld number they have no dimension, and power is left out.
    for (size_t i = 0; i < sizeof with_units / sizeof *with_units; i++) {
        const quantity *what = &with_units[i];
        const bool bare = axis == ALONG_SOMMERFELD;
        if (bare && what->index == -4) continue;
        if (*what->label) {
            panel = figure_panel(figure, what->panel, what->index >= 0 ? 1.0 : 0.5, what->index >= 0 ? 4.5 : 3.2);
            if (!panel) return;
            snprintf(panel->x.label, sizeof panel->x.label, "%s", along_label);
            label_of(drawn, what, panel->y.label, sizeof panel->y.label);
            panel->x.logarithmic = bare && table->count > 1;
            panel->keyed = what->index >= 0;
            axis_show(&panel->y, figure_bearing_range(drawn, what->index, what->index >= 0 ? 4 : 1));
        }
        add_values(figure, panel, drawn, what, what->index < 0 ? "#0072B2" : line_colour((size_t)what->index % 4));
    }
    // Describe the panels.
    snprintf(figure->caption, sizeof figure->caption,
             "%s over %s: eccentricity ratio (clearance of the pads), attitude from the load with the rotation, least "
             "film%s, stiffness and damping%s.%s",
             "The bearing",
             axis == ALONG_SPEED  ? "the speed"
             : axis == ALONG_LOAD ? "the load"
                                  : "the Sommerfeld number",
             axis == ALONG_SOMMERFELD ? "" : ", power loss", axis == ALONG_SOMMERFELD ? " without dimensions" : "",
             axis == ALONG_SPEED && table->bearing->load_count > 1 && !table->bearing->pairs ? " A line for each load."
                                                                                             : "");
}

/// Returns the distance from the centre at which the journal touches a pad in a direction, in pad clearances.
static double figure_bearing_touch_distance(const whirl_pads *pads, double angle) {
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
    // The wall: where the journal touches a pad.
    panel->equal = true;
    snprintf(panel->x.label, sizeof panel->x.label, "$x/c$");
    snprintf(panel->y.label, sizeof panel->y.label, "$y/c$");
    whirl_series *wall = panel_series(figure, panel, WHIRL_LINE, "#606060", 0.8);
    for (int k = 0; k <= 360; k++) {
        const double r = fmin(figure_bearing_touch_distance(&of->pads, k * degree), 1.3);
        series_add(figure, wall, r * cos(k * degree), r * sin(k * degree));
    }
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, "#0072B2", 0.7);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, "#0072B2", 2.5);
    // The positions, in the order of the Sommerfeld number: with one viscosity they lie on one curve.
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

whirl_status whirl_bearing_figure(const whirl_bearing_table *table, const char *name, const char *units,
                                  whirl_figure **out) {
    // Find the kind of figure by its name.
    static const char *const names[] = {"curves", "sommerfeld", "locus"};
    size_t which = 0;
    *out = NULL;
    while (name && which < sizeof names / sizeof *names && strcmp(names[which], name) != 0) which++;
    if (which == sizeof names / sizeof *names)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "there is no figure '%.100s' of a bearing, expected curves, sommerfeld or locus", name);
    // Make a figure in the units of the bearing, or the requested ones.
    whirl_shown_units drawn_in;
    const whirl_status status = whirl_shown_units_alone(units ? units : table->bearing->units, &drawn_in);
    if (status.code != WHIRL_OK) return status;
    whirl_figure *figure = calloc(1, sizeof *figure);
    if (!figure) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure of a bearing");
    figure->width = 12.0;
    figure->font = 7.0;
    // Name and draw it.
    snprintf(figure->name, sizeof figure->name, "bearing-%s", names[which]);
    snprintf(figure->title, sizeof figure->title, "%.200s: %s",
             *table->bearing->title ? table->bearing->title : table->bearing->kind,
             which == 2   ? "where the journal rests"
             : which == 1 ? "over the Sommerfeld number"
                          : "over speed and load");
    if (which == 2)
        draw_locus(figure, table);
    else
        draw_curves(figure, &(curves){table, &drawn_in,
                                      which == 1         ? ALONG_SOMMERFELD
                                      : one_speed(table) ? ALONG_LOAD
                                                         : ALONG_SPEED});
    // Hand it over, unless memory ran out.
    if (figure->failed) {
        whirl_figure_free(figure);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the figure of a bearing");
    }
    figure_finish(figure, NULL);
    *out = figure;
    return whirl_ok();
}
