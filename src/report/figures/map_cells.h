/// Cells of a plane of a map: every point of its grid stands for the part of the plane that is nearest to it.
#ifndef REPORT_MAP_CELLS_H
#define REPORT_MAP_CELLS_H

#include <stdbool.h>
#include <stddef.h>

#include "figure_build.h"
#include "units.h"
#include "whirl/engine/result.h"

typedef struct map_cells {
    size_t plane, columns, rows;
    double *x, *y;           ///< [columns + 1], [rows + 1] edges, in shown units
    double z;                ///< value of the third parameter in the plane, in its shown unit; NaN where there is none
    bool x_ratios, y_ratios; ///< the axes are logarithmic
    bool refined;
    size_t *cover;           ///< [rows][columns] the point of the table that stands for a cell (whirl_table_cover)
    double *memory;          ///< of the edges
    size_t *cover_of_planes; ///< of all, of which `cover` is a part
} map_cells;

/// Lays out the cells of a plane of a table with rows; of a partial one, too. False without memory. Freed by
/// map_cells_free.
bool map_cells_make(const whirl_shown_units *units, const whirl_table *table, size_t plane, map_cells *cells);
void map_cells_free(map_cells *cells);

/// Cells of one value that are drawn as one: in a refined map neighbours in a row. Starts as {0}.
typedef struct map_run {
    size_t next;  ///< cell behind them
    double value; ///< theirs
    span x, y;
} map_run;

/// The next of them, by values [rows][columns]; cells without one (NaN) are left out. False where there are no more.
bool map_cells_next(const map_cells *cells, const double *values, map_run *run);

/// Adds lines where cells of different labels [rows][columns] meet; none beside cells without one (0).
void map_cells_add_borders(whirl_figure *figure, whirl_series *to, const map_cells *cells, const long *labels);

#endif
