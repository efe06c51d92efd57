/// Squares over a plane of points, divided where their points differ: which points of a refined map are computed.
///
/// The plane is cut into first squares whose corners are points of it; those of the last column and row may be smaller.
/// A square is halved along both axes where a point on its edges is known to differ from its first corner, down to
/// squares of neighbouring points. What one first square learns of an edge the other one beside it learns, too, so that
/// a boundary is followed from square to square. The more is known the more is divided, and never less: what is asked
/// for in the end does not depend on the order in which points become known, nor on who asks first. Alone, a first
/// square looks at the points that it asked for itself: what it asks for then is part of that, and depends on no other.
#ifndef STUDY_SQUARES_H
#define STUDY_SQUARES_H

#include <stdbool.h>
#include <stddef.h>

typedef struct squares {
    size_t columns, rows;       ///< points of the plane; a point is row * columns + column
    size_t width;               ///< of the first squares, in points, a power of two
    const unsigned char *known; ///< [rows][columns] 1 for points that can be compared
    bool alone;                 ///< first squares are
    bool (*differ)(const void *context, size_t a, size_t b);
    const void *context;
} squares;

/// First squares, which are counted row after row.
size_t squares_count(const squares *s);

/// Whether a point is of a first square, its edges included.
bool squares_has(const squares *s, size_t square, size_t point);

/// Whether it is a corner of one.
bool squares_is_corner(const squares *s, size_t point);

/// Sets in asked [rows][columns] all points that a first square needs as far as known points tell: its corners, and
/// those of all squares into which it is divided. False without memory.
bool squares_ask(const squares *s, size_t square, unsigned char *asked);

/// Sets in widths [rows][columns], at their first corners, the widths of the squares that were left as they are and
/// whose corners are known. False without memory.
bool squares_widths(const squares *s, size_t square, double *widths);

#endif
