/// Cells of a plane of a map: the cell of a point is the part of the plane that is nearest to it.
#ifndef REPORT_MAP_CELLS_H
#define REPORT_MAP_CELLS_H

#include "figure_build.h"
#include "whirl/engine/result.h"
#include "whirl/internal/shown.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct map_cells {
    size_t plane, columns, rows;
    double *x, *y;           ///< [columns + 1], [rows + 1] edges, in shown units
    double z;                ///< value of the third parameter in the plane, in its shown unit; NaN without one
    bool x_ratios, y_ratios; ///< the axes are logarithmic
    bool refined;
    size_t *cover;           ///< [rows][columns] the point of the table that covers a cell (whirl_table_cover)
    double *memory;          ///< memory of the edges
    size_t *cover_of_planes; ///< covers of all planes; `cover` is a part of it
} map_cells;

/// Lays out the cells of a plane of a table with rows, also of a partial result. Returns false without memory. Freed by
/// map_cells_free.
bool map_cells_make(const whirl_shown_units *units, const whirl_table *table, size_t plane, map_cells *cells);
void map_cells_free(map_cells *cells);

/// A run of cells with the same value, neighbours in a row of a refined map, which are drawn as one box. Initial value:
/// {0}.
typedef struct map_run {
    size_t next;  ///< first cell after the run
    double value; ///< value of the cells
    span x, y;
} map_run;

/// Advances to the next run of equal values in [rows][columns]; cells without a value (NaN) are skipped. Returns false
/// at the end.
bool map_cells_next(const map_cells *cells, const double *values, map_run *run);

/// Adds borders between cells of different labels [rows][columns]; label 0 (no verdict) has no border.
void map_cells_add_borders(whirl_figure *figure, whirl_series *to, const map_cells *cells, const long *labels);

#endif
