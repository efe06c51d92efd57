// The machine as a drawing, to scale: shafts, discs, and symbols of what acts on them.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_kinds.h"
#include "shown_kinds.h"
#include "whirl/engine/model.h"

/// What the drawing of a machine is laid out by. Lengths in m; of a machine without shafts of finite elements they mean
/// nothing.
typedef struct layout {
    const whirl_result *result;
    whirl_model model;
    bool to_scale;                                           ///< the machine has shafts of finite elements
    double offset[WHIRL_MAX_SHAFTS], axis[WHIRL_MAX_SHAFTS]; ///< where a shaft begins; its height
    bool placed_shaft[WHIRL_MAX_SHAFTS];
    bool placed[WHIRL_MAX_PROBES];
    double x[WHIRL_MAX_PROBES], y[WHIRL_MAX_PROBES], radius[WHIRL_MAX_PROBES]; ///< of every station
    double symbol;                                                             ///< size of symbols
    double top, bottom;                                                        ///< of all that is drawn
    span along;
} layout;

/// Density by which masses and inertias become discs, kg/m3: steel.
static const double steel = 7850.0;

static const double pi = 3.14159265358979323846;

static bool is_station(const layout *l, size_t station) {
    return station < l->model.station_count && station < WHIRL_MAX_PROBES;
}

// ---------------------------------------------------------------- where shafts and stations are

/// Outer radius of a shaft at a place along it, the larger one where it steps; 0 beyond its ends.
static double shaft_radius(const layout *l, size_t shaft, double at) {
    double radius = 0.0;
    for (size_t i = 0; i < l->model.section_count; i++) {
        const whirl_model_section *s = &l->model.sections[i];
        const double slack = 1e-9 * (s->to - s->from);
        if (s->shaft != shaft || at < s->from - slack || at > s->to + slack) continue;
        const double share = (at - s->from) / (s->to - s->from);
        radius = fmax(radius, 0.5 * (s->outer[0] + share * (s->outer[1] - s->outer[0])));
    }
    return radius;
}

static double largest_radius(const layout *l, size_t shaft) {
    double radius = 0.0;
    for (size_t i = 0; i < l->model.section_count; i++)
        if (l->model.sections[i].shaft == shaft)
            radius = fmax(radius, 0.5 * fmax(l->model.sections[i].outer[0], l->model.sections[i].outer[1]));
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++)
        if (l->model.stations[s].shaft == shaft) radius = fmax(radius, l->radius[s]);
    return radius;
}

/// Puts a shaft on the axis of another one, if an element joins them: their stations there have one place.
static bool align_shaft(layout *l, size_t shaft) {
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        for (int end = 0; end < 2; end++) {
            if (!is_station(l, e->station[0]) || !is_station(l, e->station[1])) continue;
            const whirl_model_mass *own = &l->model.stations[e->station[end]];
            const whirl_model_mass *other = &l->model.stations[e->station[1 - end]];
            if (own->shaft != shaft || other->shaft >= l->model.shaft_count || !l->placed_shaft[other->shaft]) continue;
            l->offset[shaft] = l->offset[other->shaft] + other->position - own->position;
            l->axis[shaft] = l->axis[other->shaft];
            return l->placed_shaft[shaft] = true;
        }
    }
    return false;
}

/// Shafts that an element joins lie on one axis, the others below one another.
static void place_shafts(layout *l) {
    double axis = 0.0;
    size_t left = l->model.shaft_count;
    while (left > 0) {
        bool any = false;
        for (size_t s = 0; s < l->model.shaft_count; s++)
            if (!l->placed_shaft[s] && align_shaft(l, s)) left--, any = true;
        if (any || left == 0) continue;
        size_t next = 0;
        while (l->placed_shaft[next]) next++;
        if (next > 0) axis -= largest_radius(l, next - 1) + largest_radius(l, next) + 9.0 * l->symbol;
        l->axis[next] = axis;
        l->placed_shaft[next] = true;
        left--;
    }
}

