// Maps over two parameters: every point a cell, coloured by its regime (paler where the verdict is less to be trusted)
// or by one of its numbers; those of a basin by the attractor that they came to rest on.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "figures.h"
#include "map_cells.h"
#include "quantities.h"
#include "regimes.h"
#include "typeset.h"

enum { COLOURS = ATTRACTOR_COLOURS };

/// A map that is drawn.
typedef struct map_drawing {
    const drawing *to;
    const whirl_table *table;
    map_cells cells;
    const size_t *labels;                ///< [count] attractors of a basin; NULL: it is none
    long *kinds;                         ///< [cells] another one for every regime and period, or attractor; 0 for none
    bool bordered;                       ///< some of them meet
    whirl_attractor attractors[COLOURS]; ///< those of most starts
    size_t attractor_count;              ///< of all
} map_drawing;

/// What one of the figures shows of every point.
typedef struct map_quantity {
    const char *stem, *title, *label; ///< label: in gnuplot's markup
    const char *palette, *range;      ///< gnuplot's commands
    double (*of)(const map_drawing *map, size_t point, size_t station);
    bool per_station;
} map_quantity;

// ---------------------------------------------------------------- numbers

/// The colour of a regime over white: as strong as the verdict can be trusted.
static double regime_of(const map_drawing *map, size_t point, size_t station) {
    static const double strength[] = {[WHIRL_LOW] = 0.4, [WHIRL_FAIR] = 0.8, [WHIRL_HIGH] = 1.0};
    const whirl_verdict verdict = whirl_table_verdict(map->table, point);
    const unsigned long full = strtoul(regime_class_colour(regime_class_of(&verdict)) + 1, NULL, 16);
    unsigned mixed = 0;
    (void)station;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const double part = (double)(full >> shift & 0xff);
        mixed = mixed << 8 | (unsigned)lround(255.0 + strength[verdict.confidence] * (part - 255.0));
    }
    return (double)mixed;
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
    return rub_share(map->table, point, map->to->result->contact_count);
}

static double radius_of(const map_drawing *map, size_t point, size_t station) {
    return units_length(map->to->units, map->table, point) * max_radius(map->table, point, station);
}

// Viridis and a blue-white-vermilion scale: both are read alike by all kinds of colour vision.
#define RISING                                                                                                         \
    "set palette defined (0 '#440154', 1 '#46327e', 2 '#365c8d', 3 '#277f8e', 4 '#1fa187', 5 '#4ac16d', 6 '#a0da39', " \
    "7 '#fde725')\n"
#define AROUND_ZERO "set palette defined (0 '#0072B2', 1 '#ffffff', 2 '#D55E00')\n"

static const map_quantity regimes = {"map-regime", "Regimes", "", "", "", regime_of, false};

static double beside_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return map->table->attractors ? (double)map->table->attractors[point].beside : (double)NAN;
}

static double share_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    return map->table->attractors ? 100.0 * map->table->attractors[point].share : (double)NAN;
}

static const map_quantity quantities[] = {
    {"map-attractors", "Attractors side by side", "attractors that the starts lead to", RISING,
     "set cbrange [1:(most > 2 ? most : 2)]\nset cbtics 1\n", beside_of, false},
    {"map-share", "Share of the starts that lead to the attractor shown", "share of the starts (%)", RISING,
     "set cbrange [0:100]\n", share_of, false},
    {"map-period", "Period of periodic motions", "{/:Italic k} of P-{/:Italic k}", RISING,
     "set logscale cb 2\nset cbrange [1:(most > 2 ? most : 2)]\n", period_of, false},
    {"map-exponent", "Largest Lyapunov exponent", "largest exponent per revolution", AROUND_ZERO,
     "size = least < 0 && -least > most ? -least : most\nsize = size > 0.5 ? 0.5 : size\n"
     "set cbrange [-size:size]\n",
     exponent_of, false},
    {"map-contact", "Share of the time in contact", "share of the time in contact", RISING,
     "set cbrange [0:(most > 0 ? most : 1)]\n", contact_of, false},
    {"map-radius", "Largest radius", "", RISING, "", radius_of, true},
};

// ---------------------------------------------------------------- attractors

static double attractor_of(const map_drawing *map, size_t point, size_t station) {
    (void)station;
    const size_t label = map->labels[point];
    if (label == 0) return NAN;
    return (double)strtoul(attractor_colour(label) + 1, NULL, 16);
}

