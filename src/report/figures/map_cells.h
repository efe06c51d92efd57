/// Cells of a plane of a map: every point of its grid stands for the part of the plane that is nearest to it.
#ifndef REPORT_MAP_CELLS_H
#define REPORT_MAP_CELLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "units.h"
#include "whirl/result.h"

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

/// Writes cells that have one of the values [rows][columns], a line each: its middle, its edges and the value. Some
/// edges reach under cells that come later in the order of rows and have a value, too. In a refined map neighbours of
/// one value in a row are one.
void map_cells_write(FILE *stream, const map_cells *cells, const double *values);

/// Writes where cells of different labels [rows][columns] meet, as lines; nothing beside cells without one (0). False
/// where they meet nowhere. NULL for the stream: nothing is written.
bool map_cells_write_borders(FILE *stream, const map_cells *cells, const long *labels);

#endif
