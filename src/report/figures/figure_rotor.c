// Drawing of the machine to scale: shafts, discs, and symbols of the elements on them.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_kinds.h"
#include "machine_layout.h"
#include "margins.h"
#include "whirl/internal/model.h"

// ---------------------------------------------------------------- drawing

/// State of the drawing. Functions take places in m, with x along and y across the shafts; a vertical machine is drawn
/// upright, with x up or down.
typedef struct pen {
    whirl_figure *figure;
    whirl_panel *panel;
    machine_layout *l;
    double unit;    ///< m of one shown unit
    double upright; ///< 0 for a horizontal machine; 1 or -1 if x points up or down
    double cm;      ///< m of the machine for each cm of the drawing, approximately
} pen;

static void reach(machine_layout *l, double x, double low, double high) {
    span_widen(&l->along, x);
    l->top = fmax(l->top, high);
    l->bottom = fmin(l->bottom, low);
}

/// Return the coordinates of a place in the panel, in shown units.
static double pen_x(const pen *p, double x, double y) {
    return (p->upright != 0.0 ? y : x) / p->unit;
}

static double pen_y(const pen *p, double x, double y) {
    return (p->upright != 0.0 ? p->upright * x : y) / p->unit;
}

static void pen_box(const pen *p, whirl_series *to, double x, double half, double low, double high) {
    const double along = p->upright < 0.0 ? -half : half;
    const double left = pen_x(p, x - along, low), right = pen_x(p, x + along, high);
    series_add_box(p->figure, to, (span){left, right}, (span){pen_y(p, x - along, low), pen_y(p, x + along, high)});
    reach(p->l, x - half, low, high);
    reach(p->l, x + half, low, high);
}

static void pen_point(const pen *p, whirl_series *to, double x, double y) {
    series_add(p->figure, to, pen_x(p, x, y), pen_y(p, x, y));
    reach(p->l, x, y, y);
}

static void pen_text(const pen *p, whirl_series *to, double x, double y, const char *text) {
    series_add_text(p->figure, to, pen_x(p, x, y), pen_y(p, x, y), text);
}

static void pen_line(const pen *p, whirl_series *to, double x, double y, double x_to, double y_to) {
    pen_point(p, to, x, y);
    pen_point(p, to, x_to, y_to);
    series_break(p->figure, to);
}

/// Fills a wall of a shaft along `x` above (side 1) or below the axis; inner and outer: distances from the axis at both
/// ends. A series of areas is filled between two heights. The wall of a vertical machine is therefore filled along the
/// shaft, with one point at each distance from the axis at which the wall has a corner.
static void pen_fill(const pen *p, whirl_series *area, span x, const double inner[2], const double outer[2], int side) {
    if (p->upright == 0.0) {
        for (int end = 0; end < 2; end++)
            series_add_to(p->figure, area, (end ? x.high : x.low) / p->unit, inner[end] / p->unit,
                          outer[end] / p->unit);
        series_break(p->figure, area);
        return;
    }
    // Sort the distances of the corners of the upright wall.
    const double corners[] = {inner[0], inner[1], outer[0], outer[1]};
    double at[4];
    size_t count = 0;
    for (double after = -HUGE_VAL; count < 4;) {
        double next = HUGE_VAL;
        for (size_t i = 0; i < 4; i++)
            if (corners[i] > after) next = fmin(next, corners[i]);
        if (next == HUGE_VAL) break;
        at[count++] = after = next;
    }
    // Fill along the shaft at each of them.
    for (size_t i = 0; i < count; i++) {
        span along = x;
        const double c = at[i];
        // A slanted edge cuts off the part that the wall does not have at this distance.
        for (int edge = 0; edge < 2; edge++) {
            const double *r = edge ? outer : inner;
            if (r[0] == r[1] || c < fmin(r[0], r[1]) || c > fmax(r[0], r[1])) continue;
            const bool kept_low = edge ? side * r[0] > side * r[1] : side * r[0] < side * r[1];
            *(kept_low ? &along.high : &along.low) = x.low + (x.high - x.low) * (c - r[0]) / (r[1] - r[0]);
        }
        const double low = p->upright * along.low / p->unit, high = p->upright * along.high / p->unit;
        series_add_to(p->figure, area, c / p->unit, fmin(low, high), fmax(low, high));
    }
    series_break(p->figure, area);
}