/// The radius of a steel disc of a station's mass and polar inertia; of a mass without one that of a cube.
static double disc_radius(const whirl_model_mass *of) {
    if (!(of->mass > 0.0)) return 0.0;
    return of->polar > 0.0 ? sqrt(2.0 * of->polar / of->mass) : 0.5 * cbrt(of->mass / steel);
}

static double disc_width(const whirl_model_mass *of) {
    const double r = disc_radius(of);
    return of->polar > 0.0 ? of->mass / (steel * pi * r * r) : 2.0 * r;
}

/// The radius of a station's disc, or of its shaft where that is larger.
static double rim_radius(const layout *l, size_t station) {
    const whirl_model_mass *own = &l->model.stations[station];
    return own->shaft < l->model.shaft_count ? fmax(disc_radius(own), l->radius[station]) : l->radius[station];
}

/// A station that lies on no shaft stands below what an element joins it to.
static bool hang_station(layout *l, size_t station) {
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        for (int end = 0; end < 2; end++) {
            const size_t other = e->station[1 - end];
            if (e->station[end] != station || !is_station(l, other) || !l->placed[other]) continue;
            l->x[station] = l->x[other];
            l->y[station] = l->y[other] - l->radius[other] - 3.2 * l->symbol;
            return l->placed[station] = true;
        }
    }
    return false;
}

/// Whether a station is the housing or the support of another one: the second end of a bearing, stator or support.
static bool is_housing(const layout *l, size_t station) {
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        if (e->station[1] == station && e->station[0] != WHIRL_MODEL_NONE && e->role != WHIRL_ROLE_LINK) return true;
    }
    return false;
}

static void place_stations(layout *l) {
    const size_t count = l->model.station_count < WHIRL_MAX_PROBES ? l->model.station_count : WHIRL_MAX_PROBES;
    double beside = l->to_scale ? l->along.high + 4.0 * l->symbol : 0.0;
    for (size_t s = 0; s < count; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        if (own->shaft >= l->model.shaft_count) continue;
        l->x[s] = l->offset[own->shaft] + own->position;
        l->y[s] = l->axis[own->shaft];
        l->placed[s] = true;
    }
    for (size_t s = 0; s < count && !l->to_scale; s++) {
        if (is_housing(l, s)) continue;
        l->x[s] = beside;
        beside += 1.0;
        l->placed[s] = true;
    }
    for (bool any = true; any;) {
        any = false;
        for (size_t s = 0; s < count; s++)
            if (!l->placed[s] && hang_station(l, s)) any = true;
    }
    for (size_t s = 0; s < count; s++) {
        if (l->placed[s]) continue;
        l->x[s] = beside;
        beside += l->to_scale ? 4.0 * l->symbol : 1.0;
        l->placed[s] = true;
    }
}

/// Sizes of symbols, and of stations: those of a machine that is not to scale by the cube root of their masses.
static void size_stations(layout *l) {
    double length = 0.0, thick = 0.0, heaviest = 0.0;
    for (size_t i = 0; i < l->model.section_count; i++) {
        length = fmax(length, l->model.sections[i].to);
        thick = fmax(thick, fmax(l->model.sections[i].outer[0], l->model.sections[i].outer[1]));
    }
    for (size_t s = 0; s < l->model.station_count; s++) heaviest = fmax(heaviest, l->model.stations[s].mass);
    l->symbol = l->to_scale ? fmax(0.018 * length, 0.12 * thick) : 0.1;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        const double shaft = own->shaft < l->model.shaft_count ? shaft_radius(l, own->shaft, own->position) : 0.0;
        l->radius[s] = !l->to_scale  ? 0.06 + (heaviest > 0.0 ? 0.16 * cbrt(own->mass / heaviest) : 0.0)
                       : shaft > 0.0 ? shaft
                                     : l->symbol;
    }
}

static void measure(layout *l) {
    l->along = span_empty();
    for (size_t i = 0; i < l->model.section_count; i++) {
        span_widen(&l->along, l->offset[l->model.sections[i].shaft] + l->model.sections[i].from);
        span_widen(&l->along, l->offset[l->model.sections[i].shaft] + l->model.sections[i].to);
    }
}

// ---------------------------------------------------------------- drawing

