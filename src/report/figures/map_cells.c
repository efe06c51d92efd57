// Lays out the cells of a map, and draws the borders between cells of different kinds.
#include "map_cells.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static bool have_equal_ratios(const double *values, size_t count) {
    if (count < 3 || !(values[0] * values[count - 1] > 0.0)) return false;
    const double ratio = values[1] / values[0], difference = values[1] - values[0];
    for (size_t i = 2; i < count; i++)
        if (!(fabs(values[i] / values[i - 1] - ratio) < 1e-6 * fabs(ratio - 1.0))) return false;
    return fabs(values[count - 1] - values[count - 2] - difference) > 1e-3 * fabs(difference);
}

/// Places edges half-way between neighbours (on a logarithmic axis by ratios); outer cells are symmetric about their
/// points.
static void find_edges(const double *values, size_t count, bool ratios, double *edges) {
    const double own = fabs(values[0]) > 0.0 ? 0.05 * fabs(values[0]) : 0.5;
    for (size_t i = 1; i < count; i++)
        edges[i] = ratios ? copysign(sqrt(values[i - 1] * values[i]), values[i]) : 0.5 * (values[i - 1] + values[i]);
    if (count == 1) {
        edges[0] = values[0] - own;
        edges[1] = values[0] + own;
        return;
    }
    edges[0] = ratios ? values[0] * values[0] / edges[1] : 2.0 * values[0] - edges[1];
    const double last = values[count - 1], before = edges[count - 1];
    edges[count] = ratios ? last * last / before : 2.0 * last - before;
}

/// Finds the values along both axes from the table's points; NaN for columns and rows without a point.
static void read_axes(map_cells *map, const whirl_shown_units *units, const whirl_table *table, double *x, double *y) {
    const double across = whirl_shown_parameter(units, table->parameter).size;
    const double up = whirl_shown_parameter(units, table->second).size;
    for (size_t i = 0; i < map->columns; i++) x[i] = NAN;
    for (size_t i = 0; i < map->rows; i++) y[i] = NAN;
    map->z = NAN;
    if (map->columns == 0 || map->rows == 0) return;
    for (size_t i = 0; i < table->count; i++) {
        const size_t slot = whirl_table_slot(table, i);
        x[slot % map->columns] = table->values[i] / across;
        if (!whirl_table_done(table, i)) continue;
        y[slot / map->columns % map->rows] = whirl_table_second(table, i) / up;
        if (table->plane > 0 && slot / table->plane == map->plane)
            map->z = whirl_table_third(table, i) / whirl_shown_parameter(units, table->third).size;
    }
}

/// Returns true if the known values have equal ratios from column to column (or row to row) and unequal differences.
static bool are_ratios(const double *values, size_t first, size_t last) {
    const double steps = (double)(last - first), ratio = values[last] / values[first];
    bool ratios = ratio > 0.0, differences = true;
    for (size_t i = first; i <= last; i++) {
        const double share = (double)(i - first) / steps;
        const double even = values[first] + share * (values[last] - values[first]);
        if (isnan(values[i])) continue;
        ratios = ratios && fabs(log(values[i] / values[first]) - share * log(ratio)) < 1e-6 * fabs(log(ratio)) / steps;
        differences = differences && fabs(values[i] - even) < 1e-3 * fabs(values[last] - values[first]) / steps;
    }
    return ratios && !differences;
}

/// Interpolates (or extrapolates) to `share` of the way from `a` to `b`; by ratio on a logarithmic axis.
static double between(double a, double b, double share, bool ratios) {
    return ratios ? a * pow(b / a, share) : a + share * (b - a);
}

/// Replaces missing values by values spaced evenly between known ones, or beyond them; by ratio on a logarithmic axis.
static void fill_gaps(double *values, size_t count) {
    size_t first = 0, last = count - 1;
    while (first < last && isnan(values[first])) first++;
    while (last > first && isnan(values[last])) last--;
    if (first == last) { // one known value, or none
        const double only = isnan(values[first]) ? 0.0 : values[first];
        for (size_t k = 0; k < count; k++) values[k] = only + (double)k - (double)first;
        return;
    }
    const bool ratios = are_ratios(values, first, last);
    size_t before = first, known = first;
    for (size_t i = first + 1; i <= last; i++) {
        if (isnan(values[i])) continue;
        before = known;
        known = i;
        for (size_t k = before + 1; k < i; k++)
            values[k] = between(values[before], values[i], (double)(k - before) / (double)(i - before), ratios);
    }
    for (size_t k = last + 1; k < count; k++)
        values[k] = between(values[last - 1], values[last], (double)(k - last + 1), ratios);
    for (size_t k = first; k-- > 0;) values[k] = between(values[k + 2], values[k + 1], 2.0, ratios);
}

