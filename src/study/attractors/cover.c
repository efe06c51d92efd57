// Grid points that each computed point of a refined map represents; the rest of the grid was not computed.
#include <math.h>
#include <stdlib.h>

#include "whirl/engine/result.h"

/// Returns the end of a half-open range, so that every grid point belongs to one square. The last column and row belong
/// to the squares that end there.
static size_t cover_end_of(size_t begin, double width, size_t points) {
    const double end = (double)begin + width;
    return end + 1.0 < (double)points ? (size_t)end : points;
}

/// Counts the grid points of a square and subtracts them from *left. In an undamaged file *left suffices for all
/// squares.
static void cover_square(const whirl_table *table, size_t point, double width, size_t *left, size_t *cover) {
    const size_t slot = whirl_table_slot(table, point), columns = table->row, rows = whirl_table_rows(table);
    const size_t right = cover_end_of(slot % columns, width, columns), top = cover_end_of(slot / columns, width, rows);
    const size_t area = (right - slot % columns) * (top - slot / columns);
    if (area > *left) return;
    *left -= area;
    for (size_t y = slot / columns; y < top; y++)
        for (size_t x = slot % columns; x < right; x++) cover[y * columns + x] = point;
}

void whirl_table_cover(const whirl_table *table, size_t *cover) {
    const size_t grid = whirl_table_grid(table);
    size_t left = grid;
    for (size_t i = 0; i < grid; i++) cover[i] = table->count;
    for (size_t i = 0; i < table->count && table->refine > 0; i++) {
        const double width = whirl_table_number(table, i, WHIRL_FIELD_MAP_WIDTH, 0);
        if (whirl_table_done(table, i) && width > 1.0) cover_square(table, i, width, &left, cover);
    }
    for (size_t i = 0; i < table->count; i++)
        if (whirl_table_done(table, i)) cover[whirl_table_slot(table, i)] = i;
}

double whirl_table_revolutions(const whirl_table *table) {
    double sum = 0.0;
    size_t done = 0;
    for (size_t i = 0; i < table->count; i++) {
        if (!whirl_table_done(table, i)) continue;
        sum += whirl_table_number(table, i, WHIRL_FIELD_REGIME_REVOLUTIONS, 0);
        done++;
    }
    return done > 0 ? sum / (double)done : (double)NAN;
}

double whirl_table_grid_revolutions(const whirl_table *table) {
    const size_t grid = whirl_table_grid(table);
    size_t *cover = calloc(grid + 1, sizeof *cover), *cells = calloc(table->count + 1, sizeof *cells);
    double sum = cover && cells ? 0.0 : (double)NAN;
    if (cover && cells) {
        whirl_table_cover(table, cover);
        for (size_t i = 0; i < grid; i++) cells[cover[i]]++;
        for (size_t i = 0; i < table->count; i++)
            if (cells[i] > 0) sum += (double)cells[i] * whirl_table_number(table, i, WHIRL_FIELD_REGIME_REVOLUTIONS, 0);
    }
    free(cover);
    free(cells);
    return sum;
}
