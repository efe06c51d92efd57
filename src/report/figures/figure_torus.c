// Figures of tori: their numbers over the parameter.
#include "figure_kinds.h"
#include "tori_bands.h"
#include "units.h"

#include <math.h>
#include <stdio.h>

#include "figure_build.h"
#include "quantities.h"

/// A branch of tori, and data shared by its panels.
typedef struct torus_view {
    const drawing *of;
    const whirl_table *table;
    whirl_tori own;
    double size; ///< one unit of the parameter, in SI
    span range;
} torus_view;

static double rotation_of(const torus_view *v, size_t point, size_t station) {
    (void)station;
    return point_number(v->table, point, WHIRL_FIELD_TORUS_ROTATION);
}

static double exponent_of(const torus_view *v, size_t point, size_t station) {
    (void)station;
    return point_number(v->table, point, WHIRL_FIELD_TORUS_EXPONENT);
}

/// Returns the larger amplitude of x and y of a station at the strongest line of the second frequency.
static double amplitude_of(const torus_view *v, size_t point, size_t station) {
    const double *amplitude = whirl_table_field(v->table, point, WHIRL_FIELD_TORUS_AMPLITUDE, station);
    return units_length(v->of->units, v->table, point, WHIRL_AMPLITUDE) * fmax(amplitude[0], amplitude[1]);
}

/// Adds a number of a branch's tori: a line with discs for stable tori, a dashed line with rings for unstable ones.
static void add_numbers(whirl_figure *figure, whirl_panel *panel, const torus_view *v, size_t station, const char *name,
                        double (*number)(const torus_view *v, size_t point, size_t station)) {
    const char *colour = line_colour(station);
    for (int stable = 1; stable >= 0; stable--) {
        whirl_series *line = panel_named(figure, panel, WHIRL_LINE, stable ? name : "", colour, stable ? 0.8 : 0.6);
        whirl_series *dots = panel_series(figure, panel, WHIRL_DOTS, colour, 1.1);
        if (line) line->dashed = !stable;
        if (dots) dots->mark = stable ? WHIRL_DISC : WHIRL_RING;
        for (size_t point = v->own.first; point <= v->own.last; point++) {
            if (tori_is_stable(v->table, point) != stable) continue;
            const double at = v->table->values[point] / v->size, value = number(v, point, station);
            if (point > v->own.first && tori_is_stable(v->table, point - 1) != stable)
                series_add(figure, line, v->table->values[point - 1] / v->size, number(v, point - 1, station));
            series_add(figure, line, at, value);
            series_add(figure, dots, at, value);
            if (point < v->own.last && tori_is_stable(v->table, point + 1) != stable) series_break(figure, line);
        }
    }
}

static size_t common_divisor(size_t p, size_t q) {
    return p == 0 ? q : common_divisor(q % p, p);
}

/// Adds the simplest fractions in the range as lines, those of smallest denominator q first.
static void add_resonances(whirl_figure *figure, whirl_panel *panel, span range) {
    enum { MAX_DENOMINATOR = 12, MAX_DRAWN = 5 };
    const double turns = 1e3; // rotation numbers are below 1, but those of a damaged file may be large
    size_t drawn = 0;
    if (!(range.low > -turns && range.high < turns)) return;
    for (size_t q = 1; q <= MAX_DENOMINATOR && drawn < MAX_DRAWN; q++)
        for (double p = ceil(range.low * (double)q); p / (double)q <= range.high; p++) {
            if (common_divisor((size_t)fabs(p), q) != 1) continue;
            const double at = p / (double)q;
            char text[32];
            snprintf(text, sizeof text, "%.0f/%zu", p, q);
            whirl_series *line = panel_level(figure, panel, at, "#9A9A9A", 0.4);
            if (line) line->dashed = true;
            whirl_series *label = panel_series(figure, panel, WHIRL_TEXTS, "#606060", 1.0);
            if (label) label->movable = true;
            series_add_text(figure, label, panel->x.low + 0.97 * (panel->x.high - panel->x.low), at, text);
            drawn++;
        }
}

/// Returns the range of the rotation numbers, with the resonance at which tori end.
static span rotations_of(const torus_view *v) {
    const double *resonance = whirl_table_field(v->table, v->own.last, WHIRL_FIELD_TORUS_RESONANCE, 0);
    span range = span_empty();
    for (size_t point = v->own.first; point <= v->own.last; point++) span_widen(&range, rotation_of(v, point, 0));
    if (point_number(v->table, v->own.last, WHIRL_FIELD_TORUS_END) == WHIRL_TORUS_ROUGH)
        span_widen(&range, resonance[0] / resonance[1]);
    return span_with_margin(range, 0.12, 1e-6);
}