static const map_quantity attractors = {"basins", "Basins of attraction", "", "", "", attractor_of, false};

/// "P-5 (31 %)", in the key.
static void put_attractor_title(FILE *script, const whirl_table *table, const whirl_attractor *one) {
    const whirl_verdict verdict = whirl_table_verdict(table, one->first);
    char name[WHIRL_NAME_SIZE];
    regime_name(&verdict, name, sizeof name);
    fprintf(script, "title '%s (%.3g %%)'", name, 100.0 * one->share);
}

// ---------------------------------------------------------------- figures

/// The number of a square that was not divided: the mean of its corners'.
static double square_number(const map_drawing *map, const double *of, size_t point, size_t width) {
    const map_cells *cells = &map->cells;
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

/// The numbers of all cells, NaN where there is none; NULL without memory.
static double *cell_numbers(const map_drawing *map, const map_quantity *what, size_t station) {
    const whirl_table *table = map->table;
    const size_t count = table->count, grid = map->cells.columns * map->cells.rows;
    double *cells = malloc((count + grid + 1) * sizeof *cells);
    if (!cells) return NULL;
    double *of = cells + grid;
    for (size_t i = 0; i < count; i++) of[i] = whirl_table_done(table, i) ? what->of(map, i, station) : (double)NAN;
    for (size_t slot = 0; slot < grid; slot++) {
        const size_t point = map->cells.cover[slot];
        const double width = point < count ? whirl_table_number(table, point, "map/width", 0) : (double)NAN;
        const bool mixed = *what->palette && width > 1.0;
        cells[slot] = point == count ? (double)NAN : mixed ? square_number(map, of, point, (size_t)width) : of[point];
    }
    return cells;
}

/// Cells with the number of a quantity. Those without one are left out; *range bounds the others'.
static whirl_status write_cells(const map_drawing *map, const char *name, const map_quantity *what, size_t station,
                                span *range) {
    report_file file;
    double *cells = cell_numbers(map, what, station);
    if (!cells) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a map");
    whirl_status status = report_file_open(&file, map->to->folder, name);
    *range = span_empty();
    if (status.code == WHIRL_OK) {
        fprintf(file.stream, "# %s and %s of a cell's middle, its edges (some reach under the next cells), %s\n",
                map->table->parameter, map->table->second, *what->palette ? what->title : "colour");
        for (size_t slot = 0; slot < map->cells.columns * map->cells.rows; slot++) span_widen(range, cells[slot]);
        map_cells_write(file.stream, &map->cells, cells);
        status = report_file_close(&file);
    }
    free(cells);
    return status;
}

/// Where regimes meet.
static whirl_status write_borders(const map_drawing *map, const char *name) {
    report_file file;
    const whirl_status status = report_file_open(&file, map->to->folder, name);
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream, "# lines along which regimes meet: %s and %s\n", map->table->parameter, map->table->second);
    map_cells_write_borders(file.stream, &map->cells, map->kinds);
    return report_file_close(&file);
}

/// The data files of a figure.
static whirl_status write_data(const map_drawing *map, const figure *of, const map_quantity *what, size_t station,
                               span *range) {
    const whirl_status status = write_cells(map, of->data[0], what, station, range);
    return status.code == WHIRL_OK && *of->data[1] ? write_borders(map, of->data[1]) : status;
}

static void write_axes(FILE *script, const map_drawing *map) {
    const whirl_table *table = map->table;
    char label[TYPESET_SIZE];
    typeset_parameter(map->to->units, table->parameter, label, sizeof label);
    script_label(script, "parameter_label", label);
    typeset_parameter(map->to->units, table->second, label, sizeof label);
    script_label(script, "second_label", label);
    const double *x = map->cells.x, *y = map->cells.y;
    fprintf(script, "set xrange [%.10g:%.10g]\nset yrange [%.10g:%.10g]\n", fmin(x[0], x[map->cells.columns]),
            fmax(x[0], x[map->cells.columns]), fmin(y[0], y[map->cells.rows]), fmax(y[0], y[map->cells.rows]));
    if (map->cells.x_ratios) fputs("set logscale x\n", script);
    if (map->cells.y_ratios) fputs("set logscale y\n", script);
}

