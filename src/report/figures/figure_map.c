// Maps over two parameters. Every point is a cell, coloured by its regime (paler for lower confidence) or by one of its
// numbers; cells of a basin by their attractor. Several planes have a panel each.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "figure_build.h"
#include "figure_kinds.h"
#include "map_cells.h"
#include "quantities.h"
#include "regimes.h"
#include "sensitivity_view.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"
#include "whirl/status.h"

enum { MAX_PLANES = 12, LEVELS = WHIRL_HIGH + 1 };

/// Share of a verdict's colour that is mixed with white, by confidence.
static const double strength[LEVELS] = {[WHIRL_LOW] = 0.4, [WHIRL_FAIR] = 0.8, [WHIRL_HIGH] = 1.0};

// Viridis and a blue-white-vermilion scale: both are suitable for all kinds of colour vision.
static const char *const rising[] = {"#440154", "#46327e", "#365c8d", "#277f8e",
                                     "#1fa187", "#4ac16d", "#a0da39", "#fde725"};
static const char *const around_zero[] = {"#0072B2", "#ffffff", "#D55E00"};

/// A map to draw, and its figure.
typedef struct map_drawing {
    const drawing *of;
    const figure_place *place;
    const whirl_table *table;
    whirl_figure *figure;
    size_t *labels;                                ///< [count] attractors of a basin; NULL for other maps
    whirl_attractor attractors[ATTRACTOR_COLOURS]; ///< attractors with the most starts
    size_t attractor_count;                        ///< number of all attractors
} map_drawing;

/// A quantity that a figure shows at every point.
typedef struct map_quantity {
    const char *name, *title, *label;
    double (*of)(const map_drawing *map, size_t point, size_t station);
    void (*scale)(whirl_colour_scale *scale, span range); ///< NULL: points have kinds, each with a colour
    bool per_station;
} map_quantity;

// ---------------------------------------------------------------- numbers

/// Returns class and confidence of the verdict as one number.
static double regime_of(const map_drawing *map, size_t point, size_t station) {
    const whirl_verdict verdict = whirl_table_verdict(map->table, point);
    (void)station;
    return (double)((int)regime_class_of(&verdict) * LEVELS + (int)verdict.confidence);
}

static double attractor_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return map->labels && map->labels[point] > 0 ? (double)((map->labels[point] - 1) % ATTRACTOR_COLOURS) : (double)NAN;
}

static double period_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    const whirl_verdict verdict = whirl_table_verdict(map->table, point);
    return verdict.regime == WHIRL_PERIODIC ? (double)verdict.period : (double)NAN;
}

static double exponent_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return point_exponent(map->table, point).value;
}

static double contact_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return rub_share(map->table, point, map->of->result->contact_count);
}

static double radius_of(const map_drawing *map, size_t point, size_t station) {
    return whirl_shown_length(map->of->units, map->table, point) * max_radius(map->table, point, station);
}

static double field_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return shown_number(map->of, map->place, point, 0);
}

static double change_of(const map_drawing *map, size_t point, size_t station) {
    const size_t parameters = sensitivity_parameters(map->table), which = map->place->which;
    (void)station;
    return sensitivity_of(map->table, point, which / parameters, which % parameters).change;
}

static double coexisting_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return map->table->attractors ? (double)map->table->attractors[point].coexisting : (double)NAN;
}

static double share_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return map->table->attractors ? 100.0 * map->table->attractors[point].share : (double)NAN;
}

static void scale_rising(whirl_colour_scale *scale, double low, double high) {
    scale->low = low;
    scale->high = high;
    scale->colours = rising;
    scale->count = sizeof rising / sizeof *rising;
}

static void scale_counts(whirl_colour_scale *scale, span range) {
    scale_rising(scale, 1.0, range.high > 2.0 ? range.high : 2.0);
}

static void scale_periods(whirl_colour_scale *scale, span range) {
    scale_counts(scale, range);
    scale->logarithmic = true;
}

static void scale_percent(whirl_colour_scale *scale, span range) {
    (void)range;
    scale_rising(scale, 0.0, 100.0);
}

static void scale_from_zero(whirl_colour_scale *scale, span range) {
    scale_rising(scale, 0.0, range.high > 0.0 ? range.high : 1.0);
}