static whirl_panel *torus_add_panel(whirl_figure *figure, const torus_view *v, const char *name, const char *label) {
    whirl_panel *panel = figure_panel(figure, name, 1.0, 4.0);
    if (!panel) return NULL;
    axis_show(&panel->x, v->range);
    panel->x.shown = false;
    symbol_parameter(v->of->units, v->table->parameter, panel->x.label, sizeof panel->x.label);
    snprintf(panel->y.label, sizeof panel->y.label, "%s", label);
    return panel;
}

/// Returns the range of the parameter from the beginning of the tori to their end.
static span axis_of(const torus_view *v) {
    span range = span_empty();
    span_widen(&range, point_number(v->table, v->own.first, WHIRL_FIELD_TORUS_BEGINS) / v->size);
    span_widen(&range, point_number(v->table, v->own.last, WHIRL_FIELD_TORUS_LIMIT) / v->size);
    for (size_t point = v->own.first; point <= v->own.last; point++)
        span_widen(&range, v->table->values[point] / v->size);
    return span_with_margin(range, 0.03, 0.0);
}

static void torus_list(figure_list *to, const drawing *of, const whirl_table *table) {
    (void)of;
    for (size_t point = 0; table_has(table, WHIRL_FIELD_TORUS_NUMBER) && point < table->count; point++) {
        const whirl_tori own = whirl_table_tori(table, point);
        const figure_place place = {.kind = &torus_figure, .table = table, .point = NO_POINT, .which = own.first};
        const double number = point_number(table, own.first, WHIRL_FIELD_TORUS_NUMBER);
        char name[WHIRL_NAME_SIZE];
        snprintf(name, sizeof name, "torus-%.0f", number);
        if (own.found > 1) list_figure(to, &place, name, "Torus %.0f over %s", number, table->parameter);
        point = own.last;
    }
}

static void torus_figure_describe(const drawing *of, const figure_place *place, whirl_figure *figure) {
    // Find the branch of tori, and the range of its parameter.
    torus_view v = {.of = of, .table = place->table, .own = whirl_table_tori(place->table, place->which)};
    char label[SYMBOL_SIZE];
    v.size = whirl_shown_parameter(of->units, v.table->parameter).size;
    v.range = axis_of(&v);
    // Draw the rotation number, with simple fractions near which motions may lock.
    whirl_panel *rotation = torus_add_panel(figure, &v, "rotation", "rotation number");
    const span rotations = rotations_of(&v);
    if (rotation) axis_show(&rotation->y, rotations);
    if (rotation) add_resonances(figure, rotation, rotations);
    add_numbers(figure, rotation, &v, 0, "", rotation_of);
    // Draw amplitudes at the stations.
    symbol_length(of->units, WHIRL_AMPLITUDE, "amplitude", label, sizeof label);
    whirl_panel *amplitude = torus_add_panel(figure, &v, "amplitude", label);
    if (amplitude) amplitude->keyed = true;
    for (size_t s = 0; s < of->result->station_count; s++)
        add_numbers(figure, amplitude, &v, s, of->result->stations[s].name, amplitude_of);
    // Draw the largest exponent across the torus.
    whirl_panel *exponent = torus_add_panel(figure, &v, "exponent", "normal exponent / rev.");
    if (exponent) {
        exponent->x.shown = true;
        whirl_series *zero = panel_level(figure, exponent, 0.0, "#9A9A9A", 0.4);
        if (zero) zero->dashed = true;
    }
    add_numbers(figure, exponent, &v, 0, "", exponent_of);
    // Describe the panels.
    snprintf(
        figure->caption, sizeof figure->caption,
        "Quasi-periodic motions over %s, solid where they are stable, dashed where not. Above: the rotation "
        "number, turns round the closed curve of the section from one revolution to the next, with simple fractions, "
        "near which motions may lock. Middle: the amplitude of the strongest line of the second frequency, the larger "
        "one of both coordinates. Below: the largest Lyapunov exponent across the torus.",
        v.table->parameter);
}

const figure_kind torus_figure = {.list = torus_list, .describe = torus_figure_describe};