static figure *add_figure(const map_drawing *map, const char *stem, const char *title, const char *station) {
    const whirl_table *table = map->table;
    char name[STEM_SIZE];
    snprintf(name, sizeof name, "%s%s%s", stem, *station ? "-" : "", station);
    figure *what = figure_add(map->to->list, map->to->index, name);
    if (!what) return NULL;
    snprintf(what->data[0], sizeof what->data[0], "%.190s.dat", what->stem);
    if (map->bordered) snprintf(what->data[1], sizeof what->data[1], "%.180s-borders.dat", what->stem);
    snprintf(what->title, sizeof what->title, "%s%s%s over %s and %s", title, *station ? " of " : "", station,
             table->parameter, table->second);
    return what;
}

/// Goes on with a plot: lines where regimes meet.
static void write_border_plot(FILE *script, const figure *what) {
    if (*what->data[1])
        fprintf(script, ", \\\n  '%s' using 1:2 with lines linewidth 0.4 linecolor rgb '#80404040' notitle",
                what->data[1]);
}

/// The panel, with cells of which each has a colour; what else is plotted, for the key, follows.
static void write_plane(FILE *script, const map_drawing *map, const figure *what) {
    write_axes(script, map);
    script_loop(script);
    script_panel(script, 0.13, 0.97, 0.11, 0.90);
    fputs("set xlabel parameter_label\nset ylabel second_label\nset tics out\n"
          "set key at screen 0.55, screen 0.995*top center top horizontal maxrows 2 Left reverse samplen 1 "
          "font small_font\nset style fill solid 1 noborder\n",
          script);
    fprintf(script, "plot '%s' using 1:2:3:4:5:6:7 with boxxyerror linecolor rgb variable notitle", what->data[0]);
    write_border_plot(script, what);
}

static whirl_status draw_regimes(const map_drawing *map) {
    report_file file;
    span range;
    char refined[160] = "";
    if (map->table->refine > 0)
        snprintf(refined, sizeof refined,
                 " %zu points were computed, where regimes meet; a square whose corners agree is of their regime.",
                 map->table->count);
    figure *what = add_figure(map, regimes.stem, regimes.title, "");
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    snprintf(what->caption, sizeof what->caption,
             "Regimes over %s and %s, a cell a point (%zu by %zu). The paler a cell, the less its verdict can be "
             "trusted: fair and low confidence are mixed with white.%s",
             map->table->parameter, map->table->second, map->cells.columns, map->cells.rows, refined);
    whirl_status status = write_data(map, what, &regimes, 0, &range);
    if (status.code == WHIRL_OK) status = script_begin(&file, map->to, what, 12.0, 10.5, 7.0);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    write_plane(script, map, what);
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        fprintf(script, ", \\\n  NaN with boxes linecolor rgb '%s' title '%s'", regime_class_colour((regime_class)kind),
                regime_class_name((regime_class)kind));
    fputc('\n', script);
    script_end(script);
    return report_file_close(&file);
}

static whirl_status draw_basins(const map_drawing *map) {
    report_file file;
    span range;
    const size_t count = map->attractor_count;
    figure *what = add_figure(map, attractors.stem, attractors.title, "");
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    whirl_status status = write_data(map, what, &attractors, 0, &range);
    snprintf(
        what->caption, sizeof what->caption,
        "Motions that starts over %s and %s come to rest on: %zu attractor%s, told apart by their sections. In the "
        "key their shares of all starts; starts without a verdict are left white.",
        map->table->parameter, map->table->second, count, count == 1 ? "" : "s");
    if (status.code == WHIRL_OK) status = script_begin(&file, map->to, what, 12.0, 10.5, 7.0);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    write_plane(script, map, what);
    for (size_t k = 0; k < count && k < COLOURS; k++) {
        fprintf(script, ", \\\n  NaN with boxes linecolor rgb '%s' ", attractor_colour(k + 1));
        put_attractor_title(script, map->table, &map->attractors[k]);
    }
    fputc('\n', script);
    script_end(script);
    return report_file_close(&file);
}

static void write_colour_bar(FILE *script, const map_drawing *map, const map_quantity *quantity, span range) {
    const shown_units units = typeset_units(map->to->units);
    char label[TYPESET_SIZE];
    snprintf(label, sizeof label, "%s", quantity->label);
    if (quantity->per_station) units_length_label(&units, "largest radius", label, sizeof label);
    script_label(script, "number_label", label);
    fprintf(script, "least = %.10g\nmost = %.10g\n%s%s", range.low, range.high, quantity->palette, quantity->range);
}