static void scale_as_found(whirl_colour_scale *scale, span range) {
    const double size = fmax(fabs(range.low), fabs(range.high)), least = size > 0.0 ? 1e-6 * size : 1.0;
    const span shown = span_with_margin(range, 0.0, least);
    scale_rising(scale, shown.low, shown.high);
}

static void scale_exponents(whirl_colour_scale *scale, span range) {
    const double size = fmin(fmax(fmax(-range.low, range.high), 1e-6), 0.5);
    scale->low = -size;
    scale->high = size;
    scale->colours = around_zero;
    scale->count = sizeof around_zero / sizeof *around_zero;
}

static void scale_around_zero(whirl_colour_scale *scale, span range) {
    const double size = fmax(fabs(range.low), fabs(range.high));
    scale->low = size > 0.0 ? -size : -1.0;
    scale->high = -scale->low;
    scale->colours = around_zero;
    scale->count = sizeof around_zero / sizeof *around_zero;
}

static const map_quantity quantities[] = {
    {"basins", "Basins of attraction", "", attractor_of, NULL, false},
    {"map-regime", "Regimes", "", regime_of, NULL, false},
    {"map-attractors", "Coexisting attractors", "attractors that the starts lead to", coexisting_of, scale_counts,
     false},
    {"map-share", "Share of the starts that lead to the attractor shown", "share of the starts (%)", share_of,
     scale_percent, false},
    {"map-period", "Period of periodic motions", "$k$ of P-$k$", period_of, scale_periods, false},
    {"map-exponent", "Largest Lyapunov exponent", "largest exponent per revolution", exponent_of, scale_exponents,
     false},
    {"map-contact", "Share of the time in contact", "share of the time in contact", contact_of, scale_from_zero, false},
    {"map-radius", "Largest radius", "", radius_of, scale_as_found, true},
};
enum { BASINS, REGIMES, QUANTITIES = sizeof quantities / sizeof *quantities };

/// The quantity of a figure of any field.
static const map_quantity of_field = {"", "", "", field_of, scale_as_found, false};

/// The quantity of a figure of sensitivities.
static const map_quantity of_change = {"", "", "", change_of, scale_around_zero, false};

// ---------------------------------------------------------------- cells

/// Returns the number of a square that was not refined: the mean of its corners.
static double square_number(const map_drawing *map, const map_cells *cells, const double *of, size_t point,
                            size_t width) {
    const size_t slot = whirl_table_slot(map->table, point), x = slot % cells->columns, y = slot / cells->columns;
    const size_t right = x + width < cells->columns ? x + width : cells->columns - 1;
    const size_t top = y + width < cells->rows ? y + width : cells->rows - 1;
    const size_t corners[] = {slot, y * cells->columns + right, top * cells->columns + x, top * cells->columns + right};
    double sum = 0.0;
    for (size_t i = 0; i < 4; i++) {
        const size_t corner = cells->cover[corners[i]];
        sum += corner < map->table->count ? of[corner] : (double)NAN;
    }
    return 0.25 * sum;
}

/// Writes the numbers of all cells of a plane; NaN for cells without a point. mixes: a square that was
/// not refined has the mean of its corners, else the number of its point.
static void fill_cells(const map_drawing *map, const map_cells *cells, bool mixes, const double *of, double *values) {
    const size_t count = map->table->count;
    for (size_t slot = 0; slot < cells->columns * cells->rows; slot++) {
        const size_t point = cells->cover[slot];
        const double width =
            point < count ? whirl_table_number(map->table, point, WHIRL_FIELD_MAP_WIDTH, 0) : (double)NAN;
        values[slot] = point == count         ? (double)NAN
                       : mixes && width > 1.0 ? square_number(map, cells, of, point, (size_t)width)
                                              : of[point];
    }
}

/// Region id of a cell, used to draw borders: one id per regime and period (or attractor); 0 if the point has no
/// verdict.
static long map_kind_of(const map_drawing *map, size_t point) {
    if (point == map->table->count) return 0;
    if (map->labels) return (long)map->labels[point];
    if (!whirl_layout_has_verdict(&map->table->layout)) return 0;
    const whirl_verdict verdict = whirl_table_verdict(map->table, point);
    return 1 + (long)verdict.regime * (WHIRL_MAX_PERIOD + 1) + verdict.period;
}

