// Panels over the places along a machine: their axis, the machine in grey behind, and shapes.
#include <math.h>
#include <stdio.h>

#include "figure_kinds.h"
#include "machine_along.h"
#include "machine_layout.h"
#include "shaft_bends.h"

/// Returns the range of positions covered by the shafts on one axis.
static span axis_reach(const machine_layout *l, double axis) {
    span reach = span_empty();
    for (size_t s = 0; s < l->model.shaft_count; s++) {
        if (l->axis[s] != axis) continue;
        const span ends = layout_shaft_ends(l, s);
        span_widen(&reach, ends.low);
        span_widen(&reach, ends.high);
    }
    return reach;
}

/// Places the shafts. Shafts on one axis keep their relative places; the next axis begins after them.
static span along_place_shafts(const machine_layout *l, machine_along *out) {
    span places = span_empty();
    bool placed[WHIRL_MAX_SHAFTS] = {false};
    for (size_t s = 0; s < l->model.shaft_count; s++) {
        if (placed[s]) continue;
        const span own = axis_reach(l, l->axis[s]);
        if (!span_has_any(own)) continue;
        const double begin =
            span_has_any(places) ? places.high + 0.12 * (places.high - places.low) - own.low / out->unit : 0.0;
        for (size_t k = s; k < l->model.shaft_count; k++) {
            if (l->axis[k] != l->axis[s]) continue;
            out->start[k] = begin + l->offset[k] / out->unit;
            placed[k] = true;
        }
        span_widen(&places, begin + own.low / out->unit);
        span_widen(&places, begin + own.high / out->unit);
    }
    return places;
}

void along_place(const drawing *of, machine_along *out) {
    // Without known shafts the places of stations are 1, 2, ...
    const whirl_result *result = of->result;
    span places = span_empty();
    *out = (machine_along){.unit = layout_unit(of->units), .range = {0.5, (double)result->station_count + 0.5}};
    out->layout = layout_new(of);
    // Find how far shafts and stations on them reach.
    if (out->layout && out->layout->to_scale) places = along_place_shafts(out->layout, out);
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        out->at[s] = (double)s + 1.0;
        if (station->shaft > 0) span_widen(&places, out->start[station->shaft - 1] + station->position / out->unit);
    }
    // Place stations on shafts by their position, all others one after another behind the last shaft.
    if (!span_has_any(places)) return;
    const double step = places.high > places.low ? 0.16 * (places.high - places.low) : 1.0;
    out->shafts = true;
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        out->at[s] = station->shaft > 0 ? out->start[station->shaft - 1] + station->position / out->unit
                                        : places.high + step * (double)++out->aside;
    }
    out->step = step;
    out->end = places.high + 0.5 * step;
    out->range = (span){places.low - 0.3 * step, places.high + step * ((double)out->aside + 0.3)};
}

/// Adds ticks over the shafts on one axis, which count from the beginning of its first shaft.
static void add_ticks(whirl_figure *figure, whirl_panel *panel, span own, double start, double step) {
    char text[32];
    const double first = ceil((own.low - start) / step - 1e-9);
    for (int k = 0; k < 12 && start + step * (first + k) <= own.high + 1e-9 * step; k++) {
        snprintf(text, sizeof text, "%g", step * (first + k) + 0.0);
        axis_tick(figure, &panel->x, start + step * (first + k), text);
    }
}

static void add_shaft_ticks(whirl_figure *figure, whirl_panel *panel, const machine_along *along) {
    const machine_layout *l = along->layout;
    const double high = along->aside > 0 ? along->end : along->range.high;
    const bool several = l && l->to_scale && l->axis[0] != l->axis[l->model.shaft_count - 1];
    const double step = tick_step(high - along->range.low, several ? 7 : 4);
    if (!l || !l->to_scale) {
        add_ticks(figure, panel, (span){along->range.low, high}, 0.0, step);
        return;
    }
    for (size_t s = 0; s < l->model.shaft_count; s++) {
        bool first = true;
        for (size_t k = 0; k < s; k++) first = first && l->axis[k] != l->axis[s];
        const span own = axis_reach(l, l->axis[s]);
        const double shift = along->start[s] - l->offset[s] / along->unit;
        if (first && span_has_any(own))
            add_ticks(figure, panel, (span){own.low / along->unit + shift, own.high / along->unit + shift},
                      along->start[s], step);
    }
}

void along_axis(whirl_figure *figure, whirl_panel *panel, const drawing *of, const machine_along *along) {
    const whirl_result *result = of->result;
    const size_t stations = result->station_count;
    axis_show(&panel->x, along->range);
    if (along->shafts) {
        add_shaft_ticks(figure, panel, along);
        snprintf(panel->x.label, sizeof panel->x.label, "%s", layout_label(of->units));
    }
    whirl_series *names = panel_series(figure, panel, WHIRL_TEXTS, "#606060", 1.0);
    if (names) names->side = WHIRL_SLANTED;
    for (size_t s = 0; s < stations; s++) {
        if (!along->shafts && (stations <= 8 || s == 0 || s + 1 == stations))
            axis_tick(figure, &panel->x, (double)s + 1.0, result->stations[s].name);
        if (along->shafts && result->stations[s].shaft == 0)
            series_add_text(figure, names, along->at[s] - 0.45 * along->step,
                            panel->y.low + 0.05 * (panel->y.high - panel->y.low), result->stations[s].name);
    }
    if (along->aside > 0) panel_upright(figure, panel, along->end, "#909090", 0.4);
}

