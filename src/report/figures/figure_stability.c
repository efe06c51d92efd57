// Stability: logarithmic decrements over the cross coupling of stages.
#include <math.h>
#include <stdio.h>

#include "asked.h"
#include "figure_build.h"
#include "figure_kinds.h"

/// Lists a figure for each point or, if there are many, for every few points.
static void stability_list(figure_list *to, const drawing *of, const whirl_table *table) {
    enum { MAX_FIGURES = 6 };
    const size_t step = 1 + (table->count - 1) / MAX_FIGURES;
    for (size_t point = 0; point < table->count && table_has(table, WHIRL_FIELD_STABILITY_CURVE); point += step) {
        const whirl_unit unit = whirl_shown_parameter(of->units, table->parameter);
        const figure_place place = {.kind = &stability_figure, .table = table, .point = (long)point};
        char at[2 * WHIRL_NAME_SIZE] = "";
        const double *curve = whirl_table_field(table, point, WHIRL_FIELD_STABILITY_CURVE, 0);
        if (!whirl_table_done(table, point) || !curve || !isfinite(curve[0])) continue;
        if (*table->parameter) snprintf(at, sizeof at, " at %.6g %s", table->values[point] / unit.size, unit.name);
        list_figure(to, &place, "stability", "Stability over the cross coupling of stages%s", at);
    }
}

/// Adds a named vertical line at a cross coupling.
static void add_mark(whirl_figure *figure, whirl_panel *panel, double at, double low, double high, const char *name,
                     size_t colour) {
    if (!isfinite(at)) return;
    whirl_series *line = panel_named(figure, panel, WHIRL_LINE, name, line_colour(colour), 0.8);
    if (line) line->dashed = true;
    series_add(figure, line, at, low);
    series_add(figure, line, at, high);
}

static void stability_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    static const double mega = 1e6;
    const double least = asked_decrement;
    const whirl_table *table = place->table;
    const size_t point = (size_t)place->point;
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_STABILITY_CURVE);
    const double *curve = whirl_table_field(table, point, WHIRL_FIELD_STABILITY_CURVE, 0);
    const double *coupling = whirl_table_field(table, point, WHIRL_FIELD_STABILITY_CROSS_COUPLING, 0);
    whirl_panel *panel = figure_panel(figure, "decrement", 1.0, 7.5);
    double low = 0.0, high = least;
    (void)of;
    if (!panel) return;
    snprintf(panel->x.label, sizeof panel->x.label, "cross coupling of all stages (MN/m)");
    snprintf(panel->y.label, sizeof panel->y.label, "logarithmic decrement");
    whirl_series *line = panel_named(figure, panel, WHIRL_LINE, "least of forward modes", line_colour(0), 1.2);
    const double limit = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_LIMIT, 0);
    for (size_t i = 0; i < field->rows; i++) {
        // The curve crosses 0 at the limit, between two of its points.
        if (i > 0 && limit > coupling[i - 1] && limit < coupling[i]) series_add(figure, line, limit / mega, 0.0);
        series_add(figure, line, coupling[i] / mega, curve[i]);
        low = fmin(low, curve[i]);
        high = fmax(high, curve[i]);
    }
    // Draw the required decrement, 0, and marks of both cross couplings.
    char asked[16];
    snprintf(asked, sizeof asked, "%g", least);
    whirl_series *level = panel_named(figure, panel, WHIRL_LINE, asked, line_colour(5), 0.6);
    if (level) level->dashed = true;
    series_add(figure, level, 0.0, least);
    series_add(figure, level, coupling[field->rows - 1] / mega, least);
    whirl_series *zero = panel_series(figure, panel, WHIRL_LINE, "#909090", 0.5);
    series_add(figure, zero, 0.0, 0.0);
    series_add(figure, zero, coupling[field->rows - 1] / mega, 0.0);
    add_mark(figure, panel, whirl_table_number(table, point, WHIRL_FIELD_STABILITY_ANTICIPATED, 0) / mega, low, high,
             "anticipated", 1);
    add_mark(figure, panel, limit / mega, low, high, "limit", 2);
    snprintf(
        figure->caption, sizeof figure->caption,
        "The smallest logarithmic decrement of forward modes up to the speed, over the cross coupling of all stages, "
        "each in proportion, with bearings and without seals. Marks: the anticipated cross coupling, and the limit at "
        "which the decrement is 0.");
}

const figure_kind stability_figure = {.list = stability_list, .describe = stability_describe};
