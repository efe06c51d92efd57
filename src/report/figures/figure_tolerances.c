// Figures of spreads over samples: bands of quantiles over the parameter, or a histogram; probabilities; and the part
// of the variance that each parameter causes, as a tornado diagram.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "number_name.h"

enum { CLASSES = 40 };

static const char dark[] = "#0072B2", outer_colour[] = "#CFE3F1", inner_colour[] = "#9CC7E3",
                  limit_colour[] = "#D55E00";

/// A number whose spread is drawn, and its table.
typedef struct spread_view {
    const drawing *of;
    const whirl_table *table;
    whirl_spread_of number;
    whirl_unit unit;
    double period; ///< period of the number if it is an angle; else 0
    size_t places;
    double value; ///< size of the unit of the parameter
} spread_view;

static void tolerances_list(figure_list *to, const drawing *of, const whirl_table *table) {
    figure_place place = {.kind = &tolerances_figure, .table = table, .point = NO_POINT};
    whirl_spread_of number;
    for (; whirl_table_asked(of->result, table, place.which, &number); place.which++) {
        char name[NUMBER_NAME_SIZE], file[NUMBER_NAME_SIZE];
        number_name(table, &number, name);
        snprintf(file, sizeof file, "%.60s-%.100s", table->name, name);
        list_figure(to, &place, file, "Spread of %.100s", name);
    }
}

/// Returns the statistics at a place. A failure marks the figure as failed, and leaves the statistics empty.
static whirl_spread spread_at(const spread_view *v, whirl_figure *figure, size_t place) {
    whirl_spread spread = {.samples = 0};
    const whirl_status status = whirl_table_spread(v->of->result, v->table, &v->number, place, 0, &spread);
    figure->failed = figure->failed || status.code != WHIRL_OK;
    return spread;
}

static bool spread_is_limited(const spread_view *v) {
    return isfinite(v->number.above) || isfinite(v->number.below);
}

/// Returns the number of the case's own machine at a place; NaN if the study has none.
static double spread_nominal(const spread_view *v, size_t place) {
    const whirl_result *result = v->of->result;
    for (size_t t = 0; t < result->table_count; t++) {
        const whirl_table *own = &result->tables[t];
        const whirl_field *field = whirl_layout_field(&own->layout, v->number.field);
        char name[2 * WHIRL_NAME_SIZE];
        snprintf(name, sizeof name, "tolerances_%s", own->name);
        const bool belongs = strcmp(v->table->name, name) == 0 || strcmp(v->table->name, "tolerances") == 0;
        if (!belongs || own->tolerances.samples > 0 || !field || place >= own->count || own->role == WHIRL_ROLE_DETAIL)
            continue;
        whirl_spread_at found;
        if (!whirl_spread_place(result, own, &v->number, &found) || !whirl_table_done(own, place)) continue;
        return whirl_spread_number(result, own, place, &found) / v->unit.size;
    }
    return (double)NAN;
}

/// Returns a number moved by whole periods next to another one, if it is an angle.
static double spread_near(const spread_view *v, double number, double other) {
    if (!(v->period > 0.0) || !isfinite(number) || !isfinite(other)) return number;
    return number + v->period * rint((other - number) / v->period);
}

static void spread_axis(const spread_view *v, whirl_axis *axis) {
    char name[NUMBER_NAME_SIZE];
    number_name(v->table, &v->number, name);
    snprintf(axis->label, sizeof axis->label, *v->unit.name ? "%.180s (%s)" : "%.180s", name, v->unit.name);
}

// ---------------------------------------------------------------- bands

static void add_bands(whirl_figure *figure, const spread_view *v) {
    // Set up the panel and its series.
    whirl_panel *panel = figure_panel(figure, "bands", 1.0, 6.0);
    if (!panel) return;
    symbol_parameter(v->of->units, v->table->parameter, panel->x.label, sizeof panel->x.label);
    spread_axis(v, &panel->y);
    whirl_series *outer = panel_named(figure, panel, WHIRL_AREA, "5 to 95 %", outer_colour, 1.0);
    whirl_series *inner = panel_named(figure, panel, WHIRL_AREA, "25 to 75 %", inner_colour, 1.0);
    whirl_series *median = panel_named(figure, panel, WHIRL_LINE, "median", dark, 0.8);
    whirl_series *own = panel_named(figure, panel, WHIRL_LINE, "case's own machine", "#303030", 0.6);
    if (own) own->dashed = true;
    // Add the quantiles at each value of the parameter.
    span shown = span_empty();
    double before = NAN; // the previous median; an angle is unwrapped to within half a period of it
    for (size_t place = 0; place < v->places; place++) {
        const whirl_spread s = spread_at(v, figure, place);
        const double x = v->table->values[place] / v->value, middle = s.quantiles[2].value;
        const double shift = spread_near(v, middle, before) - middle;
        double q[WHIRL_QUANTILES];
        for (size_t i = 0; i < WHIRL_QUANTILES; i++)
            q[i] = (s.quantiles[i].value + (isfinite(shift) ? shift : 0.0)) / v->unit.size;
        if (isfinite(middle)) before = q[2] * v->unit.size;
        const double nominal = spread_near(v, spread_nominal(v, place), before);
        series_add_to(figure, outer, x, q[0], q[4]);
        series_add_to(figure, inner, x, q[1], q[3]);
        series_add(figure, median, x, q[2]);
        series_add(figure, own, x, nominal);
        span_widen(&shown, q[0]);
        span_widen(&shown, q[4]);
        span_widen(&shown, nominal);
    }
    // Widen the axis to the limits, and draw them.
    const double limits[] = {v->number.above, v->number.below};
    for (int i = 0; i < 2; i++) span_widen(&shown, limits[i] / v->unit.size);
    if (!span_has_any(shown)) return;
    axis_show(&panel->y, span_with_margin(shown, 0.05, 0.0));
    axis_show(&panel->x, (span){fmin(v->table->values[0], v->table->values[v->places - 1]) / v->value,
                                fmax(v->table->values[0], v->table->values[v->places - 1]) / v->value});
    for (int i = 0; i < 2; i++)
        if (isfinite(limits[i])) panel_level(figure, panel, limits[i] / v->unit.size, limit_colour, 0.6);
}

