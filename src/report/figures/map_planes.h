/// The planes of a map that its figures show, a panel each.
#ifndef REPORT_MAP_PLANES_H
#define REPORT_MAP_PLANES_H

#include "map_cells.h"

enum { MOST_PLANES = 16 }; ///< in a figure

typedef struct map_planes {
    const whirl_shown_units *units;
    const whirl_table *table;
    size_t count;                 ///< that are shown: evenly chosen of all, the first and the last among them
    map_cells cells[MOST_PLANES]; ///< of each
} map_planes;

/// A part of a figure, as shares of its width and height.
typedef struct map_area {
    double left, right, bottom, top;
} map_area;

/// Lays out the planes of a table with rows. False without memory. Freed by map_planes_free.
bool map_planes_make(const whirl_shown_units *units, const whirl_table *table, map_planes *planes);
void map_planes_free(map_planes *planes);

/// Height of a figure, in cm, whose panels of the planes lie side by side and above each other in its width; `single`
/// of a map with one plane.
double map_planes_height(const map_planes *planes, double single);

/// Places the panel of plane k within the area, with the axes' names and tics where it is an outer one, and above it
/// the value of the third parameter.
void map_planes_panel(FILE *script, const map_planes *planes, size_t k, map_area area);

/// A sentence of the caption: how many planes are shown; "" where there is one.
void map_planes_note(const map_planes *planes, char *text, size_t size);

#endif
