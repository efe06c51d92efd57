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

/// Whether the values that are there have equal ratios from column to column, or row to row, and no equal differences.
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

/// What stands between or beyond two values, `share` of the way from one to the other.
static double between(double a, double b, double share, bool ratios) {
    return ratios ? a * pow(b / a, share) : a + share * (b - a);
}

/// Cells without a value stand evenly between those that have one, or beyond; by ratios where the values do.
static void fill_gaps(double *values, size_t count) {
    size_t first = 0, last = count - 1;
    while (first < last && isnan(values[first])) first++;
    while (last > first && isnan(values[last])) last--;
    if (first == last) { // or none at all
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

// ---------------------------------------------------------------- writing

/// An edge that reaches under the next cell, which is drawn later: nothing shines through between the two.
static double reach(const double *edges, bool next) {
    return next ? edges[1] + 0.5 * (edges[2] - edges[1]) : edges[1];
}

/// The cells of a row from one column to another, its end not included, that have one value.
typedef struct run {
    size_t row, begin, end;
} run;

/// Whether all cells above have a value.
static bool is_covered(const map_cells *map, const run *r, const double *values) {
    if (r->row + 1 == map->rows) return false;
    for (size_t i = r->begin; i < r->end; i++)
        if (isnan(values[(r->row + 1) * map->columns + i])) return false;
    return true;
}

static void write_run(FILE *stream, const map_cells *map, const run *r, const double *values) {
    const size_t next = r->row * map->columns + r->end;
    const double *x = map->x + r->end - 1, *y = map->y + r->row, left = map->x[r->begin];
    const bool beside = r->end < map->columns && !isnan(values[next]), above = is_covered(map, r, values);
    const bool across = beside && above && !isnan(values[next + map->columns]);
    const double right = reach(x, beside && (across || !above)), up = reach(y, above && (across || !beside));
    fprintf(stream, "%.10g %.10g %.10g %.10g %.10g %.10g %.10g\n", 0.5 * (left + x[1]), 0.5 * (y[0] + y[1]),
            fmin(left, right), fmax(left, right), fmin(y[0], up), fmax(y[0], up), values[next - 1]);
}

void map_cells_write(FILE *stream, const map_cells *map, const double *values) {
    for (size_t row = 0; row < map->rows; row++) {
        const double *own = values + row * map->columns;
        for (run r = {.row = row}; r.begin < map->columns; r.begin = r.end) {
            for (r.end = r.begin + 1; map->refined && r.end < map->columns && own[r.end] == own[r.begin];) r.end++;
            if (!isnan(own[r.begin])) write_run(stream, map, &r, values);
        }
    }
}

/// Where the cells on both sides of a line meet: those of column `at` - 1 and `at` where it stands, else of rows.
typedef struct border {
    const map_cells *map;
    const long *labels;
    bool stands;
    size_t at;
} border;

static bool is_crossed(const border *b, size_t along) {
    const size_t columns = b->map->columns;
    const size_t after = b->stands ? along * columns + b->at : b->at * columns + along;
    const long one = b->labels[after - (b->stands ? 1 : columns)], other = b->labels[after];
    return one != 0 && other != 0 && one != other;
}

static void write_piece(FILE *stream, const border *b, size_t begin, size_t end) {
    const double *edges = b->stands ? b->map->y : b->map->x, here = b->stands ? b->map->x[b->at] : b->map->y[b->at];
    if (b->stands)
        fprintf(stream, "%.10g %.10g\n%.10g %.10g\n\n", here, edges[begin], here, edges[end]);
    else
        fprintf(stream, "%.10g %.10g\n%.10g %.10g\n\n", edges[begin], here, edges[end], here);
}

/// Whether there is any of it.
static bool write_border(FILE *stream, const border *b) {
    const size_t count = b->stands ? b->map->rows : b->map->columns;
    bool any = false;
    for (size_t begin = 0, end; begin < count; begin = end) {
        const bool crossed = is_crossed(b, begin);
        for (end = begin + 1; end < count && is_crossed(b, end) == crossed;) end++;
        if (crossed && stream) write_piece(stream, b, begin, end);
        any = any || crossed;
    }
    return any;
}

bool map_cells_write_borders(FILE *stream, const map_cells *map, const long *labels) {
    border b = {.map = map, .labels = labels, .stands = true};
    bool any = false;
    for (b.at = 1; b.at < map->columns; b.at++) any = write_border(stream, &b) || any;
    b.stands = false;
    for (b.at = 1; b.at < map->rows; b.at++) any = write_border(stream, &b) || any;
    return any;
}