/// A drawing under way: the figure, its panel, and how large a metre is in the unit shown.
typedef struct pen {
    whirl_figure *figure;
    whirl_panel *panel;
    layout *l;
    double unit;
} pen;

static void reach(layout *l, double x, double low, double high) {
    span_widen(&l->along, x);
    l->top = fmax(l->top, high);
    l->bottom = fmin(l->bottom, low);
}

static void pen_box(const pen *p, whirl_series *to, double x, double half, double low, double high) {
    series_add_box(p->figure, to, (span){(x - half) / p->unit, (x + half) / p->unit},
                   (span){low / p->unit, high / p->unit});
    reach(p->l, x - half, low, high);
    reach(p->l, x + half, low, high);
}

static void pen_point(const pen *p, whirl_series *to, double x, double y) {
    series_add(p->figure, to, x / p->unit, y / p->unit);
    reach(p->l, x, y, y);
}

static void pen_line(const pen *p, whirl_series *to, double x, double y, double x_to, double y_to) {
    pen_point(p, to, x, y);
    pen_point(p, to, x_to, y_to);
    series_break(p->figure, to);
}

/// One wall of a section, between radii of its ends, above (side 1) or below the axis.
static void pen_wall(const pen *p, whirl_series *area, whirl_series *edge, const whirl_model_section *s, int side) {
    const layout *l = p->l;
    const double axis = l->axis[s->shaft], from = l->offset[s->shaft] + s->from, to = l->offset[s->shaft] + s->to;
    double inner[2], outer[2];
    for (int end = 0; end < 2; end++) {
        inner[end] = axis + side * 0.5 * s->inner[end];
        outer[end] = axis + side * 0.5 * s->outer[end];
    }
    series_add_to(p->figure, area, from / p->unit, inner[0] / p->unit, outer[0] / p->unit);
    series_add_to(p->figure, area, to / p->unit, inner[1] / p->unit, outer[1] / p->unit);
    series_break(p->figure, area);
    pen_point(p, edge, from, inner[0]);
    pen_point(p, edge, from, outer[0]);
    pen_point(p, edge, to, outer[1]);
    pen_point(p, edge, to, inner[1]);
    if (s->inner[0] > 0.0 || s->inner[1] > 0.0) pen_point(p, edge, from, inner[0]);
    series_break(p->figure, edge);
}

static void draw_shafts(const pen *p) {
    const layout *l = p->l;
    whirl_series *axis = panel_series(p->figure, p->panel, WHIRL_LINE, "#909090", 0.4);
    whirl_series *area = panel_named(p->figure, p->panel, WHIRL_AREA, "shaft", "#B9C6D2", 1.0);
    whirl_series *edge = panel_series(p->figure, p->panel, WHIRL_LINE, "#303030", 0.5);
    if (axis) axis->dashed = true;
    for (size_t i = 0; i < l->model.section_count; i++)
        for (int side = 1; side >= -1; side -= 2) pen_wall(p, area, edge, &l->model.sections[i], side);
    for (size_t s = 0; s < l->model.shaft_count; s++) {
        span ends = span_empty();
        for (size_t i = 0; i < l->model.section_count; i++) {
            if (l->model.sections[i].shaft != s) continue;
            span_widen(&ends, l->model.sections[i].from);
            span_widen(&ends, l->model.sections[i].to);
        }
        if (span_has_any(ends))
            pen_line(p, axis, l->offset[s] + ends.low - l->symbol, l->axis[s], l->offset[s] + ends.high + l->symbol,
                     l->axis[s]);
    }
}

/// Discs and masses, with a hole for the shaft that they sit on.
static void draw_masses(const pen *p) {
    layout *l = p->l;
    whirl_series *discs = NULL;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        const bool on_shaft = own->shaft < l->model.shaft_count;
        if (!(own->mass > 0.0)) continue;
        if (!discs)
            discs = panel_named(p->figure, p->panel, WHIRL_BOXES, l->to_scale ? "discs and masses" : "masses",
                                "#7D93A8", 0.4);
        if (on_shaft) {
            const double radius = fmax(disc_radius(own), l->radius[s] + 0.3 * l->symbol);
            const double half = fmax(0.5 * disc_width(own), 0.12 * l->symbol);
            pen_box(p, discs, l->x[s], half, l->y[s] + l->radius[s], l->y[s] + radius);
            pen_box(p, discs, l->x[s], half, l->y[s] - radius, l->y[s] - l->radius[s]);
        } else {
            pen_box(p, discs, l->x[s], l->radius[s], l->y[s] - l->radius[s], l->y[s] + l->radius[s]);
        }
    }
}

