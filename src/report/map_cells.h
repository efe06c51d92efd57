/// Cells of a map: every point stands for the part of the plane that is nearest to it.
#ifndef REPORT_MAP_CELLS_H
#define REPORT_MAP_CELLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "units.h"
#include "whirl/result.h"

typedef struct map_cells {
    size_t columns, rows;
    double *x, *y;           ///< [columns + 1], [rows + 1] edges, in shown units
    bool x_ratios, y_ratios; ///< the axes are logarithmic
    double *memory;          ///< of the edges
} map_cells;

/// Lays out the cells of a table with rows; of a partial one, too. False without memory. Freed by map_cells_free.
bool map_cells_make(const shown_units *units, const whirl_table *table, map_cells *cells);
void map_cells_free(map_cells *cells);

/// Writes a line: the middle of a cell, its edges and its value, one of values [rows][columns]. Some edges reach under
/// cells that come later in the order of rows and have a value, too.
void map_cells_put(FILE *stream, const map_cells *cells, size_t column, size_t row, const double *values);

#endif
