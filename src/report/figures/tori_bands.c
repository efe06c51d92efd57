#include "tori_bands.h"

#include <math.h>
#include <string.h>

#include "figure_build.h"
#include "quantities.h"

const char tori_caption[] =
    " Green: the bands that quasi-periodic motions fill, with solid edges where they are stable, dashed where not.";

static bool tori_has_torus(const whirl_table *table, size_t point) {
    return isfinite(point_number(table, point, WHIRL_FIELD_TORUS_ROTATION));
}

bool tori_is_stable(const whirl_table *table, size_t point) {
    return point_number(table, point, WHIRL_FIELD_TORUS_UNSTABLE) == 0.0;
}

const whirl_table *tori_table(const whirl_result *result) {
    const whirl_table *table = whirl_result_role(result, WHIRL_ROLE_TORI);
    for (size_t point = 0; table && point < table->count; point++)
        if (whirl_layout_field(&table->layout, WHIRL_FIELD_TORUS_NUMBER) && tori_has_torus(table, point)) return table;
    return NULL;
}

/// Band of a station at one value: the x and y ranges of one closed curve of its section.
typedef struct band {
    double value, low[2], high[2];
    bool stable;
} band;

/// Sets a band without width, the orbit at which a branch of tori begins. Returns false if it is unknown.
static bool tori_begin(const drawing *to, const whirl_table *table, size_t first, size_t station, size_t line,
                       band *out) {
    const whirl_table *branches = whirl_result_role(to->result, WHIRL_ROLE_BRANCHES);
    const double row = point_number(table, first, WHIRL_FIELD_TORUS_POINT);
    if (!branches || !(row >= 1.0 && row <= (double)branches->count)) return false;
    const whirl_field *field = whirl_layout_field(&branches->layout, WHIRL_FIELD_TRACE_SECTION);
    if (!field || line >= field->rows) return false;
    const double *section = whirl_table_field(branches, (size_t)row - 1, field->name, station);
    *out =
        (band){.value = point_number(table, first, WHIRL_FIELD_TORUS_BEGINS), .stable = tori_is_stable(table, first)};
    for (size_t c = 0; section && c < 2; c++) out->low[c] = out->high[c] = section[4 * line + c];
    return section != NULL;
}

/// Sets the last band of a branch that shrinks to an orbit: a band without width, in the middle of the one before.
/// Returns false for other ends.
static bool tori_close(const whirl_table *table, size_t last, size_t station, size_t line, band *out) {
    const double *low = whirl_table_field(table, last, WHIRL_FIELD_TORUS_SECTION_LOW, station);
    const double *high = whirl_table_field(table, last, WHIRL_FIELD_TORUS_SECTION_HIGH, station);
    if (point_number(table, last, WHIRL_FIELD_TORUS_END) != WHIRL_TORUS_SHRANK) return false;
    *out = (band){.value = point_number(table, last, WHIRL_FIELD_TORUS_LIMIT), .stable = tori_is_stable(table, last)};
    for (size_t c = 0; c < 2; c++) out->low[c] = out->high[c] = 0.5 * (low[2 * line + c] + high[2 * line + c]);
    return true;
}

/// Sets band `index` of a branch: 0 is the beginning, then follow its rows and the end. Returns false if there is none.
static bool tori_band(const drawing *to, const whirl_table *table, whirl_tori own, size_t index, size_t station,
                      size_t line, band *out) {
    if (index == 0) return tori_begin(to, table, own.first, station, line, out);
    const size_t point = own.first + index - 1;
    if (point > own.last) return tori_close(table, own.last, station, line, out);
    const double *low = whirl_table_field(table, point, WHIRL_FIELD_TORUS_SECTION_LOW, station);
    const double *high = whirl_table_field(table, point, WHIRL_FIELD_TORUS_SECTION_HIGH, station);
    *out = (band){.value = table->values[point], .stable = tori_is_stable(table, point)};
    memcpy(out->low, low + 2 * line, sizeof out->low);
    memcpy(out->high, high + 2 * line, sizeof out->high);
    return tori_has_torus(table, point);
}

/// Series of the bands: their areas, and the edges of stable and unstable bands.
typedef struct band_series {
    whirl_series *fill, *edges[2][2]; ///< [stable][side]
} band_series;

static void tori_break(whirl_figure *figure, const band_series *to) {
    series_break(figure, to->fill);
    for (int stable = 0; stable < 2; stable++)
        for (int side = 0; side < 2; side++) series_break(figure, to->edges[stable][side]);
}

static void tori_add_edges(whirl_figure *figure, const band_series *to, const band *b, bool stable, size_t column,
                           double length, double size) {
    series_add(figure, to->edges[stable][0], b->value / size, length * b->low[column]);
    series_add(figure, to->edges[stable][1], b->value / size, length * b->high[column]);
}

/// Adds the bands of one branch, for one closed curve of its section. Stable and unstable pieces meet where stability
/// changes.
static void tori_add_line(whirl_figure *figure, const band_series *to, const drawing *of, whirl_tori own,
                          size_t station, size_t line, size_t column, double size) {
    const whirl_table *table = tori_table(of->result);
    const double length = whirl_shown_length(of->units, table, own.first);
    band now, before = {.value = NAN};
    for (size_t index = 0; index < own.last - own.first + 3; index++) {
        if (!tori_band(of, table, own, index, station, line, &now)) continue;
        series_add_to(figure, to->fill, now.value / size, length * now.low[column], length * now.high[column]);
        if (isfinite(before.value) && before.stable != now.stable) {
            tori_add_edges(figure, to, &before, now.stable, column, length, size);
            for (int side = 0; side < 2; side++) series_break(figure, to->edges[before.stable][side]);
        }
        tori_add_edges(figure, to, &now, now.stable, column, length, size);
        before = now;
    }
    tori_break(figure, to);
}

void tori_add_bands(whirl_figure *figure, whirl_panel *panel, const drawing *of, size_t station, size_t column,
                    double size) {
    static const char green[] = "#009E73";
    const whirl_table *table = tori_table(of->result);
    if (!table) return;
    band_series to = {.fill = panel_named(figure, panel, WHIRL_AREA, "torus", green, 1.0)};
    if (to.fill) to.fill->opacity = 0.3;
    for (int stable = 0; stable < 2; stable++)
        for (int side = 0; side < 2; side++) {
            to.edges[stable][side] = panel_series(figure, panel, WHIRL_LINE, green, 0.45);
            if (to.edges[stable][side]) to.edges[stable][side]->dashed = !stable;
        }
    for (size_t first = 0; first < table->count; first++) {
        const whirl_tori own = whirl_table_tori(table, first);
        const double lines = point_number(table, first, WHIRL_FIELD_TORUS_REVOLUTIONS);
        for (size_t line = 0; (double)line < lines; line++)
            tori_add_line(figure, &to, of, own, station, line, column, size);
        first = own.last;
    }
}
