// Shapes of the lowest modes along the shaft.
#include <math.h>
#include <stdio.h>

#include "figure_kinds.h"
#include "shown_kinds.h"

enum { SHAPES = 6 };

/// Where stations stand along a figure: those of shafts of finite elements at their places, the others beyond the last
/// of these, one by one; without shafts all one by one.
typedef struct along {
    bool shafts;
    size_t aside; ///< stations on no shaft, where there are shafts
    span range;   ///< mm, or numbers of stations
    double end;   ///< mm; beyond it stations lie on no shaft
    double at[WHIRL_MAX_PROBES];
} along;

static void place_stations(const whirl_result *result, along *out) {
    span places = span_empty();
    *out = (along){.range = {0.5, (double)result->station_count + 0.5}};
    for (size_t s = 0; s < result->station_count; s++) {
        out->at[s] = (double)s + 1.0;
        if (result->stations[s].shaft > 0) span_widen(&places, 1e3 * result->stations[s].position);
    }
    if (!span_has_any(places)) return;
    const double step = places.high > places.low ? 0.16 * (places.high - places.low) : 1.0;
    out->shafts = true;
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        out->at[s] = station->shaft > 0 ? 1e3 * station->position : places.high + step * (double)++out->aside;
    }
    out->end = places.high + 0.5 * step;
    out->range = (span){places.low - 0.3 * step, places.high + step * ((double)out->aside + 0.3)};
}

/// The station that follows one on its shaft, along it; station_count where there is none, or none is asked for.
static size_t next_on_shaft(const whirl_result *result, size_t shaft, double after) {
    size_t next = result->station_count;
    for (size_t s = 0; s < result->station_count; s++) {
        const whirl_probe *station = &result->stations[s];
        if (station->shaft != shaft || !(station->position > after)) continue;
        if (next == result->station_count || station->position < result->stations[next].position) next = s;
    }
    return next;
}

/// A mode of a point, and one of its four numbers a station: x_cos, x_sin, y_cos, y_sin.
typedef struct shape {
    const whirl_table *table;
    size_t point, mode, column;
    const along *places;
    whirl_series *line, *dots;
} shape;

static void add_station(whirl_figure *figure, const shape *s, size_t station) {
    const double *row = whirl_table_field(s->table, s->point, WHIRL_FIELD_MODES_SHAPE, station) + 4 * s->mode;
    if (!isfinite(row[0])) return;
    series_add(figure, s->line, s->places->at[station], row[s->column]);
    series_add(figure, s->dots, s->places->at[station], row[s->column]);
}

/// The stations of every shaft, along it, and each of the others alone.
static void add_shape(whirl_figure *figure, const whirl_result *result, const shape *of) {
    for (size_t shaft = 1; shaft <= WHIRL_MAX_SHAFTS; shaft++) {
        size_t s = next_on_shaft(result, shaft, -(double)INFINITY);
        for (; s < result->station_count; s = next_on_shaft(result, shaft, result->stations[s].position))
            add_station(figure, of, s);
        series_break(figure, of->line);
    }
    for (size_t s = 0; s < result->station_count; s++) {
        if (result->stations[s].shaft > 0) continue;
        add_station(figure, of, s);
        if (of->places->shafts) series_break(figure, of->line);
    }
}

/// The horizontal axis: places along the shaft, or the names of stations where there is none.
static void set_places(whirl_figure *figure, whirl_panel *panel, const whirl_result *result, const along *places) {
    const size_t stations = result->station_count;
    axis_show(&panel->x, places->range);
    axis_show(&panel->y, (span){-1.1, 1.1});
    if (places->shafts) {
        const double high = places->aside > 0 ? places->end : places->range.high;
        const double step = tick_step(high - places->range.low, 4);
        char text[32];
        const double first = ceil(places->range.low / step);
        for (int k = 0; k < 8 && step * (first + k) <= high; k++) {
            snprintf(text, sizeof text, "%g", step * (first + k) + 0.0);
            axis_tick(figure, &panel->x, step * (first + k), text);
        }
        snprintf(panel->x.label, sizeof panel->x.label, "$z$ (mm)");
    }
    whirl_series *names = panel_series(figure, panel, WHIRL_TEXTS, "#606060", 1.0);
    for (size_t s = 0; s < stations; s++) {
        if (!places->shafts && (stations <= 8 || s == 0 || s + 1 == stations))
            axis_tick(figure, &panel->x, (double)s + 1.0, result->stations[s].name);
        if (places->shafts && result->stations[s].shaft == 0)
            series_add_text(figure, names, places->at[s], -1.0, result->stations[s].name);
    }
    if (places->aside > 0) panel_upright(figure, panel, places->end, "#909090", 0.4);
}

