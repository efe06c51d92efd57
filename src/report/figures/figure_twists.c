// Responses to torques over a parameter: torques in shafts, couplings and gears, and twists of stations.
#include <math.h>
#include <stdio.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "margins.h"
#include "shown_kinds.h"
#include "units.h"

/// Figures of torques and of angles: values of figure_place.which.
enum { TORQUES, ANGLES };

enum { MAX_PANELS = 6 };

static void twists_list(figure_list *to, const drawing *of, const whirl_table *table) {
    figure_place place = {.kind = &twists_figure, .table = table, .point = NO_POINT, .which = TORQUES};
    (void)of;
    if (!table_has(table, WHIRL_FIELD_TORSION_TORQUE) || table->count < 2) return;
    list_figure(to, &place, "torsion-torques", "Vibratory torques over %s", table->parameter);
    place.which = ANGLES;
    list_figure(to, &place, "torsion-angles", "Twists of the stations over %s", table->parameter);
}

/// Source of a panel's lines: rows of a field, one for each excitation from `first` on, and their sum, row sum_row of
/// the field `sum`.
typedef struct twists_source {
    const char *field, *sum;
    size_t which, first, sum_row;
    double size; ///< one shown unit of the axis, in SI
} twists_source;

static void twists_add_lines(const drawing *of, const whirl_table *table, const twists_source *from, bool named,
                             whirl_figure *figure, whirl_panel *panel) {
    const double unit = whirl_shown_parameter(of->units, table->parameter).size;
    const size_t excitations = whirl_layout_field(&table->layout, WHIRL_FIELD_TORSION_ORDER)->rows;
    double most = 0.0, low, high;
    span range = span_empty();
    for (size_t point = 0; point < table->count; point++) {
        const double *sum = whirl_table_field(table, point, from->sum, from->which);
        span_widen(&range, table->values[point] / unit);
        if (whirl_table_done(table, point) && sum[from->sum_row] > most) most = sum[from->sum_row];
    }
    axis_show(&panel->x, span_with_margin(range, 0.0, 1e-300));
    axis_show(&panel->y, (span){0.0, most > 0.0 ? 1.06 * most / from->size : 1.0});
    if (margin_running(table, &low, &high) && units_of_speed(table, WHIRL_FIELD_TORSION_SPEED)) {
        const double margin = 1e-3 * (range.high - range.low); // so that a single speed is a line
        const span running = {fmax(low / unit - margin, range.low), fmin(high / unit + margin, range.high)};
        if (running.low < running.high)
            series_add_box(figure, panel_series(figure, panel, WHIRL_BOXES, "#D8D8D8", 1.0), running,
                           (span){0.0, panel->y.high});
    }
    for (size_t i = 0; i <= excitations; i++) {
        char name[WHIRL_NAME_SIZE] = "sum of all";
        const bool sum = i == excitations;
        if (!sum) twists_name_excitation(table, i, name, sizeof name);
        whirl_series *line = panel_named(figure, panel, WHIRL_LINE, named ? name : "", sum ? "#606060" : line_colour(i),
                                         sum ? 1.1 : 0.7);
        if (line) line->dashed = sum;
        for (size_t point = 0; point < table->count; point++) {
            const double *own = whirl_table_field(table, point, sum ? from->sum : from->field, from->which);
            if (whirl_table_done(table, point))
                series_add(figure, line, table->values[point] / unit,
                           own[sum ? from->sum_row : from->first + i] / from->size);
        }
    }
}

/// Chooses the stations with the largest twists, the largest first; returns their number.
static size_t twists_choose_stations(const drawing *of, const whirl_table *table, size_t chosen[MAX_PANELS]) {
    double sizes[MAX_PANELS];
    size_t count = 0;
    for (size_t s = 0; s < of->result->station_count; s++) {
        double most = -1.0;
        for (size_t point = 0; point < table->count; point++) {
            const double sum = whirl_table_number(table, point, WHIRL_FIELD_TORSION_ANGLE_SUM, s);
            if (whirl_table_done(table, point) && sum > most) most = sum;
        }
        if (most < 0.0) continue;
        size_t at = count < MAX_PANELS ? count++ : MAX_PANELS;
        for (; at > 0 && sizes[at - 1] < most; at--)
            if (at < MAX_PANELS) sizes[at] = sizes[at - 1], chosen[at] = chosen[at - 1];
        if (at < MAX_PANELS) sizes[at] = most, chosen[at] = s;
    }
    return count;
}

static void twists_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    // Choose the shafts with the largest torques, or the stations with the largest twists.
    const whirl_table *table = place->table;
    const bool torques = place->which == TORQUES;
    const whirl_unit *unit = &of->units->of[torques ? WHIRL_QUANTITY_MOMENT : WHIRL_QUANTITY_SLOPE];
    const size_t excitations = whirl_layout_field(&table->layout, WHIRL_FIELD_TORSION_ORDER)->rows;
    size_t chosen[MAX_PANELS], first = 0;
    const size_t count = torques ? twists_choose(table, MAX_PANELS, chosen) : twists_choose_stations(of, table, chosen);
    while (first < table->count && !whirl_table_done(table, first)) first++;
    figure->width = 14.0;
    // Set up a panel for each.
    for (size_t i = 0; i < count && first < table->count; i++) {
        char name[2 * WHIRL_NAME_SIZE + 40];
        whirl_panel *panel = figure_panel(figure, torques ? "torque" : "angle", 1.0, count > 3 ? 2.8 : 3.8);
        if (!panel) return;
        symbol_parameter(of->units, table->parameter, panel->x.label, sizeof panel->x.label);
        snprintf(panel->y.label, sizeof panel->y.label, "%s (%s)", torques ? "torque" : "twist", unit->name);
        // Title it by the shaft or the station.
        if (torques)
            torque_name(of->result, whirl_table_field(table, first, WHIRL_FIELD_TORSION_TORQUE_OF, 0) + 3 * chosen[i],
                        name, sizeof name);
        else
            snprintf(name, sizeof name, "%s", of->result->stations[chosen[i]].name);
        snprintf(panel->title, sizeof panel->title, "%.80s", name);
        // Draw the part of each excitation, and their sum.
        const twists_source from = {.field = torques ? WHIRL_FIELD_TORSION_TORQUE : WHIRL_FIELD_TORSION_ANGLE,
                                    .sum = torques ? WHIRL_FIELD_TORSION_TORQUE_SUM : WHIRL_FIELD_TORSION_ANGLE_SUM,
                                    .which = torques ? 0 : chosen[i],
                                    .first = torques ? chosen[i] * excitations : 0,
                                    .sum_row = torques ? chosen[i] : 0,
                                    .size = unit->size};
        twists_add_lines(of, table, &from, i == 0, figure, panel);
    }
    // Describe the panels.
    snprintf(figure->caption, sizeof figure->caption,
             "%s over %s, zero to peak: by each excitation, and summed over all (dashed), the worst case.%s",
             torques ? "Vibratory torques of shafts, couplings and gears" : "Twists of the stations", table->parameter,
             margin_asked(table) ? " Grey: where the machine runs." : "");
}

const figure_kind twists_figure = {.list = twists_list,
                                   .describe = twists_describe,
                                   .stem = "torsion-",
                                   .study = "{torsion: {parameter: ..., from: ..., to: ...}}"};
