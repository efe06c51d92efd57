// Maps over two parameters: every point a cell, coloured by its regime (paler where the verdict is less to be trusted)
// or by one of its numbers; those of a basin by the attractor that they came to rest on.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "figures.h"
#include "map_planes.h"
#include "quantities.h"
#include "regimes.h"
#include "typeset.h"

enum { COLOURS = ATTRACTOR_COLOURS };

/// A map that is drawn.
typedef struct map_drawing {
    const drawing *to;
    const whirl_table *table;
    map_planes planes;
    const size_t *labels;                ///< [count] attractors of a basin; NULL: it is none
    long *kinds;                         ///< [planes][cells] another for every regime and period, or attractor, or 0
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
    return whirl_shown_length(map->to->units, map->table, point) * max_radius(map->table, point, station);
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

/// The numbers of all cells of a plane, by those of all points; NaN where there is none.
static void fill_cells(const map_drawing *map, const map_cells *cells, const map_quantity *what, const double *of,
                       double *values) {
    const size_t count = map->table->count;
    for (size_t slot = 0; slot < cells->columns * cells->rows; slot++) {
        const size_t point = cells->cover[slot];
        const double width =
            point < count ? whirl_table_number(map->table, point, WHIRL_FIELD_MAP_WIDTH, 0) : (double)NAN;
        const bool mixed = *what->palette && width > 1.0;
        values[slot] = point == count ? (double)NAN
                       : mixed        ? square_number(map, cells, of, point, (size_t)width)
                                      : of[point];
    }
}

/// Cells with the number of a quantity. Those without one are left out; *range bounds the others'.
static whirl_status write_cells(const map_drawing *map, const char *name, const map_quantity *what, size_t station,
                                span *range) {
    report_file file;
    const whirl_table *table = map->table;
    const size_t count = table->count, grid = map->planes.cells[0].columns * map->planes.cells[0].rows;
    double *values = malloc((count + grid + 1) * sizeof *values);
    if (!values) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a map");
    double *of = values + grid;
    for (size_t i = 0; i < count; i++) of[i] = whirl_table_done(table, i) ? what->of(map, i, station) : (double)NAN;
    whirl_status status = report_file_open(&file, map->to->folder, name);
    *range = span_empty();
    if (status.code == WHIRL_OK) {
        fprintf(file.stream, "# %s and %s of a cell's middle, its edges (some reach under the next cells), %s\n",
                table->parameter, table->second, *what->palette ? what->title : "colour");
        for (size_t k = 0; k < map->planes.count; k++) {
            bool any = false;
            if (k > 0) fputs("\n\n", file.stream);
            fill_cells(map, &map->planes.cells[k], what, of, values);
            for (size_t slot = 0; slot < grid; slot++) span_widen(range, values[slot]);
            for (size_t slot = 0; slot < grid; slot++) any = any || !isnan(values[slot]);
            map_cells_write(file.stream, &map->planes.cells[k], values);
            if (!any) fputs("NaN NaN NaN NaN NaN NaN NaN\n", file.stream);
        }
        status = report_file_close(&file);
    }
    free(values);
    return status;
}

/// Where regimes meet.
static whirl_status write_borders(const map_drawing *map, const char *name) {
    report_file file;
    const whirl_status status = report_file_open(&file, map->to->folder, name);
    if (status.code != WHIRL_OK) return status;
    fprintf(file.stream, "# lines along which regimes meet: %s and %s\n", map->table->parameter, map->table->second);
    for (size_t k = 0; k < map->planes.count; k++) {
        const map_cells *cells = &map->planes.cells[k];
        if (k > 0) fputs("\n", file.stream); // one more line stands behind every piece
        if (!map_cells_write_borders(file.stream, cells, map->kinds + k * cells->columns * cells->rows))
            fputs("NaN NaN\n\n", file.stream);
    }
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
    const map_cells *cells = &map->planes.cells[0];
    const double *x = cells->x, *y = cells->y;
    fprintf(script, "set xrange [%.10g:%.10g]\nset yrange [%.10g:%.10g]\n", fmin(x[0], x[cells->columns]),
            fmax(x[0], x[cells->columns]), fmin(y[0], y[cells->rows]), fmax(y[0], y[cells->rows]));
    if (cells->x_ratios) fputs("set logscale x\n", script);
    if (cells->y_ratios) fputs("set logscale y\n", script);
}

static figure *add_figure(const map_drawing *map, const char *stem, const char *title, const char *station) {
    const whirl_table *table = map->table;
    char name[STEM_SIZE];
    snprintf(name, sizeof name, "%s%s%s", stem, *station ? "-" : "", station);
    figure *what = figure_add(map->to->list, map->to->index, name);
    if (!what) return NULL;
    snprintf(what->data[0], sizeof what->data[0], "%.190s.dat", what->stem);
    if (map->bordered) snprintf(what->data[1], sizeof what->data[1], "%.180s-borders.dat", what->stem);
    snprintf(what->title, sizeof what->title, "%s%s%s over %s%s%s%s%s", title, *station ? " of " : "", station,
             table->parameter, *table->third ? ", " : " and ", table->second, *table->third ? " and " : "",
             table->third);
    return what;
}

/// The plot of plane k: cells of colours as gnuplot is told, and lines where regimes meet.
static void write_plane(FILE *script, const map_drawing *map, const figure *what, const char *colours, size_t k) {
    char index[40] = "";
    if (map->planes.count > 1) snprintf(index, sizeof index, " index %zu", k);
    fprintf(script, "plot '%s'%s using 1:2:3:4:5:6:7 with boxxyerror linecolor %s notitle", what->data[0], index,
            colours);
    if (*what->data[1])
        fprintf(script, ", \\\n  '%s'%s using 1:2 with lines linewidth 0.4 linecolor rgb '#80404040' notitle",
                what->data[1], index);
}

/// Writes the lines of the key: goes on with a plot.
typedef void (*key_writer)(FILE *script, const map_drawing *map);

/// Of several panels the key has one of its own, as wide as all.
static void write_key_panel(FILE *script, const map_drawing *map, key_writer put_key) {
    script_panel(script, 0.085, 0.985, 0.055, 0.91);
    fputs("set border 0\nunset tics\nunset xlabel\nunset ylabel\nunset label 2\nplot NaN notitle", script);
    put_key(script, map);
    fputs("\nset border 31 linewidth 0.5 linecolor rgb '#303030'\nset tics out scale 0.4 font small_font textcolor rgb "
          "'#000000'\n"
          "set xtics nomirror\nset ytics nomirror\nunset key\n",
          script);
}

/// The panels, with cells of which each has a colour.
static void write_planes(FILE *script, const map_drawing *map, const figure *what, key_writer put_key) {
    const bool one = map->planes.count == 1;
    write_axes(script, map);
    script_loop(script);
    fprintf(script,
            "set tics out\nset key at screen %s, screen 0.995*top center top horizontal maxrows 2 Left reverse "
            "samplen 1 font small_font\nset style fill solid 1 noborder\n",
            one ? "0.55" : "0.53");
    if (!one) write_key_panel(script, map, put_key);
    const double height = map_planes_height(&map->planes, 1.0); // of several, cm
    const map_area area =
        one ? (map_area){0.13, 0.97, 0.11, 0.90} : (map_area){0.085, 1.0, 0.7 / height, 1.0 - 1.3 / height};
    for (size_t k = 0; k < map->planes.count; k++) {
        map_planes_panel(script, &map->planes, k, area);
        write_plane(script, map, what, "rgb variable", k);
        if (one) put_key(script, map);
        fputc('\n', script);
    }
}

static void put_regimes(FILE *script, const map_drawing *map) {
    (void)map;
    for (int kind = 0; kind < CLASS_COUNT; kind++)
        fprintf(script, ", \\\n  NaN with boxes linecolor rgb '%s' title '%s'", regime_class_colour((regime_class)kind),
                regime_class_name((regime_class)kind));
}

static void put_attractors(FILE *script, const map_drawing *map) {
    for (size_t k = 0; k < map->attractor_count && k < COLOURS; k++) {
        fprintf(script, ", \\\n  NaN with boxes linecolor rgb '%s' ", attractor_colour(k + 1));
        put_attractor_title(script, map->table, &map->attractors[k]);
    }
}

/// The beginning of a figure's script, as large as its panels need.
static whirl_status begin_script(report_file *file, const map_drawing *map, const figure *what, double height) {
    return script_begin(file, map->to, what, map->planes.count > 1 ? 17.5 : 12.0,
                        map_planes_height(&map->planes, height), 7.0);
}

static whirl_status draw_regimes(const map_drawing *map) {
    report_file file;
    span range;
    char refined[160] = "", planes[160];
    map_planes_note(&map->planes, planes, sizeof planes);
    if (map->table->refine > 0)
        snprintf(refined, sizeof refined,
                 " %zu points were computed, where regimes meet; a square whose corners agree is of their regime.",
                 map->table->count);
    figure *what = add_figure(map, regimes.stem, regimes.title, "");
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    snprintf(what->caption, sizeof what->caption,
             "Regimes over %s and %s, a cell a point (%zu by %zu). The paler a cell, the less its verdict can be "
             "trusted: fair and low confidence are mixed with white.%s%s",
             map->table->parameter, map->table->second, map->table->row, whirl_table_rows(map->table), refined, planes);
    whirl_status status = write_data(map, what, &regimes, 0, &range);
    if (status.code == WHIRL_OK) status = begin_script(&file, map, what, 10.5);
    if (status.code != WHIRL_OK) return status;
    write_planes(file.stream, map, what, put_regimes);
    script_end(file.stream);
    return report_file_close(&file);
}

static whirl_status draw_basins(const map_drawing *map) {
    report_file file;
    span range;
    const size_t count = map->attractor_count;
    char planes[160];
    map_planes_note(&map->planes, planes, sizeof planes);
    figure *what = add_figure(map, attractors.stem, attractors.title, "");
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    whirl_status status = write_data(map, what, &attractors, 0, &range);
    snprintf(
        what->caption, sizeof what->caption,
        "Motions that starts over %s and %s come to rest on: %zu attractor%s, told apart by their sections. In the "
        "key their shares of all starts; starts without a verdict are left white.%s",
        map->table->parameter, map->table->second, count, count == 1 ? "" : "s", planes);
    if (status.code == WHIRL_OK) status = begin_script(&file, map, what, 10.5);
    if (status.code != WHIRL_OK) return status;
    write_planes(file.stream, map, what, put_attractors);
    script_end(file.stream);
    return report_file_close(&file);
}

static void write_colour_bar(FILE *script, const map_drawing *map, const map_quantity *quantity, span range) {
    const whirl_shown_units units = typeset_units(map->to->units);
    char label[TYPESET_SIZE];
    snprintf(label, sizeof label, "%s", quantity->label);
    if (quantity->per_station) units_length_label(&units, "largest radius", label, sizeof label);
    script_label(script, "number_label", label);
    fprintf(script, "least = %.10g\nmost = %.10g\n%s%s", range.low, range.high, quantity->palette, quantity->range);
}

static whirl_status draw_quantity(const map_drawing *map, const map_quantity *quantity, size_t station) {
    report_file file;
    span range;
    char planes[160];
    const char *name = quantity->per_station ? map->to->result->stations[station].name : "";
    figure *what = add_figure(map, quantity->stem, quantity->title, name);
    if (!what) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the list of figures");
    what->station = station;
    map_planes_note(&map->planes, planes, sizeof planes);
    snprintf(what->caption, sizeof what->caption, "%s%s%s over %s and %s%s.%s", quantity->title, *name ? " of " : "",
             name, map->table->parameter, map->table->second,
             quantity->of == period_of ? "; other motions are left white" : "", planes);
    whirl_status status = write_data(map, what, quantity, station, &range);
    if (status.code == WHIRL_OK) status = begin_script(&file, map, what, 10.0);
    if (status.code != WHIRL_OK) return status;
    FILE *script = file.stream;
    write_axes(script, map);
    write_colour_bar(script, map, quantity, range);
    script_loop(script);
    fputs("set cblabel number_label\nset tics out\nset style fill solid 1 noborder\n", script);
    const bool one = map->planes.count == 1;
    const double height = map_planes_height(&map->planes, 1.0); // of several, cm
    const map_area area =
        one ? (map_area){0.13, 0.80, 0.11, 0.96} : (map_area){0.085, 0.89, 0.7 / height, 1.0 - 0.6 / height};
    for (size_t k = 0; k < map->planes.count; k++) {
        map_planes_panel(script, &map->planes, k, area);
        if (k == 0)
            fprintf(script, "set colorbox user origin screen %s, %s 0.03, %s\n", one ? "0.83" : "0.89",
                    one ? "graph 0 size screen" : "screen 0.1 size screen", one ? "graph 1" : "screen 0.8");
        else
            fputs("unset colorbox\n", script);
        write_plane(script, map, what, "palette", k);
        fputc('\n', script);
    }
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
    const size_t count = map->planes.cells[0].columns * map->planes.cells[0].rows;
    map->kinds = calloc(map->planes.count * count + 1, sizeof *map->kinds);
    if (!map->kinds) return false;
    const bool judged = map->labels || whirl_layout_has_verdict(&map->table->layout);
    for (size_t k = 0; k < map->planes.count && judged; k++) {
        const map_cells *cells = &map->planes.cells[k];
        long *kinds = map->kinds + k * count;
        for (size_t i = 0; i < count; i++) kinds[i] = kind_of(map, cells->cover[i]);
        map->bordered = map_cells_write_borders(NULL, cells, kinds) || map->bordered;
    }
    return true;
}

static whirl_status draw_table(const drawing *to, const whirl_table *table, bool basin) {
    map_drawing map = {.to = to, .table = table};
    size_t *labels = basin ? calloc(table->count, sizeof *labels) : NULL;
    whirl_status status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a map");
    if (map_planes_make(to->units, table, &map.planes) && (labels || !basin))
        status =
            basin ? whirl_table_attractors(table, labels, map.attractors, COLOURS, &map.attractor_count) : whirl_ok();
    map.labels = labels;
    if (status.code == WHIRL_OK && !make_kinds(&map)) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a map");
    if (status.code == WHIRL_OK) status = draw_all(&map);
    free(labels);
    free(map.kinds);
    map_planes_free(&map.planes);
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
