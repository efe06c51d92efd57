// Draws the sensitivity of a number to parameters: lines along the varied parameter, and bars at the point where the
// number is largest. Maps have a figure for each parameter (figure_map.c).
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "number_name.h"
#include "sensitivity_view.h"

/// Lists the maps of a number's sensitivity, one for each parameter that changes it anywhere.
static void sensitivity_list_maps(figure_list *to, const drawing *of, const whirl_table *table, size_t number,
                                  const char *name) {
    const size_t parameters = sensitivity_parameters(table);
    for (size_t p = 0; p < parameters; p++) {
        bool any = false;
        for (size_t i = 0; i < table->count && !any; i++)
            any = whirl_table_done(table, i) && fabs(sensitivity_of(table, i, number, p).change) > 0.0;
        if (!any) continue;
        const figure_place place = {
            .kind = &sensitivity_figure, .table = table, .point = NO_POINT, .which = number * parameters + p};
        const char *parameter = sensitivity_parameter(of->result, p);
        char file[NUMBER_NAME_SIZE + WHIRL_NAME_SIZE];
        snprintf(file, sizeof file, "sensitivity-%.150s-to-%.60s", name, parameter);
        list_figure(to, &place, file, "Sensitivity of %.100s to %.60s", name, parameter);
    }
}

static void sensitivity_list(figure_list *to, const drawing *of, const whirl_table *table) {
    figure_place place = {.kind = &sensitivity_figure, .table = table, .point = NO_POINT};
    whirl_spread_of number;
    if (whirl_layout_field(&table->layout, WHIRL_FIELD_TRACE_SPECIAL)) return; // special points are listed
    for (; whirl_table_derived(of->result, table, place.which, &number); place.which++) {
        char name[NUMBER_NAME_SIZE], file[NUMBER_NAME_SIZE];
        if (sensitivity_largest(table, place.which) == table->count) continue;
        number_name(table, &number, name);
        if (*table->second) {
            sensitivity_list_maps(to, of, table, place.which, name);
            continue;
        }
        snprintf(file, sizeof file, "sensitivity-%.150s", name);
        list_figure(to, &place, file, "Sensitivity of %.100s", name);
    }
}

/// Writes the name of the number that a figure shows.
static void name_number(const drawing *of, const figure_place *place, char name[NUMBER_NAME_SIZE]) {
    whirl_spread_of number;
    *name = '\0';
    if (whirl_table_derived(of->result, place->table, place->which, &number)) number_name(place->table, &number, name);
}

/// Adds the panel with the change of the number along the varied parameter, a line for each parameter.
static void add_lines(whirl_figure *figure, const drawing *of, const figure_place *place) {
    const whirl_table *table = place->table;
    whirl_panel *panel = figure_panel(figure, "changes", 1.0, 6.0);
    if (!panel) return;
    const whirl_unit unit = whirl_shown_parameter(of->units, table->parameter);
    symbol_parameter(of->units, table->parameter, panel->x.label, sizeof panel->x.label);
    snprintf(panel->y.label, sizeof panel->y.label, "change (%% for 1 %%)");
    span along = span_empty();
    for (size_t p = 0; p < sensitivity_parameters(table); p++) {
        char symbol[SYMBOL_SIZE];
        symbol_of(sensitivity_parameter(of->result, p), symbol, sizeof symbol);
        whirl_series *line = panel_named(figure, panel, WHIRL_LINE, symbol, line_colour(p), 0.8);
        for (size_t point = 0; point < table->count; point++) {
            const double change = sensitivity_of(table, point, place->which, p).change;
            if (whirl_table_done(table, point) && isfinite(change))
                series_add(figure, line, table->values[point] / unit.size, change);
            else
                series_break(figure, line);
            span_widen(&along, table->values[point] / unit.size);
        }
    }
    if (span_has_any(along)) axis_show(&panel->x, along);
}

/// Adds the panel with the changes at one point as bars, the largest at the top.
static void add_bars(whirl_figure *figure, const drawing *of, const figure_place *place, size_t point) {
    size_t order[WHIRL_MAX_SENSITIVITIES];
    const size_t known = sensitivity_order(place->table, point, place->which, order);
    whirl_panel *panel = known > 0 ? figure_panel(figure, "bars", 1.0, 1.2 + 0.6 * (double)known) : NULL;
    if (!panel) return;
    // Label the axis with the value of the varied parameter at the point.
    const bool along = *place->table->parameter && place->table->count > 1;
    const whirl_unit unit = whirl_shown_parameter(of->units, place->table->parameter);
    char symbol[SYMBOL_SIZE];
    symbol_of(place->table->parameter, symbol, sizeof symbol);
    if (along)
        snprintf(panel->x.label, sizeof panel->x.label, "change (%% for 1 %%) at %.100s = %.6g %.30s", symbol,
                 place->table->values[point] / unit.size, unit.name);
    else
        snprintf(panel->x.label, sizeof panel->x.label, "change (%% for 1 %%)");
    // Add a bar from 0 for each parameter.
    whirl_series *more = panel_series(figure, panel, WHIRL_BOXES, line_colour(0), 1.0);
    whirl_series *less = panel_series(figure, panel, WHIRL_BOXES, line_colour(1), 1.0);
    span shown = {0.0, 0.0};
    for (size_t k = 0; k < known; k++) {
        const double change = sensitivity_of(place->table, point, place->which, order[k]).change;
        const double y = (double)(known - k);
        symbol_of(sensitivity_parameter(of->result, order[k]), symbol, sizeof symbol);
        axis_tick(figure, &panel->y, y, symbol);
        series_add_box(figure, change < 0.0 ? less : more, (span){fmin(change, 0.0), fmax(change, 0.0)},
                       (span){y - 0.3, y + 0.3});
        span_widen(&shown, change);
    }
    axis_show(&panel->x, span_with_margin(shown, 0.05, 1e-12));
    axis_show(&panel->y, (span){0.5, (double)known + 0.5});
    panel_upright(figure, panel, 0.0, "#303030", 0.5);
}

static void sensitivity_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    if (*place->table->second) {
        map_describe(of, place, figure);
        return;
    }
    char name[NUMBER_NAME_SIZE];
    name_number(of, place, name);
    size_t known = 0;
    for (size_t i = 0; i < place->table->count; i++)
        known += whirl_table_done(place->table, i) && isfinite(sensitivity_of(place->table, i, place->which, 0).number);
    const bool along = *place->table->parameter && known > 1;
    if (along) add_lines(figure, of, place);
    const size_t point = sensitivity_largest(place->table, place->which);
    if (point < place->table->count) add_bars(figure, of, place, point);
    snprintf(figure->caption, sizeof figure->caption,
             "Change of %.150s if a parameter grows by 1 %%, all others as they are%s.", name,
             along ? "; the bars are where it is largest" : "");
}

const figure_kind sensitivity_figure = {
    .list = sensitivity_list, .describe = sensitivity_describe, .stem = "sensitivity", .study = "sensitivity"};
