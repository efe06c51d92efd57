// Figures of motions without a verdict, such as drops and losses of blades: x and y of a station over the revolutions.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "quantities.h"
#include "shown_kinds.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

enum { MAX_MOTIONS = 6, MAX_STEPS = 1500 };

static bool is_transient(const whirl_table *table) {
    return shown_kind_of(table) == &shown_motions && !whirl_layout_has_verdict(&table->layout) && table->row == 0 &&
           !table->source;
}

static bool has_waveform(const whirl_table *table, size_t point, size_t station) {
    return whirl_table_done(table, point) && point_waveform(table, point, station).at;
}

static void transient_list(figure_list *to, const drawing *of, const whirl_table *table) {
    for (size_t s = 0; s < of->result->station_count && is_transient(table); s++) {
        const figure_place place = {.kind = &transient_figure, .table = table, .point = NO_POINT, .station = s};
        const char *const station = of->result->stations[s].name;
        char name[2 * WHIRL_NAME_SIZE];
        size_t point = 0;
        while (point < table->count && !has_waveform(table, point, s)) point++;
        if (point == table->count) continue;
        snprintf(name, sizeof name, "transient-%.63s", station);
        list_figure(to, &place, name, "%.60s over the revolutions: %.60s", station, table->name);
    }
}

/// Adds a line through the least and the largest of every few samples, in their order, to limit the number of points.
static void add_samples(whirl_figure *figure, whirl_series *line, const numbers *samples, size_t column, double turn,
                        double length) {
    const size_t step = samples->rows / MAX_STEPS + 1;
    for (size_t first = 0; first < samples->rows; first += step) {
        size_t low = first, high = first;
        for (size_t k = first; k < first + step && k < samples->rows; k++) {
            if (samples->at[2 * k + column] < samples->at[2 * low + column]) low = k;
            if (samples->at[2 * k + column] > samples->at[2 * high + column]) high = k;
        }
        const size_t both[] = {low < high ? low : high, low < high ? high : low};
        for (size_t i = 0; i < (low == high ? 1u : 2u); i++)
            series_add(figure, line, (double)(both[i] + 1) / turn, length * samples->at[2 * both[i] + column]);
    }
}

static void transient_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    static const char *const names[] = {"x", "y"}, *const symbols[] = {"$x$", "$y$"};
    // Find the number of samples in a revolution.
    const whirl_table *table = place->table;
    const double turn = fmax(1.0, whirl_record_samples(&table->record, table->integrate.steps_per_revolution));
    size_t left = 0;
    // Set up a panel for x and one for y.
    for (size_t column = 0; column < 2; column++) {
        whirl_panel *panel = figure_panel(figure, names[column], 1.0, 4.0);
        size_t count = 0;
        if (!panel) return;
        left = 0;
        snprintf(panel->x.label, sizeof panel->x.label, "revolution%s", table->record.transient ? " recorded" : "");
        symbol_length(of->units, WHIRL_FROM_CENTRE, symbols[column], panel->y.label, sizeof panel->y.label);
        // Draw the first motions with a waveform; count the others.
        for (size_t i = 0; i < table->count; i++) {
            char label[UNIT_LABEL_SIZE] = "";
            if (!has_waveform(table, i, place->station)) continue;
            if (count == MAX_MOTIONS) {
                left++;
                continue;
            }
            if (column == 0) units_point_label(of->units, table, i, label, sizeof label);
            const numbers samples = point_waveform(table, i, place->station);
            whirl_series *line = panel_named(figure, panel, WHIRL_LINE, label, line_colour(count++), 0.5);
            add_samples(figure, line, &samples, column, turn, whirl_shown_length(of->units, table, i));
        }
    }
    // Describe the panels.
    snprintf(figure->caption, sizeof figure->caption, "%.60s of the %.60s over the revolutions",
             of->result->stations[place->station].name, table->name);
    const size_t used = strlen(figure->caption);
    snprintf(figure->caption + used, sizeof figure->caption - used, left > 0 ? "; the first %d of %zu motions." : ".",
             MAX_MOTIONS, left + MAX_MOTIONS);
}

const figure_kind transient_figure = {.list = transient_list, .describe = transient_describe};
