/// Squares over a plane of points, divided where their points differ: they decide which points of a refined map are
/// computed. The plane is cut into first squares whose corners are its points; those of the last column and row may be
/// smaller. A square is halved along both axes if a point on its edges is known to differ from its first corner, down
/// to neighbouring points. Points on an edge count for the squares on both sides, so a boundary is followed from square
/// to square. Further known points can only divide squares further, so the final request depends neither on the order
/// in which points become known nor on who requests first. A square that is `alone` uses only points that it requested
/// itself and is independent of all others.
#ifndef STUDY_SQUARES_H
#define STUDY_SQUARES_H

#include <stdbool.h>
#include <stddef.h>

typedef struct squares {
    size_t columns, rows;       ///< points of the plane; a point is row * columns + column
    size_t width;               ///< width of first squares, in points, a power of two
    const unsigned char *known; ///< [rows][columns] 1 for points that can be compared
    bool alone;                 ///< first squares use only their own points
    bool (*differ)(const void *context, size_t a, size_t b);
    const void *context;
} squares;

/// Returns the number of first squares, counted row after row.
size_t squares_count(const squares *s);

/// Returns true if a point is in a first square, edges included.
bool squares_has(const squares *s, size_t square, size_t point);

/// Returns true if a point is a corner of a first square.
bool squares_is_corner(const squares *s, size_t point);

/// Sets in asked [rows][columns] all points that a first square needs, given the known points: its corners, and those
/// of all squares into which it is divided. False without memory.
bool squares_ask(const squares *s, size_t square, unsigned char *asked);

/// Sets in widths [rows][columns], at their first corners, the widths of the undivided squares with known corners.
/// False without memory.
bool squares_widths(const squares *s, size_t square, double *widths);

#endif
