// Waterfalls: spectral lines of a station over the swept parameter, backward whirl on the left, forward whirl on the
// right. Each line is a mark coloured by amplitude.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bifurcation.h"
#include "figure_build.h"
#include "figure_kinds.h"
#include "machine_at.h"
#include "quantities.h"
#include "units.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

const char *const waterfall_colours[WATERFALL_COLOURS] = {"#fde725", "#a0da39", "#4ac16d", "#1fa187",
                                                          "#277f8e", "#365c8d", "#46327e", "#440154"};

/// Least amplitude of a line, relative to the largest.
static const double MIN_AMPLITUDE = 1e-3;

/// Width of a mark, and its largest height (if points are far apart), as parts of the axes.
static const double WIDE = 0.007, HIGH = 0.03;

/// Mark of a spectral line in one direction of whirl.
typedef struct mark {
    size_t point;
    double at, amplitude; ///< shown frequency, negative for backward whirl; shown amplitude
} mark;

typedef struct waterfall {
    bifurcation axis; ///< axis of the parameter
    bool orders;      ///< frequencies are shown as orders of the running speed
    double *sizes;    ///< [points] shown size of one order
    mark *marks;      ///< sorted by rising amplitude, so that the largest is drawn over the others
    size_t count;
    double largest; ///< largest amplitude
} waterfall;

static int by_amplitude(const void *left, const void *right) {
    const double a = ((const mark *)left)->amplitude, b = ((const mark *)right)->amplitude;
    return (a > b) - (a < b);
}

/// Sets the shown size of one order at all points: a frequency, or 1 if the units show orders or a speed is unknown.
static void find_sizes(const drawing *to, waterfall *of) {
    const whirl_table *table = of->axis.table;
    of->orders = !(to->units->frequency > 0.0);
    for (size_t i = 0; i < table->count && !of->orders; i++) {
        if (!whirl_table_done(table, i)) continue;
        of->sizes[i] = units_order(to->units, machine_clock(to->machine, to->result, table, i));
        of->orders = isnan(of->sizes[i]);
    }
    for (size_t i = 0; i < table->count && of->orders; i++) of->sizes[i] = 1.0;
}

static void gather(waterfall *of) {
    const whirl_table *table = of->axis.table;
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        const numbers lines = point_lines(table, i, of->axis.station);
        const double scale = units_length(of->axis.units, table, i, WHIRL_AMPLITUDE);
        for (size_t k = 0; k < lines.rows; k++) {
            const double *line = &lines.at[5 * k], at = of->sizes[i] * line[0];
            of->marks[of->count++] = (mark){i, at, scale * line[3]};
            of->marks[of->count++] = (mark){i, -at, scale * line[4]};
            of->largest = fmax(of->largest, scale * fmax(line[3], line[4]));
        }
    }
    size_t kept = 0;
    for (size_t k = 0; k < of->count; k++)
        if (of->marks[k].amplitude > 0.0 && of->marks[k].amplitude >= MIN_AMPLITUDE * of->largest)
            of->marks[kept++] = of->marks[k];
    of->count = kept;
    if (kept > 1) qsort(of->marks, kept, sizeof *of->marks, by_amplitude);
}

/// Returns the vertical range of a point's marks: its part of the axis, up to a limit.
static span height_of(const waterfall *of, size_t point) {
    const bifurcation *axis = &of->axis;
    const double at = axis->value * axis->table->values[point];
    double low, high;
    bifurcation_edges(axis, point, &low, &high);
    if (axis->ratios) {
        const double most = pow(axis->parameter.high / axis->parameter.low, 0.5 * HIGH);
        return (span){fmax(axis->value * low, at / most), fmin(axis->value * high, at * most)};
    }
    const double most = 0.5 * HIGH * (axis->parameter.high - axis->parameter.low);
    return (span){fmax(axis->value * low, at - most), fmin(axis->value * high, at + most)};
}

// ---------------------------------------------------------------- the figure