static void add_borders(const map_drawing *map, whirl_panel *panel, const map_cells *cells) {
    const size_t count = cells->columns * cells->rows;
    long *kinds = calloc(count + 1, sizeof *kinds);
    whirl_series *lines = panel_series(map->figure, panel, WHIRL_LINE, "#606060", 0.3);
    map->figure->failed = map->figure->failed || !kinds;
    for (size_t i = 0; kinds && i < count; i++) kinds[i] = map_kind_of(map, cells->cover[i]);
    if (kinds) map_cells_add_borders(map->figure, lines, cells, kinds);
    free(kinds);
}

/// Writes the colour of a class or attractor, mixed with white for low confidence.
static void kind_colour(const map_quantity *what, size_t code, char colour[8]) {
    const bool judged = what == &quantities[REGIMES];
    const char *full = judged ? regime_class_colour((regime_class)(code / LEVELS)) : attractor_colour(code + 1);
    const unsigned long number = strtoul(full + 1, NULL, 16);
    unsigned mixed = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const double part = (double)(number >> shift & 0xff);
        mixed = mixed << 8 | (unsigned)lround(255.0 + (judged ? strength[code % LEVELS] : 1.0) * (part - 255.0));
    }
    snprintf(colour, 8, "#%06X", mixed & 0xffffffu);
}

/// Writes the name of a class or an attractor for the legend: "P-5 (31 %)" for an attractor with 31 % of the starts.
static void kind_name(const map_drawing *map, const map_quantity *what, size_t code, char *name, size_t size) {
    if (what == &quantities[REGIMES]) {
        snprintf(name, size, "%s", regime_class_name((regime_class)(code / LEVELS)));
        return;
    }
    const whirl_attractor *one = &map->attractors[code];
    const whirl_verdict verdict = whirl_table_verdict(map->table, one->first);
    char regime[WHIRL_NAME_SIZE];
    regime_name(&verdict, regime, sizeof regime);
    snprintf(name, size, "%.32s (%.3g %%)", regime, 100.0 * one->share);
}

/// Adds the legend: all classes in full colour, or the attractors.
static void add_legend(const map_drawing *map, whirl_panel *panel, const map_quantity *what) {
    const bool judged = what == &quantities[REGIMES];
    const size_t most = map->attractor_count < ATTRACTOR_COLOURS ? map->attractor_count : ATTRACTOR_COLOURS;
    for (size_t k = 0; k < (judged ? (size_t)CLASS_NOT_JUDGED : most); k++) {
        const size_t code = judged ? k * LEVELS + WHIRL_HIGH : k;
        char name[WHIRL_NAME_SIZE], colour[8];
        kind_name(map, what, code, name, sizeof name);
        kind_colour(what, code, colour);
        panel_named(map->figure, panel, WHIRL_BOXES, name, colour, 1.0);
    }
}

static void add_kinds(const map_drawing *map, whirl_panel *panel, const map_quantity *what, const map_cells *cells,
                      const double *values) {
    whirl_series *of_code[CLASS_COUNT * LEVELS] = {NULL};
    for (map_run run = {0}; map_cells_next(cells, values, &run);) {
        const size_t code = (size_t)run.value;
        char colour[8];
        kind_colour(what, code, colour);
        if (!of_code[code]) of_code[code] = panel_series(map->figure, panel, WHIRL_BOXES, colour, 1.0);
        series_add_box(map->figure, of_code[code], run.x, run.y);
    }
}

static void add_numbers(const map_drawing *map, whirl_panel *panel, const map_cells *cells, const double *values) {
    whirl_series *boxes = panel_series(map->figure, panel, WHIRL_BOXES, "#000000", 1.0);
    for (map_run run = {0}; map_cells_next(cells, values, &run);) {
        series_add_box(map->figure, boxes, run.x, run.y);
        series_value(map->figure, boxes, run.value);
    }
}

// ---------------------------------------------------------------- panels

/// Returns the number of panels in a row: up to three, or about the square root of the number of planes.
static size_t panels_across(size_t count) {
    return count <= 3 ? count : (size_t)ceil(sqrt((double)count));
}

