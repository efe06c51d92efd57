#include <stdlib.h>

#include "squares.h"

/// A square, cut off at the edges of the plane.
typedef struct square {
    size_t x, y, width;
} square;

/// A first square and the points that it has requested.
typedef struct tile {
    const squares *plane;
    square all;
    unsigned char *asked; ///< [width + 1][width + 1]
} tile;

static size_t squares_along(size_t points, size_t width) {
    return points > 1 ? (points - 2) / width + 1 : 1;
}

size_t squares_count(const squares *s) {
    return squares_along(s->columns, s->width) * squares_along(s->rows, s->width);
}

static square first_square(const squares *s, size_t index) {
    const size_t across = squares_along(s->columns, s->width);
    return (square){index % across * s->width, index / across * s->width, s->width};
}

static size_t squares_end_of(size_t begin, size_t width, size_t points) {
    return begin + width < points ? begin + width : points - 1;
}

static size_t right_of(const squares *s, square q) {
    return squares_end_of(q.x, q.width, s->columns);
}

static size_t top_of(const squares *s, square q) {
    return squares_end_of(q.y, q.width, s->rows);
}

bool squares_has(const squares *s, size_t index, size_t point) {
    const square q = first_square(s, index);
    const size_t x = point % s->columns, y = point / s->columns;
    return x >= q.x && x <= right_of(s, q) && y >= q.y && y <= top_of(s, q);
}

bool squares_is_corner(const squares *s, size_t point) {
    const size_t x = point % s->columns, y = point / s->columns;
    return (x % s->width == 0 || x + 1 == s->columns) && (y % s->width == 0 || y + 1 == s->rows);
}

// ---------------------------------------------------------------- points

static unsigned char *asked_at(const tile *t, size_t x, size_t y) {
    return &t->asked[(y - t->all.y) * (t->all.width + 1) + x - t->all.x];
}

static size_t point_at(const tile *t, size_t x, size_t y) {
    return y * t->plane->columns + x;
}

/// Requests a point; returns true if that is new.
static bool squares_request(const tile *t, size_t x, size_t y) {
    unsigned char *asked = asked_at(t, x, y);
    const bool is_new = !*asked;
    *asked = 1;
    return is_new;
}

static bool ask_corners(const tile *t, square q) {
    const size_t x = right_of(t->plane, q), y = top_of(t->plane, q);
    bool is_new = squares_request(t, q.x, q.y);
    is_new = squares_request(t, x, q.y) || is_new;
    is_new = squares_request(t, q.x, y) || is_new;
    return squares_request(t, x, y) || is_new;
}

static bool knows_corners(const tile *t, square q) {
    const size_t x = right_of(t->plane, q), y = top_of(t->plane, q);
    const unsigned char *known = t->plane->known;
    return known[point_at(t, q.x, q.y)] && known[point_at(t, x, q.y)] && known[point_at(t, q.x, y)] &&
           known[point_at(t, x, y)];
}

/// Returns true if a point is known and differs from the first corner.
static bool differs_at(const tile *t, square q, size_t x, size_t y) {
    const squares *s = t->plane;
    const size_t corner = point_at(t, q.x, q.y), point = point_at(t, x, y);
    return point != corner && (!s->alone || *asked_at(t, x, y)) && s->known[point] &&
           s->differ(s->context, corner, point);
}

/// Returns true if points on the edges differ. Inside an undivided square none is known.
static bool squares_differs(const tile *t, square q) {
    const size_t right = right_of(t->plane, q), top = top_of(t->plane, q);
    for (size_t x = q.x; x <= right; x++)
        if (differs_at(t, q, x, q.y) || differs_at(t, q, x, top)) return true;
    for (size_t y = q.y; y <= top; y++)
        if (differs_at(t, q, q.x, y) || differs_at(t, q, right, y)) return true;
    return false;
}

// ---------------------------------------------------------------- dividing

static bool is_divided(const tile *t, square q) {
    return q.width > 1 && knows_corners(t, q) && squares_differs(t, q);
}

/// Divides a square along both axes, as far as the plane goes.
static size_t squares_divide(const squares *s, square q, square parts[4]) {
    const size_t half = q.width / 2;
    const size_t columns = q.x + half < right_of(s, q) ? 2 : 1, rows = q.y + half < top_of(s, q) ? 2 : 1;
    size_t count = 0;
    for (size_t j = 0; j < rows; j++)
        for (size_t i = 0; i < columns; i++) parts[count++] = (square){q.x + i * half, q.y + j * half, half};
    return count;
}

/// Requests the points that a square needs; returns true if any of them is new.
static bool squares_visit(const tile *t, square q) {
    square parts[4];
    bool is_new = false;
    if (!is_divided(t, q)) return false;
    const size_t count = squares_divide(t->plane, q, parts);
    for (size_t i = 0; i < count; i++) is_new = ask_corners(t, parts[i]) || is_new;
    for (size_t i = 0; i < count; i++) is_new = squares_visit(t, parts[i]) || is_new;
    return is_new;
}

/// Makes a first square and requests all that its known points imply. `asked` is to be freed, NULL without memory.
static tile open_tile(const squares *s, size_t index) {
    const size_t side = s->width + 1;
    tile t = {.plane = s, .all = first_square(s, index), .asked = calloc(side * side, 1)};
    if (!t.asked) return t;
    ask_corners(&t, t.all);
    // Repeat, since a point requested on an edge may divide the square on its other side.
    while (squares_visit(&t, t.all)) {
    }
    return t;
}

bool squares_ask(const squares *s, size_t index, unsigned char *asked) {
    const tile t = open_tile(s, index);
    const size_t right = right_of(s, t.all), top = top_of(s, t.all);
    if (!t.asked) return false;
    for (size_t y = t.all.y; y <= top; y++)
        for (size_t x = t.all.x; x <= right; x++)
            if (*asked_at(&t, x, y)) asked[point_at(&t, x, y)] = 1;
    free(t.asked);
    return true;
}

static void note_widths(const tile *t, square q, double *widths) {
    square parts[4];
    if (is_divided(t, q)) {
        const size_t count = squares_divide(t->plane, q, parts);
        for (size_t i = 0; i < count; i++) note_widths(t, parts[i], widths);
    } else if (knows_corners(t, q)) {
        widths[point_at(t, q.x, q.y)] = (double)q.width;
    }
}

bool squares_widths(const squares *s, size_t index, double *widths) {
    const tile t = open_tile(s, index);
    if (!t.asked) return false;
    note_widths(&t, t.all, widths);
    free(t.asked);
    return true;
}