static void waterfall_add_panel(whirl_figure *figure, const waterfall *of, int branch) {
    const bifurcation *axis = &of->axis;
    whirl_panel *panel = figure_panel(figure,
                                      !axis->both  ? "waterfall"
                                      : branch < 0 ? "down"
                                                   : "up",
                                      axis->both ? 0.5 : 1.0, 8.4);
    if (!panel) return;
    // The axis of orders reaches as far as the farthest line.
    double farthest = 0.0;
    for (size_t k = 0; k < of->count; k++) farthest = fmax(farthest, fabs(of->marks[k].at));
    const double reach = farthest > 0.0 ? 1.04 * farthest : 1.0;
    // Set up the panel.
    if (axis->both) snprintf(panel->title, sizeof panel->title, "from the %s value on", branch < 0 ? "last" : "first");
    axis_show(&panel->x, (span){-reach, reach});
    axis_show(&panel->y, axis->parameter);
    panel->y.logarithmic = axis->ratios;
    panel->y.shown = figure->count == 1;
    units_order_label(axis->units, of->orders, true, panel->x.label, sizeof panel->x.label);
    symbol_parameter(axis->units, axis->table->parameter, panel->y.label, sizeof panel->y.label);
    panel_upright(figure, panel, 0.0, "#9A9A9A", 0.4);
    // Draw the lines of the branch as narrow boxes, coloured by amplitude.
    whirl_series *boxes = panel_series(figure, panel, WHIRL_BOXES, "#000000", 1.0);
    for (size_t k = 0; k < of->count; k++) {
        const mark *one = &of->marks[k];
        if ((axis->table->branch[one->point] < 0 ? -1 : 1) != branch) continue;
        series_add_box(figure, boxes, (span){one->at - WIDE * reach, one->at + WIDE * reach},
                       height_of(of, one->point));
        series_value(figure, boxes, one->amplitude);
    }
}

static bool has_lines(const whirl_table *table, size_t station) {
    for (size_t i = 0; i < table->count; i++)
        if (whirl_table_done(table, i) && point_lines(table, i, station).at) return true;
    return false;
}

static void waterfall_list(figure_list *to, const drawing *of, const whirl_table *table) {
    if (!table_is_sweep(of, table)) return;
    for (size_t s = 0; s < of->result->station_count; s++) {
        const char *station = of->result->stations[s].name;
        const figure_place place = {.kind = &waterfall_figure, .table = table, .point = NO_POINT, .station = s};
        char name[2 * WHIRL_NAME_SIZE];
        if (!has_lines(table, s)) continue;
        snprintf(name, sizeof name, "waterfall-%s", station);
        list_figure(to, &place, name, "Spectral lines of %s over %s", station, table->parameter);
    }
}

static void waterfall_describe(const drawing *to, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    // Make memory for the lines of all points.
    waterfall of = {.axis = {.result = to->result,
                             .table = table,
                             .machine = to->machine,
                             .station = place->station,
                             .units = to->units,
                             .length = to->units->length,
                             .value = 1.0 / whirl_shown_parameter(to->units, table->parameter).size}};
    of.sizes = calloc(table->count + 1, sizeof *of.sizes);
    of.marks = calloc(2 * whirl_layout_field(&table->layout, WHIRL_FIELD_SPECTRUM_LINES)->rows * table->count + 1,
                      sizeof *of.marks);
    figure->failed = !of.sizes || !of.marks;
    // Gather the lines, and set up the scale of colours.
    if (!figure->failed) {
        bifurcation_survey(&of.axis);
        find_sizes(to, &of);
        gather(&of);
        figure->scale = (whirl_colour_scale){.low = MIN_AMPLITUDE * of.largest,
                                             .high = of.largest,
                                             .logarithmic = true,
                                             .colours = waterfall_colours,
                                             .count = WATERFALL_COLOURS};
        symbol_length(to->units, WHIRL_AMPLITUDE, "amplitude", figure->scale.label, sizeof figure->scale.label);
        // Draw a panel for each branch, and describe them.
        if (of.axis.both) figure->width = 17.5;
        waterfall_add_panel(figure, &of, 1);
        if (of.axis.both) waterfall_add_panel(figure, &of, -1);
        snprintf(figure->caption, sizeof figure->caption,
                 "Waterfall of %s: the spectral lines of x + iy over %s, forward whirl on the right, backward whirl on "
                 "the left, coloured by their amplitudes (the darker, the larger), down to a thousandth of the "
                 "largest.%s",
                 to->result->stations[place->station].name, table->parameter,
                 of.axis.both ? " Left: followed from the first value on; right: from the last." : "");
    }
    free(of.marks);
    free(of.sizes);
}

const figure_kind waterfall_figure = {.list = waterfall_list,
                                      .describe = waterfall_describe,
                                      .stem = "waterfall-",
                                      .study = "{sweep: ..., analyze: [spectrum]}"};