/// Draws the wall of a section above (side 1) or below the axis.
static void pen_wall(const pen *p, whirl_series *area, whirl_series *edge, const whirl_model_section *s, int side) {
    const machine_layout *l = p->l;
    const double axis = l->axis[s->shaft], from = l->offset[s->shaft] + s->from, to = l->offset[s->shaft] + s->to;
    double inner[2], outer[2];
    for (int end = 0; end < 2; end++) {
        inner[end] = axis + side * 0.5 * s->inner[end];
        outer[end] = axis + side * 0.5 * s->outer[end];
    }
    pen_fill(p, area, (span){from, to}, inner, outer, side);
    pen_point(p, edge, from, inner[0]);
    pen_point(p, edge, from, outer[0]);
    pen_point(p, edge, to, outer[1]);
    pen_point(p, edge, to, inner[1]);
    if (s->inner[0] > 0.0 || s->inner[1] > 0.0) pen_point(p, edge, from, inner[0]);
    series_break(p->figure, edge);
}

static void draw_shafts(const pen *p) {
    const machine_layout *l = p->l;
    whirl_series *axis = panel_series(p->figure, p->panel, WHIRL_LINE, "#909090", 0.4);
    whirl_series *area = panel_named(p->figure, p->panel, WHIRL_AREA, "shaft", "#B9C6D2", 1.0);
    whirl_series *edge = panel_series(p->figure, p->panel, WHIRL_LINE, "#303030", 0.5);
    if (axis) axis->dashed = true;
    for (size_t i = 0; i < l->model.section_count; i++)
        for (int side = 1; side >= -1; side -= 2) pen_wall(p, area, edge, &l->model.sections[i], side);
    for (size_t s = 0; s < l->model.shaft_count; s++) {
        const span ends = layout_shaft_ends(l, s);
        if (span_has_any(ends)) pen_line(p, axis, ends.low - l->symbol, l->axis[s], ends.high + l->symbol, l->axis[s]);
    }
}

/// Draws discs and masses, with a hole for their shaft.
static void draw_masses(const pen *p) {
    machine_layout *l = p->l;
    whirl_series *discs = NULL;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        const bool on_shaft = own->shaft < l->model.shaft_count;
        if (!(layout_mass(own) > 0.0)) continue;
        if (!discs)
            discs = panel_named(p->figure, p->panel, WHIRL_BOXES, l->to_scale ? "discs and masses" : "masses",
                                "#7D93A8", 0.4);
        if (on_shaft) {
            const layout_disc disc = layout_disc_of(l, s);
            pen_box(p, discs, l->x[s], disc.half, l->y[s] + l->radius[s], l->y[s] + disc.radius);
            pen_box(p, discs, l->x[s], disc.half, l->y[s] - disc.radius, l->y[s] - l->radius[s]);
        } else {
            pen_box(p, discs, l->x[s], l->radius[s], l->y[s] - l->radius[s], l->y[s] + l->radius[s]);
        }
    }
}

/// Draws the ground at a place: a line with hatches below.
static void draw_ground(const pen *p, whirl_series *to, double x, double y) {
    const double u = p->l->symbol;
    pen_line(p, to, x - 0.8 * u, y, x + 0.8 * u, y);
    for (int k = -1; k <= 1; k++) pen_line(p, to, x + 0.5 * k * u + 0.2 * u, y, x + 0.5 * k * u - 0.2 * u, y - 0.4 * u);
}

/// Symbol of a bearing, seal, stator or support: a block above and one below its station, and its link to the ground.
typedef struct symbol {
    whirl_model_role role;
    const char *name, *colour;
    double half, from, to; ///< half of its width, and inner and outer edge beyond the station's radius, in symbol sizes
} symbol;

