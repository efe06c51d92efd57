// Cells of a map: where they lie, and how they are written for gnuplot.
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

/// Half-way between neighbours, on a logarithmic axis by ratios; outer cells reach as far out as in.
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

/// The values along both axes, by the points that are there; of columns and rows without any point those beside.
static void read_axes(const map_cells *map, const shown_units *units, const whirl_table *table, double *x, double *y) {
    const double across = units_parameter(units, table->parameter).size;
    const double up = units_parameter(units, table->second).size;
    for (size_t i = 0; i < map->columns; i++) x[i] = NAN;
    for (size_t i = 0; i < map->rows; i++) y[i] = NAN;
    for (size_t i = 0; i < table->count; i++) {
        const size_t slot = whirl_table_slot(table, i);
        x[slot % map->columns] = table->values[i] / across;
        if (whirl_table_done(table, i)) y[slot / map->columns] = whirl_table_second(table, i) / up;
    }
}

/// Cells without a value stand evenly between those that have one, or beyond.
static void fill_gaps(double *values, size_t count) {
    size_t known = SIZE_MAX, before = SIZE_MAX;
    for (size_t i = 0; i < count; i++) {
        if (isnan(values[i])) continue;
        for (size_t k = known == SIZE_MAX ? i : known + 1; k < i; k++)
            values[k] = values[known] + (values[i] - values[known]) * (double)(k - known) / (double)(i - known);
        before = known;
        known = i;
    }
    const double step = before == SIZE_MAX ? 1.0 : (values[known] - values[before]) / (double)(known - before);
    for (size_t k = known == SIZE_MAX ? count : known + 1; k < count; k++)
        values[k] = values[known] + step * (double)(k - known);
    size_t first = 0;
    while (first < count && isnan(values[first])) first++;
    const double early = first + 1 < count ? values[first + 1] - values[first] : 1.0;
    for (size_t k = 0; k < first && first < count; k++) values[k] = values[first] - early * (double)(first - k);
}

bool map_cells_make(const shown_units *units, const whirl_table *table, map_cells *map) {
    const size_t columns = table->row, rows = whirl_table_planned(table) / table->row;
    *map = (map_cells){.columns = columns, .rows = rows};
    double *x = map->memory = calloc(2 * (columns + rows) + 2, sizeof *x);
    if (!x) return false;
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
    map->memory = NULL;
}

/// An edge that reaches under the next cell, which is drawn later: nothing shines through between the two.
static double reach(const double *edges, bool next) {
    return next ? edges[1] + 0.5 * (edges[2] - edges[1]) : edges[1];
}

void map_cells_put(FILE *stream, const map_cells *map, size_t column, size_t row, const double *values) {
    const size_t slot = row * map->columns + column;
    const double *x = map->x + column, *y = map->y + row;
    const bool beside = column + 1 < map->columns && !isnan(values[slot + 1]);
    const bool above = row + 1 < map->rows && !isnan(values[slot + map->columns]);
    const bool across = beside && above && !isnan(values[slot + map->columns + 1]);
    const double right = reach(x, beside && (across || !above)), up = reach(y, above && (across || !beside));
    fprintf(stream, "%.10g %.10g %.10g %.10g %.10g %.10g %.10g\n", 0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]),
            fmin(x[0], right), fmax(x[0], right), fmin(y[0], up), fmax(y[0], up), values[slot]);
}