static void set_axes(const map_drawing *map, whirl_panel *panel, const map_cells *cells, size_t k, size_t count) {
    const whirl_table *table = map->table;
    const double *x = cells->x, *y = cells->y;
    symbol_parameter(map->of->units, table->parameter, panel->x.label, sizeof panel->x.label);
    symbol_parameter(map->of->units, table->second, panel->y.label, sizeof panel->y.label);
    axis_show(&panel->x, (span){fmin(x[0], x[cells->columns]), fmax(x[0], x[cells->columns])});
    axis_show(&panel->y, (span){fmin(y[0], y[cells->rows]), fmax(y[0], y[cells->rows])});
    panel->x.logarithmic = cells->x_ratios;
    panel->y.logarithmic = cells->y_ratios;
    panel->x.shown = k + panels_across(count) >= count;
    panel->y.shown = k % panels_across(count) == 0;
    if (count == 1 || isnan(cells->z)) return;
    char symbol[SYMBOL_SIZE];
    const whirl_unit unit = whirl_shown_parameter(map->of->units, table->third);
    symbol_of(table->third, symbol, sizeof symbol);
    snprintf(panel->title, sizeof panel->title, "%.60s = %.4g%s%.32s", symbol, cells->z, *unit.name ? " " : "",
             unit.name);
}

static void add_plane(const map_drawing *map, const map_quantity *what, const double *of, size_t k, size_t count) {
    // Several planes are spread evenly over all.
    const size_t all = whirl_table_planes(map->table), plane = count > 1 ? k * (all - 1) / (count - 1) : 0;
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, count > 1 ? "plane-%zu" : "map", k + 1);
    // Make the panel, its cells and their values.
    const double across = (double)panels_across(count);
    whirl_panel *panel = figure_panel(map->figure, name, 1.0 / across, count > 1 ? 13.5 / across : 8.4);
    map_cells cells = {.columns = 0};
    const bool made = map_cells_make(map->of->units, map->table, plane, &cells);
    double *values = made ? malloc((cells.columns * cells.rows + 1) * sizeof *values) : NULL;
    map->figure->failed = map->figure->failed || !values;
    // Draw cells as numbers on a scale of colours, or as kinds with a legend.
    if (panel && values) {
        set_axes(map, panel, &cells, k, count);
        fill_cells(map, &cells, what->scale != NULL, of, values);
        if (k == 0 && !what->scale) add_legend(map, panel, what);
        if (what->scale)
            add_numbers(map, panel, &cells, values);
        else
            add_kinds(map, panel, what, &cells, values);
        add_borders(map, panel, &cells);
    }
    free(values);
    map_cells_free(&cells);
}

// ---------------------------------------------------------------- the figure

static size_t plane_count(const whirl_table *table) {
    const size_t all = whirl_table_planes(table);
    return all < MAX_PLANES ? all : MAX_PLANES;
}

static void write_caption(const map_drawing *map, const map_quantity *what, size_t station) {
    // State how many planes are shown.
    const whirl_table *table = map->table;
    const size_t planes = whirl_table_planes(table), shown = plane_count(table);
    char text[500], note[160] = "";
    if (planes > shown)
        snprintf(note, sizeof note, " Of %zu planes %zu are shown.", planes, shown);
    else if (planes > 1)
        snprintf(note, sizeof note, " A panel for every %.63s.", table->third);
    // Describe the quantity: regimes, basins, a field, or another number.
    if (what == &quantities[REGIMES]) {
        snprintf(
            text, sizeof text,
            "Regimes over %s and %s, a cell for each point (%zu by %zu). The paler a cell, the less its verdict can be "
            "trusted: fair and low confidence are mixed with white.",
            table->parameter, table->second, table->row, whirl_table_rows(table));
        if (table->refine > 0)
            snprintf(text + strlen(text), sizeof text - strlen(text),
                     " %zu points were computed, where regimes meet; a square whose corners agree has their regime.",
                     table->count);
    } else if (what == &quantities[BASINS]) {
        snprintf(text, sizeof text,
                 "Starts over %s and %s lead to %zu attractor%s, distinguished by their sections. The legend gives "
                 "their shares "
                 "of all starts; starts without a verdict are white.",
                 table->parameter, table->second, map->attractor_count, map->attractor_count == 1 ? "" : "s");
    } else if (what == &of_field || what == &of_change) {
        snprintf(text, sizeof text, "%.420s%s.", map->figure->title,
                 what == &of_change ? "; white where it is 0 or missing" : "");
    } else {
        const char *name = what->per_station ? map->of->result->stations[station].name : "";
        snprintf(text, sizeof text, "%s%s%s over %s and %s%s.", what->title, *name ? " of " : "", name,
                 table->parameter, table->second, what->of == period_of ? "; other motions are left white" : "");
    }
    snprintf(map->figure->caption, sizeof map->figure->caption, "%s%s", text, note);
}