static const symbol symbols[] = {
    {WHIRL_ROLE_BEARING, "bearings", "#0072B2", 0.7, 0.0, 0.8},
    {WHIRL_ROLE_DRAG, "seals and stages", "#009E73", 0.45, 0.1, 0.5},
    {WHIRL_ROLE_STATOR, "stators", "#D55E00", 0.9, 0.55, 0.75},
};

static void draw_symbol(const pen *p, const symbol *what) {
    machine_layout *l = p->l;
    whirl_series *blocks = NULL, *ground = NULL;
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        if (e->role != what->role || !layout_has_station(l, e->station[0])) continue;
        const double x = l->x[e->station[0]], y = l->y[e->station[0]], u = l->symbol;
        // A stator surrounds the disc, other symbols the shaft.
        const double r =
            what->role == WHIRL_ROLE_STATOR ? layout_rim_radius(l, e->station[0]) : l->radius[e->station[0]];
        if (!blocks) {
            blocks = panel_named(p->figure, p->panel, WHIRL_BOXES, what->name, what->colour, 0.4);
            ground = panel_series(p->figure, p->panel, WHIRL_LINE, "#404040", 0.5);
        }
        pen_box(p, blocks, x, what->half * u, y + r + what->from * u, y + r + what->to * u);
        pen_box(p, blocks, x, what->half * u, y - r - what->to * u, y - r - what->from * u);
        if (layout_has_station(l, e->station[1]))
            pen_line(p, ground, x, y - r - what->to * u, l->x[e->station[1]], l->y[e->station[1]]);
        else if (what->role == WHIRL_ROLE_BEARING)
            draw_ground(p, ground, x, y - r - what->to * u);
    }
}

/// Draws a spring, a zigzag from one height down to another.
static void draw_spring(const pen *p, whirl_series *to, double x, double high, double low) {
    enum { BENDS = 6 };
    pen_point(p, to, x, high);
    for (int k = 1; k <= BENDS; k++)
        pen_point(p, to, x + (k % 2 ? 0.3 : -0.3) * p->l->symbol, high + (low - high) * k / (BENDS + 1.0));
    pen_point(p, to, x, low);
    series_break(p->figure, to);
}

static void draw_supports(const pen *p) {
    machine_layout *l = p->l;
    whirl_series *springs = NULL;
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        const size_t station = layout_has_station(l, e->station[0]) ? e->station[0] : e->station[1];
        if (e->role != WHIRL_ROLE_SUPPORT || !layout_has_station(l, station)) continue;
        const double x = l->x[station], y = l->y[station] - l->radius[station], u = l->symbol;
        if (!springs) springs = panel_named(p->figure, p->panel, WHIRL_LINE, "supports", "#404040", 0.7);
        draw_spring(p, springs, x, y, y - 1.6 * u);
        draw_ground(p, springs, x, y - 1.6 * u);
    }
}

/// Draws elements between two stations: as a bar along the axis, or as a spring if one station is below the other.
static void draw_links(const pen *p) {
    machine_layout *l = p->l;
    whirl_series *bars = NULL;
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        if (e->role != WHIRL_ROLE_LINK || !layout_has_station(l, e->station[0]) ||
            !layout_has_station(l, e->station[1]))
            continue;
        const size_t a = e->station[0], b = e->station[1];
        if (!bars)
            bars = panel_named(p->figure, p->panel, WHIRL_LINE,
                               l->to_scale ? "couplings and springs" : "shafts and springs", "#303030", 1.4);
        if (fabs(l->x[a] - l->x[b]) > 1e-9) {
            pen_line(p, bars, l->x[a], l->y[a], l->x[b], l->y[b]);
        } else if (fabs(l->y[a] - l->y[b]) > 1e-9) {
            const size_t upper = l->y[a] > l->y[b] ? a : b, lower = upper == a ? b : a;
            draw_spring(p, bars, l->x[a], l->y[upper] - l->radius[upper], l->y[lower] + l->radius[lower]);
        } else {
            pen_line(p, bars, l->x[a], l->y[a] + l->radius[a] + l->symbol, l->x[a], l->y[a] - l->radius[a] - l->symbol);
        }
    }
}