static void add_mode(whirl_figure *figure, const drawing *of, const whirl_table *table, size_t mode, bool lowest,
                     const along *places) {
    const size_t point = table->count - 1;
    const speed_unit unit = speed_unit_of(of, table, WHIRL_FIELD_MODES_SPEED);
    const double frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0)[mode];
    const double direction = whirl_table_field(table, point, WHIRL_FIELD_MODES_DIRECTION, 0)[mode];
    static const char *const ways[] = {", backward", "", ", forward"};
    char name[WHIRL_NAME_SIZE];
    snprintf(name, sizeof name, "mode-%zu", mode + 1);
    whirl_panel *panel = figure_panel(figure, name, 0.5, 2.1);
    if (!panel) return;
    snprintf(panel->title, sizeof panel->title, "%zu: %.5g %.40s%s", mode + 1, frequency / unit.size, unit.name,
             ways[units_way(direction) + 1]);
    set_places(figure, panel, of->result, places);
    if (!lowest) *panel->x.label = '\0';
    for (size_t column = 0; column < 4; column++) {
        const char *colour = line_colour(column / 2);
        shape own = {.table = table, .point = point, .mode = mode, .column = column, .places = places};
        own.line = panel_series(figure, panel, WHIRL_LINE, colour, 0.53);
        own.dots = panel_series(figure, panel, WHIRL_DOTS, colour, 1.35);
        if (own.line) own.line->dashed = column % 2;
        if (own.dots) own.dots->mark = column % 2 ? WHIRL_RING : WHIRL_DISC;
        add_shape(figure, of->result, &own);
    }
}

static size_t count_modes(const whirl_table *table) {
    const whirl_field *field = whirl_layout_field(&table->layout, WHIRL_FIELD_MODES_FREQUENCY);
    const double *frequency = whirl_table_field(table, table->count - 1, WHIRL_FIELD_MODES_FREQUENCY, 0);
    size_t count = 0;
    while (frequency && count < field->rows && count < SHAPES && isfinite(frequency[count]) &&
           !mode_is_overdamped(table, table->count - 1, count))
        count++;
    return whirl_table_done(table, table->count - 1) ? count : 0;
}

static void list(figure_list *to, const drawing *of, const whirl_table *table) {
    const figure_place place = {.kind = &shapes_figure, .table = table, .point = NO_POINT};
    if (table_has(table, WHIRL_FIELD_MODES_FREQUENCY) && of->result->station_count > 1 && count_modes(table) > 0)
        list_figure(to, &place, "shapes", "Shapes of the lowest modes");
}

static void describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    const whirl_table *table = place->table;
    const size_t count = count_modes(table);
    char label[UNIT_LABEL_SIZE];
    along places;
    figure->font = 6.5;
    place_stations(of->result, &places);
    for (size_t mode = 0; mode < count; mode++) add_mode(figure, of, table, mode, mode + 2 >= count, &places);
    units_point_label(of->units, table, table->count - 1, label, sizeof label);
    snprintf(figure->caption, sizeof figure->caption,
             "Shapes of the %zu lowest modes at %s, over %s: blue x, orange y; full lines at the instant at which the "
             "largest displacement peaks, dashed lines a quarter of a period later.",
             count, label,
             !places.shafts     ? "the stations"
             : places.aside > 0 ? "the place of the stations along the shaft, and those on no shaft"
                                : "the place of the stations along the shaft");
}

const figure_kind shapes_figure = {.list = list, .describe = describe};