/// Returns true if any point has a number.
static bool is_known(const map_drawing *map, const map_quantity *what, size_t station) {
    for (size_t i = 0; i < map->table->count; i++)
        if (whirl_table_done(map->table, i) && !isnan(what->of(map, i, station))) return true;
    return false;
}

static bool is_basin(const whirl_table *table) {
    return table->role == WHIRL_ROLE_BASIN;
}

static void add_to_list(figure_list *to, const map_drawing *map, size_t which, size_t station) {
    const map_quantity *what = &quantities[which];
    const whirl_table *table = map->table;
    const char *name = what->per_station ? map->of->result->stations[station].name : "";
    const figure_place place = {
        .kind = &map_figure, .table = table, .point = NO_POINT, .station = station, .which = which};
    char stem[2 * WHIRL_NAME_SIZE];
    snprintf(stem, sizeof stem, "%s%s%s", what->name, *name ? "-" : "", name);
    list_figure(to, &place, stem, "%s%s%s over %s%s%s%s%s", what->title, *name ? " of " : "", name, table->parameter,
                *table->third ? ", " : " and ", table->second, *table->third ? " and " : "", table->third);
}

static void map_list(figure_list *to, const drawing *of, const whirl_table *table) {
    const map_drawing map = {.of = of, .table = table};
    if (table->row == 0) return;
    if (is_basin(table)) add_to_list(to, &map, BASINS, 0);
    if (whirl_layout_has_verdict(&table->layout)) add_to_list(to, &map, REGIMES, 0);
    // Other numbers of a basin belong to its attractors, and have no maps.
    for (size_t which = REGIMES + 1; which < QUANTITIES && !is_basin(table); which++)
        for (size_t s = 0; s < (quantities[which].per_station ? of->result->station_count : 1); s++)
            if (is_known(&map, &quantities[which], s)) add_to_list(to, &map, which, s);
}

void map_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    // Choose the quantity, and make memory for its values.
    const whirl_table *table = place->table;
    // A figure of another kind shows a field or a sensitivity.
    const map_quantity *what = place->kind == &map_figure ? &quantities[place->which]
                               : place->field             ? &of_field
                                                          : &of_change;
    const size_t planes = plane_count(table);
    map_drawing map = {.of = of, .place = place, .table = table, .figure = figure};
    double *of_points = malloc((table->count + 1) * sizeof *of_points);
    span range = span_empty();
    map.labels = is_basin(table) ? calloc(table->count + 1, sizeof *map.labels) : NULL;
    figure->failed = !of_points || (is_basin(table) && !map.labels);
    // Find the attractors to which starts lead.
    if (map.labels &&
        whirl_table_attractors(table, map.labels, map.attractors, ATTRACTOR_COLOURS, &map.attractor_count).code !=
            WHIRL_OK)
        figure->failed = true;
    // Compute the values of all points, and their range.
    for (size_t i = 0; i < table->count && !figure->failed; i++) {
        of_points[i] = whirl_table_done(table, i) ? what->of(&map, i, place->station) : (double)NAN;
        span_widen(&range, of_points[i]);
    }
    // Set up the scale of colours.
    if (planes > 1) figure->width = 17.5;
    if (what->scale) {
        what->scale(&figure->scale, span_has_any(range) ? range : (span){0.0, 1.0});
        snprintf(figure->scale.label, sizeof figure->scale.label, "%s", what->label);
        if (what->per_station)
            symbol_length(of->units, WHIRL_ZERO_TO_PEAK, "largest radius", figure->scale.label,
                          sizeof figure->scale.label);
        if (what == &of_change) snprintf(figure->scale.label, sizeof figure->scale.label, "change (%% for 1 %%)");
        if (place->field) shown_label(of, place, figure->scale.label, sizeof figure->scale.label);
    }
    // Draw the planes, and describe them.
    for (size_t k = 0; k < planes && !figure->failed; k++) add_plane(&map, what, of_points, k, planes);
    if (!figure->failed) write_caption(&map, what, place->station);
    free(map.labels);
    free(of_points);
}

const figure_kind map_figure = {
    .list = map_list, .describe = map_describe, .stem = "map-", .study = "{map: {x: ..., y: ...}}"};