/// Returns true if a table of the result names the station among those with probes.
static bool has_probe(const whirl_result *result, size_t station) {
    for (size_t t = 0; t < result->table_count; t++)
        if (*result->tables[t].record.probes_at && margin_probed(result, &result->tables[t], station)) return true;
    return false;
}

/// Draws marks above stations: planes of unbalance, and probes.
static void draw_marks(const pen *p) {
    machine_layout *l = p->l;
    whirl_series *planes = NULL, *seen = NULL;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const double radius = layout_rim_radius(l, s);
        if (l->model.stations[s].unbalanced) {
            if (!planes) planes = panel_named(p->figure, p->panel, WHIRL_DOTS, "unbalance", "#CC79A7", 3.4);
            if (planes) planes->mark = WHIRL_DISC;
            pen_point(p, planes, l->x[s], l->y[s] + radius + 1.2 * l->symbol);
        }
        if (has_probe(l->result, s)) {
            if (!seen) seen = panel_named(p->figure, p->panel, WHIRL_DOTS, "probes", "#E69F00", 3.8);
            if (seen) seen->mark = p->upright != 0.0 ? WHIRL_DIAMOND : WHIRL_DOWN;
            pen_point(p, seen, l->x[s], l->y[s] + radius + 2.2 * l->symbol);
        }
    }
}

typedef struct label {
    size_t station;
    double x;
} label;

static int by_place(const void *a, const void *b) {
    const double one = ((const label *)a)->x, other = ((const label *)b)->x;
    return (one > other) - (one < other);
}

/// Moves labels apart, by as little as possible, so that their distance is at least `step`. Labels that are too close
/// form a group, centred on their places.
static void spread_labels(label *labels, size_t count, double step) {
    size_t sizes[WHIRL_MAX_PROBES], groups = 0;
    double middles[WHIRL_MAX_PROBES]; // mean of x - i step over the labels i of a group
    for (size_t i = 0; i < count; i++) {
        middles[groups] = labels[i].x - (double)i * step;
        sizes[groups++] = 1;
        for (; groups > 1 && middles[groups - 1] < middles[groups - 2]; groups--) {
            const double one = (double)sizes[groups - 2], other = (double)sizes[groups - 1];
            middles[groups - 2] = (one * middles[groups - 2] + other * middles[groups - 1]) / (one + other);
            sizes[groups - 2] += sizes[groups - 1];
        }
    }
    for (size_t g = 0, i = 0; g < groups; g++)
        for (size_t k = 0; k < sizes[g]; k++, i++) labels[i].x = middles[g] + (double)i * step;
}

/// Writes the names of an axis' stations above its parts, with strokes to their places. step: least distance of names;
/// high: top of the parts.
static void name_axis(const pen *p, double axis, double high, double step) {
    machine_layout *l = p->l;
    label labels[WHIRL_MAX_PROBES];
    size_t count = 0;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++)
        if (l->y[s] == axis) labels[count++] = (label){s, l->x[s]};
    if (count == 0) return;
    qsort(labels, count, sizeof *labels, by_place);
    spread_labels(labels, count, step);
    whirl_series *names = panel_series(p->figure, p->panel, WHIRL_TEXTS, "#303030", 1.0);
    whirl_series *strokes = panel_series(p->figure, p->panel, WHIRL_LINE, "#A0A0A0", 0.35);
    if (names) names->side = p->upright != 0.0 ? WHIRL_BESIDE : WHIRL_SLANTED;
    for (size_t i = 0; i < count; i++) {
        const size_t s = labels[i].station;
        pen_line(p, strokes, l->x[s], l->y[s] + l->radius[s], labels[i].x, high);
        pen_text(p, names, labels[i].x, high, l->result->stations[s].name);
    }
}

/// Returns the top of all parts on an axis, above which its names begin.
static double axis_top(const machine_layout *l, double axis) {
    double high = axis;
    for (size_t k = 0; k < l->model.station_count && k < WHIRL_MAX_PROBES; k++)
        if (l->y[k] == axis) high = fmax(high, axis + layout_rim_radius(l, k));
    for (size_t k = 0; k < l->model.shaft_count; k++)
        if (l->axis[k] == axis) high = fmax(high, axis + layout_largest_radius(l, k));
    return high + 2.9 * l->symbol;
}