/// The ground below a place: a line with hatches.
static void draw_ground(const pen *p, whirl_series *to, double x, double y) {
    const double u = p->l->symbol;
    pen_line(p, to, x - 0.8 * u, y, x + 0.8 * u, y);
    for (int k = -1; k <= 1; k++) pen_line(p, to, x + 0.5 * k * u + 0.2 * u, y, x + 0.5 * k * u - 0.2 * u, y - 0.4 * u);
}

/// A bearing, seal, stator or support: blocks above and below its station, and what carries it.
typedef struct symbol {
    whirl_model_role role;
    const char *name, *colour;
    double half, from, to; ///< width, and where it begins and ends outside the station, in sizes of symbols
} symbol;

static const symbol symbols[] = {
    {WHIRL_ROLE_BEARING, "bearings", "#0072B2", 0.7, 0.0, 0.8},
    {WHIRL_ROLE_DRAG, "seals and stages", "#009E73", 0.45, 0.1, 0.5},
    {WHIRL_ROLE_STATOR, "stators", "#D55E00", 0.9, 0.55, 0.75},
};

static void draw_symbol(const pen *p, const symbol *what) {
    layout *l = p->l;
    whirl_series *blocks = NULL, *ground = NULL;
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        if (e->role != what->role || !is_station(l, e->station[0])) continue;
        const double x = l->x[e->station[0]], y = l->y[e->station[0]], u = l->symbol;
        // A stator is around the disc, all else around the shaft.
        const double r = what->role == WHIRL_ROLE_STATOR ? rim_radius(l, e->station[0]) : l->radius[e->station[0]];
        if (!blocks) {
            blocks = panel_named(p->figure, p->panel, WHIRL_BOXES, what->name, what->colour, 0.4);
            ground = panel_series(p->figure, p->panel, WHIRL_LINE, "#404040", 0.5);
        }
        pen_box(p, blocks, x, what->half * u, y + r + what->from * u, y + r + what->to * u);
        pen_box(p, blocks, x, what->half * u, y - r - what->to * u, y - r - what->from * u);
        if (is_station(l, e->station[1]))
            pen_line(p, ground, x, y - r - what->to * u, l->x[e->station[1]], l->y[e->station[1]]);
        else if (what->role == WHIRL_ROLE_BEARING)
            draw_ground(p, ground, x, y - r - what->to * u);
    }
}

/// A zigzag from one height down to another.
static void draw_spring(const pen *p, whirl_series *to, double x, double high, double low) {
    enum { BENDS = 6 };
    pen_point(p, to, x, high);
    for (int k = 1; k <= BENDS; k++)
        pen_point(p, to, x + (k % 2 ? 0.3 : -0.3) * p->l->symbol, high + (low - high) * k / (BENDS + 1.0));
    pen_point(p, to, x, low);
    series_break(p->figure, to);
}

static void draw_supports(const pen *p) {
    layout *l = p->l;
    whirl_series *springs = NULL;
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        const size_t station = is_station(l, e->station[0]) ? e->station[0] : e->station[1];
        if (e->role != WHIRL_ROLE_SUPPORT || !is_station(l, station)) continue;
        const double x = l->x[station], y = l->y[station] - l->radius[station], u = l->symbol;
        if (!springs) springs = panel_named(p->figure, p->panel, WHIRL_LINE, "supports", "#404040", 0.7);
        draw_spring(p, springs, x, y, y - 1.6 * u);
        draw_ground(p, springs, x, y - 1.6 * u);
    }
}

