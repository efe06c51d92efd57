// The screening diagram of stability: critical speed ratios over the average density of the gas, with their regions.
#include <math.h>
#include <stdio.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "whirl/internal/response_peaks.h"

/// Returns true if a point has a place in the diagram.
static bool stands(const whirl_table *table, size_t point) {
    return whirl_table_done(table, point) &&
           isfinite(whirl_table_number(table, point, WHIRL_FIELD_STABILITY_REGION, 0));
}

static void screening_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &screening_figure, .table = table, .point = NO_POINT};
    (void)of;
    if (!table_has(table, WHIRL_FIELD_STABILITY_REGION)) return;
    for (size_t point = 0; point < table->count; point++)
        if (stands(table, point)) {
            list_figure(to, &place, "screening", "Screening of stability by the density of the gas");
            return;
        }
}

static void screening_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    static const double dense = 60.0, corner = 16.53; // kg/m3, corners of the line of whirl_screening_ratio
    const whirl_table *table = place->table;
    whirl_panel *panel = figure_panel(figure, "ratio", 1.0, 7.5);
    double end = 1.25 * dense;
    if (!panel) return;
    snprintf(panel->x.label, sizeof panel->x.label, "average density of the gas (kg/m3)");
    snprintf(panel->y.label, sizeof panel->y.label, "critical speed ratio");
    whirl_series *line = panel_named(figure, panel, WHIRL_LINE, "between A (below) and B", line_colour(5), 1.0);
    // Draw the line between the regions.
    const double bounds[] = {0.0, corner, dense};
    for (size_t i = 0; i < sizeof bounds / sizeof *bounds; i++)
        series_add(figure, line, bounds[i], whirl_screening_ratio(bounds[i]));
    series_add(figure, line, dense, 0.0);
    // Draw the machine at each point, with the value of the parameter.
    whirl_series *dots[2];
    for (int region = 0; region < 2; region++)
        dots[region] = panel_named(figure, panel, WHIRL_DOTS, region ? "machine, in B" : "machine, in A",
                                   line_colour(region), 3.2);
    whirl_series *names = *table->parameter ? panel_series(figure, panel, WHIRL_TEXTS, "#303030", 1.0) : NULL;
    const whirl_unit unit = whirl_shown_parameter(of->units, table->parameter);
    if (names) names->side = WHIRL_BESIDE;
    if (names) names->movable = true;
    for (size_t point = 0; point < table->count; point++) {
        if (!stands(table, point)) continue;
        const bool in_b = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_REGION, 0) > 0.5;
        const double density = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_DENSITY, 0);
        end = fmax(end, 1.1 * density);
        const double ratio = whirl_table_number(table, point, WHIRL_FIELD_STABILITY_RATIO, 0);
        char text[2 * WHIRL_NAME_SIZE];
        snprintf(text, sizeof text, "%.6g %s", table->values[point] / unit.size, unit.name);
        series_add(figure, dots[in_b], density, ratio);
        if (names) series_add_text(figure, names, density, ratio, text);
    }
    series_add(figure, line, end, 0.0);
    snprintf(figure->caption, sizeof figure->caption,
             "The speed over the first forward critical speed without damping on rigid supports, over the average "
             "density of the gas; in region B a limit of the cross coupling below 10 times the anticipated asks for "
             "seals and impellers to be counted (after API 617; which edition counts is for the user to check).");
}

const figure_kind screening_figure = {.list = screening_list, .describe = screening_describe};