bool map_cells_make(const whirl_shown_units *units, const whirl_table *table, size_t plane, map_cells *map) {
    const size_t columns = table->row, rows = whirl_table_rows(table);
    *map = (map_cells){.plane = plane, .columns = columns, .rows = rows, .refined = table->refine > 0};
    double *x = map->memory = calloc(2 * (columns + rows) + 2, sizeof *x);
    map->cover_of_planes = calloc(columns * rows * whirl_table_planes(table) + 1, sizeof *map->cover);
    if (!x || !map->cover_of_planes) return false;
    whirl_table_cover(table, map->cover_of_planes);
    map->cover = map->cover_of_planes + plane * columns * rows;
    double *y = x + columns;
    map->x = y + rows;
    map->y = map->x + columns + 1;
    read_axes(map, units, table, x, y);
    fill_gaps(x, columns);
    fill_gaps(y, rows);
    map->x_ratios = have_equal_ratios(x, columns);
    map->y_ratios = have_equal_ratios(y, rows);
    find_edges(x, columns, map->x_ratios, map->x);
    find_edges(y, rows, map->y_ratios, map->y);
    return true;
}

void map_cells_free(map_cells *map) {
    free(map->memory);
    free(map->cover_of_planes);
    map->memory = NULL;
    map->cover = map->cover_of_planes = NULL;
}

// ---------------------------------------------------------------- runs and borders

bool map_cells_next(const map_cells *map, const double *values, map_run *run) {
    const size_t all = map->columns * map->rows;
    size_t at = run->next;
    while (at < all && isnan(values[at])) at++;
    if (at >= all) return false;
    const size_t row = at / map->columns, begin = at % map->columns, end_of_row = (row + 1) * map->columns;
    size_t end = at + 1;
    while (map->refined && end < end_of_row && values[end] == values[at]) end++;
    const double left = map->x[begin], right = map->x[end - row * map->columns];
    *run = (map_run){.next = end,
                     .value = values[at],
                     .x = {fmin(left, right), fmax(left, right)},
                     .y = {fmin(map->y[row], map->y[row + 1]), fmax(map->y[row], map->y[row + 1])}};
    return true;
}

/// Borders along a grid line: between columns `at` - 1 and `at` if it is upright, else between these rows.
typedef struct border {
    const map_cells *map;
    const long *labels; ///< [rows][columns] kinds of the cells
    bool upright;
    size_t at;
} border;

static bool is_crossed(const border *b, size_t along) {
    const size_t columns = b->map->columns;
    const size_t after = b->upright ? along * columns + b->at : b->at * columns + along;
    const long one = b->labels[after - (b->upright ? 1 : columns)], other = b->labels[after];
    return one != 0 && other != 0 && one != other;
}

static void add_border(whirl_figure *figure, whirl_series *to, const border *b) {
    const size_t count = b->upright ? b->map->rows : b->map->columns;
    const double *edges = b->upright ? b->map->y : b->map->x, here = b->upright ? b->map->x[b->at] : b->map->y[b->at];
    for (size_t begin = 0, end; begin < count; begin = end) {
        const bool crossed = is_crossed(b, begin);
        for (end = begin + 1; end < count && is_crossed(b, end) == crossed;) end++;
        if (!crossed) continue;
        series_add(figure, to, b->upright ? here : edges[begin], b->upright ? edges[begin] : here);
        series_add(figure, to, b->upright ? here : edges[end], b->upright ? edges[end] : here);
        series_break(figure, to);
    }
}

void map_cells_add_borders(whirl_figure *figure, whirl_series *to, const map_cells *map, const long *labels) {
    border b = {.map = map, .labels = labels, .upright = true};
    for (b.at = 1; b.at < map->columns; b.at++) add_border(figure, to, &b);
    b.upright = false;
    for (b.at = 1; b.at < map->rows; b.at++) add_border(figure, to, &b);
}