/// Writes the names of housings next to their stations, below the shafts.
static void name_housings(const pen *p) {
    machine_layout *l = p->l;
    whirl_series *names = panel_series(p->figure, p->panel, WHIRL_TEXTS, "#303030", 1.0);
    if (names) names->side = WHIRL_BESIDE;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        bool on_axis = !l->to_scale && l->y[s] == 0.0;
        for (size_t k = 0; k < l->model.shaft_count; k++) on_axis = on_axis || l->y[s] == l->axis[k];
        if (on_axis) continue;
        const char *name = l->result->stations[s].name;
        const double right = l->x[s] + l->radius[s], side = l->y[s] - l->radius[s];
        const double width = (figure_text_width(p->figure, strlen(name)) + 0.2) * p->cm;
        if (p->upright != 0.0) {
            pen_text(p, names, l->x[s], side - width, name);
            l->bottom = fmin(l->bottom, side - width);
            continue;
        }
        pen_text(p, names, right, l->y[s], name);
        span_widen(&l->along, right + width);
    }
}

/// Returns half of the width of a station's hot spot, which covers its parts, at most half-way to its neighbours.
static double spot_half(const machine_layout *l, size_t station) {
    double half = 1.5 * l->symbol;
    if (layout_mass(&l->model.stations[station]) > 0.0 && l->to_scale)
        half = fmax(half, 0.5 * layout_disc_width(&l->model.stations[station]));
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++)
        if (s != station && l->y[s] == l->y[station] && l->x[s] != l->x[station])
            half = fmin(half, 0.5 * fabs(l->x[s] - l->x[station]));
    return half;
}

/// Adds hot spots of stations, from their names down to their lower edges.
static void add_spots(const pen *p) {
    const machine_layout *l = p->l;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const double half = spot_half(l, s), low = l->y[s] - layout_rim_radius(l, s) - l->symbol;
        const bool on_axis = l->model.stations[s].shaft < l->model.shaft_count || (!l->to_scale && l->y[s] == 0.0);
        const double high = on_axis ? axis_top(l, l->y[s]) : 2.0 * l->y[s] - low;
        const double x[] = {pen_x(p, l->x[s] - half, low), pen_x(p, l->x[s] + half, high)};
        const double y[] = {pen_y(p, l->x[s] - half, low), pen_y(p, l->x[s] + half, high)};
        panel_spot(p->figure, p->panel, l->result->stations[s].name, (span){fmin(x[0], x[1]), fmax(x[0], x[1])},
                   (span){fmin(y[0], y[1]), fmax(y[0], y[1])});
    }
}

// ---------------------------------------------------------------- the figure

static void rotor_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &rotor_figure, .table = table, .point = NO_POINT};
    if (of->machine && of->result->station_count > 0) list_figure(to, &place, "rotor", "The machine");
}

/// Returns the height of the names above a horizontal machine, cm.
static double names_height(const pen *p) {
    return 0.87 * figure_text_width(p->figure, layout_longest_name(p->l->result)) + 0.25;
}

/// Sets the ranges of the panel of a horizontal machine, with the same scale on both axes, and its height.
static void fit_lying(const pen *p) {
    const machine_layout *l = p->l;
    const double across = p->figure->width - 1.2, margin = 0.03 * (l->along.high - l->along.low);
    const double width = l->along.high - l->along.low + 2.0 * margin;
    const double cm = width / across; // m for each cm
    const double low = l->bottom - margin, high = l->top + names_height(p) * cm;
    p->panel->height = fmin(fmax((high - low) / cm, 2.5), 14.0);
    axis_show(&p->panel->x, (span){(l->along.low - margin) / p->unit, (l->along.high + margin) / p->unit});
    axis_show(&p->panel->y, (span){low / p->unit, high / p->unit});
    p->panel->y.shown = false;
    p->panel->x.shown = l->to_scale;
}