// ---------------------------------------------------------------- the machine in grey

/// Returns the vertical size of a metre in units of the vertical axis: the same scale as along the axis if that fits.
static double across_scale(const whirl_figure *figure, const whirl_panel *panel, const machine_along *along,
                           double high) {
    const machine_layout *l = along->layout;
    const double numbers = 1.6; // width of numbers next to a panel in cm, approximately
    const double wide = fmax(figure->width * panel->width - numbers, 1.0);
    const double scale = 2.0 * high / panel->height * wide / ((along->range.high - along->range.low) * along->unit);
    double radius = 0.0;
    for (size_t s = 0; s < l->model.shaft_count; s++) radius = fmax(radius, layout_largest_radius(l, s));
    return radius > 0.0 ? fmin(scale, 0.95 * high / radius) : scale;
}

static void add_wall(whirl_figure *figure, whirl_series *area, const machine_along *along, const whirl_model_section *s,
                     double scale) {
    const double at[] = {along->start[s->shaft] + s->from / along->unit, along->start[s->shaft] + s->to / along->unit};
    for (int side = 1; side >= -1; side -= 2) {
        for (int end = 0; end < 2; end++)
            series_add_to(figure, area, at[end], 0.5 * side * scale * s->inner[end],
                          0.5 * side * scale * s->outer[end]);
        series_break(figure, area);
    }
}

/// Adds a box above and one below the axis; `inner` and `outer` in m.
static void add_pair(whirl_figure *figure, whirl_series *boxes, span x, double inner, double outer, double scale) {
    series_add_box(figure, boxes, x, (span){scale * inner, scale * outer});
    series_add_box(figure, boxes, x, (span){-scale * outer, -scale * inner});
}

void along_machine(whirl_figure *figure, whirl_panel *panel, const machine_along *along, double high) {
    const machine_layout *l = along->layout;
    if (!l || !l->to_scale) return;
    // Set up the series: shafts, discs, bearings.
    const double scale = across_scale(figure, panel, along, high);
    whirl_series *shafts = panel_series(figure, panel, WHIRL_AREA, "#E2E6EA", 1.0);
    whirl_series *discs = panel_series(figure, panel, WHIRL_BOXES, "#CDD4DB", 1.0);
    whirl_series *bearings = panel_series(figure, panel, WHIRL_BOXES, "#A9B4BF", 1.0);
    // Draw sections of shafts.
    for (size_t i = 0; i < l->model.section_count; i++) add_wall(figure, shafts, along, &l->model.sections[i], scale);
    // Draw the discs of stations with mass.
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        if (own->shaft >= l->model.shaft_count || !(own->mass > 0.0)) continue;
        const layout_disc disc = layout_disc_of(l, s);
        const double half = disc.half / along->unit;
        add_pair(figure, discs, (span){along->at[s] - half, along->at[s] + half}, l->radius[s], disc.radius, scale);
    }
    // Draw the bearings of stations on shafts.
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        const double half = 0.7 * l->symbol / along->unit;
        if (e->role != WHIRL_ROLE_BEARING || !layout_has_station(l, e->station[0])) continue;
        const size_t s = e->station[0];
        if (l->model.stations[s].shaft >= l->model.shaft_count) continue;
        add_pair(figure, bearings, (span){along->at[s] - half, along->at[s] + half}, l->radius[s],
                 l->radius[s] + 0.8 * l->symbol, scale);
    }
}

const char *along_caption(const machine_along *along) {
    return along->layout && along->layout->to_scale ? " Grey: the machine, along its shafts to scale." : "";
}

// ---------------------------------------------------------------- shapes

/// Returns the next station along a shaft; station_count if there is none.
static size_t next_on_shaft(const whirl_result *result, size_t shaft, double after) {
    size_t next = result->station_count;
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        if (station->shaft != shaft || !(station->position > after)) continue;
        if (next == result->station_count || station->position < result->stations[next].position) next = s;
    }
    return next;
}

/// Adds lines from station to station of every shaft; without shafts, from each station to the next.
static void add_polygons(whirl_figure *figure, whirl_series *line, const drawing *of, const machine_along *along,
                         const double *values) {
    const whirl_result *result = of->result;
    for (size_t shaft = 1; shaft <= WHIRL_MAX_SHAFTS && along->shafts; shaft++) {
        size_t s = next_on_shaft(result, shaft, -(double)INFINITY);
        for (; s < result->station_count; s = next_on_shaft(result, shaft, result->stations[s].position))
            if (isfinite(values[s])) series_add(figure, line, along->at[s], values[s]);
        series_break(figure, line);
    }
    for (size_t s = 0; s < result->station_count && !along->shafts; s++)
        if (isfinite(values[s])) series_add(figure, line, along->at[s], values[s]);
}

void along_shape(whirl_figure *figure, whirl_panel *panel, const along_curve *of, const double *values) {
    const char *colour = line_colour(of->column / 2);
    whirl_series *line = panel_series(figure, panel, WHIRL_LINE, colour, 0.6);
    whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, colour, 1.35);
    if (line) line->dashed = of->column % 2;
    if (dots) dots->mark = of->column % 2 ? WHIRL_RING : WHIRL_DISC;
    if (of->bends)
        bends_draw(figure, line, of->bends, of->along, of->moved, of->columns, of->column);
    else
        add_polygons(figure, line, of->of, of->along, values);
    for (size_t s = 0; s < of->of->result->station_count; s++)
        if (isfinite(values[s])) series_add(figure, dots, of->along->at[s], values[s]);
}