/// Elements between two stations: a bar between places along the axis, a spring between places below one another.
static void draw_links(const pen *p) {
    layout *l = p->l;
    whirl_series *bars = NULL;
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        if (e->role != WHIRL_ROLE_LINK || !is_station(l, e->station[0]) || !is_station(l, e->station[1])) continue;
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

/// Whether a table names the station among those with probes.
static bool has_probe(const whirl_result *result, size_t station) {
    for (size_t t = 0; t < result->table_count; t++)
        if (*result->tables[t].record.probes_at && margin_probed(result, &result->tables[t], station)) return true;
    return false;
}

/// Marks above stations: planes of unbalance, and probes.
static void draw_marks(const pen *p) {
    layout *l = p->l;
    whirl_series *planes = NULL, *seen = NULL;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        const double radius =
            own->shaft < l->model.shaft_count && own->mass > 0.0 ? fmax(disc_radius(own), l->radius[s]) : l->radius[s];
        if (own->unbalanced) {
            if (!planes) planes = panel_named(p->figure, p->panel, WHIRL_DOTS, "unbalance", "#CC79A7", 3.4);
            if (planes) planes->mark = WHIRL_DISC;
            pen_point(p, planes, l->x[s], l->y[s] + radius + 1.2 * l->symbol);
        }
        if (has_probe(l->result, s)) {
            if (!seen) seen = panel_named(p->figure, p->panel, WHIRL_DOTS, "probes", "#E69F00", 3.8);
            if (seen) seen->mark = WHIRL_DOWN;
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

/// Moves labels apart to at least `step`, as little as that takes: neighbours that are too close form a group, which is
/// centred upon their places.
static void spread_labels(label *labels, size_t count, double step) {
    size_t sizes[WHIRL_MAX_PROBES], groups = 0;
    double middles[WHIRL_MAX_PROBES]; // where a group's first label would stand, were all of them at one place
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

/// Names of the stations of one axis above all that is drawn there, apart from each other, with strokes to their
/// places; `step` is the least distance, `high` the top of the axis' parts.
static void name_axis(const pen *p, double axis, double high, double step) {
    layout *l = p->l;
    label labels[WHIRL_MAX_PROBES];
    size_t count = 0;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++)
        if (l->y[s] == axis) labels[count++] = (label){s, l->x[s]};
    if (count == 0) return;
    qsort(labels, count, sizeof *labels, by_place);
    spread_labels(labels, count, step);
    whirl_series *names = panel_series(p->figure, p->panel, WHIRL_TEXTS, "#303030", 1.0);
    whirl_series *strokes = panel_series(p->figure, p->panel, WHIRL_LINE, "#A0A0A0", 0.35);
    if (names) names->side = WHIRL_SLANTED;
    for (size_t i = 0; i < count; i++) {
        const size_t s = labels[i].station;
        pen_line(p, strokes, l->x[s], l->y[s] + l->radius[s], labels[i].x, high);
        series_add_text(p->figure, names, labels[i].x / p->unit, high / p->unit, l->result->stations[s].name);
    }
}

/// Names at stations of housings, which lie below the others.
static void name_housings(const pen *p) {
    layout *l = p->l;
    const double cm = (l->along.high - l->along.low) / (p->figure->width - 1.2);
    whirl_series *names = panel_series(p->figure, p->panel, WHIRL_TEXTS, "#303030", 1.0);
    if (names) names->side = WHIRL_BESIDE;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        bool on_axis = !l->to_scale && l->y[s] == 0.0;
        for (size_t k = 0; k < l->model.shaft_count; k++) on_axis = on_axis || l->y[s] == l->axis[k];
        if (on_axis) continue;
        const char *name = l->result->stations[s].name;
        const double beside = l->x[s] + l->radius[s];
        series_add_text(p->figure, names, beside / p->unit, l->y[s] / p->unit, name);
        span_widen(&l->along, beside + (figure_text_width(p->figure, strlen(name)) + 0.2) * cm);
    }
}

static size_t longest_name(const whirl_result *result) {
    size_t longest = 0;
    for (size_t s = 0; s < result->station_count; s++)
        longest = strlen(result->stations[s].name) > longest ? strlen(result->stations[s].name) : longest;
    return longest;
}

// ---------------------------------------------------------------- the figure

static void list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &rotor_figure, .table = table, .point = NO_POINT};
    if (of->machine && of->result->station_count > 0) list_figure(to, &place, "rotor", "The machine");
}