static void add_probability(whirl_figure *figure, const spread_view *v) {
    whirl_panel *panel = figure_panel(figure, "probability", 1.0, 3.0);
    if (!panel) return;
    symbol_parameter(v->of->units, v->table->parameter, panel->x.label, sizeof panel->x.label);
    snprintf(panel->y.label, sizeof panel->y.label, "beyond the limit (%%)");
    whirl_series *interval = panel_named(figure, panel, WHIRL_AREA, "95 % interval", "#F3D3BC", 1.0);
    whirl_series *line = panel_named(figure, panel, WHIRL_LINE, "probability", limit_colour, 0.8);
    for (size_t place = 0; place < v->places; place++) {
        const whirl_spread s = spread_at(v, figure, place);
        const double x = v->table->values[place] / v->value;
        series_add_to(figure, interval, x, 100.0 * s.beyond.from, 100.0 * s.beyond.to);
        series_add(figure, line, x, 100.0 * s.beyond.of.value);
    }
    axis_show(&panel->x, (span){fmin(v->table->values[0], v->table->values[v->places - 1]) / v->value,
                                fmax(v->table->values[0], v->table->values[v->places - 1]) / v->value});
}

// ---------------------------------------------------------------- histogram

static void add_histogram(whirl_figure *figure, const spread_view *v) {
    // Find the samples and their range.
    whirl_panel *panel = figure_panel(figure, "histogram", 1.0, 6.0);
    const whirl_spread s = spread_at(v, figure, 0);
    double counts[CLASSES] = {0.0}, all = 0.0, most = 0.0;
    if (!panel || !(s.most > s.least)) return;
    // Set up the panel.
    spread_axis(v, &panel->x);
    snprintf(panel->y.label, sizeof panel->y.label, "samples (%%)");
    // Count the samples of each class; machines that serve only sensitivity indices do not count.
    whirl_spread_at at;
    if (!whirl_spread_place(v->of->result, v->table, &v->number, &at)) return;
    for (size_t point = 0; point < v->table->count; point++) {
        const double machine = whirl_table_number(v->table, point, WHIRL_FIELD_TOLERANCES_MACHINE, 0);
        double x = whirl_spread_number(v->of->result, v->table, point, &at);
        if (!whirl_table_done(v->table, point) || machine > 1.0 || !isfinite(x)) continue;
        if (v->period > 0.0) x += v->period * ceil((s.least - x) / v->period - 1e-9);
        const double share = (x - s.least) / (s.most - s.least) * CLASSES;
        counts[share >= CLASSES ? CLASSES - 1 : share > 0.0 ? (size_t)share : 0] += 1.0;
        all += 1.0;
    }
    // Draw the classes.
    whirl_series *boxes = panel_series(figure, panel, WHIRL_BOXES, inner_colour, 1.0);
    const double low = s.least / v->unit.size, step = (s.most - s.least) / v->unit.size / CLASSES;
    for (size_t i = 0; i < CLASSES; i++) {
        const double height = 100.0 * counts[i] / all, left = low + (double)i * step;
        most = fmax(most, height);
        series_add_box(figure, boxes, (span){left, left + step}, (span){0.0, height});
    }
    // Draw the limits and the case's own value.
    span shown = {low, low + CLASSES * step};
    const double limits[] = {v->number.above, v->number.below},
                 nominal = spread_near(v, spread_nominal(v, 0), s.mean.value);
    for (int i = 0; i < 2; i++) span_widen(&shown, limits[i] / v->unit.size);
    span_widen(&shown, nominal);
    axis_show(&panel->x, span_with_margin(shown, 0.02, 0.0));
    axis_show(&panel->y, (span){0.0, 1.08 * most});
    for (int i = 0; i < 2; i++)
        if (isfinite(limits[i])) panel_upright(figure, panel, limits[i] / v->unit.size, limit_colour, 0.8);
    whirl_series *own = isfinite(nominal) ? panel_upright(figure, panel, nominal, "#303030", 0.6) : NULL;
    if (own) own->dashed = true;
}