/// Sets the ranges of the panel of a vertical machine, with names to the right, its height, and the width of the
/// figure.
static void fit_standing(const pen *p) {
    enum { HEIGHT = 14, WIDTH = 15 }; // cm, at most
    const machine_layout *l = p->l;
    const double margin = 0.03 * (l->along.high - l->along.low);
    const double up = p->upright * (p->upright > 0.0 ? l->along.low - margin : l->along.high + margin);
    const double length = l->along.high - l->along.low + 2.0 * margin, wide = l->top - l->bottom + 2.0 * margin;
    const double names = figure_text_width(p->figure, layout_longest_name(l->result)) + 0.3, numbers = 2.2;
    const double cm = fmax(length / HEIGHT, wide / (WIDTH - names - numbers)); // m for each cm
    p->panel->height = length / cm;
    p->figure->width = fmax(wide / cm + names + numbers, 7.0);
    axis_show(&p->panel->x, (span){(l->bottom - margin) / p->unit, (l->top + margin + names * cm) / p->unit});
    axis_show(&p->panel->y, (span){up / p->unit, (up + length) / p->unit});
    const double step = tick_step(length / p->unit, 8), first = ceil((l->along.low - margin) / p->unit / step);
    for (int k = 0; k < 24 && step * (first + k) <= (l->along.high + margin) / p->unit && l->to_scale; k++) {
        char text[32];
        snprintf(text, sizeof text, "%g", step * (first + k) + 0.0);
        axis_tick(p->figure, &p->panel->y, p->upright * step * (first + k), text);
    }
    p->panel->x.shown = false;
    p->panel->y.shown = l->to_scale;
}

static void figure_rotor_draw(const pen *p) {
    machine_layout *l = p->l;
    if (l->to_scale) draw_shafts(p);
    draw_links(p);
    draw_masses(p);
    for (size_t i = 0; i < sizeof symbols / sizeof *symbols; i++) draw_symbol(p, &symbols[i]);
    draw_supports(p);
    draw_marks(p);
    // Write names, for each axis above its own parts.
    const double step = 0.42 * p->cm;
    double done = HUGE_VAL;
    for (size_t s = 0; s < (l->to_scale ? l->model.shaft_count : 1); s++) {
        const double axis = l->to_scale ? l->axis[s] : 0.0;
        if (axis >= done) continue;
        name_axis(p, axis, axis_top(l, axis), step);
        done = axis;
    }
    name_housings(p);
}

static void rotor_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    (void)place;
    machine_layout *l = layout_new(of);
    whirl_panel *panel = figure_panel(figure, "machine", 1.0, 4.0);
    if (!l || !panel) {
        layout_free(l);
        return;
    }
    // Set up the drawing; stations of a machine without shafts to scale are one unit apart.
    const double length = l->to_scale ? l->along.high - l->along.low : (double)l->model.station_count;
    pen p = {.figure = figure, .panel = panel, .l = l, .unit = l->to_scale ? layout_unit(of->units) : 1.0};
    figure->font = 6.5;
    figure->width = 16.0;
    if (l->model.stands) p.upright = l->model.rises ? 1.0 : -1.0;
    p.cm = p.upright != 0.0 ? length / 12.0 : length / (figure->width - 1.2);
    // Draw the machine, and size the panel.
    figure_rotor_draw(&p);
    if (p.upright != 0.0)
        fit_standing(&p);
    else
        fit_lying(&p);
    add_spots(&p);
    panel->equal = true;
    whirl_axis *along = p.upright != 0.0 ? &panel->y : &panel->x;
    snprintf(along->label, sizeof along->label, "%s", layout_label(of->units));
    snprintf(figure->caption, sizeof figure->caption, "%s%s",
             l->to_scale
                 ? "The machine: shafts of finite elements to scale, along and across; discs and masses as discs of "
                   "steel of the same mass and polar inertia; symbols of what acts on stations, not to scale."
                 : "The machine: stations in their order, as large as the cube root of their masses; lines and springs "
                   "join them. It has no shaft of finite elements, so nothing is to scale.",
             l->model.stands ? " It stands, as it is drawn." : "");
    layout_free(l);
}

const figure_kind rotor_figure = {.list = rotor_list, .describe = rotor_describe, .whole = true};