/// The range of the panel, of one scale both ways, and its height in cm.
static void fit_panel(const pen *p) {
    const layout *l = p->l;
    const double across = p->figure->width - 1.2, margin = 0.03 * (l->along.high - l->along.low);
    const double width = l->along.high - l->along.low + 2.0 * margin;
    const double names = 0.87 * figure_text_width(p->figure, longest_name(l->result)) + 0.25;
    const double cm = width / across; // m a cm
    const double low = l->bottom - margin, high = l->top + names * cm;
    p->panel->height = fmin(fmax((high - low) / cm, 2.5), 14.0);
    axis_show(&p->panel->x, (span){(l->along.low - margin) / p->unit, (l->along.high + margin) / p->unit});
    axis_show(&p->panel->y, (span){low / p->unit, high / p->unit});
    p->panel->equal = true;
    p->panel->y.shown = false;
    p->panel->x.shown = l->to_scale;
}

static void draw(const pen *p) {
    layout *l = p->l;
    if (l->to_scale) draw_shafts(p);
    draw_links(p);
    draw_masses(p);
    for (size_t i = 0; i < sizeof symbols / sizeof *symbols; i++) draw_symbol(p, &symbols[i]);
    draw_supports(p);
    draw_marks(p);
    // Names of every axis stand above its own parts.
    const double step = 0.42 * (l->along.high - l->along.low) / (p->figure->width - 1.2);
    double done = HUGE_VAL;
    for (size_t s = 0; s < (l->to_scale ? l->model.shaft_count : 1); s++) {
        const double axis = l->to_scale ? l->axis[s] : 0.0;
        double high = axis;
        if (axis >= done) continue;
        for (size_t k = 0; k < l->model.station_count && k < WHIRL_MAX_PROBES; k++)
            if (l->y[k] == axis) high = fmax(high, axis + rim_radius(l, k));
        for (size_t k = 0; k < l->model.shaft_count; k++)
            if (l->axis[k] == axis) high = fmax(high, axis + largest_radius(l, k));
        name_axis(p, axis, high + 2.9 * l->symbol, step);
        done = axis;
    }
    name_housings(p);
}

static void describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    (void)place;
    layout *l = calloc(1, sizeof *l);
    whirl_panel *panel = figure_panel(figure, "machine", 1.0, 4.0);
    figure->failed = figure->failed || !l;
    if (!l || !panel) {
        free(l);
        return;
    }
    l->result = of->result;
    const bool made = whirl_case_model(of->machine, &l->model).code == WHIRL_OK;
    l->to_scale = l->model.section_count > 0;
    const bool inches = strcmp(of->units->length_name, "mil") == 0 || strcmp(of->units->length_name, "in") == 0;
    const pen p = {figure, panel, l, l->to_scale ? (inches ? 0.0254 : 1e-3) : 1.0};
    figure->font = 6.5;
    figure->width = 16.0;
    if (made) {
        size_stations(l);
        place_shafts(l);
        measure(l);
        place_stations(l);
        draw(&p);
        fit_panel(&p);
    }
    snprintf(panel->x.label, sizeof panel->x.label, inches ? "$z$ (in)" : "$z$ (mm)");
    snprintf(figure->caption, sizeof figure->caption, "%s%s",
             l->to_scale
                 ? "The machine: shafts of finite elements to scale, along and across; discs and masses as discs of "
                   "steel of the same mass and polar inertia; symbols of what acts on stations, not to scale."
                 : "The machine: stations in their order, as large as the cube root of their masses; lines and springs "
                   "join them. It has no shaft of finite elements, so nothing is to scale.",
             weight_stands(of->result) ? " The machine stands and is drawn lying." : "");
    whirl_model_free(&l->model);
    free(l);
}

const figure_kind rotor_figure = {.list = list, .describe = describe, .whole = true};