// ---------------------------------------------------------------- tornado

/// Sorts the parameters by their total index; the largest is the last, which is drawn at the top.
static void order_by_total(const whirl_spread *s, size_t order[WHIRL_MAX_TOLERANCES]) {
    for (size_t i = 0; i < s->index_count; i++) {
        size_t k = i;
        for (; k > 0 && s->indices[order[k - 1]].total.value > s->indices[i].total.value; k--) order[k] = order[k - 1];
        order[k] = i;
    }
}

static void add_tornado(whirl_figure *figure, const spread_view *v) {
    // Find the indices of sensitivity; if a parameter varies, those of the worst of all its values.
    const whirl_spread s = spread_at(v, figure, v->places > 1 ? WHIRL_ANYWHERE : 0);
    size_t order[WHIRL_MAX_TOLERANCES];
    if (s.index_count == 0 || !isfinite(s.indices[0].total.value)) return;
    // Set up the panel and its series.
    whirl_panel *panel = figure_panel(figure, "indices", 1.0, 1.2 + 0.6 * (double)s.index_count);
    if (!panel) return;
    snprintf(panel->x.label, sizeof panel->x.label, "part of the variance%s",
             v->places > 1 ? " of the worst of all values" : "");
    whirl_series *total = panel_named(figure, panel, WHIRL_BOXES, "with others", inner_colour, 1.0);
    whirl_series *first = panel_named(figure, panel, WHIRL_BOXES, "alone", dark, 1.0);
    whirl_series *errors = panel_series(figure, panel, WHIRL_LINE, "#303030", 0.5);
    // Draw bars of both indices of each parameter with standard errors, the largest first.
    double most = 1.0;
    order_by_total(&s, order);
    for (size_t k = 0; k < s.index_count; k++) {
        const whirl_index *own = &s.indices[order[k]];
        const double y = (double)k + 1.0;
        char name[WHIRL_NAME_SIZE], symbol[SYMBOL_SIZE];
        whirl_result_tolerance(v->of->result, order[k], name);
        symbol_of(name, symbol, sizeof symbol);
        axis_tick(figure, &panel->y, y, symbol);
        series_add_box(figure, total, (span){0.0, fmax(own->total.value, 0.0)}, (span){y - 0.35, y + 0.35});
        series_add_box(figure, first, (span){0.0, fmax(own->first.value, 0.0)}, (span){y - 0.18, y + 0.18});
        series_add(figure, errors, own->first.value - own->first.error, y);
        series_add(figure, errors, own->first.value + own->first.error, y);
        series_break(figure, errors);
        series_add(figure, errors, own->total.value - own->total.error, y + 0.27);
        series_add(figure, errors, own->total.value + own->total.error, y + 0.27);
        series_break(figure, errors);
        most = fmax(most, own->total.value + own->total.error);
    }
    axis_show(&panel->x, (span){0.0, most});
    axis_show(&panel->y, (span){0.5, (double)s.index_count + 0.5});
}

static void tolerances_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    // Find the quantity and its values.
    spread_view v = {.of = of,
                     .table = place->table,
                     .places = whirl_table_places(place->table),
                     .value = whirl_shown_parameter(of->units, place->table->parameter).size};
    if (!whirl_table_asked(of->result, place->table, place->which, &v.number)) return;
    v.unit = number_unit(of->units, place->table, &v.number);
    whirl_spread_at at;
    if (whirl_spread_place(of->result, place->table, &v.number, &at)) v.period = whirl_spread_period(&at);
    // Draw quantiles along the parameter, or a histogram if nothing varies.
    const bool along = v.places > 1 && place->table->count >= v.places;
    if (along)
        add_bands(figure, &v);
    else
        add_histogram(figure, &v);
    // Draw the probability to exceed a limit, and the causes.
    if (along && spread_is_limited(&v)) add_probability(figure, &v);
    add_tornado(figure, &v);
    // Describe the panels.
    snprintf(figure->caption, sizeof figure->caption,
             "%s of %d samples of the parameters with tolerances%s%s. The dashed line is the case's own machine.",
             along ? "Quantiles" : "Histogram", place->table->tolerances.samples,
             spread_is_limited(&v) ? "; the limit is orange" : "",
             place->table->tolerances.indices
                 ? ". Bars: the part of the variance that a parameter causes, with standard errors"
                 : "");
}

const figure_kind tolerances_figure = {.list = tolerances_list,
                                       .describe = tolerances_describe,
                                       .stem = "tolerances",
                                       .study = "tolerances",
                                       .samples = true};