static whirl_status draw_quantity(const map_drawing *map, const map_quantity *quantity, size_t station) {
    report_file file;
    span range;
    const char *name = quantity->per_station ? map->to->result->stations[station].name : "";
    figure *what = add_figure(map, quantity->stem, quantity->title, name);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    what->station = station;
    snprintf(what->caption, sizeof what->caption, "%s%s%s over %s and %s%s.", quantity->title, *name ? " of " : "",
             name, map->table->parameter, map->table->second,
             quantity->of == period_of ? "; other motions are left white" : "");
    whirl_status status = write_data(map, what, quantity, station, &range);
    if (status.code == WHIRL_OK) status = script_begin(&file, map->to, what, 12.0, 10.0, 7.0);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    write_axes(script, map);
    write_colour_bar(script, map, quantity, range);
    script_loop(script);
    script_panel(script, 0.13, 0.80, 0.11, 0.96);
    fputs("set xlabel parameter_label\nset ylabel second_label\nset cblabel number_label\nset tics out\n"
          "set style fill solid 1 noborder\nset colorbox user origin screen 0.83, graph 0 size screen 0.03, graph 1\n",
          script);
    fprintf(script, "plot '%s' using 1:2:3:4:5:6:7 with boxxyerror linecolor palette notitle", what->data[0]);
    write_border_plot(script, what);
    fputc('\n', script);
    script_end(script);
    return report_file_close(&file);
}

/// Whether there is a number at any point.
static bool is_known(const map_drawing *map, const map_quantity *quantity, size_t station) {
    for (size_t i = 0; i < map->table->count; i++)
        if (whirl_table_done(map->table, i) && !isnan(quantity->of(map, i, station))) return true;
    return false;
}

static whirl_status draw_all(const map_drawing *map) {
    const whirl_table *table = map->table;
    whirl_status status = map->labels ? draw_basins(map) : whirl_ok();
    if (status.code == WHIRL_OK && whirl_layout_has_verdict(&table->layout)) status = draw_regimes(map);
    if (map->labels) return status; // all other numbers are those of the attractors
    for (size_t q = 0; q < sizeof quantities / sizeof *quantities; q++)
        for (size_t s = 0; s < (quantities[q].per_station ? map->to->result->station_count : 1); s++)
            if (status.code == WHIRL_OK && is_known(map, &quantities[q], s))
                status = draw_quantity(map, &quantities[q], s);
    return status;
}

static long kind_of(const map_drawing *map, size_t point) {
    if (point == map->table->count) return 0;
    if (map->labels) return (long)map->labels[point];
    const whirl_verdict verdict = whirl_table_verdict(map->table, point);
    return 1 + (long)verdict.regime * (WHIRL_MAX_PERIOD + 1) + verdict.period;
}

/// What borders lie between; none where nothing is judged.
static bool make_kinds(map_drawing *map) {
    const size_t cells = map->cells.columns * map->cells.rows;
    map->kinds = calloc(cells + 1, sizeof *map->kinds);
    if (!map->kinds) return false;
    const bool judged = map->labels || whirl_layout_has_verdict(&map->table->layout);
    for (size_t i = 0; i < cells && judged; i++) map->kinds[i] = kind_of(map, map->cells.cover[i]);
    map->bordered = map_cells_write_borders(NULL, &map->cells, map->kinds);
    return true;
}

static whirl_status draw_table(const drawing *to, const whirl_table *table, bool basin) {
    map_drawing map = {.to = to, .table = table};
    size_t *labels = basin ? calloc(table->count, sizeof *labels) : NULL;
    whirl_status status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a map");
    if (map_cells_make(to->units, table, &map.cells) && (labels || !basin))
        status =
            basin ? whirl_table_attractors(table, labels, map.attractors, COLOURS, &map.attractor_count) : whirl_ok();
    map.labels = labels;
    if (status.code == WHIRL_OK && !make_kinds(&map)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a map");
    if (status.code == WHIRL_OK) status = draw_all(&map);
    free(labels);
    free(map.kinds);
    map_cells_free(&map.cells);
    return status;
}

whirl_status draw_maps(const drawing *to) {
    static const char *const names[] = {"map", "basin"};
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < 2 && status.code == WHIRL_OK; i++) {
        const whirl_table *table = whirl_result_table(to->result, names[i]);
        if (table && table->count > 0 && table->row > 0) status = draw_table(to, table, i == 1);
    }
    return status;
}
